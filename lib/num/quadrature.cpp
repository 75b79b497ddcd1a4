#include "num/quadrature.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>

#include "num/counted.hpp"
#include "num/gsl.hpp"
#include "units/input_error.hpp"

namespace railbook::num {

Integral integrate(const std::function<double(double)>& f, double a, double b, double relative,
                   double absolute) {
  use_gsl_status_codes();
  constexpr std::size_t limit = 2000;
  const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> space{
      gsl_integration_workspace_alloc(limit), gsl_integration_workspace_free};
  Counted counted{f};
  gsl_function function{evaluate_counted, &counted};
  Integral result;
  int status = GSL_SUCCESS;
  if (std::isinf(a) && std::isinf(b)) {
    status = gsl_integration_qagi(&function, absolute, relative, limit, space.get(), &result.value,
                                  &result.error);
  } else if (std::isinf(b)) {
    status = gsl_integration_qagiu(&function, a, absolute, relative, limit, space.get(),
                                   &result.value, &result.error);
  } else if (std::isinf(a)) {
    status = gsl_integration_qagil(&function, b, absolute, relative, limit, space.get(),
                                   &result.value, &result.error);
  } else {
    status = gsl_integration_qags(&function, a, b, absolute, relative, limit, space.get(),
                                  &result.value, &result.error);
  }
  if (status == GSL_EBADTOL) check_gsl(status, "integrate");  // a mistake of the caller
  result.evaluations = counted.evaluations;
  result.converged = status == GSL_SUCCESS;
  return result;
}

GaussRule gauss_legendre(int n, double a, double b) {
  if (n < 1)
    throw InputError{"gauss_legendre: n is " + std::to_string(n) + "; allowed: at least 1"};
  const std::unique_ptr<gsl_integration_glfixed_table,
                        decltype(&gsl_integration_glfixed_table_free)>
      table{gsl_integration_glfixed_table_alloc(static_cast<std::size_t>(n)),
            gsl_integration_glfixed_table_free};
  GaussRule rule{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (int i = 0; i < n; ++i) {
    gsl_integration_glfixed_point(a, b, static_cast<std::size_t>(i), &rule.x[i], &rule.w[i],
                                  table.get());
  }
  return rule;
}

}  // namespace railbook::num
