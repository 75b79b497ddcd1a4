/***
### In time

{{fig-histories}}

At 150 ft/s the new wheel's rest is unstable. A disturbance of 0.02 in grows on the cone, where nothing limits it,
until the flange does, and settles on the cycle. Enlarged, the describing function and 23 harmonics against
the integration: the latter two are not to be told apart; the former is a little small, and, more visibly, a little slow. Since the
frequency is in error, its phase drifts, and in the figure all three are put in phase at the first crossing.

{{cycle-table}}

Every stable cycle found by time integration is the one found by shooting, to all digits shown, whatever the way
there. A program of another author in another language (an ODE solver of variable order on the same tables) agrees within its rounding.
The describing function is worst just where amplitudes are small against the friction's own scale. The
unstable ones are closed by shooting only: started on them, the integration runs off.
*/

#include <fmt/format.h>

#include <cmath>

#include "cycles.hpp"
#include "items.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;
using units::inch;

namespace {

constexpr double length_in_time = 1.5;  // s, of the enlarged stretch

// Displacement of the rear leading wheelset over a stretch that begins at its crossing upwards.
void add_wave(report::Data& data, const std::string& name, const Cycle& cycle,
              const Eigen::VectorXd& row) {
  const auto x = [&](double phase) { return row.dot(state_at(cycle, phase).head(row.size())); };
  double low = 0, high = 0;  // around the crossing
  for (double phase = 0; phase < 2 * units::pi; phase += 0.01)
    if (x(phase) < 0 && x(phase + 0.01) >= 0) low = phase, high = phase + 0.01;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (x(middle) < 0 ? low : high) = middle;
  }
  for (double t = 0; t <= length_in_time; t += 0.005)
    data.add(name, t, x(low + cycle.omega * t) / inch);
  data.gap();
}

void fig_histories(report::Item& item) {
  item.reconstructed("not in the paper");
  const CycleCase& c = cycle_case("new-150");
  const std::size_t wheelset = 2;
  HistoryOptions options = watching(c.car);
  options.integrator = Integrator::dopri5;
  Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
  y[X_TR] = 0.02 * inch;
  const History growth = integrate(c.car, y, 100, options);
  auto& envelope = item.data({"t_s", "peak_in"});
  for (const Turn& turn : growth.turns[wheelset])
    if (turn.x > 0) envelope.add(turn.t, turn.x / inch);
  // One more stretch, from the last crossing on.
  options.sample_step = 0.005;
  const double begin = growth.rises[wheelset].back();
  HistoryOptions bare = watching(c.car);
  const History at_crossing = integrate(c.car, y, begin, bare);
  const History wave = integrate(c.car, at_crossing.y, length_in_time, options);
  auto& waves = item.data("waves", {"method", "t_s", "x_in"});
  for (std::size_t j = 0; j < wave.sample_times.size(); ++j)
    waves.add("time", wave.sample_times[j],
              wave.samples(Eigen::Index(wheelset), Eigen::Index(j)) / inch);
  waves.gap();
  const Eigen::VectorXd row = c.car.channels[wheelset].row;
  add_wave(waves, "balance", c.examined.balance, row);
  const Cycle quasi = first_harmonic(c.car, c.quasi.motion.shape, c.quasi.motion.lambda.imag(), 1);
  add_wave(waves, "describing", quasi, row);
}

// From the describing function's cycle until nothing changes any more: long where a multiplier is near 1.
Swing settled(const CycleCase& c) {
  HistoryOptions options = watching(c.car);
  options.integrator = c.car.channels.back().of_rate ? Integrator::pieces : Integrator::dopri5;
  const double decay = -std::log(c.examined.stability.largest) / c.examined.orbit.period;
  const double duration = std::min(20 + 12 / decay, 400.0);
  return largest_swing(integrate(c.car, state_of(c.quasi.motion), duration, options), 5);
}

// Friction's transients last minutes: all of them at full level only.
bool in_time(const report::Item& item, const CycleCase& c) {
  return c.examined.stability.stable &&
         (item.full() || !c.car.channels.back().of_rate || c.key == "friction-100");
}

std::string both(double a, double omega) {
  return fmt::format("{:.5f}, {:.4f}", a / inch, omega);
}

void cycle_table(report::Item& item) {
  const table::CsvTable program = item.printed("cycles.csv");
  int stable = 0, known = 0;
  for (const CycleCase& c : cycle_cases()) {
    if (in_time(item, c)) ++stable;
    for (const auto& row : program.rows)
      if (row[0] == c.key) ++known;
  }
  item.expect_checks(2 * stable + 2 * known);
  item.reconstructed("not in the paper: cycles of our reconstruction by four methods");
  item.columns({"cycle", "describing function: A in, ω rad/s", "9 harmonics", "23 harmonics",
                "in time", "by shooting"});
  for (const CycleCase& c : cycle_cases()) {
    const Cycle nine = balance(c.car, with_orders(c.examined.balance, 9));
    std::string time = c.examined.stability.stable ? "(full level)" : "unstable";
    if (in_time(item, c)) {
      const Swing s = settled(c);
      time = both(s.amplitude, s.omega);
      item.agree("time-" + c.key, c.name + ", amplitude in time", "in", s.amplitude / inch,
                 c.examined.amplitude / inch, 1e-4, "shooting");
      item.agree("time-omega-" + c.key, c.name + ", frequency in time", "rad/s", s.omega,
                 c.examined.omega, 1e-5, "shooting");
    }
    for (const auto& row : program.rows) {
      const std::string& key = row[0];
      if (key != c.key) continue;
      item.agree("program-" + key, c.name + ", amplitude", "in", c.examined.amplitude / inch,
                 std::stod(program.at(key, "amplitude")), std::stod(program.at(key, "allowed")),
                 "an independent program");
      item.agree("program-omega-" + key, c.name + ", frequency", "rad/s", c.examined.omega,
                 std::stod(program.at(key, "omega")), 2e-4, "an independent program");
    }
    item.add_row({c.name, both(c.quasi.largest, c.quasi.motion.lambda.imag()),
                  nine.converged ? both(largest_amplitude(c.car, nine), nine.omega) : nine.reason,
                  both(largest_amplitude(c.car, c.examined.balance), c.examined.balance.omega),
                  time, both(c.examined.amplitude, c.examined.omega)});
  }
}

}  // namespace

void add_histories(report::Chapter& chapter) {
  chapter.figure("fig-histories",
                 "New wheel, 150 ft/s: onto the limit cycle, and the cycle by three methods",
                 fig_histories);
  chapter.table("cycle-table", "Limit cycles by four methods", cycle_table);
}

}  // namespace railbook::hunting_chapter
