// One wheel on its rail under a vertical load: patches, pressures, creepages and forces.
//
//   const Pair pair = s1002_on_60e1(1.0 / 40);
//   const WheelResult right = solve_wheel(pair, {.y = 3e-3}, {.load = 80e3, .speed = 30,
//                                                          .angular_velocity = 30 / 0.46});
//
// For the right wheel; a left one is solved in its mirrored() pose, and its forces across and
// moments about x and z change their signs.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <railbook/contact/material.hpp>
#include <railbook/rolling/case.hpp>
#include <railbook/units/warning.hpp>
#include <railbook/wheel_contact/patch.hpp>
#include <railbook/wheel_contact/strips.hpp>

namespace railbook::wheel_contact {

// mu(v) = mu0 (a + (1 - a) exp(-v/v0)), the law of Ohyama and Polach. v is the mean rigid slip
// speed of the patch, not the slip of each particle: with that a rolling contact has several
// solutions, with this one. a = 1: constant. On a flange mu0 may be another: up to a contact angle
// of 20 degrees it is the tread's, from 40 degrees on the flange's, and linear in the angle
// between.
struct Friction {
  double coefficient = 0.3;           // mu0, 0 to 2
  double high_speed_share = 1;        // a: the fraction left at high speed, 0 to 1
  double speed = 1;                   // v0 [m/s], > 0
  std::optional<double> flange = {};  // mu0 of the flange, 0 to 2; none: as on the tread
  // `angle` [rad] grows towards the flange.
  double at(double slip_speed, double angle = 0) const;
  double largest() const { return std::max(coefficient, flange.value_or(0)); }
};

enum class Method {
  hertz,   // an ellipse, and FASTSIM on it
  strips,  // semi-Hertzian strips, and FASTSIM on them
  full     // the half-space's own pressure, and Kalker's full theory on it
};

struct WheelInput {
  double load = 0;              // vertical, of the wheel on the rail [N], > 0
  double speed = 0;             // of the wheelset along the track [m/s], > 0
  double angular_velocity = 0;  // of the wheelset about its axle [rad/s], > 0 forwards
  Friction friction = {};
  contact::Material wheel = contact::default_steel, rail = contact::default_steel;
  Method method = Method::full;
  PatchOptions patches = {};
  long along = 40, across = 32;  // cells of the finer of two grids, of Method::full; 8 to 512
};

struct PatchResult {
  Patch patch;
  double load = 0;              // normal [N]
  double approach = 0;          // greatest overlap [m]
  double p_max = 0;             // [Pa]
  double area = 0;              // [m^2]
  rolling::CreepForces forces;  // on the rail, in the frame: fx along, fy across, mz about n
  rolling::Creepage creepage;   // wheel over rail, in the frame at its origin
  double friction = 0;
  double largest_shear = 0;  // traction [Pa]
  double wear_number = 0;    // T gamma: power of friction over speed [N]
  // Of p_max, as a share: the change from a grid of half the cells along and across, and what cells
  // of this size leave at least; infinite for the approximate methods. forces.error is the like of
  // (fx, fy) over mu N. Not yet counted on fresh contacts.
  double p_max_error = std::numeric_limits<double>::infinity();
  contact::Grid grid;        // of Method::full ...
  Eigen::VectorXd pressure;  // ... and the pressure [Pa]
  Strips strips;             // of the other methods
};

struct WheelResult {
  double z = 0;  // depth of the axle's middle below its height at the running circles on the rails'
                 // top [m]
  double z_touch = 0;                               // at first touch
  std::vector<PatchResult> patches;                 // the one that carries most first
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // on the rail, in the track's axes [N]
  double axle_moment =
      0;  // of the forces on the wheel about the axle [N m]; > 0 speeds a forward turn down
  bool converged = false;
  std::string reason;  // why not
  // Where no depth up to 2 mm bears the load: what that depth bears without friction [N].
  double bearable = std::numeric_limits<double>::infinity();
  std::vector<units::Warning> warnings;  // verge of a second contact, conformal, coarse ...
};

// Load to 1e-5 (full: with the share that friction bears to 1e-3). Throws InputError naming what is
// out of range, when the wheel touches within 0.5 mm of an end of a profile, or when the load needs
// more than 2 mm of depth; not converged when friction holds the wheel up. Accuracy of the full
// method, against CONTACT in the benchmark: see tests/lib/wheel_contact/benchmark.cpp.
WheelResult solve_wheel(const ProfilePair& pair, const Pose& pose, const WheelInput& input);

struct WheelsetResult {
  Pose pose;
  double angular_velocity = 0;
  WheelResult left, right;  // the left as seen in the mirror
  bool converged = false;
  std::string reason;
};

// A wheelset with the same load on both wheels, free to roll and to turn: its roll has both wheels
// at one height, and its angular velocity lets the moments about the axle cancel. Of the input,
// `angular_velocity` is not used; of the pose, roll is not. Throws as solve_wheel, and when no roll
// near the rigid wheelset's does. Some twenty solutions of both wheels by an approximate method,
// and some hundred where the roll depends on friction as on a flange; by the full theory some six,
// one by itself, and two or three on its planes and cells.
WheelsetResult solve_wheelset(const ProfilePair& pair, const Pose& pose, const WheelInput& input);
// The same with another wheel or rail on the left, as seen in the mirror.
WheelsetResult solve_wheelset(const ProfilePair& left, const ProfilePair& right, const Pose& pose,
                              const WheelInput& input);

}  // namespace railbook::wheel_contact
