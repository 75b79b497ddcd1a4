#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/units/constants.hpp>

#include "support/cg_fft_cells.hpp"
#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::contact;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("extreme: long patches cost no accuracy and few more iterations") {
  const NoFpFault no_fault;
  // Ratios of curvature whose Hertz patch has b/a near .1, .01 and 1e-4: the force of each, scaled
  // by the force of the same patch on twice the cells, must not depend on the ratio.
  for (const double ratio : {36.54, 2003.0, 1.042e7}) {
    INFO(ratio);
    const Gap gap = [=](double x, double y) { return x * x + ratio * y * y; };
    const NormalContact coarse = solve_cg_fft(gap, 1, 1, cells(64, 64)).contact;
    const NormalContact fine = solve_cg_fft(gap, 1, 1, cells(128, 128)).contact;
    CHECK(coarse.converged);
    CHECK(fine.converged);
    CHECK(coarse.force == Approx(fine.force).epsilon(3e-4));
    CHECK(fine.iterations < 400);
  }
}

TEST_CASE("extreme: approaches from 1e-20 to 1e20 scale") {
  const NoFpFault no_fault;
  const Gap gap = [](double x, double y) { return 0.5 * (x * x + y * y); };
  for (const double approach : {1e-20, 1e-12, 1e3}) {
    const NormalContact contact = solve_cg_fft(gap, approach, 1, cells(48, 48)).contact;
    INFO(approach);
    CHECK(contact.converged);
    CHECK(contact.force == Approx(4.0 / 3 * std::pow(approach, 1.5)).epsilon(2e-4));
  }
}

TEST_CASE("extreme: prime sizes and sizes of a few cells") {
  const NoFpFault no_fault;
  const Gap gap = [](double x, double y) { return 0.5 * (x * x + y * y); };
  CHECK(solve_cg_fft(gap, 1, 1, cells(101, 103)).contact.force == Approx(4.0 / 3).epsilon(2e-5));
  CHECK(solve_cg_fft(gap, 1, 1, cells(5, 4)).contact.force == Approx(4.0 / 3).epsilon(0.5));
}

TEST_CASE("extreme: one cell in contact is its own stiffness") {
  const Grid grid{0, 0, 1, 1, 3, 3};
  Eigen::VectorXd f = Eigen::VectorXd::Constant(9, inf);
  f[4] = 0.25;
  Eigen::VectorXd p;
  const Region region = solve_on(grid, f, 1, 1, p);
  CHECK(region.cells == 1);
  CHECK(region.force == Approx(0.75 / Convolution(grid, 1).self()).epsilon(1e-7));
}

TEST_CASE("extreme: no approach, no contact") {
  const Gap gap = [](double x, double y) { return x * x + y * y; };
  for (const double approach : {0.0, -1.0}) {
    const NormalContact contact = solve_cg_fft(gap, approach, 1).contact;
    CHECK(contact.converged);
    CHECK(contact.approach == approach);
    CHECK(contact.force == 0);
    CHECK(contact.p.size() == 0);
    CHECK(contact.area == 0);
    CHECK(contact.reason == empty_contact_reason);
  }
}

TEST_CASE("extreme: a sharp edge is called singular") {
  const NoFpFault no_fault;
  const Gap gap = crowned_roller_gap({0.5, 0.5, 0});
  const NormalContact contact = solve_cg_fft(gap, 6.5e-4, 1, cells(90, 90)).contact;
  CHECK(contact.converged);
  CHECK(contact.reason.find("singular") != std::string::npos);
  CHECK(contact.x_max == Approx(0.5).epsilon(1e-12));
  // A flat circular punch has F = 2 E* b delta.
  const Gap punch = rounded_punch_gap({1, 0});
  CHECK(solve_cg_fft(punch, 1e-3, 1, cells(128, 128)).contact.force == Approx(2e-3).epsilon(5e-3));
}

TEST_CASE("extreme: loads from 1e-12 to 1e4 find their approach") {
  const NoFpFault no_fault;
  const Gap gap = [](double x, double y) { return 0.5 * (x * x + y * y); };
  for (const double load : {1e-12, 1.0, 1e4}) {
    INFO(load);
    const NormalContact contact = solve_cg_fft_load(gap, load, 1, cells(40, 40)).contact;
    CHECK(contact.converged);
    CHECK(contact.force == Approx(load).epsilon(2e-7));
    CHECK(contact.approach == Approx(std::pow(0.75 * load, 2.0 / 3)).epsilon(2e-4));
  }
}
