/***
What could defeat the solver is the search for the stick area: a cell that changes its state changes its neighbours, and an active-set
method may cycle. It has not done so in any of {{combinations-tried}} combinations of creepages. What costs is a contact a hundred times longer than wide
under spin: the linear systems take hundreds of products instead of twenty.

{{full-extremes}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "../full.hpp"
#include "../rig.hpp"
#include "../sections.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/fastsim.hpp"
#include "rolling/kalker_coefficients.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;
using report::Found;

namespace {

struct Shares {
  double fx = 0, fy = 0, mz = 0;  // over mu N, and mu N sqrt(a b)
};

Shares solve(const RollingCase& c, Eigen::Index along = 24, Eigen::Index rows = 12) {
  const CreepForces f = solve_rolling(c, {.along = along, .rows = rows});
  if (!f.converged) throw report::NoAnswer(f.reason);
  const double bound = c.friction * c.load;
  return {f.fx / bound, f.fy / bound, f.mz / (bound * std::sqrt(c.a * c.b))};
}

RollingCase reduced(const Creepage& r) {
  return with_reduced_creepage(rig_case(), r);
}

double apart(const Shares& f, const Shares& g) {
  return std::hypot(f.fx - g.fx, f.fy - g.fy);
}

void creepages(report::Item& item) {
  item.stability(
      {.id = "creep-1e-9",
       .what = "creepage 1e-9",
       .stress = "absolute thresholds",
       .allowed = 1e-9,
       .reference = "proportion to 1e-6"},
      [] {
        RollingCase tiny = rig_case(), small = rig_case();
        tiny.creepage.longitudinal = 1e-9, small.creepage.longitudinal = 1e-6;
        const double f = solve(tiny).fx;
        return Found{fmt::format("f = {:.6e}", f), std::abs(solve(small).fx / f / 1000 - 1)};
      });
  item.stability({.id = "creep-1",
                  .what = "creepage 1",
                  .stress = "full slip, far beyond the curve",
                  .allowed = 1e-6,
                  .reference = "mu N"},
                 [] {
                   RollingCase c = rig_case();
                   c.creepage.longitudinal = 1;
                   const double f = solve(c).fx;
                   return Found{fmt::format("f above 1 - {:.0e}", 1e-6), std::abs(1 - f)};
                 });
  item.stability({.id = "mu-1e-6",
                  .what = "mu = 1e-6",
                  .stress = "all slides, reduced creepage of thousands",
                  .allowed = 1e-6,
                  .reference = "mu N"},
                 [] {
                   RollingCase c = rig_case();
                   c.creepage = {1e-3, 5e-4, 0}, c.friction = 1e-6;
                   const Shares f = solve(c);
                   return Found{"full force along the slip", 1 - std::hypot(f.fx, f.fy)};
                 });
}

void spins(report::Item& item) {
  item.stability(
      {.id = "spin-small",
       .what = "pure spin, reduced 1e-6",
       .stress = "linear in C23 and C33",
       .allowed = 0.02,
       .reference = "Kalker's coefficients by polynomials"},
      [] {
        const auto k = kalker_coefficients(axis_ratio, poisson);
        const Shares s = solve(reduced({0, 0, 1e-6}));
        return Found{fmt::format("C23 {:.3f}, C33 {:.3f}", s.fy * 1e6, s.mz * 1e6),
                     std::max(std::abs(s.fy * 1e6 / k.c23 - 1), std::abs(s.mz * 1e6 / k.c33 - 1))};
      });
  item.stability({.id = "spin-large",
                  .what = "pure spin, reduced 1e5",
                  .stress = "fy falls to 0, mz to that of full slip",
                  .allowed = 2e-3,
                  .reference = "mu times the mean distance from the centre"},
                 [] {
                   const double a = std::sqrt(axis_ratio), b = 1 / a;
                   double moment = 0;
                   for (int i = 0; i < 400; ++i) {
                     const double t = 2 * units::pi * (i + 0.5) / 400;
                     moment +=
                         3 * units::pi / 16 * std::hypot(a * std::cos(t), b * std::sin(t)) / 400;
                   }
                   const Shares s = solve(reduced({0, 0, 1e5}));
                   return Found{fmt::format("mz = {:.4f}", s.mz),
                                std::max(std::abs(s.fy), std::abs(s.mz / moment - 1))};
                 });
  item.stability({.id = "state-changes",
                  .what = "reduced spin about 1.373 with creepages 0.05 and 0.1, 12 x 8 cells",
                  .stress = "a cell changes from stick to slip",
                  .allowed = 1e-7,
                  .reference = "the force 1e-9 of spin further on, over 400 places"},
                 [] {
                   const EllipseRolling contact(1.5, poisson, {.along = 12, .rows = 8});
                   RollingCase c = unit_case();
                   c.a = std::sqrt(1.5), c.b = 1 / c.a;
                   double worst = 0;
                   for (int i = 0; i < 400; ++i) {
                     const double z = 1.372998641 + 1e-9 * (i - 200);
                     const auto at = [&](double spin) {
                       return contact.solve(with_reduced_creepage(c, {0.05, 0.1, spin}));
                     };
                     const CreepForces f = at(z), g = at(z + 1e-9);
                     worst = std::max(worst, std::hypot(f.fx - g.fx, f.fy - g.fy));
                   }
                   return Found{"no jump", worst};
                 });
  item.stability({.id = "fastsim-spin",
                  .what = "FASTSIM, reduced spin 1e9",
                  .stress = "the slip turns fully within a cell",
                  .allowed = 5e-3,
                  .reference = "no force"},
                 [] {
                   RollingCase c = unit_case();
                   c.creepage.spin = 1e9;
                   const auto f = fastsim_grid(c, kalker_table(axis_ratio, poisson));
                   return Found{"the force returns to zero", std::hypot(f.fx, f.fy)};
                 });
  item.stability({.id = "she-spin",
                  .what = "Shen-Hedrick-Elkins, reduced spin 1e9",
                  .stress = "not made for large spin; the answer says so",
                  .expect = report::degrades,
                  .allowed = 1 + 1e-12,
                  .reference = "no force: all of mu N is wrong"},
                 [] {
                   RollingCase c = unit_case();
                   c.creepage.spin = 1e9;
                   const auto f = shen_hedrick_elkins(c, kalker_table(axis_ratio, poisson));
                   if (f.doubt.empty()) throw std::runtime_error("no doubt expressed");
                   return Found{std::string(f.doubt), f.fy};
                 });
}

void slender(report::Item& item) {
  for (const double ratio : {0.01, 100.0})
    item.stability(
        {.id = fmt::format("slender-{}", ratio),
         .what = fmt::format("a/b = {}", ratio),
         .stress = "cells a hundred times longer than wide",
         .allowed = 0.01,
         .reference = "32 x 16 cells"},
        [ratio] {
          RollingCase c = rig_case();
          const double area = c.a * c.b, x = ratio < 1 ? 0.2 : 0.008;
          c.a = std::sqrt(area * ratio), c.b = std::sqrt(area / ratio);
          c = with_reduced_creepage(c, {x, x / 3, ratio < 1 ? x / 10 : 0});
          const Shares f = solve(c);
          return Found{fmt::format("f = {:.3f}, {:.3f}", f.fx, f.fy), apart(f, solve(c, 32, 16))};
        });
}

void grids(report::Item& item) {
  struct Grid {
    const char *id, *what;
    Eigen::Index along, rows;
    report::Stands expect;
    double allowed;
  };
  for (const Grid& g : {Grid{"grid-one", "one cell", 1, 1, report::degrades, 0.5},
                        Grid{"grid-row", "a single row of 24 cells", 24, 1, report::degrades, 0.1},
                        Grid{"grid-prime", "23 x 13 cells", 23, 13, report::holds, 5e-3}})
    item.stability(
        {.id = g.id,
         .what = g.what,
         .stress = "hardly a grid",
         .expect = g.expect,
         .allowed = g.allowed,
         .reference = "32 x 16 cells"},
        [g] {
          const RollingCase c = reduced({0.2, 0.05, 0.1});
          const Shares f = solve(c, g.along, g.rows);
          return Found{fmt::format("f = {:.3f}, {:.3f}", f.fx, f.fy), apart(f, solve(c, 32, 16))};
        });
}

void searches(report::Item& item) {
  item.value("combinations-tried", "320");
  item.stability(
      {.id = "combinations",
       .what = "320 combinations of three creepages",
       .stress = "Newton on stick and slip may cycle",
       .allowed = 1e-12,
       .reference = "|F| <= mu N"},
      [] {
        const EllipseRolling contact(axis_ratio, poisson, {.along = 12, .rows = 8});
        double largest = 0;
        for (const double x : {0.0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1.0})
          for (const double y : {0.0, 0.05, 0.3, 1.0})
            for (const double s : {-2.0, -1.0, -0.5, -0.1, 0.0, 0.1, 0.5, 1.0, 2.0, 10.0}) {
              const auto f = contact.solve(with_reduced_creepage(unit_case(), {x, y, s}));
              if (!f.converged) throw report::NoAnswer(f.reason);
              largest = std::max(largest, std::hypot(f.fx, f.fy));
            }
        return Found{"all converge", std::max(0.0, largest - 1)};
      });
  item.stability({.id = "hasty",
                  .what = "one Newton step allowed",
                  .stress = "must not be passed off as a solution",
                  .expect = report::refused},
                 [] {
                   RollingOptions options;
                   options.solver.most_newton = 1, options.estimate = false;
                   const auto f = solve_rolling(reduced({0.2, 0.1, 0.1}), options);
                   if (!f.converged) throw report::NoAnswer(f.reason);
                   return Found{"solved", 0};
                 });
  const auto forces = [](double fx, std::optional<double> fy) {
    const EllipseRolling contact(axis_ratio, poisson, {.along = 12, .rows = 8});
    const auto met =
        solve_for_forces(contact, with_reduced_creepage(unit_case(), {0, 0, 0.3}), fx, fy);
    if (!met.forces.converged) throw report::NoAnswer(met.forces.reason);
    return Found{fmt::format("X = {:.4f}", met.rolling.creepage.longitudinal),
                 std::hypot(met.forces.fx - fx, met.forces.fy - fy.value_or(met.forces.fy))};
  };
  item.stability({.id = "forces",
                  .what = "F = 0.9, -0.3 of mu N prescribed, spin 0.3",
                  .stress = "close to full slip; an outer Newton iteration",
                  .allowed = 1e-8,
                  .reference = "the forces prescribed"},
                 [&] { return forces(0.9, -0.3); });
  item.stability({.id = "forces-beyond",
                  .what = "F = 1.001 mu N prescribed",
                  .stress = "no solution",
                  .expect = report::refused},
                 [&] { return forces(1.001, {}); });
}

// Hertz's pressure as a user would give it, cell by cell on a square grid.
void given(report::Item& item) {
  item.stability(
      {.id = "given",
       .what = "Hertz's pressure given on 45 x 45 cells",
       .stress = "a staircase for a rim",
       .allowed = 5e-3,
       .reference = "rows that end on the ellipse"},
      [] {
        const RollingCase c = reduced({0.2, 0.05, 0.1});
        constexpr Eigen::Index n = 45;
        const contact::Grid grid{-c.a, -c.b, 2 * c.a / n, 2 * c.b / n, n, n};
        Eigen::VectorXd pressure(grid.cells());
        for (Eigen::Index k = 0; k < pressure.size(); ++k)
          pressure[k] = std::sqrt(std::max(
              0.0, 1 - std::pow(grid.x(k % n) / c.a, 2) - std::pow(grid.y(k / n) / c.b, 2)));
        pressure *= c.load / (pressure.sum() * grid.dx * grid.dy);
        const CreepForces f = solve_rolling(grid, pressure, c, {.estimate = false});
        const double bound = c.friction * c.load;
        const Shares found{f.fx / bound, f.fy / bound, 0};
        return Found{fmt::format("f = {:.3f}, {:.3f}", found.fx, found.fy), apart(found, solve(c))};
      });
}

void cases(report::Item& item) {
  item.added("a study of limits");
  item.columns({"cells", "X = 0.01", "X = 0.2", "X = 0.5", "X = 0.2, Φ = 0.3", "Φ = 2"});
  for (const auto& [along, rows] : {std::pair{6, 4}, {12, 8}, {24, 12}, {32, 16}}) {
    std::vector<std::string> cells{fmt::format("{} x {}", along, rows)};
    for (const Creepage& r : {Creepage{0.01, 0, 0}, Creepage{0.2, 0, 0}, Creepage{0.5, 0, 0},
                              Creepage{0.2, 0, 0.3}, Creepage{0, 0, 2}})
      cells.push_back(
          fmt::format("{}", solve_rolling(reduced(r), {.along = along, .rows = rows}).iterations));
    item.add_row(cells);
  }
  creepages(item);
  spins(item);
  slender(item);
  grids(item);
  searches(item);
  given(item);
}

}  // namespace

const report::Section creep_chapter::extremes{report::table(
    "full-extremes", "Newton steps of the full theory, two solutions, on the finest grid", cases)};
