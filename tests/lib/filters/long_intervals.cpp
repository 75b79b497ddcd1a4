// Intervals from far below the filter's time constant to far above it: where one formula hands over
// to another.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <limits>

#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/complementary.hpp>
#include <railbook/filters/geometry_chain.hpp>
#include <railbook/filters/hybrid_filter.hpp>

using namespace railbook::filters;
using Complex = std::complex<double>;

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();

// What three samples give, with these intervals before the second and the third.
double mean_of(const SecondOrderLowPass& f, double before, double after,
               const SecondOrderOptions& options = {}) {
  SecondOrderHybrid g{f, options};
  (void)g.push(0.3, 1);
  (void)g.push(-0.7, before);
  return g.push(1.1, after).mean;
}
}  // namespace

TEST_CASE("property: the second filter's samples have the response of its formula, fast and slow") {
  for (const double damping : {0.3, 0.7, 1.0, 2.5})
    for (const double T : {0.02, 0.5, 1.2, 2.7, 5.0, 30.0, 250.0, 400.0, 1e4})
      for (const double theta : {0.3, 1.7, 3.0}) {
        const SecondOrderLowPass f{1, damping};
        SecondOrderHybrid real{f}, imaginary{f};
        Complex out;
        for (int k = 0; k < 3; ++k)
          out = {real.push(std::cos(theta * k), T).mean,
                 imaginary.push(std::sin(theta * k), T).mean};
        const Complex gain = second_order_digital(f, T, theta);
        CAPTURE(damping, T, theta);
        CHECK(std::abs(out / std::polar(1.0, 2 * theta) - gain) < 1e-10 * std::abs(gain));
      }
}

TEST_CASE("property: the second filter has no jump where its formulas change hands") {
  for (const double damping : {1.0, 1 + 1e-7, 1.2, 4.0}) {
    const SecondOrderLowPass f{2, damping};
    const double s = f.damping * f.omega;
    const double slow = f.omega / (damping + std::sqrt(damping * damping - 1));
    for (const double after : {0.01, 0.4, 3.0}) {
      CAPTURE(damping, after);
      const auto near = [&](double before, double step) {
        const double below = mean_of(f, before * (1 - step), after),
                     above = mean_of(f, before * (1 + step), after);
        return below == Approx(above).epsilon(100 * step);
      };
      CHECK(near(20 / s, 1e-9));
      CHECK(near(300 / slow, 1e-9));
      // Beyond, the sample before the last but one is forgotten; q(t) = exp(-s t) sinh(w t)/w takes
      // out both modes.
      const double long_ago = 310 / slow, w = f.omega * std::sqrt(damping * damping - 1);
      const double ratio = w == 0 ? 1 + after / long_ago
                           : w * long_ago < 99
                               ? std::sinh(w * (after + long_ago)) / std::sinh(w * long_ago)
                               : std::exp(w * after);
      const double alpha = std::exp(-s * after) * ratio;
      CHECK(mean_of(f, long_ago, after) == Approx(1.1 + alpha * 1.8 / (1 - alpha)).epsilon(1e-9));
      CHECK(mean_of(f, infinity, after) == Approx(mean_of(f, 1e15, after)).epsilon(1e-9));
      CHECK(near(1.0, 1e-9));
    }
    CHECK(mean_of(f, 0.5, 301 / slow) == 1.1);  // all is forgotten
    CHECK(mean_of(f, 0.5, infinity) == 1.1);
  }
  CHECK(std::isnan(mean_of({2, 0.5}, 1e4, 0.3)));  // complex poles, half a period gone
  CHECK(std::isnan(mean_of({2, 0.5}, 1.9, 0.3)));
  CHECK(std::isfinite(mean_of({2, 0.5}, 1.7, 0.3)));  // half a period is 1.81
  CHECK(std::isnan(mean_of({2, 0.5}, 0.3, 1.9)));
}

TEST_CASE("property: the second filter with an approximate decay is near the exact one") {
  for (const double before : {0.05, 0.11})
    for (const double after : {0.04, 0.13}) {
      const double exact = mean_of({2, 1}, before, after);
      // The area is of the order of 4 before after: what the decay misses shows divided by it.
      CHECK(mean_of({2, 1}, before, after, {.how = Decay::pade22}) == Approx(exact).epsilon(1e-4));
      CHECK(mean_of({2, 1}, before, after, {.how = Decay::pade11}) == Approx(exact).epsilon(0.1));
      const double same = mean_of({2, 1}, after, after);
      CHECK(mean_of({2, 1}, before, after, {.local = true}) == same);
    }
  CHECK(std::isnan(mean_of({1, 1}, 0.5, infinity, {.how = Decay::linear})));
  CHECK(std::isnan(mean_of({1, 1}, 1, 1e151, {.how = Decay::linear})));  // a factor of -1e302
  CHECK(std::isfinite(mean_of({1, 1}, infinity, 0.5, {.how = Decay::reciprocal})));
}

TEST_CASE("property: faults of the encoder are passed over, or begin anew") {
  const double nan = std::nan("");
  FirstOrderHybrid c{3};
  CHECK(std::isnan(c.push(1, nan)));
  const double first = c.push(2, 0.1);
  CHECK(first == Approx(2 + 1 / std::expm1(0.3)));
  CHECK(std::isnan(c.push(5, 0)));     // a second pulse
  CHECK(c.push(2, 0.1) == 2);          // 2 before it, 2 after it
  CHECK(std::isnan(c.push(7, -0.1)));  // anew
  CHECK(c.push(8, 0.1) == Approx(8 + 1 / std::expm1(0.3)));
  CHECK(std::isnan(c.push(nan, 0.1)));
  CHECK(std::isnan(c.push(3, 0.1)));
  CHECK(c.push(4, 0.1) == Approx(4 + 1 / std::expm1(0.3)));
  CHECK(c.push(9, infinity) == 9);
  c.restart();
  CHECK(std::isnan(c.push(9, 0.1)));
  CHECK_FALSE(possible_interval(1e-10));
  CHECK(possible_interval(1.01e-10));
  CHECK_FALSE(possible_interval(nan));

  SecondOrderHybrid g{{3, 1}};
  CHECK(std::isnan(g.push(1, 0.1).mean));
  CHECK(std::isnan(g.push(2, 0.2).mean));
  const double good = g.push(4, 0.1).mean;
  CHECK(std::isfinite(good));
  CHECK(std::isnan(g.push(5, 0).mean));
  const TwoIntervals next = g.push(4, 0.3);
  CHECK(std::isfinite(next.mean));
  CHECK(next.T_before == 0.1);
  CHECK(next.T_after == 0.3);
  CHECK(std::isnan(g.push(nan, 0.1).mean));
  CHECK(std::isnan(g.push(1, 0.1).mean));
  CHECK(std::isnan(g.push(1, 0.1).mean));
  CHECK(g.push(1, 0.1).mean == 1);
  CHECK(std::isnan(g.push(1, -1).mean));
  CHECK(std::isnan(g.push(1, 0.1).mean));
  CHECK(g.push(1, 0.1).mean == 1);
  g.restart();
  CHECK(std::isnan(g.push(1, 0.1).mean));

  // The complementary filter: inclination, increment, T, and what comes out. It halves what it knew
  // in T.
  ComplementaryFilter roll{1 / std::log(2.0)};
  const double row[][4] = {{3, 5, 1, 3},     {5, 0, 1, 4},     {7, 1, 1, 6},       {7, 1, 0, nan},
                           {8, 0, 1, 7},     {nan, 0, 1, nan}, {2, 9, 1, 2},       {4, 0, 1, 3},
                           {9, 1, -1, nan},  {11, 0, 1, 10},   {6, nan, 1, nan},   {8, 0, 1, 7},
                           {1, 0, nan, nan}, {3, 0, 1, 2},     {5, 7, infinity, 5}};
  for (const auto& [inclination, increment, T, expected] : row) {
    const double found = roll.push(inclination, increment, T);
    CAPTURE(inclination, increment, T, found);
    CHECK((std::isnan(expected) ? std::isnan(found) : found == Approx(expected)));
  }
  for (const auto& [T, increment, expected] :
       {std::tuple{0.0, 1.0, 4.0}, {-1.0, 1.0, nan}, {nan, 1.0, nan}, {1.0, nan, nan}}) {
    roll.restart();
    const double found = roll.push(4, increment, T);
    CHECK((std::isnan(expected) ? std::isnan(found) : found == expected));
    CHECK(roll.push(6, 0, 1) == Approx(5));
  }

  CHECK(std::isnan(short_chord({nan, 1, 1})));
  CHECK(std::isnan(short_chord({1, infinity, 1})));
  CHECK(std::isnan(short_chord({1, 1, infinity})));
}

TEST_CASE("property: a hole in short chords spoils as much as the weights reach, and no more") {
  for (const int half : {1, 2, 7})
    for (const std::size_t hole : {0UL, 3UL, 20UL, 39UL}) {
      std::vector<double> x(40, 1.0);
      x[hole] = std::nan("");
      if (hole == 20) x[22] = -infinity;
      const auto found = to_chord(x, half);
      const std::size_t width = 2 * static_cast<std::size_t>(half) - 1;
      REQUIRE(found.offset.size() == x.size() - width + 1);
      for (std::size_t i = 0; i < found.offset.size(); ++i) {
        bool spoilt = false;
        for (std::size_t j = 0; j < width; ++j) spoilt |= !std::isfinite(x[i + j]);
        CHECK(std::isnan(found.offset[i]) == spoilt);
        if (!spoilt) CHECK(found.offset[i] == half * half);
      }
    }
}

TEST_CASE("property: the shortest chain of all loses one sample at each end of its chord") {
  const std::vector<double> x{0.1, -0.2, 0.3, 0.1, 0.4, -0.1, 0.5, 0.2};
  const Geometry found = geometry(x, {.half_chord = 1, .high_pass = {3, 1}});
  REQUIRE(found.chord.size() == x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    CHECK(std::isfinite(found.space_curve[i]));
    CHECK(std::isnan(found.chord[i]) == (i == 0 || i + 1 == x.size()));
  }
}
