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

// A sampled rate through the analog filter F; NaN until that has settled after a start or a gap.
struct Followed {
  Column integral, derivative, rate,
      held_back;  // of the filtered rate; what F holds back of the integral
};
Followed follow(const Column& rate, const Run& run, double corner) {
  const std::size_t n = rate.size();
  Followed f{Column(n, nan), Column(n, nan), Column(n, nan), Column(n, nan)};
  Matched filter{corner};
  double since = -1, integral = 0;
  for (std::size_t k = 1; k < n; ++k) {
    const double T = run.T[k];
    if (std::isnan(rate[k])) {
      since = -1;
      continue;
    }
    if (since < 0) filter.settle(rate[k]);
    since = since < 0 ? 0 : since + T;
    filter.push(rate[k], T);
    integral += T * rate[k];
    if (since * corner < 2) continue;
    f.held_back[k] = filter.held_back();
    f.integral[k] = integral - filter.held_back();
    f.rate[k] = filter.rate();
    f.derivative[k] = filter.derivative();
  }
  return f;
}

Followed follow_changes(const Run& run, Channel c, double corner) {
  Column rate(run.size(), nan);
  for (std::size_t k = 1; k < run.size(); ++k) rate[k] = (run[c][k] - run[c][k - 1]) / run.T[k];
  return follow(rate, run, corner);
}

}  // namespace

std::vector<Balance> balances(const Run& run, const Processing& p) {
  using enum Channel;
  const Layout& l = p.layout;
  const double corner = l.second_corner, over = l.inclinometer_height - l.beam_height;
  const Followed turn = follow(rates(run, yaw_rate, p), run, corner),
                 roll = follow(rates(run, roll_rate, p), run, corner);
  const auto term = [&](Channel c, auto value) {
    Term t{c, Column(run.size(), nan)};
    for (std::size_t k = 1; k < run.size(); ++k)
      if (run.T[k] * slowest <= l.sample) t.values[k] = value(k);
    return t;
  };
  const auto itself = [&](Channel c, double sign) {
    return term(c, [&, sign](std::size_t k) { return sign * run[c][k]; });
  };
  const auto rolling = [&](double arm) {
    return term(roll_rate, [&, arm](std::size_t k) { return arm * roll.derivative[k]; });
  };
  const auto height = [&](Channel c, double sign) {
    const Followed f = follow_changes(run, c, corner);
    return term(c, [&, sign](std::size_t k) {
      const double filtered = run[c][k] - f.held_back[k];
      return sign * (l.beam_height * f.derivative[k] - g * filtered) / l.transducers;
    });
  };
  const auto sway = [&](Channel c) {
    const Followed f = follow_changes(run, c, corner);
    return term(c, [&](std::size_t k) { return -0.5 * f.derivative[k]; });
  };
  // Change since (backing: until) the other truck was here; only at a steady speed.
  const long apart = run.direction * std::lround(l.truck_spacing / l.sample);
  const auto there = [&](std::size_t k) {
    return static_cast<std::size_t>(static_cast<long>(k) - apart);
  };
  const auto steady = [&](std::size_t k) {
    return there(k) < run.size() && there(k) > 0 &&
           std::abs(run.T[k] - run.T[there(k)]) < 0.05 * run.T[k];
  };
  const auto change = [&](Channel c, auto value) {
    return term(c,
                [&, value](std::size_t k) { return steady(k) ? value(k) - value(there(k)) : nan; });
  };
  const Followed front_a = follow_changes(run, sway_front_a, corner),
                 front_b = follow_changes(run, sway_front_b, corner),
                 rear = follow_changes(run, sway_rear, corner);
  const auto ends = [&](Channel c, const Followed& f) {
    return term(c, [&](std::size_t k) { return steady(k) ? -0.5 * f.derivative[there(k)] : nan; });
  };
  return {{itself(inclinometer, 1), itself(lateral, -1), rolling(over), height(height_left, 1),
           height(height_right, -1), sway(sway_front_a), sway(sway_front_b)},
          {itself(vertical_left, 1), itself(vertical_right, -1), rolling(-l.transducers)},
          {term(yaw_rate, [&](std::size_t k) { return l.truck_spacing * turn.derivative[k]; }),
           change(inclinometer, [&](std::size_t k) { return -run[inclinometer][k]; }),
           change(roll_rate,
                  [&](std::size_t k) {
                    return g * roll.integral[k] - l.inclinometer_height * roll.derivative[k];
                  }),
           ends(sway_front_a, front_a), ends(sway_front_b, front_b),
           term(sway_rear, [&](std::size_t k) { return rear.derivative[k]; })}};
}

}  // namespace railbook::geometry_car
