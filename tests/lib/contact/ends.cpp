// The errors stated for the ends of a contact and for the place of first touch: they cover the
// truth of Hertz's contacts, and what a grid twice as fine finds in others.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include <railbook/contact/bodies.hpp>
#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/units/constants.hpp>

#include "support/cg_fft_cells.hpp"

using namespace railbook;
using namespace railbook::contact;

namespace {

constexpr double modulus = 1.1e11;

struct Covered {
  int ends = 0, within = 0;
  double largest = 0;  // stated error over the semi-axis

  void add(double off, double stated, double half) {
    ++ends, within += off <= stated;
    largest = std::max(largest, stated / half);
  }
};

// Ellipses of any slenderness to 1:10, along the cells or turned to them.
Covered hertz_ends(std::uint64_t seed, int cases, bool turned, Eigen::Index n) {
  const num::RandomSource random{seed, 39};
  std::uint64_t i = 0;
  Covered covered;
  for (int k = 0; k < cases; ++k) {
    const double ratio = std::pow(10, (turned ? 1.0 : 2.0) * (random.uniform(i++) - 0.5)),
                 angle = turned ? units::pi * random.uniform(i++) : 0,
                 approach = std::pow(10, -5 + random.uniform(i++)), a = 1.25, b = a * ratio;
    const double c = std::cos(angle), s = std::sin(angle);
    const Gap gap = [=](double x, double y) {
      const double u = c * x + s * y, v = c * y - s * x;
      return a * u * u + b * v * v;
    };
    const NormalContact found = solve_cg_fft(gap, approach, modulus, cells(n, n)).contact;
    const HertzContact h = hertz_from_approach({a, b}, modulus, approach);
    const double x = std::hypot(h.a * c, h.b * s), y = std::hypot(h.a * s, h.b * c);
    for (const double end : {found.x_max, -found.x_min})
      covered.add(std::abs(end - x), found.x_end_error, x);
    for (const double end : {found.y_max, -found.y_min})
      covered.add(std::abs(end - y), found.y_end_error, y);
  }
  return covered;
}

}  // namespace

TEST_CASE("property: the errors of a contact's ends cover Hertz's ellipse") {
  for (const bool turned : {false, true})
    for (const Eigen::Index n : {24, 64, 127}) {
      const Covered covered = hertz_ends(2026, n > 100 ? 25 : 50, turned, n);
      CAPTURE(turned, n, covered.within, covered.ends, covered.largest);
      CHECK(covered.within >= 0.97 * covered.ends);
      CHECK(covered.largest < 2.5 / static_cast<double>(n));  // about a cell, and no more
    }
}

TEST_CASE("property: a grid twice as fine moves no end by more than the stated errors") {
  // A flat top, a jump of the curvature, and two summits.
  const std::array<Gap, 3> gaps{
      [](double x, double y) { return 2e5 * x * x * x * x + y * y; },
      [](double x, double y) { return (x > 0 ? 5.0 : 0.8) * x * x + y * y; },
      [](double x, double y) {
        const double u = std::abs(x) - 4e-3;
        return 2.5 * u * u + y * y;
      }};
  for (const Gap& gap : gaps)
    for (const double approach : {1e-5, 3e-5, 1e-4}) {
      CgFftOptions options = cells(64, 64);
      options.search = [](double) { return Box{-0.02, 0.02, -0.02, 0.02}; };
      const NormalContact coarse = solve_cg_fft(gap, approach, modulus, options).contact;
      options.nx = options.ny = 128;
      const NormalContact fine = solve_cg_fft(gap, approach, modulus, options).contact;
      CAPTURE(&gap - gaps.data(), approach, coarse.x_end_error, coarse.y_end_error, coarse.reason);
      const double x = coarse.x_end_error + fine.x_end_error,
                   y = coarse.y_end_error + fine.y_end_error;
      CHECK(std::abs(coarse.x_min - fine.x_min) < x);
      CHECK(std::abs(coarse.x_max - fine.x_max) < x);
      CHECK(std::abs(coarse.y_min - fine.y_min) < y);
      CHECK(std::abs(coarse.y_max - fine.y_max) < y);
    }
}

// A circle's points, rounded: the spline through them touches where they happen to be high.
TEST_CASE("property: the error of the place of first touch covers that of rounded points") {
  const num::RandomSource random{39, 5};
  std::uint64_t i = 0;
  int within = 0, cases = 0;
  double largest = 0;
  for (const double quantum : {0.0, 1e-9, 1e-8, 1e-7, 1e-6})
    for (int k = 0; k < 40; ++k) {
      const double place = 1e-3 * (random.uniform(i++) - 0.5),
                   radius = 0.2 + 0.3 * random.uniform(i++);
      DepthPoints p{Eigen::VectorXd::LinSpaced(81, -0.02, 0.02), Eigen::VectorXd(81)};
      for (Eigen::Index n = 0; n < 81; ++n) {
        const double depth = std::pow(p.x[n] - place, 2) / (2 * radius);
        p.depth[n] = quantum > 0 ? quantum * std::round(depth / quantum) : depth;
      }
      const Body body{.profile = p}, wheel{.radius_y = 0.46};
      const TouchingBodies bodies = join_bodies(body, wheel);
      const double stated = touch_place_error(bodies, touch_scatter(body, wheel));
      ++cases, within += std::abs(bodies.x_touch - place) <= stated;
      if (quantum == 0) largest = std::max(largest, stated);
    }
  CAPTURE(cases, within, largest);
  CHECK(within >= 0.97 * cases);
  CHECK(largest < 1e-6);  // of exact points
  CHECK(touch_place_error(join_bodies({.radius_x = 0.3}, {.radius_y = 0.46}), 1e-6) == 0);
}
