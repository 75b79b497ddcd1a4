// Creep forces tabulated over the axis ratio and the reduced creepages, for codes that need them a
// million times.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include <railbook/rolling/case.hpp>

namespace railbook::rolling {

// Shares of the friction bound: forces over mu N, the moment over mu N sqrt(a b).
struct ForceShares {
  double fx = 0;
  double fy = 0;
  double mz = 0;
};

// Nodes: axis ratios spaced evenly in ln(a/b); longitudinal and lateral reduced creepages from 0,
// spin of both signs, all dense near 0, where the forces bend, and thin towards `reach` (x = s
// sinh(u arsinh(reach/s)), s = 0.5).
struct ForceTableAxes {
  double ratio_from = 0.5, ratio_to = 2;
  int ratios = 5;
  double reach = 5, spin_reach = 5;                // largest reduced creepages
  int longitudinal = 13, lateral = 13, spin = 25;  // nodes; spin odd, so that 0 is one
};

// The theory to tabulate, at an axis ratio.
using ShareFunction = std::function<ForceShares(const Creepage& reduced)>;
using ShareTheory = std::function<ShareFunction(double axis_ratio)>;

// How far interpolation is from the theory itself, at points that are no nodes.
struct InterpolationError {
  double largest_force = 0, rms_force = 0;    // of (fx, fy), as a share of mu N
  double largest_moment = 0, rms_moment = 0;  // of mz, as a share of mu N sqrt(a b)
  int points = 0;
  int within_bound = 0;  // points whose force and moment are within a finite bound of the table
};

// How far an interpolated answer may be from the theory.
struct InterpolationBound {
  double force = 0;   // of (fx, fy), as a share of mu N
  double moment = 0;  // of mz, as a share of mu N sqrt(a b)
};

class ForceTable {
 public:
  // Calls the theory at every node. Throws InputError on axes out of range: ratios in order and
  // positive, reaches positive, 2 nodes or more an axis (1 for the ratio if both ends are equal),
  // at most 1e7 nodes in all.
  ForceTable(const ForceTableAxes& axes, const ShareTheory& theory);

  // Linear in each stretched coordinate, to rounding. Negative longitudinal creepage turns fx;
  // negative lateral creepage turns spin, fy and mz (the symmetries of the problem). Beyond an axis
  // the value at its end.
  ForceShares at(double axis_ratio, const Creepage& reduced) const;

  // An estimated bound of the error of at(): twice the error that a parabola through three
  // neighbouring nodes along each axis would give, added over the axes, at the worst corner of the
  // cell of nodes. The theory has kinks where the last cell begins to slide;
  // InterpolationError::within_bound says how often the bound held. Infinite beyond an axis, and
  // where an axis has two nodes only.
  InterpolationBound bound(double axis_ratio, const Creepage& reduced) const;

  // Against the theory at `points` places drawn evenly in the stretched coordinates, off the nodes;
  // the same ones for the same axes and number of points.
  InterpolationError error(const ShareTheory& theory, int points) const;

  const std::vector<double>& ratios() const { return ratio_; }
  const std::vector<double>& longitudinal() const { return x_; }
  const std::vector<double>& lateral() const { return y_; }
  const std::vector<double>& spin() const { return z_; }
  // The node's value; indices in the order of the axes above.
  const ForceShares& node(std::size_t ratio, std::size_t x, std::size_t y, std::size_t z) const {
    return values_[((ratio * x_.size() + x) * y_.size() + y) * z_.size() + z];
  }

  // Of the node: the largest of the cells about it.
  const InterpolationBound& node_bound(std::size_t ratio, std::size_t x, std::size_t y,
                                       std::size_t z) const {
    return bounds_[((ratio * x_.size() + x) * y_.size() + y) * z_.size() + z];
  }

 private:
  // An axis in the coordinate in which its nodes are even.
  struct Axis {
    double first = 0, steps_per_unit = 0;
    std::size_t nodes = 0, stride = 0;  // in values_
  };
  // The cell of nodes with a place: its first corner, and the weight of the upper one along each
  // axis.
  struct Cell {
    std::size_t corner = 0;
    std::array<double, 4> weight = {};
    bool outside = false;
    double turn_x = 1, turn_y = 1;
  };
  Cell cell(double axis_ratio, const Creepage& reduced) const;
  void find_bounds();

  std::vector<double> ratio_, x_, y_, z_;
  std::array<Axis, 4> axes_;
  std::vector<ForceShares> values_;
  std::vector<InterpolationBound> bounds_;
};

// A theory's forces as shares, for RollingCase-based solvers: at G = N = mu = 1, a b = 1. Calls
// throw std::runtime_error where the theory does not converge.
ShareFunction shares_of(std::function<CreepForces(const RollingCase&)> solve, double axis_ratio,
                        double poisson);

}  // namespace railbook::rolling
