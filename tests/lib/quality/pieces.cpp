// The pieces behind the index, each by its definition.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/quality/bump_stops.hpp>
#include <railbook/quality/descriptor_filter.hpp>
#include <railbook/quality/spreading.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::quality;

namespace {
const ForceLimit force{make_car(800, 7000, {2, 0.5}), 143e3};
Envelope envelope_at(double speed) {
  return Envelope{{stroke_limit_of_level({0.5, 0.2}, 0.016), force, speed}};
}
}  // namespace

TEST_CASE("unit: the weights are the inverse transform, tapered, without a mean") {
  const Envelope envelope = envelope_at(20);
  const double spacing = 0.5, shortest = 3;
  const filters::FilterTaps taps = design_filter(envelope, {spacing, shortest, 40});
  REQUIRE(taps.half.size() == 81);
  // By Gauss's rule over the wavenumbers; the grid of the transform is as fine as the kinks of the
  // gain allow.
  const num::GaussRule rule = num::gauss_legendre(24);
  const auto weight = [&](std::size_t j) {
    double sum = 0;
    for (int panel = 0; panel < 400; ++panel)
      for (Eigen::Index i = 0; i < rule.x.size(); ++i) {
        const double half = 0.5 / (2 * spacing) / 400;
        const double phi = half * (2 * panel + 1 + rule.x[i]);
        sum += 2 * half * rule.w[i] * filter_gain(envelope, shortest, phi) *
               std::cos(2 * units::pi * phi * spacing * static_cast<double>(j));
      }
    return spacing * sum;
  };
  const auto taper = [](std::size_t j) {
    const double u = static_cast<double>(j) / 81;
    return u <= 0.5 ? 1 : std::pow(std::sin(units::pi * u), 2);
  };
  std::vector<double> wanted(81);
  double sum = 0, tapers = 0;
  for (std::size_t j = 0; j <= 80; ++j) {
    wanted[j] = taper(j) * weight(j);
    sum += (j == 0 ? 1 : 2) * wanted[j];
    tapers += (j == 0 ? 1 : 2) * taper(j);
  }
  double level = taps.half[0];
  for (std::size_t j = 0; j <= 80; ++j) {
    CHECK(taps.half[j] == Approx(wanted[j] - taper(j) * sum / tapers).margin(1e-4 * taps.half[0]));
    if (j > 0) level += 2 * taps.half[j];
  }
  CHECK(std::abs(level) < 1e-13 * taps.half[0]);
  CHECK(filter_gain(envelope, 3, 0.8 / 3) == envelope(0.8 / 3));
  CHECK(filter_gain(envelope, 3, 0.9 / 3) == Approx(0.5 * envelope(0.3)));
  CHECK(filter_gain(envelope, 3, 0.85 / 3) ==
        Approx(std::pow(std::cos(units::pi / 8), 2) * envelope(0.85 / 3)));
  CHECK(filter_gain(envelope, 3, 1.0 / 3) == 0);
  CHECK(filter_gain(envelope, 3, 2) == 0);
  for (const std::size_t n : {8U, 9U})
    CHECK(impulse_response(envelope, spacing, 0, n).size() == n / 2 + 1);
  CHECK_THROWS_AS(impulse_response(envelope, 0, 0, 8), InputError);
  CHECK_THROWS_AS(design_filter(envelope, {0.5, 0.99, 40}), InputError);
  CHECK_NOTHROW(design_filter(envelope, {0.5, 1, 40}));
  CHECK_THROWS_AS(design_filter(envelope, {0.5, 0, 3.9}), InputError);
  // Without a reach, twenty times the longest resonant wave: 20 m/s over 0.5 Hz.
  CHECK(design_filter(envelope, {.spacing = 2}).half.size() == 401);
}

TEST_CASE("unit: there is a lower corner only with both limits, and a speed") {
  const Envelope both = envelope_at(20);
  CHECK(lower_corner(both.descriptor()) > 0);
  CHECK(lower_corner({both.descriptor().stroke, {}, 20}) == 0);
  CHECK(lower_corner({{}, force, 20}) == 0);
  CHECK(lower_corner({both.descriptor().stroke, force, 0}) == 0);
  // The corner goes with the speed: one frequency.
  CHECK(lower_corner(envelope_at(40).descriptor()) ==
        Approx(2 * lower_corner(both.descriptor())).epsilon(1e-9));
}

TEST_CASE("unit: the balance of energy is judged by the larger of what went in and what was held") {
  CHECK(Energy{}.defect() == 0);
  CHECK(Energy{2, 1, 0.5, 0.1}.defect() == Approx(0.25));
  CHECK(Energy{-2, -1, -1.5, 1}.defect() == Approx(0.25));
  CHECK(Energy{2, 1, 0.5, 4}.defect() == Approx(0.125));
  CHECK(Energy{0, 0, 0.5, 5}.defect() == Approx(0.1));
}

TEST_CASE("unit: the mean square of a settled stroke is half its square, and only when asked for") {
  const StoppedBody body{{0.7, 0.3}, std::numeric_limits<double>::infinity(), 0};
  const Track track{{{0.01, 0.5, 0.2}}, 0};
  const RunOptions options{.watch_from = 60, .audit = true};
  const Run audited = run(body, track, at_rest(track), 60 + 20, options);
  CHECK(audited.mean_square == Approx(0.5 * audited.largest * audited.largest).epsilon(1e-6));
  const Run plain = run(body, track, at_rest(track), 80, {.watch_from = 60});
  CHECK(plain.mean_square == 0);
  CHECK(plain.energy.input == 0);
  CHECK(plain.energy.lost == 0);
  CHECK(plain.largest == audited.largest);
  CHECK(plain.largest_at > 60);
}

TEST_CASE("unit: the track's rate is the derivative of its height, on the ramp and behind it") {
  const Track track{{{0.01, 0.5, 0.2}, {0.003, 1.7, 2}}, 5};
  CHECK(height(track, 0) == 0);
  for (const double t : {0.3, 2.0, 4.9, 5.1, 9.0}) {
    const double h = 1e-5;
    CHECK(wheel_rate(track, t) ==
          Approx((height(track, t + h) - height(track, t - h)) / (2 * h)).epsilon(1e-6));
  }
  CHECK(height(track, 2.5) == Approx(0.5 * (0.01 * std::sin(2.5 * units::pi + 0.2) +
                                            0.003 * std::sin(8.5 * units::pi + 2))));
  CHECK(at_rest(track).v == Approx(-(0.01 * std::sin(0.2) + 0.003 * std::sin(2.0)) / 5));
  CHECK(at_rest({track.waves, 0}).v == 0);
}

TEST_CASE(
    "unit: spreading leaves the area and the mean, and adds to the variance what diffusion adds") {
  Histogram start{-3, 0.05, std::vector<double>(121, 0.0)};
  for (std::size_t i = 0; i < 121; ++i)
    start.height[i] = std::exp(-2 * start.x(i) * start.x(i)) * (1 + 0.2 * start.x(i));
  const Spread done = spread({0.2, 0}, start, 1, 2, 40);
  CHECK(done.converged);
  CHECK(area(done.profile) == Approx(area(start)).epsilon(1e-13));
  CHECK(mean(done.profile) == Approx(mean(start)).margin(1e-4));
  CHECK(std::pow(deviation(done.profile), 2) ==
        Approx(std::pow(deviation(start), 2) + 2 * 0.2).epsilon(1e-3));
  // A linear law takes two solutions a step and one that sees that it has arrived.
  CHECK(done.iterations <= 4 * 40);
  for (const auto& bad : {Histogram{0, 0, {1, 1, 1}}, Histogram{0, 1, {1, 1}}})
    CHECK_THROWS_AS(spread({}, bad, 1, 2, 1), InputError);
  CHECK_THROWS_AS(spread({}, start, 2, 2, 1), InputError);
  CHECK_THROWS_AS(spread({}, start, 0, 2, 1), InputError);
  CHECK_THROWS_AS(spread({}, start, 1, 2, 0), InputError);
  CHECK_THROWS_AS(spread({0, 3}, start, 1, 2, 1), InputError);
  CHECK(blob_height(blob_front(3), 3) == 0);
  CHECK(blob_height(-1.01 * blob_front(3), 3) == 0);
  CHECK(blob_height(0.999 * blob_front(3), 3) > 0);
}
