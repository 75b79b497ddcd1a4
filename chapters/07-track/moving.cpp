/***
## A load that runs along the rail

The beam on its bed also carries waves, and a load that runs as fast as the slowest of them would outrun its own deflection. That speed is

$$V_c=\left(\frac{4EIK}{\rho^2}\right)^{1/4}, \tag{9}$$

the smallest phase speed $\omega/k$ of $EIk^4+K=\rho\omega^2$. The paper puts it at about 1100 mph "using parameters for the rail-tie-ballast type structure" and
concludes that at 250 mph the whole phenomenon is worth less than 3 percent, so that a lumped track may travel below each wheel at 150 mph or less. It does not give
$K$ and $\rho$, and the answer hangs on what moves with the rail:

{{critical-speed}}

With the rail's mass alone the typical track has {{v-rail}}, near the printed figure. But $\rho$ is the "track mass per unit length", and below (15) that "of tie,
ballast and rail". With half a tie the speed is {{v-tie}}; with the ballast of (18), {{v-ballast}}. Then {{error-at-250-ballast}} and not 3 percent are
ignored at 250 mph. At 150 mph it is still only {{error-at-150-ballast}}: the paper's conclusion stands, its number does not.

### The shape under the load

Seen from the load, in $s=\beta(X-Vt)$ and in units of $P\beta/2K$, the rail's shape satisfies

$$y''''+4\theta^2y''-8\zeta\theta y'+4y=8\,\delta(s),\qquad \theta=V/V_c,$$

with a damping $2\zeta\sqrt{K\rho}$ of the bed. Without damping the deflection under the load is $1/\sqrt{1-\theta^2}$. With damping the textbook takes the four roots
of $p^4+4\theta^2p^2-8\zeta\theta p+4=0$ and solves for four amplitudes; both steps lose digits where two roots meet, as they do at $V_c$. The roots are not needed: the
quartic splits into two real quadratics, $(p^2+ap+b)(p^2-ap+c)$, one ahead of the load and one behind, and $u=a^2$ is the one positive root of a convex cubic,

$$u^3+8\theta^2u^2+16(\theta^4-1)u-64\zeta^2\theta^2=0.$$

{{code: track/moving_load.cpp moving_load}}

{{fig-moving}}

Below $V_c$ the dent is symmetric without damping and leans back with it. Above $V_c$ it falls behind, and short waves run ahead, long ones behind. Steady finite
elements in the moving frame, which share nothing with the closed form but the differential equation, are drawn as points.

{{fig-amplification}}

At a quarter of $V_c$ the rail goes {{quarter}} deeper. The paper's 15 to 25 percent of material damping leave a factor of {{most-015}} to {{most-025}} at the worst
speed; of its range for radiation, 40 percent leave {{most-040}}, and with 100 the rail is deepest at rest.
*/
#include "track/moving_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sections.hpp"
#include "track/fe_moving_load.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

// Mass per length that moves with the rail: nothing else, half of each tie, or that and the ballast of (18).
struct MovingMass {
  double rail, and_tie, and_ballast;
};

MovingMass typical_mass() {
  const auto support = typical_support();
  const double rail = typical_rail().mass_per_length;
  const double tie = 0.5 * typical_tie_mass / support.tie_spacing;
  return {rail, rail + tie, rail + tie + ballast_mass_per_length(typical_ballast, support)};
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
                {"rail only: V_c, mph", "{:.1f}"},
                {"and half a tie", "{:.1f}"},
                {"and ballast", "{:.1f}"},
                {"ignored at 250 mph, %: rail only", "{:.2f}"},
                {"and half a tie", "{:.2f}"},
                {"and ballast", "{:.2f}"}});
  const double ei = typical_rail().bending_stiffness(), mph = units::mph;
  const double typical = typical_beam().foundation_modulus;
  const MovingMass mass = typical_mass();
  const auto speed = [&](double modulus, double rho) { return critical_speed(ei, modulus, rho); };
  for (const double k :
       {1000 * units::psi, 1500 * units::psi, typical, 2000 * units::psi, 3000 * units::psi}) {
    const double rail = speed(k, mass.rail), tie = speed(k, mass.and_tie),
                 all = speed(k, mass.and_ballast);
    item.add_row(k / units::psi, rail / mph, tie / mph, all / mph, ignored(250 * mph, rail),
                 ignored(250 * mph, tie), ignored(250 * mph, all));
  }
  item.expect_checks(5);
  const table::CsvTable printed = item.printed("numbers.csv");
  const double own = speed(typical, mass.and_ballast),
               wave = slowest_wave(ei, typical, mass.and_ballast);
  item.claim("free-wave", "the critical velocity is the lowest at which a free wave will propagate",
             std::abs(wave / own - 1) < 1e-6,
             fmt::format("(9) {:.4f} mph, the slowest wave of the dispersion relation {:.4f} mph",
                         own / mph, wave / mph));
  item.row(printed, "critical-speed")
      .print(
          "printed", own / mph,
          report::not_confirmed(wave / mph, 1e-6,
                                "with the mass of rail, tie and ballast; the value is the slowest "
                                "free wave of the dispersion relation"));
  item.row(printed, "error-at-250")
      .print("printed", ignored(250 * mph, 1100 * mph),
             report::at_most("from the paper's own 1100 mph"));
  item.refute("own-mass", "less than 3 percent at 250 mph, with the mass of rail, tie and ballast",
              ignored(250 * mph, own) > 3, fmt::format("{:.1f} %", ignored(250 * mph, own)));
  item.claim("conclusion",
             "a lumped track may move below each wheel at 150 mph or less: under the 3 percent "
             "allowed at 250 mph",
             ignored(150 * mph, own) < 3, fmt::format("{:.1f} %", ignored(150 * mph, own)));
  item.value("v-rail", speed(typical, mass.rail) / mph, "mph", "{:.0f}");
  item.value("v-tie", speed(typical, mass.and_tie) / mph, "mph", "{:.0f}");
  item.value("v-ballast", own / mph, "mph", "{:.0f}");
  item.value("error-at-250-ballast", ignored(250 * mph, own), "%", "{:.1f}");
  item.value("error-at-150-ballast", ignored(150 * mph, own), "%", "{:.1f}");
  const double claimed = 1100 * mph;
  item.value("k-for-1100", std::pow(claimed, 4) * mass.rail * mass.rail / (4 * ei) / units::psi,
             "psi", "{:.0f}");
  item.value("rho-for-1100", 2 * std::sqrt(ei * typical) / (claimed * claimed) / mass.rail, "times",
             "{:.2f}");
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
  for (const double mph : {150.0, 250.0}) marks.add(mph / 1100, undamped_amplification(mph / 1100));
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
    report::table("critical-speed", "Critical speed, and what 250 mph ignores", critical_speeds),
    report::figure("fig-moving", "Rail shape under a moving load", shapes),
    report::figure("fig-amplification", "Largest deflection against speed", amplification)};

}  // namespace railbook::track_chapter
