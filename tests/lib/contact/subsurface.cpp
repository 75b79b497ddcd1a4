// Stresses below the surface against closed forms: Hertz's circle and line, pressed and sliding
// (Johnson, Contact Mechanics, 1985).
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/half_space_loads.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::tests;
using Eigen::Index;
using Eigen::VectorXd;
using units::pi;

TEST_CASE("unit: stresses on the axis below Hertz's circle") {
  const double nu = 0.3;
  const Grid grid = square_grid(41, 1.02);
  const VectorXd p = hertz_circle(grid), none = VectorXd::Zero(grid.cells());
  const Subsurface body(grid, nu, p, none, none);
  const Index middle = grid.cells() / 2;
  for (const double z : {0.0, 0.05, 0.2, 0.48, 1.0, 3.0}) {
    INFO("depth " << z);
    const Stress s = body.at(z).row(middle);
    const double zz = -1 / (1 + z * z);
    const double turn = z > 0 ? z * std::atan(1 / z) : 0;
    CHECK(s[2] == Approx(zz).margin(2e-3));
    CHECK(s[0] == Approx(-(1 + nu) * (1 - turn) - 0.5 * zz).margin(4e-3));
    CHECK(s[0] == Approx(s[1]).margin(1e-12));
    CHECK(s.tail<3>().norm() < 1e-12);
  }
  const LargestStress found = largest_stress(grid, nu, p, none, none);
  CHECK(found.von_mises.value == Approx(0.620).margin(2e-3));
  CHECK(found.von_mises.depth == Approx(0.48).margin(0.01));
  CHECK(found.shear.value == Approx(0.310).margin(1e-3));
  CHECK(found.shear.depth == Approx(0.48).margin(0.01));
  CHECK(std::hypot(found.shear.x, found.shear.y) < 1e-12);
}

TEST_CASE(
    "unit: the largest stresses are found from those at each depth, below an ellipse that lies "
    "anyhow") {
  const double nu = 0.28;
  const Grid grid{0.3, -2, 0.1, 0.125, 26, 22};
  VectorXd p(grid.cells()), qx(grid.cells());
  for (Index n = 0; n < grid.cells(); ++n) {
    const Index row = n / grid.nx;
    const double x = grid.x(n % grid.nx) - 1.6, y = grid.y(row) + 0.6, u = 0.8 * x + 0.6 * y,
                 v = 0.8 * y - 0.6 * x;  // axes 1.1 and 0.7
    p[n] = std::sqrt(std::max(0.0, 1 - u * u / 1.21 - v * v / 0.49));
    qx[n] = 0.2 * p[n];
  }
  const VectorXd none = VectorXd::Zero(grid.cells());
  const LargestStress found = largest_stress(grid, nu, p, qx, none);
  REQUIRE(found.depths.size() == 18);
  CHECK(found.depths[0] == 0);
  CHECK(found.depths[17] == Approx(2 * 0.7).epsilon(0.01));
  for (Index k = 2; k < 18; ++k) CHECK(found.depths[k] == Approx(1.2 * found.depths[k - 1]));
  const Subsurface body(grid, nu, p, qx, none);
  VectorXd below = none;
  double most = 0, most_shear = 0;
  Index at = 0, shear_at = 0;
  for (Index k = 0; k < 18; ++k) {
    const Stresses all = body.at(found.depths[k]);
    double mises = 0, shear = 0;
    for (Index c = 0; c < grid.cells(); ++c) {
      const Stress s = all.row(c);
      const double here = von_mises(s), there = largest_shear(s);
      below[c] = std::max(below[c], here);
      mises = std::max(mises, here), shear = std::max(shear, there);
      if (here > most) most = here, at = c;
      if (there > most_shear) most_shear = there, shear_at = c;
    }
    CHECK(found.von_mises_at[k] == mises);
    CHECK(found.shear_at[k] == shear);
  }
  CHECK(found.below == below);
  const auto is_at = [&](const LargestStress::Place& place, Index cell) {
    const Index row = cell / grid.nx;
    return place.x == grid.x(cell % grid.nx) && place.y == grid.y(row);
  };
  CHECK(is_at(found.von_mises, at));
  CHECK(is_at(found.shear, shear_at));
  CHECK(found.von_mises.value == Approx(most).epsilon(0.01));
  CHECK(found.von_mises.value >= most);
  CHECK_THROWS_AS(largest_stress(grid, nu, -p, none, none), railbook::InputError);
  CHECK(largest_stress(grid, nu, none, none, none).below == none);
}

TEST_CASE("unit: stresses below a line contact, in plane strain") {
  const double nu = 0.3, friction = 0.3;
  const Grid grid = line_grid(161, 1.01);
  const VectorXd p = hertz_line(grid), none = VectorXd::Zero(grid.cells());
  const Subsurface pressed(grid, nu, p, none, none);
  for (const double z : {0.1, 0.5, 0.786, 2.0}) {
    INFO("depth " << z);
    const Stress s = pressed.at(z).row(80);
    const double root = std::sqrt(1 + z * z), xx = -((1 + 2 * z * z) / root - 2 * z),
                 zz = -1 / root;
    CHECK(s[0] == Approx(xx).margin(1e-3));
    CHECK(s[1] == Approx(nu * (xx + zz)).margin(1e-3));
    CHECK(s[2] == Approx(zz).margin(1e-3));
  }
  const LargestStress found = largest_stress(grid, nu, p, none, none);
  CHECK(found.shear.value == Approx(0.300).margin(1e-3));
  CHECK(found.shear.depth == Approx(0.786).margin(0.01));
  // Sliding: at the surface -p - 2 mu p0 x/a, pulled behind and pressed ahead.
  const Stresses surface = Subsurface(grid, nu, p, friction * p, none).at(0);
  for (const Index i : {20, 50, 80, 110, 140})
    CHECK(surface(i, 0) == Approx(-p[i] - 2 * friction * grid.x(i)).margin(5e-3));
}

TEST_CASE(
    "unit: sliding of a circle is linear at the surface, and worst there under high friction") {
  const double nu = 0.3;
  const Grid grid = square_grid(41, 1.02);
  const VectorXd p = hertz_circle(grid), none = VectorXd::Zero(grid.cells());
  // Of the traction alone (Hamilton and Goodman 1966).
  const Stresses along = Subsurface(grid, nu, none, p, none).at(0),
                 across = Subsurface(grid, nu, none, none, p).at(0);
  for (const Index i : {8, 14, 20, 27, 33}) {
    const double x = grid.x(i), slope = -(4 + nu) * pi / 8;
    CHECK(along(Index{20} * 41 + i, 0) == Approx(slope * x).margin(0.02));
    CHECK(across(i * 41 + 20, 1) == Approx(slope * x).margin(0.02));
  }
  const auto worst = [&](double friction) {
    return largest_stress(grid, nu, p, friction * p, none).von_mises;
  };
  // It changes at 0.3 for the exact tractions; whole cells meet the peak at the rim late.
  CHECK(worst(0.25).depth > 0.2);
  CHECK(worst(0.4).depth == 0);
  CHECK(worst(0.5).value > worst(0.4).value);
}

// What any stresses below a surface must be: in equilibrium with one another and with the
// tractions, and alike when turned.

namespace {

struct Load {
  Grid grid = square_grid(61, 3.05);
  VectorXd p, qx, qy;
  Load() {
    const auto bump = [](double x, double y) { return std::exp(-x * x - 1.5 * y * y); };
    p = on(grid, bump);
    qx = on(grid, [&](double x, double y) { return 0.4 * (1 + 0.5 * x) * bump(x, y); });
    qy = on(grid, [&](double x, double y) { return 0.2 * bump(x + 0.3, y - 0.2); });
  }
};

// Fourth order from values at -2, -1, 1, 2 steps.
double slope(double a, double b, double c, double d, double step) {
  return (a - 8 * b + 8 * c - d) / (12 * step);
}

}  // namespace

TEST_CASE("property: stresses under any tractions are in equilibrium at every depth") {
  const Load load;
  const Index n = load.grid.nx;
  const double h = load.grid.dx, step = 0.05;
  for (const double nu : {0.0, 0.28, 0.5}) {
    const Subsurface body(load.grid, nu, load.p, load.qx, load.qy);
    for (const double z : {0.3, 1.0}) {
      INFO("nu " << nu << ", depth " << z);
      const Stresses s = body.at(z), up2 = body.at(z - 2 * step), up = body.at(z - step),
                     down = body.at(z + step), down2 = body.at(z + 2 * step);
      double worst = 0;
      for (Index j = 15; j < 46; j += 5)
        for (Index i = 15; i < 46; i += 5) {
          const Index k = j * n + i;
          const auto dx = [&](int c) {
            return slope(s(k - 2, c), s(k - 1, c), s(k + 1, c), s(k + 2, c), h);
          };
          const auto dy = [&](int c) {
            return slope(s(k - 2 * n, c), s(k - n, c), s(k + n, c), s(k + 2 * n, c), h);
          };
          const auto dz = [&](int c) {
            return slope(up2(k, c), up(k, c), down(k, c), down2(k, c), step);
          };
          worst = std::max({worst, std::abs(dx(0) + dy(3) + dz(5)), std::abs(dx(3) + dy(1) + dz(4)),
                            std::abs(dx(5) + dy(4) + dz(2))});
        }
      CHECK(worst < 2e-3);
    }
  }
}

TEST_CASE("property: the surface bears its tractions, and a layer below it the load") {
  const Load load;
  const Subsurface body(load.grid, 0.28, load.p, load.qx, load.qy);
  const Stresses top = body.at(0);
  CHECK((top.col(2) + load.p).cwiseAbs().maxCoeff() < 1e-12);
  CHECK((top.col(5) + load.qx).cwiseAbs().maxCoeff() < 1e-12);
  CHECK((top.col(4) + load.qy).cwiseAbs().maxCoeff() < 1e-12);
  const Stresses layer = body.at(0.2);
  CHECK(-layer.col(2).sum() == Approx(load.p.sum()).epsilon(0.01));
}

TEST_CASE("property: stresses turn with their tractions") {
  const Load load;
  const Index n = load.grid.nx;
  const auto turned = [&](const VectorXd& v) {  // x and y exchanged
    VectorXd out(v.size());
    for (Index k = 0; k < v.size(); ++k) out[(k % n) * n + k / n] = v[k];
    return out;
  };
  const Stresses s = Subsurface(load.grid, 0.28, load.p, load.qx, load.qy).at(0.4);
  const Stresses other =
      Subsurface(load.grid, 0.28, turned(load.p), turned(load.qy), turned(load.qx)).at(0.4);
  constexpr int exchanged[6] = {1, 0, 2, 3, 5, 4};
  for (int c = 0; c < 6; ++c)
    CHECK((turned(s.col(c)) - other.col(exchanged[c])).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("property: the largest stress settles as cells get finer") {
  const auto largest = [](Index n, double friction) {
    const Grid grid = square_grid(n, 1.1);
    const VectorXd p = hertz_circle(grid);
    return largest_stress(grid, 0.28, p, friction * p, VectorXd::Zero(grid.cells()));
  };
  const double fine = largest(80, 0.2).von_mises.value;
  CHECK(largest(32, 0.2).von_mises.value == Approx(fine).epsilon(0.005));
  CHECK(largest(56, 0.2).von_mises.value == Approx(fine).epsilon(0.0025));
}

TEST_CASE("input: stresses below the surface refuse what they cannot mean") {
  const Grid grid = square_grid(5, 1);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(25), none = Eigen::VectorXd::Zero(25);
  CHECK_THROWS_AS(Subsurface(grid, 0.51, one, none, none), InputError);
  CHECK_THROWS_AS(Subsurface(grid, 0.3, one, none, Eigen::VectorXd::Zero(24)), InputError);
  CHECK_THROWS_AS(Subsurface(grid, 0.3, units::nan * one, none, none), InputError);
  CHECK_THROWS_AS(Subsurface(grid, 0.3, one, none, none).at(-1e-9), InputError);
  CHECK_THROWS_AS(largest_stress(grid, 0.3, -one, none, none), InputError);
  CHECK(largest_stress(grid, 0.3, none, none, none).von_mises.value == 0);
}
