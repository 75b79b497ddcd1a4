#include <railbook/quality/growth.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/filters/wavelength_band.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/num/special.hpp>
#include <railbook/quality/runs.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;

namespace {

constexpr double spacing = 0.25, mm = 1e-3;
constexpr std::size_t samples = 24000, section = 800;  // 6 km, 200 m

std::vector<double> in_d1(const std::vector<double>& heights) {
  return filters::filter(filters::band_taps(filters::bands[1], 2, spacing), heights);
}

// Without long waves, so that stretches of two tracks join without a step.
std::vector<double> track(std::uint64_t seed) {
  return in_d1(
      spectra::synthesize({.spacing = spacing, .seed = seed, .A = 4e-7, .phi_c = 0.13}, samples));
}

// Recorded with noise, `offset` metres further on.
quality::LineRun run_of(std::vector<double> heights, double noise, double offset,
                        std::uint64_t seed) {
  const num::RandomSource source{seed, 0};
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] += noise * source.normal(i);
  return {in_d1(heights),
          [offset](std::size_t i) { return offset + spacing * static_cast<double>(i); }};
}

double deviation(const std::vector<double>& z, std::size_t from) {
  double sum = 0, squares = 0;
  for (std::size_t i = from; i < from + section; ++i) sum += z[i] / section;
  for (std::size_t i = from; i < from + section; ++i)
    squares += (z[i] - sum) * (z[i] - sum) / section;
  return std::sqrt(squares);
}

// Runs a year apart of a track that grows by `rate` a year of what it was at first; before the
// third, sections 10 to 14 are smoothed to half of their shape and as much of another.
struct Scene {
  double rate = 0.05, noise = 0.3 * mm;
  std::size_t runs = 4;
  bool tamping = false;
};

std::vector<quality::ComparedRun> compare(const Scene& scene, std::uint64_t seed) {
  const std::vector<double> first = track(seed), other = track(seed + 5000);
  std::vector<quality::LineRun> runs;
  for (std::size_t k = 0; k < scene.runs; ++k) {
    std::vector<double> z(samples);
    for (std::size_t i = 0; i < samples; ++i) {
      const bool tamped = scene.tamping && k > 1 && i >= 10 * section && i < 15 * section;
      z[i] = (1 + scene.rate * static_cast<double>(k)) *
             (tamped ? 0.4 * first[i] + 0.4 * other[i] : first[i]);
    }
    runs.push_back(
        run_of(std::move(z), scene.noise, 3.3 * static_cast<double>(k % 3), 100 * seed + k));
  }
  quality::RunSeries series{std::move(runs.front()), 200};
  for (std::size_t k = 1; k < runs.size(); ++k) series.add(std::move(runs[k]));
  return series.sections();
}

const std::vector<double> years{0, 1, 2, 3, 4, 5, 6, 7};

}  // namespace

TEST_CASE("unit: Student's quantiles in closed form") {
  for (const double p : {0.5, 0.6, 0.975, 0.9999}) {
    const double a = 4 * p * (1 - p);
    CHECK(num::student_quantile(p, 1) == Approx(std::tan(M_PI * (p - 0.5))).epsilon(1e-10));
    CHECK(num::student_quantile(p, 2) == Approx(2 * (p - 0.5) * std::sqrt(2 / a)).epsilon(1e-10));
    const double q = std::cos(std::acos(std::sqrt(a)) / 3) / std::sqrt(a);
    CHECK(num::student_quantile(p, 4) == Approx(2 * std::sqrt(q - 1)).epsilon(1e-10).margin(1e-7));
    CHECK(num::student_quantile(1 - p, 4) == Approx(-num::student_quantile(p, 4)).margin(1e-9));
  }
  CHECK_THROWS_AS(num::student_quantile(0.5, 0), InputError);
  CHECK_THROWS_AS(num::student_quantile(1.1, 3), InputError);
}

TEST_CASE("unit: a straight line, its error and its interval by hand") {
  // Residuals 0.04, -0.12, 0.12, -0.04: their squares are 0.032, of two degrees of freedom.
  const auto line =
      quality::straight_line(std::vector{0.0, 1.0, 2.0, 3.0}, std::vector{1.0, 2.2, 3.8, 5.0});
  CHECK(line.slope == Approx(1.36));
  CHECK(line.standard_error == Approx(std::sqrt(0.016 / 5)));
  CHECK(line.high - line.slope == Approx(4.302652729911 * line.standard_error));
  CHECK(line.slope - line.low == Approx(line.high - line.slope));
  const auto two = quality::straight_line(std::vector{2.0, 4.0}, std::vector{1.0, 2.0});
  CHECK(two.slope == Approx(0.5));
  CHECK((std::isnan(two.standard_error) && std::isnan(two.low) && std::isnan(two.high)));
  CHECK_THROWS_AS(quality::straight_line(std::vector{1.0}, std::vector{1.0}), InputError);
  CHECK_THROWS_AS(quality::straight_line(std::vector{1.0, 1.0}, std::vector{1.0, 2.0}), InputError);
  CHECK_THROWS_AS(quality::straight_line(std::vector{1.0, 2.0}, std::vector{1.0}), InputError);
  CHECK_THROWS_AS(quality::straight_line(std::vector{1.0, 2.0}, std::vector{1.0, 2.0}, 2),
                  InputError);
}

TEST_CASE("unit: intervals of growth hold the growth of a known track in 95 of 100 sections") {
  for (const std::size_t runs : {std::size_t{3}, std::size_t{4}, std::size_t{6}}) {
    double held = 0, all = 0, errors = 0, squares = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const Scene scene{.runs = runs};
      const std::vector<double> first = in_d1(track(seed));
      const auto compared = compare(scene, seed);
      for (std::size_t i = 1; i + 1 < samples / section; ++i) {
        const auto periods = quality::periods(compared, i, std::span{years}.first(runs), 0.15);
        REQUIRE(periods.size() == 1);
        REQUIRE(periods.front().runs.size() == runs);
        const quality::Trend& growth = periods.front().growth;
        const double truth = scene.rate * deviation(first, i * section);
        held += growth.low <= truth && truth <= growth.high ? 1 : 0;
        errors += (growth.slope - truth) * (growth.slope - truth);
        squares += growth.standard_error * growth.standard_error;
        ++all;
      }
    }
    CAPTURE(runs, all);
    CHECK(held / all == Approx(0.95).margin(0.035));  // three standard errors of 336 sections
    CHECK(errors / squares == Approx(1).margin(0.35));
  }
}

TEST_CASE("unit: tamped sections are found, and few others") {
  std::size_t tamped = 0, found = 0, pairs = 0, alarms = 0, unlike = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const auto compared = compare({.runs = 5, .tamping = true}, seed);
    const double drop = quality::tamping_drop(compared);
    CHECK(drop == 0.15);
    for (std::size_t i = 0; i < samples / section; ++i) {
      const bool truth = i >= 10 && i < 15;
      tamped += truth ? 1 : 0;
      pairs += truth ? 3 : 4;
      const auto periods = quality::periods(compared, i, std::span{years}.first(5), drop);
      for (const quality::Period& period : periods) {
        const bool before_third = !period.runs.empty() && period.runs.front() == 2;
        unlike += period.begin == quality::Period::Begin::unlike ? 1 : 0;
        if (period.begin == quality::Period::Begin::tamped)
          ++(truth && before_third ? found : alarms);
      }
      // Since then there are three runs of growth.
      if (truth && periods.size() == 2) CHECK(periods.back().runs.size() == 3);
    }
  }
  CAPTURE(tamped, found, pairs, alarms, unlike);
  CHECK(tamped == 60);
  CHECK(found == tamped);
  CHECK(alarms == 0);
  CHECK(unlike == 0);
}

TEST_CASE("unit: a recorder that scatters more needs a larger fall for tamping") {
  const auto sections = [](std::uint64_t seed, double scatter) {
    std::vector<quality::ComparedRun> runs(4);
    const num::RandomSource source{seed, 0};
    std::uint64_t draw = 0;
    for (auto& run : runs)
      for (int i = 0; i < 200; ++i) {
        const double sd = mm * std::exp(scatter * source.normal(draw++));
        run.sections.push_back({.heights = {.samples = 800, .squares = 800 * sd * sd},
                                .correlation = 0.9,
                                .offset = 0});
      }
    return runs;
  };
  CHECK(quality::tamping_drop(sections(1, 0.01)) == 0.15);
  // Of a difference of two: sqrt(2) times the scatter of one.
  const double drop = quality::tamping_drop(sections(2, 0.07));
  CHECK(drop == Approx(1 - std::exp(-4 * std::sqrt(2.0) * 0.07)).epsilon(0.15));
  std::size_t alarms = 0;
  for (std::uint64_t seed = 10; seed < 20; ++seed) {
    const auto runs = sections(seed, 0.07);
    const double own = quality::tamping_drop(runs);
    for (std::size_t i = 0; i < 200; ++i)
      alarms += quality::periods(runs, i, std::span{years}.first(4), own).size() - 1;
  }
  CHECK(alarms <= 2);  // of 6000 changes; with 15 % there are 450
  CHECK(quality::tamping_drop({}, {.tamping_drop = 0.3}) == 0.3);
}

TEST_CASE(
    "unit: a run with a hole is left out of that section only, and another shape is no growth") {
  std::vector<double> first = track(3), other = track(77);
  std::vector<double> second = first, third = first;
  for (std::size_t i = 5 * section; i < 6 * section - 100; ++i)
    second[i] = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 20 * section; i < 23 * section; ++i) third[i] = other[i] * 1.2;
  quality::RunSeries series{run_of(first, 0.1 * mm, 0, 1), 200};
  series.add(run_of(second, 0.1 * mm, 0, 2));
  CHECK(series.sections()[1].sections[5].missing());
  series.add(run_of(third, 0.1 * mm, 0, 3));
  const auto runs = series.sections();
  const auto of = [&](std::size_t i) {
    return quality::periods(runs, i, std::span{years}.first(3), 0.15);
  };
  REQUIRE(of(5).size() == 1);
  CHECK(of(5).front().runs == std::vector<std::size_t>{0, 2});
  CHECK(std::abs(of(5).front().growth.slope) < 0.02 * mm);
  REQUIRE(of(21).size() == 2);
  CHECK(of(21).back().begin == quality::Period::Begin::unlike);
  CHECK(of(12).size() == 1);
  const std::vector<double> nowhere = track(123);
  CHECK_THROWS_WITH(series.add(run_of(nowhere, 0, 0, 4)),
                    Catch::Contains("run 4 is nowhere like run 3"));
}
