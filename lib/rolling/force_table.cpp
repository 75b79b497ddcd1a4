#include <railbook/rolling/force_table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double bend = 0.5;  // reduced creepages below it lie evenly, above it ever wider

double stretched(double u, double reach) {
  return bend * std::sinh(u * std::asinh(reach / bend));
}

// n nodes from 0 to reach, or from -reach to reach.
std::vector<double> creepage_nodes(double reach, int n, bool both_signs) {
  std::vector<double> nodes;
  for (int i = 0; i < n; ++i) {
    const double u = both_signs ? 2.0 * i / (n - 1) - 1 : double(i) / (n - 1);
    nodes.push_back(2 * i == n - 1 && both_signs ? 0.0 : stretched(u, reach));
  }
  return nodes;
}

std::vector<double> ratio_nodes(double from, double to, int n) {
  std::vector<double> nodes;
  nodes.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i)
    nodes.push_back(n == 1 || i == 0 ? from
                    : i == n - 1     ? to
                                     : from * std::pow(to / from, double(i) / (n - 1)));
  return nodes;
}

double along_creepage(double x) {
  return std::asinh(x / bend);
}

// The fractional part of k times an irrational: evenly spread points, never on a node.
double spread(int k, double step) {
  const double x = (k + 0.5) * step;
  return x - std::floor(x);
}

}  // namespace

ForceTable::ForceTable(const ForceTableAxes& axes, const ShareTheory& theory) {
  units::require_positive("first axis ratio", axes.ratio_from);
  units::require_between("last axis ratio", axes.ratio_to, axes.ratio_from, 1e3 * axes.ratio_from);
  units::require_between("axis ratios", axes.ratios, axes.ratio_from == axes.ratio_to ? 1 : 2,
                         1000);
  units::require_between("reach of reduced creepage", axes.reach, 1e-3, 1e6);
  units::require_between("reach of reduced spin", axes.spin_reach, 1e-3, 1e6);
  units::require_between("longitudinal nodes", axes.longitudinal, 2, 1000);
  units::require_between("lateral nodes", axes.lateral, 2, 1000);
  units::require_between("spin nodes", axes.spin, 3, 1001);
  if (axes.spin % 2 == 0)
    throw InputError(fmt::format("spin nodes is {}; allowed: an odd number", axes.spin));
  units::require_between("nodes of the table",
                         double(axes.ratios) * axes.longitudinal * axes.lateral * axes.spin, 12,
                         1e7);
  ratio_ = ratio_nodes(axes.ratio_from, axes.ratio_to, axes.ratios);
  x_ = creepage_nodes(axes.reach, axes.longitudinal, false);
  y_ = creepage_nodes(axes.reach, axes.lateral, false);
  z_ = creepage_nodes(axes.spin_reach, axes.spin, true);
  values_.reserve(ratio_.size() * x_.size() * y_.size() * z_.size());
  for (const double ratio : ratio_) {
    const ShareFunction shares = theory(ratio);
    for (const double x : x_)
      for (const double y : y_)
        for (const double z : z_) values_.push_back(shares({x, y, z}));
  }
  std::size_t stride = 1;
  const auto axis = [&](const std::vector<double>& nodes, auto along) {
    const double first = along(nodes.front()), length = along(nodes.back()) - first;
    const Axis found{first, length > 0 ? double(nodes.size() - 1) / length : 0, nodes.size(),
                     stride};
    stride *= nodes.size();
    return found;
  };
  axes_[3] = axis(z_, along_creepage);
  axes_[2] = axis(y_, along_creepage);
  axes_[1] = axis(x_, along_creepage);
  axes_[0] = axis(ratio_, [](double ratio) { return std::log(ratio); });
  find_bounds();
}

// An even parabola is off its chord by an eighth of its second difference at most.
void ForceTable::find_bounds() {
  bounds_.resize(values_.size());
  for (std::size_t n = 0; n < values_.size(); ++n)
    for (const Axis& axis : axes_) {
      if (axis.nodes == 1) continue;
      if (axis.nodes == 2) {  // no second difference tells how far the theory is from a line
        bounds_[n] = {infinity, infinity};
        break;
      }
      const std::size_t k = n / axis.stride % axis.nodes;
      const std::size_t middle = std::clamp<std::size_t>(k, 1, axis.nodes - 2);
      const std::size_t m = n + middle * axis.stride - k * axis.stride;
      const ForceShares &a = values_[m - axis.stride], &b = values_[m],
                        &c = values_[m + axis.stride];
      bounds_[n].force += std::hypot(a.fx - 2 * b.fx + c.fx, a.fy - 2 * b.fy + c.fy) / 4;
      bounds_[n].moment += std::abs(a.mz - 2 * b.mz + c.mz) / 4;
    }
}

ForceTable::Cell ForceTable::cell(double axis_ratio, const Creepage& reduced) const {
  Cell found;
  found.turn_x = reduced.longitudinal < 0 ? -1 : 1;
  found.turn_y = reduced.lateral < 0 ? -1 : 1;
  const std::array at{std::log(axis_ratio), along_creepage(found.turn_x * reduced.longitudinal),
                      along_creepage(found.turn_y * reduced.lateral),
                      along_creepage(found.turn_y * reduced.spin)};
  for (std::size_t k = 0; k < 4; ++k) {
    const Axis& axis = axes_[k];
    const double last = double(axis.nodes - 1);
    const double place = (at[k] - axis.first) * (axis.nodes > 1 ? axis.steps_per_unit : 1);
    if (!(place >= -1e-9 && place <= last + 1e-9)) found.outside = true;
    const double held = place > 0 ? std::min(place, last) : 0;
    const auto low = static_cast<std::size_t>(std::min(held, std::max(last - 1, 0.0)));
    found.corner += low * axis.stride;
    found.weight[k] = held - double(low);
  }
  return found;
}

ForceShares ForceTable::at(double axis_ratio, const Creepage& reduced) const {
  const Cell c = cell(axis_ratio, reduced);
  ForceShares sum;
  for (unsigned corner = 0; corner < 16; ++corner) {
    double weight = 1;
    std::size_t n = c.corner;
    for (std::size_t k = 0; k < 4; ++k) {
      const bool high = (corner >> k & 1U) != 0;
      weight *= high ? c.weight[k] : 1 - c.weight[k];
      n += high ? axes_[k].stride : 0;
    }
    if (weight == 0) continue;  // also beyond the last node
    sum.fx += weight * values_[n].fx;
    sum.fy += weight * values_[n].fy;
    sum.mz += weight * values_[n].mz;
  }
  return {c.turn_x * sum.fx, c.turn_y * sum.fy, c.turn_y * sum.mz};
}

InterpolationBound ForceTable::bound(double axis_ratio, const Creepage& reduced) const {
  const Cell c = cell(axis_ratio, reduced);
  if (c.outside) return {infinity, infinity};
  InterpolationBound worst;
  for (unsigned corner = 0; corner < 16; ++corner) {
    std::size_t n = c.corner;
    for (std::size_t k = 0; k < 4; ++k)
      if ((corner >> k & 1U) != 0 && axes_[k].nodes > 1) n += axes_[k].stride;
    worst.force = std::max(worst.force, bounds_[n].force);
    worst.moment = std::max(worst.moment, bounds_[n].moment);
  }
  return worst;
}

InterpolationError ForceTable::error(const ShareTheory& theory, int points) const {
  units::require_between("points", points, 1, 10'000'000);
  InterpolationError e;
  e.points = points;
  // A theory may be costly to set up for an axis ratio, so that a few ratios share the points.
  const int groups = std::min(points, ratio_.size() == 1 ? 1 : 8);
  double forces = 0, moments = 0;
  for (int g = 0; g < groups; ++g) {
    const double ratio =
        ratio_.front() * std::pow(ratio_.back() / ratio_.front(), (g + 0.5) / groups);
    const ShareFunction shares = theory(ratio);
    for (int k = g; k < points; k += groups) {
      // Additive recurrence with powers of the plastic numbers' kind (Roberts 2018) in three
      // dimensions.
      const Creepage reduced{stretched(spread(k, 0.8191725133961645), x_.back()),
                             stretched(spread(k, 0.6710436067037893), y_.back()),
                             stretched(2 * spread(k, 0.5497004779019703) - 1, z_.back())};
      const ForceShares exact = shares(reduced), table = at(ratio, reduced);
      const double force = std::hypot(table.fx - exact.fx, table.fy - exact.fy);
      const double moment = std::abs(table.mz - exact.mz);
      const InterpolationBound stated = bound(ratio, reduced);
      if (std::isfinite(stated.force) && force <= stated.force && moment <= stated.moment)
        ++e.within_bound;
      e.largest_force = std::max(e.largest_force, force);
      e.largest_moment = std::max(e.largest_moment, moment);
      forces += force * force;
      moments += moment * moment;
    }
  }
  e.rms_force = std::sqrt(forces / points);
  e.rms_moment = std::sqrt(moments / points);
  return e;
}

ShareFunction shares_of(std::function<CreepForces(const RollingCase&)> solve, double axis_ratio,
                        double poisson) {
  return [solve = std::move(solve),
          unit = normalised_case(axis_ratio, poisson)](const Creepage& reduced) {
    RollingCase c = unit;
    c.creepage = reduced;
    const CreepForces f = solve(c);
    if (!f.converged)
      throw std::runtime_error(
          fmt::format("no answer at reduced creepages {:.6g}, {:.6g} and spin {:.6g}: {}",
                      reduced.longitudinal, reduced.lateral, reduced.spin, f.reason));
    return ForceShares{f.fx, f.fy, f.mz};
  };
}

}  // namespace railbook::rolling
