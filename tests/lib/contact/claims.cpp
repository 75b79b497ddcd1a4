// The accuracy that lib/contact states, on seeded inputs over its range; exact values in 80-bit
// arithmetic, by Gauss's mean and bisection.
#include <cmath>

#include <railbook/contact/convolution.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/contact/influence.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::tests;

namespace {

// K and D = (K - E)/m at m1 = 1 - m = exp(log_m1).
struct Elliptic {
  Long k, d;
};
Elliptic elliptic(Long log_m1) {
  const Long m = -std::expm1(log_m1);
  Long a = 1, g = std::exp(log_m1 / 2), sum = 0.5L, square = m, power = 1;
  for (int n = 0; n < 40 && square > 1e-40L * m; ++n) {
    const Long next = (a + g) / 2, half = square / (4 * next);
    g = std::sqrt(a * g), a = next;
    square = half * half;
    sum += power * square / m;
    power *= 2;
  }
  const Long k = long_pi / (2 * a);
  return {k, k * sum};
}

// ln m1 of Hertz's ellipse for a ratio of curvatures > 1.
Long axis_ratio_long(Long ratio) {
  Long low = -std::log(ratio) - 10, high = -1e-18L;
  for (int k = 0; k < 75; ++k) {
    const Long middle = (low + high) / 2;
    const Elliptic e = elliptic(middle);
    (std::log(e.k - e.d) - middle - std::log(e.d) > std::log(ratio) ? low : high) = middle;
  }
  return (low + high) / 2;
}

Long disc(Long c, Long r) {
  const Long log_m1 = std::log(std::abs(c - r)) + std::log(c + r) - 2 * std::log(std::max(c, r));
  const Elliptic e = elliptic(log_m1);
  const Long m = -std::expm1(log_m1);
  return r < c ? 4 * c * (e.k - m * e.d) : 4 * r * m * (e.k - e.d);
}

Long corner(Long x, Long y) {
  if (x == 0 || y == 0) return 0;
  return x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y));
}

}  // namespace

TEST_CASE("claim: elliptic integrals and Hertz's contact") {
  Claim integrals("contact::elliptic_integrals"), approach("contact::hertz_from_approach"),
      force("contact::hertz_from_force");
  RandomStream draw(1);
  for (int k = 0; k < 1000; ++k) {
    const double log_m1 = -draw.decades(1e-12, 700);
    const Elliptic e = elliptic(log_m1);
    const EllipticIntegrals found = elliptic_integrals(log_m1);
    // In units of the claim: 1e-15 K/B.
    const Long scale = e.k / (e.k - e.d);
    for (const auto& [value, exact] :
         {std::pair<Long, Long>{found.k, e.k}, {found.d, e.d}, {found.b, e.k - e.d}})
      integrals.error(static_cast<double>(std::abs(value / exact - 1) / scale));

    const double ratio = k % 2 == 0 ? draw.decades(1.000001, 10) : draw.decades(2, 1e200);
    const double a = draw.decades(1e-3, 1e3) / std::sqrt(ratio), delta = draw.decades(1e-9, 1e-3);
    const Long l = axis_ratio_long(Long{a * ratio} / a);
    const Elliptic at = elliptic(l);
    // With f = A x^2 + B y^2, A < B: a^2 = delta D/(A K), F = (4/3)... by the pressure p0 = E*
    // delta/(b K).
    const Long major = std::sqrt(delta * at.d / (a * at.k)), minor = major * std::exp(l / 2);
    const Long peak = 1e11L * delta / (minor * at.k);
    const Long load = 2 * long_pi / 3 * major * minor * peak;
    const HertzContact h = hertz_from_approach({a, a * ratio, 0}, 1e11, delta);
    for (const auto& [value, exact] :
         {std::pair<Long, Long>{h.a, major}, {h.b, minor}, {h.p_max, peak}, {h.force, load}})
      approach.relative(value, exact);
    const HertzContact again = hertz_from_force({a, a * ratio, 0}, 1e11, h.force);
    for (const auto& [value, exact] : {std::pair<double, double>{again.a, h.a},
                                       {again.b, h.b},
                                       {again.p_max, h.p_max},
                                       {again.approach, delta}})
      force.relative(value, exact);
  }
}

TEST_CASE("claim: relative curvatures of convex bodies") {
  Claim claim("contact::relative_curvature");
  RandomStream draw(2);
  for (int k = 0; k < 1000; ++k) {
    const Curvature one{draw.decades(1e-8, 1), draw.decades(1e-8, 1), draw(-2, 2)};
    const Curvature two{draw.decades(1e-8, 1), draw.decades(1e-8, 1), draw(-2, 2)};
    const RelativeCurvature found = relative_curvature(one, two);
    // The eigenvalues of the sum of two symmetric matrices, the smaller by the determinant.
    Long xx = 0, yy = 0, xy = 0;
    for (const Curvature* c : {&one, &two}) {
      const Long cosine = std::cos(Long{c->angle}), sine = std::sin(Long{c->angle});
      xx += (c->first * cosine * cosine + c->second * sine * sine) / 2;
      yy += (c->first * sine * sine + c->second * cosine * cosine) / 2;
      xy += (Long{c->first} - c->second) * cosine * sine / 2;
    }
    const Long large = (xx + yy) / 2 + std::hypot((xx - yy) / 2, xy);
    claim.relative(std::max(found.a, found.b), large);
    // Its 80 bits are enough while the smaller is not below 1e-4 of the larger.
    const Long small = (xx * yy - xy * xy) / large;
    if (small > 1e-4L * large) claim.relative(std::min(found.a, found.b), small);
  }
}

TEST_CASE("claim: the curve of interpenetration") {
  Claim claim("contact::interpenetration_distance");
  RandomStream draw(3);
  for (int k = 0; k < 1000; ++k) {
    const double a = draw.decades(1e-4, 1e3), b = draw.decades(1e-4, 1e3), angle = draw(-4, 4),
                 delta = draw.decades(1e-12, 1e-2);
    const Long c = std::cos(Long{angle}), s = std::sin(Long{angle});
    claim.relative(interpenetration_distance(quadratic_gap({a, b, 0}), delta, angle),
                   std::sqrt(delta / (a * c * c + b * s * s)));
  }
}

TEST_CASE("claim: an empty contact, and a budget of memory") {
  const NormalContact none = empty_contact(-1e-6);
  CHECK(none.converged);
  CHECK(none.reason == empty_contact_reason);
  CHECK(none.approach == -1e-6);
  CHECK(none.force == 0);
  CHECK(none.p_max == 0);
  CHECK(none.area == 0);
  CHECK(none.p.size() == 0);
  // At least the pressures, the displacements and a padded transform, twice as many cells each way.
  CHECK(memory_needed(100, 50) > 8.0 * (2 + 4) * 100 * 50);
  CHECK(memory_needed(200, 100) > 3 * memory_needed(100, 50));
}

TEST_CASE("claim: disc, ring and rectangle") {
  Claim discs("contact::disc_influence"), rectangles("contact::rectangle_influence"),
      corners("contact::corner_function");
  RandomStream draw(4);
  for (int k = 0; k < 4000; ++k) {
    const double c = draw.decades(1e-3, 1e3), beside = draw.decades(1e-16, 1);  // of the edge
    const double r = k % 4 == 0   ? c * draw.decades(0.03, 30)
                     : k % 4 == 1 ? c * (1 + beside)
                     : k % 4 == 2 ? c * (1 - beside)
                                  : 2 * c * draw(0, 1);
    if (r == c) continue;
    const Long exact = disc(c, r);
    discs.relative(disc_influence(c, r), exact);
    const double wider = c * (1 + draw.decades(1e-4, 1));
    if (r == wider) continue;
    const Long ring = disc(wider, r) - exact;
    CHECK(std::abs(static_cast<double>((disc_influence(wider, r) - disc_influence(c, r)) / ring -
                                       1)) < 1e-14 * wider / (wider - c));

    corners.relative(corner_function(c, beside), corner(c, beside));
    const double a = draw.decades(1e-2, 1e2), b = draw.decades(1e-2, 1e2);
    const double far = std::max(a, b) * draw.decades(0.1, 1e4);
    const double x = far * draw(-0.5, 0.5), y = far * draw(-0.5, 0.5);
    const double x1 = x - a / 2, x2 = x + a / 2, y1 = y - b / 2, y2 = y + b / 2;
    const Long whole = corner(x2, y2) - corner(x1, y2) - corner(x2, y1) + corner(x1, y1);
    const double d =
        std::hypot(std::max(std::abs(x1), std::abs(x2)), std::max(std::abs(y1), std::abs(y2)));
    // The cell is the one between the four rounded numbers; in units of D^2/A.
    const double area = (x2 - x1) * (y2 - y1);
    rectangles.error(
        std::abs(static_cast<double>(rectangle_influence(x1, x2, y1, y2) / whole - 1)) * area /
        (d * d));
  }
}

TEST_CASE("claim: displacements by transforms") {
  Claim claim("contact::Convolution");
  RandomStream draw(6);
  for (int k = 0; k < 40; ++k) {
    const Grid grid{0, 0, draw.decades(1e-5, 1e-2), draw.decades(1e-5, 1e-2), 4 + k % 7, 4 + k % 5};
    Eigen::VectorXd p(grid.cells()), u(grid.cells());
    for (double& value : p) value = draw(0, 1e9);
    Convolution(grid, 1e11).apply(p, u);
    for (Eigen::Index n = 0; n < grid.cells(); ++n) {
      Long sum = 0;
      for (Eigen::Index m = 0; m < grid.cells(); ++m) {
        const double x = static_cast<double>(n % grid.nx - m % grid.nx) * grid.dx,
                     y = static_cast<double>(n / grid.nx - m / grid.nx) * grid.dy;
        sum += p[m] * rectangle_influence(x - grid.dx / 2, x + grid.dx / 2, y - grid.dy / 2,
                                          y + grid.dy / 2);
      }
      claim.relative(u[n], sum / (long_pi * 1e11L));
    }
  }
}

TEST_CASE("claim: displacements by the approximate transforms") {
  Claim claim("contact::approximate", 20);
  RandomStream draw(7);
  const auto worst = [&](const Grid& grid) {
    Convolution a(grid, 1e11);
    REQUIRE(a.approximates());
    Eigen::VectorXd p(grid.cells()), exact(grid.cells()), found(grid.cells());
    for (double& value : p) value = draw(0, 1e9);
    a.apply(p, exact);
    a.approximate(p, found);
    return (found - exact).cwiseAbs().maxCoeff() / exact.maxCoeff();
  };
  for (int k = 0; k < 20; ++k) {
    const Eigen::Index nx = 127 + 23 * (k % 7), ny = 127 + 31 * (k % 5);
    claim.error(
        worst({0, 0, 1e-5 * draw.decades(0.32, 3.2), 1e-5 * draw.decades(0.32, 3.2), nx, ny}));
  }
  for (const double dx : {1e-5 / 80, 1e-5 * 80}) CHECK(worst({0, 0, dx, 1e-5, 400, 350}) < 2e-6);
  CHECK_FALSE(Convolution({0, 0, 1e-5, 1e-5, 40, 40}, 1e11).approximates());
}
