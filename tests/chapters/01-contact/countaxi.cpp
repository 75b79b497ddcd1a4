#include "method/countaxi.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>

#include "method/parts.hpp"
#include "method/punch.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

namespace {

constexpr double modulus = 1.5e7 / 0.91, approach = 1e-3;

}  // namespace

TEST_CASE("unit: COUNTAXI on the rounded punch against the closed form") {
  for (double edge : {0.1, 1.0, 5.0}) {
    const PunchContact exact = punch_from_approach({0.5, edge}, modulus, approach);
    const RingContact c = countaxi(rounded_punch_gap({0.5, edge}), approach, modulus);
    REQUIRE(c.converged);
    CHECK(c.force == Approx(exact.force).epsilon(1e-5));
    CHECK((c.radius - 0.5) / exact.edge_width == Approx(1).epsilon(5e-3));
    CHECK(c.p_max == Approx(punch_peak(exact).pressure).epsilon(1e-2));
    for (Eigen::Index i = 0; i < c.r.size(); ++i)
      if (c.r[i] < 0.49) CHECK(c.p[i] == Approx(punch_pressure(exact, c.r[i])).epsilon(2e-3));
    CHECK(c.work == 60L * 60 * c.iterations);
  }
}

TEST_CASE("unit: COUNTAXI on the sharp punch says that the edge is singular") {
  double before = 0;
  for (int n : {20, 40, 80}) {
    CountaxiOptions options;
    options.rings = n;
    const RingContact c = countaxi(rounded_punch_gap({0.5, 0}), approach, modulus, options);
    CHECK(c.converged);
    CHECK(c.reason.find("sharp") != std::string::npos);
    CHECK(c.radius == Approx(0.5).epsilon(1e-14));
    CHECK(c.force == Approx(2 * modulus * 0.5 * approach).epsilon(1e-4));
    CHECK(c.p_max > 2 * before);
    before = c.p_max;
  }
}

TEST_CASE("unit: COUNTAXI moves the boundary to where the pressure ends, then by the secant") {
  const Gap gap = rounded_punch_gap({0.5, 1});
  CountaxiOptions options;
  std::vector<double> radius, move;
  for (options.most_iterations = 1; options.most_iterations <= 3; ++options.most_iterations) {
    const RingContact c = countaxi(gap, approach, modulus, options);
    CHECK(c.iterations == options.most_iterations);
    radius.push_back(c.radius);
    move.push_back(detail::find_zero(c.r, c.p, c.radius, options.fit, false).at - c.radius);
  }
  CHECK(gap(radius[0], 0) == Approx(approach));  // the interpenetration curve
  CHECK(radius[1] == Approx(radius[0] + move[0]).epsilon(1e-14));
  CHECK(radius[2] ==
        Approx(radius[1] - move[1] * (radius[1] - radius[0]) / (move[1] - move[0])).epsilon(1e-13));
}
