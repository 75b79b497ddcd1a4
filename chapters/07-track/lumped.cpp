/***
## The lumped track, on car and at trackside

Well below $V_c$ the rail's dent travels with the wheel almost unchanged. A lumped model, one mass
or two on springs and dampers, may therefore be moved along below each wheel. The paper's Figure 4
represents one rail and half of the unsprung mass (the mass below the springs) of a four-wheel
truck, that is two wheels, and "Deflections of the rail under each wheel are influenced by loads at
the adjacent wheels". {{fig-04}} is drawn after these words; {{two-wheels}} tests what two wheels do
to each other.

::: {.fold summary="The model with two wheels, as a figure"}

{{fig-04}}

:::

An instrument at a fixed point beside the track sees wheels come and go. For it the paper takes the
same lumped model,

$$Y(s)=\frac{P(s)}{K_r+C_rs+M_rs^2}, \tag{10}$$

and lets each wheel's force act on it, reduced by the factor $a$ of (1) for the distance between
wheel and instrument. ($Y$ and $P$ are the Laplace transforms of deflection and force, $s$ is the
transform's variable, and $M_r$ and $C_r$ are mass and damping of the track.) Equations (11) to (14)
are not in the text that is available, and nothing in it says what Figure 5 shows. We read the
paper's words as follows, with two masses in place of the one of (10). Wheel $i$ at the place $x_i$
gives the force $P_i$; the rail mass $M_{rail}$ sinks by $y_r$ and the mass $m_t$ of tie and ballast
by $y_t$; $K_1$ and $C_1$ are spring and damper between them, $K_g$ and $C_g$ those to the ground:

$$P(t)=\sum_iP_i(t)\,a\bigl(\beta(Vt-x_i)\bigr),$$

$$M_{rail}\ddot y_r+C_1(\dot y_r-\dot y_t)+K_1(y_r-y_t)=P(t),$$

$$m_t\ddot y_t+C_g\dot y_t+K_gy_t=C_1(\dot y_r-\dot y_t)+K_1(y_r-y_t).$$

::: {.fold summary="How the response is computed without steps in time"}

The shape $a$ is a sum of damped exponentials in time, and for constant loads so is the response.
The function `state` therefore needs no steps in time. While a wheel approaches (`coming_`), the
response has the same exponential as the load. After it has passed, the track swings on from where
it was, which a matrix exponential gives; the load $a$ is two more components of that state
(`leaving_`). The constructor of the class computes the matrices.

{{code: track/lumped.cpp state}}

:::

{{fig-05}}

### What the lumped mass gets wrong

With one mass, as in (10), the response depends on three numbers, the speed ratio $\theta$, the
damping $\zeta$ and the mass ratio $\mu=M_r\beta^2V_c^2/K_r$, which is 3/4 for the mass of (15). At
low speed its peak grows as $1+2\mu\theta^2$, that of the beam under a moving load as
$1+\theta^2/2$. As we read (10), the mass (15) therefore makes the effect of inertia at a fixed
point three times too large. For this one purpose, a passing load of low speed, $M_r=\rho/2\beta$
($\mu=1/4$) would be right; the next section has the masses for other purposes.

::: {.fold summary="The peak at trackside, by lumped mass and by beam"}

{{trackside-peak}}

:::
*/
#include <fmt/format.h>

#include <array>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/track/lumped.hpp>
#include <railbook/track/moving_load.hpp>
#include <railbook/track/wheel_on_track.hpp>

#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

// The rail's running surface with a joint; the rest of the scheme is drawn by its script.
void scheme(report::Item& item) {
  item.sketch("drawn after the paper's words; its drawing is not in the copy");
  auto& surface = item.data({"x", "y"});
  for (double x = 0.9; x <= 3.6; x += 0.05)
    surface.add(x, 4.5 - 0.3 * (1 - std::abs(std::sin(units::pi * (x - 2.25) / 2.9))));
}

constexpr std::array<WheelLoad, 4> trucks{{{0, typical_wheel_load},
                                           {70 * units::inch, typical_wheel_load},
                                           {15, typical_wheel_load},
                                           {15 + 70 * units::inch, typical_wheel_load}}};

// Deflection [m] below standing trucks, at a place of the track.
double static_deflection(double x) {
  const WinklerBeam beam = typical_beam();
  double sum = 0;
  for (const WheelLoad& wheel : trucks)
    sum += wheel.force / beam.point_stiffness() *
           winkler_shapes(beam.beta() * std::abs(x - wheel.x)).a;
  return sum;
}

void modulation(report::Item& item) {
  const auto track = two_layer(typical_impact().track);
  auto& data = item.data({"distance_m", "static_mm", "at_60mph_mm", "at_250mph_mm"});
  constexpr int count = 1600;
  const double first = -5, last = 27, step = (last - first) / count;
  std::array<std::vector<double>, 2> runs;
  for (std::size_t i = 0; i < 2; ++i) {
    const double speed = (i == 0 ? 60 : 250) * units::mph;
    runs[i] = trackside(track, typical_beam().beta(), speed, trucks, first / speed, step / speed,
                        count + 1);
  }
  for (int k = 0; k <= count; ++k) {
    const double x = first + k * step;
    data.add(x, 1e3 * static_deflection(x), 1e3 * runs[0][std::size_t(k)],
             1e3 * runs[1][std::size_t(k)]);
  }
  item.lost(
      "nothing in the copy says what Fig. 5 shows, and (11) to (14) are not in it: two trucks "
      "on the typical track");
}

// The slope of the peak in theta^2 as theta goes to zero, by Richardson from two small speeds.
double peak_growth(double mu) {
  const auto slope = [mu](double theta) {
    return (trackside_peak(theta, mu, 0).y - 1) / (theta * theta);
  };
  return (4 * slope(0.01) - slope(0.02)) / 3;
}

void trackside_peaks(report::Item& item) {
  item.rebuilt("follows from the reading of (10)-(14) above");
  item.columns({{"θ", "{:.4f}"},
                {"moving load on the beam", "{:.6f}"},
                {"lumped, μ = 3/4", "{:.6f}"},
                {"lumped, μ = 1/4", "{:.6f}"},
                {"beam, ζ = 0.2", "{:.6f}"},
                {"lumped, μ = 3/4, ζ = 0.2", "{:.6f}"}});
  for (const double theta : {100.0 / 1100, 160.0 / 1100, 250.0 / 1100, 0.5})
    item.add_row(theta, undamped_amplification(theta), trackside_peak(theta, 0.75, 0).y,
                 trackside_peak(theta, 0.25, 0).y, moving_load(theta, 0.2).maximum().y,
                 trackside_peak(theta, 0.75, 0.2).y);
  item.expect_checks(2);
  for (const double mu : {0.75, 0.25})
    item.agree(fmt::format("growth-{}", mu), fmt::format("growth of the peak, μ = {}", mu), "",
               peak_growth(mu), 2 * mu, 1e-4, "the expansion for low speed");
}

/***
## How much of the track moves

For a lumped model the track needs a mass beside its spring. The paper's is

$$M_r=\frac{3\rho}{2\beta}, \tag{15}$$

with the mass $\rho$ per length of rail, half the ties, and ballast. It has been "derived from the
first natural frequency of a beam", says the paper. An endless beam has no separate natural
frequencies; the lowest frequency at which waves travel along it is $\sqrt{K/\rho}$. The mass (15) follows from
Rayleigh's estimate of it, which assumes a shape and equates the largest kinetic and elastic
energies. Let $\omega_R$ be the estimate with the static shape $a$. Then $K_r/\omega_R^2=\rho\int
a^2dX=3\rho/2\beta$, since $\int a^2\,d(\beta X)=\frac32$ over the line. The estimate is an upper
bound: it is $\sqrt{4/3}$ of the frequency itself, {{too-high}} too high. So (15) is the mass that
has the beam's kinetic energy, and $2\rho/\beta$ would be the one that has its frequency.

{{masses}}

For impact the paper takes two masses, and {{fig-joint}} will show why. That of the rail alone is
(15) with the rail's mass $\rho_r$ per length and with $\beta_o$, which is made of the stiffness of
pads and ties only:

$$M_{rail}=\frac{3\rho_r}{2\beta_o}, \tag{16}$$

$$\beta_o=\left[\frac{k_{pad}k_{tie}}{l_t(k_{pad}+k_{tie})\,4EI}\right]^{1/4}. \tag{17}$$

::: {.fold summary="How much ballast moves with a tie: two rules of thumb"}

For the ballast that moves with a tie the paper has two rules of thumb. The first weighs a body of
stone below the tie,

$$\rho_b=\frac{d_b\,w\,A_t\,C_m}{N\,l_t\,g\tan\alpha}, \tag{18}$$

with the specific weight $d_b$ of the ballast, the tamped area $A_t$ of half a tie (where ballast is
packed below it), gravity $g$ and an empirical $C_m$ of one or slightly more. The integer $N$ cannot
be read in our copy: it would be 6 for a pyramid of depth $w/2\tan\alpha$, 4 for a wedge. The other
rule, also numbered (18), uses the speed $V_s$ of shear waves, $\rho_b=0.28\,k_bA_t/(l_tV_s^2)$;
$k_b$, the "effective" stiffness under half a tie, is read as $k_{bs}/2$. Half a tie of the weight
$W_{tie}$ and its ballast are

$$m_t=\frac3{2\beta}\left(\frac{W_{tie}}{2gl_t}+\rho_b\right). \tag{19}$$

The first rule with $N=4$ gives {{mass-spread}} more $m_t$ than the second, and nothing in the paper
says which is nearer. The function `ballast_mass_per_length` is the first rule.

{{code: track/effective_mass.cpp ballast_mass_per_length}}

:::

Damping is taken as viscous, $C_r=2\zeta\sqrt{K_rM_r}$. The paper quotes $\zeta$ of 0.15 to 0.25
from tests on clean ballast and 0.40 to 1.00 from the theory of waves that radiate into the ground.
This is a range of a factor of seven; {{fig-amplification}} shows what such a range does to the
deflection under a moving load.
*/
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

// The lowest frequency of a long free rail, from its longest standing wave: it comes down to sqrt(K
// / rho).
double longest_standing_wave(const WinklerBeam& beam, double rho) {
  const double wave = units::pi / (200 / beam.beta());
  return std::sqrt((beam.bending_stiffness * std::pow(wave, 4) + beam.foundation_modulus) / rho);
}

// Rayleigh's estimate of the first natural frequency [rad/s], with the static shape: what bends and
// presses over what moves.
double rayleigh_frequency(const WinklerBeam& beam, double rho) {
  const auto integral = [](double (*shape)(double)) {
    return 2 *
           num::integrate([&](double xi) { return std::pow(shape(xi), 2); }, 0, 40, 1e-12).value;
  };
  const double deflected = integral([](double xi) { return winkler_shapes(xi).a; });
  const double bent = integral([](double xi) { return 2 * winkler_shapes(xi).c; });  // a''
  const double bending = beam.bending_stiffness * std::pow(beam.beta(), 4) * bent;
  return std::sqrt((bending + beam.foundation_modulus * deflected) / (rho * deflected));
}

void masses_table(report::Item& item) {
  item.rebuilt("the paper gives the formulas; the data and N in (18) are assumed");
  const auto m = typical_masses();
  item.columns({"mass", "from", "value"});
  item.add_row("rail on the whole track",
               fmt::format("(15) with the rail alone: 132RE, {:.1f} lb/yd, assumed",
                           typical_rail().mass_per_length / (units::pound / units::yard)),
               both_units(m.rail_only));
  item.add_row("rail on its ties, M_rail for the blow", "(16), (17)", both_units(m.rail));
  item.add_row("rail and half a tie",
               "0.4 times (15) with rail and half a tie: British practice for impact, a footnote",
               both_units(m.british));
  item.add_row("tie and ballast, m_t for the blow",
               "(18), (19), N = 6: tie 200 lb, A_t = 270 in², 0.0579 lbf/in³, C_m = 1, all assumed",
               both_units(m.bed_pyramid));
  item.add_row("tie and ballast", "the same, N = 4", both_units(m.bed_wedge));
  item.add_row("tie and ballast", "second (18): shear waves at 1000 ft/s, assumed",
               both_units(m.bed_seismic));
  const auto beam = typical_beam();
  const double rho = typical_rail().mass_per_length;
  const double first = longest_standing_wave(beam, rho);
  const double estimate = rayleigh_frequency(beam, rho), too_high = estimate / first - 1;
  item.claims(
      {{"natural-frequency",
        {100 * too_high, beam.point_stiffness() / (estimate * estimate) / m.rail_only - 1}}});
  item.value("too-high", 100 * too_high, "%", "{:.1f}");
  item.value("mass-spread", 100 * (m.bed_wedge / m.bed_seismic - 1), "%", "{:.0f}");
}

}  // namespace

const report::Section lumped{report::figure("fig-04", scheme), report::figure("fig-05", modulation),
                             report::table("trackside-peak", trackside_peaks),
                             report::table("masses", masses_table)};

}  // namespace railbook::track_chapter
