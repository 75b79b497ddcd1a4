/***
## How much of the track moves

For a lumped model the track needs a mass beside its spring. The paper's is

$$M_r=\frac{3\rho}{2\beta}, \tag{15}$$

$\rho$ being the mass per length of rail, half the ties, and ballast, "derived from the first natural frequency of a beam on an elastic foundation". It is the mass
whose kinetic energy equals the beam's when the whole static shape moves up and down with its peak: $\rho\int a^2dX=3\rho/2\beta$, since
$\int a^2\,d(\beta X)=\frac32$ over the line. The first natural frequency of the infinite beam, where waves begin to travel, is $\sqrt{K/\rho}$ and belongs to
$2\rho/\beta$; with (15) one finds $\sqrt{4/3}$ of it, {{too-high}} too high. As an upper bound of Rayleigh's kind that is in order.

{{masses}}

Impact needs two masses, since ties and ballast cannot follow a wheel that hits a joint. The rail alone is (15) on the stiffness of pads and ties:

$$M_{rail}=\frac{3\rho_r}{2\beta_o}, \tag{16}$$

$$\beta_o=\left[\frac{k_{pad}k_{tie}}{l_t(k_{pad}+k_{tie})\,4EI}\right]^{1/4}. \tag{17}$$

For the ballast that moves with a tie the paper has two rules of thumb. The first weighs a body of stone below the tie,

$$\rho_b=\frac{d_b\,w\,A_t\,C_m}{N\,l_t\,g\tan\alpha}, \tag{18}$$

where the integer $N$ cannot be read in our copy: 6 is what a pyramid of depth $w/2\tan\alpha$ needs, 4 a wedge. The other, which carries the same number, uses the
speed of shear waves, $\rho_b=0.28\,k_bA_t/(l_tV^2)$; $k_b$, the "effective" stiffness under half a tie, is read as $k_{bs}/2$. Half a tie and its ballast are

$$m_t=\frac3{2\beta}\left(\frac{W_{tie}}{2gl_t}+\rho_b\right). \tag{19}$$

The rules differ by {{mass-spread}} in $m_t$, and nothing in the paper says which is nearer.

{{code: track/effective_mass.cpp ballast_mass_per_length}}

Damping is taken as viscous, $C=2\zeta\sqrt{K_rM}$, with $\zeta$ of 0.15 to 0.25 from tests on clean ballast or 0.40 to 1.00 from radiation into the half-space: a
factor of seven, which {{fig-amplification}} makes visible.
*/

#include <fmt/format.h>

#include <cmath>

#include "num/quadrature.hpp"
#include "sections.hpp"
#include "track/effective_mass.hpp"
#include "track/typical_track.hpp"

namespace railbook::track_chapter {

using namespace track;

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

// The lowest frequency of a long free rail, from its longest standing wave: it comes down to sqrt(K / rho).
double longest_standing_wave(const WinklerBeam& beam, double rho) {
  const double wave = units::pi / (200 / beam.beta());
  return std::sqrt((beam.bending_stiffness * std::pow(wave, 4) + beam.foundation_modulus) / rho);
}

void masses_table(report::Item& item) {
  item.rebuilt("the paper gives the formulas; the data and N in (18) are assumed");
  const auto m = typical_masses();
  item.columns({"mass", "from", "value"});
  item.add_row("rail on the whole track", "(15) with the rail alone: 132RE, assumed",
               both_units(m.rail_only));
  item.add_row("rail on its ties", "(16), (17)", both_units(m.rail));
  item.add_row("rail and half a tie", "a footnote: British practice for impact, 0.4 of (15)",
               both_units(m.british));
  item.add_row("tie and ballast",
               "(18), (19), N = 6: tie 200 lb, A_t = 270 in², 0.0579 lb/in³, C_m = 1, all assumed",
               both_units(m.bed_pyramid));
  item.add_row("tie and ballast", "the same, N = 4", both_units(m.bed_wedge));
  item.add_row("tie and ballast", "second (18): shear waves at 1000 ft/s, assumed",
               both_units(m.bed_seismic));
  item.expect_checks(3);
  const auto beam = typical_beam();
  const double rho = typical_rail().mass_per_length, beta = beam.beta();
  const auto energy = [&](double x) { return rho * std::pow(winkler_shapes(beta * x).a, 2); };
  item.agree("energy-mass", "(15), as the kinetic-energy mass of the static shape", "kg",
             m.rail_only, 2 * num::integrate(energy, 0, 40 / beta, 1e-12).value, 1e-10,
             "the integral of rho a^2");
  const double first = longest_standing_wave(beam, rho);
  item.agree("cut-on", "lowest frequency from 2 rho / beta", "rad/s",
             std::sqrt(beam.point_stiffness() / cut_on_mass(rho, beta)), first, 1e-6,
             "a standing wave 400 / beta long");
  const double implied = std::sqrt(beam.point_stiffness() / effective_mass(rho, beta));
  const double too_high = implied / cut_on_frequency(beam, rho) - 1;
  item.refute("natural-frequency", "(15) follows from the first natural frequency of the beam",
              too_high > 0.15,
              fmt::format("it implies a frequency {:.1f} % higher", 100 * too_high));
  item.value("too-high", 100 * too_high, "%", "{:.1f}");
  item.value("mass-spread", 100 * (m.bed_wedge / m.bed_seismic - 1), "%", "{:.0f}");
}

}  // namespace

const report::Section masses{
    report::table("masses", "Effective masses of the typical track, one rail", masses_table)};

}  // namespace railbook::track_chapter
