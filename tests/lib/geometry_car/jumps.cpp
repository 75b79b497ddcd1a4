// Which values of a channel are jumps, and where its zero has moved, to the row and to the limit.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <railbook/units/constants.hpp>

#include "support/claim.hpp"
#include "support/one_channel.hpp"

using namespace railbook;
using namespace railbook::geometry_car;
using namespace railbook::geometry_car::one_channel;
using Catch::Matchers::StartsWith;

namespace {

// A difference that is no kink, as joints of rails make: the next takes half of it back.
void spike(std::vector<double>& e, std::size_t row, double size) {
  e[row] = size;
  if (row + 1 < e.size()) e[row + 1] -= 0.5 * size;
}

}  // namespace

TEST_CASE("geometry car: outliers are judged over a block and its neighbours") {
  tests::RandomStream draw(11);
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
        // Loud: the row, both ends of the window, and others by chance, just half of them all, or
        // one fewer.
        for (std::size_t i = window.size(); i-- > 1;)
          std::swap(window[i], window[static_cast<std::size_t>(draw(0, 1) * double(i + 1))]);
        std::stable_partition(window.begin(), window.end(), [&](std::size_t k) {
          return k == row || k == row + 1 || k == from || k + 1 == to;
        });
        window.resize((window.size() + 1) / 2 - (loud_enough ? 0 : 1));
        std::vector<double> e = alternating(rows, 0.01 * mm);
        for (const std::size_t k : window) e[k] *= 100;
        spike(e, row, 10 * mm);
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
        spike(e, 400, sign * share * size);
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
      e[406] = -(jump / 2) * step;
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
    spike(e, row, 10 * mm);
    CHECK(masked(record_of(height, summed(e, 2)), height).count(row) == (row < 4 ? 0 : 1));
  }
}

TEST_CASE("geometry car: at half of 10 m/s four times a jump is left, two rows to either side") {
  for (const long slow : {-3, -2, -1, 0, 1, 2, 3})
    for (const double jump : {11.9, 12.1}) {
      std::vector<double> e = alternating(800, 0.01 * mm);
      spike(e, 400, jump * mm);
      Record r = record_of(height, summed(e, 2));
      r.elapsed[static_cast<std::size_t>(400 + slow)] = Layout{}.sample / 5;
      INFO(slow << " rows away, " << jump << " mm");
      CHECK(masked(r, height).count(400) == (std::abs(slow) <= 2 && jump < 12 ? 0 : 1));
    }
  // And from 10 m/s / sqrt(20) down no more than twenty times.
  for (const double jump : {59.0, 61.0}) {
    std::vector<double> e = alternating(800, 0.01 * mm);
    spike(e, 400, jump * mm);
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
      // Masked are the rows whose differences a spike moves; those of two are one where fewer than
      // `gap` rows lie between.
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
  // A height's parabola takes three rows to either side of what is masked, of which one may be
  // missing.
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

TEST_CASE("geometry car: a kink of a displacement is a joint, and no jump") {
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> e = alternating(800, 0.01 * mm);
    e[400] = sign * 10 * mm;
    Record r = record_of(height, summed(e, 2));
    CHECK(masked(r, height).empty());
    CHECK_FALSE(finding(examine(r, {}), Fault::jump, "height_left"));
  }
}
