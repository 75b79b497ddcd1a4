#include <railbook/geometry_car/simulate.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::geometry_car {
namespace {

constexpr double longest = 0.1;  // s between two moments

// One step of a linear system x' = f(x, u, u') whose input runs straight from u0 at the slope du:
// the Taylor series of the solution, ended when a term no longer counts. |rates| * h about 1 at
// most.
template <class State, class Input, class Derivative>
void taylor_step(State& x, const Input& u0, const Input& du, double h, Derivative f) {
  State term = f(x, u0, du);
  double factor = h;
  for (int order = 1; order <= 60; ++order) {
    double largest = 0, size = 1e-300;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double step = factor * term[i];
      x[i] += step;
      largest = std::max(largest, std::abs(step));
      size = std::max(size, std::abs(x[i]));
    }
    if (order > 2 && largest < 1e-19 * size) return;
    term = order == 1 ? f(term, du, Input{}) : f(term, Input{}, Input{});
    factor *= h / (order + 1);
  }
}

// The track under the car at one moment.
enum Below { height, roll, roll_rear, line, line_rear, inputs };
using Input = std::array<double, inputs>;

enum Motions {
  z,
  z_rate,
  phi,
  phi_rate,
  path,
  slope,
  path_rear,
  slope_rear,
  sway,
  sway_rate,
  tail,
  tail_rate,
  f_z1,
  f_z2,
  f_phi1,
  f_phi2,
  f_roll1,
  f_roll2,
  f_beam1,
  f_beam2,
  f_incl1,
  f_incl2,
  b_yaw,
  b_roll,
  states
};
using State = std::array<double, states>;

// Attitude terms of second order, and their filters.
enum Terms { of_vertical, of_beam, of_inclinometer, of_yaw, terms };
using Extra = std::array<double, terms>;
using ExtraState = std::array<double, 7>;  // two for each F, one for B

struct Rates {
  double c_z, k_z, c_phi, k_phi, c_sway, k_sway, lean, c_truck, k_truck, w1, w2, span;
};

Rates rates_of(const Car& car) {
  const auto turns = [](const Mode& m) { return 2 * units::pi * m.frequency; };
  const Ride& r = car.ride;
  const double wz = turns(r.bounce), wp = turns(r.roll), ws = turns(r.sway);
  const double wave = 2 * units::pi / r.truck_wave;
  return {2 * r.bounce.damping * wz,
          wz * wz,
          2 * r.roll.damping * wp,
          wp * wp,
          2 * r.sway.damping * ws,
          ws * ws,
          r.lean * wp * wp / g,
          2 * r.truck_damping * wave,
          wave * wave,
          2 * units::pi * car.layout.first_corner,
          2 * units::pi * car.layout.second_corner,
          car.layout.truck_spacing};
}

// Lateral acceleration of the truck's path: v times the rate of its heading.
double path_acceleration(const Rates& r, double v, double y, double p, double u, double du) {
  return -r.c_truck * v * (v * p - du) - r.k_truck * v * v * (y - u);
}

State derivative(const Rates& r, double v, const State& x, const Input& u, const Input& du) {
  State d;
  const double front = path_acceleration(r, v, x[path], x[slope], u[line], du[line]);
  const double rear =
      path_acceleration(r, v, x[path_rear], x[slope_rear], u[line_rear], du[line_rear]);
  d[z] = x[z_rate];
  d[z_rate] = -r.c_z * (x[z_rate] - du[height]) - r.k_z * (x[z] - u[height]);
  const double under = 0.5 * (u[roll] + u[roll_rear]),
               under_rate = 0.5 * (du[roll] + du[roll_rear]);
  d[phi] = x[phi_rate];
  d[phi_rate] = -r.c_phi * (x[phi_rate] - under_rate) - r.k_phi * (x[phi] - under) +
                r.lean * (0.5 * (front + rear) + g * under);
  d[path] = v * x[slope];
  d[slope] = -r.c_truck * (v * x[slope] - du[line]) - v * r.k_truck * (x[path] - u[line]);
  d[path_rear] = v * x[slope_rear];
  d[slope_rear] = -r.c_truck * (v * x[slope_rear] - du[line_rear]) -
                  v * r.k_truck * (x[path_rear] - u[line_rear]);
  d[sway] = x[sway_rate];
  d[sway_rate] = -r.c_sway * x[sway_rate] - r.k_sway * x[sway] - (front + g * u[roll]);
  d[tail] = x[tail_rate];
  d[tail_rate] = -r.c_sway * x[tail_rate] - r.k_sway * x[tail] - (rear + g * u[roll_rear]);
  const auto filter = [&](int first, double input) {
    const auto i = static_cast<std::size_t>(first);
    d[i] = r.w2 * (input - x[i]);
    d[i + 1] = r.w2 * (x[i] - x[i + 1]);
  };
  filter(f_z1, x[z]);
  filter(f_phi1, x[phi]);
  filter(f_roll1, u[roll]);
  filter(f_beam1, front + g * u[roll]);
  filter(f_incl1, front + d[sway_rate] + g * x[phi]);
  const double yaw = (v * (x[slope] - x[slope_rear]) + x[sway_rate] - x[tail_rate]) / r.span;
  d[b_yaw] = r.w1 * (yaw - x[b_yaw]);
  d[b_roll] = r.w1 * (x[phi_rate] - x[b_roll]);
  return d;
}

class Journey {
 public:
  Journey(const Track& track, const Car& car) : track_(track), car_(car), rates_(rates_of(car)) {
    const auto fastest = [](double a, double b) { return std::max(a, b); };
    stiffest_ = fastest(fastest(std::sqrt(rates_.k_z), std::sqrt(rates_.k_sway)),
                        fastest(fastest(rates_.w1, rates_.w2), std::sqrt(rates_.k_phi)));
  }

  void start(const Moment& m) {
    at_ = m;
    u_ = below(m.position);
    x_ = {};
    x_[z] = x_[f_z1] = x_[f_z2] = u_[height];
    x_[phi] = x_[f_phi1] = x_[f_phi2] = 0.5 * (u_[roll] + u_[roll_rear]);
    x_[f_roll1] = x_[f_roll2] = u_[roll];
    x_[path] = u_[line];
    x_[path_rear] = u_[line_rear];
    moving_ = 0;
  }

  void advance(const Moment& m) {
    const double h = m.time - at_.time;
    if (!(h > 0)) return;
    const double way = m.position - at_.position;
    const double v = std::abs(way) / h;
    if (way != 0) face(way > 0 ? 1 : -1, v);
    const Input u1 = below(m.position), begin = u_;
    Input du;
    for (std::size_t i = 0; i < du.size(); ++i) du[i] = (u1[i] - u_[i]) / h;
    const double from = at_.position, fastest = std::max(stiffest_, std::sqrt(rates_.k_truck) * v);
    // An eighth of the fastest time at most: the terms of second order are straight over a part.
    const auto parts = static_cast<int>(std::ceil(8 * h * fastest));
    at_.acceleration = m.acceleration;
    Extra e0 = extra(v, du);
    for (int i = 1; i <= parts; ++i) {
      taylor_step(x_, u_, du, h / parts, [&](const State& x, const Input& u, const Input& slope_u) {
        return derivative(rates_, v, x, u, slope_u);
      });
      const double share = static_cast<double>(i) / parts;
      for (std::size_t j = 0; j < u_.size(); ++j) u_[j] = begin[j] + du[j] * h * share;
      at_.position = from + way * share;
      const Extra e1 = extra(v, du);
      filter_extra(e0, e1, h / parts);
      e0 = e1;
    }
    u_ = u1;
    at_ = m;
  }

  void read(Record& record) const;

 private:
  double rail(const std::vector<double>& values, double position) const {
    const double place =
        std::clamp(position / track_.spacing, 0.0, static_cast<double>(values.size()) - 1.000001);
    const auto i = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(i);
    return values[i] + share * (values[i + 1] - values[i]);
  }

  Input below(double s) const {
    Input u;
    const double back = s - car_.layout.truck_spacing;
    const auto tilt = [&](double at) {
      return std::asin((rail(track_.z_left, at) - rail(track_.z_right, at)) / track_.base);
    };
    u[height] = 0.5 * (rail(track_.z_left, s) + rail(track_.z_right, s));
    u[roll] = tilt(s);
    u[roll_rear] = tilt(back);
    u[line] = 0.5 * (rail(track_.y_left, s) + rail(track_.y_right, s));
    u[line_rear] = 0.5 * (rail(track_.y_left, back) + rail(track_.y_right, back));
    return u;
  }

  // The slopes of the paths are per metre travelled: they change sign when the car turns back.
  void face(int direction, double v) {
    if (moving_ == 0 && v > 0) {
      const auto ahead = below(at_.position + direction * track_.spacing);
      x_[slope] = (ahead[line] - u_[line]) / track_.spacing;
      x_[slope_rear] = (ahead[line_rear] - u_[line_rear]) / track_.spacing;
    } else if (moving_ == -direction) {
      x_[slope] = -x_[slope];
      x_[slope_rear] = -x_[slope_rear];
    }
    moving_ = direction;
  }

  Extra extra(double v, const Input& du) const {
    const State d = derivative(rates_, v, x_, u_, du);
    const double front = v * d[slope];
    const double body = front + d[sway_rate], rolling = d[phi_rate];
    const double yaw =
        (v * (x_[slope] - x_[slope_rear]) + x_[sway_rate] - x_[tail_rate]) / rates_.span;
    const double lean = x_[phi], one_less = std::cos(lean) - 1;
    Extra e;
    e[of_vertical] =
        g * one_less - (body - car_.layout.inclinometer_height * rolling) * std::sin(lean);
    if (car_.ride.pitches) {
      const double s = at_.position, back = s - car_.layout.truck_spacing;
      const double rise = rail(track_.z_left, s) + rail(track_.z_right, s) -
                          rail(track_.z_left, back) - rail(track_.z_right, back);
      e[of_vertical] -= at_.acceleration * 0.5 * rise / car_.layout.truck_spacing;
    }
    e[of_beam] = front * (std::cos(u_[roll]) - 1) + g * (std::sin(u_[roll]) - u_[roll]);
    e[of_inclinometer] = body * one_less + g * (std::sin(lean) - lean);
    e[of_yaw] = yaw * one_less;
    return e;
  }

  // The terms jump with the slope of the track at grid points, and run straight over a part.
  void filter_extra(const Extra& first, const Extra& last, double h) {
    Extra de;
    for (std::size_t i = 0; i < de.size(); ++i) de[i] = (last[i] - first[i]) / h;
    taylor_step(filtered_, first, de, h, [&](const ExtraState& x, const Extra& e, const Extra&) {
      ExtraState d;
      for (std::size_t k = 0; k < 3; ++k) {
        d[2 * k] = rates_.w2 * (e[k] - x[2 * k]);
        d[2 * k + 1] = rates_.w2 * (x[2 * k] - x[2 * k + 1]);
      }
      d[6] = rates_.w1 * (e[of_yaw] - x[6]);
      return d;
    });
  }

  const Track& track_;
  const Car& car_;
  Rates rates_;
  double stiffest_ = 1;
  Moment at_;
  Input u_{};
  State x_{};
  ExtraState filtered_{};
  int moving_ = 0;  // direction of travel; 0: not yet
};

void Journey::read(Record& record) const {
  using enum Channel;
  const Layout& l = car_.layout;
  const auto put = [&](Channel c, double value) { record[c].push_back(value); };
  // s^2 F of an angle or height whose F runs in two states: its filtered second derivative.
  const auto second = [&](double input, int first) {
    const auto i = static_cast<std::size_t>(first);
    return rates_.w2 * rates_.w2 * (input - 2 * x_[i] + x_[i + 1]);
  };
  const double bounce = second(x_[z], f_z1) + filtered_[1];
  const double rolling = second(x_[phi], f_phi1);
  put(vertical_left, bounce + 0.5 * l.transducers * rolling);
  put(vertical_right, bounce - 0.5 * l.transducers * rolling);
  put(lateral, x_[f_beam2] - l.beam_height * second(u_[roll], f_roll1) + filtered_[3]);
  put(inclinometer, x_[f_incl2] - l.inclinometer_height * rolling + filtered_[5]);
  put(yaw_rate, x_[b_yaw] + filtered_[6]);
  put(roll_rate, x_[b_roll]);
  const double over = x_[z] - u_[height];
  const double tilt = 0.5 * l.transducers * (std::sin(x_[phi]) - std::sin(u_[roll]));
  put(height_left, over + tilt);
  put(height_right, over - tilt);
  // The truck turns under the body, which moves the two front sensors, 0.6 m before and behind its
  // centre, apart.
  const double body = (x_[path] + x_[sway] - x_[path_rear] - x_[tail]) / rates_.span;
  const double turn = 0.6 * (body - x_[slope] * (moving_ < 0 ? -1 : 1));
  put(sway_front_a, x_[sway] + turn);
  put(sway_front_b, x_[sway] - turn);
  put(sway_rear, x_[tail]);
  put(gage_left, rail(track_.y_left, at_.position) - x_[path] - 0.5 * l.beam);
  put(gage_right, x_[path] - rail(track_.y_right, at_.position) - 0.5 * l.beam);
}

}  // namespace

Record drive(const Track& track, const Car& car, const Motion& motion) {
  Record record;
  Journey journey{track, car};
  double last = 0;
  bool first = true;
  each_moment(motion, track.spacing, longest, [&](const Moment& m) {
    units::require_between("position of the car on the track", m.position, car.layout.truck_spacing,
                           track.length() + 1e-6, "m");
    if (first)
      journey.start(m);
    else
      journey.advance(m);
    first = false;
    if (m.node < 0 || m.node % track.substeps != 0) return;
    record.elapsed.push_back(m.time - last);
    record.mark.push_back(m.node / track.substeps);
    last = m.time;
    journey.read(record);
  });
  return record;
}

}  // namespace railbook::geometry_car
