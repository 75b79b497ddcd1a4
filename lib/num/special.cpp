#include <railbook/num/special.hpp>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sf_expint.h>

#include <cmath>
#include <numbers>

#include <railbook/num/gsl.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::num {

double sine_integral(double x) {
  if (std::isnan(x)) return x;
  if (std::isinf(x)) return std::copysign(std::numbers::pi / 2, x);
  use_gsl_status_codes();
  gsl_sf_result result;
  check_gsl(gsl_sf_Si_e(x, &result), "sine_integral");
  return result.val;
}

double student_quantile(double probability, double degrees) {
  units::require_positive("degrees of freedom", degrees, "");
  units::require_between("probability", probability, 0, 1);
  return gsl_cdf_tdist_Pinv(probability, degrees);
}

}  // namespace railbook::num
