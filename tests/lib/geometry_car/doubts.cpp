// Which rows a finding concerns, to the row: records of one channel, made so that it is known by
// hand.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <railbook/geometry_car/health.hpp>
#include <railbook/units/constants.hpp>

#include "support/one_channel.hpp"

using namespace railbook;
using namespace railbook::geometry_car;
using namespace railbook::geometry_car::one_channel;
using Catch::Matchers::Contains;

TEST_CASE("geometry car: both ends of a converter are masked, from the first row at one of them") {
  // One row in 29 at each end, and each value between comes once.
  const auto clipped = [](std::size_t at_low, std::size_t at_high) {
    std::vector<double> x;
    for (std::size_t k = 0; k < 900; ++k)
      x.push_back(0.04 * std::sin(0.01 * double(k)) + 1e-9 * double(k));
    for (std::size_t n = 0; n < at_low; ++n) x[100 + 29 * n] = -0.05;
    for (std::size_t n = 0; n < at_high; ++n) x[115 + 29 * n] = 0.05;
    return x;
  };
  for (const bool turned : {false, true}) {
    auto x = clipped(10, 20);
    if (turned)
      for (double& v : x) v = -v;
    Record r = record_of(Channel::lateral, x);
    const Health health = examine(r, {});
    const Finding* found = finding(health, Fault::still, "lateral");
    REQUIRE(found);
    CHECK(found->first == 100);
    CHECK(found->rows == 30);
    CHECK(found->size == Approx(0.1));
    CHECK(found->text == "30 rows at the ends of its range, masked");
    std::set<std::size_t> expected;
    for (std::size_t n = 0; n < 10; ++n) expected.insert(100 + 29 * n);
    for (std::size_t n = 0; n < 20; ++n) expected.insert(115 + 29 * n);
    CHECK(masked(record_of(Channel::lateral, x), Channel::lateral) == expected);
  }
}

TEST_CASE(
    "geometry car: equal values are still from 40 on, and from eight times the usual number") {
  // Of that many values, each held over so many rows but for one; fewer than a hundred tell no
  // usual number.
  for (const auto& [values, held, least] : {std::array<std::size_t, 3>{900, 1, 40},
                                            {300, 5, 40},
                                            {200, 10, 80},
                                            {150, 24, 192},
                                            {150, 30, 200},
                                            {80, 10, 40}})
    for (const std::size_t rows : {least - 1, least}) {
      std::vector<double> x;
      for (std::size_t k = 0; k < values; ++k)
        x.insert(x.end(), k == values / 2 ? rows : held, (k % 2 == 0 ? 1 : -1) * 1e-6 * double(k));
      Record r = record_of(height, x);
      const Health health = examine(r, {});
      INFO(values << " values over " << held << " rows, one over " << rows);
      const Finding* found = finding(health, Fault::still, "height_left");
      REQUIRE((found != nullptr) == (rows == least));
      const std::size_t from = values / 2 * held;
      CHECK(masked(record_of(height, x), height) ==
            (found ? range(from, from + rows) : range(0, 0)));
      if (!found) continue;
      CHECK(found->first == from);
      CHECK(found->rows == rows);
    }
}

TEST_CASE("geometry car: gravity left in shows in a median of 3 m/s^2") {
  for (const double level : {2.9, -2.9, 3.1, -3.1, 9.80665}) {
    auto x = alternating(800, 1e-5);
    for (double& v : x) v += level;
    Record r = record_of(Channel::vertical_right, x);
    const Health health = examine(r, {});
    const Finding* found = finding(health, Fault::level, "vertical_right");
    const bool told = std::abs(level) > 3;
    REQUIRE((found != nullptr) == told);
    const auto& doubted = health.doubted[static_cast<std::size_t>(Channel::vertical_right)];
    CHECK(rows_of(doubted).size() == (told ? 800 : 0));
    if (!told) continue;
    CHECK(found->size == Approx(level).epsilon(0.01));
    CHECK(found->first == 0);
    CHECK(found->rows == 800);
  }
}

TEST_CASE("geometry car: a gage outside of all track in service is doubted row by row") {
  const Layout layout;
  const double expected = layout.base - 76.2 * mm;
  for (const auto& [off, told] :
       {std::pair{-21.9, false}, {-22.1, true}, {44.9, false}, {45.1, true}}) {
    const auto x = quiet(800);
    Record r = record_of(Channel::gage_left, x);
    for (std::size_t k = 0; k < 800; ++k) {
      const bool here = k >= 300 && k < 500;
      r[Channel::gage_right][k] = expected - layout.beam + (here ? off * mm : 0) - x[k] +
                                  (k % 2 == 0 ? 0.001 : -0.001) * mm;
    }
    r[Channel::gage_left][310] = missing;
    r.elapsed[320] = -1;
    r.elapsed[0] = -1;  // means nothing
    const Health health = examine(r, {});
    INFO(off << " mm");
    const Finding* found = finding(health, Fault::level, "gage");
    REQUIRE((found != nullptr) == told);
    if (!told) continue;
    CHECK(found->rows == 200 - 2 - 2);  // and two where the sensors leap there, which are masked
    CHECK(found->size == Approx(expected + off * mm).epsilon(1e-4));
    CHECK_THAT(found->text, Contains(" mm in 196 of 794 rows, where base says 1413 to 1480"));
    const auto rows = rows_of(health.doubted[static_cast<std::size_t>(Channel::gage_left)]);
    CHECK(rows.count(299) + rows.count(500) + rows.count(310) + rows.count(320) == 0);
    CHECK(rows.count(302) + rows.count(497) == 2);
  }
}

TEST_CASE("geometry car: a distance that stands is doubted, where the car turns it is not") {
  struct Case {
    std::vector<long> marks;  // in the middle of a journey, or at its begin
    std::set<std::size_t> doubted;
    std::size_t first, rows;
  };
  const auto of = [](const std::vector<long>& begin, bool from_start) {
    std::vector<long> marks;
    const long before = from_start ? 0 : 400;
    const long direction = from_start ? 1 : begin[1] >= begin[0] ? 1 : -1;
    for (long k = before; k-- > 0;) marks.push_back(begin[0] - direction * (k + 1));
    marks.insert(marks.end(), begin.begin(), begin.end());
    const long step = marks.back() - marks[marks.size() - 2];
    while (marks.size() < 1000) marks.push_back(marks.back() + (step != 0 ? step : 1));
    return marks;
  };
  for (const bool from_start : {true, false})
    for (const Case& c :
         {Case{{7, 8, 9, 10, 11}, {}, 0, 0}, Case{{7, 8, 9, 9, 8, 7}, {}, 0, 0},
          Case{{7, 8, 9, 9, 10, 11}, {2, 3}, 3, 1}, Case{{7, 8, 9, 9, 9, 10, 11}, {2, 3, 4}, 3, 2},
          Case{{7, 8, 9, 9, 9, 8, 7}, {2, 3, 4}, 3, 2},
          Case{{7, 8, 8, 9, 9, 10}, {1, 2, 3, 4}, 2, 2}}) {
      Record r = record_of(height, quiet(1000));
      r.mark = of(c.marks, from_start);
      const Health health = examine(r, {});
      const std::size_t offset = from_start ? 0 : 400;
      std::set<std::size_t> expected;
      for (const std::size_t k : c.doubted) expected.insert(k + offset);
      INFO(Catch::rangeToString(c.marks) << (from_start ? " at the begin" : " in the middle"));
      CHECK(rows_of(health.place_doubted) == expected);
      const Finding* found = finding(health, Fault::place, "distance");
      REQUIRE((found != nullptr) == !c.doubted.empty());
      if (!found) continue;
      CHECK(found->first == c.first + offset);
      CHECK(found->rows == c.rows);
      CHECK_THAT(found->text, Contains("stands still over " + std::to_string(c.rows) + " rows"));
    }
}
