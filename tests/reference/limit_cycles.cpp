// Limit cycles of the paper's car by a program of its own: the equations body by body
// (tests/support), probed with unit motions; Runge and Kutta's fixed steps; Newton on the closed
// orbit; multipliers from differences of orbits; and describing functions by sums over the cycle.
// Of lib/ only the car's data and the tables of wheel and rail are used. Each line is "file: text
// that stands in it".
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "closed_orbits.hpp"

using namespace railbook;
using namespace railbook::reference;
using units::foot, units::inch;
using Complex = std::complex<double>;

namespace {

constexpr double two_pi = 2 * 3.14159265358979323846;

std::string digits(double x, int count) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", count, x);
  return text;
}

// The matrix that a motion q e^(lambda t) is a null vector of, for given sizes of the wheelsets'
// and the joints' motions.
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

// (speed [ft/s], omega [rad/s]) of the cycle of this amplitude [in] near a guess, by Newton on all
// 20 unknowns.
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
    std::printf("tests/lib/vehicle/cycles_reference.cpp: {%s, %s, %s,\n", w.written,
                digits(amplitude(car, c), w.of_amplitude).c_str(),
                digits(two_pi / c.period, w.of_omega).c_str());
  }
}

void multipliers() {
  const Table& table = wheelset::new_wheel_table();
  const Car first(equations(false, 150 * foot), table);
  Closed c = settle(first, describe(table, false, 0.404, {150, 13.1}), 60, 4000);
  for (const auto& [speed, written] :
       {std::pair{151.0, ""}, {152.0, ""}, {153.0, "153.0"}, {153.5, "153.5"}, {154.0, "154.0"}}) {
    const Car car(equations(false, speed * foot), table);
    c = close(car, c.start, c.period, 8000);
    if (*written)
      std::printf("tests/lib/vehicle/cycles_reference.cpp: {%s, %s}\n", written,
                  digits(largest_multiplier(c), 2).c_str());
  }
}

}  // namespace

int main() {
  const Table &fresh = wheelset::new_wheel_table(), &cn = wheelset::cn_table(),
              &heumann = wheelset::heumann_table();
  cycles(fresh, false, {{146, "146", 0.401, 12.3, 5, 3}, {150, "150", 0.405, 13.1, 6, 4}});
  cycles(heumann, false, {{87, "87", 0.21, 26.1, 4, 3}, {87.4, "87.4", 0.22, 26.1, 4, 3}});
  cycles(cn, false, {{130.8, "130.8", 0.405, 21.5, 4, 3}, {131.5, "131.5", 0.413, 21.6, 4, 3}});
  cycles(cn, true, {{90, "90", 0.05, 14.2, 4, 3}, {100, "100", 0.12, 17, 4, 3}});
  multipliers();
}
