// What theories, tables and grids of rolling contact are refused for, each limit from both sides.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/force_table.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/rolling/kalker_table.hpp>
#include <railbook/rolling/smooth_force.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/rolling/transient.hpp>
#include <railbook/rolling/unlike_materials.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::rolling;

namespace {

template <class Make>
bool refused(Make&& make) {
  try {
    make();
  } catch (const InputError&) {
    return true;
  }
  return false;
}

const RollingCase good{1e-3, 1e-3, 4000, 80e9, 0.25, 0.3, {1e-3, 0, 0}};

ShareFunction nothing(double) {
  return [](const Creepage&) { return ForceShares{}; };
}

}  // namespace

TEST_CASE("input: a case of rolling is refused just beyond the range of each of its numbers") {
  const auto of = [](auto&& change) {
    RollingCase c = good;
    change(c);
    return refused([&] { reduced_creepage(c); });
  };
  for (double RollingCase::*number : {&RollingCase::a, &RollingCase::b, &RollingCase::load,
                                      &RollingCase::shear_modulus, &RollingCase::friction})
    for (const double value : {-1e-12, 0.0, 1e-12})
      CHECK(of([&](RollingCase& c) { c.*number = value; }) ==
            (value < 0 || (value == 0 && number != &RollingCase::friction)));
  for (const double poisson : {-1e-9, 0.0, 0.5, 0.5 + 1e-9})
    CHECK(of([&](RollingCase& c) { c.poisson = poisson; }) == (poisson < 0 || poisson > 0.5));
  for (double Creepage::*part : {&Creepage::longitudinal, &Creepage::lateral, &Creepage::spin})
    for (const double value : {units::nan, units::infinity, -units::infinity, -1e9, 1e9})
      CHECK(of([&](RollingCase& c) { c.creepage.*part = value; }) == !std::isfinite(value));
}

TEST_CASE("input: coefficients, cells and contacts are refused just beyond their ranges") {
  for (const double share : {0.999, 1.001}) {
    CHECK(refused([&] { kalker_coefficients(1e4 * share, 0.3, 4); }) == (share > 1));
    CHECK(refused([&] { kalker_coefficients(1e-4 / share, 0.3, 4); }) == (share > 1));
    CHECK(refused([&] { kalker_coefficients(1, 0.5 * share, 4); }) == (share > 1));
  }
  for (const int degree : {3, 4, 41})
    CHECK(refused([&] { kalker_coefficients(1, 0.3, degree); }) == (degree != 4));
  const auto k = kalker_table(1, 0.25);
  for (const int cells : {0, 1, 4096, 4097}) {
    const bool out = cells < 1 || cells > 4096;
    CHECK(refused([&] { fastsim_grid(good, k, {.along = cells, .strips = 1}); }) == out);
    CHECK(refused([&] { fastsim_grid(good, k, {.along = 1, .strips = cells}); }) == out);
    if (cells == 4096) continue;
    CHECK_THROWS_WITH(EllipseRolling(1, 0.25, {.along = 5000, .rows = cells}),
                      Catch::Contains("cells along"));
    CHECK(refused([&] { EllipseRolling(1, 0.25, {.along = cells, .rows = 1}); }) == out);
    CHECK(refused([&] { EllipseRolling(1, 0.25, {.along = 1, .rows = cells}); }) == out);
  }
  for (const double poisson : {-1e-9, 0.0, 0.5, 0.5 + 1e-9})
    CHECK(refused([&] { EllipseRolling(1, poisson, {.along = 4, .rows = 4}); }) ==
          (poisson < 0 || poisson > 0.5));
  const EllipseRolling circle(1, 0.25, {.along = 4, .rows = 4});
  for (const double off : {-2e-9, -0.5e-9, 0.5e-9, 2e-9}) {
    RollingCase c = good;
    c.a *= 1 + off;
    CHECK(refused([&] { circle.solve(c); }) == (std::abs(off) > 1e-9));
  }
}

TEST_CASE("input: a table's axes are refused just beyond their ranges") {
  const auto of = [](auto&& change) {
    ForceTableAxes axes{.ratio_from = 1, .ratio_to = 2, .ratios = 2};
    axes.longitudinal = axes.lateral = 2, axes.spin = 3;
    change(axes);
    return refused([&] { ForceTable(axes, nothing); });
  };
  using Axes = ForceTableAxes;
  CHECK_FALSE(of([](Axes&) {}));
  for (const double from : {-1.0, 0.0, 1e-9})
    CHECK(of([&](Axes& a) { a.ratio_from = a.ratio_to = from; }) == (from <= 0));
  for (const double to : {0.999, 1.0, 999.0, 1001.0})
    CHECK(of([&](Axes& a) { a.ratio_to = to; }) == (to < 1 || to > 1000));
  for (const int ratios : {0, 1, 2, 1000, 1001}) {
    CHECK(of([&](Axes& a) { a.ratios = ratios; }) == (ratios < 2 || ratios > 1000));
    CHECK(of([&](Axes& a) { a.ratio_to = 1, a.ratios = ratios; }) == (ratios < 1 || ratios > 1000));
  }
  for (double Axes::*reach : {&Axes::reach, &Axes::spin_reach})
    for (const double share : {0.999, 1.001}) {
      CHECK(of([&](Axes& a) { a.*reach = share * 1e6; }) == (share > 1));
      CHECK(of([&](Axes& a) { a.*reach = 1e-3 / share; }) == (share > 1));
    }
  for (int Axes::*nodes : {&Axes::longitudinal, &Axes::lateral})
    for (const int n : {1, 2, 1000, 1001})
      CHECK(of([&](Axes& a) { a.*nodes = n; }) == (n < 2 || n > 1000));
  for (const int n : {1, 2, 3, 4, 1001, 1002, 1003})
    CHECK(of([&](Axes& a) { a.spin = n; }) == (n < 3 || n > 1001 || n % 2 == 0));
  CHECK(of([](Axes& a) { a.longitudinal = a.lateral = 1000, a.ratios = 4; }));  // 12 million
  const ForceTable table({.ratio_from = 1, .ratio_to = 1, .ratios = 1}, nothing);
  for (const int points : {0, 1}) CHECK(refused([&] { table.error(nothing, points); }) == !points);
  CHECK(refused([&] { table.error(nothing, 10'000'001); }));
  const auto linear = [](const Creepage& r) { return ForceShares{1e-3 * r.longitudinal, 0, 0}; };
  for (const int nodes : {3, 4, 101})
    CHECK(refused([&] { SmoothForce(linear, {1, 1, 1, 1}, nodes); }) == (nodes != 4));
}

namespace {

// Even pressures in the middle of an n by n grid, an empty cell around them.
struct Block {
  contact::Grid grid;
  Eigen::VectorXd pressure;
  explicit Block(Eigen::Index n) : grid{-1e-3, -1e-3, 2e-3 / double(n), 2e-3 / double(n), n, n} {
    pressure.setZero(n * n);
    for (Eigen::Index j = 1; j + 1 < n; ++j)
      for (Eigen::Index i = 1; i + 1 < n; ++i) pressure[j * n + i] = 1e9;
  }
};

}  // namespace

TEST_CASE(
    "input: a pressure's rolling is refused just beyond the ranges of dissimilarity and force") {
  const Block block(6);
  for (const double size : {0.499, 0.501})
    for (const double sign : {-1.0, 1.0})
      CHECK(refused([&] {
              solve_rolling_unlike(block.grid, block.pressure, good, {}, sign * size);
            }) == (size > 0.5));
  RollingCase smooth = good;
  smooth.friction = 0;
  for (const double k : {0.0, 0.1}) {
    const CreepForces none = solve_rolling_unlike(block.grid, block.pressure, smooth, {}, k);
    CHECK(none.converged);
    CHECK(none.reason.starts_with("no friction"));
    CHECK((none.fx == 0 && none.fy == 0 && none.mz == 0 && none.stick_share == 0));
  }
  const double bound = good.friction * block.pressure.sum() * block.grid.dx * block.grid.dy;
  for (const double sign : {-1.0, 1.0})
    for (const double share : {0.998, 0.9995}) {
      Transient contact(block.grid, block.pressure, good);
      Transient::Step found;
      REQUIRE(refused([&] { found = contact.shift_for(sign * share * bound); }) == (share > 0.999));
      if (share > 0.999) continue;
      CHECK(found.forces.converged);
      CHECK(found.forces.fx == Approx(sign * share * bound).epsilon(2e-6));
      CHECK(found.motion * sign > 0);
      // Of the same force again there is nothing left to move.
      CHECK(std::abs(contact.shift_for(sign * share * bound).motion) < 1e-3 * found.motion * sign);
    }
}

TEST_CASE("unit: the error of a force on given pressures is known from four cells along on") {
  for (const Eigen::Index n : {3, 4, 8}) {
    const Block block(n);
    for (const bool estimate : {false, true}) {
      const auto f = solve_rolling(block.grid, block.pressure, good, {.estimate = estimate});
      CAPTURE(n, estimate);
      CHECK(f.converged);
      CHECK(std::isfinite(f.error) == (estimate && n >= 4));
      CHECK(std::isfinite(f.mz_error) == (estimate && n >= 4));
    }
  }
}

TEST_CASE(
    "unit: a force prescribed is met where friction bears it, and said to be too much where not") {
  const EllipseRolling circle(1, 0.25, {.along = 8, .rows = 8});
  const double bound = good.friction * good.load;
  for (const double share : {0.3, 0.99, 1.0, 1.01})
    for (const double turn : {0.0, 0.6, 2.0, 4.0}) {
      const double fx = share * bound * std::cos(turn), fy = share * bound * std::sin(turn);
      const auto found = solve_for_forces(circle, good, fx, fy);
      CAPTURE(share, turn);
      CHECK(found.forces.converged == (share < 1));
      if (share > 1 || (share == 1 && turn == 0))
        CHECK(found.forces.reason.starts_with("the prescribed forces are not below mu N"));
      if (share >= 1) continue;
      CHECK(found.forces.fx == Approx(fx).margin(1e-7 * bound));
      CHECK(found.forces.fy == Approx(fy).margin(1e-7 * bound));
      // The case it comes with has just those forces.
      const CreepForces again = circle.solve(found.rolling);
      CHECK(again.fx == Approx(fx).margin(1e-6 * bound));
      CHECK(again.fy == Approx(fy).margin(1e-6 * bound));
    }
}

TEST_CASE(
    "unit: a solver by name is the law of that name, and the full theory on half as many rows") {
  const double ratio = 1.3;
  const RollingCase c = with_reduced_creepage(normalised_case(ratio, 0.28), {0.7, -0.4, 0});
  const auto same = [](const CreepForces& a, const CreepForces& b) {
    CHECK(a.fx == b.fx);
    CHECK(a.fy == b.fy);
    CHECK(a.mz == b.mz);
  };
  for (const Theory theory : {Theory::linear, Theory::vermeulen_johnson, Theory::fastsim,
                              Theory::shen_hedrick_elkins, Theory::fastrip, Theory::polach}) {
    const std::string called{name(theory)};
    INFO(called);
    same(solver(called, ratio, 0.28, 0)(c), creep_forces(theory, c));
    same(solver(called, ratio, 0.28, 0, true)(c),
         creep_forces(theory, c, kalker_coefficients(ratio, 0.28)));
  }
  for (const long cells : {7L, 8L})
    same(solver("full", ratio, 0.28, cells)(c),
         EllipseRolling(ratio, 0.28, {.along = cells, .rows = 4}).solve(c));
  CHECK_THROWS_WITH(solver("none", 1, 0.3, 8), Catch::Contains("no theory named none"));
}
