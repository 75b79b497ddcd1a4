#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/detail/extrapolation.hpp>
#include <railbook/contact/detail/grid_fit.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::contact;

namespace {

// A sphere of relative radius 1 at approach 1, in units where E* is 1: a = 1, F = 4/3, p_0 = 2/pi
// (Johnson, ch. 4).
constexpr double force = 4.0 / 3, peak = 2 / units::pi;

Gap sphere() {
  return [](double x, double y) { return 0.5 * (x * x + y * y); };
}

CgFft solve(Eigen::Index n, bool remedy = true) {
  CgFftOptions options;
  options.nx = options.ny = n;
  options.remedy = remedy;
  return solve_cg_fft(sphere(), 1, 1, options);
}

// Two spheres beside each other; the second, of radius r, ends `lower` above the first.
Gap two_spheres(double r, double lower) {
  return [=](double x, double y) {
    const double u = x - 3;
    return std::min((x * x + y * y) / 2, (u * u + y * y) / (2 * r) + lower);
  };
}

}  // namespace

TEST_CASE("unit: preconditioned iterations do not grow with the grid") {
  const int coarse = solve(64).levels.back().iterations, fine = solve(256).levels.back().iterations;
  CHECK(fine <= coarse + 6);
  CHECK(fine < 25);
}

TEST_CASE("unit: a limit from one grid is its value, whose whole size is the error") {
  for (const double value : {3.0, -5.0}) {
    const Extrapolated one = extrapolate({0.1}, {value}, 2);
    CHECK(one.value == value);
    CHECK(one.error == std::abs(value));
    // From two it is that of the line through both, and the error what was taken off.
    const Extrapolated two = extrapolate({0.2, 0.1}, {value * 1.4, value * 1.1}, 2);
    CHECK(two.value == Approx(value));
    CHECK(two.error == Approx(0.1 * std::abs(value)));
    // From three on that line: 0.3 of it.
    const Extrapolated three =
        extrapolate({0.3, 0.2, 0.1}, {value * 1.9, value * 1.4, value * 1.1}, 2);
    CHECK(three.value == Approx(value));
    CHECK(three.error == Approx(0.03 * std::abs(value)));
  }
}

TEST_CASE(
    "unit: a contact between the cells of coarse grids is found by finer ones, or reported to be "
    "narrow") {
  int missed = 0, found = 0;
  for (const double ratio : {1e2, 1e3, 1e4, 1e5, 1e6})
    for (const double angle : {0.5, units::pi / 4, 1.1})
      for (const Eigen::Index n : {16, 40, 64}) {
        const Gap gap = quadratic_gap({1, ratio, angle});
        CgFftOptions options;
        options.nx = options.ny = n;
        const CgFft result = solve_cg_fft(gap, 1, 1, options);
        const double exact = hertz_from_approach({1, ratio, 0}, 1, 1).force;
        CAPTURE(ratio, angle, n, result.contact.force, exact, result.contact.reason);
        for (const CgFftLevel& level : result.levels) {
          CHECK(level.grid.dx > 0);
          CHECK(level.grid.dy > 0);
          missed += level.region.cells == 0 ? 1 : 0;
        }
        const double off = std::abs(result.contact.force / exact - 1);
        CHECK(off <= result.contact.force_error);
        if (std::isinf(result.contact.force_error))
          CHECK(result.contact.reason.starts_with("under-resolved"));
        else
          ++found;
      }
  CHECK(missed > 0);
  CHECK(found > 0);
}

TEST_CASE("unit: a load is met by a few solves, of smooth bodies and of a flat one") {
  for (const bool flat : {false, true})
    for (const double load : {1e-6, 1.0, 1e4}) {
      int solves = 0;
      CgFftOptions options;
      options.nx = options.ny = 64;
      const Gap gap = flat ? rounded_punch_gap({1, 0}) : rounded_punch_gap({0, 1});
      options.search = [&](double approach) {
        ++solves;
        return interpenetration_box(gap, approach);
      };
      const NormalContact c = solve_cg_fft_load(gap, load, 1, options).contact;
      CAPTURE(flat, load, solves);
      CHECK(c.converged);
      CHECK(c.force == Approx(load).epsilon(1e-7));
      CHECK(c.approach ==
            Approx(flat ? load / 2 : std::pow(0.75 * load, 2.0 / 3)).epsilon(flat ? 5e-3 : 1e-4));
      CHECK(solves <= 8);
    }
}

TEST_CASE(
    "unit: a contact is under-resolved below five cells, of patches with a hundredth of its "
    "force") {
  const auto holds = [](const Gap& gap, const CgFftOptions& options) {
    const CgFft result = solve_cg_fft(gap, 1, 1, options);
    const Region& finest = result.levels.back().region;
    double narrowest = 1e9;
    for (const PressurePatch& patch : finest.patches)
      if (patch.force > 0.01 * finest.force) narrowest = std::min(narrowest, patch.cells_across);
    CAPTURE(narrowest, finest.patches.size(), finest.patches.back().force / finest.force);
    CHECK(std::isinf(result.contact.force_error) == (narrowest < 5));
    CHECK(std::isinf(result.contact.p_max_error) == (narrowest < 5));
    CHECK(result.contact.reason.starts_with("under-resolved: the contact is") == (narrowest < 5));
    return narrowest >= 5;
  };
  int resolved = 0, narrow = 0;
  for (double ratio = 12; ratio < 100; ratio *= 1.08) {  // turned against the grid
    CgFftOptions options;
    options.nx = options.ny = 32;
    (holds(quadratic_gap({1, ratio, units::pi / 4}), options) ? resolved : narrow) += 1;
  }
  CHECK(resolved > 3);
  CHECK(narrow > 3);
  resolved = narrow = 0;
  for (double lower = 0.6; lower < 0.96; lower += 0.03) {  // a small sphere beside a large one
    CgFftOptions options;
    options.nx = 90, options.ny = 40;
    options.search = [](double) { return Box{-1.5, 4.5, -1.5, 1.5}; };
    (holds(two_spheres(0.05, lower), options) ? resolved : narrow) += 1;
  }
  CHECK(resolved > 1);
  CHECK(narrow > 1);
}

TEST_CASE(
    "unit: what edges add to the error falls with the cells across, to the power 2.5 or 1.7") {
  // Without what the ladder of grids says.
  const auto of_edges = [](const Gap& gap, Eigen::Index n, double order) {
    CgFftOptions options;
    options.nx = options.ny = n;
    const CgFft result = solve_cg_fft(gap, 1, 1, options);
    const Region& finest = result.levels.back().region;
    std::vector<double> h, forces;
    for (const CgFftLevel& level : result.levels) {
      h.push_back(std::hypot(level.grid.dx / (finest.ends.x_max - finest.ends.x_min),
                             level.grid.dy / (finest.ends.y_max - finest.ends.y_min)));
      forces.push_back(level.region.force);
    }
    const Extrapolated f = extrapolate(h, forces, order);
    const PressurePatch& patch = finest.patches.front();
    return std::tuple{result.contact.force_error - f.error / f.value, patch.cells_across,
                      std::max(1.0, patch.edge_intensity)};
  };
  for (const bool sharp : {false, true}) {
    const Gap gap = sharp ? rounded_punch_gap({1, 0}) : sphere();
    const auto [coarse, few, strong] = of_edges(gap, 48, sharp ? 1 : 2);
    const auto [fine, many, weak] = of_edges(gap, 128, sharp ? 1 : 2);
    CHECK(many > 2 * few);
    CHECK(coarse > 0);
    const double intensity = sharp ? 1 : strong / weak;
    CHECK(coarse / fine ==
          Approx(intensity * std::pow(many / few, sharp ? 1.7 : 2.5)).epsilon(1e-6));
  }
}

TEST_CASE("a normal contact of 512 x 512 cells takes some fifteen pairs of transforms to 1e-6") {
  CgFftOptions options;
  options.nx = options.ny = 512;
  options.cg.tolerance = 1e-6;
  for (const double across : {1.0, 10.0}) {
    const CgFft found = solve_cg_fft(quadratic_gap({1.0, across, 0.0}), 1e-4, 1.1e11, options);
    CHECK(found.contact.converged);
    CHECK(found.levels.back().residual <= 1e-6);
    CHECK(found.transform_pairs() < 15.5);
  }
}

TEST_CASE("input: bad arguments of the grid solver are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const Gap bowl = [](double x, double y) { return x * x + y * y; };
  const Gap hole = [&](double x, double y) { return x > 0.1 && y > 0.1 ? nan : x * x + y * y; };
  const Gap all_nan = [&](double, double) { return nan; };
  const Gap plane = [](double, double) { return 0.0; };
  const Gap trough = [](double x, double) { return x * x; };
  CHECK_THROWS_AS(solve_cg_fft(bowl, nan, 1), InputError);
  CHECK_THROWS_AS(solve_cg_fft(bowl, inf, 1), InputError);
  CHECK_THROWS_AS(solve_cg_fft(bowl, 1, 0), InputError);
  CHECK_THROWS_AS(solve_cg_fft(bowl, 1, -1), InputError);
  CHECK_THROWS_AS(solve_cg_fft(hole, 1, 1), InputError);
  CHECK_THROWS_AS(solve_cg_fft(all_nan, 1, 1), InputError);
  CHECK_THROWS_WITH(solve_cg_fft(plane, 1, 1), Catch::Contains("do not separate"));
  CHECK_THROWS_WITH(solve_cg_fft(trough, 1, 1), Catch::Contains("do not separate"));
  CHECK_THROWS_AS(solve_cg_fft_load(bowl, 0, 1), InputError);
  CHECK_THROWS_AS(solve_cg_fft_load(bowl, -3, 1), InputError);
  CgFftOptions options;
  options.nx = 0;
  CHECK_THROWS_AS(solve_cg_fft(bowl, 1, 1, options), InputError);
  options.nx = options.ny = 60000;
  CHECK_THROWS_WITH(solve_cg_fft(bowl, 1, 1, options), Catch::Contains("GB"));
}

TEST_CASE("input: samples of a gap have no NaN and no minus infinity") {
  const Grid grid{0, 0, 1, 1, 4, 4};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()})
    CHECK_THROWS_AS(sample([=](double x, double) { return x > 3 ? bad : 1; }, grid), InputError);
}

TEST_CASE("input: too few iterations are reported") {
  const Gap bowl = [](double x, double y) { return x * x + y * y; };
  CgFftOptions options;
  options.cg.most_iterations = 2;
  const NormalContact contact = solve_cg_fft(bowl, 1, 1, options).contact;
  CHECK_FALSE(contact.converged);
  CHECK(contact.reason.find("conjugate gradients") != std::string::npos);
}
