// What several sensors feel of one motion, each through its own filter, must add up to zero:
//
//   lateral:  inclinometer - accelerometer on the beam + (h - h_b) roll' - g d + h_b d'' - sway'',
//   d the roll of body against track vertical: left - right accelerometer - (their distance) roll'
//   yaw:      L yaw' - a(now) + a(when the rear truck's place was the front's) - sway'' of both
//   ends, a the acceleration of the path
//
#include <cmath>

#include <railbook/geometry_car/detail/health_parts.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::geometry_car {
namespace {

using units::nan;
constexpr double slowest = 4.5;  // m/s: below, a row is too long for the filters' times

// Of a rate that is sampled and goes through the analog filter F: value(k, filter, integral) of
// each row; NaN until F has settled after a start or a gap.
template <class Rate, class Value>
Column follow(const Run& run, double corner, Rate rate, Value value) {
  Column out(run.size(), nan);
  Matched filter{corner};
  double since = -1, integral = 0;
  for (std::size_t k = 1; k < run.size(); ++k) {
    const double T = run.T[k], now = rate(k);
    if (std::isnan(now)) {
      since = -1;
      continue;
    }
    if (since < 0) filter.settle(now);
    since = since < 0 ? 0 : since + T;
    filter.push(now, T, run.decay[k]);
    integral += T * now;
    if (since * corner >= 2) out[k] = value(k, filter, integral);
  }
  return out;
}

}  // namespace

std::vector<Balance> balances(const Run& run, const Processing& p, bool terms) {
  using enum Channel;
  const Layout& l = p.layout;
  const std::size_t n = run.size();
  const auto followed = [&](auto rate, auto value) {
    return follow(run, l.second_corner, rate, value);
  };
  const auto change_of = [&](Channel c) {
    return [&run, x = run[c]](std::size_t k) { return (x[k] - x[k - 1]) / run.T[k]; };
  };
  const auto derivative = [](std::size_t, const Matched& f, double) { return f.derivative(); };
  const auto angle = [](std::size_t, const Matched& f, double sum) { return sum - f.held_back(); };
  const auto turn = [&](std::size_t k) { return run.yaw[k]; };
  const auto roll = [&](std::size_t k) { return run.roll[k]; };
  const Column turning = followed(turn, derivative), rolling = followed(roll, derivative),
               rolled = followed(roll, angle),
               front_a = followed(change_of(sway_front_a), derivative),
               front_b = followed(change_of(sway_front_b), derivative),
               rear = followed(change_of(sway_rear), derivative);
  const auto height = [&](Channel c, double sign) {
    return followed(change_of(c), [&, x = run[c]](std::size_t k, const Matched& f, double) {
      return sign * (l.beam_height * f.derivative() - g * (x[k] - f.held_back())) / l.transducers;
    });
  };
  const Column left = height(height_left, 1), right = height(height_right, -1);
  std::vector<Balance> all(3);
  Balance &lateral_balance = all[0], &vertical = all[1], &yaw = all[2];
  const auto add = [&](Balance& b, Channel c, auto value) {
    Column x(terms ? n : 0, nan);
    b.sum.resize(n);
    std::size_t known = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double v = k > 0 && run.T[k] * slowest <= l.sample ? value(k) : nan;
      known += std::isnan(v) ? 0 : 1;
      b.sum[k] += v;
      if (terms) x[k] = v;
    }
    b.known = b.known && 4 * known >= n;
    b.channels.push_back(c);
    if (terms) b.terms.push_back(std::move(x));
  };
  const auto times = [](double factor, View x) {
    return [=](std::size_t k) { return factor * x[k]; };
  };
  add(lateral_balance, inclinometer, times(1, run[inclinometer]));
  add(lateral_balance, lateral, times(-1, run[lateral]));
  add(lateral_balance, roll_rate, times(l.inclinometer_height - l.beam_height, rolling));
  add(lateral_balance, height_left, times(1, left));
  add(lateral_balance, height_right, times(1, right));
  add(lateral_balance, sway_front_a, times(-0.5, front_a));
  add(lateral_balance, sway_front_b, times(-0.5, front_b));
  add(vertical, vertical_left, times(1, run[vertical_left]));
  add(vertical, vertical_right, times(-1, run[vertical_right]));
  add(vertical, roll_rate, times(-l.transducers, rolling));
  // Change since (backing: until) the other truck was here; only at a steady speed.
  const long apart = run.direction * std::lround(l.truck_spacing / l.sample);
  const auto there = [&](std::size_t k) {
    return static_cast<std::size_t>(static_cast<long>(k) - apart);
  };
  const auto steady = [&](std::size_t k) {
    return there(k) < n && there(k) > 0 && std::abs(run.T[k] - run.T[there(k)]) < 0.05 * run.T[k];
  };
  const auto change = [&](auto value) {
    return [&, value](std::size_t k) { return steady(k) ? value(k) - value(there(k)) : nan; };
  };
  const auto before = [&](double factor, const Column& x) {
    return [&, factor](std::size_t k) { return steady(k) ? factor * x[there(k)] : nan; };
  };
  add(yaw, yaw_rate, times(l.truck_spacing, turning));
  add(yaw, inclinometer, change(times(-1, run[inclinometer])));
  add(yaw, roll_rate,
      change([&](std::size_t k) { return g * rolled[k] - l.inclinometer_height * rolling[k]; }));
  add(yaw, sway_front_a, before(-0.5, front_a));
  add(yaw, sway_front_b, before(-0.5, front_b));
  add(yaw, sway_rear, times(1, rear));
  std::erase_if(all, [](const Balance& b) { return !b.known; });
  return all;
}

}  // namespace railbook::geometry_car
