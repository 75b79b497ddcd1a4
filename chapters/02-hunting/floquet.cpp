/***
### Stability of the cycles: Floquet multipliers

The paper calls a cycle stable when a little more amplitude makes its mode decay. That looks at one mode of eighteen. The
monodromy matrix looks at all: a small disturbance of the cycle is multiplied, every period, by the multipliers $\mu$. One of
them is 1, a shift along the cycle. The cycle is stable if all others lie inside the unit circle. It can lose that in
three ways: through $+1$ (a fold, or the loss of left/right symmetry), through $-1$, or by a complex pair, a *torus*: a second
frequency grows on top of the first.

{{fig-multipliers}}

The branch of new wheels, by the paper's rule stable far to the right, is stable from the critical speed to
{{torus-speed}} only, {{torus-above}} above it. There a complex pair leaves the circle (amplitude {{torus-amplitude}}, {{torus-omega}}); it turns by {{torus-angle}} a
period, so what grows should beat with {{torus-beat}}. It is not the car's second critical mode, although that one's Hopf point at {{second-hopf}}
is near: at its frequency the pair would turn by {{second-turn}}. {{fig-beating}} shows it in time.

{{fig-beating}}

At 154 ft/s the beat grows, at first with the rhythm of the multipliers there, and settles on a torus, where it is slower: amplitudes between {{beat-low}} and
{{beat-high}}, one beat in {{beat-period}}. At 160 ft/s front and rear get out of step and the car does not
stay: after {{leave-time}} a wheelset is at the end of the table, beyond the flange's top. The
describing function has cycles up to {{fold-new}}.

{{floquet-table}}

The last column starts 2 % off the cycle and looks after 30 s. The paper's rule is right on the folds, where it must
be, and blind to tori: the new wheel above {{torus-speed}} and CN at 140 ft/s. Hill's exponents of the single harmonic see them, but too soon. Friction cycles are stable, but by a hair:
$|\mu|$ = 0.99 means that a disturbance needs half a minute to die. Their slowest disturbance is a
drift: an offset of the body against dry friction that no spring opposes much. The flange cycles with friction, which the describing
function also finds, are unstable.

As a second witness, Hill's determinant: the same exponents from the harmonics of the balanced cycle, without any integration. It agrees with the multipliers
within {{hill-worst}} of the largest exponent compared.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cycles.hpp"
#include "dynamics/hill.hpp"
#include "items.hpp"

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

// The beat that a pair of the half-period map's multipliers makes, seen once a period.
double beat_of(const Leading& at, double period) {
  return 2 * units::pi * period / std::abs(std::remainder(2 * std::arg(at.pair), 2 * units::pi));
}

// Cycles of the new wheel from neighbour to neighbour in speed.
struct NewBranch {
  Oscillator car = cycle_case("new-150").car;
  Orbit orbit = cycle_case("new-150").examined.orbit;

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
  double car_speed() const { return 1 / car.inverse_speed; }
  double size() const {
    double largest = 0;
    for (std::size_t i = 0; i < wheelsets; ++i)
      largest = std::max(largest, amplitude(car, orbit, car.channels[i].row));
    return largest;
  }
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
  const table::CsvTable program = item.printed("multipliers.csv");
  item.expect_checks(static_cast<int>(program.rows.size()));
  item.reconstructed("not in the paper");
  auto& data = item.data({"V_ft_s", "pair", "real", "A_in"});
  for (const double direction : {-1.0, 1.0}) {
    std::vector<std::array<double, 4>> rows;
    NewBranch branch;
    for (double v = 150; v > 144.8 && v < 165; v += direction * (v > 152 && v < 155 ? 0.25 : 0.5)) {
      if (!branch.move_to(v * foot)) break;
      const Leading l = leading(branch.orbit);
      rows.push_back({v, l.complex, l.real, branch.size() / inch});
    }
    if (direction < 0) std::reverse(rows.begin(), rows.end());
    for (const auto& r : rows) data.add(r[0], r[1], r[2], r[3]);
  }
  const NewBranch torus = torus_point();
  const Leading at = leading(torus.orbit);
  const double speed = torus.car_speed() / foot;
  auto& mark = item.data("torus", {"V_ft_s", "pair"});
  mark.add(speed, at.complex);
  const double turn = 2 * std::arg(at.pair);  // of the pair, over a whole period
  const double folded = std::abs(std::remainder(turn, 2 * units::pi));
  item.value("torus-speed", speed, "ft/s", "{:.3f}");
  item.value("torus-amplitude", torus.size() / inch, "in", "{:.4f}");
  item.value("torus-omega", torus.orbit.omega(), "rad/s", "{:.3f}");
  item.value("torus-angle", folded * 180 / units::pi, "°", "{:.1f}");
  item.value("torus-beat", beat_of(at, torus.orbit.period), "s", "{:.2f}");
  const Study& fresh = study("new");
  const Motion& second = fresh.hopf.at(1).motion;
  item.value("torus-above", 100 * (torus.car_speed() / fresh.hopf.at(0).motion.speed - 1), "%",
             "{:.1f}");
  item.value("second-hopf", second.speed / foot, "ft/s", "{:.1f}");
  item.value("second-turn",
             std::abs(std::remainder(360 * second.lambda.imag() / torus.orbit.omega(), 360)), "°",
             "{:.0f}");
  for (const auto& row : program.rows) {
    if (row[0] == "torus") {
      item.agree("torus", "speed of the torus point", "ft/s", speed, std::stod(row[2]),
                 std::stod(row[3]), "an independent program");
      continue;
    }
    NewBranch branch;
    branch.move_to(152 * foot);
    branch.move_to(std::stod(row[0]) * foot);
    item.agree("mu-" + row[0], "|mu| of the pair at " + row[0] + " ft/s", "",
               leading(branch.orbit).complex, std::stod(row[2]), std::stod(row[3]),
               "an independent program");
  }
}

// Mean time between peaks of the peaks of a wheelset over [from, to] s, and the range of these.
struct Beat {
  double period = 0, low = 1, high = 0;
};
Beat beat(const std::vector<Turn>& turns, double from, double to) {
  std::vector<Turn> peaks;
  for (const Turn& turn : turns)
    if (turn.x > 0 && turn.t > from && turn.t < to) peaks.push_back(turn);
  Beat result;
  double first = 0, last = 0;
  int beats = -1;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    result.low = std::min(result.low, peaks[i].x);
    result.high = std::max(result.high, peaks[i].x);
    if (i == 0 || i + 1 == peaks.size()) continue;
    if (peaks[i].x > peaks[i - 1].x && peaks[i].x >= peaks[i + 1].x) {
      if (++beats == 0) first = peaks[i].t;
      last = peaks[i].t;
    }
  }
  if (beats > 0) result.period = (last - first) / beats;
  return result;
}

void fig_beating(report::Item& item) {
  item.expect_checks(1);
  item.reconstructed("not in the paper");
  auto& data = item.data({"t_s", "peak_in"});
  auto& leaving = item.data("leaving", {"t_s", "front_in", "rear_in"});
  for (const double v : {154.0, 160.0}) {
    NewBranch branch;
    for (const double step : {152.0, 153.0, 154.0}) branch.move_to(step * foot);
    const Oscillator car = at_speed(branch.car, v * foot);
    HistoryOptions options = watching(car);
    options.integrator = Integrator::dopri5;
    if (v > 155) options.sample_step = 0.02;
    const History h = integrate(car, 1.002 * branch.orbit.y, 200, options);
    if (h.end == History::End::left_table) {
      for (std::size_t j = 0; j < h.sample_times.size(); ++j)
        leaving.add(h.sample_times[j], h.samples(0, Eigen::Index(j)) / inch,
                    h.samples(2, Eigen::Index(j)) / inch);
      leaving.add(h.t, options.watch[0].dot(h.y.head(9)) / inch,
                  options.watch[2].dot(h.y.head(9)) / inch);
      item.value("leave-time", h.t, "s", "{:.1f}");
      continue;
    }
    for (const Turn& turn : h.turns[2])
      if (turn.x > 0) data.add(turn.t, turn.x / inch);
    const Beat settled = beat(h.turns[2], 140, 200);
    item.value("beat-low", settled.low / inch, "in", "{:.3f}");
    item.value("beat-high", settled.high / inch, "in", "{:.3f}");
    item.value("beat-period", settled.period, "s", "{:.2f}");
    item.agree("beat-growing", "beat while it is small, 154 ft/s", "s",
               beat(h.turns[2], 2, 10).period, beat_of(leading(branch.orbit), branch.orbit.period),
               0.05, "the angle of the multipliers");
  }
}

// What is left after 30 s of a start 2 % off.
std::string in_time(const CycleCase& c) {
  HistoryOptions options = watching(c.car);
  if (!c.car.channels.back().of_rate) options.integrator = Integrator::dopri5;
  const History h = integrate(c.car, 0.98 * c.examined.orbit.y, 30, options);
  if (h.end == History::End::left_table) return fmt::format("off the table at {:.1f} s", h.t);
  const Swing s = largest_swing(h, 5);
  if (!s.found) return "at rest";
  const double off = s.amplitude / c.examined.amplitude - 1;
  if (s.spread > 0.01 * s.amplitude) return fmt::format("beats, {:+.1f} %", 100 * off);
  return std::abs(off) < 1e-5 ? "on the cycle" : fmt::format("{:+.3f} %", 100 * off);
}

void floquet_table(report::Item& item) {
  item.columns({"cycle", "A, in", "ω, rad/s", "the paper's rule", "Hill, one harmonic",
                "largest |μ|", "Floquet", "|μ − 1| of the trivial one", "2 % off, after 30 s"});
  item.reconstructed("not in the paper: the multipliers of our reconstruction");
  std::vector<std::string> compared{"new-154", "cn-131.5", "cn-upper", "heumann-upper"};
  item.expect_checks(int(compared.size()));
  double worst = 0;
  for (const CycleCase& c : cycle_cases()) {
    const auto& s = c.examined.stability;
    const Complex one_harmonic = leading_exponent(c.study->car, c.quasi.motion);
    item.add_row({c.name, fmt::format("{:.5f}", c.examined.amplitude / inch),
                  fmt::format("{:.4f}", c.examined.omega),
                  c.quasi.neutral  ? "neutral"
                  : c.quasi.stable ? "stable"
                                   : "unstable",
                  one_harmonic.real() < 1e-6 ? "stable" : "unstable",
                  fmt::format("{:.5f}", s.largest),
                  s.stable ? std::string{"stable"} : "unstable (" + s.loss + ")",
                  fmt::format("{:.0e}", s.trivial_error), in_time(c)});
    if (std::find(compared.begin(), compared.end(), c.key) == compared.end()) continue;
    // A witness without integration: 63 harmonics balanced, and Hill's determinant.
    const Cycle cycle = balance(c.car, harmonics(c.car, c.examined.orbit, 63));
    const auto& map = c.examined.orbit.map_multipliers;
    const std::size_t first = std::abs(map[0] - 1.0) < 1e-6 ? 1 : 0;
    const Complex expected = exponent(map[first], c.examined.orbit.period);
    const HillExponent hill = hill_exponent(c.car, cycle, expected * 1.03, 63);
    const double by_hill =
        hill.converged ? std::exp(hill.value.real() * c.examined.orbit.period) : 0.0;
    worst = std::max(worst, std::abs(hill.value - expected) / std::abs(expected));
    item.agree("hill-" + c.key, "largest |mu|, " + c.name, "", by_hill, s.largest, 0.02,
               "shooting");
  }
  item.value("hill-worst", 100 * worst, "%", "{:.1f}");
}

}  // namespace

void add_floquet(report::Chapter& chapter) {
  chapter.figure("fig-multipliers", "New wheel: multipliers of the cycle against speed",
                 fig_multipliers);
  chapter.figure("fig-beating", "New wheel beyond the torus point, in time", fig_beating);
  chapter.table("floquet-table", "Stability of the cycles by three criteria, and in time",
                floquet_table);
}

}  // namespace railbook::hunting_chapter
