#include <railbook/wheelset/conicity.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <railbook/num/quadrature.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::wheelset {

namespace {

// The way inwards over a length on which the pull goes from `outer` to `inner` evenly, in closed
// form: a quarter of the wave bends like sqrt(A - y) at its outer end, and does so in a piece that
// ends just beside that, where no quadrature follows.
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

// The difference of radii of a wheelset whose sides differ, piecewise linear between knots -end,
// ..., 0, ..., end.
class Steering {
 public:
  explicit Steering(const ConstraintFunctions& f) : step_(f.R.step()) {
    const auto& odd = f.R.values();
    const auto& even = f.even.R;
    for (std::size_t i = odd.size(); i-- > 1;) at_.push_back(even[i] - odd[i]);
    for (std::size_t i = 0; i < odd.size(); ++i) at_.push_back(even[i] + odd[i]);
    end_ = step_ * double(odd.size() - 1);
  }
  double end() const { return end_; }

  double operator()(double x) const {
    const std::size_t i = interval(x);
    return at_[i] + (x - knot(i)) * (at_[i + 1] - at_[i]) / step_;
  }

  // Where it steers neither way, the nearest to the middle; NaN when it steers one way all along.
  double centre() const {
    double nearest = units::nan;
    for (std::size_t i = 0; i + 1 < at_.size(); ++i) {
      if (!(at_[i] <= 0 && at_[i + 1] > 0)) continue;
      const double x = knot(i) - step_ * at_[i] / (at_[i + 1] - at_[i]);
      if (!(std::abs(x) >= std::abs(nearest))) nearest = x;
    }
    return nearest;
  }

  // The way from `outer` to `inner`: its passages one after the other.
  Passage way(double inner, double outer) const {
    const double sign = outer < inner ? -1 : 1;
    std::vector<double> stops = between(inner, outer);  // from the inner end
    Passage whole;
    for (std::size_t i = stops.size() - 1; i > 0; --i) {
      const double from = stops[i], to = stops[i - 1];
      const Passage p =
          pass(std::abs(from - to), sign * (*this)(from), sign * (*this)(to), whole.energy);
      if (!(p.energy > 0)) return {units::nan, 0};
      whole.distance += p.distance;
      whole.energy = p.energy;
    }
    return whole;
  }

  // The work of the steering from the centre to x.
  double work(double centre, double x) const {
    const std::vector<double> stops = between(centre, x);
    double sum = 0;
    for (std::size_t i = 1; i < stops.size(); ++i)
      sum += 0.5 * ((*this)(stops[i - 1]) + (*this)(stops[i])) * (stops[i] - stops[i - 1]);
    return sum;
  }

 private:
  double knot(std::size_t i) const { return step_ * double(i) - end_; }
  // a, the knots between, b; places closer than rounding are one.
  std::vector<double> between(double a, double b) const {
    const double least = 1e-9 * step_;
    std::vector<double> stops;
    for (std::size_t i = 0; i < at_.size(); ++i)
      if (knot(i) > std::min(a, b) + least && knot(i) < std::max(a, b) - least)
        stops.push_back(knot(i));
    if (a > b) std::ranges::reverse(stops);
    stops.insert(stops.begin(), a);
    stops.push_back(b);
    return stops;
  }
  std::size_t interval(double x) const {
    const double i = std::floor((x + end_) / step_);
    return std::size_t(std::clamp(i, 0.0, double(at_.size() - 2)));
  }
  double step_, end_ = 0;
  std::vector<double> at_;
};

Conicity of_unlike_sides(const ConstraintFunctions& pair, double amplitude) {
  const Steering steering(pair);
  Conicity result;
  result.amplitude = amplitude;
  result.harmonic = result.regression = units::nan;
  result.oscillates = false;
  result.centre = steering.centre();
  if (std::isnan(result.centre)) return result;
  const double c = result.centre;
  units::require_between("amplitude about the centre of the run", amplitude, 0,
                         steering.end() - std::abs(c), "m");
  // The ends of the run have the same energy.
  const auto excess = [&](double x) {
    return steering.work(c, x) - steering.work(c, x - 2 * amplitude);
  };
  const double low = c + 1e-6 * amplitude,
               high = std::min(c + (2 - 1e-6) * amplitude, steering.end());
  if (!(excess(low) < 0 && excess(high) > 0)) return result;
  const double right = num::find_root(excess, low, high).x;
  const Passage from_right = steering.way(c, right),
                from_left = steering.way(c, right - 2 * amplitude);
  result.oscillates = from_right.energy > 0 && from_left.energy > 0;
  if (!result.oscillates) return result;
  result.wavelength = 2 * std::sqrt(pair.radius) * (from_right.distance + from_left.distance);
  const double wavenumber = 2 * units::pi / result.wavelength;
  result.kinematic = wavenumber * wavenumber * pair.half_spacing * pair.radius;
  return result;
}

}  // namespace

Conicity conicity(const ConstraintFunctions& pair, double amplitude) {
  const OddTable& R = pair.R;
  units::require_positive("amplitude", amplitude, "m");
  units::require_between("amplitude", amplitude, 0, R.end() * (1 + 1e-12), "m");
  if (!pair.symmetric()) return of_unlike_sides(pair, amplitude);
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

}  // namespace railbook::wheelset
