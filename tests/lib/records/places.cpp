// Places of samples, and positions that a recorder rounds or that do not come evenly: limits where
// they are sharp.
#include <railbook/records/places.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <railbook/records/record.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::records;
using Catch::Matchers::Contains;

namespace {

// A record at those positions; missing: samples handed on that had none.
struct PlacedWheel {
  double spacing = 0;
  std::size_t samples = 0, missing = 0;
  std::string refused;
  explicit PlacedWheel(const std::vector<double>& positions, const RecordOptions& options = {}) {
    RecordStream stream{options, [](std::span<const double>) {}};
    try {
      for (std::size_t i = 0; i < positions.size(); ++i)
        stream.add(positions[i], 1e-3 * std::sin(0.7 * static_cast<double>(i)));
      stream.finish();
    } catch (const InputError& error) {
      refused = error.what();
    }
    spacing = stream.spacing(), samples = stream.samples(), missing = stream.missing();
  }
};

// Positions whose steps are those, over and over.
std::vector<double> stepping(const std::vector<double>& steps, std::size_t n, double first = 0) {
  std::vector<double> x{first};
  for (std::size_t i = 0; x.size() < n; ++i) x.push_back(x.back() + steps[i % steps.size()]);
  return x;
}

}  // namespace

TEST_CASE("unit: between nodes a place lies on their line, beyond them at the spacing") {
  for (const double direction : {1.0, -1.0}) {
    PlaceMap map(1, direction * 7, direction);
    CHECK(map.at(0) == direction * 7);
    CHECK(map.at(5) == direction * 12);
    // From sample 5 on: 100 steps of 1 m, 50 of 3 m.
    double x = 20;
    for (std::size_t i = 5; i <= 155; ++i) {
      map.add(i, direction * x);
      x += i < 105 ? 1 : 3;
    }
    CHECK(map.at(2) == direction * 17);
    for (const auto& [sample, place] :
         {std::pair{5, 20.0}, {55, 70.0}, {105, 120.0}, {106, 123.0}, {155, 270.0}, {160, 275.0}})
      CHECK(map.at(static_cast<std::size_t>(sample)) == Approx(direction * place).epsilon(1e-12));
    // 250 m in 150 steps; 3 m are 0.8 more, of which 1/50 may be the nodes' rounding.
    const auto u = map.unevenness();
    CHECK(u.overall == Approx(250 / 150.0));
    CHECK(u.spacing == Approx(3));
    CHECK(u.share == Approx(0.8 - 1 / 50.0));
    CHECK(u.from == Approx(direction * 120));
    CHECK(u.to == Approx(direction * 270));
  }
  // The begin may be what is out, and closer as well as farther.
  PlaceMap map;
  double x = 0;
  for (std::size_t i = 0; i <= 250; ++i) {
    map.add(i, x);
    x += i < 50 ? 1 : 4;
  }
  const auto u = map.unevenness();
  CHECK(u.overall == Approx(850 / 250.0));
  CHECK(u.share == Approx(1 - 1 / 3.4 - 1 / 50.0));
  CHECK(u.from == 0);
  CHECK(u.to == Approx(50));
}

TEST_CASE("unit: a piece goes on as long as half a spacing is kept") {
  for (const double off : {0.49, 0.51}) {
    PlaceMap map(2);
    for (const auto& [sample, x] : {std::pair{0, 0.0}, {10, 20 + 2 * off}, {20, 40.0}, {30, 60.0}})
      map.add(static_cast<std::size_t>(sample), x);
    // One line from 0 to 60 passes 10 at 20; else there is a node at each position that is left.
    CHECK((map.at(10) == Approx(20)) == (off < 0.5));
  }
}

TEST_CASE("unit: steps are of an even grid with samples lost, or rounded: by 60 % of one size") {
  // Steps of one and of two grid lengths. Lost samples leave gaps; rounding leaves none.
  const auto mixed = [](int ones, int of) {
    std::vector<double> steps;
    for (int k = 0; k < of; ++k) steps.push_back((k * ones) % of < ones ? 1 : 2);
    return steps;
  };
  for (const int ones : {62, 59}) {
    const PlacedWheel p(stepping(mixed(ones, 100), 2001));
    CAPTURE(ones, p.refused);
    CHECK(p.refused.empty());
    CHECK(p.spacing == Approx(ones > 60 ? 1 : 2 - 0.01 * ones).epsilon(1e-3));
    CHECK(p.samples == (ones > 60 ? 2001U + 20 * 38 : 2001U));
    CHECK(p.missing == p.samples - 2001);
  }
}

TEST_CASE("unit: a position read twice is an error but where positions are rounded") {
  for (const std::size_t n : {15, 16, 17, 40}) {  // positions: from 16 steps on rounding is seen
    std::vector<double> x;
    for (std::size_t i = 0; i < n; ++i) x.push_back(std::floor(0.8 * static_cast<double>(i)));
    const PlacedWheel p(x);
    CAPTURE(n, p.refused);
    CHECK(p.refused.empty() == (n >= 17));
  }
  for (const double spacing : {0.985, 0.975}) {  // of 100 steps to whole metres 1.5 or 2.5 are none
    std::vector<double> x;
    for (int i = 0; i < 401; ++i) x.push_back(std::floor(spacing * i));
    const PlacedWheel p(x);
    CAPTURE(spacing, p.refused);
    CHECK(p.refused.empty() == (spacing < 0.98));
  }
}

TEST_CASE("unit: the next sample lies within a quarter of a spacing of its place") {
  for (const std::size_t at : {500, 1500})  // before the spacing is settled, and after
    for (const double off : {-0.26, -0.24, 0.24, 0.26}) {
      auto x = stepping({2}, 2000, 100);
      x[at] += 2 * off;  // and the one after it lies as far off the other way
      const PlacedWheel p(x);
      CAPTURE(at, off, p.refused);
      CHECK(p.refused.empty() == (std::abs(off) < 0.25));
      if (off > 0.25)
        CHECK_THAT(p.refused, Contains("not evenly spaced: ") &&
                                  Contains("is followed by " + std::to_string(2 * at + 100)));
    }
}

TEST_CASE("unit: gaps of a record come to a million spacings and twenty for each sample") {
  for (const bool late : {false, true})
    for (const double beyond : {-1.0, 1.0}) {
      const std::size_t n = late ? 3000 : 500, at = late ? 2000 : 100;
      std::vector<double> x;
      for (std::size_t i = 0; i < n; ++i) x.push_back(static_cast<double>(i));
      // At sample `at` + 1 so many spacings have gone by.
      const double most = 1e6 + 20 * static_cast<double>(late ? at + 1 : n);
      for (std::size_t i = at; i < n; ++i)
        x[i] += most - static_cast<double>(late ? at : n - 1) + beyond;
      const PlacedWheel p(x);
      CAPTURE(late, beyond, p.refused);
      CHECK(p.refused.empty() == (beyond < 0));
      if (beyond < 0) CHECK(p.samples == static_cast<std::size_t>(x.back()) + 1);
    }
}

TEST_CASE("unit: a spacing that is given is the positions' own to half a per cent") {
  for (const double share : {-0.0051, -0.0049, 0.0049, 0.0051}) {
    const PlacedWheel p(stepping({0.25}, 3000), {.spacing = 0.25 / (1 + share)});
    CAPTURE(share, p.refused);
    CHECK(p.refused.empty() == (std::abs(share) < 0.005));
    if (!p.refused.empty()) CHECK_THAT(p.refused, Contains("spacing is given as"));
  }
}

TEST_CASE("unit: a spacing that changes is doubted from 0.3 % on and refused from 2 % on") {
  for (const double change : {0.0028, 0.0032, 0.0195, 0.0208}) {
    // Half of the record each: from the whole either differs by half of the change.
    std::vector<double> x{0};
    for (int i = 1; i <= 20000; ++i)
      x.push_back(x.back() + 0.25 * (1 + (i > 10000 ? 2 : 0) * change));
    RecordStream stream{{}, [](std::span<const double>) {}};
    for (std::size_t i = 0; i < x.size(); ++i)
      stream.add(x[i], 1e-3 * std::sin(0.7 * static_cast<double>(i)));
    CAPTURE(change);
    if (change > 0.02) {
      CHECK_THROWS_WITH(stream.finish(), Contains("changes of up to 2 %"));
    } else {
      stream.finish();
      CHECK(stream.warnings().size() == (change > 0.003 ? 1 : 0));
    }
  }
}

TEST_CASE("unit: a gap is bridged by a straight line up to its limit, whichever limit is longer") {
  const double lost = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [bridge, length] : {std::pair{4U, 0.0}, {0U, 1.1}, {4U, 0.6}, {1U, 1.1}})
    for (const std::size_t gap : {4U, 5U}) {
      std::vector<double> out;
      RecordStream stream{
          {.spacing = 0.25, .bridge = bridge, .bridge_length = length},
          [&](std::span<const double> s) { out.insert(out.end(), s.begin(), s.end()); }};
      for (std::size_t i = 0; i < 100; ++i)
        stream.add(i >= 50 && i < 50 + gap ? lost : 1e-3 * std::pow(static_cast<double>(i), 2));
      stream.finish();
      CHECK(stream.bridged() == (gap == 4 ? 4 : 0));
      CHECK(stream.missing() == (gap == 4 ? 0 : 5));
      CHECK(stream.samples() == 100);
      for (std::size_t i = 50; i < 50 + gap; ++i) {
        const double share = static_cast<double>(i - 49) / 5;
        if (gap == 4) CHECK(out[i] == Approx(1e-3 * (49 * 49 + share * (54 * 54 - 49 * 49))));
        if (gap == 5) CHECK(std::isnan(out[i]));
      }
    }
}
