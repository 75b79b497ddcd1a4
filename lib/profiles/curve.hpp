// A profile of wheel or rail in its plane: a chain of circular arcs and straight lines.
//
//   const Curve tread = chain({0, 0}, 0.05, {line(3 * units::inch), arc(0.6875 * units::inch, 70 *
//   units::degree)});
//
// Coordinates: u towards the track's centre, z up [m]. The angle at a point is its fall per length,
// dz/du = -tan(angle), so a 1:20 cone has +0.05 and a flange 1.2. A positive radius is a piece
// whose angle grows with u (the throat of a wheel, the head of a rail), a negative one the other
// kind (the tip of a flange). u grows along the whole chain.
#pragma once

#include <limits>
#include <vector>

namespace railbook::profiles {

struct Point {
  double u = 0, z = 0;
};

// One piece. An arc has the centre (u_c, z_c) with u = u_c + radius sin(angle), z = z_c + radius
// cos(angle).
struct Piece {
  Point start, end;
  double angle_start = 0, angle_end = 0;  // equal for a line
  double radius = std::numeric_limits<double>::infinity();
  Point centre;  // of an arc

  bool is_line() const { return radius == std::numeric_limits<double>::infinity(); }
};

class Curve {
 public:
  // Throws InputError when there is no piece, a coordinate is not finite, pieces do not join to
  // 1e-9 m, u does not grow, or an angle is not below 90 degrees in size. Angles may step between
  // pieces (a corner).
  explicit Curve(std::vector<Piece> pieces);

  const std::vector<Piece>& pieces() const { return pieces_; }
  Point start() const { return pieces_.front().start; }
  Point end() const { return pieces_.back().end; }

  // Height and angle [rad] at u, which must lie on the curve (InputError otherwise); to rounding
  // over the cosine of the angle.
  double height(double u) const;
  double angle(double u) const;
  // The first point whose angle is `angle`; throws InputError when there is none.
  Point point_at_angle(double angle) const;

 private:
  const Piece& piece(double u) const;
  std::vector<Piece> pieces_;
};

// The steps of a chain: a straight line of a length [m], or an arc of a radius [m] to an angle
// [rad].
struct Step {
  double radius = 0, length = 0, to_angle = 0;
};
Step line(double length);
Step arc(double radius, double to_angle);

// Steps joined without corners, from a point and angle on; joints to 1e-14 of the lengths and
// radii. Throws InputError for a length or radius that is zero or not finite, an arc whose angle
// goes the other way than its radius says, or a size of an angle of 90 degrees.
Curve chain(Point start, double angle, const std::vector<Step>& steps);

// The curve moved; turned about the origin so that every angle grows by `angle` [rad].
Curve moved(const Curve& curve, double du, double dz);
Curve turned(const Curve& curve, double angle);

}  // namespace railbook::profiles
