// The paper's car body by body in the time domain, and its closed orbits by Newton's method: what
// limit_cycles.cpp counts.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <railbook/units/constants.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "../support/body_by_body.hpp"

namespace railbook::reference {

using namespace railbook::vehicle;
using units::inch;
using Table = wheelset::ConstraintFunctions;
using Point = Eigen::Matrix<double, 18, 1>;  // q, q'

// M q'' = -C q' - K q + sum over wheelsets of G_i (R, D, Phi)(x_i) [- friction].
struct Equations {
  CarParameters data;
  bool friction = false;
  double speed = 0;
  Matrix9 mass, damping, stiffness;
  std::array<Eigen::Matrix<double, 9, 3>, 4> force;
  std::array<Vector9, 4> lateral;
};

// Rates of the joints where friction acts, with the number of alike ones, level and width.
struct Slider {
  Vector9 row;
  double level, stick;
};
inline std::vector<Slider> sliders(const CarParameters& p) {
  std::vector<Slider> out;
  for (const int truck : {0, 1}) {
    const double end = truck == 0 ? 1 : -1;
    const auto e = [](int c) { return Vector9(Vector9::Unit(c)); };
    out.push_back({e(X_TF + truck) - e(X_C) - end * p.half_truck_distance * e(TH_C) -
                       p.bolster_depth * e(PHI_C),
                   2 * p.lateral_friction, p.stick_speed});
    out.push_back({p.half_sideframe_spacing * e(PHI_C), 2 * p.vertical_friction, p.stick_speed});
    out.push_back({e(TH_WF + truck), p.warp_friction, p.stick_rate});
    out.push_back(
        {e(TH_TF + truck) + e(TH_WF + truck) - e(TH_C), p.centre_plate_friction, p.stick_rate});
  }
  return out;
}

inline Equations equations(bool friction, double speed) {
  Equations e;
  e.friction = friction, e.speed = speed;
  CarParameters& p = e.data;
  CarParameters smooth = p;  // without friction: its part is added by itself
  if (friction)
    smooth.lateral_friction = smooth.vertical_friction = smooth.warp_friction =
        smooth.centre_plate_friction = 0;
  const Vector9 none = Vector9::Zero();
  const ContactGeometry flat = [&](double) {
    return WheelContacts{p.wheel_radius, p.wheel_radius, 0, 0, 0};
  };
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) {
      const Vector9 u = Vector9::Unit(i), v = Vector9::Unit(j);
      e.mass(i, j) = kinetic_energy(p, u + v) - kinetic_energy(p, u) - kinetic_energy(p, v);
      e.stiffness(i, j) = -force_power(smooth, friction, speed, flat, v, none, u);
      e.damping(i, j) = -force_power(smooth, friction, speed, flat, none, v, u);
    }
  for (std::size_t w = 0; w < 4; ++w) {
    for (int j = 0; j < 9; ++j)
      e.lateral[w][j] = body_by_body::axle(p, Vector9::Unit(j), w >= 2, w % 2 == 1).x;
    for (int what = 0; what < 3; ++what)
      for (int i = 0; i < 9; ++i) {
        std::size_t asked = 0;  // wheelsets are asked for in their order
        const ContactGeometry one = [&](double) {
          const bool this_one = asked++ == w;
          const double R = this_one && what == 0, D = this_one && what == 1,
                       Phi = this_one && what == 2;
          return WheelContacts{p.wheel_radius + p.half_gauge * R, p.wheel_radius - p.half_gauge * R,
                               D, -D, Phi};
        };
        e.force[w](i, what) =
            force_power(smooth, friction, speed, one, none, none, Vector9::Unit(i));
      }
  }
  return e;
}

struct Car {
  Matrix9 damping, stiffness;  // over the mass
  std::array<Eigen::Matrix<double, 9, 3>, 4> force;
  std::array<Vector9, 4> lateral;
  std::vector<Slider> slider;
  std::vector<Vector9> pushed;
  const Table& table;

  Car(const Equations& e, const Table& t) : lateral(e.lateral), table(t) {
    const Matrix9 inverse = Eigen::MatrixXd(e.mass).inverse();
    damping = inverse * e.damping, stiffness = inverse * e.stiffness;
    for (std::size_t w = 0; w < 4; ++w) force[w] = inverse * e.force[w];
    if (e.friction) slider = sliders(e.data);
    for (const Slider& s : slider) pushed.push_back(inverse * s.row * s.level);
  }
  Point rate(const Point& y) const {
    Point out;
    out.head<9>() = y.tail<9>();
    Vector9 a = -damping * y.tail<9>() - stiffness * y.head<9>();
    for (std::size_t w = 0; w < 4; ++w) {
      const double x = lateral[w].dot(y.head<9>());
      a += force[w] * Eigen::Vector3d{table.R(x), table.D(x), table.Phi(x)};
    }
    for (std::size_t k = 0; k < slider.size(); ++k)
      a -= std::max(-1.0, std::min(1.0, slider[k].row.dot(y.tail<9>()) / slider[k].stick)) *
           pushed[k];
    out.tail<9>() = a;
    return out;
  }
  Point step(const Point& y, double h) const {
    const Point a = rate(y), b = rate(y + h / 2 * a), c = rate(y + h / 2 * b), d = rate(y + h * c);
    return y + h / 6 * (a + 2 * b + 2 * c + d);
  }
};

struct Closed {
  Point start;
  double period = 0;
  int steps = 0;
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(18, 18);
};

inline Point flow(const Car& car, Point y, double time, int steps) {
  for (int k = 0; k < steps; ++k) y = car.step(y, time / steps);
  return y;
}

// Newton on y(T) = y, from where the front truck turns.
inline Closed close(const Car& car, Point y, double period, int steps) {
  Closed out{y, period, steps};
  for (int turn = 0; turn < 12; ++turn) {
    const Point end = flow(car, out.start, out.period, steps);
    for (int j = 0; j < 18; ++j) {
      const double h = 1e-7 * (j < 9 ? 0.01 : 0.1);
      Point moved = out.start;
      moved[j] += h;
      out.map.col(j) = (flow(car, moved, out.period, steps) - end) / h;
    }
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(19, 19);
    a.topLeftCorner(18, 18) = out.map - Eigen::MatrixXd::Identity(18, 18);
    a.topRightCorner(18, 1) = car.rate(end);
    a(18, 9 + X_TF) = 1;
    Eigen::VectorXd b(19);
    b << out.start - end, 0;
    const Eigen::VectorXd d = a.partialPivLu().solve(b);
    out.start += d.head<18>();
    out.period += d[18];
    if (d.norm() < 1e-11) return out;
  }
  std::printf("an orbit did not close\n");
  std::exit(1);
}

// From a motion until it has settled, then closed.
inline Closed settle(const Car& car, Point y, double seconds, int steps) {
  double last = 0, period = 0;
  const double h = car.slider.empty() ? 2e-4 : 5e-5;  // friction that sticks is stiff
  for (double t = 0; t < seconds || y[9 + X_TF] > 0; t += h) {
    const Point next = car.step(y, h);
    if (y[9 + X_TF] > 0 && next[9 + X_TF] <= 0) {
      const double share = y[9 + X_TF] / (y[9 + X_TF] - next[9 + X_TF]);
      period = t + share * h - last, last = t + share * h;
      if (t > seconds) {
        y += share * (next - y);
        break;
      }
    }
    y = next;
  }
  return close(car, y, period, steps);
}

// Half of peak to peak of the largest wheelset [in], tops by parabolas.
inline double amplitude(const Car& car, const Closed& c) {
  double most = 0;
  for (const Vector9& row : car.lateral) {
    std::vector<double> x;
    Point y = c.start;
    for (int k = 0; k < c.steps; ++k, y = car.step(y, c.period / c.steps))
      x.push_back(row.dot(y.head<9>()));
    double high = 0, low = 0;
    const std::size_t n = x.size();
    for (std::size_t k = 0; k < n; ++k) {
      const double before = x[(k + n - 1) % n], after = x[(k + 1) % n],
                   bend = before - 2 * x[k] + after;
      const double top = bend == 0 ? x[k] : x[k] - (after - before) * (after - before) / (8 * bend);
      if (x[k] >= before && x[k] >= after) high = std::max(high, top);
      if (x[k] <= before && x[k] <= after) low = std::min(low, top);
    }
    most = std::max(most, (high - low) / 2);
  }
  return most / inch;
}

inline double largest_multiplier(const Closed& c) {
  const Eigen::VectorXcd all = c.map.eigenvalues();
  Eigen::Index own = 0;
  (all.array() - 1.0).abs().minCoeff(&own);
  double most = 0;
  for (Eigen::Index k = 0; k < 18; ++k)
    if (k != own) most = std::max(most, std::abs(all[k]));
  return most;
}

}  // namespace railbook::reference
