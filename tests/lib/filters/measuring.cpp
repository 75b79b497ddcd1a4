#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/complementary.hpp>
#include <railbook/filters/geometry_chain.hpp>
#include <railbook/filters/high_pass.hpp>
#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/units/constants.hpp>

#include "support/filter_weights.hpp"

using namespace railbook;
using namespace railbook::spectra;
using namespace railbook::filters;

namespace {

std::vector<double> noise(std::size_t n, std::uint64_t seed = 1) {
  const num::RandomSource random{seed, 3};
  std::vector<double> x(n);
  for (std::size_t k = 0; k < n; ++k) x[k] = 1e-4 * random.normal(k);
  return x;
}

double response(const std::vector<double>& taps, double theta) {
  double sum = 0;
  const auto centre = static_cast<double>(taps.size() / 2);
  for (std::size_t j = 0; j < taps.size(); ++j)
    sum += taps[j] * std::cos(theta * (static_cast<double>(j) - centre));
  return sum;
}

// Direct: what the chain is to give, NaN included.
std::vector<double> direct(const std::vector<double>& x, const std::vector<double>& taps) {
  std::vector<double> y(x.size(), std::nan(""));
  const std::size_t r = taps.size() / 2;
  for (std::size_t i = r; i + r < x.size(); ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < taps.size(); ++j) sum += taps[j] * x[i + j - r];
    y[i] = sum;
  }
  return y;
}

void check_equal(const std::vector<double>& a, const std::vector<double>& b, double margin) {
  REQUIRE(a.size() == b.size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    wrong += std::isnan(a[i]) != std::isnan(b[i]) ||
             (!std::isnan(a[i]) && std::abs(a[i] - b[i]) > margin);
  CHECK(wrong == 0);
}

std::vector<double> chord_of(const std::vector<double>& curve, std::size_t half) {
  std::vector<double> y(curve.size(), std::nan(""));
  for (std::size_t i = half; i + half < curve.size(); ++i)
    y[i] = curve[i] - 0.5 * (curve[i - half] + curve[i + half]);
  return y;
}

}  // namespace

TEST_CASE("Long chords from short ones are those of the profile") {
  const auto z = noise(500);
  for (const int half : {1, 2, 31, 100}) {
    const auto m = mid_chord_offsets(z, 1, 2);
    const auto expected = mid_chord_offsets(z, 1, 2.0 * half);
    const auto got = to_chord(m.offset, half);
    CHECK(got.first + m.first == expected.first);
    check_equal(got.offset, expected.offset, 1e-13);
    const auto by_weights = direct(m.offset, chord_taps(half));
    for (std::size_t i = 0; i < got.offset.size(); ++i)
      CHECK(got.offset[i] == Approx(by_weights[i + got.first]).margin(1e-13));
  }
}

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

TEST_CASE("The mean's gain, its limits included") {
  for (const int M : {1, 2, 3, 31, 150})
    for (const double theta : {0.0, 1e-9, 0.3, 3.0, 2 * units::pi, 7.0, 4 * units::pi, 6.2}) {
      std::complex<double> sum = 0;
      for (int j = 0; j < M; ++j) sum += std::polar(1.0, theta * (j - 0.5 * (M - 1)));
      CHECK(mean_gain(M, theta) == Approx(sum.real() / M).margin(1e-13));
    }
}

TEST_CASE("Taps of the high-pass and the space curve have the gains of the formulas") {
  for (const HighPass f : {HighPass{}, HighPass{3, 1}, HighPass{21, 3}, HighPass{151, 4, 2}}) {
    const auto hp = high_pass_taps(f), curve = space_curve_taps(f);
    CHECK(hp.size() == 2 * reach(f) + 1);
    CHECK(curve.size() == 2 * reach(f) - 1);
    for (const double theta : {0.0, 0.001, 0.01, 0.05, 0.3, 1.0, 3.0, units::pi}) {
      CHECK(response(hp, theta) == Approx(high_pass_gain(f, theta)).margin(1e-12));
      const double chord = 2 * std::pow(std::sin(theta / 2), 2);
      const double limit = f.stages > 1 ? 0 : f.passes * (f.length * f.length - 1) / 12.0;
      CHECK(response(curve, theta) == Approx(theta == 0 ? limit : high_pass_gain(f, theta) / chord)
                                          .epsilon(1e-10)
                                          .margin(2e-9));
    }
  }
}

TEST_CASE("The chain is the direct convolution, in blocks and pieces of any size") {
  auto x = noise(3000);
  x[1700] = std::nan("");
  x[2350] = std::numeric_limits<double>::infinity();
  x[2351] = -5;  // m: no track
  for (const HighPass hp : {HighPass{}, HighPass{51, 4, 2}, HighPass{31, 3}}) {
    auto clean = x;
    for (double& v : clean)
      if (!(std::abs(v) < 1)) v = std::nan("");
    const auto curve = direct(clean, space_curve_taps(hp));
    const auto chord = chord_of(curve, 31);
    for (const std::size_t block : {1UL, 100UL, 4096UL}) {
      if (block == 1 && hp.length == 151) continue;
      std::vector<double> got_curve, got_chord;
      GeometryChain chain{{.high_pass = hp, .block = block}, [&](auto s, auto c) {
                            got_curve.insert(got_curve.end(), s.begin(), s.end());
                            got_chord.insert(got_chord.end(), c.begin(), c.end());
                          }};
      for (std::size_t i = 0; i < x.size(); i += 777)
        chain.push(std::span{x}.subspan(i, std::min<std::size_t>(777, x.size() - i)));
      chain.finish();
      CHECK(chain.masked() == 3);
      check_equal(got_curve, curve, 1e-11);
      check_equal(got_chord, chord, 1e-11);
    }
  }
}

TEST_CASE("The complementary filter passes a true roll, and leaves a bias as it should") {
  for (const int poles : {1, 2, 3}) {
    const double tau = time_constant(0.3125);
    ComplementaryFilter filter{tau, poles};
    double t = 0, before = 0;
    for (int k = 0; k < 200; ++k) {
      const double T = 0.01 + 0.3 * (k % 7), roll = std::sin(0.3 * t);
      CHECK(filter.push(roll, roll - before, T) == Approx(roll).margin(1e-13));
      before = roll;
      t += 0.01 + 0.3 * ((k + 1) % 7);
    }
    ComplementaryFilter biased{tau, poles};
    double last = 0;
    for (int k = 0; k < 3000; ++k) last = biased.push(0, 0.01 * 0.02, 0.02);
    CHECK(last == Approx(gyro_bias_error(0.01, tau, poles, 0.02)).epsilon(1e-9));
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

TEST_CASE("A running sum is the sum of each window, however often it begins anew") {
  std::vector<std::uint64_t> x;
  for (std::uint64_t i = 0; i < 500; ++i) x.push_back(i * i * 7919 % 1009);
  for (const int length : {1, 2, 31, 499, 500})
    for (const std::size_t restart : {0U, 1U, 2U, 7U, 100U, 469U, 470U, 471U, 4096U}) {
      const auto sums = running_sum<std::uint64_t>(x, length, restart);
      const auto n = static_cast<std::size_t>(length);
      REQUIRE(sums.size() == x.size() - n + 1);
      bool all = true;
      for (std::size_t i = 0; i < sums.size(); ++i) {
        std::uint64_t sum = 0;
        for (std::size_t j = i; j < i + n; ++j) sum += x[j];
        all = all && sums[i] == sum;
      }
      INFO("windows of " << length << ", anew after " << restart);
      CHECK(all);
    }
}
