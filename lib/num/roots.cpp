#include <railbook/num/roots.hpp>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <cmath>
#include <memory>
#include <string>

#include <railbook/num/detail/counted.hpp>
#include <railbook/num/gsl.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::num {

Root find_root(const std::function<double(double)>& f, double low, double high, double relative,
               int most) {
  use_gsl_status_codes();
  Counted counted{f};
  const double f_low = evaluate_counted(low, &counted);
  const double f_high = evaluate_counted(high, &counted);
  if (std::isnan(f_low) || std::isnan(f_high))
    throw InputError{"find_root: NaN at an end of the bracket"};
  if (f_low == 0) return {low, 0, counted.evaluations, true};
  if (f_high == 0) return {high, 0, counted.evaluations, true};
  if (std::signbit(f_low) == std::signbit(f_high)) {
    throw InputError{"find_root: no change of sign between " + std::to_string(low) + " and " +
                     std::to_string(high)};
  }

  const auto solver =
      gsl_owned(gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  gsl_function function{evaluate_counted, &counted};
  check_gsl(gsl_root_fsolver_set(solver.get(), &function, low, high), "find_root");

  Root root;
  for (int i = 0; i < most && !root.converged; ++i) {
    check_gsl(gsl_root_fsolver_iterate(solver.get()), "find_root");
    root.x = gsl_root_fsolver_root(solver.get());
    root.width = gsl_root_fsolver_x_upper(solver.get()) - gsl_root_fsolver_x_lower(solver.get());
    root.converged = root.width <= relative * std::abs(root.x) + 1e-300;
  }
  root.evaluations = counted.evaluations;
  return root;
}

}  // namespace railbook::num
