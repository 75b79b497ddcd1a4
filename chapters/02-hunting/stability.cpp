/***
## Are the cycles stable? The full equations

The paper asks for "validation of the quasi-linear results by comparison with numerical integration". Each cycle is refined by harmonic balance with 23
harmonics, closed by shooting, and the flow's derivative over a period (the monodromy matrix) multiplies a small disturbance by its eigenvalues, the Floquet multipliers $\mu$.
One of them is 1, a shift along the cycle. The cycle is stable if all others lie inside the unit circle.

{{code: dynamics/examine.cpp examine}}

{{fig-multipliers}}

The branch of new wheels, by the paper's rule stable far to the right, is stable from the critical speed to
{{torus-speed}} only, {{torus-above}} above it. There a complex pair leaves the circle (amplitude {{torus-amplitude}}, {{torus-omega}}): a *torus* bifurcation, a second frequency grows on the
cycle. The pair turns by {{torus-angle}} a period, so what grows should beat with {{torus-beat}}. {{fig-beating}} shows it in time.

{{fig-beating}}

At 154 ft/s the beat grows with the rhythm of the multipliers and settles on a torus. At 160 ft/s front and rear get out of step, and after {{leave-time}} a wheelset is
at the end of the table, beyond the flange's top. With linear creep nothing but the
flange limits the motion; a creep force that saturates, which the paper calls for as future work, may well do so.

{{time-claims}}

The describing function has the amplitude right within {{df-error-new}} for the new wheel at 150 ft/s, {{df-error-cn}} for CN at 131.5 and
{{df-error-friction}} with friction at 100 ft/s.
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sections.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;
using units::foot;
using units::inch;

namespace {

// The leading multiplier of each kind but the trivial one.
struct Leading {
  double complex = 0, real = 0;
  Complex pair;  // of the half-period map
};
Leading leading(const Orbit& orbit) {
  Leading result;
  std::size_t trivial = 0;
  const auto& m = orbit.map_multipliers;
  for (std::size_t i = 1; i < m.size(); ++i)
    if (std::abs(m[i] - 1.0) < std::abs(m[trivial] - 1.0)) trivial = i;
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (i == trivial) continue;
    const double size = std::norm(m[i]);
    if (std::abs(m[i].imag()) < 1e-9 * std::abs(m[i])) {
      result.real = std::max(result.real, size);
    } else if (size > result.complex) {
      result.complex = size;
      result.pair = {m[i].real(), std::abs(m[i].imag())};
    }
  }
  return result;
}

// How far a pair of the half-period map's multipliers turns in a period [rad].
double turn_of(const Leading& at) {
  return std::abs(std::remainder(2 * std::arg(at.pair), 2 * units::pi));
}

// Cycles of the new wheel from neighbour to neighbour in speed.
struct NewBranch {
  Oscillator car = example_cycle().car;
  Orbit orbit = example_cycle().examined.orbit;

  // In halves of the way where one leap is too long.
  bool move_to(double speed, int halvings = 5) {
    const double from = 1 / car.inverse_speed;
    if (leap_to(speed)) return true;
    return halvings > 0 && move_to(0.5 * (from + speed), halvings - 1) &&
           move_to(speed, halvings - 1);
  }
  bool leap_to(double speed) {
    const Oscillator there = at_speed(car, speed);
    const Orbit next = shoot(there, orbit.y, orbit.period);
    if (!next.converged) return false;
    car = there;
    orbit = next;
    return true;
  }
  double speed() const { return 1 / car.inverse_speed; }
};

// The speed at which the pair's modulus is 1, by the secant rule on its logarithm.
NewBranch torus_point() {
  NewBranch branch;
  branch.move_to(152 * foot);
  double a = 153 * foot, b = 153.4 * foot;
  branch.move_to(a);
  double fa = std::log(leading(branch.orbit).complex);
  for (int i = 0; i < 20; ++i) {
    if (!branch.move_to(b)) break;
    const double fb = std::log(leading(branch.orbit).complex);
    if (std::abs(fb) < 1e-10) break;
    const double next = b - fb * (b - a) / (fb - fa);
    a = b;
    fa = fb;
    b = next;
  }
  return branch;
}

void fig_multipliers(report::Item& item) {
  item.added("the paper has no such figure; it asks for the comparison");
  item.expect_checks(1);
  auto& data = item.data({"V_ft_s", "pair", "real", "A_in"});
  for (const double direction : {-1.0, 1.0}) {
    std::vector<std::array<double, 4>> rows;
    NewBranch branch;
    for (double v = 150; v > 144.8 && v < 165; v += direction * (v > 152 && v < 155 ? 0.25 : 0.5)) {
      if (!branch.move_to(v * foot)) break;
      const Leading l = leading(branch.orbit);
      rows.push_back({v, l.complex, l.real, largest_amplitude(branch.car, branch.orbit) / inch});
    }
    if (direction < 0) std::reverse(rows.begin(), rows.end());
    for (const auto& r : rows) data.add(r[0], r[1], r[2], r[3]);
  }
  const NewBranch torus = torus_point();
  const Leading at = leading(torus.orbit);
  auto& mark = item.data("torus", {"V_ft_s", "pair"});
  mark.add(torus.speed() / foot, at.complex);
  const double first = vehicle("new").hopf.at(0).motion.speed;
  item.refute("stable-to-high-speed",
              "new wheels: the stable limit cycle on the flange extends to a high velocity",
              std::abs(at.complex - 1) < 1e-6 && torus.speed() < words::much * first,
              fmt::format("a pair of multipliers leaves the unit circle at {:.1f} ft/s",
                          torus.speed() / foot));
  item.value("torus-speed", torus.speed() / foot, "ft/s", "{:.1f}");
  item.value("torus-above", 100 * (torus.speed() / first - 1), "%", "{:.1f}");
  item.value("torus-amplitude", largest_amplitude(torus.car, torus.orbit) / inch, "in", "{:.3f}");
  item.value("torus-omega", torus.orbit.omega(), "rad/s", "{:.2f}");
  item.value("torus-angle", turn_of(at) * 180 / units::pi, "°", "{:.0f}");
  item.value("torus-beat", 2 * units::pi * torus.orbit.period / turn_of(at), "s", "{:.1f}");
}

// Mean time between peaks of the peaks of a wheelset over [from, to] s.
double beat(const std::vector<Turn>& turns, double from, double to) {
  std::vector<Turn> peaks;
  for (const Turn& turn : turns)
    if (turn.x > 0 && turn.t > from && turn.t < to) peaks.push_back(turn);
  double first = 0, last = 0;
  int beats = -1;
  for (std::size_t i = 1; i + 1 < peaks.size(); ++i)
    if (peaks[i].x > peaks[i - 1].x && peaks[i].x >= peaks[i + 1].x) {
      if (++beats == 0) first = peaks[i].t;
      last = peaks[i].t;
    }
  return beats > 0 ? (last - first) / beats : units::nan;
}

// From 0.2 % off the cycle of 154 ft/s, at another speed.
History beyond(double v, const NewBranch& branch, double duration) {
  const Oscillator car = at_speed(branch.car, v * foot);
  HistoryOptions options = watching(car);
  options.integrator = Integrator::dopri5;
  return integrate(car, 1.002 * branch.orbit.y, duration, options);
}

void fig_beating(report::Item& item) {
  item.added("the paper has no such figure; it asks for the comparison");
  item.expect_checks(2);
  NewBranch branch;
  for (const double step : {152.0, 153.0, 154.0}) branch.move_to(step * foot);
  const History settling = beyond(154, branch, 24);
  auto& data = item.data({"t_s", "peak_in"});
  data.holds_to("*", 1e-3, 1e-4, "a motion whose disturbance grows from 0.2 %");
  for (const Turn& turn : settling.turns[2])
    if (turn.x > 0) data.add(turn.t, turn.x / inch);
  const History away = beyond(160, branch, 200);
  for (const auto& [name, wheelset] : {std::pair{"front", 0U}, std::pair{"rear", 2U}}) {
    auto& leaving = item.data(name, {"t_s", "peak_in"});
    leaving.holds_to("*", 1e-3, 1e-4, "a motion whose disturbance grows from 0.2 %");
    for (const Turn& turn : away.turns[wheelset])
      if (turn.x > 0) leaving.add(turn.t, turn.x / inch);
  }
  const Leading at = leading(branch.orbit);
  item.agree("beat-growing", "beat while it is small, 154 ft/s", "s",
             1e-3 * std::round(1e3 * beat(settling.turns[2], 2, 10)),
             2 * units::pi * branch.orbit.period / turn_of(at), 0.05,
             "the angle of the multipliers");
  item.value("leave-time", away.t, "s", "{:.0f}");
  item.claim("unbounded", "motions beyond the unstable cycles may become unbounded",
             away.end == History::End::left_table, "at 160 ft/s a wheelset leaves its table");
}

// What the harmonics beyond the first have of a wheelset's motion, relative to the first; the largest of the four.
double distortion(const CycleCase& c) {
  const Eigen::MatrixXcd motion = harmonics(c.car, c.examined.orbit, 23).motion;
  double worst = 0;
  for (std::size_t i = 0; i < wheelsets; ++i) {
    const Eigen::RowVectorXcd s = c.car.channels[i].row.transpose() * motion;
    worst = std::max(worst, s.tail(s.size() - 1).norm() / std::abs(s[0]));
  }
  return worst;
}

double df_error(const CycleCase& c) {
  return 100 * std::abs(c.quasi.largest / c.examined.amplitude - 1);
}

// Amplitude of the largest wheelset some time after a start with both trucks aside.
double after(const char* key, double feet_a_second, double aside, double duration) {
  const Vehicle& v = vehicle(key);
  const Oscillator car = car_on_track(v.car.car(), *v.table, feet_a_second * foot);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
  y[X_TF] = y[X_TR] = aside * inch;
  HistoryOptions options = watching(car);
  options.integrator = Integrator::dopri5;
  return largest_swing(integrate(car, y, duration, options), 3).amplitude / inch;
}

void time_claims(report::Item& item) {
  item.added("integration in time, which the paper asks for");
  item.expect_checks(7);
  item.columns({"cycle",
                {"A by describing functions, in", "{:.5f}"},
                {"true A, in", "{:.5f}"},
                {"ω, rad/s", "{:.4f}"},
                {"true ω", "{:.4f}"},
                {"beyond the first harmonic, %", "{:.1f}"},
                "the paper's rule",
                "Floquet"});
  double worst = 0;
  const auto add = [&](const CycleCase& c) {
    item.add_row(c.name, c.quasi.largest / inch, c.examined.amplitude / inch,
                 c.quasi.motion.lambda.imag(), c.examined.omega, 100 * distortion(c),
                 c.quasi.stable ? "stable" : "unstable",
                 c.examined.stability.stable ? "stable" : "unstable, " + c.examined.stability.loss);
    worst = std::max(worst, distortion(c));
  };
  const CycleCase& fresh = example_cycle();
  const CycleCase cn = cycle_case(vehicle("cn"), 131.5 * foot),
                  upper = cycle_case(vehicle("cn"), 131.5 * foot, 1),
                  torus = cycle_case(vehicle("new"), 154 * foot),
                  heumann = cycle_case(vehicle("heumann"), 87.4 * foot),
                  friction = cycle_case(vehicle("friction"), 100 * foot);
  for (const CycleCase* c : {&fresh, &torus, &cn, &upper, &heumann, &friction}) add(*c);
  item.claim(
      "sinusoidal", "limit cycles are approximately sinusoidal", worst < words::nearly,
      fmt::format("up to {:.1f} % of a wheelset's motion is beyond the first harmonic in the "
                  "cycles of the table",
                  100 * worst));
  const double grown = after("new", 150, 0.02, 100), decayed = after("new", 140, 0.3, 60);
  item.claim("growth",
             "above the critical speed small amplitudes grow until flange contact limits them",
             std::abs(grown * inch / fresh.examined.amplitude - 1) < words::drawn,
             fmt::format("150 ft/s: from 0.02 in to {:.4f} in, the cycle's {:.4f}", grown,
                         fresh.examined.amplitude / inch));
  item.claim("decay", "left of each curve motions of any amplitude decrease", decayed < 0.3,
             fmt::format("140 ft/s: from 0.3 in to {:.3f} in after a minute", decayed));
  item.claim("stable-on-flange", "the first occurrence of flange contact is a stable limit cycle",
             fresh.examined.stability.stable && cn.examined.stability.stable,
             "by multipliers, new wheel at 150, CN A at 131.5 ft/s");
  item.claim("heumann-stable", "Heumann: the cycles of low amplitude are stable",
             heumann.examined.stability.stable, "by multipliers, at 87.4 ft/s");
  item.refute(
      "cn-upper-stable", "CN A: the cycles of the higher region are stable",
      upper.examined.converged && !upper.examined.stability.stable,
      fmt::format("largest multiplier {:.2f} at 131.5 ft/s", upper.examined.stability.largest));
  double off = 0;
  for (const char* key : {"new", "cn", "heumann"}) {
    const Vehicle& v = vehicle(key);
    const auto p = cycles_at_amplitude(v.car, v.main_branch(), v.flange).at(0);
    off = std::max(off, std::abs(p.motion.speed / v.hopf[0].motion.speed - 1));
  }
  item.claim("linear-good", "linear theory is good until flange contact: for the critical speed",
             off < words::nearly, fmt::format("within {:.1f} %", 100 * off));
  item.value("df-error-new", df_error(fresh), "%", "{:.2f}");
  item.value("df-error-cn", df_error(cn), "%", "{:.2f}");
  item.value("df-error-friction", df_error(friction), "%", "{:.1f}");
}

}  // namespace

const report::Section stability{
    report::figure("fig-multipliers", "New wheel: multipliers of the cycle against speed",
                   fig_multipliers),
    report::figure("fig-beating", "New wheel beyond the torus point, in time", fig_beating),
    report::table("time-claims", "Cycles of the full equations, and what the text says of them",
                  time_claims)};

}  // namespace railbook::hunting_chapter
