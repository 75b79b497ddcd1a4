#include <railbook/wheelset/wheelset_contact.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::wheelset {
namespace {

constexpr double largest_roll = 0.1;                     // rad
constexpr double steepest_wheel = 84 * units::degree;    // so that it stays below 90 when rolled
constexpr double steepest_centred = 45 * units::degree;  // beyond is a flange
constexpr double closed = 1e-12;                         // m, of the difference of the two gaps
constexpr double jump_width = 1e-12;                     // m
constexpr int jump_samples = 100;

}  // namespace

WheelsetOnTrack::WheelsetOnTrack(profiles::Curve wheel, profiles::Curve rail)
    : wheel_(std::move(wheel)), rail_(std::move(rail)) {
  for (const profiles::Piece& p : wheel_.pieces()) {
    const double steepest = std::max(std::abs(p.angle_start), std::abs(p.angle_end));
    units::require_between("angle of the wheel's profile", steepest / units::degree, 0,
                           steepest_wheel / units::degree, "deg");
    left_.wheel.push_back(part_of(p));
  }
  for (const profiles::Piece& p : rail_.pieces()) left_.rail.push_back(part_of(p));
  if (wheel_.start().u >= rail_.end().u || wheel_.end().u <= rail_.start().u)
    throw InputError(fmt::format(
        "wheel and rail do not touch: the wheel is {:.6g} to {:.6g} m from the centre, the "
        "rail {:.6g} to {:.6g} m",
        -wheel_.end().u, -wheel_.start().u, -rail_.end().u, -rail_.start().u));
  right_ = left_;
}

WheelsetOnTrack::WheelsetOnTrack(const WheelsetOnTrack& left, const WheelsetOnTrack& right)
    : wheel_(left.wheel_),
      rail_(left.rail_),
      left_(left.left_),
      right_(right.left_),
      symmetric_(false) {}

WheelsetOnTrack::Part WheelsetOnTrack::part_of(const profiles::Piece& piece) {
  Part part{};
  part.u0 = piece.start.u;
  part.z0 = piece.start.z;
  part.u1 = piece.end.u;
  part.z1 = piece.end.z;
  if (piece.is_line()) {
    part.sine = std::sin(piece.angle_start);
    part.slope = -std::tan(piece.angle_start);
  } else {
    part.radius = piece.radius;
    part.uc = piece.centre.u;
    part.zc = piece.centre.z;
    part.rr = piece.radius * piece.radius;
  }
  return part;
}

// The part turned by the roll (s, c) about the axle's middle and moved to the displacement x.
void WheelsetOnTrack::pose(const Part& part, double x, double s, double c, Part& out) {
  out = part;
  out.u0 = part.u0 * c + part.z0 * s - x;
  out.z0 = part.z0 * c - part.u0 * s;
  out.u1 = part.u1 * c + part.z1 * s - x;
  out.z1 = part.z1 * c - part.u1 * s;
  if (part.radius == 0) {
    const double cosine = std::sqrt(1 - part.sine * part.sine);
    out.sine = part.sine * c + cosine * s;
    out.slope = -out.sine / (cosine * c - part.sine * s);
  } else {
    out.uc = part.uc * c + part.zc * s - x;
    out.zc = part.zc * c - part.uc * s;
  }
}

void WheelsetOnTrack::pose_all(const std::vector<Part>& parts, double x, double phi,
                               std::vector<Part>& out) {
  const double s = std::sin(phi), c = std::cos(phi);
  out.resize(parts.size());
  for (std::size_t k = 0; k < out.size(); ++k) pose(parts[k], x, s, c, out[k]);
}

double WheelsetOnTrack::height(const Part& part, double u) {
  if (part.radius == 0) return part.z0 + part.slope * (u - part.u0);
  const double du = u - part.uc;
  return part.zc + std::copysign(std::sqrt(std::max(0.0, part.rr - du * du)), part.radius);
}

double WheelsetOnTrack::sine(const Part& part, double u) {
  return part.radius == 0 ? part.sine : std::clamp((u - part.uc) / part.radius, -1.0, 1.0);
}

// Where the gap of two pieces is stationary: their tangents are parallel. Two lines have no such
// place.
std::optional<double> WheelsetOnTrack::parallel(const Part& w, const Part& r) {
  if (w.radius == 0 && r.radius == 0) return std::nullopt;
  if (w.radius == 0) return r.uc + r.radius * w.sine;
  if (r.radius == 0) return w.uc + w.radius * r.sine;
  const double difference = w.radius - r.radius;
  if (difference == 0) return std::nullopt;
  const double s = (r.uc - w.uc) / difference;
  if (!(std::abs(s) < 1)) return std::nullopt;
  return w.uc + w.radius * s;
}

WheelsetOnTrack::Least WheelsetOnTrack::least_gap(const Side& side, double x, double phi,
                                                  std::vector<Part>& posed) {
  const std::vector<Part>& rail = side.rail;
  pose_all(side.wheel, x, phi, posed);
  std::size_t i = 0, j = 0;
  double from = std::max(posed.front().u0, rail.front().u0);
  while (i < posed.size() && posed[i].u1 <= from) ++i;
  while (j < rail.size() && rail[j].u1 <= from) ++j;
  Least best;
  if (i == posed.size() || j == rail.size()) return best;
  const auto offer = [&](double u, double tangent_sine, bool at_end) {
    const double z = height(rail[j], u), gap = height(posed[i], u) - z;
    if (gap < best.gap) best = {gap, tangent_sine, {u, z}, at_end, true};
  };
  offer(from, sine(posed[i], from), true);
  for (;;) {
    const Part &w = posed[i], &r = rail[j];
    const double to = std::min(w.u1, r.u1);
    if (const auto u = parallel(w, r); u && *u > from && *u < to) offer(*u, sine(w, *u), false);
    const bool wheel_ends = w.u1 <= to, rail_ends = r.u1 <= to;
    const bool last = (wheel_ends && i + 1 == posed.size()) || (rail_ends && j + 1 == rail.size());
    // At a corner of the wheel the rail says how the common tangent lies.
    offer(to, wheel_ends ? sine(r, to) : sine(w, to), last);
    if (last) return best;
    from = to;
    if (wheel_ends) ++i;
    if (rail_ends) ++j;
  }
}

SideContact WheelsetOnTrack::side(const Least& least, double x, double phi) {
  const double s = std::sin(phi), c = std::cos(phi);
  const double u = least.on_rail.u + x, z = least.on_rail.z + least.gap;
  SideContact at;
  at.on_wheel = {u * c - z * s, z * c + u * s};
  at.on_rail = least.on_rail;
  at.radius = -at.on_wheel.z;
  at.delta = std::asin(least.sine) - phi;
  at.at_end = least.at_end;
  return at;
}

WheelsetContact WheelsetOnTrack::contact(double x, double guess) const {
  units::require_finite("lateral displacement", x, "m");
  WheelsetContact result;
  result.x = x;
  std::vector<Part> posed;
  Least left, right;
  double low = -largest_roll, high = largest_roll, phi = std::clamp(guess, low, high);
  // Newton's method within a bracket: the difference of the gaps grows with the roll.
  for (int i = 0; i < 200; ++i) {
    left = least_gap(left_, x, phi, posed);
    right = least_gap(right_, -x, -phi, posed);
    if (!left.found || !right.found) return result;
    const double f = left.gap - right.gap;
    const auto lever = [](const Least& at, double shift) {
      const double tangent = at.sine / std::sqrt(std::max(1e-8, 1 - at.sine * at.sine));
      return -at.on_rail.u - shift + tangent * (at.on_rail.z + at.gap);
    };
    const double slope = lever(left, x) + lever(right, -x);
    (f < 0 ? low : high) = phi;
    double next = slope > 0 ? phi - f / slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (f == 0 || std::abs(next - phi) < 1e-16 || high - low < 1e-16) break;
    phi = next;
  }
  result.converged = std::abs(left.gap - right.gap) < closed;
  result.roll = phi;
  result.height = -0.5 * (left.gap + right.gap);
  result.left = side(left, x, phi);
  result.right = side(right, -x, -phi);
  return result;
}

WheelsetContact WheelsetOnTrack::level_contact(double x) const {
  units::require_finite("lateral displacement", x, "m");
  std::vector<Part> posed;
  const Least left = least_gap(left_, x, 0, posed), right = least_gap(right_, -x, 0, posed);
  WheelsetContact result;
  result.x = x;
  result.converged = left.found && right.found;
  if (!result.converged) return result;
  result.height = -std::min(left.gap, right.gap);
  result.left = side(left, x, 0);
  result.right = side(right, -x, 0);
  return result;
}

profiles::Curve placed_wheel(const profiles::Curve& wheel, double from_centre) {
  return profiles::moved(
      wheel, -units::require_positive("profile origin from the centre", from_centre, "m"), 0);
}

namespace {

// The highest point of a rail, which a measured one may not be level at alone.
profiles::Point top_of(const profiles::Curve& rail) {
  profiles::Point top = rail.start();
  for (const profiles::Piece& p : rail.pieces()) {
    if (p.end.z > top.z) top = p.end;
    const bool crest = !p.is_line() && p.radius > 0 && p.angle_start <= 0 && p.angle_end >= 0;
    if (crest && p.centre.z + p.radius > top.z) top = {p.centre.u, p.centre.z + p.radius};
  }
  if (top.u == rail.start().u || top.u == rail.end().u)
    throw InputError(
        fmt::format("the rail is highest at an end of its profile, {:.6g} m across; allowed: "
                    "heights upwards (is it "
                    "upside down?) and the top of the head within the profile",
                    top.u));
  return top;
}

}  // namespace

profiles::Curve placed_rail(const profiles::Curve& rail, double gauge, double gauge_depth,
                            double cant, double depth_below_end) {
  units::require_positive("gauge", gauge, "m");
  units::require_positive("depth of the gauge point", gauge_depth, "m");
  const profiles::Curve leaning =
      profiles::turned(rail, units::require_between("cant of the rail", cant, -0.5, 0.5, "rad"));
  const profiles::Point top = top_of(leaning);
  const auto above = [&](double u) { return leaning.height(u) - top.z + gauge_depth; };
  if (above(leaning.end().u) > 0) {
    if (depth_below_end >= gauge_depth)
      return profiles::moved(leaning, -0.5 * gauge - leaning.end().u, -top.z);
    throw InputError(fmt::format(
        "the rail's profile ends {:.6g} m below its top on the gauge side; allowed: "
        "at least the depth of the gauge point (--gauge-depth), {:.6g} m; if the file's "
        "other side is the gauge side: --mirror-rail",
        top.z - leaning.end().z, gauge_depth));
  }
  const auto at = num::find_root(above, top.u, leaning.end().u);
  return profiles::moved(leaning, -0.5 * gauge - at.x, -top.z);
}

namespace {

// Where the flange is steepest; the profile's end when it has none. A flange is less than 50 mm
// thick: what is steep farther out is the edge of a rim.
double flange_face(const profiles::Curve& wheel) {
  constexpr double thickest = 0.05;
  const auto steepness = [](const profiles::Piece& p) {
    return std::max(p.angle_start, p.angle_end);
  };
  const auto& pieces = wheel.pieces();
  const double tip =
      std::ranges::min_element(pieces, {}, [](const profiles::Piece& p) { return p.end.z; })->end.u;
  const auto begin = std::ranges::find_if(
      pieces, [&](const profiles::Piece& p) { return p.end.u > tip - thickest; });
  const auto steepest = std::ranges::max_element(begin, pieces.end(), {}, steepness);
  return steepness(*steepest) > steepest_centred ? steepest->end.u : wheel.end().u;
}

}  // namespace

WheelsetOnTrack with_radius(const profiles::Curve& wheel, const profiles::Curve& rail,
                            double radius) {
  units::require_positive("rolling radius", radius, "m");
  const WheelsetOnTrack free(profiles::moved(wheel, 0, -radius), rail);
  const WheelsetContact at = free.contact(0);
  if (!at.converged || at.left.at_end)
    throw InputError(
        "the wheelset does not sit on the rails: centred, it touches at an end of a profile");
  if (std::abs(at.left.delta) > steepest_centred || at.left.on_wheel.u > flange_face(wheel))
    throw InputError(
        fmt::format("the wheelset does not fit between the rails: centred, it stands on a flange, "
                    "{:.4g} mm from the profile's end; check gauge, back-to-back and origin",
                    (wheel.end().u - at.left.on_wheel.u) / units::millimetre));
  return {profiles::moved(wheel, 0, at.left.radius - 2 * radius), rail};
}

namespace {

using Sample = WheelsetContact;

double apart(const Sample& a, const Sample& b) {
  return std::hypot(a.left.on_wheel.u - b.left.on_wheel.u, a.left.on_wheel.z - b.left.on_wheel.z);
}

void halve(const WheelsetOnTrack& pair, const Sample& a, const Sample& b, double smallest,
           std::vector<ContactJump>& jumps) {
  if (!a.converged || !b.converged || apart(a, b) < smallest) return;
  if (b.x - a.x < jump_width) {
    jumps.push_back({b.x, a.left, b.left});
    return;
  }
  const Sample middle = pair.contact(0.5 * (a.x + b.x), a.roll);
  halve(pair, a, middle, smallest, jumps);
  halve(pair, middle, b, smallest, jumps);
}

}  // namespace

std::vector<ContactJump> contact_jumps(const WheelsetOnTrack& pair, double low, double high,
                                       double smallest) {
  units::require_finite("begin of the search", low, "m");
  units::require_between("end of the search", high, low, units::infinity, "m");
  units::require_between("smallest jump", smallest, 1e-6, units::infinity, "m");
  std::vector<ContactJump> jumps;
  Sample before = pair.contact(low);
  for (int k = 1; k <= jump_samples; ++k) {
    const Sample at = pair.contact(low + (high - low) * k / jump_samples, before.roll);
    halve(pair, before, at, smallest, jumps);
    before = at;
  }
  return jumps;
}

}  // namespace railbook::wheelset
