#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/complementary.hpp>
#include <railbook/filters/geometry_chain.hpp>
#include <railbook/filters/high_pass.hpp>
#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/num/dopri5.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::filters;
using namespace railbook::spectra;
using Catch::Contains;

TEST_CASE("Running sums in integers are exact, wrapped or not") {
  std::vector<std::uint64_t> x(300);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = 0x9E3779B97F4A7C15U * (i + 1) * (i + 5);
  const auto sums = running_sum<std::uint64_t>(x, 31, 0);
  for (const std::size_t i : {0UL, 17UL, 269UL}) {
    std::uint64_t sum = 0;
    for (std::size_t j = 0; j < 31; ++j) sum += x[i + j];
    CHECK(sums.at(i) == sum);
  }
}

TEST_CASE("A second pulse in no time is passed over as if it had not come") {
  FirstOrderHybrid c{6}, c_plain{6};
  SecondOrderHybrid g{{6, 1}}, g_plain{{6, 1}};
  ComplementaryFilter roll{0.5, 2}, roll_plain{0.5, 2};
  for (int k = 0; k < 20; ++k) {
    const double y = std::sin(0.7 * k), T = 0.03 + 0.01 * (k % 3);
    const double with[] = {c.push(y, T), g.push(y, T).mean, roll.push(y, 0.02, T)};
    const double without[] = {c_plain.push(y, T), g_plain.push(y, T).mean,
                              roll_plain.push(y, 0.02, T)};
    for (int i = 0; i < 3; ++i) CHECK((with[i] == without[i] || (k < 2 && std::isnan(without[i]))));
    CHECK(std::isnan(c.push(5, 0)));
    CHECK(std::isnan(g.push(5, 0).mean));
    CHECK(std::isnan(roll.push(5, 1, 0)));
  }
}

namespace {

std::vector<double> noise(std::size_t n, std::uint64_t stream) {
  const num::RandomSource random{11, stream};
  std::vector<double> x(n);
  for (std::size_t k = 0; k < n; ++k) x[k] = 1e-4 * random.normal(k);
  return x;
}

// Largest difference of a against s b.
double difference(const std::vector<double>& a, const std::vector<double>& b, double s = 1) {
  double worst = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (std::isnan(a[i]) != std::isnan(b[i])) return 1;
    if (!std::isnan(a[i])) worst = std::max(worst, std::abs(a[i] - s * b[i]));
  }
  return worst;
}

}  // namespace

TEST_CASE("A change of speed leaves no transient: two histories, one future") {
  // Whatever came before, outputs two samples on are the same when the analog output is.
  FirstOrderHybrid a{3}, b{3};
  SecondOrderHybrid f{{3, 1}}, g{{3, 1}};
  for (int k = 0; k < 50; ++k) {
    a.push(std::sin(k), 0.1);
    f.push(std::sin(k), 0.1);
    b.push(1e3 * std::cos(k), 5);
    g.push(1e3 * std::cos(k), 5);
  }
  for (int k = 0; k < 5; ++k) {
    const double y = std::exp(-k), T = 0.2 + 0.1 * k;
    const double u = a.push(y, T), v = b.push(y, T), m = f.push(y, T).mean, n = g.push(y, T).mean;
    if (k >= 1) CHECK(u == v);
    if (k >= 2) CHECK(m == n);
  }
}

TEST_CASE("Run backwards, the stream gives the same backwards: zero phase") {
  auto x = noise(2000, 5);
  const auto forward = geometry(x).space_curve;
  std::reverse(x.begin(), x.end());
  auto backward = geometry(x).space_curve;
  std::reverse(backward.begin(), backward.end());
  CHECK(difference(forward, backward) < 1e-12);
}

TEST_CASE("The result does not depend on blocks or pieces") {
  const auto x = noise(9000, 6);
  const auto reference = geometry(x).chord;
  for (const std::size_t block : {7UL, 661UL, 5000UL, 20000UL}) {
    if (block == 7 && x.size() > 9000) continue;
    CHECK(difference(geometry(x, {.block = block}).chord, reference) < 1e-12);
  }
}

namespace {

constexpr double f1 = 2 * units::pi;  // 1 Hz

}  // namespace

TEST_CASE("A constant passes C and G unchanged, exactly") {
  FirstOrderHybrid c{f1};
  SecondOrderHybrid g{{f1, 1}};
  c.push(0.7, 1);
  g.push(0.7, 1);
  g.push(0.7, 0.3);
  for (const double T : {0.3, 1e-9, 20.0, 1e-3, 1e4, 0.01}) {
    CHECK(c.push(0.7, T) == 0.7);
    CHECK(g.push(0.7, T).mean == 0.7);
  }
}

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

namespace {

void ignore(std::span<const double>, std::span<const double>) {}

}  // namespace

TEST_CASE("Hybrid filters refuse corners that are none") {
  for (const double bad : {0.0, -1.0, std::nan(""), infinity}) {
    CHECK_THROWS_WITH(FirstOrderHybrid{bad}, Contains("corner of the filter"));
    CHECK_THROWS_WITH((SecondOrderHybrid{{bad, 1}}), Contains("corner of the filter"));
    CHECK_THROWS_WITH((SecondOrderHybrid{{1, bad}}), Contains("damping"));
  }
  CHECK_THROWS_WITH((SecondOrderHybrid{{1, 0.7}, {.how = Decay::pade11}}),
                    Contains("double pole only"));
}

TEST_CASE("Chords refuse lengths and records that cannot be") {
  const std::vector<double> x(60, 0.0);
  CHECK_THROWS_WITH(to_chord(x, 0), Contains("half chord"));
  CHECK_THROWS_WITH(to_chord(x, -3), Contains("half chord"));
  CHECK_THROWS_WITH(to_chord(x, 31), Contains("allowed: at least 61"));
  CHECK_NOTHROW(to_chord(x, 30));
  CHECK_THROWS_WITH(running_sum<double>(x, 61), Contains("samples of the record"));
}

TEST_CASE("The high-pass refuses what it is not made for") {
  CHECK_THROWS_WITH(reach({150, 4}), Contains("odd"));
  CHECK_THROWS_WITH(reach({1, 4}), Contains("length of the mean"));
  CHECK_THROWS_WITH(high_pass_gain({151, 0}, 1), Contains("passes"));
  CHECK_THROWS_WITH(high_pass_gain({151, 4, 3}, 1), Contains("stages"));
  CHECK_THROWS_WITH(space_curve_integers({10001, 4}), Contains("length^passes"));
}

TEST_CASE("The stream refuses bad options and short records") {
  CHECK_THROWS_WITH((GeometryChain{{.half_chord = 0}, ignore}), Contains("half chord"));
  CHECK_THROWS_WITH((GeometryChain{{.limit = 0}, ignore}), Contains("limit"));
  CHECK_THROWS_WITH((GeometryChain{{.limit = infinity}, ignore}), Contains("limit"));
  CHECK_THROWS_WITH((GeometryChain{{.block = 0}, ignore}), Contains("block"));
  CHECK_THROWS_WITH((GeometryChain{{.high_pass = {4, 1}}, ignore}), Contains("odd"));
  CHECK_THROWS_WITH(geometry(std::vector<double>(660, 0.0)), Contains("allowed: at least 661"));
  CHECK_NOTHROW(geometry(std::vector<double>(661, 0.0)));
}

TEST_CASE("The complementary filter refuses bad time constants and pole counts") {
  CHECK_THROWS_WITH(ComplementaryFilter{0}, Contains("time constant"));
  CHECK_THROWS_WITH(ComplementaryFilter(1, 0), Contains("poles"));
  CHECK_THROWS_WITH(ComplementaryFilter(1, 9), Contains("poles"));
  CHECK_THROWS_WITH(time_constant(-1), Contains("corner"));
}
