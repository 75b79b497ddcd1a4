// Rollers of unlike materials: Bentall and Johnson (1967), with CONTACT's numbers (its example
// bentall).
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/roots.hpp>
#include <railbook/rolling/material_pair.hpp>
#include <railbook/rolling/parts.hpp>
#include <railbook/rolling/unlike_materials.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::rolling;

namespace {

// Aluminium on steel, radii 50, half width 0.1 in 200 strips; N and mm.
struct Rollers {
  contact::Grid grid{-0.1, -1e3, 1e-3, 2e3, 200, 1};
  Eigen::VectorXd pressure{200};
  MaterialPair pair = combine({2 * 23000 * 1.31, 0.31}, {2 * 82000 * 1.28, 0.28});
  RollingCase c{1, 1, 1, pair.shear_modulus, pair.poisson, 0.3, {}};
  Rollers() {
    const double top = 2 * 16.2019 / (units::pi * 0.1);
    for (Eigen::Index i = 0; i < 200; ++i)
      pressure[i] = top * std::sqrt(1 - std::pow(grid.x(i) / 0.1, 2));
  }
  CreepForces at(double creepage, double friction) const {
    RollingCase now = c;
    now.creepage.longitudinal = creepage, now.friction = friction;
    // CONTACT's cells just fill the contact.
    return solve_rolling_unlike(grid, pressure, now, {.remedy = false, .estimate = false},
                                pair.dissimilarity);
  }
  double creepage_for(double share, double friction) const {
    const double bound = friction * pressure.sum() * grid.dx * grid.dy;
    const auto off = [&](double x) { return at(x, friction).fx / bound - share; };
    return num::find_root(off, -1e-3, 0, 1e-5).x;
  }
};

}  // namespace

TEST_CASE("unit: rollers of aluminium and steel creep as Bentall and Johnson, and CONTACT, say") {
  const Rollers r;
  CHECK(r.pair.dissimilarity == Approx(0.1002).epsilon(1e-3));
  // Free rolling without friction to speak of: half the load is on either side of the place that
  // does not slip.
  const double kappa = 2 * r.pair.dissimilarity / (1 - r.pair.poisson);
  CHECK(-r.creepage_for(0, 1e-4) == Approx(0.457 * kappa * 0.1 / 25).epsilon(0.005));
  // CONTACT also feeds the tractions back into the pressure, which grows by half a per cent.
  const double free = r.creepage_for(0, 0.05), driving = r.creepage_for(0.75, 0.05);
  CHECK(-free == Approx(4.294e-4).epsilon(0.01));
  CHECK(-driving == Approx(2.108e-4).epsilon(0.01));
  CHECK(r.at(free, 0.05).tractions.stick.sum() == Approx(125).margin(3));
  CHECK(r.at(driving, 0.05).tractions.stick.sum() == Approx(36).margin(3));
}

TEST_CASE("property: which of two unlike bodies is on top changes signs only") {
  const Rollers r;
  const auto forces = [&](double creepage, double k) {
    RollingCase c = r.c;
    c.friction = 0.05, c.creepage.longitudinal = creepage;
    return solve_rolling_unlike(r.grid, r.pressure, c, {.estimate = false}, k);
  };
  CHECK(forces(1e-4, 0.1).fx == Approx(-forces(-1e-4, -0.1).fx).epsilon(1e-6));
  CHECK(forces(1e-4, 0).fx < forces(1e-4, 0.1).fx);
  CHECK_THROWS_AS(forces(0, 0.6), InputError);
}

TEST_CASE("unit: under a long strip pressure p drives a slip of 2 K p, and none ahead of it") {
  RollingMesh mesh;
  mesh.along = 20;
  mesh.y = Eigen::VectorXd::Zero(1), mesh.dy = Eigen::VectorXd::Constant(1, 1e4);
  mesh.x0 = Eigen::VectorXd::Constant(1, -1.9), mesh.dx = Eigen::VectorXd::Constant(1, 0.2);
  Eigen::VectorXd p = Eigen::VectorXd::Zero(20);
  p.head(10).setConstant(3);
  const Eigen::VectorXd slip = driven_slip(mesh, p, 0.1);
  REQUIRE(slip.size() == 40);
  for (Eigen::Index i = 0; i < 19; ++i)
    CHECK(slip[i] == Approx(i < 9 ? 0.6 : i == 9 ? 0.3 : 0).margin(1e-3));
  CHECK(slip.tail(20).cwiseAbs().maxCoeff() < 1e-9);
}
