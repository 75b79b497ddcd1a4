#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/quality/descriptor_filter.hpp>
#include <railbook/quality/quality_index.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::quality;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double speed = 100 / 3.6;

Envelope stroke_envelope() {
  return Envelope{{stroke_limit_of_level({0.5, 0.2}, 0.016), {}, speed}};
}

Envelope combined_envelope() {
  return Envelope{{stroke_limit_of_level({0.5, 0.2}, 0.016),
                   ForceLimit{make_car(800, 7000, {2, 0.5}), 143e3}, speed}};
}

std::vector<double> noise(std::size_t n) {
  const num::RandomSource source{7, 1};
  std::vector<double> z(n);
  for (std::size_t i = 0; i < n; ++i) z[i] = 0.01 * source.normal(i);
  return z;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double off = std::abs(a[i] - b[i]);
    worst = std::max(worst, std::isnan(off) ? std::numeric_limits<double>::infinity() : off);
  }
  return worst;
}

}  // namespace

TEST_CASE("Streamed blocks equal direct convolution, whatever the pieces", "[quality]") {
  for (const Envelope& envelope : {stroke_envelope(), combined_envelope()}) {
    const auto taps = design_filter(envelope, {.spacing = 0.5, .shortest = 1.5, .reach = 200});
    for (const std::size_t n : {1U, 2U, 100U, 400U, 401U, 402U, 803U, 5000U, 20000U}) {
      const auto z = noise(n);
      const auto direct = filter_direct(taps, z);
      CHECK(largest_difference(filter(taps, z), direct) < 1e-10);
      std::vector<double> out;
      filters::FilterStream stream{taps, [&](std::span<const double> piece) {
                                     out.insert(out.end(), piece.begin(), piece.end());
                                   }};
      for (std::size_t i = 0; i < n;) {
        const std::size_t count = std::min<std::size_t>(1 + i % 777, n - i);
        stream.push(std::span{z}.subspan(i, count));
        i += count;
      }
      stream.finish();
      CHECK(largest_difference(out, direct) < 1e-10);
    }
  }
}

TEST_CASE("Level and graded track give nothing, reversed track the reverse", "[quality]") {
  const auto taps =
      design_filter(combined_envelope(), {.spacing = 0.5, .shortest = 1.5, .reach = 0});
  std::vector<double> level(3000, 2.5), grade(3000);
  for (std::size_t i = 0; i < grade.size(); ++i) grade[i] = 0.005 * static_cast<double>(i);
  for (const double p : filter(taps, level)) CHECK(std::abs(p) < 1e-9);
  for (const double p : filter(taps, grade)) CHECK(std::abs(p) < 1e-8);
  auto z = noise(6000);
  auto p = filter(taps, z);
  std::reverse(z.begin(), z.end());
  std::reverse(p.begin(), p.end());
  CHECK(largest_difference(filter(taps, z), p) < 1e-10);
}

TEST_CASE("A single lost sample is a gap wherever it stands", "[quality]") {
  const auto taps = design_filter(stroke_envelope(), {.spacing = 0.5, .shortest = 0, .reach = 100});
  const auto z = noise(1200);
  for (const std::size_t at : {600U, 0U, 1U, 2U, 127U, 255U, 256U, 257U, 511U, 512U, 767U, 768U,
                               1023U, 1024U, 1198U, 1199U}) {
    auto lost = z;
    lost[at] = std::numeric_limits<double>::quiet_NaN();
    const auto p = filter(taps, lost);
    const auto middle = static_cast<std::ptrdiff_t>(at);
    INFO("sample " << at);
    REQUIRE(p.size() == z.size());
    CHECK(std::isnan(p[at]));
    const std::vector<double> left(z.begin(), z.begin() + middle),
        right(z.begin() + middle + 1, z.end());
    if (!left.empty())
      CHECK(largest_difference({p.begin(), p.begin() + middle}, filter_direct(taps, left)) < 1e-10);
    if (!right.empty())
      CHECK(largest_difference({p.begin() + middle + 1, p.end()}, filter_direct(taps, right)) <
            1e-10);
  }
}

TEST_CASE("A sine is beyond the limit where its amplitude is, whatever its phase at the ends",
          "[quality]") {
  const num::RandomSource draw{22, 3};
  for (const double damping : {0.1, 0.2, 0.4}) {
    const Envelope envelope{{stroke_limit_of_level({0.5, damping}, 0.016), {}, speed}};
    const auto taps = design_filter(envelope, {.spacing = 0.5, .reach = 1112});
    const double margin = end_effect(taps, envelope);
    CHECK(margin > 40);
    CHECK(margin < 400);
    for (std::uint64_t k = 0; k < 100; ++k) {
      const double wave = k == 0 ? 2.2 : 2 * std::pow(25.0, draw.uniform(2 * k));
      const double phase = 2 * units::pi * draw.uniform(2 * k + 1), phi = 1 / wave;
      for (const double share : {0.97, 1.03}) {
        std::vector<double> z(3000);
        for (std::size_t i = 0; i < z.size(); ++i)
          z[i] = share * allowed_amplitude(envelope(phi)) *
                 std::sin(2 * units::pi * phi * 0.5 * static_cast<double>(i) + phase);
        IndexBuilder builder{{.spacing = 0.5, .margin = margin}};
        builder.push(filter(taps, z));
        builder.finish();
        const auto& found = builder.exceedances();
        const bool sure = std::any_of(found.begin(), found.end(), [&](const Exceedance& e) {
          return !e.cut && e.clear >= margin;
        });
        CAPTURE(damping, wave, phase, share);
        CHECK(sure == (share > 1));
      }
    }
  }
}

TEST_CASE("Filters out of range are refused", "[quality]") {
  const Envelope envelope = stroke_envelope();
  CHECK_THROWS_AS(design_filter(envelope, {.spacing = 0}), InputError);
  CHECK_THROWS_AS(design_filter(envelope, {.spacing = 0.5, .shortest = 0.9}), InputError);
  CHECK_THROWS_AS(design_filter(envelope, {.spacing = 1e-5}), InputError);
  CHECK_THROWS_AS(design_filter(envelope, {.spacing = 1000}), InputError);
}
