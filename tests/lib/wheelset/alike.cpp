// A wheel hollowed to the radius of its rail: the gap of two such arcs is stationary nowhere.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/wheelset/wheelset_contact.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;

TEST_CASE(
    "extreme: arcs of one radius on each other are met at their ends, and nothing is trapped") {
  const NoFpFault no_fault;
  const double radius = 0.3;
  const Curve rail = chain({-0.78, 0}, -0.1, {arc(radius, 0.1)});
  for (const double lean : {-0.02, 0.0, 0.02}) {
    const Curve wheel = moved(turned(moved(rail, 0.75, 0), lean), -0.75, -0.46);
    const WheelsetOnTrack pair(wheel, rail);
    for (const double x : {0.0, 1e-3, -2e-3}) {
      const WheelsetContact at = pair.contact(x);
      CAPTURE(lean, x);
      REQUIRE(at.converged);
      CHECK(std::isfinite(at.height));
      if (lean != 0) CHECK(at.left.at_end);
      if (x == 0) CHECK(at.left.radius == Approx(at.right.radius).epsilon(1e-14));
    }
  }
}
