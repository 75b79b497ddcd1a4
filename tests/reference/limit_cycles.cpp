// Limit cycles of the paper's car by a program of its own: the equations body by body (tests/support), probed with unit motions;
// Runge and Kutta's fixed steps; Newton on the closed orbit; multipliers from differences of orbits; and describing
// functions by sums over the cycle. Of lib/ only the car's data and the tables of wheel and rail are used.
// Each line is "file: text that stands in it".
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "../support/body_by_body.hpp"
#include "units/constants.hpp"
#include "wheelrail/paper_pairs.hpp"

using namespace railbook;
using namespace railbook::dynamics;
using units::foot, units::inch;
using Table = wheelrail::ConstraintFunctions;
using Complex = std::complex<double>;
using Point = Eigen::Matrix<double, 18, 1>;  // q, q'

namespace {

constexpr double two_pi = 2 * 3.14159265358979323846;

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
std::vector<Slider> sliders(const CarParameters& p) {
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

Equations equations(bool friction, double speed) {
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

Point flow(const Car& car, Point y, double time, int steps) {
  for (int k = 0; k < steps; ++k) y = car.step(y, time / steps);
  return y;
}

// Newton on y(T) = y, from where the front truck turns.
Closed close(const Car& car, Point y, double period, int steps) {
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
Closed settle(const Car& car, Point y, double seconds, int steps) {
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
double amplitude(const Car& car, const Closed& c) {
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

double largest_multiplier(const Closed& c) {
  const Eigen::VectorXcd all = c.map.eigenvalues();
  Eigen::Index own = 0;
  (all.array() - 1.0).abs().minCoeff(&own);
  double most = 0;
  for (Eigen::Index k = 0; k < 18; ++k)
    if (k != own) most = std::max(most, std::abs(all[k]));
  return most;
}

std::string digits(double x, int count) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", count, x);
  return text;
}

// The matrix that a motion q e^(lambda t) is a null vector of, for given sizes of the wheelsets' and the joints' motions.
using Gains = std::array<double, 3>;
const std::vector<double>& sines() {  // over half a cycle, in the middles of equal steps
  static const std::vector<double> all = [] {
    std::vector<double> out;
    for (int k = 0; k < 4000; ++k) out.push_back(std::sin(two_pi / 2 * (k + 0.5) / 4000));
    return out;
  }();
  return all;
}
Gains gains(const Table& table, double size) {
  Gains out{};
  for (const double s : sines()) {
    const double x = size * s, weight = 2 * s / (double(sines().size()) * size);
    out[0] += weight * table.R(x), out[1] += weight * table.D(x), out[2] += weight * table.Phi(x);
  }
  return out;
}
double friction_gain(const Slider& slider, double size) {
  double out = 0;
  for (const double s : sines())
    out += 2 * s / (double(sines().size()) * size) * slider.level *
           std::min(1.0, size * s / slider.stick);
  return out;
}

Eigen::Matrix<Complex, 9, 1> left_over(const Table& table, bool friction, double speed,
                                       Complex lambda, const Eigen::Matrix<Complex, 9, 1>& q) {
  const Equations e = equations(friction, speed);
  Eigen::Matrix<Complex, 9, 1> out =
      (lambda * lambda * e.mass + lambda * e.damping + e.stiffness) * q;
  for (std::size_t w = 0; w < 4; ++w) {
    const Complex x = e.lateral[w].cast<Complex>().dot(q);
    const Gains g = gains(table, std::abs(x));
    out -= e.force[w].cast<Complex>() * Eigen::Vector3d{g[0], g[1], g[2]} * x;
  }
  if (friction)
    for (const Slider& s : sliders(e.data)) {
      const Complex rate = lambda * s.row.cast<Complex>().dot(q);
      out += friction_gain(s, std::abs(rate)) * rate * s.row;
    }
  return out;
}

// (speed [ft/s], omega [rad/s]) of the cycle of this amplitude [in] near a guess, by Newton on all 20 unknowns.
struct Found {
  double speed, omega;
  Eigen::Matrix<Complex, 9, 1> shape = Eigen::Matrix<Complex, 9, 1>::Zero();
};
Found describe(const Table& table, bool friction, double inches, Found guess) {
  const double size = inches * inch;
  using Shape = Eigen::Matrix<Complex, 9, 1>;
  const Equations e = equations(friction, guess.speed * foot);
  const auto joints_here = friction ? sliders(e.data) : std::vector<Slider>{};
  const Complex lambda{0, guess.omega};
  Shape q;
  std::size_t lead = 0;  // the wheelset that moves most
  std::array<double, 4> sizes;
  sizes.fill(size);
  std::vector<double> rates(joints_here.size(), guess.omega * size / 2);
  const bool given = guess.shape.squaredNorm() > 0;  // a cycle nearby
  if (given) {
    q = guess.shape;
    for (std::size_t w = 0; w < 4; ++w)
      if (std::abs(e.lateral[w].cast<Complex>().dot(q)) >
          std::abs(e.lateral[lead].cast<Complex>().dot(q)))
        lead = w;
    const Complex largest = e.lateral[lead].cast<Complex>().dot(q);
    q *= size / std::abs(largest) * std::polar(1.0, -std::arg(largest));
  }
  for (int pass = 0; pass < 12 && !given;
       ++pass) {  // the nearest to a null vector, its sizes put in again
    Eigen::MatrixXcd D =
        lambda * lambda * e.mass + lambda * e.damping + e.stiffness.cast<Complex>();
    for (std::size_t w = 0; w < 4; ++w) {
      const Gains g = gains(table, sizes[w]);
      D -= (e.force[w] * Eigen::Vector3d{g[0], g[1], g[2]} * e.lateral[w].transpose())
               .cast<Complex>();
    }
    for (std::size_t k = 0; k < rates.size(); ++k)
      D += lambda * friction_gain(joints_here[k], rates[k]) *
           (joints_here[k].row * joints_here[k].row.transpose()).cast<Complex>();
    const Vector9 scale = e.mass.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXcd scaled = scale.asDiagonal() * D * scale.asDiagonal();
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(scaled, Eigen::ComputeFullV);
    q = scale.asDiagonal() * svd.matrixV().col(8);
    const auto moved = [&](const Vector9& row) { return Complex(row.cast<Complex>().dot(q)); };
    for (std::size_t w = 0; w < 4; ++w)
      if (std::abs(moved(e.lateral[w])) > std::abs(moved(e.lateral[lead]))) lead = w;
    const Complex largest = moved(e.lateral[lead]);
    q *= size / std::abs(largest) * std::polar(1.0, -std::arg(largest));
    for (std::size_t w = 0; w < 4; ++w) sizes[w] = std::abs(moved(e.lateral[w]));
    for (std::size_t k = 0; k < rates.size(); ++k)
      rates[k] = guess.omega * std::abs(moved(joints_here[k].row));
  }
  Eigen::VectorXd u(20);
  u << q.real(), q.imag(), guess.omega, guess.speed;
  const Vector9 weight = equations(friction, guess.speed * foot).mass.diagonal();
  const auto equations_left = [&](const Eigen::VectorXd& v) {
    Shape shape;
    shape.real() = v.head<9>(), shape.imag() = v.segment<9>(9);
    const auto r = left_over(table, friction, v[19] * foot, {0, v[18]}, shape);
    const Complex largest = e.lateral[lead].cast<Complex>().dot(shape);
    Eigen::VectorXd out(20);
    out << r.real().cwiseQuotient(weight), r.imag().cwiseQuotient(weight),
        1e3 * (largest.real() - size), 1e3 * largest.imag();
    return out;
  };
  double last = 0;
  for (int turn = 0; turn < 60; ++turn) {
    const Eigen::VectorXd r = equations_left(u);
    Eigen::MatrixXd J(20, 20);
    for (int j = 0; j < 20; ++j) {
      Eigen::VectorXd moved = u;
      const double h = j < 18 ? 1e-7 * size : 1e-6 * u[j];
      moved[j] += h;
      J.col(j) = (equations_left(moved) - r) / h;
    }
    const Eigen::VectorXd d = J.partialPivLu().solve(-r);
    const double share = std::max(std::abs(d[18] / u[18]), std::abs(d[19] / u[19]));
    u += std::min(1.0, 0.03 / share) * d;
    if (share < 1e-9) {
      Found out{u[19], u[18]};
      out.shape.real() = u.head<9>(), out.shape.imag() = u.segment<9>(9);
      std::size_t most = lead;
      const auto of = [&](std::size_t w) {
        return Complex(e.lateral[w].cast<Complex>().dot(out.shape));
      };
      for (std::size_t w = 0; w < 4; ++w)
        if (std::abs(of(w)) > std::abs(of(most)) * (1 + 1e-9)) most = w;
      if (most == lead) return out;
      const Complex back = size / std::abs(of(most)) * std::polar(1.0, -std::arg(of(most)));
      out.shape *= back;  // another wheelset has become the largest
      u.head<9>() = out.shape.real(), u.segment<9>(9) = out.shape.imag();
      lead = most;
    }
    last = share;
  }
  std::printf("no cycle of %g in near %g ft/s: last step %g\n", inches, guess.speed, last);
  std::exit(1);
}

struct Wanted {
  double speed;
  const char* written;
  double size;  // [in], and omega: near which describing functions have a cycle to begin with
  double omega;
  int of_amplitude, of_omega;  // digits
};
Closed settle(const Car& car, const Found& near, double seconds, int steps) {
  Point y;
  y << near.shape.real(), -near.omega * near.shape.imag();
  return settle(car, y, seconds, steps);
}
void cycles(const Table& table, bool friction, const std::vector<Wanted>& wanted) {
  for (const Wanted& w : wanted) {
    const Car car(equations(friction, w.speed * foot), table);
    const Found near = describe(table, friction, w.size, {w.speed, w.omega});
    const Closed c = settle(car, near, friction ? 20 : 40, friction ? 6000 : 4000);
    std::printf("tests/unit/dynamics_cycles_reference.cpp: {%s, %s, %s,\n", w.written,
                digits(amplitude(car, c), w.of_amplitude).c_str(),
                digits(two_pi / c.period, w.of_omega).c_str());
  }
}

void multipliers() {
  const Table& table = wheelrail::new_wheel_table();
  const Car first(equations(false, 150 * foot), table);
  Closed c = settle(first, describe(table, false, 0.404, {150, 13.1}), 60, 4000);
  for (const auto& [speed, written] :
       {std::pair{151.0, ""}, {152.0, ""}, {153.0, "153.0"}, {153.5, "153.5"}, {154.0, "154.0"}}) {
    const Car car(equations(false, speed * foot), table);
    c = close(car, c.start, c.period, 8000);
    if (*written)
      std::printf("tests/unit/dynamics_cycles_reference.cpp: {%s, %s}\n", written,
                  digits(largest_multiplier(c), 2).c_str());
  }
}

// Cycles of these amplitudes [in], written as they stand in the test, each from the one before: near one speed and frequency there
// are several, of one truck or of both.
void describing(const Table& table, bool friction, double amplitude, Found near,
                const std::vector<const char*>& wanted) {
  Found at = describe(table, friction, amplitude, near);
  for (const char* text : wanted) {
    for (const double goal = std::stod(text); amplitude < goal;) {
      amplitude = std::min(amplitude + 0.01, goal);
      at = describe(table, friction, amplitude, at);
    }
    std::printf("tests/unit/dynamics_paper_branches.cpp: {%s, %s, %s,\n", text,
                digits(at.speed, 2).c_str(), digits(at.omega, 2).c_str());
  }
}

}  // namespace

int main() {
  const Table &fresh = wheelrail::new_wheel_table(), &cn = wheelrail::cn_table(),
              &heumann = wheelrail::heumann_table();
  cycles(fresh, false, {{146, "146", 0.401, 12.3, 5, 3}, {150, "150", 0.405, 13.1, 6, 4}});
  cycles(heumann, false, {{87, "87", 0.21, 26.1, 4, 3}, {87.4, "87.4", 0.22, 26.1, 4, 3}});
  cycles(cn, false, {{130.8, "130.8", 0.405, 21.5, 4, 3}, {131.5, "131.5", 0.413, 21.6, 4, 3}});
  cycles(cn, true, {{90, "90", 0.05, 14.2, 4, 3}, {100, "100", 0.12, 17, 4, 3}});
  multipliers();
  describing(fresh, false, 0.39, {144.5, 12.05}, {"0.41", "0.43", "0.45", "0.50", "0.60"});
  describing(fresh, false, 0.39, {152.4, 13.09}, {"0.43", "0.48"});
  describing(cn, false, 0.3, {130.3, 21.1}, {"0.30", "0.41", "0.48", "0.60"});
  describing(heumann, false, 0.2, {86.9, 26.1}, {"0.20", "0.30", "0.41"});
  describing(cn, true, 0.1, {98.7, 16.7}, {"0.10", "0.20", "0.30", "0.45"});
}
