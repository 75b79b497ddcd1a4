#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/contact/hertz.hpp>
#include <railbook/contact/material.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/rolling/kalker_table.hpp>

#include "support/cg_fft_cells.hpp"
#include "support/kalker_grids.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::tests;

namespace {

constexpr std::array coefficients{&KalkerCoefficients::c11, &KalkerCoefficients::c22,
                                  &KalkerCoefficients::c23, &KalkerCoefficients::c33};

// The pressure of n x n cells over the diameters of Hertz's ellipse, and of an empty cell around,
// at its load.
struct Pixels {
  contact::Grid grid;
  Eigen::VectorXd pressure;
};
Pixels pressed(const contact::HertzContact& h, double modulus, Eigen::Index n) {
  const double dx = 2 * h.a / static_cast<double>(n), dy = 2 * h.b / static_cast<double>(n);
  Pixels out{{-h.a - dx, -h.b - dy, dx, dy, n + 2, n + 2}, {}};
  const auto gap = contact::sample(
      [&](double x, double y) { return h.curvature.a * x * x + h.curvature.b * y * y; }, out.grid);
  double approach = h.approach, last = 0, force = 0;
  for (int k = 0; k < 12; ++k) {  // secants
    const auto c = solve_on(out.grid, gap, approach, modulus, out.pressure, 1e-10);
    if (std::abs(c.force / h.force - 1) < 1e-9) return out;
    const double slope = k > 0 ? (c.force - force) / (approach - last) : 1.5 * h.force / h.approach;
    last = approach, force = c.force;
    approach += (h.force - force) / slope;
  }
  FAIL("the pressure was not found for the load");
  return out;
}

}  // namespace

TEST_CASE("unit: Kalker's printed coefficients are within 0.8 % of the computed ones") {
  // But for the most slender contacts. J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling
  // Contact, 1990, Table E3. He computed as well as one could, so that his error goes smoothly
  // along a column: an entry off by more than its neighbours is a slip of the pen, his or ours.
  int entries = 0, off = 0;
  for (const double nu : {0.0, 0.25, 0.5})
    for (const auto member : coefficients) {
      std::vector<double> error;
      for (int k = 1; k <= 19; ++k) {
        const double ratio = k <= 10 ? k / 10.0 : 10.0 / (20 - k);
        INFO("a/b " << ratio << ", nu " << nu);
        const ComputedCoefficients computed = kalker_coefficients(ratio, nu);
        CHECK(computed.c32 == Approx(computed.c23).epsilon(1e-10));
        error.push_back(kalker_table(ratio, nu).*member / (computed.*member) - 1);
        CHECK(std::abs(error.back()) < (k == 1 || k == 19 ? 0.0125 : 0.008));
        ++entries;
        off += std::abs(error.back()) > 0.005;
      }
      for (std::size_t k = 1; k + 1 < error.size(); ++k) {
        INFO("row " << k << ", nu " << nu);
        CHECK(std::abs(error[k] - (error[k - 1] + error[k + 1]) / 2) < 0.007);
      }
    }
  CHECK(entries == 228);
  CHECK(off < entries / 5);  // most are good to half a per cent
}

TEST_CASE("unit: Kalker's coefficients by extrapolated grids over the whole table") {
  for (const double ratio : {0.1, 10.0 / 3, 10.0})
    for (const double nu : {0.0, 0.5}) {
      INFO("a/b " << ratio << ", nu " << nu);
      const ComputedCoefficients c = kalker_coefficients(ratio, nu);
      const GridCoefficients grids = kalker_coefficients_by_grids(ratio, nu);
      const bool slender = ratio > 9;
      CHECK(grids.c11 == Approx(c.c11).epsilon(slender ? 0.008 : 0.003));
      CHECK(grids.c22 == Approx(c.c22).epsilon(slender ? 0.008 : 0.003));
      CHECK(grids.c23 == Approx(c.c23).epsilon(slender ? 0.008 : ratio < 0.15 ? 0.005 : 0.003));
      CHECK(grids.c33 == Approx(c.c33).epsilon(slender ? 0.025 : ratio > 1.5 ? 0.006 : 0.003));
    }
}

TEST_CASE("unit: on CONTACT's own grids its force comes out to the digits it prints") {
  // The public program CONTACT on n x n cells over the diameters, a/b = 1.568, nu = 0.3, pure
  // longitudinal creepage.
  struct Printed {
    Eigen::Index n;
    std::array<double, 3> force;  // over mu N, at X = 0.1, 0.2, 0.3
  };
  const std::vector<Printed> all{{15, {.431778, .730340, .907672}},
                                 {31, {.423703, .715882, .894025}},
                                 {63, {.420516, .711119, .888986}}};
  const double young = 207e9, nu = 0.3, radius = 82.167232e-3;
  const double modulus = contact::effective_modulus({young, nu}, {young, nu});
  const contact::HertzContact h =
      contact::hertz_from_force({.a = 0.5 / radius, .b = 0.5 / 41.78975e-3}, modulus, 4449.72);
  REQUIRE(h.a / h.b == Approx(1.568).epsilon(1e-6));
  const RollingCase rig{h.a, h.b, h.force, young / (2 * (1 + nu)), nu, 0.3, {}};
  for (const Printed& printed : all) {
    const Pixels cells = pressed(h, modulus, printed.n);
    for (std::size_t k = 0; k < 3; ++k) {
      const RollingCase c = with_reduced_creepage(rig, {0.1 * static_cast<double>(k + 1), 0, 0});
      const CreepForces f =
          solve_rolling(cells.grid, cells.pressure, c, {.remedy = false, .estimate = false});
      INFO(printed.n << " cells, X = " << 0.1 * static_cast<double>(k + 1));
      CHECK(f.converged);
      CHECK(std::abs(f.fx / (c.friction * c.load) - printed.force[k]) < 6e-7);
    }
  }
}
