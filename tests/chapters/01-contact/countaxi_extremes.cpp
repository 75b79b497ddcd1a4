#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/contact/geometry.hpp>
#include <railbook/units/input_error.hpp>

#include "method/countaxi.hpp"
#include "method/punch.hpp"
#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

TEST_CASE("extreme: too few rings for a sharp gradient are reported, not used") {
  const NoFpFault no_fault;
  CountaxiOptions options;
  options.grading = 1;
  for (int n : {5, 10, 20}) {
    options.rings = n;
    const RingContact c = countaxi(rounded_punch_gap({0.5, 0.01}), 1e-3, 1.0, options);
    CHECK_FALSE(c.converged);
    CHECK(c.reason.find("too few rings") != std::string::npos);
  }
}

TEST_CASE("extreme: the sphere scales from tiny to large approaches") {
  const NoFpFault no_fault;
  const RingContact one = countaxi(rounded_punch_gap({0, 1}), 1e-3, 1.0);
  for (double delta : {1e-18, 1e-9}) {
    const RingContact c = countaxi(rounded_punch_gap({0, 1}), delta, 1.0);
    const double s = std::sqrt(delta / 1e-3);
    CHECK(c.radius / (one.radius * s) == Approx(1).epsilon(1e-6));
    CHECK(c.force / (one.force * s * s * s) == Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("extreme: a short iteration says how far it got") {
  CountaxiOptions options;
  options.most_iterations = 2;
  const RingContact c = countaxi(rounded_punch_gap({0.5, 1}), 1e-3, 1.0, options);
  CHECK_FALSE(c.converged);
  CHECK(c.reason.find("still moves") != std::string::npos);
}

TEST_CASE("input: COUNTAXI refuses what makes no sense") {
  const Gap gap = rounded_punch_gap({0.5, 1});
  CHECK_THROWS_AS((void)countaxi(gap, std::nan(""), 1), InputError);
  CHECK_THROWS_AS((void)countaxi(gap, 1e-3, -1), InputError);
  CHECK_THROWS_AS((void)countaxi(gap, 1e-3, 1, {.rings = 2}), InputError);
  CHECK_THROWS_AS((void)countaxi(gap, 1e-3, 1, {.grading = 0.5}), InputError);
  const Gap broken = [](double x, double) {
    return x > 0.01 ? std::numeric_limits<double>::quiet_NaN() : x * x;
  };
  CHECK_THROWS_AS((void)countaxi(broken, 1e-2, 1), InputError);
}

TEST_CASE(
    "extreme: a gap that is least on a ring leaves no pressure at the centre, and that is "
    "reported") {
  for (const double hollow : {0.02, 0.9}) {
    const Gap ring = [=](double x, double) {
      const double u = 4 * (x * x - 0.25);  // -1 at the centre, 0 on the ring of 0.5
      return 1e-3 * hollow * u * u;
    };
    for (const int most : {1, 100}) {
      const RingContact c = countaxi(ring, 1e-3, 1.0, {.most_iterations = most});
      CAPTURE(hollow, most, c.iterations, c.reason);
      CHECK(c.reason.starts_with("collapsed: no pressure is left at the centre") == (hollow > 0.5));
      if (hollow > 0.5) CHECK_FALSE(c.converged);
      if (hollow > 0.5) CHECK(c.p[0] <= 0);
    }
  }
}

TEST_CASE("extreme: what has converged has three rings or more from the largest pressure on") {
  int few = 0, enough = 0;
  for (const double edge : {0.01, 0.1, 1.0})
    for (const double grading : {1.0, 2.0, 3.0})
      for (int n = 3; n < 30; ++n) {
        const RingContact c =
            countaxi(rounded_punch_gap({0.5, edge}), 1e-3, 1.0, {.rings = n, .grading = grading});
        const auto beyond = (c.r.array() >= c.r_p_max).count();
        CAPTURE(edge, grading, n, c.reason);
        if (c.converged) CHECK(beyond >= 3);
        if (c.converged) CHECK(c.reason.empty());
        if (!c.converged) CHECK_FALSE(c.reason.empty());
        ++(c.converged ? enough : few);
      }
  CHECK(few > 10);
  CHECK(enough > 10);
}
