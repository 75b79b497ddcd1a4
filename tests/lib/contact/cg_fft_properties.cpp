#include <Eigen/Cholesky>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/contact/influence.hpp>
#include <railbook/units/constants.hpp>

#include "support/cg_fft_cells.hpp"

using namespace railbook;
using namespace railbook::contact;

namespace {

Gap ellipsoid(double a, double b) {
  return [=](double x, double y) { return a * x * x + b * y * y; };
}

}  // namespace

TEST_CASE("property: pressure and gap are complementary") {
  const Gap gap = rail_wheel_gap({0.4, 0.3, 0.25, 0.03});
  const double approach = 1e-4, modulus = 1e11;
  CgFftOptions options = cells(60, 50);
  options.edge_x = 0;
  const CgFft result = solve_cg_fft(gap, approach, modulus, options);
  REQUIRE(result.contact.converged);
  const Grid& grid = result.levels.back().grid;
  Eigen::VectorXd p = Eigen::VectorXd::Zero(grid.cells()), u(grid.cells());
  for (Eigen::Index n = 0; n < result.contact.p.size(); ++n) {
    const auto i = std::lround((result.contact.x[n] - grid.x(0)) / grid.dx);
    const auto j = std::lround((result.contact.y[n] - grid.y(0)) / grid.dy);
    p[j * grid.nx + i] = result.contact.p[n];
  }
  Convolution(grid, modulus).apply(p, u);
  const Eigen::VectorXd s =
      u + sample(gap, grid) - Eigen::VectorXd::Constant(grid.cells(), approach);
  CHECK(p.minCoeff() >= 0);
  CHECK(s.minCoeff() > -1e-7 * approach);
  CHECK((p.array() > 0).select(s, 0.0).cwiseAbs().maxCoeff() < 1e-7 * approach);
  // A cell edge is on the jump of the curvature.
  const double edge = -grid.x0 / grid.dx;
  CHECK(edge == Approx(std::round(edge)).epsilon(1e-10));
  // The sums of the cells are those of the level.
  CHECK(result.contact.p.sum() * grid.dx * grid.dy ==
        Approx(result.levels.back().region.force).epsilon(1e-12));
}

TEST_CASE("property: turning or moving the bodies changes nothing but the frame") {
  const NormalContact straight = solve_cg_fft(ellipsoid(1, 3), 1, 1, cells(96, 96)).contact;
  const double c = std::cos(0.5), s = std::sin(0.5);
  const Gap gap = ellipsoid(1, 3);
  const Gap turned = [=](double x, double y) { return gap(c * x + s * y, c * y - s * x); };
  const NormalContact other = solve_cg_fft(turned, 1, 1, cells(96, 96)).contact;
  CHECK(other.force == Approx(straight.force).epsilon(5e-5));
  CHECK(other.p_max == Approx(straight.p_max).epsilon(5e-5));
  // Moved by less than the box found from the origin still holds: the moments are those of the
  // offset.
  const Gap moved = [=](double x, double y) { return gap(x - 0.2, y + 0.1); };
  const NormalContact shifted = solve_cg_fft(moved, 1, 1, cells(96, 96)).contact;
  CHECK(shifted.force == Approx(straight.force).epsilon(2e-5));
  CHECK(shifted.moment_y == Approx(0.2 * straight.force).epsilon(2e-5));
  CHECK(shifted.moment_x == Approx(0.1 * straight.force).epsilon(2e-5));
  CHECK(shifted.x_p_max == Approx(0.2).margin(1e-4));
}

TEST_CASE("property: the ends of a roller are found wherever it lies along its axis") {
  const auto roller = [](double x_mid, double y_mid) {
    return solve_cg_fft(
               [=](double x, double y) {
                 const bool along = std::abs(x - x_mid) < 0.9, around = std::abs(y - y_mid) < 0.9;
                 return along && around ? 0.5 * (y - y_mid) * (y - y_mid)
                                        : std::numeric_limits<double>::infinity();
               },
               0.1, 1, cells(64, 64))
        .contact;
  };
  const NormalContact middle = roller(0, 0);
  CHECK(middle.x_max == Approx(0.9).epsilon(1e-9));
  for (const auto& [x, y] : {std::pair{1.0, 0.0}, {-0.8, 0.1}, {0.4, -0.2}}) {
    const NormalContact off = roller(x, y);
    CHECK(off.x_min - x == Approx(middle.x_min).epsilon(1e-9));
    CHECK(off.x_max - x == Approx(middle.x_max).epsilon(1e-9));
    CHECK(off.force == Approx(middle.force).epsilon(1e-3));
    CHECK(off.p_max == Approx(middle.p_max).epsilon(1e-3));
  }
}

TEST_CASE("property: a box that is too small grows to the same answer") {
  CgFftOptions small = cells(64, 64);
  small.search = [](double) { return Box{-0.1, 0.02, -0.05, 0.3}; };
  const NormalContact grown = solve_cg_fft(ellipsoid(1, 1), 1, 1, small).contact;
  CHECK(grown.converged);
  CHECK(grown.force ==
        Approx(solve_cg_fft(ellipsoid(1, 1), 1, 1, cells(64, 64)).contact.force).epsilon(3e-5));
}

TEST_CASE("property: the stated errors hold for Hertz's contacts of any slenderness and direction",
          "[thorough]") {
  for (const double ratio : {1.0, 4.0, 25.0, 128.0, 289.0, 652.0, 1e4, 1e6})
    for (const double angle : {0.0, 0.3, units::pi / 4})
      for (const bool swapped : {false, true})
        for (const Eigen::Index n : {24, 40, 64, 127}) {
          const RelativeCurvature curvature{swapped ? ratio : 1, swapped ? 1 : ratio, angle};
          const HertzContact exact = hertz_from_approach(curvature, 1, 1e-4);
          const NormalContact c =
              solve_cg_fft(quadratic_gap(curvature), 1e-4, 1, cells(n, n)).contact;
          INFO("ratio " << ratio << ", angle " << angle << ", " << n << " cells: " << c.reason);
          CHECK(std::abs(c.force / exact.force - 1) < c.force_error);
          CHECK(std::abs(c.p_max / exact.p_max - 1) < 1.3 * c.p_max_error);
          CHECK(std::isinf(c.force_error) ==
                (c.reason.find("under-resolved") != std::string::npos));
          if (angle == 0 && n >= 64) CHECK(c.force_error < 2e-4);
        }
}

TEST_CASE("property: several patches are the sum of each") {
  // Five equal patches in a row along x or y, whose mutual influence is small: each has its share
  // of area and force.
  const double apart = 40;
  for (const bool along_x : {true, false})
    for (const int count : {2, 5}) {
      const Gap gap = [=](double x, double y) {
        const double t = along_x ? x : y, s = along_x ? y : x;
        const double nearest = std::clamp(std::round(t / apart), 0.0, count - 1.0);
        return 0.5 * (std::pow(t - nearest * apart, 2) + s * s);
      };
      CgFftOptions options = along_x ? cells(60 * count, 31) : cells(31, 60 * count);
      const double end = (count - 1) * apart + 1.5;
      options.search = [=](double) {
        return along_x ? Box{-1.5, end, -1.5, 1.5} : Box{-1.5, 1.5, -1.5, end};
      };
      const CgFft result = solve_cg_fft(gap, 1, 1, options);
      const Region& region = result.levels.back().region;
      REQUIRE(result.contact.converged);
      REQUIRE(region.patches.size() == static_cast<std::size_t>(count));
      double area = 0, force = 0;
      for (const PressurePatch& patch : region.patches) {
        CHECK(patch.area ==
              Approx(region.area / count).epsilon(0.3));  // a cell is a fifth of a radius
        CHECK(patch.force == Approx(region.force / count).epsilon(0.2));
        area += patch.area, force += patch.force;
      }
      const Box& e = region.ends;  // of all together: a radius of 1 beyond the outer summits
      CHECK((along_x ? e.x_min : e.y_min) == Approx(-1).margin(0.25));
      CHECK((along_x ? e.x_max : e.y_max) == Approx((count - 1) * apart + 1).margin(0.25));
      CHECK((along_x ? e.y_min : e.x_min) == Approx(-1).margin(0.25));
      CHECK((along_x ? e.y_max : e.x_max) == Approx(1).margin(0.25));
      CHECK(result.contact.area == Approx(area).epsilon(1e-12));
      CHECK(region.force == Approx(force).epsilon(1e-12));
      CHECK(result.contact.area == Approx(count * units::pi).epsilon(0.25));
      CHECK(std::set<int>(result.outline.patch.begin(), result.outline.patch.end()).size() ==
            static_cast<std::size_t>(count));
    }
}

TEST_CASE("property: a hole in the contact is no area") {
  // A ring of contact: an annular ridge of radius 1.
  const Gap gap = [](double x, double y) { return std::pow(std::hypot(x, y) - 1, 2); };
  CgFftOptions options = cells(121, 121);
  options.search = [](double) { return Box{-1.2, 1.2, -1.2, 1.2}; };
  const CgFft result = solve_cg_fft(gap, 1e-3, 1, options);
  const Grid& grid = result.levels.back().grid;
  const Region& region = result.levels.back().region;
  CHECK(region.patches.size() == 1);
  CHECK(region.area == Approx(static_cast<double>(region.cells) * grid.dx * grid.dy).epsilon(0.35));
  CHECK(region.area < 0.5);
}

TEST_CASE("property: a contact off the origin is found, or there is none and it is refused") {
  const double exact = solve_cg_fft(ellipsoid(1, 3), 1e-4, 1, cells(50, 50)).contact.force;
  for (const auto& place : {std::pair{0.02, 0.0}, {-1.0, 3.0}, {0.0, 70.0}, {1e-3, -2e-5}}) {
    const double x0 = place.first, y0 = place.second;
    INFO(x0 << " " << y0);
    const Gap gap = [=](double x, double y) {
      return std::pow(x - x0, 2) + 3 * std::pow(y - y0, 2);
    };
    const NormalContact c = solve_cg_fft(gap, 1e-4, 1, cells(50, 50)).contact;
    CHECK(c.force == Approx(exact).epsilon(1e-4));
    CHECK(c.x_p_max == Approx(x0).margin(1e-4));
    const NormalContact loaded = solve_cg_fft_load(gap, exact, 1, cells(50, 50)).contact;
    CHECK(loaded.converged);
    CHECK(loaded.approach == Approx(1e-4).epsilon(1e-3));
  }
  const Gap ring = [](double x, double y) { return std::pow(std::hypot(x, y) - 1, 2); };
  CHECK(solve_cg_fft(ring, 1e-3, 1, cells(64, 64)).contact.x_max > 1);
  const Gap apart = [](double x, double y) { return 1e-3 + x * x + y * y; };
  CHECK_THROWS_WITH(solve_cg_fft(apart, 1e-4, 1), Catch::Contains("0.001 m at the origin") &&
                                                      Catch::Contains("below the approach"));
}

TEST_CASE("property: a load is met on a grid too coarse for the contact, and that is reported") {
  const RelativeCurvature curvature{1, 1e5, 0.6};
  const double load = hertz_from_approach(curvature, 1, 1e-4).force;
  const NormalContact c =
      solve_cg_fft_load(quadratic_gap(curvature), load, 1, cells(48, 48)).contact;
  CHECK(c.converged);
  CHECK_FALSE(c.reason.empty());
  CHECK(std::isinf(c.force_error));
}

TEST_CASE("property: a small patch far from the first is found on whichever side it lies") {
  // A summit 7.5 um lower at an approach of 8 um: its patch is a millimetre across, 30 mm away.
  const double far = 0.03, lower = 7.5e-6, approach = 8e-6;
  for (const bool along_y : {false, true})
    for (const double side : {-1.0, 1.0}) {
      INFO("along y " << along_y << ", side " << side);
      const Gap gap = [=](double x, double y) {
        const double along = side * (along_y ? y : x), across = along_y ? x : y;
        const double second = along > 0.5 * far ? 1 : 0, t = along - second * far;
        return 5 * t * t + 50 * across * across + second * lower;
      };
      CgFftOptions options = along_y ? cells(63, 255) : cells(255, 63);
      options.search = [=](double d) {
        const double half = std::sqrt(d), low = side > 0 ? -0.009 : -far - 0.009,
                     high = side > 0 ? far + 0.009 : 0.009;
        return along_y ? Box{-half, half, low, high} : Box{low, high, -half, half};
      };
      const CgFft found = solve_cg_fft(gap, approach, 1e11, options);
      CHECK(found.levels.back().region.patches.size() == 2);
      // Hertz's force of each, the second sunk in by the first one's load at its distance, and the
      // first by the second's.
      const auto alone = [](double d) { return hertz_from_approach({5, 50, 0}, 1e11, d).force; };
      const double first = alone(approach), per_load = 1 / (units::pi * 1e11 * far);
      const double small = alone(approach - lower - first * per_load);
      const double both = alone(approach - small * per_load) + small;
      CHECK(both > 1.01 * first);
      CHECK(found.contact.force == Approx(both).epsilon(0.0015));
    }
}

TEST_CASE("property: patches that the coarse grids of the ladder miss are found all the same") {
  // Three summits 20 mm apart, the second and third lower: patches of 1 to 3 mm at each.
  for (const double lower : {1e-7, 1e-6, 2e-6})
    for (const double approach : {8e-6, 12e-6, 20e-6}) {
      INFO("lower " << lower << ", approach " << approach);
      const Gap gap = [=](double x, double y) {
        const double nearest = std::clamp(std::round(x / 0.02), 0.0, 2.0);
        const double t = x - 0.02 * nearest;
        return 5 * t * t + y * y + lower * nearest;
      };
      CgFftOptions options = cells(255, 63);
      options.search = [](double d) {
        const double half = std::sqrt(d);
        return Box{-0.009, 0.049, -half, half};
      };
      const CgFft result = solve_cg_fft(gap, approach, 1e11, options);
      const Region& region = result.levels.back().region;
      CHECK(result.contact.converged);
      CHECK(region.patches.size() == 3);
      // Each alone would bear Hertz's force at its own approach; the others take a little of it.
      double alone = 0;
      for (const int k : {0, 1, 2})
        alone += hertz_from_approach({5, 1, 0}, 1e11, approach - k * lower).force;
      CHECK(region.force < alone);
      CHECK(region.force > 0.75 * alone);
    }
}

TEST_CASE(
    "property: a patch that only the finest grid finds is extrapolated over like the others") {
  // A second summit 20 mm away and 5 um lower begins to bear: grids that had one patch and grids
  // that had two made forces that fell as the bodies came nearer, off by more than their sum.
  const Gap gap = [](double x, double y) {
    return std::min(x * x / 0.6, 5e-6 + (x - 0.02) * (x - 0.02) / 0.2) + y * y / 0.92;
  };
  double last = 0;
  for (const double approach : {5.2e-6, 5.44e-6, 6e-6, 7.6e-6, 7.66e-6, 7.68e-6, 7.72e-6}) {
    INFO("approach " << approach);
    const auto solve = [&](Eigen::Index n) {
      CgFftOptions options = cells(n, n);
      options.search = [](double d) {
        const double half = std::sqrt(0.92 * d);
        return Box{-0.004, 0.022, -half, half};
      };
      return solve_cg_fft(gap, approach, 1.13626e11, options);
    };
    const CgFft coarse = solve(127), fine = solve(255);
    const double force = fine.contact.force, sum = fine.levels.back().region.force;
    REQUIRE(fine.levels.back().region.patches.size() == 2);
    CHECK(fine.contact.force_error < 0.01);
    CHECK(std::abs(force - sum) < fine.contact.force_error * force);
    CHECK(std::abs(coarse.contact.force / force - 1) <
          std::min(coarse.contact.force_error, 0.005) + fine.contact.force_error);
    CHECK(force > last);
    last = force;
  }
}

TEST_CASE("property: one, two and three threads find the same digits") {
  const Gap gap = rail_wheel_gap({0.4, 0.3, 0.25, 0.03});
  const auto with_threads = [&](int threads) {
    CgFftOptions options = cells(251, 260);  // a prime, and large enough for threads to be started
    options.cg.threads = threads;
    return solve_cg_fft(gap, 1e-4, 1e11, options);
  };
  const CgFft one = with_threads(1);
  for (const int threads : {2, 3}) {
    const CgFft more = with_threads(threads);
    CHECK(more.contact.iterations == one.contact.iterations);
    CHECK(more.contact.force == one.contact.force);
    CHECK(more.contact.p == one.contact.p);
  }
}
