// Sensors against each other: from which size on a contradiction is told, of which sign, and over
// which rows.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include <railbook/geometry_car/health.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::geometry_car;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

const Finding* finding(const Health& health, Fault fault, const char* what) {
  for (const Finding& f : health.findings)
    if (f.fault == fault && f.what == what) return &f;
  return nullptr;
}

// Two gages that grow steadily, by so much a row, and nothing else.
Record gages(std::size_t rows, double left, double right) {
  Record r;
  r.elapsed.assign(rows, Layout{}.sample / 20);
  r.mark.resize(rows);
  std::iota(r.mark.begin(), r.mark.end(), 0);
  for (auto& all : r.values) all.assign(rows, missing);
  for (std::size_t k = 0; k < rows; ++k) {
    r[Channel::gage_left][k] = left * static_cast<double>(k);
    r[Channel::gage_right][k] = right * static_cast<double>(k);
  }
  return r;
}

bool unlike(Record r) {
  return finding(examine(r, {}), Fault::inconsistent, "gage_left") != nullptr;
}

const Record& journey() {
  static const Record record = [] {
    TrackDescription d;
    d.length = 2600 * units::foot;
    d.substeps = 4;
    const Track track = build(d);
    Motion motion{.start = 80 * units::foot, .speed = 25};
    return drive(track, Car{}, motion.cruise(track.length() - motion.start - 0.01));
  }();
  return record;
}

std::size_t doubted(const Health& health, Channel c, std::size_t from, std::size_t to) {
  const auto& rows = health.doubted[static_cast<std::size_t>(c)];
  return static_cast<std::size_t>(std::count(rows.begin() + static_cast<std::ptrdiff_t>(from),
                                             rows.begin() + static_cast<std::ptrdiff_t>(to), true));
}

}  // namespace

TEST_CASE("geometry car: gages are unlike by as much as their length can prove") {
  // Over 2,000 differences, ten rows apart, 10 |l^2 - r^2| is to be 5 (l^2 + r^2); over 500 twice
  // as much, so all.
  const double just = std::sqrt(3.0), a = 1e-4;
  for (const double share : {0.99, 1.01}) {
    CHECK(unlike(gages(2010, a * just * share, a)) == (share > 1));
    CHECK(unlike(gages(2010, a, a * just * share)) == (share > 1));
    CHECK_FALSE(unlike(gages(490, a * just * share, 1e-3 * a)));
  }
  CHECK(unlike(gages(530, a, 0.01 * a)));
  Record r = gages(2010, 2 * a, a);
  const Health health = examine(r, {});
  CHECK(finding(health, Fault::inconsistent, "gage_left")->size == Approx(2));
}

TEST_CASE("geometry car: gages that change by less than 0.1 mm in ten rows prove nothing") {
  for (const double growth : {0.99e-5, 1.01e-5}) {
    CHECK(unlike(gages(2010, growth, 1e-8)) == (growth > 1e-5));
    CHECK(unlike(gages(2010, 1e-8, growth)) == (growth > 1e-5));
  }
}

TEST_CASE("geometry car: gages without a change in common prove nothing") {
  for (const Channel c : {Channel::gage_left, Channel::gage_right}) {
    Record r = gages(2010, 1e-4, 3e-4);
    for (double& v : r[c]) v = missing;
    CHECK_FALSE(unlike(r));  // one is dead
    for (auto& values : r.values) values.assign(r.size(), missing);
    CHECK_FALSE(unlike(r));  // both are
  }
}

TEST_CASE("geometry car: a value that one gage misses makes the two no less alike") {
  for (const Channel c : {Channel::gage_left, Channel::gage_right}) {
    Record r = gages(2010, 1e-4, 1.1e-4);
    r[c][700] = missing;
    CHECK_FALSE(unlike(r));
    r = gages(2010, 1e-4, 3e-4);
    r[c][700] = missing;
    CHECK(unlike(r));
  }
}

TEST_CASE("geometry car: a zero of the inclinometer is reported with its sign, from 0.1 m/s^2 on") {
  Record clean = journey();
  CHECK(examine(clean, {}).findings.empty());
  for (const double zero : {-0.4, -0.05, 0.05, 0.4}) {
    Record r = journey();
    for (double& v : r[Channel::inclinometer]) v += zero;
    const Health health = examine(r, {});
    const Finding* found = finding(health, Fault::level, "inclinometer");
    INFO(zero);
    REQUIRE((found != nullptr) == (std::abs(zero) > 0.1));
    for (const Channel c : {Channel::inclinometer, Channel::height_left, Channel::height_right})
      CHECK(doubted(health, c, 0, r.size()) == (found ? r.size() : 0));
    if (!found) continue;
    CHECK(found->size == Approx(zero).margin(0.03));
    CHECK(found->rows == r.size());
    CHECK(found->first == 0);
  }
}

TEST_CASE("geometry car: a zero that drifts away and back is doubted while it is away") {
  for (const double zero : {-0.5, 0.5}) {
    Record r = journey();
    const std::size_t n = r.size(), from = 900, to = 1700, drift = 200;
    REQUIRE(n > 2300);
    for (std::size_t k = from - drift; k < to + drift; ++k)
      r[Channel::inclinometer][k] +=
          zero * std::min({1.0, static_cast<double>(k + drift - from) / drift,
                           static_cast<double>(to + drift - k) / drift});
    const Health health = examine(r, {});
    const Finding* found = finding(health, Fault::level, "inclinometer");
    REQUIRE(found);
    CHECK(found->first >= from - drift - 128);
    CHECK(found->first <= from);
    CHECK(found->rows >= to - from);
    CHECK(found->rows <= to - from + 2 * drift + 2 * 128);
    for (const Channel c : {Channel::inclinometer, Channel::height_left, Channel::height_right}) {
      CHECK(doubted(health, c, from, to) == to - from);
      CHECK(doubted(health, c, 0, from - drift - 256) == 0);
      CHECK(doubted(health, c, to + drift + 256, n) == 0);
    }
  }
}
