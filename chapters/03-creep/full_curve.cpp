/***
## The curve that the full theory gives

Two half-spaces of equal stiffness touch over an ellipse with Hertz's pressure $p_n$ (equal stiffness leaves the pressure untouched
by friction). Rolling by one metre slides them over each other by the creepages; the surfaces yield by $u(x)$, and since the
material streams through the contact from $+x$ to $-x$, the slip per metre is

$$s=\begin{pmatrix}\xi-\varphi y\\ \eta+\varphi x\end{pmatrix}-\left(-\frac{\partial u}{\partial x}\right),\qquad
  |p|\le\mu p_n,\quad s=0\ \text{or}\ p=\mu p_n\frac{s}{|s|}.$$

The displacements follow from the tractions $p$ by Cerruti's formula, integrated in closed form over cells of constant traction.
The slope is taken as $[u(x)-u(x+h)]/h$ with $h$ the length of a cell: upstream, since a central difference has waves it cannot
see. Four things make the answer good on few cells:

* **Rows that end on the ellipse.** Every row has its own cells, so there is no staircase along the rim. Its half length is the
  root of the mean square over the row: then each row bears exactly its share of the load.
* **Ends at the right place.** Cells that just fill a row make an error of first order, since the slope belongs half a
  cell ahead of the traction. The ends belong {{end-behind}} of a cell behind the first centre and {{end-ahead}} ahead of the last
  (Wiener and Hopf), and a sliding cell follows the slip in its middle; the error becomes one of second order.
* **Newton's method on stick and slip**: in sticking cells both tractions are unknown, in sliding ones the angle. It settles in a few steps, each solved by GMRES with the rows as preconditioner.
* **Half the grid first**: it gives the start, an error estimate and, from 16 cells along, an extrapolation.

{{fig-full-curve}}

The figure also shows the curve on one grid and on cells that fill the ellipse. On {{cells-filled}} cells that fill it the mean error
over the curve is {{error-filled}}; placed, the same cells have {{error-placed}}, and 6 x 4 cells {{error-small}}.

{{include: answer.cpp}}

{{table-full-curve}}

Beyond 1024 cells the program gives all rows cells of one length, which Fourier transforms along the rows can multiply; 48 x 24 such cells differ nowhere by more than {{grids-apart}}. An independent program of the
same theory (CONTACT's, on square grids of 31 to 90 cells, extrapolated) is nowhere farther than {{contact-apart}}; on its own grids the
two agree to the six digits that it prints, so that the difference is that of the extrapolation. In full slip
$f$ stays a little below 1: the lateral strain turns the slip out of the rolling direction, by an angle that falls as $1/X$.

Vermeulen and Johnson, whom the paper names beside Kalker for the trend with the load, have another curve, $1-(1-CX/3)^3$, with a slope $C$ of their own:
{{vj-excess}} above Kalker's for this ellipse. With the scatter of {{fig-11}} no such experiment could tell the two apart.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curve.hpp"
#include "num/roots.hpp"
#include "rig.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/kalker_coefficients.hpp"
#include "rolling/rolling_influence.hpp"
#include "sections.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr int intervals = 60;
constexpr double end = 2;

// f at places that are dense near 0: X = end (i/n)^2.
std::vector<double> solved() {
  const RollingCase c = unit_case(axis_ratio, poisson);
  const EllipseRolling full(axis_ratio, poisson, {.along = 24, .rows = 12});
  std::vector<double> shares{0};
  for (int i = 1; i <= intervals; ++i) {
    const double x = end * (double(i) / intervals) * (double(i) / intervals);
    shares.push_back(full.solve(with_reduced_creepage(c, {x, 0, 0})).fx);
  }
  return shares;
}

}  // namespace

double creep_chapter::master_curve(double x) {
  static const std::vector<double> shares = solved();
  if (x < 0) return -master_curve(-x);
  // The cubic through four neighbours, in the root of X, where the places lie evenly.
  const double place = std::min(std::sqrt(x / end), 1.0) * intervals;
  const int first = std::clamp(static_cast<int>(place) - 1, 0, intervals - 3);
  double sum = 0;
  for (int i = first; i < first + 4; ++i) {
    double weight = 1;
    for (int j = first; j < first + 4; ++j)
      if (j != i) weight *= (place - j) / (i - j);
    sum += weight * shares[static_cast<std::size_t>(i)];
  }
  return sum;
}

double creep_chapter::master_curve_inverse(double share) {
  units::require_between("share of the friction", share, 1e-12, 0.999);
  return num::find_root([&](double x) { return master_curve(x) - share; }, 0, end, 1e-13).x;
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

const std::vector<double>& creep_chapter::curve_abscissae() {
  static const std::vector<double> x{.01, .02, .04, .06, .08, .1, .13, .16, .2, .25,
                                     .3,  .35, .4,  .45, .5,  .6, .8,  1.2, 2};
  return x;
}

std::vector<CurvePoint> creep_chapter::full_curve(const RollingOptions& options) {
  const auto rig = rig_case();
  const EllipseRolling solver(rig.a / rig.b, rig.poisson, options);
  std::vector<CurvePoint> curve;
  for (const double x : curve_abscissae()) {
    const auto f = solver.solve(with_reduced_creepage(rig, {x, 0, 0}));
    curve.push_back({f.fx / (rig.friction * rig.load), f.error, f.stick_share, f.converged});
  }
  return curve;
}

const std::vector<CurvePoint>& creep_chapter::reference_curve(bool full) {
  static const auto curve = full_curve({.along = full ? 40 : 32, .rows = full ? 20 : 16});
  return curve;
}

const std::vector<CurvePoint>& creep_chapter::other_curve() {
  static const auto curve = full_curve({.along = 48, .rows = 24});
  return curve;
}

namespace {

// Mean and largest difference of two curves at the same abscissae.
struct Apart {
  double mean = 0, most = 0;
};
Apart apart(const std::vector<CurvePoint>& a, const std::vector<CurvePoint>& b) {
  Apart d;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double e = std::abs(a[k].force - b[k].force);
    d.mean += e / static_cast<double>(a.size());
    d.most = std::max(d.most, e);
  }
  return d;
}

void tabulate(report::Item& item) {
  item.rebuilt("the paper shows the theoretical curve in Fig. 11 without numbers");
  const auto& curve = reference_curve(item.full());
  const auto& other = other_curve();
  const auto program = item.printed("contact-curve.csv");
  item.columns({"X",
                {"f", "{:.5f}"},
                {"estimated error", "{:.0e}"},
                {"f, 48 x 24 cells", "{:.5f}"},
                "f, CONTACT",
                {"stick share", "{:.2f}"}});
  item.expect_checks(static_cast<int>(curve.size()) + 1);
  double farthest = 0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const auto& p = curve[k];
    const std::string key = fmt::format("{}", curve_abscissae()[k]);
    const std::string& theirs = program.at(key, "f");
    const double f = report::printed_number(theirs);
    item.add_row(key, p.force, p.error, other[k].force, theirs, p.stick);
    item.agree("contact-" + key, "f at X = " + key, "", p.force, f, 6e-4 / f,
               "CONTACT, square grids extrapolated, good to 5e-4 by its own account");
    farthest = std::max(farthest, std::abs(f - p.force));
  }
  const double grids = apart(curve, other).most;
  item.at_most("grids", "largest difference from 48 x 24 cells", "of mu N", grids, 3e-4,
               "cells of one length in all rows, and products by transforms");
  item.value("grids-apart", grids, "", "{:.1e}");
  item.value("contact-apart", farthest, "", "{:.1e}");
}

void figure(report::Item& item) {
  item.rebuilt("the paper shows the theoretical curve in Fig. 11 without numbers");
  item.value("end-behind", 0.25 + edge_offset(), "", "{:.3f}");
  item.value("end-ahead", 0.75 + edge_offset(), "", "{:.3f}");
  const auto& curve = reference_curve(item.full());
  const auto program = item.printed("contact-curve.csv");
  auto& line = item.data({"X", "f"});
  auto& points = item.data("contact", {"X", "f"});
  line.add(0.0, 0.0);
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const double x = curve_abscissae()[k];
    line.add(x, curve[k].force);
    points.add(x, report::printed_number(program.at(fmt::format("{}", x), "f")));
  }
  auto& errors = item.data("errors", {"cells", "filled", "placed"});
  for (const int n : {4, 6, 8, 12, 16, 24}) {
    const RollingOptions filled{.along = n, .rows = n / 2, .remedy = false, .estimate = false};
    const RollingOptions placed{.along = n, .rows = n / 2, .estimate = false};
    const double raw = apart(full_curve(filled), curve).mean,
                 good = apart(full_curve(placed), curve).mean;
    errors.add(n, raw, good);
    if (n != 24) continue;
    item.value("cells-filled", fmt::format("{} x {}", n, n / 2));
    item.value("error-filled", raw, "", "{:.1e}");
    item.value("error-placed", good, "", "{:.1e}");
  }
  item.value("vj-excess",
             100 * (vermeulen_johnson_slopes(axis_ratio, poisson).longitudinal /
                        kalker_coefficients(axis_ratio, poisson).c11 -
                    1),
             "%", "{:.0f}");
  item.value("error-small", apart(full_curve({.along = 6, .rows = 4}), curve).mean, "", "{:.1e}");
  contact_answer(item);
}

}  // namespace

const report::Section creep_chapter::full_theory{
    report::figure("fig-full-curve",
                   "The dimensionless creep curve by the full theory, and its error", figure),
    report::table("table-full-curve", "The dimensionless creep curve, a/b = 1.568, nu = 0.3",
                  tabulate)};
