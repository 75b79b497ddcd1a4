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
  Column sine, cosine;  // of the roll of the car body
  Column track;         // sine of the roll of the track
};

// Crosslevel's chain: the inclinometer less what else it feels, for the slow part; the roll gyro
// for the fast one.
Attitude attitude(const Run& run, const Processing& p) {
  const Column &yaw = run.yaw, &roll = run.roll;
  const Layout& l = p.layout;
  const Corrections& on = p.corrections;
  filters::ComplementaryFilter filter{filters::time_constant(p.roll_corner), p.roll_poles};
  Matched turn{l.second_corner}, centrifugal{l.second_corner}, rolling{l.second_corner};
  Attitude a{Column(run.size(), nan), Column(run.size(), nan), Column(run.size(), nan)};
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
    turn.push(yaw[k], T, run.decay[k]);
    centrifugal.push(v * yaw[k], T, run.decay[k]);
    rolling.push(roll[k], T, run.decay[k]);
    if (on.centrifugal) felt -= centrifugal.rate();
    if (on.yaw_centre) felt -= 0.5 * l.truck_spacing * turn.derivative();
    if (on.roll_acceleration) felt += l.inclinometer_height * rolling.derivative();
    const double slow = std::asin(std::clamp(felt / g, -0.5, 0.5));
    const double body =
        on.gyro ? filter.push(slow + rolling.held_back(), T * roll[k], T) : filter.push(slow, 0, T);
    a.sine[k] = std::sin(body);
    a.cosine[k] = std::cos(body);
    const double over =
        (run[Channel::height_left][k] - run[Channel::height_right][k]) / l.transducers;
    if (since >= settling) a.track[k] = a.sine[k] - over;
  }
  return a;
}

// Mean of a column over two intervals with the kernel of the short chord: a ramp up, a ramp down.
double triangle(const Column& x, std::size_t k, double before, double after) {
  return before * (x[k - 1] / 3 + 2 * x[k] / 3) + after * (2 * x[k] / 3 + x[k + 1] / 3);
}

double short_chord(View z, std::size_t k) {
  return z[k] - 0.5 * (z[k - 1] + z[k + 1]);
}

using Weights = std::vector<filters::SecondOrderHybrid::Weights>;

filters::SecondOrderHybrid second_order(const Processing& p) {
  return filters::SecondOrderHybrid{{2 * units::pi * p.layout.second_corner},
                                    {.how = p.decay, .local = p.local}};
}

// Of the intervals at each row, for all of the run's filters.
Weights weights_of(const Run& run, const Processing& p) {
  const filters::SecondOrderHybrid filter = second_order(p);
  Weights weights(run.size());
  for (std::size_t k = 2; k < run.size(); ++k) {
    const bool steady = k > 2 && run.T[k] == run.T[k - 1] && run.T[k - 1] == run.T[k - 2];
    weights[k] = steady ? weights[k - 1] : filter.weights(run.T[k - 1], run.T[k]);
  }
  return weights;
}

// Short chord offsets of the path of an accelerometer; `correction` is added to the acceleration at
// k, given the shares of the two intervals.
template <class Correction>
Column inertial(const Run& run, Channel accelerometer, const Processing& p, const Weights& weights,
                Correction correction, const Column& step) {
  filters::SecondOrderHybrid filter = second_order(p);
  Column m(run.size(), nan);
  for (std::size_t k = 0; k < run.size(); ++k) {
    auto two = filter.push(run[accelerometer][k], k == 0 ? 1.0 : run.T[k], &weights[k]);
    if (k < 2) continue;
    const double before = two.T_before / (two.T_before + two.T_after);
    two.mean += correction(k - 1, before, 1 - before);
    m[k - 1] = filters::short_chord(two, step.empty() ? 0.0 : step[k - 1]);
  }
  return m;
}

Column curvature(const Run& run, const Processing& p) {
  const Layout& l = p.layout;
  Column turn(run.size(), nan), body(run.size());
  for (std::size_t k = 0; k < run.size(); ++k)
    body[k] = (0.5 * (run[Channel::sway_front_a][k] + run[Channel::sway_front_b][k]) -
               run[Channel::sway_rear][k]) /
              l.truck_spacing;
  for (std::size_t k = 1; k < run.size(); ++k) {
    turn[k] = run.T[k] * run.yaw[k];
    if (p.corrections.truck_motion) turn[k] -= body[k] - body[k - 1];
    turn[k] *= run.direction;
  }
  return mean_curvature(turn, p, run.direction * std::lround(0.5 * l.truck_spacing / l.sample));
}

struct Sides {
  Column left, right;
};

Sides profile(const Run& run, const Attitude& att, const Processing& p, const Weights& weights,
              const Column& step) {
  const Layout& l = p.layout;
  // What the leaning body mixes into the vertical: the lateral force that the inclinometer feels,
  // through the same filters, and gravity.
  filters::SecondOrderHybrid filter = second_order(p);
  Column sideways(run.size(), nan);
  for (std::size_t k = 0; k < run.size(); ++k) {
    const auto two =
        filter.push(run[Channel::inclinometer][k], k == 0 ? 1.0 : run.T[k], &weights[k]);
    if (k > 0) sideways[k - 1] = two.mean;
  }
  const auto correction = [&](std::size_t k, double, double) {
    if (!p.corrections.vertical_attitude) return 0.0;
    return sideways[k] * att.sine[k] + g * (att.cosine[k] - 1);
  };
  const auto axle = [&](Channel accelerometer, Channel height) {
    Column m = inertial(run, accelerometer, p, weights, correction, step);
    for (std::size_t k = 1; k + 1 < m.size(); ++k) m[k] -= short_chord(run[height], k);
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

Sides alignment(const Run& run, const Attitude& att, const Processing& p, const Weights& weights) {
  const auto gravity = [&](std::size_t k, double before, double after) {
    return p.corrections.gravity ? -g * triangle(att.track, k, before, after) : 0.0;
  };
  const Column beam = inertial(run, Channel::lateral, p, weights, gravity, {});
  Sides s{Column(beam.size(), nan), Column(beam.size(), nan)};
  for (std::size_t k = 1; k + 1 < beam.size(); ++k) {
    const double path =
        beam[k] +
        (p.corrections.beam_height ? p.layout.beam_height * short_chord(att.track, k) : 0.0);
    s.left[k] = path + short_chord(run[Channel::gage_left], k);
    s.right[k] = path - short_chord(run[Channel::gage_right], k);
  }
  return s;
}

}  // namespace

void prepare(Run& run, const Record& record, const Processing& p) {
  load(run, record);
  const std::size_t n = run.size();
  run.decay.assign(n, nan);
  for (std::size_t k = 1; k < n; ++k)
    run.decay[k] = std::exp(-2 * units::pi * p.layout.second_corner * run.T[k]);
  const auto rates = [&](Channel gyro) {
    filters::FirstOrderHybrid c{2 * units::pi * p.layout.first_corner, p.decay};
    Column rate(n);
    for (std::size_t k = 0; k < n; ++k) rate[k] = c.push(run[gyro][k], k == 0 ? 1.0 : run.T[k]);
    return rate;
  };
  run.yaw = rates(Channel::yaw_rate);
  run.roll = rates(Channel::roll_rate);
}

Column short_chords(View z) {
  Column m(z.size(), nan);
  for (std::size_t k = 1; k + 1 < z.size(); ++k) m[k] = short_chord(z, k);
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
  const Attitude att = attitude(run, p);
  Column step;  // rise of the rails over the foot before each sample, where it is known
  const std::size_t known_steps = p.grade.empty() ? 0 : run.size();
  step.reserve(known_steps);
  for (std::size_t k = 0; k < known_steps; ++k) {
    const long before = marks[run.rows[k]] - (run.direction > 0 ? 1 : 0);
    const bool known = before >= 0 && before < static_cast<long>(p.grade.size());
    step.push_back(
        known ? run.direction * p.layout.sample * p.grade[static_cast<std::size_t>(before)] : 0.0);
  }
  const Weights weights = weights_of(run, p);
  const Sides up = profile(run, att, p, weights, step), across = alignment(run, att, p, weights);

  at(Parameter::gage).resize(run.size());
  for (std::size_t k = 0; k < run.size(); ++k)
    at(Parameter::gage)[k] =
        run[Channel::gage_left][k] + run[Channel::gage_right][k] + p.layout.beam;
  at(Parameter::curvature) = curvature(run, p);
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
