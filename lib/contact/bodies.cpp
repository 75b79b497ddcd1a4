#include <railbook/contact/bodies.hpp>

#include <fmt/format.h>
#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <railbook/contact/geometry.hpp>
#include <railbook/num/gsl.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::contact {
namespace {

using Eigen::Index;

// Bounds of lengths that are asked for, in and out of which nothing overflows: the radii, and the
// profiles.
constexpr double smallest = 1e-9, largest = 1e6;

double curvature(double radius, const char* what) {
  const double size = std::abs(radius);
  if (!(size >= smallest) || (size > largest && !std::isinf(size)))
    throw InputError(fmt::format("{} is {} m; allowed: {:g} m to {:g} m, negative for concave",
                                 what, radius, smallest, largest));
  return 1 / radius;
}

// Depth across the rail as a function of x, and where it is known.
struct Section {
  std::function<double(double)> depth;
  double x_min = -units::infinity, x_max = units::infinity;
};

void check(const DepthPoints& p, const char* body) {
  if (p.x.size() != p.depth.size() || p.x.size() < 5)
    throw InputError(
        fmt::format("the profile of {} has {} points; it needs at least 5", body, p.x.size()));
  for (Index n = 0; n < p.x.size(); ++n) {
    if (!std::isfinite(p.x[n]) || !std::isfinite(p.depth[n]))
      throw InputError(fmt::format("point {} of the profile of {} is not a number", n + 1, body));
    for (const auto& [name, value] : {std::pair{"x", p.x[n]}, std::pair{"depth", p.depth[n]}})
      if (std::abs(value) > largest)
        throw InputError(
            fmt::format("point {} of the profile of {}: {} is {} m; allowed: {:g} m to {:g} m",
                        n + 1, body, name, value, -largest, largest));
    if (n > 0 && !(p.x[n] - p.x[n - 1] >= smallest))
      throw InputError(fmt::format(
          "point {} of the profile of {}: x is {} m after {} m; it must rise, by {:g} m or more",
          n + 1, body, p.x[n], p.x[n - 1], smallest));
  }
}

Section section(const Body& body) {
  if (!body.profile) {
    const double c = curvature(body.radius_x, "radius across the rail");
    return {[c](double x) { return 0.5 * c * x * x; }};
  }
  const DepthPoints& p = *body.profile;
  num::use_gsl_status_codes();
  const std::shared_ptr<gsl_spline> spline = num::gsl_owned(
      gsl_spline_alloc(gsl_interp_cspline, static_cast<std::size_t>(p.x.size())), gsl_spline_free);
  num::check_gsl(gsl_spline_init(spline.get(), p.x.data(), p.depth.data(),
                                 static_cast<std::size_t>(p.x.size())),
                 "spline of a profile");
  return {[spline](double x) { return gsl_spline_eval(spline.get(), x, nullptr); }, p.x[0],
          p.x[p.x.size() - 1]};
}

// The least value of f on [low, high]: the best of many points, then golden sections around it.
double least(const std::function<double(double)>& f, double low, double high) {
  constexpr int points = 4000;
  const double step = (high - low) / points;
  int best = 0;
  double best_value = units::infinity;
  for (int k = 0; k <= points; ++k) {
    const double value = f(std::min(low + k * step, high));
    if (value < best_value) best = k, best_value = value;
  }
  if (best == 0 || best == points)
    throw InputError(
        fmt::format("the bodies come closest at an end of the profile data, x = {:.6g} m; they "
                    "would touch beyond it",
                    best ? high : low));
  double a = low + (best - 1) * step, b = low + (best + 1) * step;
  constexpr double golden = 0.6180339887498949;
  for (int k = 0; k < 60; ++k) {
    const double left = b - golden * (b - a), right = a + golden * (b - a);
    (f(left) <= f(right) ? b : a) = f(left) <= f(right) ? right : left;
  }
  return 0.5 * (a + b);
}

// By two radii each: the closed form, in any relative position.
TouchingBodies join_radii(const Body& one, const Body& two, double angle) {
  const Curvature first{curvature(one.radius_x, "radius of body 1 across the rail"),
                        curvature(one.radius_y, "radius of body 1 along the rail"), 0};
  const Curvature second{curvature(two.radius_x, "radius of body 2 across the rail"),
                         curvature(two.radius_y, "radius of body 2 along the rail"), angle};
  TouchingBodies result;
  RelativeCurvature curvature = relative_curvature(first, second);
  result.angle = std::exchange(curvature.angle, 0);
  result.gap = quadratic_gap(curvature);
  result.search = [gap = result.gap](double approach) {
    return interpenetration_box(gap, approach);
  };
  result.x_min = -units::infinity, result.x_max = units::infinity;
  return result;
}

// At least one by a profile, which is in order.
TouchingBodies join_profiles(const Body& one, const Body& two) {
  const double along = curvature(one.radius_y, "radius of body 1 along the rail") +
                       curvature(two.radius_y, "radius of body 2 along the rail");
  if (!(along > 0))
    throw InputError(
        fmt::format("the curvatures along the rail add to {} per m; they must be positive, or the "
                    "bodies do not separate",
                    along));
  const Section first = section(one), second = section(two);
  const double low = std::max(first.x_min, second.x_min),
               high = std::min(first.x_max, second.x_max);
  if (!(low < high)) throw InputError("the two profiles have no x in common");
  const auto both = [first, second](double x) { return first.depth(x) + second.depth(x); };
  const double x_touch = least(both, low, high), depth = both(x_touch);
  const auto across = [=](double x) {
    const double t = x + x_touch;
    if (t < low || t > high) return units::infinity;
    return std::max(both(t) - depth, 0.0);
  };
  TouchingBodies result;
  result.x_touch = x_touch;
  result.x_min = low - x_touch, result.x_max = high - x_touch;
  result.gap = [=](double x, double y) { return across(x) + 0.5 * along * y * y; };
  result.search = [=, a = low - x_touch, b = high - x_touch](double approach) {
    constexpr int points = 4000;
    const double step = (b - a) / points, half = std::sqrt(2 * approach / along);
    int from = points, to = 0;
    for (int k = 0; k <= points; ++k)
      if (across(a + k * step) < approach) from = std::min(from, k), to = k;
    if (from > to) {  // smaller than the steps: search from the origin
      return interpenetration_box(
          [=](double x, double y) { return across(x) + 0.5 * along * y * y; }, approach);
    }
    return Box{a + (from - 1) * step, a + (to + 1) * step, -half, half};
  };
  return result;
}

// Every second point and both ends.
DepthPoints thinned(const DepthPoints& p, Index first) {
  std::vector<Index> kept{0};
  for (Index n = first; n < p.x.size() - 1; n += 2)
    if (n > 0) kept.push_back(n);
  kept.push_back(p.x.size() - 1);
  return {p.x(kept), p.depth(kept)};
}

// Standard deviation of the points about a smooth profile [m], by the median of their distances
// from the cubics through the two points on either side.
double scatter(const DepthPoints& p) {
  std::vector<double> off;
  for (Index n = 2; n + 2 < p.x.size(); ++n) {
    double between = 0, variance = 1;
    for (const Index k : {n - 2, n - 1, n + 1, n + 2}) {
      double weight = 1;
      for (const Index m : {n - 2, n - 1, n + 1, n + 2})
        if (m != k) weight *= (p.x[n] - p.x[m]) / (p.x[k] - p.x[m]);
      between += weight * p.depth[k];
      variance += weight * weight;
    }
    off.push_back(std::abs(p.depth[n] - between) / std::sqrt(variance));
  }
  if (off.empty()) return 0;
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::ranges::nth_element(off, middle);
  return *middle / 0.6745;
}

}  // namespace

double touch_scatter(const Body& one, const Body& two) {
  return 3 * std::hypot(one.profile ? scatter(*one.profile) : 0,
                        two.profile ? scatter(*two.profile) : 0);
}

double touch_place_error(const TouchingBodies& bodies, double height) {
  if (std::isinf(bodies.x_max)) return 0;
  constexpr double rounding = 1e-17;  // of a depth of some centimetres [m]
  const double off = height + rounding;
  const Box box = bodies.search(off);
  constexpr int steps = 1000;
  double farthest = 0;
  for (const double end : {box.x_min, box.x_max}) {
    int k = steps;
    while (k > 1 && !(bodies.gap(end * (k - 1) / steps, 0) < off)) --k;
    farthest = std::max(farthest, std::abs(end) * k / steps);
  }
  return farthest;
}

TouchingBodies join_bodies(const Body& one, const Body& two, double angle) {
  units::require_finite("angle between the bodies", angle, "rad");
  if (!one.profile && !two.profile) return join_radii(one, two, angle);
  if (angle != 0) throw InputError("an angle between the bodies is only for bodies given by radii");
  if (one.profile) check(*one.profile, "body 1");
  if (two.profile) check(*two.profile, "body 2");
  return join_profiles(one, two);
}

std::vector<TouchingBodies> join_thinned(const Body& one, const Body& two) {
  std::vector<TouchingBodies> joined;
  if (!one.profile && !two.profile) return joined;
  for (const Index first : {1, 2}) {
    Body coarse_one = one, coarse_two = two;
    if (one.profile) coarse_one.profile = thinned(*one.profile, first);
    if (two.profile) coarse_two.profile = thinned(*two.profile, first);
    joined.push_back(join_profiles(coarse_one, coarse_two));
  }
  return joined;
}

}  // namespace railbook::contact
