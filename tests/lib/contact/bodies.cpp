#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/contact/bodies.hpp>
#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::contact;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

// Points of a circle of radius r with its summit at (x0, depth0).
DepthPoints circle(double r, double x0, double depth0, int n = 161, double half = 0.04) {
  DepthPoints p{Eigen::VectorXd::LinSpaced(n, x0 - half, x0 + half), Eigen::VectorXd(n)};
  for (int k = 0; k < n; ++k)
    p.depth[k] = depth0 + r - std::copysign(std::sqrt(r * r - std::pow(p.x[k] - x0, 2)), r);
  return p;
}

}  // namespace

TEST_CASE("unit: bodies by radii give Hertz's gap") {
  const TouchingBodies t =
      join_bodies({.radius_x = 0.25, .radius_y = inf}, {.radius_x = -0.3, .radius_y = 0.46});
  CHECK(t.x_touch == 0);
  CHECK(t.gap(0.01, 0.02) == Approx(0.5 * (4 - 1 / 0.3) * 1e-4 + 0.5 / 0.46 * 4e-4).epsilon(1e-12));
  // Crossed cylinders of one radius are a sphere, in any direction.
  CHECK(std::isinf(t.x_min));  // bodies by radii have no ends
  CHECK(std::isinf(t.x_max));
  CHECK(t.x_min < t.x_max);
  const TouchingBodies crossed = join_bodies({.radius_x = 1, .radius_y = inf},
                                             {.radius_x = 1, .radius_y = inf}, std::acos(0.0));
  CHECK(crossed.gap(0.01, 0.0) == Approx(0.5e-4));
  CHECK(crossed.gap(0.006, 0.008) == Approx(0.5e-4));
}

TEST_CASE("unit: profiles touch where their depths add to least, and solve like radii") {
  // A rail of 0.3 m crown radius with its summit at x = 0.01 and a conical wheel of slope 1/20:
  // they touch where the rail's slope is the wheel's, x - 0.01 = 0.3 sin(atan(1/20)).
  DepthPoints cone{Eigen::VectorXd::LinSpaced(50, -0.05, 0.06), {}};
  cone.depth = -cone.x / 20;
  const Body rail{.profile = circle(0.3, 0.01, 0.002), .radius_y = inf};
  const Body wheel{.profile = cone, .radius_y = 0.46};
  const TouchingBodies t = join_bodies(rail, wheel);
  CHECK(t.x_touch == Approx(0.01 + 0.3 * std::sin(std::atan(0.05))).epsilon(1e-6));
  CHECK(t.gap(0, 0) == Approx(0).margin(1e-12));
  CHECK(std::isinf(t.gap(0.1, 0)));
  const double modulus = 1.1e11, delta = 5e-5;
  CgFftOptions options;
  options.nx = options.ny = 64;
  options.search = t.search;
  const NormalContact c = solve_cg_fft(t.gap, delta, modulus, options).contact;
  // The arc is not a parabola: its curvature where they touch is cos^-3 of the slope's angle over
  // the radius.
  const double across = 0.5 / 0.3 / std::pow(std::cos(std::atan(0.05)), 3);
  const HertzContact h = hertz_from_approach({across, 0.5 / 0.46, 0}, modulus, delta);
  CHECK(c.converged);
  CHECK(c.force == Approx(h.force).epsilon(1e-3));
  CHECK(c.p_max == Approx(h.p_max).epsilon(1e-3));
}

TEST_CASE("unit: two summits are two patches") {
  DepthPoints two{Eigen::VectorXd::LinSpaced(401, -0.03, 0.03), Eigen::VectorXd(401)};
  for (int k = 0; k < 401; ++k)
    two.depth[k] =
        1e-4 * (1 - std::cos(2 * 3.14159265358979 * two.x[k] / 0.02)) + 1e-7 * (two.x[k] + 0.02);
  const TouchingBodies t = join_bodies({.profile = two, .radius_y = 0.5}, {});
  CgFftOptions options;
  options.nx = 180, options.ny = 45;
  options.search = t.search;
  const NormalContact c = solve_cg_fft(t.gap, 1e-5, 1.1e11, options).contact;
  CHECK(c.converged);
  CHECK(c.x_max - c.x_min > 0.038);
  CHECK((c.x.array() + t.x_touch).abs().minCoeff() < 0.003);
}

TEST_CASE("unit: thinned profiles are two, of half the points, and none without profiles") {
  const Body rail{.profile = circle(0.3, 0, 0), .radius_y = inf};
  const Body wheel{.radius_x = inf, .radius_y = 0.46};
  const auto thinned = join_thinned(rail, wheel);
  REQUIRE(thinned.size() == 2);
  for (const TouchingBodies& t : thinned)
    CHECK(t.gap(0.005, 0.001) == Approx(join_bodies(rail, wheel).gap(0.005, 0.001)).epsilon(1e-4));
  CHECK(join_thinned(wheel, {.radius_x = 0.3, .radius_y = inf}).empty());
}

TEST_CASE("unit: rounded points move the first touch by no more than their scatter says") {
  // A radius of 0.3 m, rounded, at forty places of its summit between two points: the touch is off
  // by what the points happen to be.
  for (const double digit : {1e-8, 1e-7, 1e-6}) {
    int covered = 0, beyond_third = 0;
    for (int k = 0; k < 40; ++k) {
      DepthPoints p{Eigen::VectorXd::LinSpaced(401, -0.01, 0.01), Eigen::VectorXd(401)};
      const double summit = 5e-5 * k / 40 + 1e-4 * k;
      for (Eigen::Index n = 0; n < 401; ++n) {
        const double x = p.x[n] - summit;
        p.depth[n] = std::round((0.3 - std::sqrt(0.09 - x * x) + 0.37 * digit * k) / digit) * digit;
      }
      const Body one{p}, two{std::nullopt, 1e6, 0.46};
      const TouchingBodies touching = join_bodies(one, two);
      // The gap on average beside the touch, less the circle's.
      double mean = 0;
      for (int i = -20; i <= 20; ++i) {
        const double x = summit - touching.x_touch + 2e-4 * i, t = 2e-4 * i;
        mean += (touching.gap(x, 0) - (0.3 - std::sqrt(0.09 - t * t))) / 41;
      }
      const double scatter = touch_scatter(one, two);
      CHECK(scatter < 2 * digit);
      covered += std::abs(mean) <= scatter;
      beyond_third += std::abs(mean) > scatter / 3;
    }
    INFO("digit " << digit << ": covered " << covered << ", beyond a third of it " << beyond_third);
    CHECK(covered >= 38);
    CHECK(beyond_third >= 4);
  }
  const Body round{std::nullopt, 0.3, 0.46};
  CHECK(touch_scatter(round, round) == 0);
}
