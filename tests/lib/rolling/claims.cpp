// The accuracy that lib/rolling states, on seeded inputs over its range, against 80-bit arithmetic.
#include <cmath>
#include <vector>

#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/detail/cell_displacements.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/theory.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::tests;

namespace {

constexpr double poisson = 0.3;

// Double-exponential quadrature of f over a to b, to the last digits of 80 bits for integrands with
// end singularities.
template <class F>
Long integral(const F& f, Long a, Long b) {
  constexpr int half = 300;
  const Long step = Long{4.2} / half;
  Long sum = 0;
  for (int k = -half; k <= half; ++k) {
    const Long t = k * step, s = long_pi / 2 * std::sinh(t);
    const Long weight = long_pi / 2 * std::cosh(t) / (std::cosh(s) * std::cosh(s));
    sum += weight * f((a + b) / 2 + (b - a) / 2 * std::tanh(s));
  }
  return sum * step * (b - a) / 2;
}

// The strips of FASTSIM, each stuck over 2 l - w of its length 2 l.
Long fastsim_integral(double x) {
  const Long w = 3 * long_pi / 16 * x;
  const auto strip = [&](Long y) {
    const Long l = std::sqrt(std::max(Long{0}, (1 - y) * (1 + y))),
               s = std::max(Long{0}, 2 * l - w);
    return w * s * s / 2 + 4 * l * l * l / 3 - l * s * s + s * s * s / 3;
  };
  const Long kink = w < 2 ? std::sqrt((1 - w / 2) * (1 + w / 2)) : Long{0};
  return 4 / long_pi * (integral(strip, 0, kink) + integral(strip, kink, 1));
}

// pi/phi of Vermeulen and Johnson by the integrals B, D and C over a quarter turn.
Long slope_integral(double ratio, Long nu) {
  const Long g = ratio > 1 ? 1 / Long{ratio} : Long{ratio}, m = (1 - g) * (1 + g);
  constexpr int n = 600;
  Long b = 0, d = 0, c = 0;
  for (int k = 0; k < n; ++k) {
    const Long t = long_pi / 2 * (k + Long{0.5}) / n, s2 = std::sin(t) * std::sin(t);
    const Long root = std::sqrt(1 - m * s2), part = long_pi / 2 / n;
    b += part * (1 - s2) / root, d += part * s2 / root;
    c += part * s2 * (1 - s2) / (root * root * root);
  }
  return long_pi / (ratio > 1 ? g * (d - nu * (d - c)) : b - nu * (d - c));
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

constexpr KalkerCoefficients one{1, 1, 1, 1};
RollingCase at(double x) {
  return with_reduced_creepage(normalised_case(1, poisson), {x, 0, 0});
}

}  // namespace

TEST_CASE("claim: closed forms of the creep forces") {
  Claim strips("rolling::fastsim_without_spin"), curve("rolling::polach"),
      slopes("rolling::vermeulen_johnson_slopes"), displacements("rolling::row_displacements");
  RandomStream draw(1);
  for (int k = 0; k < 1000; ++k) {
    const double x = draw.decades(1e-3, 100);
    strips.relative(fastsim_without_spin(at(x), one).fx, fastsim_integral(x));
    const Long e = long_pi / 4 * x;
    curve.relative(polach(at(x), one).fx, 2 / long_pi * (e / (1 + e * e) + std::atan(e)));
    // Half of them nearly round, where the closed form cancels.
    const double ratio =
        k % 2 == 0 ? draw.decades(0.02, 50) : 1 + (k % 4 == 1 ? 1 : -1) * draw.decades(1e-9, 0.5);
    slopes.relative(vermeulen_johnson_slopes(ratio, poisson).longitudinal,
                    slope_integral(ratio, poisson));
    // Differences of differences lose the square of the distance in cells.
    const double far = draw.decades(1, 300);
    std::vector<Influence2> u(1);
    row_displacements(far, 0, 1, 1, poisson, u);
    const Long exact = influence(far);
    displacements.error(static_cast<double>(std::abs(u[0].xx / exact - 1)) / (far * far));
  }
}

TEST_CASE("claim: no theory but the linear one exceeds friction, and small creepage is linear") {
  Claim bound("rolling::creep_forces"), linear("rolling::linear_theory");
  RandomStream draw(2);
  for (int k = 0; k < 400; ++k) {
    RollingCase c{
        draw.decades(1e-3, 2e-2), 0, draw.decades(1e2, 1e6), draw.decades(2e10, 1e11), draw(0, 0.5),
        draw.decades(0.01, 1),    {}};
    c.b = c.a / draw.decades(0.2, 5);
    const Creepage reduced{draw(-1, 1) * draw.decades(1e-3, 10),
                           draw(-1, 1) * draw.decades(1e-3, 10),
                           draw(-1, 1) * draw.decades(1e-3, 1)};
    const RollingCase loaded = with_reduced_creepage(c, reduced);
    for (const Theory theory : {Theory::shen_hedrick_elkins, Theory::fastsim, Theory::polach}) {
      const CreepForces f = creep_forces(theory, loaded);
      bound.error(std::max(0.0, std::hypot(f.fx, f.fy) / (c.friction * c.load) - 1));
    }
    const KalkerCoefficients kalker{draw(1, 6), draw(1, 6), draw(0.2, 3), draw(0.2, 3)};
    const CreepForces f = linear_theory(loaded, kalker);
    const Long g = c.shear_modulus, ab = Long{c.a} * c.b, s = std::sqrt(ab);
    const Creepage& creep = loaded.creepage;
    const Long fy = g * ab * (kalker.c22 * Long{creep.lateral} + s * kalker.c23 * creep.spin);
    const Long mz = g * ab * (ab * kalker.c33 * Long{creep.spin} - s * kalker.c23 * creep.lateral);
    const Long size_y =
        g * ab * (kalker.c22 * std::abs(creep.lateral) + s * kalker.c23 * std::abs(creep.spin));
    const Long size_m =
        g * ab *
        (ab * kalker.c33 * std::abs(creep.spin) + s * kalker.c23 * std::abs(creep.lateral));
    linear.relative(f.fx, g * ab * kalker.c11 * creep.longitudinal);
    linear.error(static_cast<double>(std::abs(f.fy - fy) / size_y));
    linear.error(static_cast<double>(std::abs(f.mz - mz) / size_m));
  }
}

TEST_CASE("claim: each named theory solves, and says that without friction there are no forces") {
  CHECK(theory_names().size() == 7);
  RollingCase c = with_reduced_creepage(normalised_case(1.2, poisson), {0.01, 0.01, 0});
  const CreepForces exact = solver("full", 1.2, poisson, 12)(c);
  for (const std::string& name : theory_names()) {
    INFO(name);
    const Solver solve = solver(name, 1.2, poisson, 12);
    c.friction = 1;
    CHECK(solve(c).fx == Approx(exact.fx).epsilon(0.3));
    c.friction = 0;
    const CreepForces none = solve(c);
    CHECK(none.converged);
    if (name == "linear") continue;  // which knows no bound
    CHECK(none.fx == 0);
    CHECK(none.fy == 0);
    CHECK(none.mz == 0);
  }
}
