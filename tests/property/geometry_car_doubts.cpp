// Which rows a finding concerns, to the row: records of one channel, made so that it is known by hand.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "../support/claim.hpp"
#include "geometry_car/health.hpp"
#include "units/constants.hpp"

using namespace railbook;
using namespace railbook::geometry_car;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

constexpr double mm = units::millimetre, missing = std::numeric_limits<double>::quiet_NaN();
constexpr auto height = Channel::height_left;

// At 20 m/s, every other channel dead.
Record record_of(Channel channel, const std::vector<double>& values) {
  Record r;
  r.elapsed.assign(values.size(), Layout{}.sample / 20);
  r.mark.resize(values.size());
  std::iota(r.mark.begin(), r.mark.end(), 0);
  for (auto& all : r.values) all.assign(values.size(), missing);
  r[channel] = values;
  return r;
}

// The column whose centred differences of that order (2 or 4) are these.
std::vector<double> summed(std::vector<double> differences, std::size_t order) {
  const auto reach = static_cast<std::ptrdiff_t>(order / 2);
  std::vector<double>& x = differences;
  std::rotate(x.begin(), x.end() - reach, x.end());
  std::fill_n(x.begin(), order, 0.0);
  for (std::size_t k = 0; k < order; ++k) std::partial_sum(x.begin(), x.end(), x.begin());
  return x;
}

std::vector<double> alternating(std::size_t rows, double size) {
  std::vector<double> e(rows);
  for (std::size_t k = 0; k < rows; ++k) e[k] = k % 2 == 0 ? size : -size;
  return e;
}

std::set<std::size_t> masked(const Record& before, Channel channel) {
  Record r = before;
  examine(r, {});
  std::set<std::size_t> rows;
  for (std::size_t k = 0; k < r.size(); ++k)
    if (std::isnan(r[channel][k]) && !std::isnan(before[channel][k])) rows.insert(k);
  return rows;
}

const Finding* finding(const Health& health, Fault fault, const std::string& what) {
  for (const Finding& f : health.findings)
    if (f.fault == fault && f.what == what) return &f;
  return nullptr;
}

std::set<std::size_t> rows_of(const std::vector<bool>& marked) {
  std::set<std::size_t> rows;
  for (std::size_t k = 0; k < marked.size(); ++k)
    if (marked[k]) rows.insert(k);
  return rows;
}

std::set<std::size_t> range(std::size_t from, std::size_t to) {
  std::set<std::size_t> rows;
  for (std::size_t k = from; k < to; ++k) rows.insert(k);
  return rows;
}

// A quiet height with changes of its own.
std::vector<double> quiet(std::size_t rows) {
  return alternating(rows, 2e-3 * mm);
}

}  // namespace

TEST_CASE("geometry car: what is out of proportion is judged by a block and one to either side") {
  tests::Draw draw(11);
  constexpr std::size_t rows = 1024, block = 128, blocks = rows / block;
  for (std::size_t b = 0; b < blocks; ++b)
    for (const std::size_t in_block : {std::size_t{5}, block - 1})
      for (const bool loud_enough : {true, false}) {
        const std::size_t row = std::min(b * block + in_block, rows - 3);
        // Rows whose difference is known: all but the first and the last of the run.
        const std::size_t from = b < 2 ? 1 : (b - 1) * block,
                          to = std::min((b + 2) * block, rows - 1);
        std::vector<std::size_t> window(to - from);
        std::iota(window.begin(), window.end(), from);
        // Loud: the row, both ends of the window, and others by chance, just half of them all, or one fewer.
        for (std::size_t i = window.size(); i-- > 1;)
          std::swap(window[i], window[static_cast<std::size_t>(draw(0, 1) * double(i + 1))]);
        std::stable_partition(window.begin(), window.end(),
                              [&](std::size_t k) { return k == row || k == from || k + 1 == to; });
        window.resize((window.size() + 1) / 2 - (loud_enough ? 0 : 1));
        std::vector<double> e = alternating(rows, 0.01 * mm);
        for (const std::size_t k : window) e[k] *= 100;
        e[row] = 10 * mm;
        INFO("row " << row << (loud_enough ? ": half of all are loud" : ": fewer are loud"));
        CHECK(masked(record_of(height, summed(e, 2)), height).count(row) == (loud_enough ? 0 : 1));
      }
}

TEST_CASE("geometry car: a jump of each kind of channel is masked from its own size on") {
  struct Kind {
    Channel channel;
    std::size_t order;
    double size;
  };
  for (const auto& [channel, order, size] :
       {Kind{height, 2, 3 * mm}, Kind{Channel::gage_right, 2, 3 * mm},
        Kind{Channel::yaw_rate, 2, 0.4 * units::degree}, Kind{Channel::lateral, 4, 0.06}})
    for (const double sign : {1.0, -1.0})
      for (const double share : {0.99, 1.01}) {
        std::vector<double> e = alternating(800, 1e-3 * size);
        e[400] = sign * share * size;
        INFO(channel_list()[static_cast<std::size_t>(channel)].name << ' ' << sign * share);
        CHECK(masked(record_of(channel, summed(e, order)), channel).size() ==
              (share > 1 ? 1u : 0u));
      }
}

TEST_CASE("geometry car: a coarse channel may jump by three of its steps, and nine of filtered") {
  for (const auto channel : {height, Channel::lateral}) {
    const bool filtered = channel == Channel::lateral;
    const double step = filtered ? 0x1p-6 : 0x1p-9;
    for (const int jump : {3, 4, 9, 10}) {
      std::vector<double> e(800, 0.0);
      for (std::size_t k = 30; k < 800; k += 20) e[k] = (k / 20 % 2 == 0 ? 1 : -1) * step;
      e[405] = jump * step;
      auto x = summed(e, filtered ? 4 : 2);
      for (double& v : x) v = std::round(v / step) * step;
      INFO(jump << " steps");
      CHECK(masked(record_of(channel, x), channel).count(405) ==
            (jump > (filtered ? 9 : 3) ? 1 : 0));
    }
  }
}

TEST_CASE("geometry car: the first four rows of a run are what they are") {
  for (std::size_t row = 1; row < 9; ++row) {
    std::vector<double> e = alternating(800, 0.01 * mm);
    e[row] = 10 * mm;
    CHECK(masked(record_of(height, summed(e, 2)), height).count(row) == (row < 4 ? 0 : 1));
  }
}

TEST_CASE("geometry car: at half of 10 m/s four times a jump is left, two rows to either side") {
  for (const long slow : {-3, -2, -1, 0, 1, 2, 3})
    for (const double jump : {11.9, 12.1}) {
      std::vector<double> e = alternating(800, 0.01 * mm);
      e[400] = jump * mm;
      Record r = record_of(height, summed(e, 2));
      r.elapsed[static_cast<std::size_t>(400 + slow)] = Layout{}.sample / 5;
      INFO(slow << " rows away, " << jump << " mm");
      CHECK(masked(r, height).count(400) == (std::abs(slow) <= 2 && jump < 12 ? 0 : 1));
    }
  // And from 10 m/s / sqrt(20) down no more than twenty times.
  for (const double jump : {59.0, 61.0}) {
    std::vector<double> e = alternating(800, 0.01 * mm);
    e[400] = jump * mm;
    Record r = record_of(height, summed(e, 2));
    r.elapsed[400] = Layout{}.sample / 1;
    CHECK(masked(r, height).count(400) == (jump < 60 ? 0 : 1));
  }
}

TEST_CASE("geometry car: jumps are counted, named by the first and sized by the largest") {
  struct Case {
    Channel channel;
    double jump;
    std::size_t reach, gap;
    std::string text;
  };
  for (const auto& [channel, jump, reach, gap, text] :
       {Case{height, 6 * mm, 1, 2, " mm, masked"},
        Case{Channel::yaw_rate, 1 * units::degree, 1, 2, " deg/s, masked"},
        Case{Channel::lateral, 0.3, 2, 4, " m/s^2, masked"}})
    for (const bool apart : {true, false}) {
      auto x = alternating(800, 1e-5 * jump);
      // Masked are the rows whose differences a spike moves; those of two are one where fewer than `gap` rows lie between.
      const std::size_t first = 300, second = first + 2 * reach + gap + (apart ? 1 : 0);
      x[first] += jump;
      x[second] -= 2 * jump;
      Record r = record_of(channel, x);
      const Health health = examine(r, {});
      const Finding* found = finding(
          health, Fault::jump, std::string{channel_list()[static_cast<std::size_t>(channel)].name});
      REQUIRE(found);
      CHECK(found->first == first - reach);
      CHECK(found->rows == (apart ? 2 : 1));
      CHECK(found->size == Approx(2 * jump).epsilon(0.01));
      CHECK_THAT(found->text, StartsWith(apart ? "2 jumps of up to " : "1 jump of up to "));
      CHECK_THAT(found->text, Catch::Matchers::EndsWith(text));
      auto expected = range(first - reach, second + reach + 1);
      if (apart)
        for (std::size_t k = first + reach + 1; k < second - reach; ++k) expected.erase(k);
      CHECK(masked(record_of(channel, x), channel) == expected);
      if (!apart) CHECK_FALSE(finding(health, Fault::step, found->what));
    }
}

TEST_CASE("geometry car: a zero is doubted from the row where it moves to where it is back") {
  for (const double sign : {1.0, -1.0}) {
    auto x = quiet(800);
    for (std::size_t k = 300; k < 500; ++k) x[k] += sign * 8 * mm;
    for (std::size_t k = 600; k < 800; ++k) x[k] -= sign * 5 * mm;
    Record r = record_of(height, x);
    const Health health = examine(r, {});
    const auto i = static_cast<std::size_t>(height);
    auto zeros = range(299, 499);
    zeros.merge(range(599, 800));
    CHECK(rows_of(health.zero_doubted[i]) == zeros);
    CHECK(rows_of(health.doubted[i]) == std::set<std::size_t>{299, 300, 499, 500, 599, 600});
    const Finding* step = finding(health, Fault::step, "height_left");
    REQUIRE(step);
    CHECK(step->first == 299);
    CHECK(step->rows == 3);
    CHECK(step->size == Approx(8 * mm).epsilon(0.01));
    CHECK(step->text == "its zero moved, by up to 8 mm");
  }
}

TEST_CASE("geometry car: a zero that is back to a sixth of its largest move is back") {
  const auto last_doubted = [](double there, double back) {
    auto x = quiet(800);
    for (std::size_t k = 300; k < 500; ++k) x[k] += there;
    for (std::size_t k = 500; k < 800; ++k) x[k] += there - back;
    Record r = record_of(height, x);
    return *rows_of(examine(r, {}).zero_doubted[static_cast<std::size_t>(height)]).rbegin();
  };
  CHECK(last_doubted(40 * mm, 34.2 * mm) == 498);
  CHECK(last_doubted(40 * mm, 33.8 * mm) == 799);
  CHECK(last_doubted(34.2 * mm, 40 * mm) == 498);
  CHECK(last_doubted(33.8 * mm, 40 * mm) == 799);
  CHECK(last_doubted(6 * mm, 4.6 * mm) == 498);  // 1.5 mm move the mean of nothing
  CHECK(last_doubted(6 * mm, 4.4 * mm) == 799);
}

TEST_CASE("geometry car: a jump that leaves two fifths of itself behind has moved the zero") {
  for (const double left : {0.38, 0.42})
    for (const double sign : {1.0, -1.0}) {
      auto x = quiet(800);
      x[400] += sign * 20 * mm;
      for (std::size_t k = 401; k < 800; ++k) x[k] += sign * left * 20 * mm;
      Record r = record_of(height, x);
      CHECK((finding(examine(r, {}), Fault::step, "height_left") != nullptr) == (left > 0.4));
    }
}

TEST_CASE("geometry car: a step on a parabola is the step") {
  for (const auto channel : {height, Channel::lateral}) {
    const double unit = channel == height ? mm : 0.01;
    auto x = alternating(800, 1e-5 * unit);
    for (std::size_t k = 0; k < 800; ++k) {
      const double t = (static_cast<double>(k) - 400) / 20;
      x[k] += unit * (0.7 * t + 0.2 * t * t + (k >= 400 ? 20 : 0));
    }
    Record r = record_of(channel, x);
    const Health health = examine(r, {});
    const Finding* step = finding(
        health, Fault::step, std::string{channel_list()[static_cast<std::size_t>(channel)].name});
    REQUIRE(step);
    CHECK(step->size == Approx(20 * unit).epsilon(0.001));
  }
}

TEST_CASE("geometry car: a step too near the end of a run for its parabola is a jump alone") {
  // A height's parabola takes three rows to either side of what is masked, of which one may be missing.
  for (const std::size_t behind : {1, 2, 3, 4, 5}) {
    auto x = quiet(800);
    const std::size_t at = 799 - behind;  // its second row, the last that is masked
    for (std::size_t k = at; k < 800; ++k) x[k] += 9 * mm;
    Record r = record_of(height, x);
    const Health health = examine(r, {});
    INFO(behind << " rows behind it");
    CHECK(finding(health, Fault::jump, "height_left"));
    CHECK((finding(health, Fault::step, "height_left") != nullptr) == (behind >= 2));
  }
}

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
  for (const auto& [low, high, second] :
       {std::array<std::size_t, 3>{9, 20, 1}, {20, 9, 1}, {20, 19, 2}, {20, 20, 2}, {19, 20, 2}}) {
    auto x = clipped(low, high);
    if (second == 2)  // values beside the ends that come twice
      x[101] = x[103] = -0.045, x[116] = x[118] = 0.045;
    Record r = record_of(Channel::lateral, x);
    INFO(low << " low, " << high << " high, beside each " << second);
    CHECK((finding(examine(r, {}), Fault::still, "lateral") != nullptr) ==
          (low >= 10 * second && high >= 10 * second));
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
  // At the very begin: one repeated mark is where a car may have turned; two are not.
  for (const auto& [marks, expected] :
       {std::pair{std::vector<long>{5, 5, 6, 7}, std::set<std::size_t>{}},
        {{5, 5, 4, 3}, {}},
        {{5, 5, 5, 6, 7}, {0, 1, 2}},
        {{5, 5, 5, 4, 3}, {0, 1, 2}},
        {{5, 6, 6, 5, 4}, {}},
        {{5, 6, 6, 7, 8}, {1, 2}}}) {
    Record r = record_of(height, quiet(1000));
    r.mark = of(marks, true);
    INFO(Catch::rangeToString(marks));
    const Health health = examine(r, {});
    CHECK(rows_of(health.place_doubted) == expected);
    if (!expected.empty())
      CHECK(finding(health, Fault::place, "distance")->first == *expected.begin() + 1);
  }
}

TEST_CASE("geometry car: the paper's speeds below which a parameter is degraded or worse") {
  for (const ParameterInfo& info : parameter_list()) {
    const std::string name{info.name};
    const bool curvature = name.rfind("curvature", 0) == 0,
               still = name == "gage" || name == "crosslevel" || name == "warp";
    INFO(name);
    const double mph = 1609.344 / 3600;
    CHECK(info.degraded_below == Approx(still ? 0 : curvature ? 2 * mph : 15 * mph));
    CHECK(info.unreliable_below == Approx(still ? 0 : curvature ? 2 * mph : 5 * mph));
    CHECK(info.si == (name == "curvature" ? 1e-3 : name == "curvature_rate" ? 1e-6 : 1e-3));
    CHECK(info.unit == (name == "curvature"        ? "rad_per_km"
                        : name == "curvature_rate" ? "rad_per_km2"
                                                   : "mm"));
  }
}
