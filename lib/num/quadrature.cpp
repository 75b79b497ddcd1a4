#include <railbook/num/quadrature.hpp>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>

#include <railbook/num/detail/counted.hpp>
#include <railbook/num/gsl.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::num {

Integral integrate(const std::function<double(double)>& f, double a, double b, double relative,
                   double absolute) {
  use_gsl_status_codes();
  constexpr std::size_t limit = 2000;
  const auto space =
      gsl_owned(gsl_integration_workspace_alloc(limit), gsl_integration_workspace_free);
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
  // The zeros of Legendre's polynomial by Newton's method, in 80 bits. (GSL's own are good to 1e-11
  // for most n.)
  GaussRule rule{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  const long double half = (static_cast<long double>(b) - a) / 2;
  for (int i = 0; i < n; ++i) {
    long double x = -std::cos(units::pi * (i + 0.75) / (n + 0.5)), slope = 0;
    for (int pass = 0; pass < 6; ++pass) {
      long double before = 1, value = x;
      for (int k = 2; k <= n; ++k) {
        const long double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value, value = next;
      }
      slope = n * (x * value - before) / ((x - 1) * (x + 1));
      x -= value / slope;
    }
    rule.x[i] = static_cast<double>(a + half * (1 + x));
    rule.w[i] = static_cast<double>(2 * half / ((1 - x) * (1 + x) * slope * slope));
  }
  return rule;
}

}  // namespace railbook::num
