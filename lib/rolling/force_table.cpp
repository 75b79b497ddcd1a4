#include <railbook/rolling/force_table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
namespace {

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

// The interval of `nodes` with x, and the weight of its upper end, in the coordinate `of` is even
// in.
struct Place {
  std::size_t low = 0, high = 0;
  double weight = 0;
};
template <class Of>
Place place(const std::vector<double>& nodes, double x, Of of) {
  if (!(x > nodes.front())) return {0, 0, 0};
  if (!(x < nodes.back())) return {nodes.size() - 1, nodes.size() - 1, 0};
  const auto high = static_cast<std::size_t>(std::ranges::upper_bound(nodes, x) - nodes.begin());
  const double low = of(nodes[high - 1]);
  return {high - 1, high, (of(x) - low) / (of(nodes[high]) - low)};
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
}

ForceShares ForceTable::at(double axis_ratio, const Creepage& reduced) const {
  const double turn_x = reduced.longitudinal < 0 ? -1 : 1, turn_y = reduced.lateral < 0 ? -1 : 1;
  const std::array places{place(ratio_, axis_ratio, [](double r) { return std::log(r); }),
                          place(x_, turn_x * reduced.longitudinal, along_creepage),
                          place(y_, turn_y * reduced.lateral, along_creepage),
                          place(z_, turn_y * reduced.spin, along_creepage)};
  ForceShares sum;
  for (int corner = 0; corner < 16; ++corner) {
    double weight = 1;
    std::array<std::size_t, 4> n{};
    for (std::size_t k = 0; k < 4; ++k) {
      const bool high = (corner >> k & 1) != 0;
      weight *= high ? places[k].weight : 1 - places[k].weight;
      n[k] = high ? places[k].high : places[k].low;
    }
    if (weight == 0) continue;
    const ForceShares& value = node(n[0], n[1], n[2], n[3]);
    sum.fx += weight * value.fx;
    sum.fy += weight * value.fy;
    sum.mz += weight * value.mz;
  }
  return {turn_x * sum.fx, turn_y * sum.fy, turn_y * sum.mz};
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
