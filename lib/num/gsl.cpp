#include <railbook/num/gsl.hpp>

#include <gsl/gsl_errno.h>

#include <string>

namespace railbook::num {

void use_gsl_status_codes() {
  static const auto before = gsl_set_error_handler_off();
  (void)before;
}

void check_gsl(int status, std::string_view what) {
  if (status == GSL_SUCCESS || status == GSL_EUNDRFLW) return;
  throw NumericalError{std::string{what} + ": " + gsl_strerror(status)};
}

}  // namespace railbook::num
