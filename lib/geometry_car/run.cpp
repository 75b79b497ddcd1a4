#include <railbook/geometry_car/detail/run.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/filters/complementary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::geometry_car {
namespace {

using units::nan;

struct Attitude {
  Column body;   // roll of the car body, rad
  Column track;  // sine of the roll of the track
};

// Crosslevel's chain: the inclinometer less what else it feels, for the slow part; the roll gyro
// for the fast one.
Attitude attitude(const Run& run, const Column& yaw, const Column& roll, const Processing& p) {
  const Layout& l = p.layout;
  const Corrections& on = p.corrections;
  filters::ComplementaryFilter filter{filters::time_constant(p.roll_corner), p.roll_poles};
  Matched turn{l.second_corner}, centrifugal{l.second_corner}, rolling{l.second_corner};
  Attitude a{Column(run.size(), nan), Column(run.size(), nan)};
  // A start forgets itself like a step through the poles: to a third of a per cent in this time.
  const double settling = (4 + 2 * p.roll_poles) * filters::time_constant(p.roll_corner);
  double since = -1;  // the start or the last missing value; negative: not begun
  for (std::size_t k = 1; k < run.size(); ++k) {
    const double T = run.T[k], v = run.direction * l.sample / T;
    double felt = run[Channel::inclinometer][k];
    if (std::isnan(yaw[k]) || std::isnan(roll[k]) || std::isnan(felt)) {
      filter.restart();
      since = -1;
      continue;
    }
    since = since < 0 ? 0 : since + T;
    if (since == 0) {
      turn.settle(yaw[k]);
      centrifugal.settle(v * yaw[k]);
      rolling.settle(roll[k]);
    }
    turn.push(yaw[k], T);
    centrifugal.push(v * yaw[k], T);
    rolling.push(roll[k], T);
    if (on.centrifugal) felt -= centrifugal.rate();
    if (on.yaw_centre) felt -= 0.5 * l.truck_spacing * turn.derivative();
    if (on.roll_acceleration) felt += l.inclinometer_height * rolling.derivative();
    const double slow = std::asin(std::clamp(felt / g, -0.5, 0.5));
    a.body[k] =
        on.gyro ? filter.push(slow + rolling.held_back(), T * roll[k], T) : filter.push(slow, 0, T);
    const double over =
        (run[Channel::height_left][k] - run[Channel::height_right][k]) / l.transducers;
    if (since >= settling) a.track[k] = std::sin(a.body[k]) - over;
  }
  return a;
}

// Mean of a column over two intervals with the kernel of the short chord: a ramp up, a ramp down.
double triangle(const Column& x, std::size_t k, double before, double after) {
  return before * (x[k - 1] / 3 + 2 * x[k] / 3) + after * (2 * x[k] / 3 + x[k + 1] / 3);
}

// Short chord offsets of the path of an accelerometer; `correction` is added to the acceleration at
// k, given the shares of the two intervals.
template <class Correction>
Column inertial(const Run& run, Channel accelerometer, const Processing& p, Correction correction,
                const Column& step) {
  filters::SecondOrderHybrid filter{{2 * units::pi * p.layout.second_corner},
                                    {.how = p.decay, .local = p.local}};
  Column m(run.size(), nan);
  for (std::size_t k = 0; k < run.size(); ++k) {
    auto two = filter.push(run[accelerometer][k], k == 0 ? 1.0 : run.T[k]);
    if (k < 2) continue;
    const double before = two.T_before / (two.T_before + two.T_after);
    two.mean += correction(k - 1, before, 1 - before);
    m[k - 1] = filters::short_chord(two, step.empty() ? 0.0 : step[k - 1]);
  }
  return m;
}

Column curvature(const Run& run, const Column& yaw, const Processing& p) {
  const Layout& l = p.layout;
  Column turn(run.size(), nan), body(run.size());
  for (std::size_t k = 0; k < run.size(); ++k)
    body[k] = (0.5 * (run[Channel::sway_front_a][k] + run[Channel::sway_front_b][k]) -
               run[Channel::sway_rear][k]) /
              l.truck_spacing;
  for (std::size_t k = 1; k < run.size(); ++k) {
    turn[k] = run.T[k] * yaw[k];
    if (p.corrections.truck_motion) turn[k] -= body[k] - body[k - 1];
    turn[k] *= run.direction;
  }
  return mean_curvature(turn, p, run.direction * std::lround(0.5 * l.truck_spacing / l.sample));
}

struct Sides {
  Column left, right;
};

Sides profile(const Run& run, const Attitude& att, const Processing& p, const Column& step) {
  const Layout& l = p.layout;
  // What the leaning body mixes into the vertical: the lateral force that the inclinometer feels,
  // through the same filters, and gravity.
  filters::SecondOrderHybrid filter{{2 * units::pi * l.second_corner},
                                    {.how = p.decay, .local = p.local}};
  Column sideways(run.size(), nan);
  for (std::size_t k = 0; k < run.size(); ++k) {
    const auto two = filter.push(run[Channel::inclinometer][k], k == 0 ? 1.0 : run.T[k]);
    if (k > 0) sideways[k - 1] = two.mean;
  }
  const auto correction = [&](std::size_t k, double, double) {
    if (!p.corrections.vertical_attitude) return 0.0;
    return sideways[k] * std::sin(att.body[k]) + g * (std::cos(att.body[k]) - 1);
  };
  const auto axle = [&](Channel accelerometer, Channel height) {
    Column m = inertial(run, accelerometer, p, correction, step);
    const Column over = short_chords(run[height]);
    for (std::size_t k = 0; k < m.size(); ++k) m[k] -= over[k];
    return m;
  };
  Sides s{axle(Channel::vertical_left, Channel::height_left),
          axle(Channel::vertical_right, Channel::height_right)};
  const double share = p.corrections.transducer_place ? 0.5 * (1 - l.base / l.transducers) : 0.0;
  for (std::size_t k = 0; k < s.left.size(); ++k) {
    const double inward = share * (s.left[k] - s.right[k]);
    s.left[k] -= inward;
    s.right[k] += inward;
  }
  return s;
}

Sides alignment(const Run& run, const Attitude& att, const Processing& p) {
  const auto gravity = [&](std::size_t k, double before, double after) {
    return p.corrections.gravity ? -g * triangle(att.track, k, before, after) : 0.0;
  };
  const Column beam = inertial(run, Channel::lateral, p, gravity, {});
  const Column rolled = short_chords(att.track);
  Sides s{short_chords(run[Channel::gage_left]), short_chords(run[Channel::gage_right])};
  for (std::size_t k = 0; k < beam.size(); ++k) {
    const double path =
        beam[k] + (p.corrections.beam_height ? p.layout.beam_height * rolled[k] : 0.0);
    s.left[k] = path + s.left[k];
    s.right[k] = path - s.right[k];
  }
  return s;
}

}  // namespace

Column rates(const Run& run, Channel gyro, const Processing& p) {
  filters::FirstOrderHybrid c{2 * units::pi * p.layout.first_corner, p.decay};
  Column rate(run.size());
  for (std::size_t k = 0; k < run.size(); ++k)
    rate[k] = c.push(run[gyro][k], k == 0 ? 1.0 : run.T[k]);
  return rate;
}

void Matched::push(double rate, double T) {
  const double k = w_ * T, a = std::exp(-k);
  second_ = rate + a * (second_ - rate + k * (first_ - rate));
  first_ = rate + a * (first_ - rate);
}

Column short_chords(const Column& z) {
  Column m(z.size(), nan);
  for (std::size_t k = 1; k + 1 < z.size(); ++k) m[k] = z[k] - 0.5 * (z[k - 1] + z[k + 1]);
  return m;
}

Column mean_curvature(const Column& turn, const Processing& p, long shift) {
  const auto n = static_cast<long>(turn.size());
  const long half = p.curvature_mean / 2;
  const double per = p.curvature_mean * p.layout.sample;
  Column c(turn.size(), nan);
  // turn[k] lies between k - 1 and k: a mean centred on a sample takes half of the outermost two.
  for (long i = half; i + half + 1 < n; ++i) {
    const long to = i - shift;
    if (to < 0 || to >= n) continue;
    double sum = 0.5 * (turn[static_cast<std::size_t>(i - half)] +
                        turn[static_cast<std::size_t>(i + half + 1)]);
    for (long j = i - half + 1; j <= i + half; ++j) sum += turn[static_cast<std::size_t>(j)];
    c[static_cast<std::size_t>(to)] = sum / per;
  }
  return c;
}

Column change_over(const Column& column, std::size_t span) {
  Column change(column.size(), nan);
  const std::size_t half = span / 2;
  for (std::size_t k = half; k + half < column.size(); ++k)
    change[k] = column[k + half] - column[k - half];
  return change;
}

std::size_t samples_needed(const Processing& p) {
  return 2 * (filters::reach(p.chain.high_pass) + static_cast<std::size_t>(p.chain.half_chord)) - 1;
}

filters::Geometry long_chord(const Column& short_offsets, const Processing& p) {
  if (short_offsets.size() >= samples_needed(p)) return filters::geometry(short_offsets, p.chain);
  return {Column(short_offsets.size(), nan), Column(short_offsets.size(), nan)};
}

std::size_t reach_of(Parameter parameter, const Processing& p) {
  using enum Parameter;
  const auto half_chord = static_cast<std::size_t>(p.chain.half_chord);
  const auto mean = static_cast<std::size_t>(p.curvature_mean) / 2 + 1;
  const auto car =
      static_cast<std::size_t>(std::lround(0.5 * p.layout.truck_spacing / p.layout.sample));
  switch (parameter) {
    case gage:
    case crosslevel:
      return 1;
    case warp:
      return half_chord + 1;
    case curvature:
      return mean + car;
    case curvature_rate:
      return 2 * mean + car;
    default:
      return filters::reach(p.chain.high_pass) + half_chord;
  }
}

std::array<Column, parameters> process(const Run& run, const Processing& p,
                                       const std::vector<long>& marks) {
  std::array<Column, parameters> out;
  const auto at = [&](Parameter q) -> Column& { return out[static_cast<std::size_t>(q)]; };
  const Column yaw = rates(run, Channel::yaw_rate, p), roll = rates(run, Channel::roll_rate, p);
  const Attitude att = attitude(run, yaw, roll, p);
  Column step;  // rise of the rails over the foot before each sample, where it is known
  for (const std::size_t i : run.rows) {
    const long before = marks[i] - (run.direction > 0 ? 1 : 0);
    const bool known = before >= 0 && before < static_cast<long>(p.grade.size());
    step.push_back(
        known ? run.direction * p.layout.sample * p.grade[static_cast<std::size_t>(before)] : 0.0);
  }
  const Sides up = profile(run, att, p, step), across = alignment(run, att, p);

  at(Parameter::gage).resize(run.size());
  for (std::size_t k = 0; k < run.size(); ++k)
    at(Parameter::gage)[k] =
        run[Channel::gage_left][k] + run[Channel::gage_right][k] + p.layout.beam;
  at(Parameter::curvature) = curvature(run, yaw, p);
  const auto span = static_cast<std::size_t>(p.curvature_mean), half = span / 2;
  auto& rate = at(Parameter::curvature_rate) = change_over(at(Parameter::curvature), span);
  for (double& value : rate)
    value *= run.direction / (2 * static_cast<double>(half) * p.layout.sample);
  auto& level = at(Parameter::crosslevel) = att.track;
  for (double& value : level) value *= p.layout.base;
  auto& twist = at(Parameter::warp) =
      change_over(level, 2 * static_cast<std::size_t>(p.chain.half_chord));
  for (double& value : twist) value *= run.direction;
  const auto finish = [&](const Column& m, Parameter chord, Parameter curve) {
    auto both = long_chord(m, p);
    at(chord) = std::move(both.chord);
    at(curve) = std::move(both.space_curve);
  };
  finish(up.left, Parameter::profile_left, Parameter::surface_left);
  finish(up.right, Parameter::profile_right, Parameter::surface_right);
  finish(across.left, Parameter::alignment_left, Parameter::line_left);
  finish(across.right, Parameter::alignment_right, Parameter::line_right);
  return out;
}

}  // namespace railbook::geometry_car
