/***
## A rail is a beam on a bed of springs

The paper's first model is Winkler's: the rail is an infinite beam of bending stiffness $EI$ and the ties below
it are smeared into a bed of springs of stiffness $K$ per length, the *foundation modulus* (or track modulus) of
one rail. Under a wheel load $P$ the deflection is, equation (1),

$$y(X)=\frac{P\beta}{2K}\,a(X),\qquad a(X)=e^{-\beta|X|}(\cos\beta X+\sin\beta|X|),\qquad
  \beta=\left(\frac{K}{4EI}\right)^{1/4}.$$

The paper prints $X$ where $|X|$ is meant. One length, $1/\beta$, governs everything: how far a wheel is felt,
how much two wheels of a truck share, how long the reach of a joint is.

{{fig-01}}

The shape is checked against the Fourier integral $\frac{P}{\pi}\int_0^\infty\frac{\cos kX}{EIk^4+K}\,dk$, which
shares no formula with it. The rail lifts between $\beta X=3\pi/4$ and $7\pi/4$, most at $\beta X=\pi$, by
{{uplift}} of the deflection under the load.
*/

#include <fmt/format.h>

#include <cmath>

#include "items.hpp"
#include "num/quadrature.hpp"
#include "track/beam_elements.hpp"
#include "track/typical_track.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {

constexpr double lb_per_in = units::lbf / units::inch;

void shape(report::Item& item) {
  auto& curve = item.data({"beta_x", "a"});
  for (int i = -400; i <= 400; ++i) curve.add(0.01 * i, winkler_shapes(std::abs(0.01 * i)).a);
  auto& integral = item.data("fourier", {"beta_x", "a"});

  item.explained("closed form against the Fourier integral; the figure prints no numbers");
  item.expect_checks(7);
  const WinklerBeam unit{.bending_stiffness = 0.25, .foundation_modulus = 1.0};  // beta = 1
  for (const double xi : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0}) {
    const double y = deflection_by_fourier(unit, unit.point_stiffness(), xi, 1e-9).value;
    item.agree(fmt::format("a-{}", xi), fmt::format("a at beta X = {}", xi), "", y,
               winkler_shapes(xi).a, 1e-7, "equation (1)");
    integral.add(xi, y);
  }
  item.value("uplift", -100 * winkler_shapes(units::pi).a, "%", "{:.2f}");
}

/***
Equation (2) is the stiffness that a wheel feels, $K_r=P/y(0)=2\,(4EIK^3)^{1/4}=2K/\beta$. Because it goes with
$K^{3/4}$ and only with $EI^{1/4}$, the ground matters far more than the rail:

{{fig-rails}}

{{continuous}}

For an "average" main line the text puts the point of zero deflection "roughly ten feet" from the wheel. With
132RE rail that is exact for $K$ = {{k-ten-feet}}. The text never gives $K$; modern and old sources put
maintained main lines at 1500 to 3000 psi, so ten feet describes the soft end.

Linearity gives the rest. Two equal wheels at a distance $l$ deflect the rail under each of them by
$1+a(l)$ times the deflection of one, the formula printed below the paper's Figure 1: a wheel of a 66-inch truck feels
{{share-66}} of $K_r$, one of a 108-inch truck {{share-108}}.
*/

WinklerBeam rail_132(double modulus_psi) {
  return {typical_rail().bending_stiffness(), modulus_psi * units::psi};
}

// Deflection under one wheel of a pair, by exact finite elements: two nodes under the wheels, two far off.
double pair_by_elements(const WinklerBeam& beam, double base, double force) {
  const double far = 20.0 / beam.beta();
  const BeamModel model{.bending_stiffness = beam.bending_stiffness,
                        .foundation_modulus = beam.foundation_modulus,
                        .x = Eigen::VectorXd{{-far, 0.0, base, base + far}}};
  return solve_beam(model, {{1, force}, {2, force}}).deflection(1);
}

void continuous(report::Item& item) {
  item.columns({"K, psi", "β, 1/in", "K_r, lb/in", "K_r, MN/m", "zero deflection, ft",
                "joint reach 2/β, ft"});
  for (const double modulus : {1000.0, 1500.0, 2000.0, 3000.0, 5000.0}) {
    const auto beam = rail_132(modulus);
    item.add_row({fmt::format("{:.0f}", modulus), fmt::format("{:.6f}", beam.beta() * units::inch),
                  fmt::format("{:.0f}", beam.point_stiffness() / lb_per_in),
                  fmt::format("{:.2f}", beam.point_stiffness() / 1e6),
                  fmt::format("{:.3f}", beam.zero_distance() / units::foot),
                  fmt::format("{:.3f}", 2 / beam.beta() / units::foot)});
  }
  item.reconstructed(
      "the paper gives neither K nor the rail of its average track; ours is 132RE and the "
      "typical support below");
  item.expect_checks(5);
  const auto claims = item.printed("claims.csv");
  const auto beam = typical_beam();
  track_chapter::check_claim(item, claims, "zero", beam.zero_distance() / units::foot);
  track_chapter::check_claim(
      item, claims, "joint-reach", 2 / beam.beta() / units::foot,
      report::absolute(2.5,
                       "\"roughly 10 feet\" read as rounded to five; 2/β is 0.85 of the 3π/4β "
                       "that the paper also calls roughly ten feet"));
  item.agree("deflection", "deflection under 27.5 kip", "in",
             deflection_by_fourier(beam, typical_wheel_load, 0, 1e-10).value / units::inch,
             typical_wheel_load / beam.point_stiffness() / units::inch, 1e-8, "equation (2)");
  for (const double base : {66.0, 108.0}) {
    const WheelLoad pair[] = {{0, typical_wheel_load}, {base * units::inch, typical_wheel_load}};
    const double stiffness = stiffness_under_wheel(beam, pair, 0);
    item.agree(fmt::format("pair-{}", base), fmt::format("two wheels {} in apart", base), "in",
               pair_by_elements(beam, base * units::inch, typical_wheel_load) / units::inch,
               typical_wheel_load / stiffness / units::inch, 1e-9, "superposition of equation (1)");
    item.value(fmt::format("share-{}", base), stiffness / beam.point_stiffness(), "", "{:.3f}");
  }
  item.value("uplift-pull",
             -winkler_shapes(units::pi).a * typical_wheel_load * beam.beta() / 2 / lb_per_in,
             "lb/in", "{:.1f}");
  item.value("uplift-weight",
             units::standard_gravity *
                 (typical_rail().mass_per_length +
                  typical_tie_mass / (2 * typical_support().tie_spacing)) /
                 lb_per_in,
             "lb/in", "{:.1f}");
  const double beta = 0.75 * units::pi / (10 * units::foot);
  const auto modulus_for = [&](double b) {
    return 4 * beam.bending_stiffness * std::pow(b, 4) / units::psi;
  };
  item.value("k-ten-feet", modulus_for(beta), "psi", "{:.1f}");
  item.value("k-ten-feet-joint", modulus_for(2 / (10 * units::foot)), "psi", "{:.1f}");
  item.value("reach-ratio", 2 / (0.75 * units::pi), "", "{:.3f}");
}

void rails(report::Item& item) {
  auto& curves = item.data({"K_psi", "K_r_115RE_MN_per_m", "K_r_119RE_MN_per_m",
                            "K_r_132RE_MN_per_m", "K_r_136RE_MN_per_m"});
  const auto stiffness = [](const char* rail, double modulus) {
    return WinklerBeam{rail_section(rail).bending_stiffness(), modulus}.point_stiffness() / 1e6;
  };
  for (double psi = 200; psi <= 8000; psi *= 1.05) {
    const double k = psi * units::psi;
    curves.add(psi, stiffness("115RE", k), stiffness("119RE", k), stiffness("132RE", k),
               stiffness("136RE", k));
  }
  auto& typical = item.data("typical", {"K_psi", "K_r_MN_per_m"});
  typical.add(typical_beam().foundation_modulus / units::psi,
              typical_beam().point_stiffness() / 1e6);
  item.reconstructed("not in the paper: equation (2) for four rail sections of its time");
}

}  // namespace

void track_chapter::add_stiffness(report::Chapter& chapter) {
  chapter.figure("fig-01", "Rail deflection under a point load (the paper's Fig. 1)", shape);
  chapter.figure("fig-rails", "Stiffness under one wheel against the foundation modulus", rails);
  chapter.table("continuous", "132RE rail on a continuous foundation", continuous);
}
