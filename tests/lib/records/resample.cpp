// Uneven samples on an even grid: the heights, the gaps, and the error that is reported.
#include <railbook/records/resample.hpp>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <railbook/records/record_file.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

constexpr double tau = 6.283185307179586;

double wave(double x) {
  return 3e-3 * std::sin(tau * x / 10);
}

// Places 0.25 m apart that leave their grid by up to 0.08 m.
double uneven(int i) {
  return 0.25 * i + 0.08 * std::sin(1.7 * i * i);
}

records::Resampler resampled(const std::vector<double>& places, double spacing) {
  records::Resampler r{spacing, 1};
  for (const double x : places) r.push(x, std::array{wave(x)});
  r.finish();
  return r;
}

}  // namespace

TEST_CASE("property: interpolated heights are off by what the resampler says") {
  for (const double direction : {1.0, -1.0}) {
    std::vector<double> places;
    for (int i = 0; i < 4000; ++i) places.push_back(direction * uneven(i));
    const auto r = resampled(places, 0.25);
    REQUIRE(r.positions().size() > 3990);
    double square = 0;
    for (std::size_t i = 0; i < r.positions().size(); ++i) {
      if (i > 0)
        CHECK(r.positions()[i] - r.positions()[i - 1] == Approx(direction * 0.25).margin(1e-9));
      square += std::pow(r.heights(0)[i] - wave(r.positions()[i]), 2);
    }
    const double error = std::sqrt(square / static_cast<double>(r.positions().size()));
    CHECK(error < 1e-5);
    CHECK(r.error(0) == Approx(error).epsilon(0.4));
  }
}

TEST_CASE("unit: samples on the grid come out as they are, gaps stay empty") {
  std::vector<double> places;
  for (int i = 0; i < 300; ++i)
    if (i < 100 || i > 120) places.push_back(0.25 * i);
  const auto r = resampled(places, 0.25);
  REQUIRE(r.positions().size() == places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    CHECK(r.positions()[i] == Approx(places[i]).margin(1e-12));
    CHECK(r.heights(0)[i] == Approx(wave(places[i])).margin(1e-15));
  }
}

TEST_CASE("unit: missing heights stay missing, rows that stand still are left out") {
  records::Resampler r{0.5, 2};
  const double lost = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [x, a, b] : std::vector<std::array<double, 3>>{
           {0, 1, 1}, {0.4, 1, lost}, {0.4, 9, 9}, {lost, 9, 9}, {0.9, 2, 2}, {1.4, 3, 3}})
    r.push(x, std::array{a, b});
  r.finish();
  REQUIRE(r.positions() == std::vector<double>{0, 0.5, 1});
  CHECK(r.heights(0)[1] == Approx(1.2));
  CHECK(r.heights(0)[2] == Approx(2.2));
  CHECK(std::isnan(r.heights(1)[1]));
  CHECK(r.heights(1)[2] == Approx(2.2));
  CHECK(r.repeated() == 1);
}

TEST_CASE("input: a grid coarser than the samples is refused, and a spacing that is none") {
  CHECK_THROWS_WITH(resampled({0, 0.25, 0.5}, 0.5),
                    Contains("resample is 0.5 m") && Contains("up to 0.375 m"));
  CHECK_THROWS_WITH(resampled({1, 1, 1}, 0.5), Contains("different positions"));
  CHECK_THROWS_AS((records::Resampler{0, 1}), InputError);
}

TEST_CASE("unit: an uneven record is refused with the option, and read with it") {
  const TemporaryFolder folder("uneven");
  std::string text = "distance_m,profile_mm\n";
  for (int i = 0; i < 4000; ++i)
    text += std::to_string(uneven(i)) + "," + std::to_string(1e3 * wave(uneven(i))) + "\n";
  records::RecordFile file{.file = folder.write("uneven.csv", text)};
  const auto read = [&] {
    double square = 0;
    std::size_t n = 0;
    const auto sink = [&](std::span<const double> piece, const records::RecordStream&) {
      for (const double z : piece) square += z * z, ++n;
    };
    const auto record = records::read_record(file, sink);
    REQUIRE(record->warnings().size() == 1);
    CHECK(record->warnings()[0].key == "resampled");
    CHECK_THAT(record->warnings()[0].text, Contains("off by about 0.00"));
    CHECK(record->spacing() == Approx(0.25));
    return std::sqrt(square / static_cast<double>(n));
  };
  CHECK_THROWS_WITH(read(), Contains("--resample SPACING"));
  file.resample = 0.25;
  // Straight lines lose (k h)^2/12 of a wave: 0.2 % at 40 samples a wave, a little more as h
  // varies.
  CHECK(read() == Approx(3e-3 / std::sqrt(2)).epsilon(4e-3));
}
