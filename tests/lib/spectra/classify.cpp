#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <railbook/num/random_stream.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/classify.hpp>
#include <railbook/spectra/record_spectrum.hpp>
#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/spectra/welch.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Contains;

TEST_CASE("unit: classes by hand") {
  const auto only_dips = [](double B) { return spectra::classify(0, B).track_class; };
  CHECK(only_dips(0) == 6);
  CHECK(only_dips(0.25 * units::inch) == 6);
  CHECK(only_dips(0.2501 * units::inch) == 5);
  CHECK(only_dips(0.999 * units::inch) == 4);
  CHECK(only_dips(1.499 * units::inch) == 1);
  CHECK(only_dips(1.501 * units::inch) == 0);
  const auto rough = spectra::classify(5e-7, 11e-3);
  CHECK(rough.track_class == 5);
  CHECK(rough.deviation == Approx(std::sqrt(839.303 * 5e-7 + 4 * 11e-3 * 11e-3)).epsilon(1e-5));
  CHECK(rough.margin == Approx(1 - rough.deviation / (1.25 * units::inch)));
  CHECK(rough.to_next == Approx(rough.deviation / (0.5 * units::inch) - 1));
  CHECK(spectra::classify(1e-4, 0).track_class == 0);
  CHECK(spectra::classify(1e-4, 0).to_next > 0);
  for (const double dip : {0.0, 0.1 * units::inch}) {  // nothing is better than class 6
    const auto best = spectra::classify(1e-9, dip);
    CHECK(best.track_class == 6);
    CHECK(best.to_next == 0);
    CHECK(best.margin == Approx(1 - best.deviation / (0.5 * units::inch)));
  }
  CHECK(spectra::classify(1e-4, 0).margin < 0);
}

TEST_CASE("input: the class rule refuses negative parameters and limits out of order") {
  CHECK_THROWS_AS(spectra::classify(-1e-7, 0), InputError);
  CHECK_THROWS_AS(spectra::classify(1e-7, -1e-3), InputError);
  CHECK_THROWS_AS(spectra::classify(1e-7, 0, {.chord = 0}), InputError);
  spectra::ClassRule rule;
  rule.limits[5] = 1;
  CHECK_THROWS_AS(spectra::classify(1e-7, 0, rule), InputError);
  CHECK_THROWS_AS(spectra::coefficient_range(1e-7, 1e-3, 7), InputError);
}

namespace {

struct Wave {
  double length, amplitude;
};

std::optional<double> rail_seen(const std::vector<Wave>& waves) {
  const spectra::SyntheticTrack t{.seed = 77, .A = 5e-7, .phi_c = 0.13, .dip = 0};
  std::vector<double> z(30000);
  spectra::TrackGenerator{t}.fill(z);
  for (std::size_t i = 0; i < z.size(); ++i)
    for (const Wave& wave : waves)
      z[i] += wave.amplitude *
              std::sin(2 * units::pi * t.spacing * static_cast<double>(i) / wave.length);
  const auto s = spectra::welch(z, t.spacing, {.segment = 2048});
  const spectra::FitOptions options{};
  return spectra::contradicting_rail(s, options, spectra::fit_track_spectrum(s, options));
}

}  // namespace

TEST_CASE("unit: a rail of another length than the one named shows by its lines") {
  CHECK_FALSE(rail_seen({}));
  const double weak = 2e-3, strong = 6e-3;
  // The line itself, whichever of the two is stronger where both may be rails.
  CHECK(rail_seen({{20, strong}}).value_or(0) == Approx(20).epsilon(0.01));
  CHECK(rail_seen({{9, strong}}).value_or(0) == Approx(9).epsilon(0.01));
  CHECK(rail_seen({{18.2, weak}, {9.1, strong}}).value_or(0) == Approx(9.1).epsilon(0.01));
  // The second or the third of its lines, where that is too short for a rail; not the fourth.
  CHECK(rail_seen({{9, weak}, {4.5, strong}}).value_or(0) == Approx(9).epsilon(0.01));
  CHECK(rail_seen({{20, weak}, {20.0 / 3, strong}}).value_or(0) == Approx(20).epsilon(0.01));
  CHECK(rail_seen({{9, weak}, {3, strong}}).value_or(0) == Approx(9).epsilon(0.01));
  CHECK_FALSE(rail_seen({{9, weak}, {2.25, strong}}));
  // A line of neither.
  CHECK_FALSE(rail_seen({{6.5, strong}}));
}

TEST_CASE("unit: rails of half or twice the length named are not taken for each other") {
  for (const double length : {12.5, 18.0, 25.0, 36.0}) {
    const spectra::SyntheticTrack t{.spacing = 0.25,
                                    .seed = 5,
                                    .A = 2e-7,
                                    .phi_c = 0.13,
                                    .rail_length = length,
                                    .dip = 6e-3 * std::sqrt(length / 18)};
    std::vector<double> z(40000);
    spectra::TrackGenerator{t}.fill(z);
    const auto s = spectra::welch(z, t.spacing, {.segment = 4096});
    const auto fit_of = [&](double rail) {
      return spectra::fit_track_spectrum(s, {.rail_length = rail});
    };
    for (const double named : {11.8872, length / 2, 2 * length}) {
      if (named < 8 || named > 40) continue;
      CAPTURE(length, named);
      const spectra::FitOptions options{.rail_length = named};
      CHECK(spectra::contradicting_rail(s, options, fit_of(named)).value_or(0) ==
            Approx(length).epsilon(0.01));
    }
    CHECK_FALSE(spectra::contradicting_rail(s, {.rail_length = length}, fit_of(length)));
    CHECK(fit_of(length).A.value == Approx(2e-7).epsilon(0.15));
  }
}

TEST_CASE("unit: a record without its long waves is reported, others are not") {
  const spectra::SyntheticTrack t{.spacing = 0.25, .seed = 9, .A = 5e-7, .phi_c = 0.13};
  std::vector<double> z(48000);
  spectra::TrackGenerator{t}.fill(z);
  const auto told = [&](const std::vector<double>& record) {
    const auto s = spectra::welch(record, t.spacing, {.segment = 4096});
    return spectra::high_pass(s, {}, spectra::fit_track_spectrum(s)).has_value();
  };
  CHECK_FALSE(told(z));
  for (const double length : {50.0, 70.0, 100.0}) {  // two real poles, forward and backward
    auto passed = z;
    for (int pass = 0; pass < 4; ++pass) {
      const double keep = std::exp(-2 * units::pi * t.spacing / length);
      double before = passed[0], out = 0;
      for (double& height : passed) {
        out = keep * (out + height - before);
        before = std::exchange(height, out);
      }
      if (pass % 2 == 1) std::reverse(passed.begin(), passed.end());
    }
    CAPTURE(length);
    CHECK(told(passed));
  }
}

namespace {

constexpr double spacing = 0.25;  // m

std::vector<double> heights(std::size_t samples) {
  num::RandomStream random(7);
  std::vector<double> all(samples);
  for (double& z : all) z = random.normal(1e-3);
  return all;
}

// A file of the heights with 20 samples lost every `between`.
std::filesystem::path file_of(const TemporaryFolder& at, const std::vector<double>& heights,
                              std::size_t between) {
  std::string text = "profile_mm\n";
  for (std::size_t i = 0; i < heights.size(); ++i)
    text += i % between >= between - 20 ? "nan\n" : std::to_string(1e3 * heights[i]) + "\n";
  return at.write("track.csv", text);
}

records::RecordFile read(const std::filesystem::path& file) {
  records::RecordFile read;
  read.file = file;
  read.spacing = spacing;
  return read;
}

}  // namespace

TEST_CASE("unit: segments are about 1250 m, and shorter where gaps would waste the record") {
  const TemporaryFolder at("record-spectrum");
  const std::vector<double> all = heights(60000);
  struct Case {
    std::size_t between, segment;
  };
  for (const Case c : {Case{100000, 4096}, Case{2500, 2048}, Case{1080, 1024}}) {
    CAPTURE(c.between);
    const auto found =
        spectra::record_spectra(read(file_of(at, all, c.between)), {.columns = {"profile"}});
    REQUIRE(found.size() == 1);
    CHECK(found[0].segment == c.segment);
    CHECK(found[0].shortened == (c.segment < 4096));
    // At the record's spacing, although that is known at the end only.
    CHECK(found[0].spectrum.df == Approx(1 / (spacing * static_cast<double>(c.segment))));
    CHECK(found[0].record->missing() ==
          (c.between > all.size() ? 0 : 20 * (all.size() / c.between)));
    double power = 0;
    for (const double density : found[0].spectrum.density) power += density * found[0].spectrum.df;
    CHECK(power == Approx(1e-6).epsilon(0.03));  // the variance of the heights
  }
}

TEST_CASE("unit: shorter segments are found where a long record has its gaps at the end") {
  const TemporaryFolder at("record-late-gaps");
  std::string text = "profile_mm\n";
  const std::vector<double> all = heights(160000);
  for (std::size_t i = 0; i < all.size(); ++i)
    text += i > 80000 && i % 1080 < 20 ? "nan\n" : std::to_string(1e3 * all[i]) + "\n";
  const auto file = read(at.write("track.csv", text));
  std::size_t sections = 0;
  const auto found =
      spectra::record_spectra(file, {.columns = {"profile"}, .section = 10000},
                              [&](std::size_t, const spectra::SpectrumSection&) { ++sections; });
  CHECK(found[0].segment == 1024);
  CHECK(found[0].shortened);
  CHECK(sections == 4);  // once each
  const auto alone = spectra::record_spectra(file, {.columns = {"profile"}, .segment = 1024});
  CHECK(found[0].spectrum.density == alone[0].spectrum.density);
}

TEST_CASE("unit: each section of a record has the spectrum of its own samples") {
  const TemporaryFolder at("record-sections");
  const std::vector<double> all = heights(9000);
  std::vector<spectra::SpectrumSection> sections;
  spectra::record_spectra(
      read(file_of(at, all, 100000)), {.columns = {"profile"}, .section = 1000},
      [&](std::size_t, const spectra::SpectrumSection& s) { sections.push_back(s); });
  REQUIRE(sections.size() == 2);  // and 250 m, less than half of one
  CHECK(sections[1].first == 4000);
  for (const spectra::SpectrumSection& s : sections) {
    CHECK(s.count == 4000);
    spectra::Welch alone(spacing, {.segment = 1024});
    alone.push(std::span{all}.subspan(s.first, s.count));
    const spectra::Spectrum expected = alone.spectrum();
    REQUIRE(s.spectrum);
    for (Eigen::Index k = 3; k < expected.density.size(); k += 50)
      CHECK(s.spectrum->density[k] == Approx(expected.density[k]).epsilon(1e-2));  // six decimals
  }
}

TEST_CASE("input: a record without one segment between its gaps is refused") {
  const TemporaryFolder at("record-gaps");
  const auto file = file_of(at, heights(9000), 300);
  CHECK_THROWS_WITH(spectra::record_spectra(read(file), {.columns = {"profile"}}),
                    Contains("600 of them missing") && Contains("in a row without a gap"));
  CHECK_THROWS_WITH(spectra::record_spectra(read(file), {.columns = {"profile"}, .section = 10}),
                    Contains("section is 10 m, 40 samples; allowed: from 48 m"));
}
