/***
## The curve that the full theory gives

The paper compares its measurements with Kalker's theory. Two half-spaces of equal stiffness touch
over an ellipse with Hertz's pressure $p_n$; equal stiffness leaves the pressure untouched by
friction. While they roll one metre, the creepages slide them over each other, by $\xi$ along and by
$\eta$ across, and the spin turns them by $\varphi$. The surfaces yield, and the material streams
through the contact against $x$. The slip $s$ per metre, the traction $p$ and the displacement $w$,
which were numbers in the one direction above, are now vectors in the plane, and obey

$$s=\begin{pmatrix}\xi-\varphi y\\ \eta+\varphi x\end{pmatrix}+\frac{\partial w}{\partial x},\qquad
  |p|\le\mu_c\,p_n,\qquad s=0\quad\text{or}\quad p=\mu_c\,p_n\frac{s}{|s|}.$$

In words: each place either sticks, with a traction below the limit, or slides, with a traction at
the limit and along the slip. Which places slide is not known beforehand. That makes the problem
hard.

**Displacements.** They follow from the tractions by Cerruti's formula for a tangential force on a
half-space, integrated in closed form over cells of constant traction. The slope is taken as
$[w(x+h)-w(x)]/h$ with the length $h$ of a cell: it looks upstream, because a central difference
does not see an oscillation from cell to cell.

**The loop.** `run` below is the search for stick and slip. It starts with all cells sticking, or
with the answer of a coarser grid. Each pass solves one linear system, `step`: its unknowns are both
tractions of a sticking cell and the angle of the traction of a sliding one. Then `update_slip`
computes the slip and lets cells change sides. The loop ends when no cell changes and the residual
of the slip equations is small. The number `tight` says how exactly `step` has to solve; it depends
on how many cells still change.

{{code: rolling/stick_slip.cpp run}}

In the code `g_` is the limit of the traction, and `w_` the rigid slip of the creepages, the vector
in brackets above. A sticking cell begins to slide when its traction exceeds `g_`; `put_on_bound`
sees to that. A sliding cell sticks again when the component of its slip in the direction of its
traction, `along`, becomes negative. `update_slip` does both, cell by cell:

{{code: rolling/stick_slip.cpp update_slip}}

::: {.fold summary="How the linear systems are solved, and why few cells suffice"}

The linear systems are solved by GMRES, an iteration that needs only products with the matrix. It is
helped by an approximate inverse, for which each row of cells is solved by itself.

**Few cells suffice** because of three more choices:

* *Rows that end on the ellipse.* Every row has its own cells, so there is no staircase along the
  rim. The square of a row's half length is the mean, over the width of the row, of the square of
  the ellipse's half length there. So each row bears exactly its part of the load, which goes with
  that square.
* *Ends at the right place.* If the cells just fill a row, the force has an error in proportion to
  $h$, since $[w(x+h)-w(x)]/h$ is the slope half a cell ahead of the cell's middle. Cells that are
  shifted in the row take this error out. The row's trailing end then lies {{end-behind}} of a cell
  behind the middle of the hindmost cell, and its leading end {{end-ahead}} ahead of the middle of
  the foremost, instead of 0.5 each. The two numbers are those of a row that has one end only, which
  can be solved exactly (by the method of Wiener and Hopf).
* *Half the grid first.* It gives the start, an error estimate and, from 16 cells along, an
  extrapolation.

:::

{{fig-full-curve}}

Few cells suffice because their rows end where the theory of a single end puts them. 24 x 12 cells
that just fill the rows have a mean error of {{error-filled}} at six creeps, against limits known to
{{limits-known}}; with the ends of the rows placed so, the same cells have {{error-placed}}. The
[second page](03-creep-study.html) makes these limits. It also finds that without spin the error
falls about as $h^2$ from 24 to 64 cells along, and more slowly on finer grids and with spin.

Where scripts run, the [figure at the head of the page](#live-creep) can be moved: it then computes
the contact of the rig at the load of Appendix B and $\mu_c$ = 0.3 for any creep, lateral creepage
and spin. Sliding begins at the trailing edge, and spin moves the area that slides to one side.

::: {.fold summary="The curve in numbers, against two other programs"}

{{table-full-curve}}

A second grid, with cells of one length in all rows and its matrix products by Fourier transforms,
differs nowhere by more than {{grids-apart}}. A separate program solves the same equations on square
grids and extrapolates. It is not CONTACT, the public program of Kalker and Vollebregt, which is
used further below. It states an accuracy of 0.0005 and prints four digits, which together allow a
difference of 0.00055; the largest is {{program-apart}}. In full slip $f$ stays a little below 1:
the lateral strain turns the slip out of the rolling direction, by an angle that falls as $1/X$.

:::

Two simpler theories are drawn beside it. Vermeulen and Johnson's law, $f=1-(1-kX/3)^3$ up to $kX=3$
and 1 beyond, has a slope $k$ that is {{vj-excess}} above Kalker's $C_{11}$ for this ellipse.
FASTSIM is Kalker's simplified theory, in which the displacement of a place depends on the traction
at that place only. It has the right slope and approaches full slip too slowly.

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <railbook/report/values.hpp>
#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/influence.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>

#include "rig.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

ForceTable creep_chapter::curve_table(int nodes, const RollingOptions& options, double shape) {
  const auto theory = [&](double ratio) -> ShareFunction {
    const auto contact = std::make_shared<EllipseRolling>(ratio, poisson, options);
    const auto shares =
        shares_of([contact](const RollingCase& c) { return contact->solve(c); }, ratio, poisson);
    return [shares](const Creepage& c) {  // the rest of the table is not asked for
      return c.lateral != 0 || c.spin != 0 ? ForceShares{} : shares(c);
    };
  };
  return {{shape, shape, 1, 2, 1, nodes, 2, 3}, theory};
}

double creep_chapter::master_curve(double x, bool major_along_rolling) {
  static const ForceTable along = curve_table(97, {.along = 24, .rows = 12});
  if (major_along_rolling) return along.at(axis_ratio, {x, 0, 0}).fx;
  static const ForceTable across = curve_table(97, {.along = 24, .rows = 12}, 1 / axis_ratio);
  return across.at(1 / axis_ratio, {x, 0, 0}).fx;
}

RollingCase creep_chapter::rig_case() {
  const auto ellipse = rig_contact(paper_load, profile_radius(true));
  return {.a = ellipse.a,
          .b = ellipse.b,
          .load = paper_load,
          .shear_modulus = shear_modulus,
          .poisson = poisson,
          .friction = 0.3,
          .creepage = {}};
}

namespace {

constexpr double abscissae[] = {.01, .02, .04, .06, .08, .1, .13, .16, .2, .25,
                                .3,  .35, .4,  .45, .5,  .6, .8,  1.2, 2};

std::vector<CreepForces> curve_of(const RollingOptions& options,
                                  std::span<const double> at = abscissae) {
  const EllipseRolling solver(axis_ratio, poisson, options);
  std::vector<CreepForces> curve;
  for (const double x : at)
    curve.push_back(
        solver.solve(with_reduced_creepage(normalised_case(axis_ratio, poisson), {x, 0, 0})));
  return curve;
}

const std::vector<CreepForces>& best_curve(bool full) {
  static const auto curve = curve_of({.along = full ? 40 : 32, .rows = full ? 20 : 16});
  return curve;
}

// The initial slope of Vermeulen and Johnson's law over Kalker's.
double vermeulen_johnson_excess() {
  return vermeulen_johnson_slopes(axis_ratio, poisson).longitudinal /
         kalker_coefficients(axis_ratio, poisson).c11;
}

// The largest difference of two curves.
double apart(const std::vector<CreepForces>& a, const std::vector<CreepForces>& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k].fx - b[k].fx));
  return most;
}

void tabulate(report::Item& item) {
  item.rebuilt("the paper shows the theoretical curve in Fig. 11 without numbers");
  const auto& curve = best_curve(item.full());
  const auto other = curve_of({.along = 48, .rows = 24});
  const auto program = item.printed("contact-curve.csv");
  item.columns({"X",
                {item.full() ? "f, 40 x 20 cells" : "f, 32 x 16 cells", "{:.5f}"},
                {"estimated error", "{:.0e}"},
                {"f, 48 x 24 cells", "{:.5f}"},
                "f, independent program",
                {"part that sticks", "{:.2f}"}});
  double farthest = 0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const CreepForces& p = curve[k];
    const std::string key = fmt::format("{}", abscissae[k]), &theirs = program.at(key, "f");
    item.add_row(key, p.fx, p.error, other[k].fx, theirs, p.stick_share);
    farthest = std::max(farthest, std::abs(report::printed_number(theirs) - p.fx));
  }
  const double grids = apart(curve, other);
  item.expect_checks(2);
  item.at_most("program", "largest difference from an independent program", "of µ_c N", farthest,
               5.5e-4, "good to 5e-4 by its own account, and printed to 1e-4");
  item.at_most("grids", "largest difference from 48 x 24 cells", "of µ_c N", grids, 3e-4,
               "cells of one length in all rows, and products by transforms");
  item.value("grids-apart", grids, "", "{:.4f}");
  item.value("program-apart", farthest, "", "{:.5f}");
}

// What ever finer grids tend to without spin, made for the second page.
struct CurveLimits {
  std::vector<double> x, f;
  double known = 0;  // mean uncertainty

  explicit CurveLimits(const table::CsvTable& limits) {
    for (std::size_t row = 0; row < limits.rows.size(); ++row) {
      if (limits.at(row, "set") != "curve") continue;
      x.push_back(report::printed_number(limits.at(row, "longitudinal")));
      f.push_back(report::printed_number(limits.at(row, "fx")));
      known += report::printed_number(limits.at(row, "fx_known"));
    }
    known /= static_cast<double>(x.size());
  }
  double mean_error(const RollingOptions& options) const {
    const std::vector<CreepForces> curve = curve_of(options, x);
    double sum = 0;
    for (std::size_t k = 0; k < x.size(); ++k) sum += std::abs(curve[k].fx - f[k]);
    return sum / static_cast<double>(x.size());
  }
};

// Mean error of f on n cells along that just fill the rows, and with the ends of the rows placed.
struct GridErrors {
  double filled = 0, placed = 0;
};
GridErrors grid_errors(int n, const CurveLimits& limits) {
  RollingOptions options{.along = n, .rows = n / 2, .estimate = false};
  const double placed = limits.mean_error(options);
  options.remedy = false;
  return {limits.mean_error(options), placed};
}

void figure(report::Item& item) {
  item.rebuilt("the paper shows the theoretical curve in Fig. 11 without numbers");
  report::values(item, "", "{:.3f}", "end-behind", 0.25 + edge_offset(), "end-ahead",
                 0.75 + edge_offset());
  const auto& curve = best_curve(item.full());
  const auto program = item.printed("contact-curve.csv");
  auto& line = item.data({"X", "f"});
  auto& simple = item.data("simple", {"X", "fastsim", "vermeulen_johnson"});
  auto& points = item.data("program", {"X", "f"});
  line.add(0.0, 0.0);
  for (std::size_t k = 0; k < curve.size(); ++k) {
    line.add(abscissae[k], curve[k].fx);
    points.add(abscissae[k],
               report::printed_number(program.at(fmt::format("{}", abscissae[k]), "f")));
  }
  for (int i = 0; i <= 80; ++i) {
    const double x = 0.01 * i;
    const auto c = with_reduced_creepage(normalised_case(axis_ratio, poisson), {x, 0, 0});
    simple.add(x, creep_forces(Theory::fastsim, c).fx,
               creep_forces(Theory::vermeulen_johnson, c).fx);
  }
  const CurveLimits limits(item.printed("limits.csv"));
  auto& errors = item.data("errors", {"cells", "filled", "placed"});
  GridErrors last;
  for (const int n : {4, 6, 8, 12, 16, 24}) {
    last = grid_errors(n, limits);
    errors.add(n, last.filled, last.placed);
  }
  item.value("error-filled", last.filled, "", "{:.4f}");
  item.value("limits-known", limits.known, "", "{:.6f}");
  item.value("error-placed", last.placed, "", "{:.5f}");
  item.value("vj-excess", 100 * (vermeulen_johnson_excess() - 1), "%", "{:.0f}");
}

}  // namespace

const report::Section creep_chapter::full_theory{report::figure("fig-full-curve", figure),
                                                 report::table("table-full-curve", tabulate)};
