// Wheel/rail force over a joint or any profile: wheel under constant load, Hertz contact, rail,
// bed.
//
//   m_w w'' = P0 - F,   F = C_H x_+^(3/2),   x = w - r - z(V t),
//   rail mass and bed mass as in RailOnBed (lumped.hpp), moving beneath the wheel (the paper's
//   "on-car" model).
// Displacements are measured from the static state under P0, positive down; time from x = 0, the
// joint. Reconstructed: the paper's own equations for this model, and all its results, are not in
// the text.
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include <railbook/num/dense_step.hpp>
#include <railbook/track/lumped.hpp>
#include <railbook/track/track_geometry.hpp>

namespace railbook::track {

struct ImpactModel {
  double wheel_mass = 0;      // unsprung mass on one rail [kg]
  double static_load = 0;     // P0 [N], constant
  double hertz_constant = 0;  // C_H [N / m^(3/2)]
  RailOnBed track;
};
// Throws InputError unless all masses, stiffnesses and the load are positive.
void require_valid(const ImpactModel& model);

// To rounding, for a valid model.
double static_approach(const ImpactModel& model);    // [m], under P0
double contact_stiffness(const ImpactModel& model);  // dF/dx under P0 [N/m]
// Undamped natural frequencies [Hz], ascending, the contact linearized under P0. Their squares to
// rounding of the largest. Throws InputError as require_valid does.
Eigen::Vector3d natural_frequencies(const ImpactModel& model);

using ImpactState = Eigen::Matrix<double, 6, 1>;  // w, w', r, r', b, b': wheel, rail, bed

struct ImpactOptions {
  double tolerance = 1e-8;  // local error over the static approach and its speed scale
  // Distance of the first instant [m]: the wheel starts in static equilibrium, moving along the
  // slope there.
  double start = 0;
  double end_time = 0.06;        // [s] after the joint
  bool restart_at_cusps = true;  // end a step on each joint and begin anew; false steps across
  // End a step where contact is lost or regained and begin anew; false looks for no such place and
  // records no losses.
  bool locate_losses = true;
  long most_steps = 400000;  // each kept, about 300 bytes
  // Radau IIA instead of the explicit pair: for stiff data (a rail of grams, hard dampers), whose
  // fast motions it damps out where the tolerance does not see them.
  bool implicit = false;
};

enum class ImpactStatus { complete, step_limit, step_underflow };
std::string_view to_string(ImpactStatus status);

struct ContactLoss {
  double from = 0, to = 0;  // [s]; `to` is the end of the history when contact was not regained
};

struct ImpactHistory {
  ImpactModel model;
  Surface surface;
  double speed = 0;
  std::vector<num::DenseStep<6>> steps;
  std::vector<ContactLoss> losses;
  ImpactStatus status = ImpactStatus::complete;
  long evaluations = 0;
  long rejections = 0;
  double begin() const { return steps.front().begin; }
  double end() const { return steps.back().end; }
  ImpactState state(double t) const;  // dense output, t within [begin, end]
  double force(double t) const;       // wheel/rail force [N]
};

// Where a passage may start: a quarter rail before the joint, or the first sample of a measured
// profile.
double default_start(const Surface& surface);

// Throws InputError when the run is impossible: bad values, or a measured profile that does not
// cover it.
void require_valid(const ImpactOptions& options, const Surface& surface, double speed);

// Runs the wheel over the surface at `speed` [m/s]. Order 5 with error control, explicit or
// implicit; contact lost and regained are located on the dense output; at a tolerance of 1e-8
// forces are good to 1e-5 of the load. Anything but status `complete` is a history that stopped
// early. Throws InputError as require_valid does.
[[nodiscard]] ImpactHistory simulate(const ImpactModel& model, const Surface& surface, double speed,
                                     const ImpactOptions& options);

}  // namespace railbook::track
