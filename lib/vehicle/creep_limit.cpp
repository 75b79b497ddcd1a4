#include <railbook/vehicle/creep_limit.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::vehicle {

namespace {

struct Wheel {
  double a, r0, f11, f12, f22, f33, bound;  // mu N
};

Wheel wheel_of(const FreightCar& car, double friction) {
  const CarParameters& d = car.data;
  return {d.half_gauge, d.wheel_radius, d.f11, d.f12, d.f22, d.f33, friction * axle_load(d) / 2};
}

// Shares that the linear forces are of mu N, and d/d(lateral creepage, yaw rate over V,
// displacement).
struct Demand {
  std::array<double, 3> share;  // longitudinal, lateral, spin
  std::array<std::array<double, 3>, 3> slope;
};
Demand demand(const Wheel& w, const wheelset::ConstraintFunctions& table, const double* s) {
  const auto c = table.at(s[2]);
  const double x = w.f33 / w.bound, y = w.f11 / w.bound, z = w.f12 / w.bound;
  return {{x * (w.a * s[1] + w.a / w.r0 * c.R), y * s[0], z * (s[1] - c.D / w.r0)},
          {{{0, x * w.a, x * w.a / w.r0 * c.dR}, {y, 0, 0}, {0, z, -z / w.r0 * c.dD}}}};
}

struct Limited {
  std::array<double, 2> share;                 // longitudinal, lateral
  std::array<std::array<double, 3>, 2> slope;  // by the three shares asked for
};

Limited cubic(const std::array<double, 3>& t) {
  const double x = t[0], y = t[1] + t[2], size = std::hypot(x, y);
  // Force over demand, and its derivative over the demand.
  const double part = size < 3 ? 1 - size / 3 + size * size / 27 : 1 / size;
  const double bend = size == 0  ? 0
                      : size < 3 ? (-1.0 / 3 + 2 * size / 27) / size
                                 : -1 / (size * size * size);
  Limited r{{part * x, part * y}, {}};
  r.slope[0] = {part + bend * x * x, bend * x * y, bend * x * y};
  r.slope[1] = {bend * x * y, part + bend * y * y, part + bend * y * y};
  return r;
}

Limited by_curve(const CreepCurve& curve, const std::array<double, 3>& t) {
  Limited r{};
  double slope[6];
  curve(t.data(), r.share.data(), slope);
  for (std::size_t k = 0; k < 6; ++k) r.slope[k / 3][k % 3] = slope[k];
  return r;
}
Limited limited(const CreepLimit& limit, const std::array<double, 3>& t) {
  return limit.curve ? by_curve(limit.curve, t) : cubic(t);
}

// What friction takes from lateral force and moment of a wheelset: f, and d f/d s row by row.
void take(const Wheel& w, const Demand& d, const Limited& l, const double* s, double* f,
          double* slope) {
  const double x = d.share[0], y = d.share[1] + d.share[2], asked = x * x + y * y;
  const double given = l.share[0] * x + l.share[1] * y;  // along the demand
  const double part = asked > 0 ? given / asked : 1;
  const double moment = w.f12 * s[0] - w.f22 * w.bound / w.f12 * d.share[2];
  const bool spin = w.f12 > 0;
  f[0] = 2 * w.bound * (y - l.share[1]);
  f[1] = 2 * w.a * w.bound * (x - l.share[0]) + (spin ? 2 * (part - 1) * moment : 0);
  if (!slope) return;
  for (std::size_t i = 0; i < 3; ++i) {
    double fx = 0, fy = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      fx += l.slope[0][k] * d.slope[k][i];
      fy += l.slope[1][k] * d.slope[k][i];
    }
    const double dx = d.slope[0][i], dy = d.slope[1][i] + d.slope[2][i];
    slope[i] = 2 * w.bound * (dy - fy);
    slope[3 + i] = 2 * w.a * w.bound * (dx - fx);
    if (!spin || asked == 0) continue;
    const double part_slope =
        (fx * x + fy * y + l.share[0] * dx + l.share[1] * dy - 2 * part * (x * dx + y * dy)) /
        asked;
    const double moment_slope = (i == 0 ? w.f12 : 0) - w.f22 * w.bound / w.f12 * d.slope[2][i];
    slope[3 + i] += 2 * (part_slope * moment + (part - 1) * moment_slope);
  }
}

}  // namespace

void limit_creep(cycles::Oscillator& o, const FreightCar& car,
                 const wheelset::ConstraintFunctions& table, const CreepLimit& limit) {
  units::require_positive("friction of wheel and rail", limit.friction);
  const Wheel w = wheel_of(car, limit.friction);
  const auto shared = std::make_shared<const wheelset::ConstraintFunctions>(table);
  for (const Wheelset& set : car.wheels) {
    cycles::Coupling c;
    c.of_motion = c.of_rate = c.of_rate_by_speed = Eigen::MatrixXd::Zero(3, coordinates);
    c.of_rate_by_speed.row(0) = set.lateral.transpose();
    c.of_motion.row(0) = -set.yaw.transpose();
    c.of_rate_by_speed.row(1) = set.yaw.transpose();
    c.of_motion.row(2) = set.lateral.transpose();
    c.force.resize(coordinates, 2);
    c.force << set.lateral, set.yaw;
    c.law = [w, shared, limit](const double* s, double* f, double* slope) {
      const Demand d = demand(w, *shared, s);
      take(w, d, limited(limit, d.share), s, f, slope);
    };
    o.couplings.push_back(std::move(c));
  }
}

namespace {

// Of a column at -end, ..., 0, ..., end.
double between(const std::vector<double>& column, double step, double x) {
  const double at =
      std::clamp(x / step + 0.5 * double(column.size() - 1), 0.0, double(column.size() - 1) - 1e-9);
  const auto i = std::size_t(at);
  return column[i] + (at - double(i)) * (column[i + 1] - column[i]);
}

// What a wheel presses outwards over what it presses down.
double quotient(double angle, double outward) {
  const double t = std::tan(angle);
  return (t - outward) / (1 + outward * t);
}

}  // namespace

CycleForces cycle_forces(const FreightCar& car, const wheelset::ConstraintFunctions& table,
                         const CreepLimit& limit, const cycles::Cycle& cycle, int samples) {
  units::require_positive("friction of wheel and rail", limit.friction);
  units::require_between("samples of a period", samples, 8, 1 << 20);
  const Wheel w = wheel_of(car, limit.friction);
  CycleForces result;
  for (int j = 0; j < samples; ++j) {
    const Eigen::VectorXd y = cycles::state_at(cycle, 2 * units::pi * j / samples);
    const auto q = y.head<coordinates>(), v = y.tail<coordinates>();
    for (std::size_t i = 0; i < wheelsets; ++i) {
      const Wheelset& set = car.wheels[i];
      const double x = set.lateral.dot(q);
      const double s[3] = {cycle.inverse_speed * set.lateral.dot(v) - set.yaw.dot(q),
                           cycle.inverse_speed * set.yaw.dot(v), x};
      const auto asked = demand(w, table, s).share;
      const auto share = limited(limit, asked).share;
      // Creep pulls both wheels against their slip, to the left when the share is negative.
      const double left = -limit.friction * share[1], roll = table.at(x).Phi, h = table.R.step();
      double& worst = result.lateral_over_vertical[i];
      worst = std::max({worst, quotient(between(table.delta_left, h, x) + roll, left),
                        quotient(between(table.delta_right, h, x) - roll, -left)});
      result.creep[i] = std::max(result.creep[i], std::hypot(share[0], share[1]));
    }
  }
  return result;
}

}  // namespace railbook::vehicle
