#include <railbook/vehicle/describing_function.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::vehicle {

namespace {

using units::pi;

// Share of a sine's cycle spent below beta times its amplitude, weighted by sin^2: 0 at 0, 1 at 1.
double inner_share(double beta, double root) {
  return 2 / pi * (std::asin(beta) + beta * root);
}

// The rest of it, 1 - inner_share, which close to 1 is all that a dead zone leaves: (2 t - sin 2
// t)/pi at beta = cos t.
double outer_share(double beta, double root) {
  const double x = 2 * std::atan2(root, beta);
  if (x > 0.7) return (x - std::sin(x)) / pi;
  double sum = 0, term = x * x * x / 6;
  for (int k = 4; std::abs(term) > 1e-17 * sum; k += 2) sum += term, term *= -x * x / (k * (k + 1));
  return sum / pi;
}

void require_odd_table(std::span<const double> x, std::span<const std::vector<double>> values) {
  if (x.size() < 2) throw InputError("describing function: a table needs two points or more");
  for (std::size_t k = 0; k < x.size(); ++k)
    units::require_between("point of a table", x[k], k > 0 ? std::nextafter(x[k - 1], 1e300) : 0,
                           k > 0 ? 1e300 : 0);
  for (const auto& function : values) {
    if (function.size() != x.size())
      throw InputError("describing function: a value is missing or there is one too many");
    units::require_between("odd function at 0", function[0], 0, 0);
    for (const double value : function) units::require_finite("value of a table", value);
  }
}

}  // namespace

PiecewiseLinearGain::PiecewiseLinearGain(std::span<const double> x,
                                         std::span<const std::vector<double>> values)
    : functions_(values.size()) {
  require_odd_table(x, values);
  const auto slope = [&](std::size_t f, std::size_t k) {
    return (values[f][k + 1] - values[f][k]) / (x[k + 1] - x[k]);
  };
  for (std::size_t f = 0; f < functions_; ++f) first_slope_.push_back(slope(f, 0));
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    bool bends = false;
    for (std::size_t f = 0; f < functions_; ++f) bends |= slope(f, k) != slope(f, k - 1);
    if (!bends) continue;
    bend_.push_back(x[k]);
    for (std::size_t f = 0; f < functions_; ++f) change_.push_back(slope(f, k) - slope(f, k - 1));
  }
}

void PiecewiseLinearGain::evaluate(double amplitude, std::span<Gain> gains) const {
  for (std::size_t f = 0; f < functions_; ++f) gains[f] = {first_slope_[f], 0};
  const double* change = change_.data();
  for (const double bend : bend_) {
    if (bend >= amplitude) break;
    const double beta = bend / amplitude;
    const double root = std::sqrt((1 - beta) * (1 + beta));
    const double outer = outer_share(beta, root);
    const double rise = 4 / pi * beta * root / amplitude;
    for (std::size_t f = 0; f < functions_; ++f, ++change) {
      gains[f].value += *change * outer;
      gains[f].slope += *change * rise;
    }
  }
}

QuadratureGain describe(const std::function<double(double)>& f,
                        const std::function<double(double)>& derivative, double amplitude,
                        double relative) {
  units::require_positive("amplitude", amplitude);
  const auto sine = [&](double psi) { return f(amplitude * std::sin(psi)) * std::sin(psi); };
  const auto rise = [&](double psi) {
    const double s = std::sin(psi);
    return derivative(amplitude * s) * s * s;
  };
  // A quarter of the cycle is enough, f being odd.
  const auto n = num::integrate(sine, 0, pi / 2, relative);
  const double value = 4 / (pi * amplitude) * n.value;
  const auto r = num::integrate(rise, 0, pi / 2, relative, relative * std::abs(value));
  return {.gain = {value, (4 / pi * r.value - value) / amplitude},
          .evaluations = n.evaluations + r.evaluations,
          .converged = n.converged && r.converged};
}

Gain ideal_friction(double level, double amplitude) {
  units::require_positive("amplitude", amplitude);
  const double value = 4 * level / (pi * amplitude);
  return {value, -value / amplitude};
}

Gain regularized_friction(double level, double stick, double amplitude) {
  if (amplitude <= stick) return {level / stick, 0};
  const double beta = stick / amplitude;
  const double root = std::sqrt((1 - beta) * (1 + beta));
  return {level / stick * inner_share(beta, root),
          -4 * level / (pi * stick) * beta * root / amplitude};
}

}  // namespace railbook::vehicle
