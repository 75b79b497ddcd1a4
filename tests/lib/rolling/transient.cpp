// From Cattaneo's shift to Carter's rolling: Kalker's case with CONTACT's numbers, and the steady
// end.
#include <railbook/rolling/transient.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include <railbook/rolling/contact.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/cg_fft_cells.hpp"

using namespace railbook;
using namespace railbook::rolling;
using contact::Grid;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Spheres of distance 0.002963 r^2, G = 1 and nu = 0.28, on cells of 0.25: CONTACT's example
// catt_to_cart.
struct Spheres {
  Grid grid;
  VectorXd pressure;
  RollingCase c{1, 1, 1, 1, 0.28, 0.4013, {}};
  contact::Region region;
  explicit Spheres(Index n = 31) : grid{-3.875, -3.875, 7.75 / double(n), 7.75 / double(n), n, n} {
    const double young = 2 * 1.28, modulus = young / (2 * (1 - 0.28 * 0.28));
    const auto gap =
        contact::sample([](double x, double y) { return 0.002963 * (x * x + y * y); }, grid);
    region = solve_on(grid, gap, 0.07258, modulus, pressure, 1e-10);
  }
  double load() const { return pressure.sum() * grid.dx * grid.dy; }
};

}  // namespace

TEST_CASE("unit: from Cattaneo to Carter as CONTACT goes") {
  const Spheres s;
  CHECK(s.load() == Approx(0.4705).epsilon(1e-3));
  CHECK(s.region.p_max == Approx(0.01834).epsilon(2e-3));
  CHECK(s.region.cells == 621);
  const double fx = 0.657 * s.c.friction * s.load();
  Transient contact(s.grid, s.pressure, s.c);
  const auto stuck = [](const CreepForces& f) { return f.tractions.stick.sum(); };
  const auto shifted = contact.shift_for(fx);
  REQUIRE(shifted.forces.converged);
  CHECK(shifted.forces.fx == Approx(fx).epsilon(1e-5));
  CHECK(shifted.motion == Approx(1.774e-2).epsilon(1e-3));
  CHECK(stuck(shifted.forces) == Approx(305).margin(4));
  // Cattaneo and Mindlin in closed form.
  const double closed = 3 * s.c.friction * s.load() / (16 * 3.5) * 2 * (2 - s.c.poisson) *
                        (1 - std::pow(1 - 0.657, 2.0 / 3));
  CHECK(shifted.motion == Approx(closed).epsilon(5e-3));
  const std::map<int, double> published{{4, 2.050e-3}, {12, 2.968e-3}, {28, 3.085e-3}};
  for (int step = 1; step <= 28; ++step) {
    INFO("step " << step);
    const auto rolled = contact.roll_for(fx);
    REQUIRE(rolled.forces.converged);
    if (published.contains(step)) CHECK(rolled.motion == Approx(published.at(step)).epsilon(2e-3));
    if (step == 28) CHECK(stuck(rolled.forces) == Approx(346).margin(4));
  }
}

TEST_CASE(
    "property: rolling on, a transient contact comes to the steady solution of the same cells") {
  Spheres s(17);
  s.c.creepage = {3e-3, -1e-3, 2e-4};
  const CreepForces steady =
      solve_rolling(s.grid, s.pressure, s.c, {.remedy = false, .estimate = false});
  Transient contact(s.grid, s.pressure, s.c);
  CreepForces rolled;
  for (int step = 0; step < 90; ++step) {
    rolled = contact.roll(s.c.creepage);
    REQUIRE(rolled.converged);
    if (step == 3) CHECK(std::abs(rolled.fx / steady.fx) < 0.9);
  }
  CHECK(rolled.fx == Approx(steady.fx).epsilon(1e-3));
  CHECK(rolled.fy == Approx(steady.fy).epsilon(1e-3));
}

TEST_CASE("property: a shift there and back leaves tractions behind, and a small one is elastic") {
  const Spheres s(17);
  Transient contact(s.grid, s.pressure, s.c);
  const double there = contact.shift(1e-2, 0).fx;
  CHECK(there > 0);
  CHECK(contact.shift(0, 0).fx == Approx(there).epsilon(1e-6));  // nothing moves: nothing changes
  // What has slid there is missing on the way back.
  CHECK(contact.shift(-1e-2, 0).fx < -0.01 * there);
  Transient other(s.grid, s.pressure, s.c);
  const double small = other.shift(1e-5, 0).fx;
  CHECK(std::abs(other.shift(-1e-5, 0).fx) < 0.01 * small);
}

TEST_CASE("input: transient rolling refuses what it cannot carry") {
  const Spheres s(17);
  RollingCase smooth = s.c;
  smooth.friction = 0;
  CHECK_THROWS_AS(Transient(s.grid, s.pressure, smooth), InputError);
  const VectorXd full = VectorXd::Ones(s.grid.cells());
  CHECK_THROWS_AS(Transient(s.grid, full, s.c), InputError);
  Transient contact(s.grid, s.pressure, s.c);
  CHECK_THROWS_AS(contact.shift_for(s.c.friction * s.load()), InputError);
}
