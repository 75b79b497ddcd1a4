// The accuracy that lib/contact states of shapes, fields and stresses, on seeded inputs over its
// range.
#include <Eigen/Eigenvalues>
#include <cmath>

#include <railbook/contact/bodies.hpp>
#include <railbook/contact/convolution.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/contact/material.hpp>
#include <railbook/contact/region.hpp>
#include <railbook/contact/subsurface.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/units/constants.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::tests;

namespace {

constexpr double two_pi = 2 * units::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

// Stresses [xx, yy, zz, xy, yz, zx] under point loads of 1 at the origin: pressing (Boussinesq) and
// pulling along x (Cerruti), as Johnson, Contact Mechanics, 1985, eqs (3.19) and (3.76), writes
// them; tension > 0.
std::array<double, 6> boussinesq(double nu, double x, double y, double z) {
  const double r2 = x * x + y * y + z * z, r = std::sqrt(r2), r5 = r2 * r2 * r, m = 1 - 2 * nu,
               rz = r + z;
  const auto direct = [&](double a) {
    return m * (z / (r2 * r) + a * a * (2 * r + z) / (r2 * r * rz * rz) - 1 / (r * rz)) -
           3 * z * a * a / r5;
  };
  return {direct(x) / (two_pi),
          direct(y) / (two_pi),
          -3 * z * z * z / r5 / (two_pi),
          (m * x * y * (2 * r + z) / (r2 * r * rz * rz) - 3 * x * y * z / r5) / (two_pi),
          -3 * y * z * z / r5 / (two_pi),
          -3 * x * z * z / r5 / (two_pi)};
}
std::array<double, 6> cerruti(double nu, double x, double y, double z) {
  const double r2 = x * x + y * y + z * z, r = std::sqrt(r2), r3 = r2 * r, r5 = r2 * r3,
               m = 1 - 2 * nu, rz = r + z;
  const double a = 1 / (r * rz * rz), b = (3 * r + z) / (r3 * rz * rz * rz);
  return {(-3 * x * x * x / r5 + m * (x / r3 - 3 * x * a + x * x * x * b)) / (two_pi),
          (-3 * x * y * y / r5 + m * (x / r3 - x * a + x * y * y * b)) / (two_pi),
          -3 * x * z * z / r5 / (two_pi),
          (-3 * x * x * y / r5 + m * (-y * a + x * x * y * b)) / (two_pi),
          -3 * x * y * z / r5 / (two_pi),
          -3 * x * x * z / r5 / (two_pi)};
}

}  // namespace

TEST_CASE("claim: the modulus of two bodies and the gaps of the shapes") {
  Claim modulus("contact::effective_modulus"), quadratic("contact::quadratic_gap"),
      wheel("contact::rail_wheel_gap"), roller("contact::crowned_roller_gap"),
      punch("contact::rounded_punch_gap"), joined("contact::join_bodies"),
      sampled("contact::sample");
  RandomStream draw(1);
  for (int k = 0; k < 1010; ++k) {
    const Material one{draw.decades(1e3, 1e15), k % 7 == 0 ? 0.5 : draw(0, 0.5)},
        two{draw.decades(1e3, 1e15), k % 5 == 0 ? 0.0 : draw(0, 0.5)};
    const auto flexibility = [](const Material& m) {
      return (1 - Long{m.poisson}) * (1 + Long{m.poisson}) / m.young;
    };
    modulus.relative(effective_modulus(one, two), 1 / (flexibility(one) + flexibility(two)));

    const double x = draw(-1, 1) * draw.decades(1e-8, 1), y = draw(-1, 1) * draw.decades(1e-8, 1);
    const double a = draw.decades(1e-6, 1e6), b = draw.decades(1e-6, 1e6);
    // Also along the long axis of a slender one, where the turn of the axes cancels.
    const double angle = draw(-4, 4), along = k % 2 == 0 ? angle : draw(-4, 4),
                 px = x * std::cos(along), py = x * std::sin(along);
    const Long c = std::cos(Long{angle}), s = std::sin(Long{angle}), first = c * px + s * py,
               second = c * py - s * px, exact = a * first * first + b * second * second;
    const Gap gap = quadratic_gap({a, b, angle});
    const Long scale = std::sqrt(std::max(a, b) / std::min(a, b));
    quadratic.error(static_cast<double>(std::abs(gap(px, py) / exact - 1) / scale));
    const Grid grid{x, y, a, b, 3, 2};
    const Eigen::VectorXd values = sample(gap, grid);
    for (const Eigen::Index n : {0, 2, 5})
      sampled.error(values[n] == gap(grid.x(n % 3), grid.y(n / 3)) ? 0 : 1);

    const double left = draw.decades(1e-3, 10), right = draw.decades(1e-3, 10),
                 tread =
                     k % 3 == 0 ? infinite : std::max(left, right) * (1 + draw.decades(1e-12, 1e3));
    const double radius = draw.decades(0.01, 10);
    const Long rail = x < 0 ? left : right, wheel_curve = std::isinf(tread) ? 0 : 1 / Long{tread};
    const Long across = (1 / rail - wheel_curve) / 2, lengthwise = Long{y} * y / (2 * Long{radius});
    wheel.error(static_cast<double>(std::abs(rail_wheel_gap({radius, tread, left, right})(x, y) -
                                             (lengthwise + across * x * x)) /
                                    (lengthwise + Long{x} * x / (2 * rail))));

    const double flat = draw.decades(1e-4, 1), crown = draw.decades(1e-6, 1e3),
                 beyond = flat * (1 + draw.decades(1e-15, 1e3));
    const Long past = Long{beyond} - flat;
    roller.relative(crowned_roller_gap({radius, flat, crown})(k % 2 == 0 ? beyond : -beyond, y),
                    lengthwise + past * past / (2 * Long{crown}));
    const double turned = draw(0, 7), rx = beyond * std::cos(turned),
                 ry = beyond * std::sin(turned);
    const Long r = std::hypot(Long{rx}, Long{ry});
    if (r > flat)
      punch.error(static_cast<double>(
          std::abs(rounded_punch_gap({flat, crown})(rx, ry) * 2 * crown / (r - flat) - (r - flat)) /
          r));

    // Two bodies by radii, one of them turned: the gap in its own axes is that of both surfaces.
    const Body lower{.radius_x = draw.decades(1e-3, 1e3), .radius_y = draw.decades(1e-3, 1e3)},
        upper{.radius_x = draw.decades(1e-3, 1e3), .radius_y = draw.decades(1e-3, 1e3)};
    const TouchingBodies both = join_bodies(lower, upper, angle);
    const Long u = std::cos(Long{both.angle}) * x - std::sin(Long{both.angle}) * y,
               v = std::sin(Long{both.angle}) * x + std::cos(Long{both.angle}) * y,
               u2 = c * u + s * v, v2 = c * v - s * u;
    const Long sum = (u * u / lower.radius_x + v * v / lower.radius_y + u2 * u2 / upper.radius_x +
                      v2 * v2 / upper.radius_y) /
                     2;
    const Long most = (Long{x} * x + Long{y} * y) / 2 *
                      (1 / Long{std::min(lower.radius_x, lower.radius_y)} +
                       1 / Long{std::min(upper.radius_x, upper.radius_y)});
    joined.error(static_cast<double>(std::abs(both.gap(x, y) - sum) / most));
  }
}

TEST_CASE("claim: thinned profiles show what interpolation does to the gap") {
  Claim claim("contact::join_thinned");
  RandomStream draw(2);
  for (int k = 0; k < 50; ++k) {
    // A circle, or a wavy crown, of 21 to 60 points; the touch is where the exact depth is least.
    const double radius = draw.decades(0.02, 1), wave = k % 2 == 0 ? 0 : draw(0, 0.3),
                 long_wave = draw(0.5, 1) * radius;
    const auto depth = [&](double x) {
      return radius - std::sqrt((radius - x) * (radius + x)) +
             wave * x * x / radius * std::sin(x / long_wave);
    };
    const Eigen::Index n = 21 + k % 40;
    DepthPoints points{Eigen::VectorXd::LinSpaced(n, -0.5 * radius, 0.6 * radius), {}};
    points.depth = points.x.unaryExpr(depth);
    const Body one{.profile = points, .radius_y = infinite}, two{.radius_y = 0.4};
    const TouchingBodies full = join_bodies(one, two);
    const auto coarse = join_thinned(one, two);
    REQUIRE(coarse.size() == 2);
    for (int place = -10; place <= 10; ++place) {
      const double x = place * 0.03 * radius;
      const double exact = depth(x + full.x_touch) - depth(full.x_touch);
      double change = 1e-14 * radius;
      for (const TouchingBodies& c : coarse)
        for (int near = -10; near <= 10; ++near)  // the largest, along the middle of the profile
          change = std::max(
              change, std::abs(c.gap(near * 0.03 * radius, 0) - full.gap(near * 0.03 * radius, 0)));
      claim.error(std::abs(full.gap(x, 0) - exact) / change);
    }
  }
}

TEST_CASE("claim: pressures by Hertz, and carried to another grid") {
  Claim hertz("contact::hertz_pressure"), carried("contact::transfer");
  RandomStream draw(3);
  for (int k = 0; k < 1000; ++k) {
    const RelativeCurvature curvature{draw.decades(1e-2, 1e2), draw.decades(1e-2, 1e2),
                                      draw(-4, 4)};
    const HertzContact h = hertz_from_approach(curvature, 1e11, draw.decades(1e-8, 1e-3));
    // Also next to the end of the ellipse.
    const double turn = draw(0, 7),
                 share = k % 2 == 0 ? draw(0, 1.1) : 1 - draw.decades(1e-15, 0.1);
    const Long c = std::cos(Long{curvature.angle}), s = std::sin(Long{curvature.angle});
    const double u = h.a * share * std::cos(turn), v = h.b * share * std::sin(turn);
    const double x = static_cast<double>(c * u - s * v), y = static_cast<double>(s * u + c * v);
    const Long first = (c * x + s * y) / h.a, second = (c * y - s * x) / h.b;
    const Long square = std::max(Long{0}, 1 - first * first - second * second);
    const Long found = hertz_pressure(h, x, y) / Long{h.p_max};
    hertz.error(static_cast<double>(std::abs(found * found - square) * std::min(h.a, h.b) /
                                    std::max(h.a, h.b)));
  }
  for (int k = 0; k < 60; ++k) {
    const Grid from{draw(-1, 0), draw(-1, 0), draw(0.1, 1), draw(0.1, 1), 5, 4},
        to{draw(-1, 0), draw(-1, 0), draw(0.1, 0.5), draw(0.1, 0.5), 6, 5};
    Eigen::VectorXd p(from.cells());
    for (double& value : p) value = draw(0, 1) > 0.3 ? draw.decades(1, 1e9) : 0;
    const Eigen::VectorXd found = transfer(from, p, to);
    // The squares, and beside the contact what lies on the line through the last two.
    const auto square = [&](Eigen::Index i, Eigen::Index j) {
      const bool inside = i >= 0 && j >= 0 && i < from.nx && j < from.ny;
      return inside ? Long{p[j * from.nx + i]} * p[j * from.nx + i] : Long{0};
    };
    const auto extended = [&](Eigen::Index i, Eigen::Index j) {
      Long sum = 0, lines = 0;
      for (const Eigen::Index step : {-1, 1})
        for (const bool along_x : {true, false}) {
          const Eigen::Index di = along_x ? step : 0, dj = along_x ? 0 : step;
          const Long beside = square(i + di, j + dj), next = square(i + 2 * di, j + 2 * dj);
          if (beside > 0 && next > 0) sum += std::min(2 * beside - next, Long{0}), lines += 1;
        }
      return square(i, j) > 0 || lines == 0 ? square(i, j) : sum / lines;
    };
    for (Eigen::Index n = 0; n < to.cells(); ++n) {
      // Every old cell's hat at the place.
      Long sum = 0, largest = 0;
      for (Eigen::Index i = -1; i <= from.nx; ++i)
        for (Eigen::Index j = -1; j <= from.ny; ++j) {
          const Long near_x = 1 - std::abs(Long{to.x(n % 6)} - from.x(i)) / from.dx,
                     near_y = 1 - std::abs(Long{to.y(n / 6)} - from.y(j)) / from.dy;
          const Long value = extended(i, j);
          sum += std::max(Long{0}, near_x) * std::max(Long{0}, near_y) * value;
          if (near_x > -1e-12L && near_y > -1e-12L) largest = std::max(largest, std::abs(value));
        }
      if (largest > 0)
        carried.error(static_cast<double>(
            std::abs(found[n] * Long{found[n]} - std::max(sum, Long{0})) / largest));
      else if (found[n] != 0)
        carried.error(1);
    }
  }
}

TEST_CASE("claim: quantities read off a field of pressures") {
  Claim region("contact::describe"), edges("contact::outline"),
      even("contact::InversePreconditioner"), box_claim("contact::interpenetration_box");
  RandomStream draw(4);
  for (int k = 0; k < 250; ++k) {
    // Hertz's pressure on an ellipse of 5 to 15 cells each way, anywhere against the cells.
    const Grid grid{draw(-1, 0), draw(-1, 0), draw.decades(0.01, 100), draw.decades(0.01, 100),
                    36,          36};
    const double a = draw(5, 15) * grid.dx, b = draw(5, 15) * grid.dy,
                 x0 = grid.x(17) + draw(0, 1) * grid.dx, y0 = grid.y(17) + draw(0, 1) * grid.dy;
    const auto root = [](double x) { return std::sqrt(std::max(0.0, x)); };
    Eigen::VectorXd p(grid.cells()), f = Eigen::VectorXd::Zero(grid.cells());
    Long force = 0;
    for (Eigen::Index n = 0; n < grid.cells(); ++n) {
      const double u = (grid.x(n % 36) - x0) / a, v = (grid.y(n / 36) - y0) / b;
      p[n] = root(1 - u * u - v * v);
      force += Long{p[n]} * grid.dx * grid.dy;
    }
    const Region found = describe(grid, p, f);
    REQUIRE(found.patches.size() == 1);
    CHECK(std::abs(found.force / static_cast<double>(force) - 1) < 1e-13);
    CHECK(std::abs(found.p_max - 1) < 1e-3);
    for (const double off :
         {(found.ends.x_min - (x0 - a)) / grid.dx, (found.ends.x_max - (x0 + a)) / grid.dx,
          (found.ends.y_min - (y0 - b)) / grid.dy, (found.ends.y_max - (y0 + b)) / grid.dy})
      region.error(std::abs(off));
    const Outline line = outline(grid, p, f);
    for (Eigen::Index n = 0; n < line.x.size(); ++n) {
      const double u = (line.x[n] - x0) / a;
      if (std::abs(u) > 0.8) continue;  // steeper than the cells are long
      edges.error(std::abs(line.high[n] - (y0 + b * root(1 - u * u))) / grid.dy);
      edges.error(std::abs(line.low[n] - (y0 - b * root(1 - u * u))) / grid.dy);
    }
  }
  for (int k = 0; k < 1000; ++k) {
    const Grid grid{0, 0, draw.decades(1e-5, 1), draw.decades(1e-5, 1), 1 + k % 9, 1 + k % 7};
    Convolution a(grid, 1);
    InversePreconditioner inverse(grid, 1);
    Eigen::VectorXd one(grid.cells()), two(grid.cells()), of_one(one), of_two(two);
    for (double& value : one) value = draw(-1, 1);
    for (double& value : two) value = draw(-1, 1);
    inverse.apply(one, of_one, a.workspace());
    inverse.apply(two, of_two, a.workspace());
    even.error(std::abs(one.dot(of_two) - two.dot(of_one)) / (one.norm() * of_two.norm()));
    REQUIRE(one.dot(of_one) > 0);

    const double slender = draw.decades(1, 1e4), turn = draw(-4, 4),
                 delta = draw.decades(1e-9, 1e-3), curve = draw.decades(1e-3, 1e3);
    const Box box =
        interpenetration_box(quadratic_gap({curve, curve * slender * slender, turn}), delta);
    const double longest = std::sqrt(delta / curve), shortest = longest / slender;
    const double half_x = std::hypot(longest * std::cos(turn), shortest * std::sin(turn)),
                 half_y = std::hypot(longest * std::sin(turn), shortest * std::cos(turn));
    box_claim.error(std::max({0.0, half_x / box.x_max - 1, half_x / -box.x_min - 1,
                              half_y / box.y_max - 1, half_y / -box.y_min - 1}));
    // Nor is it much larger.
    REQUIRE(std::max(-box.x_min, box.x_max) < 10 * half_x);
    REQUIRE(std::max(-box.y_min, box.y_max) < 10 * half_y);
  }
}

TEST_CASE("claim: stresses at a point") {
  Claim mises("contact::von_mises"), shear("contact::largest_shear");
  RandomStream draw(5);
  for (int k = 0; k < 2000; ++k) {
    // Half of them close to hydrostatic, some with two equal principal stresses, some of one
    // component.
    Stress s = Stress::Zero();
    const double size = draw.decades(1, 1e12),
                 small = k % 2 == 0 ? size : size * draw.decades(1e-12, 1);
    for (int n = 0; n < 6; ++n) s[n] = (k % 5 == 0 && n != k % 6) ? 0 : small * draw(-1, 1);
    if (k % 7 == 0) s[1] = s[0], s[3] = s[4] = s[5] = 0;
    if (k % 2 == 1) s[0] += size, s[1] += size, s[2] += size;
    const Long xy = Long{s[0]} - s[1], yz = Long{s[1]} - s[2], zx = Long{s[2]} - s[0];
    Long squares = 0;
    for (const int n : {3, 4, 5}) squares += Long{s[n]} * s[n];
    const Long exact = std::sqrt((xy * xy + yz * yz + zx * zx) / 2 + 3 * squares);
    mises.relative(von_mises(s), exact);
    Eigen::Matrix<Long, 3, 3> m;
    const Long mean = (Long{s[0]} + s[1] + s[2]) / 3;
    m << s[0] - mean, s[3], s[5], s[3], s[1] - mean, s[4], s[5], s[4], s[2] - mean;
    const auto values =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Long, 3, 3>>(m, Eigen::EigenvaluesOnly)
            .eigenvalues();
    if (exact > 0)
      shear.error(
          static_cast<double>(std::abs(largest_shear(s) - (values[2] - values[0]) / 2) / exact));
  }
}

TEST_CASE("claim: stresses below cells of traction") {
  Claim claim("contact::Subsurface");
  RandomStream draw(6);
  const num::GaussRule rule = num::gauss_legendre(24);
  for (int k = 0; k < 170; ++k) {
    const Grid grid{0, 0, draw.decades(1e-4, 1e-2), draw.decades(1e-4, 1e-2), 2 + k % 3, 3};
    const double nu = k % 4 == 0 ? 0.5 : draw(0, 0.5),
                 depth = std::max(grid.dx, grid.dy) * draw.decades(0.5, 50);
    Eigen::VectorXd t[3];
    for (auto& values : t) {
      values.resize(grid.cells());
      for (double& value : values) value = draw(0, 1);
    }
    const Stresses found = Subsurface(grid, nu, t[0], t[1], t[2]).at(depth);
    const Eigen::Index at = k % grid.cells();
    std::array<double, 6> sum{};
    for (Eigen::Index m = 0; m < grid.cells(); ++m)
      for (Eigen::Index i = 0; i < 24; ++i)
        for (Eigen::Index j = 0; j < 24; ++j) {
          const double x = grid.x(at % grid.nx) - grid.x(m % grid.nx) - grid.dx / 2 * rule.x[i],
                       y = grid.y(at / grid.nx) - grid.y(m / grid.nx) - grid.dy / 2 * rule.x[j],
                       w = grid.dx * grid.dy / 4 * rule.w[i] * rule.w[j];
          const auto p = boussinesq(nu, x, y, depth), qx = cerruti(nu, x, y, depth),
                     qy = cerruti(nu, y, x, depth);
          constexpr std::size_t exchanged[6] = {1, 0, 2, 3, 5, 4};
          for (std::size_t c = 0; c < 6; ++c)
            sum[c] += w * (t[0][m] * p[c] + t[1][m] * qx[c] + t[2][m] * qy[exchanged[c]]);
        }
    for (int c = 0; c < 6; ++c)
      claim.error(std::abs(found(at, c) - sum[static_cast<std::size_t>(c)]));
  }
}
