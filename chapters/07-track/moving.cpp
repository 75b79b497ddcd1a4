/***
## A load that runs along the rail

The beam on its bed also carries waves, and a load that runs as fast as the slowest of them would
outrun its own deflection. That speed is

$$V_c=\left(\frac{4EIK}{\rho^2}\right)^{1/4}, \tag{9}$$

where $\rho$ is the mass that moves per length of rail. $V_c$ is the smallest phase speed
$\omega/\nu$ of free waves of the circular frequency $\omega$ and the wavenumber $\nu$, for which
$EI\nu^4+K=\rho\omega^2$. The paper puts it at about 1100 mph "using parameters for the
rail-tie-ballast type structure". It concludes that the error of ignoring the waves is less than 3
percent at 250 mph, and that at 150 mph or less a *lumped* track (a few masses, springs and dampers)
may travel below each wheel. It gives neither $K$ nor $\rho$, and the answer depends on how much of
tie and ballast moves with the rail:

{{critical-speed}}

With the rail's mass alone the typical track has {{v-rail}}, near the printed figure. But the paper
calls $\rho$ the "track mass per unit length" and, below (15), the mass "of tie, ballast and rail".
With half a tie the speed is {{v-tie}}; with the ballast as well, whose mass is (18) below,
{{v-ballast}}. That number rests on the modulus, the rail, the tie, the reading of (18) and the rule
for the ballast, all of which we chose; as they are varied, the speed is {{v-range}}, and the error
at 250 mph {{error-range}} of the deflection. The upper end of the speed needs everything at its
most favourable at once: a heavy rail, light ties, the second rule for the ballast below (18), fast
shear waves and a bed of $K$ = {{k-best}}. A critical speed of 1100 mph needs $K$ = {{k-for-1100}}
with the rail alone, {{k-for-1100-tie}} with half a tie and {{k-for-1100-ballast}} with the ballast
as well; maintained main lines have 1500 to 3000 psi. Since the paper prints neither $K$ nor $\rho$,
its number and the 3 percent cannot be tested.

At 150 mph the error is {{error-at-150-ballast}} of the deflection on the typical track
({{error-150-range}} as the same data are varied). The paper does not say how much it would accept,
but errors of this size are smaller than the uncertainty of the data of any track, and its
conclusion stands without its number.

### The shape under the load

What does the dent look like when the load runs at the speed $V$? Seen from the load, in
$\eta=\beta(X-Vt)$ with the time $t$, and in units of $P\beta/2K$, the rail's shape $\bar y$ satisfies

$$\bar y''''+4\theta^2\bar y''-8\zeta\theta\bar y'+4\bar y=8\,\hat\delta(\eta),\qquad \theta=V/V_c,$$

where $\hat\delta$ is a unit load at $\eta=0$ and $2\zeta\sqrt{K\rho}$ is the damping of the bed per
length, with the damping ratio $\zeta$ (critical damping is $\zeta=1$). Without damping the
deflection under the load is $1/\sqrt{1-\theta^2}$. With damping, textbooks take the four roots of
$p^4+4\theta^2p^2-8\zeta\theta p+4=0$ and solve for four amplitudes. Both steps lose accuracy where
two roots nearly coincide, as they do at $V_c$ when damping is small. The roots are not needed: the
quartic splits into two real quadratics, $(p^2+qp+r_1)(p^2-qp+r_2)$, one ahead of the load and one
behind, and $u=q^2$ is the one positive root of a convex cubic,

$$u^3+8\theta^2u^2+16(\theta^4-1)u-64\zeta^2\theta^2=0.$$

Newton's method finds it, with no choice between roots to make. The function `moving_load` computes
the factors ($q$, $r_1$ and $r_2$ are the variables `a`, `b` and `c` in the code). It joins the two
sides at the load, where deflection, slope and curvature are equal and the shear jumps by the load.

{{code: track/moving_load.cpp moving_load}}

{{fig-moving}}

Below $V_c$ the dent is symmetric without damping; with damping its deepest point lags behind the
load. Above $V_c$ the whole dent falls behind. Short waves run ahead of the load and long ones
behind it. The points are a check, a finite-element solution of the same differential equation.

{{fig-amplification}}

At a quarter of $V_c$ the rail sinks {{quarter}} deeper than under a standing load
({{fig-amplification}}). With 15 to 25 percent of critical damping, the paper's range for the
material, the largest deflection at any speed is {{most-015}} to {{most-025}} times the static one;
with 40 percent, the lower end of its range for waves radiated into the ground, {{most-040}} times;
with 100 percent no speed gives more than the static deflection.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <railbook/track/fe_moving_load.hpp>
#include <railbook/track/moving_load.hpp>

#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

// A track, and its mass per length: rail alone, with half of each tie, and with the ballast of (18) as well.
struct MovingTrack {
  RailSection rail = typical_rail();
  TieSupport support = typical_support();
  double tie = typical_tie_mass;
  BallastMass ballast = typical_ballast;
  double wave_speed = 0;  // of shear in the ballast, for the second rule (18); 0: the first

  double modulus() const { return stiffness_chain(support).foundation_modulus; }
  double with_tie() const { return rail.mass_per_length + 0.5 * tie / support.tie_spacing; }
  double with_ballast() const {
    if (wave_speed > 0)
      return with_tie() + seismic_mass_per_length(stiffness_chain(support).bed / 2,
                                                  ballast.tamped_area, support.tie_spacing,
                                                  wave_speed);
    return with_tie() + ballast_mass_per_length(ballast, support);
  }
  double critical() const {
    return critical_speed(rail.bending_stiffness(), modulus(), with_ballast());
  }
};

// The track with the highest critical speed that rule (18) for shear waves gives on a soil.
MovingTrack most_favourable(double soil_modulus) {
  MovingTrack track;
  track.rail = rail_section("136RE");
  track.tie = 150 * units::pound;
  track.wave_speed = 1200 * units::foot;
  track.support.soil_modulus = soil_modulus;
  return track;
}

// Varies all that the critical speed [m/s] with rail, tie and ballast rests on; `result` is made of it.
void vary_track(report::Trial& trial, const std::function<double(double)>& result) {
  using report::Setting;
  const auto vary = [&](const char* choice, const auto& change) {
    trial.vary(choice, [&](const Setting& setting) {
      MovingTrack track;
      change(track, setting);
      return result(track.critical());
    });
  };
  constexpr double soil_unit = units::psi / units::inch;
  trial.vary("foundation modulus K", [&](const Setting& k) {
    const MovingTrack track;
    return result(critical_speed(track.rail.bending_stiffness(), k.number * units::psi,
                                 track.with_ballast()));
  });
  vary("rail pad, 1e12 as none", [](MovingTrack& track, const Setting& pad) {
    track.support.pad_stiffness = pad.number * lb_per_in;
  });
  vary("rail",
       [](MovingTrack& track, const Setting& rail) { track.rail = rail_section(rail.text); });
  vary("mass of a tie",
       [](MovingTrack& track, const Setting& tie) { track.tie = tie.number * units::pound; });
  vary("unreadable integer N of (18)",
       [](MovingTrack& track, const Setting& divisor) { track.ballast.divisor = divisor.number; });
  vary("coefficient C_m of (18)", [](MovingTrack& track, const Setting& cohesion) {
    track.ballast.cohesion = cohesion.number;
  });
  vary("the other rule (18), speed of shear waves", [](MovingTrack& track, const Setting& speed) {
    track.wave_speed = speed.number * units::foot;
  });
  vary("the other rule (18) at 1000 ft/s, soil modulus",
       [](MovingTrack& track, const Setting& soil) {
         track.wave_speed = 1000 * units::foot;
         track.support.soil_modulus = soil.number * soil_unit;
       });
  trial.vary("all at once (136RE, ties of 150 lb, 1200 ft/s), soil modulus",
             [&](const Setting& soil) {
               return result(most_favourable(soil.number * soil_unit).critical());
             });
}

// The slowest free wave, by scanning the dispersion relation EI k^4 + K = rho omega^2.
double slowest_wave(double bending_stiffness, double modulus, double rho) {
  double least = 1e9;
  for (double k = 0.5; k < 4; k *= 1.0001)
    least = std::min(least, std::sqrt((bending_stiffness * k * k + modulus / (k * k)) / rho));
  return least;
}

// What is lost at `speed` when the motion of the load is ignored, in percent.
double ignored(double speed, double critical) {
  return 100 * (undamped_amplification(speed / critical) - 1);
}

void critical_speeds(report::Item& item) {
  item.rebuilt("K and rho of the paper's 1100 mph are not given: the typical track");
  item.columns({{"K, psi", "{:.0f}"},
                {"rail only: V<sub>c</sub>, mph", "{:.1f}"},
                {"and half a tie", "{:.1f}"},
                {"and ballast", "{:.1f}"},
                {"ignored at 250 mph, %: rail only", "{:.2f}"},
                {"and half a tie", "{:.2f}"},
                {"and ballast", "{:.2f}"}});
  const double mph = units::mph;
  const MovingTrack track;
  const double ei = track.rail.bending_stiffness(), typical = track.modulus();
  const double rail_alone = track.rail.mass_per_length, with_tie = track.with_tie(),
               with_ballast = track.with_ballast();
  const auto speed = [&](double modulus, double rho) { return critical_speed(ei, modulus, rho); };
  for (const double k : {1000 * units::psi, 1500 * units::psi, typical, 2000 * units::psi,
                         3000 * units::psi, 5000 * units::psi}) {
    const double rail = speed(k, rail_alone), tie = speed(k, with_tie),
                 all = speed(k, with_ballast);
    item.add_row(k / units::psi, rail / mph, tie / mph, all / mph, ignored(250 * mph, rail),
                 ignored(250 * mph, tie), ignored(250 * mph, all));
  }
  item.expect_checks(2);
  const table::CsvTable printed = item.printed("numbers.csv");
  const double own = track.critical(), wave = slowest_wave(ei, typical, with_ballast);
  item.claims({{"free-wave", {own / mph, wave / mph, wave / own - 1}}});
  item.row(printed, "error-at-250")
      .print("printed", ignored(250 * mph, 1100 * mph),
             report::at_most("from the paper's own 1100 mph"));
  report::Trial trial = item.trial("conclusion", "ignored at 150 mph", "{:.1f} %",
                                   [](double percent) { return percent < 5; });
  double slow = own, fast = own;  // of the critical speeds that are tried
  vary_track(trial, [&](double v) {
    slow = std::min(slow, v), fast = std::max(fast, v);
    return ignored(150 * mph, v);
  });
  item.consistent("conclusion", "a lumped track may move below each wheel at 150 mph or less",
                  trial,
                  fmt::format("{:.1f} % of the deflection is ignored, {} as the track is varied",
                              ignored(150 * mph, own), trial.range()),
                  "the paper does not say how much may be ignored; 5 % is our limit");
  const MovingTrack best = most_favourable(460 * units::psi / units::inch);
  item.value("k-best", best.modulus() / units::psi, "psi", "{:.0f}");
  item.value("v-range", fmt::format("{:.0f} to {:.0f} mph", slow / mph, fast / mph));
  item.value("error-range",
             fmt::format("{:.1f} to {:.1f} %", ignored(250 * mph, fast), ignored(250 * mph, slow)));
  item.value("error-150-range", trial.range());
  item.value("v-rail", speed(typical, rail_alone) / mph, "mph", "{:.0f}");
  item.value("v-tie", speed(typical, with_tie) / mph, "mph", "{:.0f}");
  item.value("v-ballast", own / mph, "mph", "{:.0f}");
  item.value("error-at-250-ballast", ignored(250 * mph, own), "%", "{:.1f}");
  item.value("error-at-150-ballast", ignored(150 * mph, own), "%", "{:.1f}");
  const auto modulus_for_1100 = [&](double rho) {
    return std::pow(1100 * mph, 4) * rho * rho / (4 * ei) / units::psi;
  };
  item.value("k-for-1100", modulus_for_1100(rail_alone), "psi", "{:.0f}");
  item.value("k-for-1100-tie", modulus_for_1100(with_tie), "psi", "{:.0f}");
  item.value("k-for-1100-ballast", modulus_for_1100(with_ballast), "psi", "{:.0f}");
}

void shapes(report::Item& item) {
  item.added("the paper refers to others for this solution");
  auto& left = item.data({"s", "theta_0", "theta_05", "theta_08", "theta_095"});
  for (double s = -10; s <= 10.001; s += 0.02)
    left.add(s, moving_load(0, 0).deflection(s), moving_load(0.5, 0).deflection(s),
             moving_load(0.8, 0).deflection(s), moving_load(0.95, 0).deflection(s));
  auto& right = item.data("damped", {"s", "theta_05", "theta_1", "theta_2"});
  for (double s = -15; s <= 5.001; s += 0.02)
    right.add(s, moving_load(0.5, 0.2).deflection(s), moving_load(1, 0.2).deflection(s),
              moving_load(2, 0.2).deflection(s));
  auto& nodes = item.data("elements", {"s", "y"});
  for (const double theta : {0.5, 1.0, 2.0}) {
    const auto fe = fe_steady(theta, 0.2);
    for (std::size_t i = 0; i < fe.s.size(); i += 16)
      if (fe.s[i] >= -15 && fe.s[i] <= 5) nodes.add(fe.s[i], fe.y[i]);
  }
}

void amplification(report::Item& item) {
  item.added("largest deflection against speed");
  const auto top = [](double theta, double zeta) { return moving_load(theta, zeta).maximum().y; };
  auto& curves = item.data({"theta", "zeta_005", "zeta_02", "zeta_04", "zeta_1"});
  for (double theta = 0; theta <= 2.5001; theta += 0.01)
    curves.add(theta, top(theta, 0.05), top(theta, 0.2), top(theta, 0.4), top(theta, 1.0));
  auto& undamped = item.data("undamped", {"theta", "amplification"});
  for (double theta = 0; theta < 0.985; theta += 0.005)
    undamped.add(theta, undamped_amplification(theta));
  auto& marks = item.data("speeds", {"theta", "amplification"});
  auto& own = item.data("own-speeds", {"theta", "amplification"});
  const double critical = MovingTrack{}.critical() / units::mph;
  for (const double mph : {150.0, 250.0}) {
    marks.add(mph / 1100, undamped_amplification(mph / 1100));
    own.add(mph / critical, undamped_amplification(mph / critical));
  }
  for (const auto& [id, zeta] :
       {std::pair{"most-015", 0.15}, {"most-025", 0.25}, {"most-040", 0.4}}) {
    double most = 0;
    for (double theta = 0; theta <= 1.5; theta += 1e-3) most = std::max(most, top(theta, zeta));
    item.value(id, most, "", "{:.2f}");
  }
  item.value("quarter", 100 * (undamped_amplification(0.25) - 1), "%", "{:.1f}");
}

}  // namespace

const report::Section moving{
    report::table(
        "critical-speed",
        "With tie and ballast the critical speed is far below 1100 mph. Critical speed of 132RE "
        "rail by (9), and the error of ignoring the waves at 250 mph, by what moves with the rail.",
        critical_speeds),
    report::figure(
        "fig-moving",
        "With damping the dent lags behind the load, above the critical speed most of all. Shape "
        "of the rail seen from the load, which runs to the right, without damping (left) and with "
        "it (right); points are finite elements.",
        shapes),
    report::figure(
        "fig-amplification",
        "Up to a quarter of the critical speed hardly anything happens. Largest deflection "
        "over the static one; the marks are 150 and 250 mph, for the paper's 1100 mph "
        "and for our typical track.",
        amplification)};

}  // namespace railbook::track_chapter
