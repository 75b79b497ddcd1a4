// From rail, tie and wheel data to the lumped model of impact: the two-layer split of the track's
// stiffness and mass, and the Hertz constant.
#pragma once

#include <railbook/track/impact.hpp>
#include <railbook/track/typical_track.hpp>

namespace railbook::track {

// Hertz: F = C_H delta^(3/2) for a wheel of rolling radius R with a straight tread on a rail of
// crown radius r, both of the same elastic material. Lengths [m], Young's modulus [Pa].
struct WheelOnRail {
  double wheel_radius = 18 * units::inch;
  double crown_radius = 10 * units::inch;
  double youngs_modulus = 30e6 * units::psi;
  double poisson_ratio = 0.3;
};
// C_H [N/m^(3/2)], by elliptic integrals, to 1e-14 at any ratio of the radii; independent of the
// load. Throws InputError on non-positive lengths or modulus, or a Poisson ratio outside [0, 0.5].
double hertz_constant(const WheelOnRail& pair);

// Damping ratios of the two layers, C = 2 zeta sqrt(K M) each.
struct LayerDamping {
  double rail = 0.05;  // rail on tie: steel and wood, our assumption
  double bed = 0.2;    // ballast: the middle of the paper's 0.15 to 0.25
};

// The track below the wheel as rail on bed (reconstructed; the paper describes the split in words):
// rail mass by (16), (17), bed mass by (18), (19), rail-to-tie stiffness K_1 = 2 (4 EI
// (k_pt/l_t)^3)^(1/4) of the rail on its pads and ties alone, and K_g = 1 / (1/K_r - 1/K_1), which
// keeps the static stiffness K_r of (2). To rounding, however stiff the bed. Throws InputError
// where its parts do; rigid pads and ties, or a rigid bed, have no such split.
RailOnBed rail_on_bed(const RailSection& rail, const TieSupport& support,
                      const BallastMass& ballast, double tie_mass,
                      const LayerDamping& damping = {});

// Half a wheelset on the typical track; every value is an assumption of ours.
inline constexpr double typical_wheel_mass = 650.0;  // unsprung, one rail [kg]
ImpactModel typical_impact();

}  // namespace railbook::track
