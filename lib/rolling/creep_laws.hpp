// The fast theories of rolling contact: from the creepages to the forces in microseconds, by
// formulas.
//
//   const RollingCase c{.a = 1.5e-3, .b = 1e-3, .load = 4450, .shear_modulus = 79.6e9, .poisson =
//   0.3,
//                       .friction = 0.3, .creepage = {.longitudinal = 0.002}};
//   const CreepForces f = creep_forces(Theory::fastsim, c);                    // Kalker's table
//   const CreepForces g = creep_forces(Theory::fastsim, c, computed_coefficients);
//
// All answer in the frame and with the result type of case.hpp; none estimates its own
// error.
#pragma once

#include <string_view>

#include <railbook/rolling/case.hpp>
#include <railbook/rolling/kalker_table.hpp>

namespace railbook::rolling {

enum class Theory { linear, vermeulen_johnson, shen_hedrick_elkins, fastsim, fastrip, polach };

// Each states the range it is good for, outside of which `warning` of its answer says so. Spin is
// measured by its reduced value Z = G (a b)^(3/2) phi/(mu N), and deviations are the largest from
// the full theory for 0.15 <= a/b <= 7 and reduced creepages up to 1.

// Kalker's linear theory: no slip anywhere, so no bound on the forces; friction is used for the
// range only: force up to mu N/3 and moment up to a third of moment_bound(), where slip takes some
// 11 % off.
CreepForces linear_theory(const RollingCase& c, const KalkerCoefficients& k);

// Vermeulen and Johnson's own slopes of the linear part, pi/phi and pi/psi of their paper (1964),
// which stand for C11 and C22: 17 to 23 % above Kalker's for ordinary ellipses. Circle: 16/(4 - 3
// nu) and 16/(4 - nu).
struct Slopes {
  double longitudinal = 0;
  double lateral = 0;
};
Slopes vermeulen_johnson_slopes(double axis_ratio, double poisson);

// F = mu N [1 - (1 - t/3)^3], t the linear force by their slopes over mu N, up to t = 3. For no
// spin: it is left out, and mz is 0. Relative accuracy 1e-14. The stick area is an ellipse (1 -
// t/3)^2 times the contact.
CreepForces vermeulen_johnson(const RollingCase& c, const Slopes& slopes);

// The largest moment that friction can bear beside a force of |F|: mu N sqrt((a^2 + b^2)/5) sqrt(1
// - (F/mu N)^2), by Its square is good to 2e-15 of that without a force. By Cauchy and Schwarz from
// |p| <= mu p_Hertz, whose mean square distance from the centre is (a^2 + b^2)/5.
double moment_bound(const RollingCase& c, double force);

// Shen, Hedrick and Elkins (1983): the same curve with Kalker's linear force, spin included, in its
// direction. mz is the linear moment reduced by the same factor, and held within moment_bound().
// For small spin only, since it saturates where the truth falls off again: |Z| <= 0.2 and C23 |Z|
// <= 0.6, where the force deviates by up to 0.2 mu N; outside by as much as mu N.
CreepForces shen_hedrick_elkins(const RollingCase& c, const KalkerCoefficients& k);

// Polach (1999). Without spin it is FASTSIM's closed form for an elliptic traction bound, with one
// flexibility weighted from C11 and C22; with spin an empirical lateral force is added, and the sum
// is held within mu N. No mz (0). For |Z| <= 0.2 and C23 |Z| <= 0.4, where the force deviates by up
// to 0.25 mu N; outside by up to 0.8 mu N.
CreepForces polach(const RollingCase& c, const KalkerCoefficients& k);

// One of the theories above, or of fastsim.hpp and strip_theory.hpp with their defaults. Without
// coefficients those of Kalker's table (0.1 <= a/b <= 10); Vermeulen-Johnson uses its own slopes
// either way. Throws InputError on a case out of range, and for spin with the strip theory.
CreepForces creep_forces(Theory theory, const RollingCase& c);
CreepForces creep_forces(Theory theory, const RollingCase& c, const KalkerCoefficients& k);

// "fastsim", "shen-hedrick-elkins", ...
std::string_view name(Theory theory);

}  // namespace railbook::rolling
