/***
## How much of the track moves

For a lumped model the track needs a mass beside its spring. Equation (15) says

$$M_r=\frac{3\rho}{2\beta},$$

$\rho$ being the mass per length of rail, half the ties, and ballast, "derived from the first natural frequency
of a beam on an elastic foundation". **It is not.** It is the mass whose kinetic energy equals the beam's when
the whole static shape moves up and down with its peak (Rayleigh's mass): $\rho\int a^2dX=3\rho/2\beta$, since
$\int a^2\,d(\beta X)=\frac32$ over the line. The first natural frequency of the infinite beam, where waves
begin to travel, is $\sqrt{K/\rho}$ and belongs to $2\rho/\beta$; with (15) one finds $\sqrt{4/3}$ of it,
{{too-high}} too high. As an upper bound of Rayleigh's kind that is in order. As a mass for a passing load it is
three times too large (see the trackside model).

{{masses}}

Impact needs two masses, since ties and ballast cannot follow a wheel that hits a joint. The rail alone,
equation (16), is (15) on the stiffness of pads and ties, equation (17):

$$M_{rail}=\frac{3\rho_r}{2\beta_o},\qquad
  \beta_o=\left[\frac{k_{pad}k_{tie}}{l_t(k_{pad}+k_{tie})\,4EI}\right]^{1/4}.$$

The bed is half a tie and the ballast that moves with it, equation (19),
$m_t=\frac3{2\beta}(W_{tie}/2gl_t+\rho_b)$. For $\rho_b$ the paper has two rules of thumb. Equation (18) weighs
a body of stone below the tie, $\rho_b=d_bwA_tC_m/(N\,l_t\,g\tan\alpha)$, where the integer $N$ cannot be read
in the available print: 6 is what a pyramid of depth $w/2\tan\alpha$ needs, 4 a wedge. The other, also numbered
(18), uses the speed of shear waves, $\rho_b=0.28\,k_bA_t/(l_tV^2)$; $l_t$ is missing in print and follows from
the units, and $k_b$, the "effective" stiffness under half a tie, we read as $k_{bs}/2$. They differ by
{{mass-spread}} in $m_t$, and nothing in the paper says which is nearer.

Damping is taken as viscous, $C=2\zeta\sqrt{K_rM}$, with $\zeta$ of 0.15 to 0.25 from tests on clean ballast or
0.40 to 1.00 from radiation into the half-space: a factor of seven, which the moving-load section makes visible.
*/

#include <fmt/format.h>

#include <cmath>

#include "items.hpp"
#include "num/quadrature.hpp"
#include "track/effective_mass.hpp"
#include "track/typical_track.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {

std::string both_units(double kilogram) {
  return fmt::format("{:.1f} lb ({:.1f} kg)", kilogram / units::pound, kilogram);
}

struct TypicalMasses {
  double rail_only, rail, british, bed_pyramid, bed_wedge, bed_seismic;
};

TypicalMasses typical_masses() {
  const auto support = typical_support();
  const auto beam = typical_beam();
  const double rho_rail = typical_rail().mass_per_length;
  const auto bed = [&](double ballast) {
    return tie_and_ballast_mass(typical_tie_mass, support.tie_spacing, ballast, beam.beta());
  };
  auto wedge = typical_ballast;
  wedge.divisor = 4;
  return {.rail_only = effective_mass(rho_rail, beam.beta()),
          .rail = effective_mass(rho_rail, rail_beta(beam.bending_stiffness, support)),
          .british = 0.4 * effective_mass(rho_rail + typical_tie_mass / (2 * support.tie_spacing),
                                          beam.beta()),
          .bed_pyramid = bed(ballast_mass_per_length(typical_ballast, support)),
          .bed_wedge = bed(ballast_mass_per_length(wedge, support)),
          .bed_seismic = bed(seismic_mass_per_length(stiffness_chain(support).bed / 2,
                                                     typical_ballast.tamped_area,
                                                     support.tie_spacing, 1000 * units::foot))};
}

void masses(report::Item& item) {
  const auto m = typical_masses();
  item.columns({"mass", "from", "value"});
  item.add_row({"rail on the whole track", "(15) with the rail alone: 132RE, assumed",
                both_units(m.rail_only)});
  item.add_row({"rail on its ties", "(16), (17)", both_units(m.rail)});
  item.add_row({"rail and half a tie", "a footnote: British practice for impact, 0.4 of (15)",
                both_units(m.british)});
  item.add_row({"tie and ballast",
                "(18), (19), N = 6: tie 200 lb, A_t = 270 in², 0.0579 lb/in³, "
                "C_m = 1, all assumed",
                both_units(m.bed_pyramid)});
  item.add_row({"tie and ballast", "the same, N = 4", both_units(m.bed_wedge)});
  item.add_row({"tie and ballast", "second (18): shear waves at 1000 ft/s, assumed",
                both_units(m.bed_seismic)});

  item.reconstructed(
      "the paper gives the formulas; the data, N in (18) and l_t in its second form "
      "are ours");
  item.expect_checks(2);
  const auto beam = typical_beam();
  const double rho = typical_rail().mass_per_length, beta = beam.beta();
  const auto energy = [&](double x) { return rho * std::pow(winkler_shapes(beta * x).a, 2); };
  item.agree("energy-mass", "3 rho / 2 beta, kinetic-energy mass of the static shape", "kg",
             m.rail_only, 2 * num::integrate(energy, 0, 40 / beta, 1e-12).value, 1e-10,
             "the integral of rho a^2");
  // The longest standing wave of a long free rail comes down to sqrt(K / rho), not to sqrt(K_r / M_r).
  const double wave = units::pi / (200 / beta);
  const double longest =
      std::sqrt((beam.bending_stiffness * std::pow(wave, 4) + beam.foundation_modulus) / rho);
  item.agree("cut-on", "lowest frequency from 2 rho / beta", "rad/s",
             std::sqrt(beam.point_stiffness() / cut_on_mass(rho, beta)), longest, 1e-6,
             "a standing wave 400 / beta long");
  item.value("too-high",
             100 * (std::sqrt(beam.point_stiffness() / effective_mass(rho, beta)) /
                        cut_on_frequency(beam, rho) -
                    1),
             "%", "{:.2f}");
  item.value("mass-spread", 100 * (m.bed_wedge / m.bed_seismic - 1), "%", "{:.0f}");
}

}  // namespace

void track_chapter::add_masses(report::Chapter& chapter) {
  chapter.table("masses", "Effective masses of the typical track, one rail", masses);
}
