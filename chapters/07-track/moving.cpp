/***
## A load that runs along the rail

The beam on its bed also carries waves, and a load that runs as fast as the slowest of them would outrun its own
deflection. That speed is equation (9),

$$V_c=\left(\frac{4EIK}{\rho^2}\right)^{1/4},$$

the smallest phase speed $\omega/k$ of $EIk^4+K=\rho\omega^2$. The paper puts it at about 1100 mph and concludes that at
250 mph the whole phenomenon is worth less than 3 percent, so that a lumped track may travel below each wheel. It does
not say what it took for $K$ and for $\rho$, and the answer hangs on what moves with the rail:

{{critical-speed}}

With the rail's mass alone we come to {{v-rail}}, near the printed figure. Add half a tie and it is {{v-tie}}; add the
ballast of equation (18) and it is {{v-ballast}}. But $\rho$ in (9) is the "track mass per unit length", and below (15)
it is that "of tie, ballast and rail". Read that way, {{error-at-250-ballast}} and not 3 percent are ignored at 250 mph. For the 150 mph that the
paper had in mind it is still only {{error-at-150-ballast}}: its conclusion stands, its number does not.
*/

#include "track/moving_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "items.hpp"
#include "track/fe_moving_load.hpp"
#include "track/typical_track.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {

// What moves with the rail: nothing else, half of each tie, or that and the ballast below it.
std::array<double, 3> masses_per_length(const RailSection& rail, const TieSupport& support) {
  const double tie = 0.5 * typical_tie_mass / support.tie_spacing;
  return {rail.mass_per_length, rail.mass_per_length + tie,
          rail.mass_per_length + tie + ballast_mass_per_length(typical_ballast, support)};
}

void critical_speeds(report::Item& item) {
  const auto& rail = typical_rail();
  const auto support = typical_support();
  const auto masses = masses_per_length(rail, support);
  const auto percent = [](double mph, double critical) {
    return 100 * (undamped_amplification(mph * units::mph / critical) - 1);
  };
  item.columns({"K, psi", "rail only: V_c, mph", "and half a tie", "and ballast",
                "ignored at 250 mph, rail only", "and half a tie", "and ballast"});
  const double typical = typical_beam().foundation_modulus;
  for (const double modulus :
       {1000 * units::psi, 1500 * units::psi, typical, 2000 * units::psi, 3000 * units::psi}) {
    std::vector<std::string> cells{fmt::format("{:.0f}", modulus / units::psi)};
    std::array<double, 3> v{};
    for (std::size_t i = 0; i < 3; ++i)
      v[i] = critical_speed(rail.bending_stiffness(), modulus, masses[i]);
    for (const double speed : v) cells.push_back(fmt::format("{:.1f}", speed / units::mph));
    for (const double speed : v) cells.push_back(fmt::format("{:.2f} %", percent(250, speed)));
    item.add_row(cells);
    if (modulus != typical) continue;
    item.value("v-rail", v[0] / units::mph, "mph", "{:.0f}");
    item.value("v-tie", v[1] / units::mph, "mph", "{:.0f}");
    item.value("v-ballast", v[2] / units::mph, "mph", "{:.0f}");
    item.value("error-at-250-ballast", percent(250, v[2]), "%", "{:.1f}");
    item.value("error-at-150-ballast", percent(150, v[2]), "%", "{:.1f}");
    const double claimed = 1100 * units::mph;
    const double ei = rail.bending_stiffness();
    item.value("k-for-1100", std::pow(claimed, 4) * masses[0] * masses[0] / (4 * ei) / units::psi,
               "psi", "{:.0f}");
    item.value("rho-for-1100", 2 * std::sqrt(ei * modulus) / (claimed * claimed) / masses[0],
               "times", "{:.2f}");
    item.value("v-three-percent", 1100 * std::sqrt(1 - 1 / (1.03 * 1.03)), "mph", "{:.1f}");
    item.expect_checks(3);
    const auto claims = item.printed("motion.csv");
    track_chapter::check_claim(
        item, claims, "critical-speed", v[0] / units::mph,
        report::relative(0.08,
                         "the text says 'about' and gives neither K nor the mass; "
                         "ours is the typical track with the rail's mass alone"));
    track_chapter::check_claim(item, claims, "error-at-250", percent(250, 1100 * units::mph),
                               report::at_most("with the paper's own 1100 mph"));
    // The smallest phase speed, found by scanning the dispersion relation of the free wave.
    double least = 1e9;
    for (double k = 0.5; k < 4; k *= 1.0001)
      least = std::min(least, std::sqrt((ei * k * k + modulus / (k * k)) / masses[0]));
    item.agree("dispersion", "V_c, rail only", "mph", v[0] / units::mph, least / units::mph, 1e-7,
               "the slowest free wave");
  }
  item.reconstructed("K and rho of the paper's 1100 mph are not given; ours is the typical track");
}

/***
### The shape under the load

Seen from the load, in $s=\beta(X-Vt)$ and in units of $P\beta/2K$, the rail's shape satisfies

$$y''''+4\theta^2y''-8\zeta\theta y'+4y=8\,\delta(s),\qquad \theta=V/V_c,$$

with a damping $2\zeta\sqrt{K\rho}$ of the bed. Without damping it is a closed form, and under the load it is
$1/\sqrt{1-\theta^2}$. With damping the textbook route takes the four roots of
$p^4+4\theta^2p^2-8\zeta\theta p+4=0$ and solves for four amplitudes; both steps lose digits where two roots meet, as they
do at $V_c$. We do not need the roots. The quartic always splits into two real quadratics,
$(p^2+ap+b)(p^2-ap+c)$, whose $u=a^2$ is the one positive root of

$$u^3+8\theta^2u^2+16(\theta^4-1)u-64\zeta^2\theta^2=0,$$

a convex cubic on which Newton's method cannot fail. The first factor rules ahead of the load, the second behind, and
continuity leaves

$$y(0)=\frac{8a}{a^2(b+c)+2d^2},\qquad y'(0)=-\frac{d}{a}\,y(0),\qquad d=\frac{4\zeta\theta}{a}.$$

Nothing here subtracts nearly equal numbers, and the solution from $y(0),y'(0)$ is written with
$\sin(ws)/w$, which does not care whether $w^2$ is positive, negative or zero.

{{fig-moving}}

Below $V_c$ the dent is symmetric without damping and leans back with it. Above $V_c$ it falls behind: at twice $V_c$ it
trails the load by {{lag-heavy}} to {{lag-light}} characteristic lengths, and short waves run ahead, long ones behind.

{{moving-load}}

Two finite-element programs confirm it. One solves the steady state in the moving frame; the other lays a long beam
on its bed, runs the load over it in time with Newmark's method, waits for the transient to die, and is extrapolated
in step and element ($\zeta$ = 0.4). They share with
the closed form nothing but the differential equation, and agree with it to {{worst-steady}} and {{worst-newmark}}
of the static deflection.
*/

void moving_load_table(report::Item& item) {
  item.columns({"theta", "zeta", "at the load", "largest", "where, s", "smallest", "where, s"});
  constexpr std::array thetas{0.5, 0.8, 1.0, 2.0};
  constexpr std::array zetas{0.05, 0.2, 0.4, 1.0};
  item.reconstructed("not in the paper: closed form against finite elements");
  item.expect_checks(3 * 16 + 1 + 3 + 1);
  double worst = 0;
  for (const double theta : thetas)
    for (const double zeta : zetas) {
      const auto shape = moving_load(theta, zeta);
      const auto top = shape.maximum(), bottom = shape.minimum();
      item.add_row({fmt::format("{}", theta), fmt::format("{}", zeta),
                    fmt::format("{:.6f}", shape.at_load()), fmt::format("{:.6f}", top.y),
                    fmt::format("{:.4f}", top.s), fmt::format("{:.6f}", bottom.y),
                    fmt::format("{:.4f}", bottom.s)});
      const auto fe = fe_steady(theta, zeta, {.element = 0.02, .neglect = 1e-9});
      worst = std::max(worst, largest_difference(fe, theta, zeta, -1e9, 1e9));
      if (theta == 2.0 && (zeta == zetas.front() || zeta == zetas.back()))
        item.value(zeta == zetas.front() ? "lag-light" : "lag-heavy", -top.s, "", "{:.1f}");
      const auto agree = [&](const char* id, const char* what, std::size_t node) {
        const double exact = shape.deflection(fe.s[node]);
        item.agree(fmt::format("{}-{}-{}", id, theta, zeta),
                   fmt::format("{}, theta = {}, zeta = {}", what, theta, zeta), "", fe.y[node],
                   exact, 1e-6 / std::abs(exact), "the closed form; 1e-6 of the static deflection");
      };
      const auto [low, high] = std::ranges::minmax_element(fe.y);
      const auto load = std::ranges::lower_bound(fe.s, -1e-9);
      agree("load", "at the load", std::size_t(load - fe.s.begin()));
      agree("top", "largest node", std::size_t(high - fe.y.begin()));
      agree("bottom", "smallest node", std::size_t(low - fe.y.begin()));
    }
  item.value("worst-steady", worst, "", "{:.0e}");
  item.agree("everywhere", "steady elements, largest difference anywhere, plus one", "", 1 + worst,
             1, 1e-6, "the closed form");

  double worst_run = 0;
  for (const double theta : {0.5, 1.0, 2.0}) {
    const auto fe = fe_newmark_extrapolated(theta, 0.4, {.element = 0.08, .step = 0.08 / 3});
    worst_run = std::max(worst_run, largest_difference(fe, theta, 0.4, -15, 10));
    const auto high = std::ranges::max_element(fe.y) - fe.y.begin();
    const double exact = moving_load(theta, 0.4).deflection(fe.s[std::size_t(high)]);
    item.agree(fmt::format("newmark-{}", theta),
               fmt::format("largest node of the run in time, theta = {}, zeta = 0.4", theta), "",
               fe.y[std::size_t(high)], exact, 1e-6, "the closed form");
  }
  item.agree("newmark-everywhere", "run in time, largest difference for s from -15 to 10, plus one",
             "", 1 + worst_run, 1, 1e-6, "the closed form");
  item.value("worst-newmark", worst_run, "", "{:.0e}");
}

void shapes(report::Item& item) {
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
  item.reconstructed("not in the paper, whose figure of this solution is a reference to others");
}

/***
What remains of the matter for a designer is this: at a quarter of $V_c$ the rail goes {{quarter}} deeper, and damping
keeps the maximum finite. The paper's 15 to 25 percent of material damping leave a factor of {{most-015}} to
{{most-025}} at the worst speed; of its range for radiation, 40 percent leave {{most-040}}, and with 100 the rail is
deepest at rest.

{{fig-amplification}}
*/

void amplification(report::Item& item) {
  auto& curves = item.data({"theta", "zeta_005", "zeta_02", "zeta_04", "zeta_1"});
  for (double theta = 0; theta <= 2.5001; theta += 0.01) {
    const auto top = [theta](double zeta) { return moving_load(theta, zeta).maximum().y; };
    curves.add(theta, top(0.05), top(0.2), top(0.4), top(1.0));
  }
  auto& undamped = item.data("undamped", {"theta", "amplification"});
  for (double theta = 0; theta < 0.985; theta += 0.005)
    undamped.add(theta, undamped_amplification(theta));
  auto& marks = item.data("speeds", {"theta", "amplification"});
  for (const double mph : {150.0, 250.0}) marks.add(mph / 1100, undamped_amplification(mph / 1100));
  for (const auto& [id, zeta] :
       {std::pair{"most-015", 0.15}, {"most-025", 0.25}, {"most-040", 0.4}}) {
    double most = 0;
    for (double theta = 0; theta <= 1.5; theta += 1e-3)
      most = std::max(most, moving_load(theta, zeta).maximum().y);
    item.value(id, most, "", "{:.2f}");
  }
  item.value("quarter", 100 * (undamped_amplification(0.25) - 1), "%", "{:.1f}");
  item.reconstructed("not in the paper: largest deflection against speed");
}

}  // namespace

void track_chapter::add_moving(report::Chapter& chapter) {
  chapter.table("critical-speed", "Critical speed, and what 250 mph ignores", critical_speeds);
  chapter.figure("fig-moving", "Rail shape under a moving load", shapes);
  chapter.table("moving-load", "Damped moving load, in units of the static deflection",
                moving_load_table);
  chapter.figure("fig-amplification", "Largest deflection against speed", amplification);
}
