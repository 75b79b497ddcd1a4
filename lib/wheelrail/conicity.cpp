#include "wheelrail/conicity.hpp"

#include <algorithm>
#include <cmath>

#include "num/quadrature.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::wheelrail {

Conicity conicity(const ConstraintFunctions& pair, double amplitude) {
  const OddTable& R = pair.R;
  units::require_positive("amplitude", amplitude, "m");
  units::require_between("amplitude", amplitude, 0, R.end() * (1 + 1e-12), "m");
  static const num::GaussRule rule = num::gauss_legendre(8);
  const double a = pair.half_spacing, r0 = pair.radius;
  double quarter = 0, first = 0, moment = 0;
  double energy = 0;  // the integral of R from y to the amplitude
  bool oscillates = true;
  const auto phase = [&](double y) { return std::asin(std::min(1.0, y / amplitude)); };
  for (double outer = amplitude; outer > 0;) {
    const double knot = R.step() * std::floor(outer / R.step() * (1 - 1e-13));
    const double inner = std::max(0.0, knot), from = phase(inner), to = phase(outer);
    for (Eigen::Index i = 0; i < rule.x.size(); ++i) {
      const double psi = 0.5 * (from + to + (to - from) * rule.x[i]);
      const double w = 0.5 * (to - from) * rule.w[i];
      const double sine = std::sin(psi), cosine = std::cos(psi), y = amplitude * sine;
      const double level = energy + 0.5 * (outer - y) * (R(y) + R(outer));
      if (level > 0)
        quarter += w * amplitude * cosine / std::sqrt(2 * level / r0);
      else
        oscillates = false;
      first += w * R(y) * sine;
      moment += w * R(y) * y * amplitude * cosine;
    }
    energy += 0.5 * (outer - inner) * (R(inner) + R(outer));
    outer = inner;
  }
  Conicity result;
  result.amplitude = amplitude;
  result.harmonic = 4 * a * first / (units::pi * amplitude);
  result.regression = 3 * a * moment / (amplitude * amplitude * amplitude);
  result.oscillates = oscillates;
  if (oscillates) {
    result.wavelength = 4 * quarter;
    const double wavenumber = 2 * units::pi / result.wavelength;
    result.kinematic = wavenumber * wavenumber * a * r0;
  }
  return result;
}

}  // namespace railbook::wheelrail
