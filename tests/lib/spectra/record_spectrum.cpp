#include <railbook/spectra/record_spectrum.hpp>

#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <railbook/num/random_stream.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Contains;

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
