#include <catch2/catch.hpp>
#include <cmath>

#include "contact/cg_fft.hpp"
#include "contact/geometry.hpp"
#include "contact/uniform_dense.hpp"
#include "units/constants.hpp"

using namespace railbook;
using namespace railbook::contact;

namespace {

CgFftOptions cells(Eigen::Index nx, Eigen::Index ny) {
  CgFftOptions options;
  options.nx = nx;
  options.ny = ny;
  return options;
}

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

TEST_CASE("property: scaling of lengths, modulus and approach") {
  const NormalContact base = solve_cg_fft(ellipsoid(1, 3), 1, 1, cells(50, 50)).contact;
  const double scale = 1e-9;
  const NormalContact tiny = solve_cg_fft(ellipsoid(1, 3), scale, 2e11, cells(50, 50)).contact;
  CHECK(tiny.force == Approx(base.force * 2e11 * std::pow(scale, 1.5)).epsilon(1e-4));
  CHECK(tiny.p_max == Approx(base.p_max * 2e11 * std::sqrt(scale)).epsilon(1e-4));
  CHECK(tiny.x_max == Approx(base.x_max * std::sqrt(scale)).epsilon(2e-2));
}

TEST_CASE("property: swapping the axes swaps the answer") {
  const NormalContact xy = solve_cg_fft(ellipsoid(1, 3), 1, 1, cells(90, 64)).contact;
  const NormalContact yx = solve_cg_fft(ellipsoid(3, 1), 1, 1, cells(64, 90)).contact;
  CHECK(xy.force == Approx(yx.force).epsilon(1e-4));
  CHECK(xy.p_max == Approx(yx.p_max).epsilon(1e-4));
  CHECK(xy.x_max == Approx(yx.y_max).epsilon(1e-2));
}

TEST_CASE("property: turning or moving the bodies changes nothing but the frame") {
  const NormalContact straight = solve_cg_fft(ellipsoid(1, 3), 1, 1, cells(96, 96)).contact;
  const double c = std::cos(0.5), s = std::sin(0.5);
  const Gap gap = ellipsoid(1, 3);
  const Gap turned = [=](double x, double y) { return gap(c * x + s * y, c * y - s * x); };
  const NormalContact other = solve_cg_fft(turned, 1, 1, cells(96, 96)).contact;
  CHECK(other.force == Approx(straight.force).epsilon(5e-5));
  CHECK(other.p_max == Approx(straight.p_max).epsilon(5e-5));
  // Moved by less than the box found from the origin still holds: the moments are those of the offset.
  const Gap moved = [=](double x, double y) { return gap(x - 0.2, y + 0.1); };
  const NormalContact shifted = solve_cg_fft(moved, 1, 1, cells(96, 96)).contact;
  CHECK(shifted.force == Approx(straight.force).epsilon(2e-5));
  CHECK(shifted.moment_y == Approx(0.2 * straight.force).epsilon(2e-5));
  CHECK(shifted.moment_x == Approx(0.1 * straight.force).epsilon(2e-5));
  CHECK(shifted.x_p_max == Approx(0.2).margin(1e-4));
}

TEST_CASE("property: a given load and its approach are one problem") {
  const Gap gap = rail_wheel_gap({0.46, 0.33, 0.3, 0.3});
  const double modulus = 1.1e11;
  const NormalContact pressed = solve_cg_fft(gap, 3e-5, modulus, cells(64, 64)).contact;
  const NormalContact loaded =
      solve_cg_fft_load(gap, pressed.force, modulus, cells(64, 64)).contact;
  REQUIRE(loaded.converged);
  CHECK(loaded.force == Approx(pressed.force).epsilon(2e-7));
  CHECK(loaded.approach == Approx(3e-5).epsilon(1e-5));
}

TEST_CASE("property: the same digits on every run") {
  const NormalContact one = solve_cg_fft(ellipsoid(1, 2), 1, 1, cells(61, 67)).contact;
  const NormalContact two = solve_cg_fft(ellipsoid(1, 2), 1, 1, cells(61, 67)).contact;
  CHECK(one.force == two.force);
  CHECK(one.work == two.work);
  CHECK((one.p - two.p).cwiseAbs().maxCoeff() == 0);
}

TEST_CASE("property: a box that is too small grows to the same answer") {
  CgFftOptions small = cells(64, 64);
  small.search = [](double) { return Box{-0.1, 0.02, -0.05, 0.3}; };
  const NormalContact grown = solve_cg_fft(ellipsoid(1, 1), 1, 1, small).contact;
  CHECK(grown.converged);
  CHECK(grown.force ==
        Approx(solve_cg_fft(ellipsoid(1, 1), 1, 1, cells(64, 64)).contact.force).epsilon(3e-5));
}

TEST_CASE("property: points of a gap solve like its function") {
  const Grid grid{-0.9, -0.9, 0.02, 0.02, 90, 90};
  const Gap gap = ellipsoid(1, 1);
  const CgFft points = solve_cg_fft(grid, sample(gap, grid), 1, 1);
  CHECK(points.contact.converged);
  const double exact = solve_cg_fft(gap, 1, 1, cells(128, 128)).contact.force;
  CHECK(points.contact.force == Approx(exact).epsilon(2e-4));
  CHECK(std::abs(points.contact.force / exact - 1) < points.contact.force_error);
  // Too small a grid is reported, not answered.
  const Grid small{-0.3, -0.3, 0.02, 0.02, 30, 30};
  const NormalContact cut = solve_cg_fft(small, sample(gap, small), 1, 1).contact;
  CHECK_FALSE(cut.converged);
  CHECK(cut.reason.find("edge") != std::string::npos);
}

TEST_CASE("property: the dense matrix and the FFT solve one discrete problem") {
  const Gap gap = rail_wheel_gap({0.4, 0.3, 0.25, 0.03});
  const Grid grid{-0.02, -0.012, 0.0008, 0.0008, 36, 30};
  const Eigen::VectorXd f = sample(gap, grid);
  CgFftOptions options;
  options.cg.tolerance = 1e-11;
  const NormalContact dense = solve_uniform_dense(grid, f, 1e-4, 1e11);
  const CgFft fft = solve_cg_fft(grid, f, 1e-4, 1e11, options);
  REQUIRE(dense.converged);
  REQUIRE(fft.contact.converged);
  REQUIRE(dense.p.size() == fft.contact.p.size());
  CHECK(dense.force == Approx(fft.levels.back().region.force).epsilon(1e-9));
  CHECK((dense.p - fft.contact.p).cwiseAbs().maxCoeff() < 1e-8 * dense.p_max);
  CHECK(dense.x_min == Approx(fft.levels.back().region.ends.x_min).epsilon(1e-6));
}
