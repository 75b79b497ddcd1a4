// Lumped masses and damping of the track, per rail.
//
// All are products and roots, to rounding; a value that is not positive (tie and ballast masses and
// zeta: negative) or not finite is refused by an InputError that names it. Source: Ahlbeck, Meacham
// & Prause, eqs (15)-(19) and the text on damping.
#pragma once

#include <railbook/track/beam_on_foundation.hpp>
#include <railbook/track/stiffness_chain.hpp>

namespace railbook::track {

// M_r = 3 rho / 2 beta, eqs (15), (16), (19), kg. rho is mass per length (kg/m) of one rail's
// share.
//
// The paper has it "from the first natural frequency": it is K_r over the square of Rayleigh's
// estimate with the static shape, and the mass whose kinetic energy equals the beam's when that
// shape moves (the integral of a^2 over the line is 3 / 2 beta). The estimate, sqrt(K_r / M_r), is
// sqrt(4/3) times the beam's lowest frequency sqrt(K / rho).
double effective_mass(double mass_per_length, double beta);

// The mass that does give the lowest (cut-on) frequency: K_r rho / K = 2 rho / beta, kg.
double cut_on_mass(double mass_per_length, double beta);

// Lowest natural frequency of the beam on its foundation, sqrt(K / rho), rad/s.
double cut_on_frequency(const WinklerBeam& beam, double mass_per_length);

// beta_o of eq. (17), 1/m: the rail on its pads and ties alone. Throws InputError when both are
// rigid: the rail then has no foundation of its own, and its effective mass, eq. (16), goes to
// zero.
double rail_beta(double bending_stiffness, const TieSupport& support);

// Ballast that moves with a tie, by eq. (18): a body of the tie's width with sides at the friction
// angle.
struct BallastMass {
  double density;         // d_b / g, kg/m^3
  double tamped_area;     // A_t, of half a tie, m^2
  double cohesion = 1.0;  // C_m, one or slightly more
  double divisor =
      6.0;  // N, unreadable in print: 6 is a pyramid of depth w / 2 tan(alpha), 4 a wedge
};

// rho_b = d_b w A_t C_m / (N l_t g tan(alpha)), eq. (18), kg/m. Friction angle above zero.
double ballast_mass_per_length(const BallastMass& ballast, const TieSupport& support);

// rho_b = 0.28 k_b A_t / (l_t V^2), the second eq. (18): from the shear-wave speed V (m/s) and the
// stiffness of ballast and subgrade under half a tie (N/m), which we read as the halved bed of eq.
// (4), k_bs / 2. l_t is not in print; the units need it. kg/m.
double seismic_mass_per_length(double bed_stiffness, double tamped_area, double tie_spacing,
                               double wave_speed);

// m_t = (3 / 2 beta)(W_tie / 2 g l_t + rho_b), eq. (19), kg: half a tie and its ballast.
double tie_and_ballast_mass(double tie_mass, double tie_spacing, double ballast_per_length,
                            double beta);

// Viscous damping C = 2 zeta sqrt(K M), N s/m. The paper quotes zeta of 0.15 to 0.25 from tests on
// clean ballast, and 0.40 to 1.00 from the theory of the half-space (radiation).
double viscous_damping(double zeta, double stiffness, double mass);

}  // namespace railbook::track
