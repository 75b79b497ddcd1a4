/***
### What the program says of its errors

The full theory states an error for the force, from a grid of half the cells. Random ellipses (a/b from 0.1 to 10, all Poisson's ratios) and creepages, 8 x 4 and 12 x 6 cells, against 32 x 16:
{{covered}} are within what was stated, which is {{median-margin}} times the true error in the middle of them.

{{estimates}}

### Digits of the closed forms

{{digits}}
*/

#include <fmt/format.h>

#include <cmath>

#include "../rig.hpp"
#include "../sections.hpp"
#include "bench/evidence.hpp"
#include "rolling/cell_displacements.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/fastsim.hpp"
#include "rolling/rolling_contact.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

void estimates(report::Item& item) {
  item.added("a study of the solver's own estimates");
  item.expect_checks(1);
  std::vector<bench::Estimate> runs;
  for (std::uint64_t k = 0; k < (item.full() ? 200u : 12u); ++k) {
    bench::Draw draw(15, k);
    const double ratio = draw.decades(0.1, 10), nu = draw(0, 0.5);
    const EllipseRolling best(ratio, nu, {.along = 32, .rows = 16});
    const EllipseRolling coarse[] = {{ratio, nu, {.along = 8, .rows = 4}},
                                     {ratio, nu, {.along = 12, .rows = 6}}};
    for (int j = 0; j < 4; ++j) {
      const double size = draw.decades(0.01, 4), angle = draw(0, 2 * units::pi);
      const double spin = j == 0 ? 0 : draw(-1, 1) * draw.decades(0.05, 5);
      const auto c = with_reduced_creepage(unit_case(ratio, nu),
                                           {size * std::cos(angle), size * std::sin(angle), spin});
      const CreepForces truth = best.solve(c);
      for (const EllipseRolling& contact : coarse) {
        const CreepForces f = contact.solve(c);
        runs.push_back(
            {fmt::format("{}-{}", k, j), f.error, std::hypot(f.fx - truth.fx, f.fy - truth.fy)});
      }
    }
  }
  bench::estimates_against_truth(item, runs);
}

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

std::vector<double> places(double low, double high, int n = 60) {
  std::vector<double> all;
  for (int k = 0; k < n; ++k) all.push_back(low * std::pow(high / low, (k + 0.5) / n));
  return all;
}

void digits(report::Item& item) {
  item.added("a study of closed forms");
  item.expect_checks(4);
  const KalkerCoefficients one{1, 1, 1, 1};
  const auto at = [](double x) { return with_reduced_creepage(unit_case(1, poisson), {x, 0, 0}); };
  const auto row = [&](const char* id, const char* function, const char* range, const char* against,
                       double allowed) {
    return bench::Digits{id, function, range, against, allowed};
  };
  const char* integrals = "its integral in 80-bit arithmetic";
  bench::digits_table(
      item,
      {bench::worst_digits(
           row("fastsim", "FASTSIM without spin", "C₁₁X from 1e-3 to 100", integrals, 1e-14),
           places(1e-3, 100), [&](double x) { return fastsim_without_spin(at(x), one).fx; },
           fastsim_integral),
       bench::worst_digits(
           row("polach", "Polach's law without spin", "C₁₁X from 1e-3 to 100",
               "the same formula in 80-bit arithmetic", 1e-14),
           places(1e-3, 100), [&](double x) { return polach(at(x), one).fx; },
           [](double x) {
             const Long e = pi_long / 4 * x;
             return 2 / pi_long * (e / (1 + e * e) + std::atan(e));
           }),
       bench::worst_digits(
           row("slope", "slope of Vermeulen and Johnson", "a/b from 0.02 to 50", integrals, 1e-13),
           places(0.02, 50),
           [](double r) { return vermeulen_johnson_slopes(r, poisson).longitudinal; },
           [](double r) { return slope_integral(r, poisson); }),
       // Differences of differences lose the square of the distance in cells.
       bench::worst_digits(
           row("influence", "influence of a cell", "1 to 300 cells away",
               "its corners in 80-bit arithmetic", 1e-16 * 300 * 300 * 10),
           places(1, 300),
           [](double far) {
             std::vector<Influence2> u(1);
             row_displacements(far, 0, 1, 1, poisson, u);
             return u[0].xx;
           },
           influence)});
}

}  // namespace

const report::Section creep_chapter::evidence{
    report::figure("estimates", "True over stated error of the full theory", estimates),
    report::table("digits", "Digits of closed forms", digits)};
