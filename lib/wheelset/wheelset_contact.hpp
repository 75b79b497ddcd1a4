// Where a rigid wheelset touches two rigid rails, in the plane across the track.
//
//   const WheelsetOnTrack pair(wheel, rail);
//   const auto at = pair.contact(0.3 * units::inch);           // at.roll, at.left.radius,
//   at.left.delta, ...
//
// Wheelset and vehicle count to the left and up, as the paper of chapter 02 does: the frame of
// rolling and wheel_contact (forward, right, down) turned half round about the direction of travel.
// Displacement and yaw change their signs from one to the other, roll does not.
//
// The wheelset is moved sideways by x (> 0 to the left) and rolls by phi (> 0: left side up) until
// the least vertical gap between wheel and rail is the same on both sides. The least gap of two
// chains of arcs is found exactly: where their pieces overlap, the gap of two arcs is stationary at
// one place that has a closed form, and else it is least at the end of a piece. There is no grid.
// One evaluation costs one pass over the pieces of both chains.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <railbook/profiles/curve.hpp>

namespace railbook::wheelset {

// Of one side, as seen from the track's centre outwards (the right side is a mirror image).
struct SideContact {
  double radius = 0;         // of the wheel at the point of contact [m]
  double delta = 0;          // angle of the contact plane to the axle [rad]
  profiles::Point on_wheel;  // in the axle's frame, of the unrolled wheelset: z = -radius
  profiles::Point on_rail;   // in the track's frame
  bool at_end = false;       // the contact is at an end of the data: more of the profile is needed
};

struct WheelsetContact {
  double x = 0;
  double roll = 0;    // phi_w [rad], > 0 left side up
  double height = 0;  // of the axle's centre over the rails' tops [m]
  SideContact left, right;
  bool converged = false;  // false: no roll within the limit closes both gaps
};

class WheelsetOnTrack {
 public:
  // `wheel` in the axle's frame: u = 0 is the middle of the axle, z = 0 its axis; all u < 0 and z <
  // 0. `rail` in the track's frame: u = 0 is the track's centre, z = 0 its plane. Both for the left
  // side, u towards the centre. Throws InputError when they do not overlap sideways at x = 0, or an
  // angle of the wheel is over 84 degrees.
  WheelsetOnTrack(profiles::Curve wheel, profiles::Curve rail);
  // The left sides of two such pairs, the second on the right.
  WheelsetOnTrack(const WheelsetOnTrack& left, const WheelsetOnTrack& right);
  bool symmetric() const { return symmetric_; }

  // Contact at displacement x [m]; NaN and infinite x throw InputError. `guess` of the roll only
  // saves time. Accurate to rounding (some 1e-15 m of gap). Not converged when the profiles do not
  // overlap any more or the roll needed is over 0.1 rad.
  WheelsetContact contact(double x, double guess = 0) const;

  // The same with the axle kept level, as EN 15302 does for the equivalent conicity: each side
  // touches where its own gap is least, and the two gaps differ. Not converged when the profiles do
  // not overlap any more.
  WheelsetContact level_contact(double x) const;

  // Of the left side.
  const profiles::Curve& wheel() const { return wheel_; }
  const profiles::Curve& rail() const { return rail_; }

 private:
  // A piece made ready for the search: a line has radius 0.
  struct Part {
    double u0, z0, u1, z1;      // its ends
    double slope, sine;         // line: dz/du, and the sine of its angle
    double radius, uc, zc, rr;  // arc: radius, centre, radius^2
  };
  struct Least {
    double gap = std::numeric_limits<double>::infinity();
    double sine = 0;  // of the angle of the common tangent in the track's frame
    profiles::Point on_rail;
    bool at_end = false, found = false;
  };
  static Part part_of(const profiles::Piece& piece);
  static void pose(const Part& part, double x, double s, double c, Part& out);
  static void pose_all(const std::vector<Part>& parts, double x, double phi,
                       std::vector<Part>& out);
  static double height(const Part& part, double u);
  static double sine(const Part& part, double u);
  static std::optional<double> parallel(const Part& w, const Part& r);
  static SideContact side(const Least& least, double x, double phi);
  struct Side {
    std::vector<Part> wheel, rail;
  };
  static Least least_gap(const Side& side, double x, double phi, std::vector<Part>& posed);

  profiles::Curve wheel_, rail_;
  Side left_, right_;
  bool symmetric_ = true;
};

// Puts profiles in their places. `wheel` of a wheelset whose profile origin is `from_centre` [m]
// from the axle's middle.
profiles::Curve placed_wheel(const profiles::Curve& wheel, double from_centre);
// `rail` leaning towards the centre by `cant` [rad] (1:40 is 0.025), its top at z = 0, its gauge
// face half a `gauge` [m] from the centre: its innermost point down to `gauge_depth` [m] below the
// top. That is the profile's end where the face leans back under it, and was measured down to
// `depth_below_end` [m]. Throws InputError when the profile was not measured so deep on that side.
profiles::Curve placed_rail(const profiles::Curve& rail, double gauge, double gauge_depth,
                            double cant, double depth_below_end = 0);
// The pair with the wheel raised so that its radius at the centred contact is `radius` [m]. Throws
// InputError when the wheelset does not fit between the rails: the centred contact is at an end of
// the data or on a flange (over 45 degrees, or beyond its steepest place).
WheelsetOnTrack with_radius(const profiles::Curve& wheel, const profiles::Curve& rail,
                            double radius);

// A displacement at which one wheel has two points of contact: below it the one, above it the
// other.
struct ContactJump {
  double x =
      0;  // of the wheelset where its left wheel jumps [m], to 1e-12 m; the right one does at -x
  SideContact before, after;
};

// All jumps of the left wheel's contact by more than `smallest` [m] along the wheel, low < x <
// high. Halves every interval over which the contact point moves by more than that.
std::vector<ContactJump> contact_jumps(const WheelsetOnTrack& pair, double low, double high,
                                       double smallest);

}  // namespace railbook::wheelset
