#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>

#include "method/countact.hpp"
#include "method/countaxi.hpp"
#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

namespace {

constexpr double modulus = 1.5e7 / 0.91;
const Gap example_1 = rail_wheel_gap({18, 12.34, 10, 10});
const Gap example_2 = rail_wheel_gap({18, 12.34, 10, 1.25});

CountactOptions square(int n) {
  CountactOptions options;
  options.columns = uniform_columns(n);
  options.rows = n;
  return options;
}

}  // namespace

TEST_CASE("extreme: delta^(1/2) and delta^(3/2) down to an approach of 1e-12") {
  const NoFpFault no_fault;
  const NormalContact one = countact_2(example_1, 4e-4, modulus).contact;
  for (double delta : {1e-12, 1e-20}) {
    const NormalContact c = countact_2(example_1, delta, modulus).contact;
    REQUIRE(c.converged);
    const double s = std::sqrt(delta / 4e-4);
    CHECK(c.force / (one.force * s * s * s) == Approx(1).epsilon(1e-9));
    CHECK(c.p_max / (one.p_max * s) == Approx(1).epsilon(1e-9));
    CHECK(c.x_max / (one.x_max * s) == Approx(1).epsilon(1e-9));
    CHECK(c.iterations == one.iterations);
  }
}

TEST_CASE("extreme: towards line contact the errors stay those of the round contact") {
  const NoFpFault no_fault;
  for (double ratio : {1.0, 36.5, 2e3, 1e7, 1e12}) {
    const RelativeCurvature curvature{1, ratio, 0};
    const HertzContact h = hertz_from_approach(curvature, 1, 1e-4);
    const NormalContact c = countact_2(quadratic_gap(curvature), 1e-4, 1, square(13)).contact;
    INFO("curvature ratio " << ratio << ", " << c.reason);
    REQUIRE(c.converged);
    CHECK(c.force == Approx(h.force).epsilon(4e-3));
    CHECK(c.p_max == Approx(h.p_max).epsilon(4e-3));
    CHECK(c.y_max / h.b == Approx(1).epsilon(0.02));
  }
}

TEST_CASE("extreme: three-point parabolas without a guard diverge, and say so") {
  for (int n : {7, 9, 13}) {
    CountactOptions options = square(n);
    options.fit = Fit::three_points;
    options.damped = false;
    const NormalContact c = countact_2(example_1, 4e-4, modulus, options).contact;
    CHECK_FALSE(c.converged);
    CHECK(c.reason.find("diverged") != std::string::npos);
    // The inward clamp makes them rest, too small; the paper's one-valued rule makes them right.
    options.inward_only = true;
    const NormalContact clamped = countact_2(example_1, 4e-4, modulus, options).contact;
    options.inward_only = false;
    options.fit = Fit::three_points_guarded;
    const NormalContact guarded = countact_2(example_1, 4e-4, modulus, options).contact;
    CHECK(guarded.converged);
    CHECK(guarded.force == Approx(999.3417).epsilon(0.01));
    CHECK(clamped.x_max < guarded.x_max);
  }
}

TEST_CASE("extreme: nine uniform columns cannot find the narrow side of the jump, and say so") {
  for (bool damped : {true, false}) {
    CountactOptions options;
    options.damped = damped;
    const NormalContact c = countact_1(example_2, 5e-3, modulus, options).contact;
    CHECK_FALSE(c.converged);
    CHECK(c.reason.find("collapsed") != std::string::npos);
  }
}

TEST_CASE(
    "extreme: a sharp edge is singular: the edge pressure grows with the mesh, and it is "
    "reported") {
  const NoFpFault no_fault;
  const Gap sharp = crowned_roller_gap({0.5, 0.5, 0});
  double before = 0;
  for (int n : {33, 65, 129}) {
    CountactOptions options;
    options.columns = uniform_columns(n);
    options.rows = 7;
    const NormalContact c = countact_2(sharp, 6.5e-4, modulus, options).contact;
    REQUIRE(c.converged);
    CHECK(c.reason.find("sharp") != std::string::npos);
    CHECK(c.x_max == Approx(0.5).epsilon(1e-12));
    CHECK(c.p_max > 1.15 * before);
    before = c.p_max;
  }
}

TEST_CASE("extreme: an iteration that is cut short says how far it got") {
  CountactOptions options;
  options.most_iterations = 2;
  const NormalContact c = countact_2(example_1, 4e-4, modulus, options).contact;
  CHECK_FALSE(c.converged);
  CHECK(c.reason.find("still moves") != std::string::npos);
  CHECK(c.force > 0);
}

TEST_CASE("extreme: of a region not found yet only what presses is listed") {
  CountactOptions options = square(9);
  options.most_iterations = 1;
  const NormalContact first = countact_2(example_1, 4e-4, modulus, options).contact;
  CHECK_FALSE(first.converged);
  CHECK(first.p.minCoeff() > 0);
  CHECK(first.p.size() < 81);  // the region the method starts from is too large
}

TEST_CASE("extreme: two pieces of overlap with a column between them are refused") {
  const NoFpFault no_fault;
  const Gap two_summits = [](double x, double y) {
    const double t = x < 0.0015 ? x : x - 0.003;
    return (t * t + y * y) / 2;
  };
  const NormalContact c = countact_1(two_summits, 1e-6, modulus, square(15)).contact;
  CHECK_FALSE(c.converged);
  CHECK(c.reason.find("several pieces") != std::string::npos);
  CHECK(c.p.size() == 0);
}

TEST_CASE("extreme: no approach, no contact") {
  const Gap gap = [](double x, double y) { return x * x + y * y; };
  for (const double approach : {0.0, -1.0}) {
    for (const NormalContact& contact :
         {countact_1(gap, approach, 1).contact, countact_2(gap, approach, 1).contact}) {
      CHECK(contact.converged);
      CHECK(contact.approach == approach);
      CHECK(contact.force == 0);
      CHECK(contact.p.size() == 0);
      CHECK(contact.area == 0);
      CHECK(contact.reason == empty_contact_reason);
    }
    const RingContact rings = countaxi(gap, approach, 1);
    CHECK(rings.converged);
    CHECK(rings.force == 0);
    CHECK(rings.reason == empty_contact_reason);
  }
}
