#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/contact/hertz.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::contact;

TEST_CASE("extreme: Hertz follows delta^(1/2) and delta^(3/2) over 40 decades") {
  const NoFpFault no_fault;
  const HertzContact one = hertz_from_approach({0.4, 1.1, 0}, 1e11, 1);
  for (double delta : {1e-40, 1e-14, 0.0254e-12, 1e-5}) {
    const HertzContact h = hertz_from_approach({0.4, 1.1, 0}, 1e11, delta);
    CHECK(h.a / (one.a * std::sqrt(delta)) == Approx(1).epsilon(1e-13));
    CHECK(h.p_max / (one.p_max * std::sqrt(delta)) == Approx(1).epsilon(1e-13));
    CHECK(h.force / (one.force * std::pow(delta, 1.5)) == Approx(1).epsilon(1e-13));
    CHECK(hertz_from_force({0.4, 1.1, 0}, 1e11, h.force).approach / delta ==
          Approx(1).epsilon(1e-13));
  }
}

TEST_CASE("extreme: towards line contact the axis ratio follows its asymptote") {
  const NoFpFault no_fault;
  // B -> 1 and D -> ln(4/sqrt(m1)) - 1, so q m1 (ln(4 a/b) - 1) -> 1, with an error of order m1 ln m1.
  for (double ratio : {1e14, 1e30, 1e100, 1e200}) {
    const HertzContact h = hertz_from_approach({1, ratio, 0}, 1e11, 1e-5);
    const double slender = h.b / h.a;
    CHECK(ratio * slender * slender * (std::log(4 / slender) - 1) == Approx(1).epsilon(1e-11));
    CHECK(h.force == Approx(2 * units::pi / 3 * h.a * h.b * h.p_max).epsilon(1e-13));
  }
  CHECK_THROWS_AS(hertz_from_approach({1, 1e201, 0}, 1e11, 1e-5), InputError);
}

TEST_CASE("extreme: nearly round contacts lose nothing") {
  const NoFpFault no_fault;
  for (double excess : {1e-3, 1e-8, 1e-15}) {
    const HertzContact h = hertz_from_approach({1, 1 + excess, 0}, 1, 1);
    // B/A = 1 + 3/4 m + O(m^2) for m = 1 - (b/a)^2, so 1 - b/a = 2/3 excess to first order.
    CHECK(h.b <= h.a);
    CHECK(1 - h.b / h.a == Approx(2.0 / 3 * excess).epsilon(2 * excess).margin(5e-16));
  }
}
