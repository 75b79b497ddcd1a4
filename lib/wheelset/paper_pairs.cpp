#include <railbook/wheelset/paper_pairs.hpp>

#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/wheelset/tabulate.hpp>

namespace railbook::wheelset {
namespace {

constexpr double inch = units::inch;
constexpr double flange_angle = 70 * units::degree;
constexpr double face_angle = units::pi / 2 - 0.055;  // of a rail's gauge face, before it leans
constexpr double field_angle = -0.45;                 // where a rail's profile begins
constexpr double throat_begins = 1.36 * inch;  // of the new wheel, from the rail's head centre
constexpr double cn_matches = 0.045, heumann_matches = 0.125;  // angle at the centred contact [rad]

// The chain of rail steps from `field_angle` on, with angle 0 at u = 0.
profiles::Curve upright(const std::vector<profiles::Step>& steps) {
  const profiles::Curve curve = profiles::chain({0, 0}, field_angle, steps);
  const profiles::Point top = curve.point_at_angle(0);
  return profiles::moved(curve, -top.u, -top.z);
}

// Tread, then a flange face 0.35 in long and a tip of 0.55 in, convex.
profiles::Curve with_flange(double tread_angle, std::vector<profiles::Step> steps) {
  steps.push_back(profiles::line(0.35 * inch));
  steps.push_back(profiles::arc(-0.55 * inch, -1));
  return profiles::chain({0, 0}, tread_angle, steps);
}

profiles::Curve new_rail_profile() {
  // The crown ends where the head becomes 3 in wide.
  const double crown =
      std::asin((1.5 - 0.875 * std::sin(0.45) - 0.375 * std::sin(units::pi / 2 - 0.025)) / 8.75);
  return upright({profiles::arc(1.25 * inch, -crown), profiles::arc(10 * inch, crown),
                  profiles::arc(1.25 * inch, 0.45), profiles::arc(0.375 * inch, face_angle),
                  profiles::line(0.5 * inch)});
}

profiles::Curve worn_rail_profile() {
  return upright({profiles::arc(1.25 * inch, -0.08), profiles::arc(12 * inch, 0.02),
                  profiles::arc(6 * inch, 0.17), profiles::arc(0.6 * inch, 0.50),
                  profiles::arc(0.33 * inch, face_angle), profiles::line(0.5 * inch)});
}

profiles::Curve new_wheel_profile() {
  return with_flange(0.05, {profiles::line(4 * inch), profiles::arc(0.6875 * inch, flange_angle)});
}

profiles::Curve cn_wheel_profile() {
  return with_flange(0, {profiles::line(4 * inch), profiles::arc(14.3 * inch, 0.115),
                         profiles::arc(1.7 * inch, 0.45), profiles::arc(0.5 * inch, flange_angle)});
}

profiles::Curve heumann_wheel_profile() {
  return with_flange(0.05,
                     {profiles::line(4 * inch), profiles::arc(8.9 * inch, 0.20),
                      profiles::arc(0.9 * inch, 0.50), profiles::arc(0.45 * inch, flange_angle)});
}

profiles::Curve railed(const profiles::Curve& rail) {
  return placed_rail(rail, paper_track.gauge, paper_track.gauge_depth, paper_track.cant);
}

// The wheel moved sideways so that its point of the angle stands over the rail's point of the same
// angle.
WheelsetOnTrack matched(const profiles::Curve& wheel, const profiles::Curve& rail, double angle) {
  const double du = rail.point_at_angle(angle).u - wheel.point_at_angle(angle).u;
  return with_radius(profiles::moved(wheel, du, 0), rail, paper_track.radius);
}

WheelsetOnTrack make_new_wheel_pair() {
  const profiles::Curve rail = railed(worn_rail_profile()), wheel = new_wheel_profile();
  // The head's centre is where the leaning rail has the angle of its cant.
  const double head = rail.point_at_angle(paper_track.cant).u;
  const double throat = wheel.pieces()[1].start.u;
  return with_radius(profiles::moved(wheel, head + throat_begins - throat, 0), rail,
                     paper_track.radius);
}

ConstraintFunctions table_of(const WheelsetOnTrack& pair) {
  return tabulate(pair, {.half_spacing = paper_track.half_spacing,
                         .end = 0.75 * inch,
                         .step = 0.0025 * inch,
                         .average = 0.02 * inch});
}

}  // namespace

const PaperTrack paper_track{29.76 * inch, 56.5 * inch, 0.625 * inch, 0.025, 16.5 * inch};

const WheelsetOnTrack& new_wheel_pair() {
  static const WheelsetOnTrack pair = make_new_wheel_pair();
  return pair;
}

const WheelsetOnTrack& cn_pair() {
  static const WheelsetOnTrack pair =
      matched(cn_wheel_profile(), railed(new_rail_profile()), cn_matches);
  return pair;
}

const WheelsetOnTrack& heumann_pair() {
  static const WheelsetOnTrack pair =
      matched(heumann_wheel_profile(), railed(worn_rail_profile()), heumann_matches);
  return pair;
}

const ConstraintFunctions& new_wheel_table() {
  static const ConstraintFunctions table = table_of(new_wheel_pair());
  return table;
}

const ConstraintFunctions& cn_table() {
  static const ConstraintFunctions table = table_of(cn_pair());
  return table;
}

const ConstraintFunctions& heumann_table() {
  static const ConstraintFunctions table = table_of(heumann_pair());
  return table;
}

}  // namespace railbook::wheelset
