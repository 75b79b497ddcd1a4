#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <railbook/num/random_stream.hpp>
#include <railbook/quality/alignment.hpp>
#include <railbook/quality/exceptions.hpp>
#include <railbook/quality/measure.hpp>
#include <railbook/quality/sections.hpp>
#include <railbook/spectra/reference_spectra.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/quantity.hpp>

using namespace railbook;
using namespace railbook::quality;
using Catch::Matchers::Contains;

namespace {

// Simpson's rule over the logarithm of the wavenumber.
double rms_mm(const spectra::Reference& r, double shortest, double longest) {
  const int n = 20000;
  const double from = std::log(1 / longest), step = (std::log(1 / shortest) - from) / n;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double phi = std::exp(from + step * i);
    sum += (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) * r.density(phi) * phi;
  }
  return 1e3 * std::sqrt(sum * step / 3);
}

}  // namespace

TEST_CASE("unit: reference spectra have the rms that two other methods found") {
  struct Known {
    const char *name, *channel;
    double d1, d2;  // mm, 3-25 m and 25-70 m; 0: not known
  };
  for (const Known& k :
       {Known{"german-low", "vertical", 0.98427, 1.65072},
        Known{"german-high", "vertical", 1.61090, 2.70163},
        Known{"german-low", "lateral", 0.71354, 0}, Known{"german-high", "lateral", 1.21313, 0},
        Known{"fra-1", "vertical", 8.54073, 14.4877}, Known{"fra-3", "vertical", 6.40828, 10.8704},
        Known{"fra-4", "vertical", 5.69123, 9.65409}, Known{"fra-5", "vertical", 3.55278, 6.02662},
        Known{"fra-6", "vertical", 1.42915, 2.42427},
        Known{"hamid-yang-1", "vertical", 5.40739, 13.0240},
        Known{"hamid-yang-4", "vertical", 2.27633, 5.48267},
        Known{"hamid-yang-6", "vertical", 1.29057, 3.10840},
        Known{"china-hsr", "vertical", 0.28642, 0.36233},
        Known{"china-hsr", "lateral", 0.26093, 0.32719}}) {
    const auto& r = spectra::reference(k.name, k.channel);
    CAPTURE(k.name, k.channel);
    CHECK(rms_mm(r, 3, 25) == Approx(k.d1).epsilon(1e-4));
    if (k.d2 > 0) CHECK(rms_mm(r, 25, 70) == Approx(k.d2).epsilon(1e-4));
  }
  CHECK_THROWS_WITH(spectra::reference("german-lo"), Contains("did you mean \"german-low\""));
}

TEST_CASE("unit: sections begin at multiples of their length, whichever way the record runs") {
  for (const double direction : {1.0, -1.0}) {
    quality::Sections sections{
        100, [&](std::size_t i) { return 1050 + direction * 0.25 * static_cast<double>(i); }};
    std::vector<double> z(1000);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = 5 + std::sin(0.1 * static_cast<double>(i));
    z[3] = std::numeric_limits<double>::quiet_NaN();
    sections.push(std::span{z}.first(333));
    sections.push(std::span{z}.subspan(333));
    REQUIRE(sections.all().size() == 3);
    CHECK(sections.all()[0].from == 1000);
    CHECK(sections.all()[1].from == 1000 + 100 * direction);
    CHECK(sections.all()[0].missing == 1);
    const quality::Section& s = sections.all()[1];
    // The plain sums of the same samples.
    const std::size_t first = sections.all()[0].samples;
    double sum = 0, square = 0;
    for (std::size_t i = first; i < first + s.samples; ++i) sum += z[i], square += z[i] * z[i];
    const auto n = static_cast<double>(s.samples);
    CHECK(s.samples == 400);
    CHECK(*s.deviation() == Approx(std::sqrt(square / n - sum * sum / n / n)).epsilon(1e-9));
    CHECK(s.highest == Approx(6).margin(1e-2));
  }
}

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

namespace {

// Rough track as a sum of many waves, so that it can be read anywhere.
double height(double x) {
  double z = 0;
  for (int k = 1; k < 60; ++k) z += std::cos(0.13 * k * x + k * k * 1.7) / k;
  return 1e-3 * z;
}

}  // namespace

TEST_CASE("unit: a run that slips against another is found again, to a fraction of a sample") {
  const double h = 0.25;
  std::vector<double> a(12000), b(12000);
  const auto slip = [](double x) {
    return 3.3 + 1e-3 * x;
  };  // m, what the second run counts too much
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = h * static_cast<double>(i);
    a[i] = height(x);
    b[i] = height(x - slip(x)) + 2e-5 * std::sin(37.0 * x);
  }
  for (std::size_t i = 5000; i < 5100; ++i) a[i] = std::numeric_limits<double>::quiet_NaN();
  const auto matches = quality::align(a, b, h);
  CHECK(matches.size() == 29);
  for (const auto& m : matches) {
    CHECK(m.found);
    CHECK(m.correlation > 0.95);
    const double x = h * static_cast<double>(m.centre);
    CHECK(m.offset == Approx(slip(x + m.offset)).margin(0.05));
  }
  CHECK(quality::offset_at(matches, 6000) == Approx(slip(1505)).margin(0.05));
}

TEST_CASE("unit: another track is not found") {
  std::vector<double> a(4000), b(4000);
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] = height(0.25 * static_cast<double>(i));
    b[i] = height(9000 + 0.31 * static_cast<double>(i));
  }
  for (const auto& m : quality::align(a, b, 0.25, {.least = 0.6})) {
    CHECK_FALSE(m.found);
    CHECK(m.offset / 0.25 == std::round(m.offset / 0.25));  // and not looked for between samples
  }
  const std::vector<double> still(a.size(), 0.0);  // is like nothing, and nothing like it
  for (const auto& matches : {quality::align(a, still, 0.25), quality::align(still, b, 0.25)})
    for (const auto& m : matches) {
      CHECK_FALSE(m.found);
      CHECK(m.correlation == -1);
    }
  CHECK(quality::offset_at({}, 7) == 0);
  CHECK_THROWS_AS(quality::align(a, b, 0), InputError);
  CHECK_THROWS_AS(quality::align(a, b, 0.25, {.window = 1}), InputError);
  CHECK_THROWS_AS(quality::align(a, b, 0.25, {.window = 5000}), InputError);
}
