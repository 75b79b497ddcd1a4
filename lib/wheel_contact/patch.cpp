#include <railbook/wheel_contact/patch.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::wheel_contact {
namespace {

using Eigen::Vector3d;

constexpr double nowhere = -units::infinity;
constexpr int most_steps = 30;
constexpr double close = 1e-13;  // m

// Along n from the plane to the rail; not finite where it has no surface.
double to_rail(const profiles::Profile& rail, const Vector3d& from, const Vector3d& n) {
  double t = 0;
  for (int k = 0; k < most_steps; ++k) {
    const double y = from.y() + n.y() * t;
    if (!rail.covers(y)) return nowhere;
    const auto [depth, slope] = rail.at(y);
    const double step = (depth - from.z() - n.z() * t) / (n.z() - slope * n.y());
    t += step;
    if (std::abs(step) < close) return t;
    if (!(std::abs(t) < 0.05)) break;
  }
  return nowhere;
}

// And to the wheel, from the wheel's own axes: the point `from`, the direction n.
double to_wheel(const ProfilePair& pair, const Vector3d& from, const Vector3d& n, double guess) {
  double t = guess;
  for (int k = 0; k < most_steps; ++k) {
    const Vector3d q = from + t * n;
    const double s = q.y() - pair.half_spacing;
    if (!pair.wheel.covers(s)) return nowhere;
    const auto [depth, slope] = pair.wheel.at(s);
    const double r = std::hypot(q.x(), q.z());
    const double rate = (q.x() * n.x() + q.z() * n.z()) / r - slope * n.y();
    const double step = (pair.radius + depth - r) / rate;
    t += step;
    if (std::abs(step) < close) return t;
    if (!(std::abs(t) < 0.05)) break;
  }
  return nowhere;
}

// The wheel as seen from a frame's plane.
struct View {
  const ProfilePair& pair;
  Vector3d origin, along, across, normal;  // in the wheel's axes

  View(const PlacedWheel& wheel, const Frame& frame, double z) : pair(*wheel.pair) {
    const Vector3d centre(0, wheel.pose.y, z - pair.radius);
    origin = wheel.turn.transpose() * (frame.origin - centre);
    along = wheel.turn.transpose() * Vector3d::UnitX();
    across = wheel.turn.transpose() * frame.across();
    normal = wheel.turn.transpose() * frame.normal();
  }
  double to(double x, double t, double guess) const {
    return to_wheel(pair, origin + x * along + t * across, normal, guess);
  }
};

struct Range {
  double low, high;  // s [m]
};

// Where gap < z around a place that is deeper than that, to 1e-8 m.
Range around(const PlacedWheel& wheel, const ContactSearch& t, const PlacedWheel::Point& deepest,
             double z) {
  const auto end = [&](int direction) {
    const auto& locus = t.locus;
    auto i = static_cast<std::ptrdiff_t>(
        std::ranges::lower_bound(locus, deepest.s, {}, &PlacedWheel::Point::s) - locus.begin());
    if (direction < 0) --i;
    double inside = deepest.s;
    const auto last = static_cast<std::ptrdiff_t>(locus.size()) - 1;
    while (i >= 0 && i <= last && locus[static_cast<std::size_t>(i)].gap < z) {
      inside = locus[static_cast<std::size_t>(i)].s;
      i += direction;
    }
    if (i < 0 || i > last) return inside;
    double outside = locus[static_cast<std::size_t>(i)].s;
    while (std::abs(outside - inside) > 1e-8) {
      const double middle = 0.5 * (inside + outside);
      (wheel.point(middle).gap < z ? inside : outside) = middle;
    }
    return inside;
  };
  return {end(-1), end(1)};
}

// A whole patch: ranges that belong together.
struct Group {
  std::vector<Range> ranges;
  double distance(const PlacedWheel& wheel, const Range& other) const {
    const auto a = wheel.point(ranges.back().high).at, b = wheel.point(other.low).at;
    return (b - a).norm();
  }
};

struct Mean {
  double weight = 0, angle = 0, low = units::infinity, high = -units::infinity;
  Vector3d at = Vector3d::Zero();
};

// Averages over a group, weighted with depth^(5/2): for a circular Hertzian contact, whose overlap
// is sqrt(2) as wide, that gives a place across the mean square it has over the area in contact.
// (Chosen at first because the frames then meet those of CONTACT, which they do to some
// micrometres.)
Mean mean_of(const PlacedWheel& wheel, const Group& group, double z) {
  constexpr int points = 48;
  Mean m;
  for (const Range& r : group.ranges)
    for (int k = 0; k < points; ++k) {
      const auto p = wheel.point(r.low + (k + 0.5) / points * (r.high - r.low));
      const double depth = std::max(0.0, z - p.gap);
      const double w = std::pow(depth, 2.5) * (r.high - r.low);
      m.weight += w, m.angle += w * p.angle, m.at += w * p.at;
      m.low = std::min(m.low, p.angle), m.high = std::max(m.high, p.angle);
    }
  m.angle /= m.weight, m.at /= m.weight;
  return m;
}

Patch patch_of(const PlacedWheel& wheel, const Group& group, double z) {
  constexpr int steps = 64;
  const Mean mean = mean_of(wheel, group, z);
  Patch patch;
  patch.frame.angle = mean.angle;
  patch.frame.origin = {mean.at.x(), mean.at.y(), wheel.pair->rail.at(mean.at.y()).depth};
  patch.turn = mean.high - mean.low;
  patch.merged = group.ranges.size() > 1;
  const auto across = patch.frame.across(), normal = patch.frame.normal();
  contact::Box& box = patch.overlap;
  box = {units::infinity, nowhere, units::infinity, nowhere};
  // Along the wheel's deepest line, then over equal steps across.
  std::vector<std::pair<double, double>> line;  // t, x
  double radius = 0;
  const double from = group.ranges.front().low, to = group.ranges.back().high;
  patch.at_end = at_end(*wheel.pair, wheel.point(from)) || at_end(*wheel.pair, wheel.point(to));
  for (int k = 0; k <= steps; ++k) {
    const auto p = wheel.point(from + (to - from) * (k - 2.0) / (steps - 4.0));
    const Vector3d d = p.at - patch.frame.origin + Vector3d(0, 0, z);
    line.emplace_back(d.dot(across), d.x());
    radius = std::max(radius, p.radius);
  }
  std::ranges::sort(line);
  patch.radius = radius / std::cos(mean.angle);
  const View view(wheel, patch.frame, z);
  for (int k = 0; k <= steps; ++k) {
    Depth d;
    d.t = line.front().first + (line.back().first - line.front().first) * k / steps;
    auto next = std::ranges::lower_bound(line, std::pair{d.t, nowhere});
    if (next == line.begin()) ++next;
    if (next == line.end()) --next;
    const auto& [t1, x1] = *next;
    const auto& [t0, x0] = *(next - 1);
    d.x = t1 > t0 ? x0 + (x1 - x0) * (d.t - t0) / (t1 - t0) : x0;
    const Vector3d at = patch.frame.origin + d.t * across;
    const double rail = to_rail(wheel.pair->rail, at, normal);
    d.overlap = std::isfinite(rail) ? view.to(d.x, d.t, rail) - rail : nowhere;
    patch.line.push_back(d);
    if (!(d.overlap > 0)) continue;
    const double half = std::sqrt(2 * patch.radius * d.overlap);
    box.x_min = std::min(box.x_min, d.x - half), box.x_max = std::max(box.x_max, d.x + half);
    box.y_min = std::min(box.y_min, d.t), box.y_max = std::max(box.y_max, d.t);
  }
  const double margin = (line.back().first - line.front().first) / steps;
  box.y_min -= margin, box.y_max += margin;
  return patch;
}

double greatest_overlap(const Patch& patch) {
  double most = nowhere;
  for (const Depth& d : patch.line) most = std::max(most, d.overlap);
  return most;
}

}  // namespace

std::vector<Patch> patches(const PlacedWheel& wheel, const ContactSearch& touching, double z,
                           const PatchOptions& options) {
  std::vector<Range> ranges;
  for (const PlacedWheel::Point& p : touching.least)
    if (p.gap < z) ranges.push_back(around(wheel, touching, p, z));
  std::ranges::sort(ranges, {}, &Range::low);
  std::vector<Group> groups;
  for (const Range& r : ranges) {
    if (!groups.empty() && r.low <= groups.back().ranges.back().high) continue;  // the same
    if (!groups.empty() && groups.back().distance(wheel, r) < options.merge_distance &&
        std::abs(mean_of(wheel, groups.back(), z).angle - mean_of(wheel, {{r}}, z).angle) <
            options.merge_angle)
      groups.back().ranges.push_back(r);
    else
      groups.push_back({{r}});
  }
  std::vector<Patch> all;
  for (const Group& group : groups)
    if (mean_of(wheel, group, z).weight > 0) all.push_back(patch_of(wheel, group, z));
  std::erase_if(all, [](const Patch& p) { return !(greatest_overlap(p) > 0); });
  std::ranges::stable_sort(all, [](const Patch& a, const Patch& b) {
    return greatest_overlap(a) > greatest_overlap(b);
  });
  return all;
}

double overlap(const PlacedWheel& wheel, const Frame& frame, double z, double x, double t) {
  const double rail = to_rail(wheel.pair->rail, frame.origin + t * frame.across(), frame.normal());
  return std::isfinite(rail) ? View(wheel, frame, z).to(x, t, rail) - rail : nowhere;
}

Eigen::VectorXd overlap(const PlacedWheel& wheel, const Frame& frame, double z,
                        const contact::Grid& grid) {
  const View view(wheel, frame, z);
  Eigen::VectorXd out(grid.cells());
  for (Eigen::Index j = 0; j < grid.ny; ++j) {
    const double t = grid.y(j);
    const double rail =
        to_rail(wheel.pair->rail, frame.origin + t * frame.across(), frame.normal());
    for (Eigen::Index i = 0; i < grid.nx; ++i)
      out[j * grid.nx + i] = std::isfinite(rail) ? view.to(grid.x(i), t, rail) - rail : nowhere;
  }
  return out;
}

}  // namespace railbook::wheel_contact
