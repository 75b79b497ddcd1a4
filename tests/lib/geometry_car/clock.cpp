// Times that cannot be: from which size on, and which rows are doubted. Only times; every sensor is
// dead.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <railbook/geometry_car/health.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::geometry_car;
using Catch::Matchers::Contains;

namespace {

const double sample = Layout{}.sample;

Record at_speeds(std::size_t rows, const std::function<double(std::size_t)>& speed) {
  Record r;
  // No two times in a row are the same to the last digit: those would be one that is held.
  for (std::size_t k = 0; k < rows; ++k)
    r.elapsed.push_back(sample / speed(k) * (k % 2 == 0 ? 1 : 1 + 1e-9));
  r.mark.resize(rows);
  std::iota(r.mark.begin(), r.mark.end(), 0);
  for (auto& all : r.values) all.assign(rows, std::numeric_limits<double>::quiet_NaN());
  return r;
}

struct Found {
  bool told = false;
  Finding finding{};
  std::size_t first = 0, rows = 0;  // that are doubted
};
Found clock_of(Record r) {
  const Health health = examine(r, {});
  Found f;
  for (const Finding& one : health.findings)
    if (one.fault == Fault::clock) f.told = true, f.finding = one;
  for (std::size_t k = r.size(); k-- > 0;)
    if (health.clock_doubted[k]) f.first = k, ++f.rows;
  return f;
}

Found leap(double v, double times, std::size_t at = 400, std::size_t rows = 1000) {
  return clock_of(at_speeds(rows, [&](std::size_t k) { return k == at ? v * times : v; }));
}

}  // namespace

TEST_CASE("geometry car: one time by 1.3 off is a leap, and doubts nine rows about it") {
  for (const double times : {1.29, 1.31, 1 / 1.29, 1 / 1.31}) {
    const bool told = std::abs(std::log(times)) > std::log(1.3);
    const Found f = leap(20, times);
    INFO(times);
    REQUIRE(f.told == told);
    CHECK(f.rows == (told ? 18 : 0));
    if (!told) continue;
    CHECK(f.first == 400 - 9);
    CHECK(f.finding.first == 400);
    CHECK(f.finding.rows == 1);
    CHECK(f.finding.size == Approx(std::abs(400 * (times * times - 1)) / (2 * sample)));
    CHECK_THAT(f.finding.text, Contains("the speed leaps once, as at "));
  }
}

TEST_CASE("geometry car: a leap of less than 12 m/s^2 from foot to foot is none") {
  for (const double rate : {11.9, 12.1}) {
    CHECK(leap(3, std::sqrt(1 + 2 * sample * rate / 9)).told == (rate > 12));
    CHECK(leap(4, std::sqrt(1 - 2 * sample * rate / 16)).told == (rate > 12));
  }
}

TEST_CASE("geometry car: a speed that leaps and stays is doubted to the end") {
  for (const double sign : {1.0, -1.0})
    for (const double rate : {5.9, 6.1, 30.0}) {
      // Means of nine rows before and behind, nine rows apart.
      const double after = std::sqrt(400 + sign * 18 * sample * rate);
      const Found f =
          clock_of(at_speeds(1000, [&](std::size_t k) { return k < 500 ? 20 : after; }));
      INFO(sign * rate);
      REQUIRE(f.told == (rate > 6));
      if (!f.told) {
        CHECK(f.rows == 0);
        continue;
      }
      // Five of nine rows are behind the leap from its fourth before it on.
      CHECK(f.finding.first == 496);
      CHECK(f.finding.rows == 1);
      CHECK(f.finding.size == Approx(rate));
      CHECK(f.first == 496 - 9);
      CHECK(f.rows == 1000 - f.first);
    }
}

TEST_CASE("geometry car: leaps within nine rows are one, named by the first, sized by the worst") {
  for (const std::size_t apart : {9, 10, 40}) {
    const auto speed = [&](std::size_t k) {
      return k == 400 ? 30.0 : k == 400 + apart ? 40.0 : k == 800 ? 28.0 : 20.0;
    };
    const Found f = clock_of(at_speeds(1000, speed));
    INFO(apart << " rows apart");
    REQUIRE(f.told);
    CHECK(f.finding.first == 400);
    CHECK(f.finding.rows == (apart > 9 ? 3 : 2));
    CHECK(f.finding.size == Approx((1600 - 400) / (2 * sample)));
    CHECK(f.rows == 18 + std::min<std::size_t>(apart, 18) + 18);
    CHECK_THAT(f.finding.text, Contains(apart > 9 ? "leaps 3 times" : "leaps 2 times"));
  }
}

TEST_CASE("geometry car: a leap is seen with nine known times before and behind it") {
  for (const std::size_t at : {9, 10, 11}) CHECK(leap(20, 2, at).told == (at >= 10));
  for (const std::size_t behind : {8, 9, 10})
    CHECK(leap(20, 2, 1000 - behind).told == (behind >= 9));
}

TEST_CASE("geometry car: a run of fewer than 36 rows has no speed to leap from") {
  for (const std::size_t rows : {35, 36}) {
    Record r = at_speeds(1000, [](std::size_t k) { return k == 18 ? 40.0 : 20.0; });
    for (std::size_t k = rows; k < 1000; ++k) r.mark[k] += 5;
    CHECK(clock_of(r).told == (rows == 36));
  }
}

TEST_CASE("geometry car: a typical speed under 0.5 or over 120 m/s is a slip of units") {
  for (const double v : {0.49, 0.51, 119.0, 121.0}) {
    const Found f = clock_of(at_speeds(1000, [&](std::size_t) { return v; }));
    INFO(v);
    REQUIRE(f.told == (v < 0.5 || v > 120));
    CHECK(f.rows == (f.told ? 1000 : 0));
    if (!f.told) continue;
    CHECK(f.finding.size == Approx(v));
    CHECK(f.finding.first == 0);
    CHECK(f.finding.rows == 1000);
  }
}

TEST_CASE("geometry car: more than three rejected times, and one in a thousand, are reported") {
  for (const auto& [rows, rejected, told] :
       {std::tuple<std::size_t, std::size_t, bool>{1000, 3, false},
        {1000, 4, true},
        {4000, 4, false},
        {3999, 4, true},
        {8000, 9, true}}) {
    Record r = at_speeds(rows, [](std::size_t) { return 20.0; });
    r.elapsed[0] = -1;  // means nothing
    for (std::size_t n = 0; n < rejected; ++n) r.elapsed[100 + 50 * n] = -1;
    const Found f = clock_of(r);
    INFO(rejected << " of " << rows);
    REQUIRE(f.told == told);
    if (!told) continue;
    CHECK(f.finding.rows == rejected);
    CHECK(f.finding.first == 0);
    CHECK(f.finding.text == std::to_string(rejected) + " of " + std::to_string(rows) +
                                " rows have no time that can be");
  }
}
