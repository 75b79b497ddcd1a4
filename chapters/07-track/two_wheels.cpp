/***
### Two wheels of a truck

Does it matter that a truck has two wheels? A second wheel on the same rail adds to the rail's
deflection under the first, at rest and in motion. On the beam of (1) with a mass $\rho$ per length
and a bed with the damping $\zeta$, a load at the circular frequency $\omega$ moves the rail at a
distance $b$ by a fraction of what it does at the load. That fraction is the modulus of $a(b)$, with
$\beta$ made of $K-\rho\omega^2+2i\zeta\omega\sqrt{K\rho}$ in place of $K$ (`share_at`). This beam
carries loads instead of wheels, and it shows that the coupling of which the paper speaks exists, in
motion more than at rest:

::: {.fold summary="The coupling of two wheels, by distance and frequency"}

{{two-wheels}}

:::

In the lumped model we use the coupling at rest: the force of each wheel acts on its own rail mass,
and the fraction $a(b)$ of it acts on that of the other wheel. In a truck of 70 inches at 60 mph
over a dip of 0.5 in, the blow to the leading wheel then moves the rail below the trailing wheel by
up to {{neighbour-rail}}. The trailing wheel hardly acts back: P1 and P2 of the leading wheel,
defined above, change by {{neighbour-p1}} and {{neighbour-p2}}. For these two peaks one wheel is
enough.

The struct `TwoWheels` has the equations of motion of {{fig-04}}. The excess of each force over the
static load acts on the rail mass below that wheel, and `share` of it on that of the other; `pad` is
the force in the upper spring and damper, and the bed carries the rest. With `share` zero these are
the equations of one wheel that {{fig-joint}} solves.

{{code: two_wheels.cpp TwoWheels}}

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/num/dopri5.hpp>
#include <railbook/track/impact_peaks.hpp>
#include <railbook/track/wheel_on_track.hpp>

#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

// Amplitude of the rail at a distance [m] from an oscillating load over that at the load; damping 2 zeta sqrt(K rho).
double share_at(const WinklerBeam& beam, double rho, double zeta, double frequency,
                double distance) {
  const double q = 2 * units::pi * frequency / std::sqrt(beam.foundation_modulus / rho);
  const std::complex<double> at =
      beam.beta() * distance * std::pow(std::complex<double>{1 - q * q, 2 * zeta * q}, 0.25);
  return std::abs(std::exp(-at) * (std::cos(at) + std::sin(at)));
}

double moving_mass() {
  const TieSupport support = typical_support();
  return typical_rail().mass_per_length + typical_tie_mass / (2 * support.tie_spacing) +
         ballast_mass_per_length(typical_ballast, support);
}

// The state is y_w, y_w', y_r, y_r', y_t, y_t' of the leading wheel, then of the trailing one.
struct TwoWheels {
  using State = Eigen::Matrix<double, 12, 1>;
  const ImpactModel& model;
  const RectifiedSine& rail;
  double speed, base, share;
  std::array<long, 2> piece{};  // of the surface, below each wheel

  double force(int wheel, double t, const State& y) const {
    const double s = speed * t - wheel * base;
    const double x = static_approach(model) + y[6 * wheel] - y[6 * wheel + 2] -
                     rail.at(s, piece[std::size_t(wheel)]).z;
    return x > 0 ? model.hertz_constant * x * std::sqrt(x) : 0;
  }
  void operator()(double t, const State& y, State& dy) const {
    const RailOnBed& k = model.track;
    const std::array<double, 2> surplus{force(0, t, y) - model.static_load,
                                        force(1, t, y) - model.static_load};
    for (const int wheel : {0, 1}) {
      const auto own = y.segment<6>(6 * wheel);
      auto rate = dy.segment<6>(6 * wheel);
      const double on_rail = surplus[std::size_t(wheel)] + share * surplus[std::size_t(1 - wheel)];
      const double pad = k.rail_stiffness * (own[2] - own[4]) + k.rail_damping * (own[3] - own[5]);
      rate << own[1], -surplus[std::size_t(wheel)] / model.wheel_mass, own[3],
          (on_rail - pad) / k.rail_mass, own[5],
          (pad - k.bed_stiffness * own[4] - k.bed_damping * own[5]) / k.bed_mass;
    }
  }
};

struct Passage2 {
  std::vector<double> time, lead;      // [s], force on the leading wheel [N]
  std::vector<double> velocity, rail;  // of the leading wheel [m/s]; below the trailing one [m]
};

// From a quarter rail before the joint until the trailing wheel comes to it, every 5 us.
Passage2 run(const ImpactModel& model, double speed, double base, double share) {
  const RectifiedSine rail = joint_dip(0.5);
  TwoWheels system{model, rail, speed, base, share};
  TwoWheels::State y = TwoWheels::State::Zero(), tolerance;
  const double rest = static_approach(model), omega = 2 * units::pi * natural_frequencies(model)[2];
  for (int i = 0; i < 12; ++i) tolerance[i] = 1e-8 * rest * (i % 2 ? omega : 1);
  const double start = -0.25 * rail.length / speed, last = base / speed;
  Passage2 result;
  num::Dopri5<12> solver{tolerance, 0.05 / omega};
  for (const auto& [from, to] : {std::pair{start, 0.0}, {0.0, last}}) {
    const double middle = 0.5 * speed * (from + to);
    system.piece = {rail.piece(middle), rail.piece(middle - base)};
    if (from == start)
      for (const int wheel : {0, 1}) {
        const auto at = rail.at(speed * start - wheel * base, system.piece[std::size_t(wheel)]);
        y[6 * wheel] = at.z, y[6 * wheel + 1] = speed * at.slope;
      }
    solver.restart(system, from, y);
    const long count = from < 0 ? 1 : std::lround((to - from) / 5e-6);
    for (long i = 1; i <= count; ++i) {
      const double stop = std::min(to, from + (to - from) * double(i) / double(count));
      while (solver.t() < stop)
        if (!solver.step(system, to)) return {};
      if (from < 0) continue;
      const TwoWheels::State now = stop < to ? solver.dense().at(stop) : solver.y();
      result.time.push_back(stop);
      result.lead.push_back(system.force(0, stop, now));
      result.rail.push_back(now[8]);
      result.velocity.push_back(now[1]);
    }
    y = solver.y();
  }
  return result;
}

LeadingPeaks peaks(const Passage2& p, const ImpactModel& model) {
  LeadingPeaks found;
  std::size_t i = 1;
  while (i + 1 < p.lead.size() && !(p.lead[i] > p.lead[i - 1] && p.lead[i] >= p.lead[i + 1])) ++i;
  found.first = p.lead.at(i);
  const double window = 1 / natural_frequencies(model)[1];
  const auto wide = std::size_t(std::lround(window / (p.time[1] - p.time[0])));
  for (std::size_t k = 0; k + wide < p.time.size(); ++k) {
    const double change = p.velocity[k + wide] - p.velocity[k];
    found.mean = std::max(
        found.mean, model.static_load - model.wheel_mass * change / (p.time[k + wide] - p.time[k]));
  }
  return found;
}

void two_wheels(report::Item& item) {
  item.rebuilt("the paper gives no data: the typical track; damping 0.2 of critical in the bed");
  const WinklerBeam beam = typical_beam();
  const ImpactModel model = typical_impact();
  const Eigen::Vector3d modes = natural_frequencies(model);
  item.columns({{"frequency, Hz", "{:.0f}"},
                {"at 66 in", "{:.2f}"},
                {"at 70 in", "{:.2f}"},
                {"at 108 in", "{:.2f}"}});
  const auto share = [&](double frequency, double inches) {
    return share_at(beam, moving_mass(), 0.2, frequency, inches * units::inch);
  };
  for (const double frequency : {0.0, 10.0, modes[0], 60.0, 100.0, modes[1]})
    item.add_row(frequency, share(frequency, 66), share(frequency, 70), share(frequency, 108));
  item.expect_checks(2);
  // At rest the paper's a(b), from two loads on exact elements.
  const double base = 70 * units::inch;
  const WheelLoad pair[] = {{0, typical_wheel_load}, {base, typical_wheel_load}};
  item.agree("at-rest",
             "1 + a(b), the deflection under a wheel of a 70-in truck over that of one alone", "",
             beam.point_stiffness() / stiffness_under_wheel(beam, pair, 0), 1 + share(0, 70), 1e-12,
             "the oscillating load at 0 Hz");
  report::Trial trial = item.trial(
      "neighbours",
      "deflection by the neighbour's oscillating load over that by its own, at the frequency of P2",
      "{:.2f}", [](double found) { return found > 0.05; });
  trial.vary("wheelbase", [&](const report::Setting& s) { return share(modes[0], s.number); });
  trial.vary("foundation modulus K", [&](const report::Setting& s) {
    return share_at({beam.bending_stiffness, s.number * units::psi}, moving_mass(), 0.2, modes[0],
                    base);
  });
  trial.vary("damping of the bed", [&](const report::Setting& s) {
    return share_at(beam, moving_mass(), s.number, modes[0], base);
  });
  trial.vary("mass that moves with the rail", [&](const report::Setting& s) {
    return share_at(beam, s.index == 0 ? typical_rail().mass_per_length : moving_mass(), 0.2,
                    modes[0], base);
  });
  item.claims({{"neighbours", {share(0, 70), share(modes[0], 70), modes[0]}, trial}});

  const double speed = 60 * units::mph;
  const Passage2 coupled = run(model, speed, base, share(0, 70)),
                 alone = run(model, speed, base, 0);
  double rail = 0;
  for (std::size_t i = 0; i < coupled.rail.size(); ++i)
    rail = std::max(rail, std::abs(coupled.rail[i] - alone.rail[i]));
  const LeadingPeaks with = peaks(coupled, model), without = peaks(alone, model);
  const RectifiedSine dip = joint_dip(0.5);
  const ImpactPeaks single =
      impact_peaks(simulate(model, dip, speed, {.tolerance = 1e-10, .start = default_start(dip)}));
  item.agree("uncoupled", "P1 of the leading wheel, without coupling", "kN",
             without.first / units::kilonewton, single.first.force / units::kilonewton, 5e-5,
             "the passage of one wheel");
  constexpr double kN = units::kilonewton;
  item.value("neighbour-rail", 1e3 * rail, "mm", "{:.1f}");
  item.value("neighbour-p1", std::abs(with.first - without.first) / kN, "kN", "{:.1f}");
  item.value("neighbour-p2", std::abs(with.mean - without.mean) / kN, "kN", "{:.1f}");
}

}  // namespace

LeadingPeaks leading_peaks(bool coupled) {
  const ImpactModel model = typical_impact();
  const double base = 70 * units::inch;
  const double share = coupled ? share_at(typical_beam(), moving_mass(), 0.2, 0, base) : 0;
  return peaks(run(model, 60 * units::mph, base, share), model);
}

const report::Section two_wheels_section{report::table(
    "two-wheels",
    "A neighbour is felt more in motion than at rest. Amplitude of the rail under a wheel from an "
    "oscillating load under the other wheel of a truck, over that under the load.",
    two_wheels)};

}  // namespace railbook::track_chapter
