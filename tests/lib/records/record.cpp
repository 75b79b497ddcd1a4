#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <railbook/records/record.hpp>
#include <railbook/records/record_file.hpp>
#include <railbook/records/resample.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

const double lost = std::numeric_limits<double>::quiet_NaN();

struct Collected {
  std::vector<double> out;
  records::RecordStream stream;
  explicit Collected(const records::RecordOptions& options)
      : stream(options,
               [this](std::span<const double> s) { out.insert(out.end(), s.begin(), s.end()); }) {}
};

}  // namespace

TEST_CASE("unit: an even record passes unchanged, with positions or without") {
  for (const bool positions : {false, true}) {
    Collected c{{.spacing = positions ? std::optional<double>{} : 0.3}};
    std::vector<double> in;
    for (int i = 0; i < 10000; ++i) {
      in.push_back(std::sin(i));
      positions ? c.stream.add(5 + 0.3 * i, in.back()) : c.stream.add(in.back());
    }
    c.stream.finish();
    CHECK(c.out == in);
    CHECK(c.stream.spacing() == Approx(0.3));
    CHECK(c.stream.samples() == 10000);
    CHECK(c.stream.missing() == 0);
  }
}

TEST_CASE("unit: positions rounded to a centimetre give the spacing and the grid") {
  Collected c{{}};
  for (int i = 0; i < 5000; ++i) c.stream.add(std::round(30.48 * i) / 100, i % 7);
  c.stream.finish();
  CHECK(c.stream.spacing() == Approx(0.3048).epsilon(1e-5));
  CHECK(c.out.size() == 5000);
}

TEST_CASE("unit: missing positions and missing values leave gaps, short ones are bridged") {
  for (const std::size_t bridge : {0U, 2U}) {
    Collected c{{.bridge = bridge}};
    for (const double x : {0., 1., 2., 5., 6., 10., 11., 12.})
      c.stream.add(x, x == 11 ? lost : 10 * x);
    c.stream.finish();
    REQUIRE(c.out.size() == 13);
    for (const std::size_t i : {0U, 1U, 2U, 5U, 6U, 10U, 12U})
      CHECK(c.out[i] == 10.0 * static_cast<double>(i));
    for (const std::size_t i : {3U, 4U, 11U})
      CHECK((bridge == 2 ? std::abs(c.out[i] - 10.0 * static_cast<double>(i)) < 1e-12
                         : std::isnan(c.out[i])));
    for (const std::size_t i : {7U, 8U, 9U}) CHECK(std::isnan(c.out[i]));
    CHECK(c.stream.missing() == (bridge == 2 ? 3 : 6));
    CHECK(c.stream.bridged() == (bridge == 2 ? 3 : 0));
  }
}

TEST_CASE("unit: gaps of up to a length are bridged, a step of the datum never") {
  Collected c{{.spacing = 0.25, .bridge_length = 1}};
  for (int i = 0; i < 1000; ++i)
    c.stream.add((i >= 300 && i < 304) || (i >= 600 && i < 605)
                     ? lost
                     : 0.001 * std::sin(0.7 * i) + (i < 800 ? 0 : 0.1));
  c.stream.finish();
  CHECK(c.stream.bridged() == 4);
  CHECK(c.stream.missing() == 6);
  CHECK(c.stream.faulty() == 1);
  CHECK(std::isnan(c.out[800]));
}

TEST_CASE("unit: places follow the positions to half a sample where the spacing drifts") {
  Collected c{{}};
  std::vector<double> x;
  for (int i = 0; i < 40000; ++i)
    x.push_back(i == 0 ? 100 : x.back() + 0.25 * (i < 15000 ? 1 : 1.01));
  for (std::size_t i = 0; i < x.size(); ++i)
    c.stream.add(std::round(100 * x[i]) / 100, 0.001 * std::sin(0.7 * static_cast<double>(i)));
  c.stream.finish();
  for (std::size_t i = 0; i < x.size(); i += 7)
    REQUIRE(std::abs(c.stream.places().at(i) - x[i]) < 0.2);
  REQUIRE(c.stream.warnings().size() == 1);
  CHECK(c.stream.warnings()[0].key == "spacing");
}

TEST_CASE("unit: positions may descend") {
  Collected c{{}};
  for (int i = 0; i < 3000; ++i)
    if (i != 2000) c.stream.add(1000 - 0.25 * i, 0.001 * std::sin(0.7 * i));
  c.stream.finish();
  CHECK(c.stream.spacing() == Approx(0.25));
  CHECK(c.stream.samples() == 3000);
  CHECK(c.stream.missing() == 1);
  CHECK(c.stream.places().at(0) == Approx(1000));
  CHECK(c.stream.places().at(2999) == Approx(1000 - 0.25 * 2999));
}

TEST_CASE("unit: positions that the recorder rounds give the grid, samples lost and all") {
  for (const double spacing : {0.25, 0.3048, 0.5, 0.2})
    for (const double quantum : {0.01, 0.05, 0.1, 0.2})
      for (const double sign : {1.0, -1.0}) {
        if (quantum > 0.45 * spacing) continue;  // as even as a grid with samples lost
        CAPTURE(spacing, quantum, sign);
        Collected c{{}};
        const int n = 20000;
        for (int i = 0; i < n; ++i)
          if (i % 997 != 500 && !(i > 9000 && i < 9040))
            c.stream.add(sign * quantum * std::round((5000 + spacing * i) / quantum),
                         0.001 * std::sin(0.7 * i));
        c.stream.finish();
        CHECK(c.stream.spacing() == Approx(spacing).epsilon(1e-4));
        CHECK(std::abs(static_cast<int>(c.stream.samples()) - n) <= 1);
        CHECK(std::abs(static_cast<int>(c.stream.missing()) - 59) <= 1);
        for (std::size_t i = 0; i < 19000; i += 371)
          CHECK(std::abs(c.stream.places().at(i) -
                         sign * (5000 + spacing * static_cast<double>(i))) < spacing + quantum);
      }
}

TEST_CASE("unit: positions in whole metres, or 40 cm, give the spacing of the record") {
  for (const auto& [spacing, quantum] : {std::pair{0.25, 1.0}, {0.1, 0.4}}) {
    CAPTURE(spacing, quantum);
    Collected c{{}};
    for (int i = 0; i < 40000; ++i)
      c.stream.add(quantum * std::floor(i * spacing / quantum + 1e-9), 0.001 * std::sin(0.7 * i));
    c.stream.finish();
    CHECK(c.stream.spacing() == Approx(spacing).epsilon(1e-3));
    CHECK(std::abs(static_cast<int>(c.stream.samples()) - 40000) < 8);
  }
}

namespace {

void read(const std::vector<double>& positions, const records::RecordOptions& options = {}) {
  records::RecordStream stream{options, [](std::span<const double>) {}};
  for (std::size_t i = 0; i < positions.size(); ++i)
    stream.add(positions[i], static_cast<double>(i % 5));
  stream.finish();
}

std::vector<double> even(std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = 0.5 * static_cast<double>(i);
  return x;
}

}  // namespace

TEST_CASE("input: positions that do not ascend evenly are refused, early or late in the record") {
  for (const std::size_t place : {5U, 1500U}) {
    auto x = even(2000);
    CHECK_NOTHROW(read(x));
    x[place] = x[place - 1];
    CHECK_THROWS_WITH(read(x), Catch::Contains("do not ascend"));
    x[place] = x[place - 1] - 3;
    CHECK_THROWS_WITH(read(x), Catch::Contains("do not ascend"));
    x[place] = x[place - 1] + 0.7;
    CHECK_THROWS_WITH(read(x), Catch::Contains("not evenly spaced"));
    x[place] = 1e9;
    CHECK_THROWS_WITH(read(x), Catch::Contains("jump too far"));
    x[place] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH(read(x), Catch::Contains("position of sample"));
    x[place] = std::numeric_limits<double>::quiet_NaN();  // a lost sample
    CHECK_NOTHROW(read(x));
  }
}

TEST_CASE("input: jumps that add up, and a spacing that changes, are refused wherever they are") {
  std::vector<double> jumps;
  for (int i = 0; i < 4500; ++i) jumps.push_back(i < 1500 ? i : 9e6 * i);
  CHECK_THROWS_WITH(read(jumps), Catch::Contains("jump too far"));
  std::vector<double> many;
  for (int i = 0; i < 200000; ++i) many.push_back(i < 1500 ? i : 40.0 * i);
  CHECK_THROWS_WITH(read(many), Catch::Contains("jump too far"));
  for (const int from : {40, 900, 20000, 39000, 39950})
    for (const double change : {0.8, 0.9, 1.05, 1.2192}) {
      std::vector<double> x{0};
      for (int i = 1; i < 40000; ++i) x.push_back(x.back() + 0.25 * (i < from ? 1 : change));
      CAPTURE(from, change);
      if ((from == 40 || from == 39950) && change == 1.05) continue;  // two samples off
      CHECK_THROWS_WITH(read(x), Catch::Contains("not evenly spaced"));
    }
}

TEST_CASE("input: turning, unknown and contradictory spacings are refused") {
  CHECK_NOTHROW(read({3, 2, 1, 0}));
  CHECK_THROWS_WITH(read({3, 2, 1, 2, 0}), Catch::Contains("do not descend"));
  CHECK_THROWS_WITH(read({3}), Catch::Contains("needs two"));
  CHECK_THROWS_WITH(read(even(2000), {.spacing = 0.3048}), Catch::Contains("0.5"));
  CHECK_THROWS_AS(read(even(10), {.spacing = -1}), InputError);
  records::RecordStream stream{{}, [](std::span<const double>) {}};
  stream.add(1);
  CHECK_THROWS_WITH(stream.finish(), Catch::Contains("spacing"));
}

TEST_CASE("input: a record that is empty, missing, constant or out of this world is refused") {
  const auto finish = [](const std::vector<double>& values) {
    records::RecordStream stream{{.spacing = 1}, [](std::span<const double>) {}};
    for (const double value : values) stream.add(value);
    stream.finish();
  };
  const double nan = std::nan("");
  CHECK_THROWS_WITH(finish({}), Catch::Contains("no finite sample"));
  CHECK_THROWS_WITH(finish({nan, nan}), Catch::Contains("no finite sample"));
  CHECK_THROWS_WITH(finish({2.5, 2.5, nan, 2.5}), Catch::Contains("constant signal"));
  CHECK_NOTHROW(finish({1, 2}));
  CHECK_NOTHROW(finish({1, -1e6}));
  CHECK_THROWS_WITH(finish({1, nan, 1e100}),
                    Catch::Contains("sample 3") && Catch::Contains("1e+100"));
  CHECK_THROWS_WITH(finish({-1e200}), Catch::Contains("from -1000000 to 1000000"));
}

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
