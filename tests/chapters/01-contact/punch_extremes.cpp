#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/units/constants.hpp>

#include "method/punch.hpp"
#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

// As a -> b the width of the rounded contact is governed by s^3 = 3 b delta R (1 + ...): nothing
// may cancel.
TEST_CASE("extreme: a hardly rounded punch keeps its digits") {
  const NoFpFault no_fault;
  for (double edge : {1e-6, 1e-12, 1e-24}) {
    const double b = 0.5, delta = 1e-3;
    const PunchContact c = punch_from_approach({b, edge}, 1, delta);
    const double s = std::cbrt(3 * b * delta * edge), x = s / b;
    CHECK(c.s == Approx(s).epsilon(x * x + 1e-13));
    CHECK(c.edge_width == Approx(s * s / (2 * b)).epsilon(2 * x * x + 1e-12));
    CHECK(c.force == Approx(2 * b * delta).epsilon(x * x + 1e-14));
    CHECK(c.force > 2 * b * delta * (1 - 1e-14));
    // Near the edge the contact is plane: with r^2 - b^2 = (s/cosh z)^2 the pressure is 3 E*
    // delta/(2 pi s) (tanh z + z/cosh^2 z), largest where z tanh z = 1, and there 3 E* delta z/(2
    // pi s).
    if (edge > 1e-20)
      CHECK(punch_peak(c).pressure ==
            Approx(3 * delta * 1.199678640257734 / (2 * units::pi * s)).epsilon(3 * x + 1e-6));
  }
}

TEST_CASE("extreme: tiny and huge approaches") {
  const NoFpFault no_fault;
  for (double delta : {1e-30, 1e-15, 1e-6}) {
    const PunchContact c = punch_from_approach({0.01, 0.02}, 1e11, delta);
    CHECK(c.force / (2e11 * 0.01 * delta) ==
          Approx(1).epsilon(3 * std::cbrt(delta * delta * 4e8) + 1e-13));
    CHECK(punch_pressure(c, 0) / (1e11 * delta / (units::pi * 0.01)) ==
          Approx(1).epsilon(3 * std::cbrt(delta * delta * 4e8) + 1e-13));
  }
  // Far beyond the flat it is a sphere (formally: half-space theory does not hold there).
  const PunchContact huge = punch_from_approach({1e-6, 1}, 1, 1e3);
  CHECK(huge.radius == Approx(std::sqrt(1e3)).epsilon(1e-6));
}

TEST_CASE("extreme: the peak of a sharp punch is at its edge, and without a bound") {
  const NoFpFault no_fault;
  for (const double flat : {1e-6, 0.5, 1e3}) {
    const PunchPeak peak = punch_peak(punch_from_approach({flat, 0}, 1, 1e-3 * flat));
    CHECK(peak.r == flat);
    CHECK(std::isinf(peak.pressure));
  }
}

TEST_CASE("extreme: a punch of any size is the same punch in its units") {
  for (const double edge : {1e-3, 1.0, 1e3}) {
    const PunchContact one = punch_from_approach({0.5, edge}, 1e11, 1e-6);
    for (const double s : {1e-9, 1e-4, 1e4, 1e6}) {
      const PunchContact c = punch_from_approach({0.5 * s, edge * s}, 1e11, 1e-6 * s);
      CAPTURE(edge, s);
      CHECK(c.edge_width == Approx(s * one.edge_width).epsilon(1e-9));
      CHECK(c.force == Approx(s * s * one.force).epsilon(1e-9));
    }
  }
}
