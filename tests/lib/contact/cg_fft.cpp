#include <railbook/contact/cg_fft.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <tuple>
#include <vector>

#include <railbook/contact/detail/extrapolation.hpp>
#include <railbook/contact/detail/grid_fit.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/num/random_stream.hpp>
#include <railbook/units/constants.hpp>

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

}  // namespace

TEST_CASE("unit: displacements of one loaded cell are those of the rectangle integral") {
  const Grid grid{0, 0, 0.5, 2, 5, 3};
  Convolution a(grid, 1 / units::pi);  // so that k = 1
  Eigen::VectorXd p = Eigen::VectorXd::Zero(15), u(15);
  p[1 * 5 + 2] = 1;
  a.apply(p, u);
  // At its own centre: 4 (X asinh(Y/X) + Y asinh(X/Y)) with half sides X, Y.
  const double own = 4 * (0.25 * std::asinh(4.0) + std::asinh(0.25));
  CHECK(u[7] == Approx(own).epsilon(1e-13));
  CHECK(a.self() == Approx(own).epsilon(1e-13));
  // Two cells off, against the midpoint rule with 400 x 1600 points.
  double sum = 0;
  for (int i = 0; i < 400; ++i)
    for (int j = 0; j < 1600; ++j)
      sum += 1 / std::hypot(1 - 0.25 + 0.5 * (i + 0.5) / 400, 2 - 1 + 2 * (j + 0.5) / 1600);
  CHECK(u[2 * 5 + 4] == Approx(sum / 640000).epsilon(1e-6));
  CHECK(u[2 * 5 + 4] == Approx(u[0]).epsilon(1e-12));  // symmetric
}

TEST_CASE("unit: a sphere on a plane to the claimed error") {
  for (const Eigen::Index n : {40, 64, 90, 128}) {
    const NormalContact contact = solve(n).contact;
    INFO(n);
    CHECK(contact.converged);
    CHECK(std::abs(contact.force / force - 1) < contact.force_error);
    CHECK(std::abs(contact.p_max / peak - 1) < contact.p_max_error);
  }
  const NormalContact contact = solve(128).contact;
  CHECK(contact.force == Approx(force).epsilon(5e-6));
  CHECK(contact.p_max == Approx(peak).epsilon(5e-6));
  CHECK(contact.x_max == Approx(1).margin(1.5e-3));
  CHECK(contact.y_min == Approx(-1).margin(1.5e-3));
  CHECK(contact.area == Approx(units::pi).epsilon(1e-3));
  CHECK(contact.force_error < 5e-5);
}

TEST_CASE("unit: the force of a single grid is second order, the extrapolated one better") {
  const double coarse = solve(45, false).contact.force / force - 1;
  const double fine = solve(180, false).contact.force / force - 1;
  const double order = std::log(coarse / fine) / std::log(4.0);
  CHECK(order > 1.7);
  CHECK(order < 2.5);
  CHECK(std::abs(solve(180).contact.force / force - 1) < 0.3 * fine);
}

TEST_CASE("unit: preconditioned iterations do not grow with the grid") {
  const int coarse = solve(64).levels.back().iterations, fine = solve(256).levels.back().iterations;
  CHECK(fine <= coarse + 6);
  CHECK(fine < 25);
}

TEST_CASE("unit: extrapolation is exact for its model") {
  const Extrapolated v = extrapolate({4, 2, 1}, {3 + 16 * 0.1, 3 + 4 * 0.1, 3.1}, 2);
  CHECK(v.value == Approx(3).epsilon(1e-14));
  CHECK(v.error == Approx(0.03).epsilon(1e-9));
  CHECK(extrapolate({1}, {7}, 2).error == 7);
}

TEST_CASE("unit: a fitted axis has the phase asked for at both ends, and its edge") {
  const Axis axis = fit_axis(-1, 3, 40, 0.9, {});
  const double low = (-1 - axis.start) / axis.step, high = (3 - axis.start) / axis.step;
  CHECK(high - std::floor(high) == Approx(0.9));
  CHECK(std::ceil(low) - low == Approx(0.9));
  CHECK(low > 2);
  CHECK(high < 38);
  const Axis edged = fit_axis(-1, 3, 40, 0.9, 0.5);
  const double cells = (0.5 - edged.start) / edged.step;
  CHECK(cells == Approx(std::round(cells)).epsilon(1e-12));
  CHECK(edged.start < -1);
  CHECK(edged.start + 40 * edged.step > 3);
}

TEST_CASE(
    "unit: a covering axis reaches both ends in cells little larger than the least, with its "
    "edge") {
  num::RandomStream draw(1);
  for (int k = 0; k < 1000; ++k) {
    const double low = draw(-5, 5), length = draw.decades(1e-3, 10), high = low + length;
    const Eigen::Index n = 16 + k % 100;
    const double edge = low + draw(0.2, 0.8) * length;
    const Axis axis = cover_axis(low, high, n, edge);
    const double cells = (edge - axis.start) / axis.step;
    REQUIRE(axis.cells == n);
    REQUIRE(cells == Approx(std::round(cells)).epsilon(1e-9));
    REQUIRE(axis.start <= low + 1e-12);
    REQUIRE(axis.start + static_cast<double>(n) * axis.step >= high - 1e-12);
    REQUIRE(axis.step <= 1.2 * length / static_cast<double>(n));
  }
}

TEST_CASE("unit: the intensity of the edge is that of the pressures, over Hertz's") {
  const Grid grid{-1.5, -1.5, 0.025, 0.025, 120, 120};
  const auto intensity = [&](auto&& square) {
    Eigen::VectorXd p(grid.cells());
    for (Eigen::Index j = 0; j < grid.ny; ++j)
      for (Eigen::Index i = 0; i < grid.nx; ++i)
        p[j * grid.nx + i] = std::sqrt(std::max(0.0, square(grid.x(i), grid.y(j))));
    return describe(grid, p, Eigen::VectorXd::Zero(p.size())).patches[0].edge_intensity;
  };
  CHECK(intensity([](double x, double y) {
          const double u = x + y, v = x - y;  // an ellipse of axes 1 and 0.4 across the cells
          return 7 * (1 - u * u / 2 - v * v / 0.32);
        }) == Approx(1).epsilon(0.04));
  // Even but for an edge of width w, where p^2 falls linearly: K = 1/sqrt(w), and the mean is 1 -
  // w/3.
  for (const double w : {0.2, 0.4, 0.8})
    CHECK(intensity([w](double x, double y) {
            const auto ramp = [w](double t) { return std::clamp((1 - std::abs(t)) / w, 0.0, 1.0); };
            return ramp(x) * ramp(y);
          }) == Approx(units::pi / (4 * std::sqrt(2 * w) * (1 - w / 3))).epsilon(0.01));
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

namespace {

// Two spheres beside each other; the second, of radius r, ends `lower` above the first.
Gap two_spheres(double r, double lower) {
  return [=](double x, double y) {
    const double u = x - 3;
    return std::min((x * x + y * y) / 2, (u * u + y * y) / (2 * r) + lower);
  };
}

// What p_max_error holds of the peak's drop between cells, as a square: the rest is of the ladder,
// and of the edges as in force_error.
double drop_in_error(const CgFft& result) {
  const Region& finest = result.levels.back().region;
  std::vector<double> h, forces, peaks;
  for (const CgFftLevel& level : result.levels) {
    h.push_back(std::hypot(level.grid.dx / (finest.ends.x_max - finest.ends.x_min),
                           level.grid.dy / (finest.ends.y_max - finest.ends.y_min)));
    forces.push_back(level.region.force), peaks.push_back(level.region.p_max);
  }
  const Extrapolated f = extrapolate(h, forces, 2), p = extrapolate(h, peaks, 2);
  return result.contact.p_max_error - p.error / p.value -
         (result.contact.force_error - f.error / f.value);
}

}  // namespace

TEST_CASE("unit: a peak's error has the largest drop of the peaks higher than half the highest") {
  // The smaller sphere's peak falls faster from cell to cell; at the second height it is 0.501 of
  // the other.
  for (const auto& [lower, counts] :
       {std::pair{0.70, true}, std::pair{0.783, true}, std::pair{0.785, false}}) {
    CgFftOptions options;
    options.nx = 150, options.ny = 90;
    options.search = [](double) { return Box{-1.5, 4.5, -1.5, 1.5}; };
    const CgFft result = solve_cg_fft(two_spheres(0.3, lower), 1, 1, options);
    const Region& finest = result.levels.back().region;
    REQUIRE(finest.patches.size() == 2);
    REQUIRE(std::isfinite(result.contact.p_max_error));
    double drop = 0, highest = 0;
    for (const PressurePatch& patch : finest.patches) highest = std::max(highest, patch.p_max);
    int higher = 0;
    for (const PressurePatch& patch : finest.patches) {
      if (2 * patch.p_max <= highest) continue;
      ++higher;
      drop = std::max(drop, patch.peak_drop);
    }
    CHECK((higher == 2) == counts);
    CHECK(drop_in_error(result) == Approx(4 * drop * drop).epsilon(1e-6));
  }
}

TEST_CASE("unit: each grid from 16 cells on fits the next one to its region") {
  for (const Eigen::Index n : {32, 34, 64}) {  // ladders from 16, 17 and 16 cells
    CgFftOptions options;
    options.nx = options.ny = n;
    const auto levels = solve_cg_fft(quadratic_gap({0.5, 1.7, 0.3}), 1, 1, options).levels;
    REQUIRE(levels.size() == (n == 64 ? 5 : 3));
    CHECK(levels[0].grid.nx == (n == 34 ? 17 : 16));
    for (std::size_t k = 1; k < levels.size(); ++k) {
      const Box& seen = levels[k - 1].region.ends;
      const Grid& next = levels[k].grid;
      // Two empty cells beyond either end, and of the outermost ones nine or four tenths in
      // contact.
      CHECK(next.dx * (static_cast<double>(next.nx) - 6 + 1.8) == Approx(seen.x_max - seen.x_min));
      CHECK(next.x0 + 2.1 * next.dx == Approx(seen.x_min));
      CHECK(next.dy * (static_cast<double>(next.ny) - 6 + 0.8) == Approx(seen.y_max - seen.y_min));
      CHECK(next.y0 + 2.6 * next.dy == Approx(seen.y_min));
    }
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
