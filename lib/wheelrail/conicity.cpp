#include "wheelrail/conicity.hpp"

#include <algorithm>
#include <cmath>

#include "num/quadrature.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::wheelrail {

namespace {

// The way inwards over a length on which the pull goes from `outer` to `inner` evenly, in closed form: a quarter of the wave
// bends like sqrt(A - y) at its outer end, and does so in a piece that ends just beside that, where no quadrature follows.
struct Passage {
  double distance = 0;  // along the track over sqrt(r_0)
  double energy = 0;    // at its end; not positive where the wheelset does not come so far
};
Passage pass(double length, double outer, double inner, double energy) {
  Passage p;
  p.energy = energy + 0.5 * length * (outer + inner);
  const double slope = (outer - inner) / length;
  // Least where a push outwards turns into a pull.
  if (outer < 0 && inner > 0 && energy <= -0.5 * outer * outer / slope) p.energy = 0;
  if (!(p.energy > 0)) return p;
  const double before = std::sqrt(2 * energy), after = std::sqrt(2 * p.energy);
  const double rise = length * (outer + inner) / (before + after);  // after - before
  const double root = std::sqrt(std::abs(slope));
  if (slope == 0)
    p.distance = 2 * length / (before + after);
  else if (slope > 0)
    p.distance = std::atan2(root * (outer * rise + before * slope * length),
                            outer * inner + slope * before * after) /
                 root;
  else
    p.distance = std::log1p(root * (rise + root * length) / (root * before + outer)) / root;
  return p;
}

}  // namespace

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
      first += w * R(y) * sine;
      moment += w * R(y) * y * amplitude * cosine;
    }
    const Passage passage = pass(outer - inner, R(outer), R(inner), energy);
    oscillates = oscillates && passage.energy > 0;
    quarter += std::sqrt(r0) * passage.distance;
    energy = passage.energy;
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
