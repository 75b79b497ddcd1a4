/***
### Slow and stiff

Creep damps with $1/V$, so that a slow car is stiff: at 1 ft/s its fastest motion dies in 40 µs, while it hunts with a period of a minute.

{{slow-steps}}

An explicit method, and the Taylor series just as well, must follow the fastest decay, which nobody wants to see. The implicit one takes
steps of the motion's own size. From a few ft/s on it is not worth its price any more.

Two of the cases above are about eigenvalues. Around {{parallel-speed}} two strongly damped modes have nearly parallel shapes: a single
eigenvector is no good for following a mode there, but each mode still solves its equations to rounding. And two Hopf points
may coincide: with the body's yaw inertia times {{coincident-factor}} both modes of the car on new wheels turn critical at {{coincident-speed}}; the
determinant still lists both.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cycles.hpp"
#include "items.hpp"
#include "num/eigenvalues.hpp"
#include "units/input_error.hpp"
#include "wheelrail/paper_pairs.hpp"
#include "wheelrail/tabulate.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;
using units::foot;
using units::inch;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

const char* holds(double error, double allowed) {
  return error <= allowed ? "holds" : "fails";
}

double fastest_decay(const Oscillator& car) {
  StateMatrix J;
  compile(car).jacobian(State::Zero(), J);
  return -num::eigenvalues(J).real().minCoeff();
}

void slow(report::Item& item) {
  const Oscillator car =
      car_on_track(assemble({}, Suspension::dampers), wheelrail::new_wheel_table(), 1 * foot);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
  y[X_TF] = y[X_TR] = 0.2 * inch;
  HistoryOptions options = watching(car, 1e-8);
  options.integrator = Integrator::radau5;
  const History implicit = integrate(car, y, 60, options);
  const History exact = integrate(car, y, 5, watching(car));
  const History same = integrate(car, y, 5, options);
  const double error = (exact.y - same.y).head(9).lpNorm<Eigen::Infinity>() / inch;
  item.stability("slow", "V = 1 ft/s", fmt::format("fastest decay {:.3g} 1/s", fastest_decay(car)),
                 fmt::format("60 s in {} implicit steps; exact pieces need {} for 5 s",
                             implicit.steps, exact.steps),
                 error, holds(error, 1e-5));
}

void refused(report::Item& item) {
  std::string said = "not refused";
  try {
    (void)car_on_track(assemble({}, Suspension::dampers), wheelrail::new_wheel_table(), 0);
  } catch (const InputError& e) {
    said = e.what();
  }
  item.stability("standstill", "V = 0", "creepage divides by V", said, none,
                 said == "not refused" ? "fails" : "refused");
}

// The jump of two-point contact as it is: a table without the running mean, cut by the same step.
void raw_jump(report::Item& item) {
  const auto raw = wheelrail::tabulate(wheelrail::new_wheel_pair(),
                                       {.half_spacing = wheelrail::paper_track.half_spacing,
                                        .end = 0.75 * inch,
                                        .step = 0.0025 * inch});
  const CycleCase& c = cycle_case("new-150");
  const Oscillator car = car_on_track(assemble({}, Suspension::dampers), raw, c.speed);
  const History h = integrate(car, state_of(c.quasi.motion), 60, watching(car));
  const Swing s = largest_swing(h, 5);
  const Orbit orbit = shoot(car, h.y, 2 * units::pi / std::max(s.omega, 1.0));
  double a = 0;
  for (std::size_t i = 0; orbit.converged && i < wheelsets; ++i)
    a = std::max(a, amplitude(car, orbit, car.channels[i].row));
  const double error = orbit.converged ? std::abs(a / s.amplitude - 1) : none;
  item.stability("raw-jump", "new wheel, the jump not averaged", "contact angle jumps by 0.36 rad",
                 orbit.converged ? fmt::format("A = {:.5f} in (averaged: {:.5f})", a / inch,
                                               c.examined.amplitude / inch)
                                 : orbit.reason,
                 error, orbit.converged ? holds(error, 1e-6) : "degraded");
}

CycleCase with_stick(const CycleCase& c, double factor) {
  CarParameters data;
  data.stick_speed *= factor;
  data.stick_rate *= factor;
  CycleCase result = c;
  result.car = car_on_track(assemble(data, Suspension::friction), *c.study->table, c.speed);
  result.examined = examine(result.car, harmonics(result.car, c.examined.orbit, 23));
  return result;
}

void sticking(report::Item& item) {
  const CycleCase& c = cycle_case("friction-90");
  const CycleCase quarter = with_stick(c, 0.25);
  const double change = quarter.examined.converged
                            ? std::abs(quarter.examined.amplitude / c.examined.amplitude - 1)
                            : none;
  item.stability("stick", "CN with friction, 90 ft/s", "sticking rate a quarter",
                 quarter.examined.converged
                     ? fmt::format("A {:.5f} to {:.5f} in", c.examined.amplitude / inch,
                                   quarter.examined.amplitude / inch)
                     : quarter.examined.reason,
                 change, change <= 0.02 ? "holds" : "degraded");
  const CycleCase& small = cycle_case("friction-66");
  const double off = small.quasi.largest / small.examined.amplitude - 1;
  item.stability("small-friction", "CN with friction, 66 ft/s", "amplitude near the stuck car's",
                 fmt::format("{:.4f} in, describing function {:.4f}",
                             small.examined.amplitude / inch, small.quasi.largest / inch),
                 std::abs(off), std::abs(off) < 0.02 ? "holds" : "degraded");
}

// Front and rear exchanged, and mirrored in yaw of the body: nearly the same equations.
void mirrored(report::Item& item) {
  const CycleCase& c = cycle_case("new-150");
  Eigen::VectorXd y = c.examined.orbit.y;
  for (const int o : {0, 9}) {
    for (const int k : {X_TF, TH_TF, TH_WF}) std::swap(y[o + k], y[o + k + 1]);
    y[o + TH_C] = -y[o + TH_C];
  }
  const Orbit orbit = shoot(c.car, y, c.examined.orbit.period);
  double a = 0;
  for (std::size_t i = 0; orbit.converged && i < wheelsets; ++i)
    a = std::max(a, amplitude(c.car, orbit, c.car.channels[i].row));
  const double off = orbit.converged ? std::abs(a / c.examined.amplitude - 1) : none;
  item.stability("mirror", "new wheel, 150 ft/s, front and rear exchanged",
                 "only the centre plates break the symmetry",
                 orbit.converged
                     ? fmt::format("shooting: A = {:.5f} in, the cycle itself is {:.5f}", a / inch,
                                   c.examined.amplitude / inch)
                     : orbit.reason,
                 off, orbit.converged ? holds(off, 0.1) : "degraded");
}

void leaving(report::Item& item) {
  const Oscillator car =
      car_on_track(assemble({}, Suspension::dampers), wheelrail::new_wheel_table(), 240 * foot);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
  y[X_TF] = y[X_TR] = 0.45 * inch;
  const History exact = integrate(car, y, 20, watching(car));
  HistoryOptions options = watching(car, 1e-9);
  options.integrator = Integrator::dopri5;
  const History explicit_run = integrate(car, y, 20, options);
  const double off = std::abs(exact.t - explicit_run.t);
  item.stability("leaving", "new wheel, 240 ft/s", "a wheelset 0.75 in off: the end of the table",
                 exact.end == History::End::left_table
                     ? fmt::format("stopped at {:.6f} s, wheelset {}", exact.t, exact.channel + 1)
                     : "did not leave",
                 off, exact.end == History::End::left_table ? holds(off, 1e-6) : "fails");
}

void no_cycle(report::Item& item) {
  const Oscillator car =
      car_on_track(assemble({}, Suspension::dampers), wheelrail::new_wheel_table(), 60 * foot);
  Eigen::VectorXcd q = Eigen::VectorXcd::Zero(9);
  q[X_TF] = q[X_TR] = 0.3 * inch;
  const Cycle cycle = balance(car, first_harmonic(car, q, 8, 9));
  item.stability("no-cycle", "new wheel, 60 ft/s", "there is no cycle", "balance: " + cycle.reason,
                 none, cycle.converged ? "fails" : "refused");
}

// A mode's displacements and rates, of length 1; the rates are divided by 10 to be of one size with the rest.
Eigen::Matrix<Complex, 18, 1> state_of_mode(const Motion& mode) {
  Eigen::Matrix<Complex, 18, 1> x;
  x << mode.shape, mode.lambda / 10.0 * mode.shape;
  return x.normalized();
}

// Nearly defective: the two modes with the most parallel shapes, and what their equations leave.
void parallel_modes(report::Item& item) {
  const QuasiLinearCar& car = study("new").car;
  const auto gains = car.small();
  double most = 0, speed = 0, left = 0;
  Complex first, second;
  for (double v = 150 * foot; v < 220 * foot; v += 0.25 * foot) {
    const auto all = modes(car, gains, v);
    const Matrix9 stiffness = car.matrices(gains, v).stiffness;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Motion& m = all[i];
      left = std::max(left, (car.dynamic_stiffness(gains, m.lambda, v) * m.shape).norm() /
                                (stiffness * m.shape).norm());
      for (std::size_t j = 0; j < i; ++j) {
        const double overlap = std::abs(state_of_mode(m).dot(state_of_mode(all[j])));
        if (overlap <= most) continue;
        most = overlap, speed = v, first = m.lambda, second = all[j].lambda;
      }
    }
  }
  item.value("parallel-speed", speed / foot, "ft/s", "{:.0f}");
  item.stability(
      "parallel-modes", fmt::format("new wheel, {:.0f} ft/s", speed / foot),
      fmt::format("two modes' shapes overlap by {:.6f}", most),
      fmt::format("{:.3f} {:+.3f}i and {:.3f} {:+.3f}i 1/s are told apart; error: |Zq|/|Kq|",
                  first.real(), first.imag(), second.real(), second.imag()),
      left, holds(left, 1e-9));
}

// The body's yaw inertia at which both Hopf points of the new wheel fall together, by secants.
void coincident(report::Item& item) {
  const auto car_with = [](double factor) {
    CarParameters data;
    data.body_yaw_inertia *= factor;
    return QuasiLinearCar{assemble(data, Suspension::dampers), wheelrail::new_wheel_table()};
  };
  Motion one = study("new").hopf.at(0).motion, two = study("new").hopf.at(1).motion;
  const auto gap = [&](double factor) {
    const QuasiLinearCar car = car_with(factor);
    one = find_hopf(car, one).point.motion;
    two = find_hopf(car, two).point.motion;
    return two.speed - one.speed;
  };
  double a = 1, b = 1.01, at_a = gap(a), at_b = gap(b);
  for (int k = 0; k < 20 && std::abs(at_b) > 1e-11 && at_a != at_b; ++k) {
    const double next = std::clamp(b - at_b * (b - a) / (at_b - at_a), 0.9 * b, 1.1 * b);
    a = b, at_a = at_b;
    b = next, at_b = gap(b);
  }
  const auto found = hopf_points(car_with(b), 100 * foot, 200 * foot);
  double off = none;
  if (found.size() == 2)
    off = std::max(std::abs(found[0].motion.speed - one.speed),
                   std::abs(found[1].motion.speed - one.speed)) /
          one.speed;
  item.value("coincident-factor", b, "", "{:.4f}");
  item.value("coincident-speed", one.speed / foot, "ft/s", "{:.2f}");
  item.stability("coincident", fmt::format("new wheel, body's yaw inertia times {:.4f}", b),
                 fmt::format("two Hopf points {:.0e} ft/s apart", std::abs(at_b) / foot),
                 fmt::format("{} listed, {:.3f} and {:.3f} rad/s", found.size(), one.lambda.imag(),
                             two.lambda.imag()),
                 off, off <= 1e-9 ? "holds" : "fails");
}

void slow_steps(report::Item& item) {
  item.reconstructed("cases of ours, not in the paper");
  item.columns({"V, ft/s", "fastest decay, 1/s", "steps of the implicit method", "explicit",
                "exact pieces"});
  for (const double v : {0.1, 1.0, 10.0, 50.0, 140.0}) {
    const Oscillator car =
        car_on_track(assemble({}, Suspension::dampers), wheelrail::new_wheel_table(), v * foot);
    std::vector<std::string> row{fmt::format("{:g}", v), fmt::format("{:.4g}", fastest_decay(car))};
    Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
    y[X_TF] = y[X_TR] = 0.2 * inch;
    for (const Integrator i : {Integrator::radau5, Integrator::dopri5, Integrator::pieces}) {
      HistoryOptions options = watching(car, 1e-6);
      options.integrator = i;
      row.push_back(std::to_string(integrate(car, y, 2, options).steps));
    }
    item.add_row(row);
  }
  slow(item);
  refused(item);
  raw_jump(item);
  sticking(item);
  mirrored(item);
  parallel_modes(item);
  coincident(item);
  leaving(item);
  no_cycle(item);
}

}  // namespace

void add_cycle_extremes(report::Chapter& chapter) {
  chapter.table("slow-steps", "Two seconds of a slow car at a tolerance of 1e-6: steps",
                slow_steps);
}

}  // namespace railbook::hunting_chapter
