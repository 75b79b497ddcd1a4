/***
### Two wheels of a truck

Does it matter that a truck has two wheels? A second wheel on the same rail adds to the rail's
deflection under the first, at rest and in motion. On the beam of (1) with a mass $\rho$ per length
and a bed with the damping $\zeta$, a load at the circular frequency $\omega$ moves the rail at a
distance $b$ by a fraction of what it does at the load. That fraction is the modulus of $a(b)$, with
$\beta$ made of $K-\rho\omega^2+2i\zeta\omega\sqrt{K\rho}$ in place of $K$, which makes $\beta$ a
complex number. This beam
carries loads instead of wheels, and it shows that the coupling of which the paper speaks exists, in
motion more than at rest:

::: {.fold summary="The coupling of two wheels, by distance and frequency"}

{{two-wheels}}

:::

In the lumped model we use the coupling at rest: the force of each wheel acts on its own rail mass,
and the fraction $a(b)$ of it acts on that of the other wheel. In a truck of 70 inches, a common one,
at 60 mph over a dip of 0.5 in, the blow to the leading wheel then moves the rail below the trailing wheel by
up to {{neighbour-rail}}. The trailing wheel hardly acts back: P1 and P2 of the leading wheel,
defined above, change by {{neighbour-p1}} and {{neighbour-p2}}. With {{strong-share}} in place of
$a(b)$, the coupling at 60 Hz and about the largest that the table has at 70 in, they change by
{{strong-p1}} and {{strong-p2}}. So the paper's claim is right for the deflection of the rail, and
for the two peaks of the force one wheel is a fair model.

::: {.fold summary="The equations of motion of two wheels, as code"}

The struct `TwoWheels` has the equations of motion of {{fig-04}}. In the code, `surplus` is the
force of a wheel beyond the static load; it acts on the rail mass below that wheel, and the fraction
`share` of it on the rail mass of the other. The variable `pad` is the force in the upper spring and
damper. The index `piece` says on which of the two rails at the joint a wheel is. With `share` zero
these are the equations of one wheel that {{fig-joint}} solves.

{{code: two_wheels.cpp TwoWheels}}

:::

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/num/dopri5.hpp>
#include <railbook/report/values.hpp>
#include <railbook/track/impact_peaks.hpp>
#include <railbook/track/wheel_on_track.hpp>

#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

// Amplitude of the rail at a distance [m] from an oscillating load over that at the load; damping 2
// zeta sqrt(K rho).
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

// The same on the typical track, by frequency [Hz] and distance [m].
double typical_share(double frequency, double distance) {
  return share_at(typical_beam(), moving_mass(), 0.2, frequency, distance);
}

constexpr double truck = 70 * units::inch;  // wheelbase

// The coupling at the frequency of P2, by what was chosen.
report::Trial neighbours(const report::Item& item) {
  const WinklerBeam beam = typical_beam();
  const double frequency = natural_frequencies(typical_impact())[0];
  report::Trial trial = item.trial(
      "neighbours",
      "deflection by the neighbour's oscillating load over that by its own, at the frequency of P2",
      "{:.2f}", [](double found) { return found > 0.05; });
  trial.vary("wheelbase", [&](const report::Setting& s) {
    return typical_share(frequency, s.number * units::inch);
  });
  trial.vary("foundation modulus K", [&](const report::Setting& s) {
    return share_at({beam.bending_stiffness, s.number * units::psi}, moving_mass(), 0.2, frequency,
                    truck);
  });
  trial.vary("damping of the bed", [&](const report::Setting& s) {
    return share_at(beam, moving_mass(), s.number, frequency, truck);
  });
  trial.vary("mass that moves with the rail", [&](const report::Setting& s) {
    return share_at(beam, s.index == 0 ? typical_rail().mass_per_length : moving_mass(), 0.2,
                    frequency, truck);
  });
  return trial;
}

// Both wheels over a dip of 0.5 in at 60 mph, the fraction `share` of each force on the other's
// rail.
Passage2 over_joint(double share) {
  return run(typical_impact(), 60 * units::mph, truck, share);
}

// The most that the leading wheel moves the rail below the trailing one [m].
double most_apart(const std::vector<double>& with, const std::vector<double>& without) {
  double most = 0;
  for (std::size_t i = 0; i < with.size(); ++i)
    most = std::max(most, std::abs(with[i] - without[i]));
  return most;
}

// P1 [N] of the passage of one wheel.
double single_p1() {
  const RectifiedSine dip = joint_dip(0.5);
  return impact_peaks(simulate(typical_impact(), dip, 60 * units::mph,
                               {.tolerance = 1e-10, .start = default_start(dip)}))
      .first.force;
}

void two_wheels(report::Item& item) {
  item.rebuilt("the paper gives no data: the typical track; damping 0.2 of critical in the bed");
  const ImpactModel model = typical_impact();
  const Eigen::Vector3d modes = natural_frequencies(model);
  item.columns({{"frequency, Hz", "{:.0f}"},
                {"at 66 in", "{:.2f}"},
                {"at 70 in", "{:.2f}"},
                {"at 108 in", "{:.2f}"}});
  const auto share = [&](double frequency, double inches) {
    return typical_share(frequency, inches * units::inch);
  };
  for (const double frequency : {0.0, 10.0, modes[0], 60.0, 100.0, modes[1]})
    item.add_row(frequency, share(frequency, 66), share(frequency, 70), share(frequency, 108));
  item.expect_checks(2);
  // At rest the paper's a(b), from two loads on exact elements.
  const WinklerBeam beam = typical_beam();
  const WheelLoad pair[] = {{0, typical_wheel_load}, {truck, typical_wheel_load}};
  item.agree("at-rest",
             "1 + a(b), the deflection under a wheel of a 70-in truck over that of one alone", "",
             beam.point_stiffness() / stiffness_under_wheel(beam, pair, 0), 1 + share(0, 70), 1e-12,
             "the oscillating load at 0 Hz");
  item.claims({{"neighbours", {share(0, 70), share(modes[0], 70), modes[0]}, neighbours(item)}});

  constexpr double kN = units::kilonewton;
  const Passage2 coupled = over_joint(share(0, 70)), alone = over_joint(0);
  const LeadingPeaks with = peaks(coupled, model), without = peaks(alone, model),
                     strong = peaks(over_joint(share(60, 70)), model);
  item.agree("uncoupled", "P1 of the leading wheel, without coupling", "kN", without.first / kN,
             single_p1() / kN, 5e-5, "the passage of one wheel");
  item.value("neighbour-rail", 1e3 * most_apart(coupled.rail, alone.rail), "mm", "{:.1f}");
  item.value("strong-share", share(60, 70), "", "{:.2f}");
  report::values(item, "kN", "{:.1f}", "strong-p1", std::abs(strong.first - without.first) / kN,
                 "strong-p2", std::abs(strong.mean - without.mean) / kN, "neighbour-p1",
                 std::abs(with.first - without.first) / kN, "neighbour-p2",
                 std::abs(with.mean - without.mean) / kN);
}

}  // namespace

LeadingPeaks leading_peaks(bool coupled) {
  return peaks(over_joint(coupled ? typical_share(0, truck) : 0), typical_impact());
}

const report::Section two_wheels_section{report::table("two-wheels", two_wheels)};

}  // namespace railbook::track_chapter
