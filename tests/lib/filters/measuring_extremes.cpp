#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/complementary.hpp>
#include <railbook/filters/geometry_chain.hpp>
#include <railbook/filters/hybrid_filter.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::spectra;
using namespace railbook::filters;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::nan("");

}  // namespace

TEST_CASE("Filters meet NaN, infinity and impossible intervals without a trap") {
  const NoFpFault no_fault;
  const std::vector<double> values{0, 1, nan_value, infinity, -infinity, 1e300, -1e300, 1e-320};
  const std::vector<double> intervals{0.03, 0, -1, nan_value, infinity, 1e-320, 1e300, 1e-9, 3600};
  for (const auto how :
       {Decay::exact, Decay::linear, Decay::reciprocal, Decay::pade11, Decay::pade22}) {
    FirstOrderHybrid c{6, how};
    SecondOrderHybrid g{{6, 1}, {.how = how}}, local{{6, 1}, {.local = true}}, complex{{6, 0.5}},
        real{{6, 30}};
    ComplementaryFilter roll{0.5, 3};
    for (const double a : values)
      for (const double b : intervals)
        for (const double later : intervals) {
          for (auto* filter : {&g, &local, &complex, &real}) {
            (void)filter->push(0.5 * (std::isfinite(a) ? std::min(std::abs(a), 1e6) : a), b);
            (void)filter->push(1, later);
          }
          (void)c.push(std::isfinite(a) ? std::min(std::abs(a), 1e6) : a, b);
          (void)c.push(1, later);
          (void)roll.push(a, 0.1, b);
          (void)roll.push(0.1, std::isfinite(a) ? 0.01 : a, later);
        }
    // And right again at once.
    for (int k = 0; k < 4; ++k) {
      const double u = c.push(2, 0.03), m = g.push(2, 0.03).mean, n = complex.push(2, 0.03).mean;
      if (k == 3) {
        CHECK(u == 2);
        CHECK(m == 2);
        CHECK(n == 2);
      }
    }
  }
}

TEST_CASE("A stop: C forgets in one sample, G in two") {
  FirstOrderHybrid c{6};
  SecondOrderHybrid g{{6, 1}};
  for (int k = 0; k < 10; ++k) {
    c.push(1e6, 0.1);
    g.push(1e6, 0.1);
  }
  CHECK(c.push(3, infinity) == 3);
  CHECK(g.push(3, infinity).mean == 3);
  CHECK(c.push(3, 0.1) == 3);
  CHECK(g.push(3, 0.1).mean == 3);
  ComplementaryFilter roll{0.5, 2};
  roll.push(1, 0, 0.1);
  CHECK(roll.push(0.25, 17, infinity) == 0.25);
}

TEST_CASE("Complex poles after a long interval are refused, and good again afterwards") {
  SecondOrderHybrid g{{6, 0.5}};
  g.push(1, 0.1);
  g.push(1, 0.1);
  CHECK(g.push(1, 0.1).mean == 1);
  CHECK(std::isnan(g.push(1, 100).mean));
  CHECK(std::isnan(g.push(1, 0.1).mean));
  CHECK(g.push(1, 0.1).mean == 1);
}

TEST_CASE("The stream meets NaN, infinity and huge samples without a trap, and forgets them") {
  const NoFpFault no_fault;
  std::vector<double> x(4000, 1e-5);
  x[1500] = nan_value;
  x[1501] = infinity;
  x[1502] = -infinity;
  x[1503] = 1e308;
  x[1504] = -1e308;
  const Geometry g = geometry(x);
  CHECK(std::isnan(g.chord[1500 - 330]));
  CHECK(std::isnan(g.chord[1504 + 330]));
  CHECK(std::abs(g.chord[1500 - 331]) < 1e-12);
  CHECK(std::abs(g.chord[1504 + 331]) < 1e-12);
  CHECK(g.space_curve[1500 - 300] == Approx(0.076).epsilon(1e-9));
  CHECK(std::isnan(g.space_curve[1500 - 299]));
}

TEST_CASE("A record of NaN gives NaN, in bounded memory") {
  const NoFpFault no_fault;
  const std::vector<double> nothing(100000, nan_value);
  std::size_t numbers = 0, outputs = 0;
  GeometryChain chain{{}, [&](std::span<const double> s, std::span<const double> c) {
                        outputs += c.size();
                        for (std::size_t i = 0; i < c.size(); ++i)
                          numbers += !std::isnan(s[i]) || !std::isnan(c[i]);
                      }};
  chain.push(nothing);
  const std::size_t before = chain.memory();
  for (int i = 0; i < 5; ++i) chain.push(nothing);
  CHECK(chain.memory() == before);
  chain.finish();
  CHECK(outputs == 600000);
  CHECK(numbers == 0);
  CHECK(chain.masked() == 600000);
}

TEST_CASE("An empty stream, and one shorter than its window, give no numbers") {
  for (const std::size_t n : {0UL, 1UL, 660UL}) {
    std::size_t numbers = 0, outputs = 0;
    GeometryChain chain{{}, [&](auto, std::span<const double> c) {
                          outputs += c.size();
                          for (const double v : c) numbers += !std::isnan(v);
                        }};
    chain.push(std::vector<double>(n, 1e-4));
    chain.finish();
    CHECK(outputs == n);
    CHECK(numbers == 0);
  }
}

TEST_CASE("Rounding of the stream does not grow with the record") {
  std::vector<double> x(65536);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = 1e-4 * std::sin(0.7 * static_cast<double>(k));
  double early = 0, late = 0;
  std::size_t count = 0;
  GeometryChain chain{{}, [&](std::span<const double>, std::span<const double> c) {
                        for (const double v : c) {
                          ++count;
                          if (std::isnan(v)) continue;
                          (count < 200000 ? early : late) =
                              std::max(count < 200000 ? early : late, std::abs(v));
                        }
                      }};
  for (int i = 0; i < 40; ++i) chain.push(x);
  CHECK(late == Approx(early).epsilon(1e-9));
}

TEST_CASE("Long chords and long high-passes") {
  const std::vector<double> x(70001, 1e-9);
  const Geometry g = geometry(
      x, {.half_chord = 10000, .high_pass = {.length = 10001, .passes = 3}, .block = 40000});
  CHECK(std::abs(g.chord[35000]) < 1e-9);
  CHECK(g.space_curve[35000] == Approx(1e-9 * 3 * (10001.0 * 10001.0 - 1) / 12).epsilon(1e-6));
}

TEST_CASE("The stream's memory is that of its blocks") {
  // What comes in and what goes out, the curve on the way, a copy of it for a second stage, and a
  // row of halves for each pass; a place for each hole.
  const std::size_t block = 400000;
  for (const int stages : {1, 2})
    for (const int passes : {1, 3})
      for (const bool holes : {false, true}) {
        GeometryChain chain{{.half_chord = 3, .high_pass = {5, passes, stages}, .block = block},
                            [](auto, auto) {}};
        const std::vector<double> x(block + 2 * chain.reach(), holes ? nan_value : 0);
        chain.push(x);
        const double doubles = double(chain.memory()) / double(sizeof(double) * block);
        const double known = 2 + stages + passes;
        if (holes)
          CHECK((doubles > known + 0.99 && doubles < known + 2.01));
        else
          CHECK(doubles == Approx(known).epsilon(0.001));
      }
}
