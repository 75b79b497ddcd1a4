/***
## A rail is a beam on a bed of springs

How far does a rail sink under a wheel, and how far away is this felt? The paper takes the rail as
an infinite beam of bending stiffness $EI$ (Young's modulus $E$ times the second moment $I$ of its
section). The ties below it are smeared into a bed of springs. Its stiffness $K$ is force for each
inch of deflection and each inch of rail; (lbf/in)/in has the unit psi, although $K$ is no pressure.
It is the *foundation modulus* of one rail. At a distance $X$ from a wheel load $P$ the deflection
$y$ is

$$y(X)=\frac{P\beta}{2K}\,a(X),\qquad a(X)=e^{-\beta|X|}(\cos\beta X+\sin\beta|X|),\qquad
  \beta=\left(\frac{K}{4EI}\right)^{1/4}, \tag{1}$$

where $a$ is its shape, 1 under the load. One length, $1/\beta$, governs everything: how far a wheel
is felt, how much two wheels of a truck (the frame under an end of the car) add to each other's
deflection, how far the effect of a joint reaches. The function `winkler_shapes`, named after
Winkler, who introduced the bed of springs, returns four functions: $a$, and those to which the
rail's slope, moment and shear are proportional.

{{code: track/beam_on_foundation.cpp winkler_shapes}}

{{fig-01}}

The squares in {{fig-01}} are a check, the same deflection as a Fourier integral over the wavenumber
$\nu$, $\frac{P}{\pi}\int_0^\infty\frac{\cos\nu X}{EI\nu^4+K}\,d\nu$. The rail lifts between
$\beta X=3\pi/4$ and $7\pi/4$, most at $\beta X=\pi$, by {{uplift}} of the deflection under the
load.

The stiffness that a wheel feels is

$$K_r=\frac{P}{y(0)}=2\,(4EIK^3)^{1/4}. \tag{2}$$

It is proportional to $K^{3/4}$ and only to $(EI)^{1/4}$: the ground matters far more than the rail.
{{continuous}} has numbers for a common rail, 132RE (132 pounds a yard, a standard American
section).

{{continuous: rows}}

::: {.fold summary="The paper calls two different lengths ten feet"}

For an "average" main line the text puts the point of zero deflection "roughly ten feet" from the
wheel. With 132RE rail it is ten feet if $K$ = {{k-ten-feet}}; the typical track of this chapter was
chosen to be near that. Later the paper lets the effect of a joint disappear beyond $\beta X=2$, "or
roughly 10 feet for average track". This distance is {{reach-ratio}} of the one to zero deflection,
so the two cannot both be exactly ten feet. On one track both can be "roughly" so: with $K$ =
{{k-both}} they are {{reach-both}} and {{zero-both}}.

:::

The deflection is linear in the loads. A second wheel at a distance $b$ with the same load therefore
adds the fraction $a(b)$ to the deflection under the first, whose stiffness falls to $K_r/(1+a(b))$:
{{share-66}} of $K_r$ in a truck of 66 inches, {{share-108}} in one of 108 inches. Discrete ties
change $K_r$ by {{worst-tie}} at most on rails of 115 to 136 pounds a yard with ties 19.5 to 24
inches apart. So ties that are all supported alike are not why theory and experiment agree only
"more or less".
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/report/values.hpp>
#include <railbook/track/beam_elements.hpp>

#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

void fig_01(report::Item& item) {
  auto& curve = item.data({"beta_x", "a"});
  for (int i = -400; i <= 400; ++i) curve.add(0.01 * i, winkler_shapes(std::abs(0.01 * i)).a);
  auto& integral = item.data("fourier", {"beta_x", "a"});
  const WinklerBeam unit{.bending_stiffness = 0.25, .foundation_modulus = 1.0};  // beta = 1
  double off = 0;
  for (const double xi : {0.0, 0.5, 1.0, 2.0, 4.0}) {
    const double y = deflection_by_fourier(unit, unit.point_stiffness(), xi, 1e-9).value;
    integral.add(xi, y);
    off = std::max(off, std::abs(winkler_shapes(xi).a / y - 1));
  }
  item.expect_checks(1);
  item.at_most("fourier", "largest difference from the Fourier integral, relative", "", off, 1e-7,
               "its quadrature");
  item.value("uplift", -100 * winkler_shapes(units::pi).a, "%", "{:.2f}");
}

// The foundation modulus at which the rail of the typical track has this beta.
double modulus_for(double beta) {
  return 4 * typical_beam().bending_stiffness * std::pow(beta, 4);
}

// Largest share by which K_r on discrete ties differs from (2), over rails and spacings in use.
double worst_discreteness() {
  double worst = 0;
  for (const RailSection& rail : rail_sections())
    for (const double inches : {19.5, 21.0, 24.0}) {
      TieSupport support = typical_support();
      support.tie_spacing = inches * units::inch;
      const WinklerBeam beam{rail.bending_stiffness(), stiffness_chain(support).foundation_modulus};
      for (const auto place : {LoadPlace::over_tie, LoadPlace::midspan})
        worst = std::max(
            worst, std::abs(discrete_tie_ratio(beam.beta() * support.tie_spacing, place) - 1));
    }
  return worst;
}

// a(b) on the typical track at a distance in inches, and what is left of K_r under two such wheels.
double share_of_neighbour(double inches) {
  return winkler_shapes(typical_beam().beta() * inches * units::inch).a;
}
double stiffness_of_pair(double inches) {
  const auto beam = typical_beam();
  const WheelLoad pair[] = {{0, typical_wheel_load}, {inches * units::inch, typical_wheel_load}};
  return stiffness_under_wheel(beam, pair, 0) / beam.point_stiffness();
}

void continuous(report::Item& item) {
  item.rebuilt(
      "the paper gives neither K nor the rail of its average track; these numbers are for 132RE "
      "rail");
  item.columns({{"K, psi", "{:.0f}"},
                {"β, 1/in", "{:.6f}"},
                {"K<sub>r</sub>, lbf/in", "{:.0f}"},
                {"K<sub>r</sub>, MN/m", "{:.2f}"},
                {"first zero deflection at, ft", "{:.3f}"},
                {"2/β, ft", "{:.3f}"}});
  for (const double psi : {1000.0, 1500.0, 2000.0, 3000.0, 5000.0}) {
    const WinklerBeam beam{typical_rail().bending_stiffness(), psi * units::psi};
    item.add_row(psi, beam.beta() * units::inch, beam.point_stiffness() / lb_per_in,
                 beam.point_stiffness() / 1e6, beam.zero_distance() / units::foot,
                 2 / beam.beta() / units::foot);
  }
  item.expect_checks(2);
  const table::CsvTable printed = item.printed("numbers.csv");
  const auto beam = typical_beam();
  const double reach_ratio = 2 / (0.75 * units::pi);
  item.row(printed, "zero")
      .print("printed", beam.zero_distance() / units::foot,
             report::fitted("the typical track was chosen to put zero deflection at ten feet"));
  // One track for both of the paper's "roughly ten feet": one is above ten by the factor by which
  // the other is below.
  const double both = 10 * units::foot * std::sqrt(reach_ratio);
  item.row(printed, "joint-reach")
      .print("printed", both / units::foot,
             report::relative(
                 0.10,
                 fmt::format("not the typical track, where it is {:.1f} ft, but one with K = "
                             "{:.0f} psi, chosen to put zero deflection as far above ten "
                             "feet; 10 % is our reading of roughly",
                             2 / beam.beta() / units::foot, modulus_for(2 / both) / units::psi)));

  const double worst = worst_discreteness();
  item.claims({{"neighbour",
                {share_of_neighbour(66), share_of_neighbour(108),
                 modulus_for(0.75 * units::pi / (108 * units::inch)) / units::psi}},
               {"ties", {100 * worst}}});
  report::values(item, "", "{:.3f}", "share-66", stiffness_of_pair(66), "share-108",
                 stiffness_of_pair(108));
  item.value("worst-tie", 100 * worst, "%", "{:.2f}");
  item.value("reach-ratio", 100 * reach_ratio, "%", "{:.0f}");
  report::values(item, "ft", "{:.2f}", "reach-both", both / units::foot, "zero-both",
                 both / reach_ratio / units::foot);
  report::values(item, "psi", "{:.0f}", "k-both", modulus_for(2 / both) / units::psi, "k-ten-feet",
                 modulus_for(0.75 * units::pi / (10 * units::foot)) / units::psi);
  const double pull = -winkler_shapes(units::pi).a * typical_wheel_load * beam.beta() / 2;
  const double mass =
      typical_rail().mass_per_length + typical_tie_mass / (2 * typical_support().tie_spacing);
  report::values(item, "lbf/in", "{:.1f}", "uplift-pull", pull / lb_per_in, "uplift-weight",
                 mass * units::standard_gravity / lb_per_in);
}

}  // namespace

const report::Section stiffness{report::figure("fig-01", fig_01),
                                report::table("continuous", continuous)};

}  // namespace railbook::track_chapter
