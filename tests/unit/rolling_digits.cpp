// Closed forms of rolling contact against 80-bit arithmetic over their ranges.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "num/log_spaced.hpp"
#include "rolling/cell_displacements.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/fastsim.hpp"

using namespace railbook;
using namespace railbook::rolling;

namespace {

constexpr double poisson = 0.3;

using Long = long double;
const Long pi_long = std::acos(Long{-1});

// Double-exponential quadrature of f over a to b, to the last digits of 80 bits for integrands with end singularities.
template <class F>
Long integral(const F& f, Long a, Long b) {
  constexpr int half = 300;
  const Long step = Long{4.2} / half;
  Long sum = 0;
  for (int k = -half; k <= half; ++k) {
    const Long t = k * step, s = pi_long / 2 * std::sinh(t);
    const Long weight = pi_long / 2 * std::cosh(t) / (std::cosh(s) * std::cosh(s));
    sum += weight * f((a + b) / 2 + (b - a) / 2 * std::tanh(s));
  }
  return sum * step * (b - a) / 2;
}

// The strips of FASTSIM, each stuck over 2 l - w of its length 2 l.
Long fastsim_integral(double x) {
  const Long w = 3 * pi_long / 16 * x;
  const auto strip = [&](Long y) {
    const Long l = std::sqrt(std::max(Long{0}, (1 - y) * (1 + y))),
               s = std::max(Long{0}, 2 * l - w);
    return w * s * s / 2 + 4 * l * l * l / 3 - l * s * s + s * s * s / 3;
  };
  const Long kink = w < 2 ? std::sqrt((1 - w / 2) * (1 + w / 2)) : Long{0};
  return 4 / pi_long * (integral(strip, 0, kink) + integral(strip, kink, 1));
}

// pi/phi of Vermeulen and Johnson by the integrals B, D and C over a quarter turn.
Long slope_integral(double ratio, Long nu) {
  const Long g = ratio > 1 ? 1 / Long{ratio} : Long{ratio}, m = (1 - g) * (1 + g);
  constexpr int n = 2000;
  Long b = 0, d = 0, c = 0;
  for (int k = 0; k < n; ++k) {
    const Long t = pi_long / 2 * (k + Long{0.5}) / n, s2 = std::sin(t) * std::sin(t);
    const Long root = std::sqrt(1 - m * s2), part = pi_long / 2 / n;
    b += part * (1 - s2) / root, d += part * s2 / root;
    c += part * s2 * (1 - s2) / (root * root * root);
  }
  return pi_long / (ratio > 1 ? g * (d - nu * (d - c)) : b - nu * (d - c));
}

// Displacement along, `far` cells ahead of a square cell of side 1, from the corners.
Long influence(double far) {
  const Long nu = poisson;
  const auto corner = [&](Long x, Long y) {
    return (1 - nu) * x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y));
  };
  const Long right = far + Long{0.5}, left = far - Long{0.5}, up = Long{0.5};
  return 2 * (corner(right, up) - corner(left, up));
}

// The largest relative error of `function` over the arguments.
template <class Function, class Exact>
double worst(const std::vector<double>& arguments, const Function& function, const Exact& exact) {
  double most = 0;
  for (const double x : arguments) {
    const Long truth = exact(x);
    most = std::max(most, static_cast<double>(std::abs((function(x) - truth) / truth)));
  }
  return most;
}

constexpr KalkerCoefficients one{1, 1, 1, 1};
RollingCase at(double x) {
  return with_reduced_creepage(unit_case(1, poisson), {x, 0, 0});
}

}  // namespace

TEST_CASE("unit: the closed forms keep their digits over their ranges") {
  const auto creepages = num::log_spaced(1e-3, 100, 12);
  CHECK(worst(
            creepages, [](double x) { return fastsim_without_spin(at(x), one).fx; },
            fastsim_integral) < 1e-14);
  CHECK(worst(
            creepages, [](double x) { return polach(at(x), one).fx; },
            [](Long x) {
              const Long e = pi_long / 4 * x;
              return 2 / pi_long * (e / (1 + e * e) + std::atan(e));
            }) < 1e-14);
  CHECK(worst(
            num::log_spaced(0.02, 50, 12),
            [](double r) { return vermeulen_johnson_slopes(r, poisson).longitudinal; },
            [](double r) { return slope_integral(r, poisson); }) < 1e-13);
  // Differences of differences lose the square of the distance in cells.
  CHECK(worst(
            num::log_spaced(1, 300, 12),
            [](double far) {
              std::vector<Influence2> u(1);
              row_displacements(far, 0, 1, 1, poisson, u);
              return u[0].xx;
            },
            influence) < 1e-16 * 300 * 300 * 10);
}
