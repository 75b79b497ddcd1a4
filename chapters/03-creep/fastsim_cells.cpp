/***
### FASTSIM on cells

With spin there is no closed form, and FASTSIM goes over strips of cells. As it is usually written, it samples the bound
at the middle of each cell and uses strips of equal width; then the bound does not add up to $\mu N$, and in full slip the force
overshoots by a part in a hundred or a thousand, which a vehicle code sees as friction that depends on the grid. Here each cell
has the mean of the bound over itself, in closed form, so that full slip is $\mu N$ to rounding on any grid. Two more changes make
the error fall with the square of the cell: the force of a cell is that at its middle, and while it slides, a traction turns
towards the slip by the solution of its equation over the cell, not by a projection.

{{table-fastsim}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "items.hpp"
#include "rig.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/fastsim.hpp"
#include "rolling/strip_theory.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

RollingCase unit(double ratio, const Creepage& reduced) {
  return {.a = std::sqrt(ratio),
          .b = 1 / std::sqrt(ratio),
          .load = 1,
          .shear_modulus = 1,
          .poisson = poisson,
          .friction = 1,
          .creepage = reduced};
}

// FASTSIM as usually written: n strips of n cells, everything sampled; the force along rolling over mu N.
double sampled(const KalkerCoefficients& k, double x, int n) {
  double sum = 0;
  for (int j = 0; j < n; ++j) {
    const double y = -1 + (2.0 * j + 1) / n, l = std::sqrt(1 - y * y), h = 2 * l / n;
    double p = 0;
    for (int i = 0; i < n; ++i) {
      const double s = 1 - (2.0 * i + 1) / n;
      p = std::min(p + 0.375 * k.c11 * x * h, 2 / units::pi * l * l * (1 - s * s));
      sum += p * h * 2 / n;
    }
  }
  return sum;
}

void rows(report::Item& item) {
  item.columns({"cells", "full slip: sampled", "by means", "error at X = 0.2: sampled", "by means",
                "error with spin, by means"});
  const auto k = kalker_table(axis_ratio, poisson);
  const auto c = unit(axis_ratio, {0.2, 0, 0}), slid = unit(axis_ratio, {50, 0, 0}),
             spun = unit(axis_ratio, {0.1, 0.1, 0.5});
  const double exact = fastsim(c, k).fx;
  const auto fine = fastsim_grid(spun, k, {.along = 480, .strips = 480});
  const auto off = [&](const CreepForces& f) { return std::hypot(f.fx - fine.fx, f.fy - fine.fy); };
  item.explained("our own study of FASTSIM; not in the paper");
  item.expect_checks(6);
  double spin_error[2] = {};
  for (const int n : {5, 10, 20, 40, 80}) {
    const FastsimOptions cells{.along = n, .strips = n};
    const double full = fastsim_grid(slid, k, cells).fx, ours = fastsim_grid(c, k, cells).fx;
    const double spin = off(fastsim_grid(spun, k, cells));
    if (n == 20) spin_error[0] = spin;
    if (n == 80) spin_error[1] = spin;
    item.add_row({fmt::format("{0} × {0}", n), fmt::format("{:.5f}", sampled(k, 50, n)),
                  fmt::format("1 {:+.0e}", full - 1),
                  fmt::format("{:.1e}", sampled(k, 0.2, n) - exact),
                  fmt::format("{:.1e}", ours - exact), fmt::format("{:.1e}", spin)});
    item.agree(fmt::format("full-slip-{}", n),
               fmt::format("force of full slip, {0} × {0} cells", n), "", full, 1.0, 1e-12,
               "the friction bound");
  }
  item.agree("order", "error with spin, 20 cells over 80, to the power 1/2", "",
             std::sqrt(spin_error[0] / spin_error[1]), 4.0, 0.35, "second order in the cell");
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();
const char* holds(double error, double allowed) {
  return error <= allowed ? "holds" : "fails";
}

void ends(report::Item& item) {
  const auto k = kalker_table(axis_ratio, poisson);
  const Theory theories[] = {Theory::shen_hedrick_elkins, Theory::fastsim, Theory::fastrip,
                             Theory::polach};
  double small = 0, large = 0, mirrored = 0, over = 0;
  for (const Theory theory : theories) {
    for (double x = 1e-15; x < 2e-9; x *= 10)
      small = std::max(
          small,
          std::abs(creep_forces(theory, unit(axis_ratio, {x, 0, 0}), k).fx / (k.c11 * x) - 1));
    large =
        std::max(large, std::abs(creep_forces(theory, unit(axis_ratio, {1e12, 0, 0}), k).fx - 1));
    for (double x = 1e-3; x < 100; x *= 1.7) {
      const auto f = creep_forces(theory, unit(axis_ratio, {x, x / 3, 0}), k),
                 g = creep_forces(theory, unit(axis_ratio, {-x, -x / 3, 0}), k);
      mirrored = std::max(mirrored, std::hypot(f.fx + g.fx, f.fy + g.fy));
      over = std::max(over, std::hypot(f.fx, f.fy) - 1);
    }
  }
  item.stability("fast-small", "fast theories, X from 1e-15 to 1e-9", "1 - (1 - x)^3 cancels",
                 "the linear force to its digits", small, holds(small, 1e-8));
  item.stability("fast-large", "fast theories, X = 1e12", "inf/inf in directions and fractions",
                 "full slip", large, holds(large, 1e-11));
  item.stability("fast-mirror", "fast theories, all creepages reversed", "signs in the formulas",
                 "the force reversed", mirrored, holds(mirrored, 1e-14));
  item.stability("fast-bound", "fast theories, X from 1e-3 to 100", "|F| <= mu N", "never passed",
                 std::max(over, 0.0), holds(over, 1e-14));
  auto free = unit(axis_ratio, {0.1, 0.2, 0});
  free.friction = 0;
  double force = 0;
  for (const Theory theory : theories) force += std::abs(creep_forces(theory, free, k).fx);
  item.stability("fast-frictionless", "fast theories, friction 0", "0/0 in the reduced creepage",
                 "no force, no stick", force, holds(force, 0));
  const auto spun = fastsim_grid(unit(axis_ratio, {0, 0, 1e9}), k);
  item.stability("fastsim-spin", "FASTSIM, reduced spin 1e9", "the slip turns fully within a cell",
                 "force returns to zero", std::hypot(spun.fx, spun.fy),
                 holds(std::hypot(spun.fx, spun.fy), 5e-3));
  const auto she = shen_hedrick_elkins(unit(axis_ratio, {0, 0, 1e9}), k);
  item.stability("she-spin", "Shen-Hedrick-Elkins, reduced spin 1e9", "not made for large spin",
                 "stays at full force; the truth is zero", she.fy, "degraded");
  std::string said = "not refused";
  try {
    (void)kalker_table(20, poisson);
  } catch (const InputError& error) {
    said = error.what();
  }
  item.stability("table-range", "Kalker's table at a/b = 20", "beyond its last row", said, none,
                 said == "not refused" ? "fails" : "refused");
}

void both(report::Item& item) {
  rows(item);
  ends(item);
}

}  // namespace

void creep_chapter::add_fastsim_cells(report::Chapter& chapter) {
  chapter.table("table-fastsim", "FASTSIM on cells: bound sampled, and by its means", both);
}
