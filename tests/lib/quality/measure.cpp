// Measures of a channel, each against the sum or the loop that defines it; the words that name
// them; and the limits of the FRA as a file.
#include <railbook/quality/measure.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <railbook/num/random_stream.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/quantity.hpp>

using namespace railbook;
using namespace railbook::quality;
using Catch::Matchers::Contains;

namespace {

constexpr double foot = units::foot, inch = units::inch;

std::vector<double> drawn(std::size_t n, std::uint64_t seed) {
  num::RandomStream draw(seed);
  std::vector<double> record(n);
  for (double& z : record) z = draw(-1, 1);
  return record;
}

// In pieces of uneven lengths.
std::vector<double> measured(const Measure& measure, double spacing,
                             std::span<const double> record) {
  std::vector<double> found;
  MeasureStream stream{measure, 2, spacing, [&](std::span<const double> values) {
                         found.insert(found.end(), values.begin(), values.end());
                       }};
  for (std::size_t at = 0, piece = 1; at < record.size(); at += piece, piece = piece * 3 % 101 + 1)
    stream.push(record.subspan(at, std::min(piece, record.size() - at)));
  stream.finish();
  return found;
}

}  // namespace

TEST_CASE("unit: a chord of two or three samples reads the second difference") {
  const auto record = drawn(40, 1);
  std::vector<double> found;
  filters::ChordStream stream{{2, 4}, 1, [&](std::span<const double> values) {
                                found.insert(found.end(), values.begin(), values.end());
                              }};
  stream.push(record);
  stream.finish();
  for (std::size_t i = 4; i + 6 < record.size(); ++i)
    CHECK(found[i] ==
          Approx(record[i] - (4 * record[i - 2] + 2 * record[i + 4]) / 6).margin(1e-15));
  CHECK_THROWS_WITH((filters::ChordStream{{1, 4}, 1, nullptr}), Contains("before its offset"));
  CHECK_THROWS_WITH((filters::ChordStream{{2, 1}, 1, nullptr}), Contains("behind its offset"));
}

TEST_CASE("unit: each measure gives what its own class gives, and no more beside a gap") {
  auto record = drawn(4000, 2);
  const double spacing = 0.25;
  const auto all = [&](const char* text, double mean = 0) {
    Measure measure = parse_measure(text);
    if (mean > 0) measure.mean = Measure::Mean::subtracted, measure.mean_length = mean;
    return measure;
  };
  CHECK(measured(parse_measure(""), spacing, record) == record);
  Twist twist{3, spacing};
  Warp warp{62 * foot, spacing};
  const auto twists = measured(parse_measure("twist 3m"), spacing, record),
             warps = measured(parse_measure("change 62ft"), spacing, record);
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double is = twist.push(record[i]);
    CHECK((std::isnan(is) ? std::isnan(twists[i]) : is == twists[i]));
    CHECK(warps[i] == warp.push(record[i]));
  }
  const auto bands = measured(parse_measure("3m-25m"), spacing, record),
             whole = filters::filter(filters::band_taps(filters::bands[1], 2, spacing), record);
  for (std::size_t i = 100; i + 100 < record.size(); ++i) CHECK(bands[i] == Approx(whole[i]));
  // A chord that the library has twice.
  const auto chords = measured(parse_measure("chord 62ft"), spacing, record),
             taps = filters::filter(filters::chord_taps(62 * foot, spacing), record);
  for (std::size_t i = 40; i + 40 < record.size(); ++i)
    CHECK(chords[i] == Approx(taps[i]).margin(1e-13));
  // Less the mean of 401 samples, of the samples themselves and of the offsets.
  for (const char* const text : {"", "chord 3m+7m"}) {
    const auto plain = measured(parse_measure(text), spacing, record),
               rest = measured(all(text, 100), spacing, record);
    for (std::size_t i = 300; i + 300 < record.size(); i += 7) {
      double sum = 0;
      for (std::size_t k = i - 200; k <= i + 200; ++k) sum += plain[k];
      CHECK(rest[i] == Approx(plain[i] - sum / 401).margin(1e-13));
    }
  }
  // What a lost sample takes with it is within the reach, and reaches to its end.
  record[2000] = std::nan("");
  for (const Measure& measure :
       {all(""), all("D1"), all("chord 20m"), all("chord 3m+7m"), all("uniformity 31ft"),
        all("twist 3m"), all("", 50), all("D1", 50), all("chord 3m+7m", 20), all("twist 3m", 20)}) {
    const MeasureStream stream{measure, 2, spacing, nullptr};
    const auto found = measured(measure, spacing, record);
    REQUIRE(found.size() == record.size());
    std::size_t farthest = 0;
    for (std::size_t i = 1000; i < 3000; ++i)
      if (std::isnan(found[i])) farthest = std::max(farthest, i > 2000 ? i - 2000 : 2000 - i);
    CAPTURE(static_cast<int>(measure.kind), measure.length, measure.mean_length);
    CHECK(farthest == stream.reach());
  }
}

TEST_CASE("input: measures in words") {
  CHECK(parse_measure("D2").band.longest == 70);
  CHECK(parse_measure("1.5m-42m").band.longest == 42);
  CHECK(parse_measure("chord 10m").chord.before == 5);
  CHECK(parse_measure("chord 3m+7m").chord.after == 7);
  CHECK(parse_measure("chord 18.9m").is_like(parse_measure("chord 62ft")));
  CHECK_FALSE(parse_measure("chord 3m+7m").is_like(parse_measure("chord 7m+3m")));
  CHECK_FALSE(parse_measure("chord 10m").is_like(parse_measure("uniformity 10m")));
  CHECK(parse_measure("D1").is_like(parse_measure("3m-25m")));
  CHECK_FALSE(parse_measure("D1").is_like(parse_measure("")));
  for (const char* const text : {"D4", "3-25", "25m-3m", "3m-3.2m", "3m-", "-3m", "chord",
                                 "chord 10", "chord 0m", "chord 3m+", "chord 3m+-7m",
                                 "uniformity 3m+7m", "twist", "twist -3m", "change 62", "warp 3m"})
    CHECK_THROWS_AS(parse_measure(text), InputError);
  CHECK_THROWS_WITH(filters::parse_band("bands", "D9"),
                    Contains("bands: \"D9\"; allowed: D0, D1, D2, D3"));
}

// Limits of both signs are whole eighths of an inch, and no higher class allows more.
TEST_CASE("unit: the shipped limits of the FRA") {
  const auto root = std::filesystem::path(__FILE__).parent_path() / "../../..";
  const auto file = table::read_table(root / "tools/quality/fra-49-cfr-213.csv");
  std::map<std::string, std::vector<double>> rising;
  for (const auto& cells : file.rows) {
    const double low = units::parse_quantity("low", cells.at(4), units::length),
                 high = units::parse_quantity("high", cells.at(5), units::length);
    CAPTURE(cells.at(0), cells.at(1), cells.at(3));
    CHECK(cells.at(2) == "peak");
    CHECK(low == (cells.at(0) == "gauge" ? 56 * inch : -high));
    CHECK(std::abs(8 * high / inch - std::round(8 * high / inch)) < 1e-9);
    rising[cells.at(0) + " " + cells.at(1)].push_back(high);
  }
  CHECK(rising.size() == 8);
  for (const auto& [of, high] : rising) {
    CAPTURE(of);
    CHECK(high.size() == (of.find("uniformity") == of.npos ? 5 : 4));
    CHECK(std::ranges::is_sorted(high, std::greater<>{}));
  }
}
