#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/vehicle/cycle_solver.hpp>
#include <railbook/vehicle/describing_function.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace railbook::vehicle;
using units::inch;
using units::pi;

TEST_CASE("describing function: tables that are no odd functions are refused") {
  using Table = std::vector<std::vector<double>>;
  const std::vector<double> x{0, 1, 2};
  CHECK_THROWS_AS((PiecewiseLinearGain{x, Table{{0.1, 1, 2}}}), InputError);
  CHECK_THROWS_AS((PiecewiseLinearGain{x, Table{{0, 1}}}), InputError);
  CHECK_THROWS_AS((PiecewiseLinearGain{x, Table{{0, std::nan(""), 1}}}), InputError);
  CHECK_THROWS_AS((PiecewiseLinearGain{std::vector<double>{0}, Table{{0}}}), InputError);
  CHECK_THROWS_AS((PiecewiseLinearGain{std::vector<double>{0, 2, 2}, Table{{0, 1, 2}}}),
                  InputError);
  CHECK_THROWS_AS((PiecewiseLinearGain{std::vector<double>{0.1, 1, 2}, Table{{0, 1, 2}}}),
                  InputError);
}

TEST_CASE("Each end of a branch of describing functions") {
  const QuasiLinearCar car{assemble({}, Suspension::dampers), wheelset::cn_table()};
  const auto hopf = hopf_points(car, 5, 100);
  REQUIRE_FALSE(hopf.empty());
  const auto walked = [&](const BranchOptions& options) {
    return trace_from(car, hopf[0], options);
  };
  const CycleBranch all = walked({});
  CHECK(all.end == BranchEnd::amplitude);
  const auto& last = all.points.back();
  CHECK(last.largest > 0.75 * inch);
  CHECK(all.points[all.points.size() - 2].largest <= 0.75 * inch);
  const double first = all.points.front().motion.speed;
  double low = first, high = first;
  for (const CyclePoint& p : all.points)
    low = std::min(low, p.motion.speed), high = std::max(high, p.motion.speed);
  BranchOptions options;
  REQUIRE(low < 0.99 * first);
  options.lowest_speed = 0.5 * (low + first);
  const auto slow = walked(options);
  CHECK(slow.end == BranchEnd::speed);
  CHECK(slow.points.back().motion.speed < options.lowest_speed);
  CHECK(slow.points[slow.points.size() - 2].motion.speed >= options.lowest_speed);
  options = {};
  options.highest_speed = 0.5 * (high + first);
  REQUIRE(high > 1.01 * first);
  const auto fast = walked(options);
  CHECK(fast.end == BranchEnd::speed);
  CHECK(fast.points.back().motion.speed > options.highest_speed);
  CHECK(fast.points[fast.points.size() - 2].motion.speed <= options.highest_speed);
  options = {};
  options.smallest_step = 1;
  CHECK(walked(options).end == BranchEnd::step);
  CHECK(walked(options).points.size() == 1);
  // Back from a cycle half way: towards smaller ones, down to half the first amplitude.
  const CyclePoint& middle = all.points[all.points.size() / 2];
  const auto back = trace_from(car, middle, -1, {});
  CHECK(back.end == BranchEnd::small_cycle);
  CHECK(back.points[1].largest < middle.largest);
  CHECK(back.points.back().largest < 0.018 * inch);
  CHECK(back.points[back.points.size() - 2].largest >= 0.018 * inch);
  CHECK(trace_from(car, middle, 1, {}).points[1].largest > middle.largest);
  for (int stop = 0; stop < 7; ++stop)
    for (int other = 0; other < stop; ++other)
      CHECK(std::string(to_string(BranchEnd(stop))) != to_string(BranchEnd(other)));
  // The first step is a quarter of the largest, in the scaled unknowns, and none is longer than
  // that.
  Unknowns before = scaled(all.points[0].motion);
  for (std::size_t k = 1; k < all.points.size(); ++k) {
    const Unknowns now = scaled(all.points[k].motion);
    const double length = (now - before).norm();
    if (k == 1) CHECK(length == Approx(0.25 * 0.03).epsilon(0.02));
    if (k == 2) CHECK(length == Approx(1.5 * 0.25 * 0.03).epsilon(0.02));
    CHECK(length < 1.06 * 0.03);
    before = now;
  }
}
