#include <railbook/records/record.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <railbook/units/input_error.hpp>

using namespace railbook;

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

TEST_CASE("unit: gaps at the ends are kept and never bridged") {
  Collected c{{.spacing = 1, .bridge = 10}};
  for (const double value : {lost, lost, 1., 2., lost}) c.stream.add(value);
  c.stream.finish();
  REQUIRE(c.out.size() == 5);
  CHECK(std::isnan(c.out[0]));
  CHECK(std::isnan(c.out[1]));
  CHECK(std::isnan(c.out[4]));
  CHECK(c.stream.missing() == 3);
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
  for (int i = 0; i < 40000; ++i)
    c.stream.add(std::round(100 * x[i]) / 100, 0.001 * std::sin(0.7 * i));
  c.stream.finish();
  for (std::size_t i = 0; i < x.size(); i += 7)
    REQUIRE(std::abs(c.stream.places().at(i) - x[i]) < 0.2);
  REQUIRE(c.stream.doubts().size() == 1);
  CHECK(c.stream.doubts()[0].key == "spacing");
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

TEST_CASE("unit: what comes of a record does not depend on the pieces it comes in") {
  for (const int kind : {0, 1, 2, 3}) {  // as it should be; rounded; a height, a position in error
    std::vector<double> x, z;
    for (int i = 0; i < 30000; ++i) {
      if (i % 5000 == 77) continue;
      x.push_back(kind == 1 ? std::round(2.5 * i) / 10 : 0.25 * i);
      const double height = 1e-5 * std::round(100 * std::sin(0.7 * i) + 30 * std::sin(0.011 * i));
      z.push_back(i % 3001 < 3 ? lost : i % 7001 < 2 ? -9.999 : height + (i < 20000 ? 0 : 0.1));
    }
    for (std::size_t i = 9000; i < 9050; ++i) z[i] = z[9000];
    if (kind == 2) z[25000] = 1e7;
    if (kind == 3) x[25000] = x[24999];
    const auto read = [&](std::size_t piece) {
      Collected c{{.bridge = 3}};
      std::string told;
      try {
        for (std::size_t i = 0; i < x.size(); i += piece) {
          const std::size_t n = std::min(piece, x.size() - i);
          c.stream.add({&x[i], n}, {&z[i], n});
        }
        c.stream.finish();
        for (const auto& doubt : c.stream.doubts()) told += doubt.text + "\n";
        for (const auto& f : c.stream.faults())
          told += std::to_string(f.first) + " " + std::to_string(f.count) + "\n";
      } catch (const InputError& error) {
        told = error.what();
      }
      std::replace_if(
          c.out.begin(), c.out.end(), [](double v) { return std::isnan(v); }, 999);
      return std::pair{told, c.out};
    };
    const auto one_by_one = read(1);
    CHECK((one_by_one.first.find("one value") == std::string::npos) == (kind > 1));
    for (const std::size_t piece : {7U, 1024U, 30000U}) {
      CAPTURE(kind, piece);
      const auto in_pieces = read(piece);
      CHECK(in_pieces.first == one_by_one.first);
      CHECK((kind > 1 || in_pieces.second == one_by_one.second));
    }
  }
}
