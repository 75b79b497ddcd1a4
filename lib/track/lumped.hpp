// The lumped track: a few masses under the wheel or under a fixed point beside the track
// ("trackside").
//
// Equation (10), Y(s) = P(s) / (K_r + C_r s + M_r s^2), is all that is legible of the paper's
// trackside model; (11)-(14) are not. Reconstructed from its wording: the force on the rail mass is
//   P(t) = sum_i P_i(t) a(beta (V t - x_i)),  a(x) = exp(-|x|) (cos x + sin |x|),
// each wheel's load modulated by the beam's deflection function (1), and for the two-layer track
// the rail mass rests on the bed mass. Responses are exact in time: matrix exponentials, no
// integrator.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include <railbook/track/beam_on_foundation.hpp>

namespace railbook::track {

// x' = rates x + input P with the force P on the rail; x[0] is the rail's deflection [m], x[1] its
// velocity.
struct LumpedTrack {
  Eigen::MatrixXd rates;
  Eigen::VectorXd input;
};

// One mass M [kg] on stiffness K [N/m] and damper C [N s/m]: equation (10). Throws InputError
// unless C >= 0 and the others > 0.
LumpedTrack single_mass(double stiffness, double damping, double mass);

// The reconstructed rail on its tie and the bed below, for one rail; states rail, bed (each y, v).
struct RailOnBed {
  double rail_mass = 0;       // M_rail of (16) [kg]
  double rail_stiffness = 0;  // rail to bed, K_1 [N/m]
  double rail_damping = 0;    // [N s/m]
  double bed_mass = 0;        // m_t of (19) [kg]
  double bed_stiffness = 0;   // bed to ground, K_g [N/m]
  double bed_damping = 0;     // [N s/m]
};
// Throws InputError unless masses and stiffnesses are positive and dampings not negative.
void require_valid(const RailOnBed& track);
LumpedTrack two_layer(const RailOnBed& track);

// A unit load that passes the point at t = 0 at `speed` [m/s] over a beam of rigidity factor beta
// [1/m].
class Passage {
 public:
  // Throws InputError unless beta > 0 and speed > 0.
  Passage(LumpedTrack track, double beta, double speed);
  // All states at time t [s], from rest at minus infinity; exact to rounding times 1 + |t| of the
  // track's fastest motion.
  Eigen::VectorXd state(double t) const;
  const LumpedTrack& track() const { return track_; }

 private:
  friend std::vector<double> add_passage(const Passage&, double, double, int);
  LumpedTrack track_;
  double rate_ = 0;          // beta V [1/s]
  Eigen::VectorXcd coming_;  // amplitude of exp((1 + i) beta V t) before the load arrives
  Eigen::MatrixXd leaving_;  // track and the decaying modulation as one autonomous system, balanced
  Eigen::VectorXd scale_;    // its states times this are the motion
  Eigen::VectorXd overhead_;  // its state at t = 0
};

// Rail deflection [m] at t = start + k step, k < count, under a train of wheels at constant loads;
// as exact as Passage. count from 1 to 1e8. Throws InputError naming what is wrong.
std::vector<double> trackside(const LumpedTrack& track, double beta, double speed,
                              std::span<const WheelLoad> wheels, double start, double step,
                              int count);

struct TracksidePeak {
  double y = 0;    // units of the static deflection
  double tau = 0;  // beta V t at the peak; 0 when the load is overhead
};
// Largest response of the single mass to one constant load: mu theta^2 y'' + 2 zeta theta sqrt(mu)
// y' + y = a(tau), mu = M beta^2 V_c^2 / K_r (3/4 with the mass of (15)). theta > 0, mu > 0, zeta
// >= 0, theta sqrt(mu) up to 1e4; relative error below 1e-6. Throws InputError outside.
TracksidePeak trackside_peak(double theta, double mu, double zeta);

}  // namespace railbook::track
