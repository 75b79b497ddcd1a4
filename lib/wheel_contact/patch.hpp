// Areas of contact of a wheel pressed into its rail: each with its own frame, and the gap in that
// frame.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <railbook/contact/grid.hpp>
#include <railbook/wheel_contact/find_contact.hpp>

namespace railbook::wheel_contact {

struct PatchOptions {
  // Areas of overlap nearer than this to one another [m] and turned by less than this [rad] are one
  // patch of one frame, in which each presses on the other; other areas are half-spaces of their
  // own.
  double merge_distance = 4e-3;
  double merge_angle = 0.35;
};

// A patch's frame: x forward, t across (outwards), n into the rail. Their origin is the mean of the
// overlap, weighted by the 5/2 power of its depth, on the rail; the angle is the rail's, averaged
// alike. n = (0, -sin, cos), t = (0, cos, sin).
struct Frame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // in the track's axes [m]
  double angle = 0;
  Eigen::Vector3d across() const { return {0, std::cos(angle), std::sin(angle)}; }
  Eigen::Vector3d normal() const { return {0, -std::sin(angle), std::cos(angle)}; }
};

// One place on the line along which the wheel is deepest in the rail, in the frame.
struct Depth {
  double t = 0;        // across [m]
  double x = 0;        // along [m]
  double overlap = 0;  // along n [m]; negative: apart
};

struct Patch {
  Frame frame;
  std::vector<Depth>
      line;  // from t_low to t_high in equal steps, a little beyond the overlap at both ends
  contact::Box overlap;  // what holds all places of overlap, in the frame's x and t (as y) [m]
  double radius = 0;     // of the wheel in the plane of rolling along n [m]: r/cos(angle)
  double turn = 0;       // by which the rail's angle changes over the overlap [rad]
  bool merged = false;   // of areas that are apart
  bool at_end = false;   // the overlap comes within 0.5 mm of an end of a profile
};

// The patches of a wheel at depth z, none when it does not touch; those with the deeper overlap
// first.
std::vector<Patch> patches(const PlacedWheel& wheel, const ContactSearch& touching, double z,
                           const PatchOptions& options = {});

// By how much wheel and rail overlap along n over the point (x, t) of the frame's plane, the wheel
// at depth z: both surfaces are met exactly, the wheel as one of revolution. -infinity where either
// has no surface.
double overlap(const PlacedWheel& wheel, const Frame& frame, double z, double x, double t);
// At the cells of a grid (x along, y across).
Eigen::VectorXd overlap(const PlacedWheel& wheel, const Frame& frame, double z,
                        const contact::Grid& grid);

}  // namespace railbook::wheel_contact
