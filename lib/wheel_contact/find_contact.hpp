// Where a rigid wheel touches a rigid rail in space, and what lies between them where they would
// overlap.
//
// Everything is stated for the right wheel: x forward, y outwards (right), z down, track origin in
// the middle of the track in the plane of the rails' tops. A left wheel is its mirror image: y, yaw
// and roll change their signs, as do forces across and moments about x and z.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include <railbook/profiles/depth_profile.hpp>

namespace railbook::wheel_contact {

// A wheel and its rail [m]: s = 0 of the wheel is `half_spacing` from the middle of the axle and
// has depth 0 and the radius `radius`; the rail stands in its place on the track.
struct ProfilePair {
  profiles::Profile wheel, rail;
  double radius = 0.460, half_spacing = 0.750;
};

// The right pair of S1002 on 60E1 with a cant (1/40), gauge 1435 mm at 14 mm below the top, running
// circles 1500 mm apart, radius 460 mm.
ProfilePair s1002_on_60e1(double cant, profiles::Rail60 kind = profiles::Rail60::drawing);

// Of the wheelset [m, rad]: sideways, yaw (front to the right) and roll (right wheel lower), each >
// 0.
struct Pose {
  double y = 0, yaw = 0, roll = 0;
  bool operator==(const Pose&) const = default;
};
Pose mirrored(const Pose& pose);

// One wheel in a pose, its axle's middle at the depth -radius + z; its directions are the columns
// of `turn`.
struct PlacedWheel {
  const ProfilePair* pair = nullptr;
  Pose pose;
  Eigen::Matrix3d turn;
  PlacedWheel(const ProfilePair& pair, const Pose& pose);

  // The point of the wheel at s that comes nearest to a rail along the track: there the wheel's
  // normal has no part along x, which is one equation A cos + B sin = 0 for the angle round the
  // axle.
  struct Point {
    double s = 0;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  // at z = 0
    double gap = 0;    // of the rail below it [m], infinity beside the rail
    double angle = 0;  // of the rail there: atan(d depth/dy)
    double radius = 0;
  };
  Point point(double s) const;
};

// Points of the wheel where the gap is least among its neighbours, the least of all first. Places
// to some 1e-7 m. Throws InputError when the wheel is nowhere above its rail.
struct ContactSearch {
  std::vector<PlacedWheel::Point> least;
  std::vector<PlacedWheel::Point> locus;          // every 0.1 mm across the wheel
  double z() const { return least.front().gap; }  // at which it first touches
};
ContactSearch find_contact(const PlacedWheel& wheel);

// The largest angle [rad] of the flange's face to the axle, sampled every 0.1 mm across; 0 of a
// wheel without a flange.
double flange_angle(const profiles::Profile& wheel);
// Where that is, s [m].
double flange_place(const profiles::Profile& wheel);
// Nadal's limit of Y/Q of a flange with this angle [rad]: (tan angle - mu)/(1 + mu tan angle).
double nadal_limit(double angle, double friction);

// Throws InputError when the wheelset does not fit between the rails: centred, it stands on its
// flanges, beyond their steepest place or at an angle of more than 45 degrees.
void require_fit(const ProfilePair& pair);

// Whether a point is within 0.5 mm of an end of either profile: more of it would be needed.
bool at_end(const ProfilePair& pair, const PlacedWheel::Point& point);

// The roll [rad] at which both wheels of a rigid wheelset touch at the same height, near 0, to
// 1e-12. Throws InputError when none within 0.05 rad does.
double rigid_roll(const ProfilePair& pair, double y, double yaw);
// The same with another wheel or rail on the left, as seen in the mirror.
double rigid_roll(const ProfilePair& left, const ProfilePair& right, double y, double yaw);

}  // namespace railbook::wheel_contact
