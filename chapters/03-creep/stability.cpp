/***
What could defeat the solver is the search for the stick area: a cell that changes its state changes its neighbours, and an active-set
method may cycle. Here it has not done so in any case tried, {{combinations-tried}} of them in the table above. The steps
it takes hardly grow with the grid, since every grid starts from half of it. What costs is a contact a hundred times longer than wide
under spin: the rows then see more of each other than of themselves, and the linear systems take hundreds of products instead of twenty.

{{full-extremes}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "full.hpp"
#include "items.hpp"
#include "rig.hpp"
#include "rolling/carter.hpp"
#include "rolling/kalker_coefficients.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;
using rolling::Creepage;
using rolling::CreepForces;
using rolling::RollingCase;

namespace {

const char* status(const CreepForces& f, double error, double allowed) {
  return f.converged && error <= allowed ? "holds" : "fails";
}

struct Solved {
  CreepForces forces;
  double fx = 0, fy = 0, mz = 0;  // over mu N, and mu N sqrt(a b)
};

Solved solve(const RollingCase& c, Eigen::Index along = 24, Eigen::Index rows = 12) {
  Solved s{rolling::solve_rolling(c, {.along = along, .rows = rows})};
  const double bound = c.friction > 0 ? c.friction * c.load : 1;
  s.fx = s.forces.fx / bound, s.fy = s.forces.fy / bound;
  s.mz = s.forces.mz / (bound * std::sqrt(c.a * c.b));
  return s;
}

RollingCase reduced(const Creepage& r) {
  return rolling::with_reduced_creepage(rig_case(), r);
}

void creepages(report::Item& item) {
  RollingCase c = rig_case();
  c.creepage.longitudinal = 1e-9;
  const Solved tiny = solve(c);
  c.creepage.longitudinal = 1e-6;
  const Solved small = solve(c);
  const double proportion = std::abs(small.fx / tiny.fx / 1000 - 1);
  item.stability("creep-1e-9", "creepage 1e-9 and 1e-6",
                 "absolute thresholds; f must be in proportion",
                 fmt::format("f = {:.6e} and {:.6e}", tiny.fx, small.fx), proportion,
                 status(tiny.forces, proportion, 1e-9));
  c.creepage.longitudinal = 1;
  const Solved one = solve(c);
  item.stability("creep-1", "creepage 1", "full slip: f below 1, by less than 1e-6",
                 fmt::format("1 - f = {:.1e}", 1 - one.fx), 1 - one.fx,
                 one.fx <= 1 ? status(one.forces, 1 - one.fx, 1e-6) : "fails");
  const Solved zero = solve(rig_case());
  item.stability("creep-0", "no creepage", "0/0 in the direction of slip", "no forces, all sticks",
                 std::abs(zero.fx), status(zero.forces, std::abs(zero.fx), 0));
}

void frictions(report::Item& item) {
  RollingCase c = rig_case();
  c.creepage = {1e-3, 5e-4, 0.1};
  c.friction = 0;
  const Solved none = solve(c);
  item.stability("mu-0", "mu = 0", "division by mu N", none.forces.reason,
                 std::hypot(none.fx, none.fy),
                 status(none.forces, std::hypot(none.fx, none.fy), 0));
  c.friction = 1e-6;
  c.creepage.spin = 0;
  const Solved hardly = solve(c);
  const double short_of = 1 - std::hypot(hardly.fx, hardly.fy);
  item.stability("mu-1e-6", "mu = 1e-6", "all slides, reduced creepage of thousands",
                 fmt::format("1 - F/mu N = {:.0e}", short_of), short_of,
                 status(hardly.forces, short_of, 1e-6));
}

void spins(report::Item& item) {
  const auto k = rolling::kalker_coefficients(rig_case().a / rig_case().b, poisson);
  const double small = 1e-6, large = 1e5;
  const Solved s = solve(reduced({0, 0, small}), 24, 12), l = solve(reduced({0, 0, large}), 24, 12);
  const double linear =
      std::max(std::abs(s.fy / (k.c23 * small) - 1), std::abs(s.mz / (k.c33 * small) - 1));
  item.stability("spin-small", "pure spin, reduced 1e-6", "linear in C23, C33; fx = 0",
                 fmt::format("fx/fy = {:.0e}", std::abs(s.fx / s.fy)), linear,
                 status(s.forces, linear, 0.02));
  // Full spin: mu times the integral of Hertz's pressure times the distance from the centre, by polar quadrature.
  const double a = std::sqrt(axis_ratio), b = 1 / a;
  double moment = 0;
  for (int i = 0; i < 400; ++i) {
    const double t = 2 * std::numbers::pi * (i + 0.5) / 400;
    moment += std::hypot(a * std::cos(t), b * std::sin(t)) / 400;
  }
  moment *= 3 * std::numbers::pi /
            16;  // 1.5/pi times the integral of r^2 sqrt(1 - r^2) over r, times 2 pi
  const double error = std::max(std::abs(l.fy), std::abs(l.mz / moment - 1));
  item.stability("spin-large", "pure spin, reduced 1e5", "fy falls to 0, mz to that of full slip",
                 fmt::format("fy = {:.1e}, mz = {:.5f}", l.fy, l.mz), error,
                 status(l.forces, error, 2e-3));
}

void slender(report::Item& item) {
  for (const double ratio : {0.01, 100.0}) {
    RollingCase c = rig_case();
    const double area = c.a * c.b;
    c.a = std::sqrt(area * ratio), c.b = std::sqrt(area / ratio);
    // What the next finer grid says; f near one half.
    const double x = ratio < 1 ? 0.2 : 0.008;
    const Creepage r{x, x / 3, ratio < 1 ? x / 10 : 0};
    const Solved f = solve(rolling::with_reduced_creepage(c, r), 24, 12);
    const Solved g = solve(rolling::with_reduced_creepage(c, r), 32, 16);
    const double error = std::hypot(f.fx - g.fx, f.fy - g.fy);
    item.stability(fmt::format("slender-{}", ratio), fmt::format("a/b = {}", ratio),
                   "cells a hundred times longer than wide; against 32 x 16",
                   fmt::format("f = {:.4f}, {:.4f}, {} steps", f.fx, f.fy, f.forces.iterations),
                   error, status(f.forces, error, 0.01));
  }
}

void grids(report::Item& item) {
  const RollingCase c = reduced({0.2, 0.05, 0.1});
  const Solved reference = solve(c, 32, 16);
  const auto one = [&](const char* id, const char* what, Eigen::Index along, Eigen::Index rows,
                       double allowed) {
    const Solved f = solve(c, along, rows);
    const double error = std::hypot(f.fx - reference.fx, f.fy - reference.fy);
    item.stability(id, fmt::format("{}, {} x {} cells", what, along, rows), "against 32 x 16",
                   fmt::format("f = {:.4f}, {:.4f}", f.fx, f.fy), error,
                   status(f.forces, error, allowed));
  };
  one("grid-one", "one cell", 1, 1, 0.5);
  one("grid-row", "a single row", 24, 1, 0.1);
  one("grid-column", "one cell along", 1, 12, 0.5);
  one("grid-prime", "primes", 23, 13, 5e-3);
  one("grid-odd", "odd and even", 31, 8, 5e-3);
}

void symmetries(report::Item& item) {
  const Solved f = solve(reduced({0.2, 0.1, 0.3})), g = solve(reduced({-0.2, -0.1, -0.3})),
               m = solve(reduced({0.2, -0.1, -0.3}));
  const double sign =
      std::max({std::abs(f.fx + g.fx), std::abs(f.fy + g.fy), std::abs(f.mz + g.mz)});
  item.stability("sign", "all creepages reversed", "forces reverse", "differences over mu N", sign,
                 status(g.forces, sign, 1e-9));
  const double mirror =
      std::max({std::abs(f.fx - m.fx), std::abs(f.fy + m.fy), std::abs(f.mz + m.mz)});
  item.stability("mirror", "lateral and spin reversed", "fy and mz reverse, fx stays",
                 "differences over mu N", mirror, status(m.forces, mirror, 1e-9));
  RollingCase twice = rig_case();
  twice.a *= std::cbrt(2.0), twice.b *= std::cbrt(2.0);
  const Solved s = solve(rolling::with_reduced_creepage(twice, {0.2, 0, 0})),
               t = solve(reduced({0.2, 0, 0}));
  const double similar = std::abs(s.fx / t.fx - 1);
  item.stability("similar", "both radii doubled at constant load", "f depends on X alone",
                 "relative difference", similar, status(s.forces, similar, 1e-10));
}

// 320 combinations of creepages: how many do not converge, and the largest force.
void combinations(report::Item& item) {
  const auto rig = rig_case();
  const rolling::EllipseRolling solver(rig.a / rig.b, rig.poisson, {.along = 12, .rows = 8});
  int lost = 0, all = 0, steps = 0;
  double largest = 0;
  for (const double x : {0.0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1.0})
    for (const double y : {0.0, 0.05, 0.3, 1.0})
      for (const double s : {-2.0, -1.0, -0.5, -0.1, 0.0, 0.1, 0.5, 1.0, 2.0, 10.0}) {
        const auto f = solver.solve(rolling::with_reduced_creepage(rig, {x, y, s}));
        lost += !f.converged, ++all;
        steps = std::max(steps, f.iterations);
        largest = std::max(largest, std::hypot(f.fx, f.fy) / (rig.friction * rig.load));
      }
  item.value("combinations-tried", fmt::format("{}", all));
  item.stability("combinations", fmt::format("{} combinations of three creepages", all),
                 "Newton on stick and slip may cycle; F <= mu N",
                 fmt::format("{} not converged, at most {} steps, largest F/mu N = {:.6f}", lost,
                             steps, largest),
                 std::max(0.0, largest - 1), lost == 0 && largest <= 1 + 1e-12 ? "holds" : "fails");
  rolling::RollingOptions hasty;
  hasty.solver.most_newton = 1, hasty.estimate = false;
  const auto f = rolling::solve_rolling(reduced({0.2, 0.1, 0.1}), hasty);
  item.stability("hasty", "one Newton step allowed", "must not be passed off as a solution",
                 f.reason, std::numeric_limits<double>::quiet_NaN(),
                 f.converged ? "fails" : "refused");
}

// Hertz's pressure as a user would give it, cell by cell on a square grid; and forces prescribed.
void other_ways(report::Item& item) {
  RollingCase c = reduced({0.2, 0.05, 0.1});
  const Solved fitted = solve(c);
  constexpr Eigen::Index n = 45;
  const contact::Grid grid{-c.a, -c.b, 2 * c.a / n, 2 * c.b / n, n, n};
  Eigen::VectorXd pressure(grid.cells());
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i) {
      const double x = grid.x(i) / c.a, y = grid.y(j) / c.b;
      pressure[j * n + i] = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    }
  pressure *= c.load / (pressure.sum() * grid.dx * grid.dy);
  const CreepForces given = rolling::solve_rolling(grid, pressure, c, {.estimate = false});
  const double bound = c.friction * c.load;
  const double error = std::hypot(given.fx / bound - fitted.fx, given.fy / bound - fitted.fy);
  item.stability("given", "Hertz's pressure given on 45 x 45 cells",
                 "a staircase for a rim; against fitted rows",
                 fmt::format("f = {:.4f}, {:.4f}", given.fx / bound, given.fy / bound), error,
                 status(given, error, 5e-3));
  const rolling::EllipseRolling solver(c.a / c.b, c.poisson, {.along = 12, .rows = 8});
  const auto met =
      rolling::solve_for_forces(solver, reduced({0, 0, 0.3}), 0.9 * bound, -0.3 * bound);
  const double off = std::hypot(met.forces.fx / bound - 0.9, met.forces.fy / bound + 0.3);
  const Creepage r = rolling::reduced_creepage(met.rolling);
  item.stability("forces", "F = 0.9, -0.3 of mu N prescribed, spin 0.3",
                 "close to full slip; an outer Newton iteration",
                 fmt::format("X = {:.4f}, Y = {:.4f}", r.longitudinal, r.lateral), off,
                 status(met.forces, off, 1e-8));
  const auto beyond = rolling::solve_for_forces(solver, reduced({0, 0, 0}), 1.001 * bound, {});
  item.stability("forces-beyond", "F = 1.001 mu N prescribed", "no solution", beyond.forces.reason,
                 std::numeric_limits<double>::quiet_NaN(),
                 beyond.forces.converged ? "fails" : "refused");
}

void wrong(report::Item& item) {
  RollingCase c = rig_case();
  c.poisson = 0.6;
  std::string said = "nothing";
  try {
    solve(c);
  } catch (const InputError& e) {
    said = e.what();
  }
  item.stability("poisson", "Poisson's ratio 0.6", "out of range", said,
                 std::numeric_limits<double>::quiet_NaN(), said == "nothing" ? "fails" : "refused");
}

void tabulate(report::Item& item) {
  item.reconstructed("not in the paper: our own study of limits");
  item.columns({"cells", "X = 0.01", "X = 0.2", "X = 0.5", "X = 0.2, Φ = 0.3", "Φ = 2"});
  for (const auto& [along, rows] : {std::pair{6, 4}, {12, 8}, {24, 12}, {32, 16}}) {
    std::vector<std::string> cells{fmt::format("{} x {}", along, rows)};
    for (const Creepage& r : {Creepage{0.01, 0, 0}, Creepage{0.2, 0, 0}, Creepage{0.5, 0, 0},
                              Creepage{0.2, 0, 0.3}, Creepage{0, 0, 2}})
      cells.push_back(fmt::format("{}", solve(reduced(r), along, rows).forces.iterations));
    item.add_row(cells);
  }
  creepages(item);
  frictions(item);
  spins(item);
  slender(item);
  grids(item);
  symmetries(item);
  combinations(item);
  other_ways(item);
  wrong(item);
}

}  // namespace

void creep_chapter::add_full_stability(report::Chapter& chapter) {
  chapter.table("full-extremes",
                "Newton steps of the full theory on the finest grid; under spin two solutions",
                tabulate);
}
