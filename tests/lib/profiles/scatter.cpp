// The scatter of measured points: found where there is some, and without effect where there is
// none.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/random_stream.hpp>
#include <railbook/profiles/measured_curve.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/conicity.hpp>
#include <railbook/wheelset/paper_pairs.hpp>
#include <railbook/wheelset/tabulate.hpp>

#include "support/sampled_curve.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;
using num::RandomStream;

namespace {

// A coned or hollow tread with a throat, a flange and its tip.
Curve any_wheel(RandomStream& draw) {
  const double cone = draw(0.01, 0.08), hollow = cone + draw(0.02, 0.1);
  return chain({-0.06, 0}, cone,
               {line(draw(0.03, 0.06)), arc(draw(0.2, 0.5), hollow), arc(draw(0.012, 0.025), 1.2),
                line(0.008), arc(-draw(0.01, 0.015), -0.5)});
}
// A crowned head.
Curve any_rail(RandomStream& draw) {
  const double crown = draw(0.06, 0.1);
  return chain({-0.033, -0.004}, -0.4,
               {arc(draw(0.03, 0.05), -crown), arc(draw(0.2, 0.35), crown),
                arc(draw(0.025, 0.05), 0.45), arc(draw(0.008, 0.012), 1.4), line(0.012)});
}

double conicity_of(const std::vector<Point>& wheel, const std::vector<Point>& rail,
                   double times_scatter) {
  const auto met = [&](const std::vector<Point>& points) {
    return measured_curve(points, times_scatter * scatter(points)).curve;
  };
  const auto pair = with_radius(placed_wheel(met(wheel), 0.745),
                                placed_rail(met(rail), 1.435, 0.014, 0.025), 0.46);
  return conicity(tabulate(pair, {.half_spacing = 0.75, .end = 3e-3, .step = 0.25e-3}), 3e-3)
      .kinematic;
}

}  // namespace

TEST_CASE("Scatter: normal noise, rounding, and none") {
  RandomStream draw(7);
  for (const double step : {0.2e-3, 0.4e-3})
    for (const double noise : {1e-6, 10e-6, 50e-6}) {
      auto points = sampled(cn_pair().rail(), step);
      // Across the profile: what lies along it moves no contact.
      for (Point& p : points) {
        const double angle = cn_pair().rail().angle(p.u), off = draw.normal(noise);
        p.u += off * std::sin(angle);
        p.z += off * std::cos(angle);
      }
      std::erase_if(points, [u = points.front().u](const Point& p) mutable {
        const bool back = p.u < u;
        u = std::max(u, p.u);
        return back;
      });
      INFO("step " << step << " noise " << noise);
      CHECK(scatter(points) == Approx(noise).epsilon(0.25));
    }
  // A slope whose rounding is well mixed.
  std::vector<Point> slope;
  for (int i = 0; i < 400; ++i) {
    const double u = 0.5e-3 * i + draw(0, 0.2e-3);
    slope.push_back({u, 1e-6 * std::round(u * 0.05 / 1e-6)});
  }
  CHECK(scatter(slope) == Approx(1e-6 / std::sqrt(12)).epsilon(0.25));
  CHECK(scatter(sampled(cn_pair().wheel(), 0.5e-3)) < 1e-9);
  CHECK_THROWS_AS(scatter({{0, 0}, {1, 1}}), InputError);
}

// What a tool flags is a conicity that moves by more than 5 % and 0.005 when the smoothing is
// halved or doubled.
TEST_CASE("Scatter: smoothing by it changes no clean profile, fewer than one in a thousand",
          "[thorough]") {
  RandomStream draw(1000);
  int seen = 0, changed = 0;
  while (seen < 1000) {
    const double step = draw(0.3e-3, 1e-3);
    const auto wheel = sampled(any_wheel(draw), step), rail = sampled(any_rail(draw), step);
    double plain = 0;
    try {
      plain = conicity_of(wheel, rail, 0);
    } catch (const InputError&) {
      continue;  // the wheel does not fit between the rails, or not 3 mm far
    }
    ++seen;
    for (const double times : {3.0, 6.0}) {
      const double change = std::abs(conicity_of(wheel, rail, times) - plain);
      changed += change > 0.05 * plain && change > 0.005;
    }
  }
  CHECK(changed == 0);
}

TEST_CASE("Scatter: smoothing by three times it keeps the conicity of noisy points") {
  RandomStream draw(3);
  const auto at = [&](double noise) {
    const auto noisy = [&](std::vector<Point> points) {
      for (Point& p : points) p.z += draw.normal(noise);
      return points;
    };
    const auto met = [](const std::vector<Point>& points) {
      return measured_curve(points, 3 * scatter(points)).curve;
    };
    const auto& pair = new_wheel_pair();
    const WheelsetOnTrack measured(met(noisy(sampled(pair.wheel(), 0.5e-3))),
                                   met(noisy(sampled(pair.rail(), 0.5e-3))));
    return conicity(tabulate(measured, {.half_spacing = 0.756, .end = 4e-3, .step = 0.1e-3}), 3e-3)
        .kinematic;
  };
  const double drawn = conicity(new_wheel_table(), 3e-3).kinematic;
  for (const double noise : {0.7e-6, 3e-6, 10e-6})
    for (int i = 0; i < 5; ++i) CHECK(at(noise) == Approx(drawn).epsilon(0.12));
}
