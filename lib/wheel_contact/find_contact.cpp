#include <railbook/wheel_contact/find_contact.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/wheelset_contact.hpp>

namespace railbook::wheel_contact {

ProfilePair s1002_on_60e1(double cant, profiles::Rail60 kind) {
  return {profiles::s1002(), profiles::Profile(wheelset::placed_rail(
                                 profiles::rail_60e1(kind), 1.435, 0.014, std::atan(cant)))};
}

Pose mirrored(const Pose& pose) {
  return {-pose.y, -pose.yaw, -pose.roll};
}

PlacedWheel::PlacedWheel(const ProfilePair& of, const Pose& in) : pair(&of), pose(in) {
  const double c = std::cos(in.yaw), s = std::sin(in.yaw);
  const double k = std::cos(in.roll), t = std::sin(in.roll);
  turn << c, -s, 0, k * s, k * c, -t, t * s, t * c, k;
}

PlacedWheel::Point PlacedWheel::point(double s) const {
  const auto [depth, slope] = pair->wheel.at(s);
  Point p;
  p.s = s;
  p.radius = pair->radius + depth;
  const double sine = -std::tan(pose.yaw) * slope;
  if (!(std::abs(sine) < 1)) {
    p.gap = units::infinity;
    return p;
  }
  const Eigen::Vector3d own(p.radius * sine, pair->half_spacing + s,
                            p.radius * std::sqrt(1 - sine * sine));
  p.at = turn * own;
  p.at.y() += pose.y;
  p.at.z() -= pair->radius;
  if (!pair->rail.covers(p.at.y())) {
    p.gap = units::infinity;
    return p;
  }
  const auto [rail, rise] = pair->rail.at(p.at.y());
  p.gap = rail - p.at.z();
  p.angle = std::atan(rise);
  return p;
}

namespace {

constexpr double step = 1e-4;  // m

// The least gap between two places, by golden sections.
PlacedWheel::Point least_between(const PlacedWheel& wheel, double low, double high) {
  constexpr double golden = 0.6180339887498949;
  PlacedWheel::Point a = wheel.point(high - golden * (high - low)),
                     b = wheel.point(low + golden * (high - low));
  for (int k = 0; k < 34; ++k) {
    if (a.gap < b.gap) {
      high = b.s, b = a;
      a = wheel.point(high - golden * (high - low));
    } else {
      low = a.s, a = b;
      b = wheel.point(low + golden * (high - low));
    }
  }
  return a.gap < b.gap ? a : b;
}

}  // namespace

ContactSearch find_contact(const PlacedWheel& wheel) {
  ContactSearch t;
  const profiles::Profile& profile = wheel.pair->wheel;
  const auto count = static_cast<std::size_t>((profile.to() - profile.from()) / step);
  const double h = (profile.to() - profile.from()) / static_cast<double>(count);
  for (std::size_t i = 0; i <= count; ++i)
    t.locus.push_back(
        wheel.point(std::min(profile.from() + h * static_cast<double>(i), profile.to())));
  for (std::size_t i = 0; i < t.locus.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, t.locus.size() - 1);
    const double gap = t.locus[i].gap;
    if (!std::isfinite(gap) || gap > t.locus[before].gap || gap > t.locus[after].gap ||
        (i > 0 && gap == t.locus[before].gap))
      continue;
    t.least.push_back(least_between(wheel, t.locus[before].s, t.locus[after].s));
  }
  if (t.least.empty())
    throw InputError{fmt::format(
        "the wheel is nowhere above its rail at a shift of {:.6g} m, yaw {:.6g} rad, roll {:.6g} "
        "rad; allowed: poses in which it is",
        wheel.pose.y, wheel.pose.yaw, wheel.pose.roll)};
  std::ranges::stable_sort(t.least, {}, [](const PlacedWheel::Point& p) { return p.gap; });
  return t;
}

namespace {

// Between the flange's tip and 50 mm outwards; depths grow downwards, s outwards. Without a face,
// the slope is that of `least`.
struct FlangeFace {
  double s, slope;
};
FlangeFace steepest_face(const profiles::Profile& wheel, double least) {
  constexpr double thickest = 0.05;  // m, of a flange
  double tip = wheel.from(), lowest = -units::infinity;
  for (double s = wheel.from(); s <= wheel.to(); s += step)
    if (const double depth = wheel.at(s).depth; depth > lowest) lowest = depth, tip = s;
  FlangeFace face{wheel.from(), least};
  for (double s = tip; s <= std::min(tip + thickest, wheel.to()); s += step)
    if (const double slope = -wheel.at(s).slope; slope > face.slope) face = {s, slope};
  return face;
}

}  // namespace

double flange_angle(const profiles::Profile& wheel) {
  return std::atan(steepest_face(wheel, 0).slope);
}

double flange_place(const profiles::Profile& wheel) {
  return steepest_face(wheel, 0).s;
}

double nadal_limit(double angle, double friction) {
  const double slope = std::tan(angle);
  return (slope - friction) / (1 + friction * slope);
}

void require_fit(const ProfilePair& pair) {
  const double face = steepest_face(pair.wheel, 1).s;  // beyond 45 degrees
  const PlacedWheel::Point first = find_contact(PlacedWheel(pair, {})).least.front();
  if (first.s < face || std::abs(first.angle) > 45 * units::degree)
    throw InputError(fmt::format(
        "the wheelset does not fit between the rails: centred, it stands on a flange, {:.4g} mm "
        "inwards of its running circle, at {:.0f} degrees; check gauge, back-to-back and origin",
        -first.s / units::millimetre, std::abs(first.angle) / units::degree));
}

bool at_end(const ProfilePair& pair, const PlacedWheel::Point& p) {
  constexpr double margin = 5e-4;
  return p.s < pair.wheel.from() + margin || p.s > pair.wheel.to() - margin ||
         p.at.y() < pair.rail.from() + margin || p.at.y() > pair.rail.to() - margin;
}

double rigid_roll(const ProfilePair& pair, double y, double yaw) {
  return rigid_roll(pair, pair, y, yaw);
}

double rigid_roll(const ProfilePair& left, const ProfilePair& right, double y, double yaw) {
  const double larger = right.radius - left.radius;
  const auto difference = [&](double roll) {
    const Pose pose{y, yaw, roll};
    return find_contact(PlacedWheel(right, pose)).z() -
           find_contact(PlacedWheel(left, mirrored(pose))).z() - larger;
  };
  // A wheel climbs by half the spacing times the roll: the first guess is nearly a Newton step.
  double low = 0, high = 0, at = difference(0);
  if (at == 0) return 0;
  for (double reach = 1e-4; reach < 0.05; reach *= 2) {
    (at > 0 ? high : low) = at > 0 ? reach : -reach;
    if ((difference(at > 0 ? high : low) > 0) != (at > 0))
      return num::find_root(difference, low, high, 1e-10).x;
    (at > 0 ? low : high) = at > 0 ? high : low;
  }
  throw InputError{fmt::format(
      "no roll within 0.05 rad lets both wheels touch at a shift of {:.6g} m and yaw {:.6g} rad", y,
      yaw)};
}

}  // namespace railbook::wheel_contact
