#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>

#include "contact/cg_fft.hpp"
#include "contact/countact.hpp"
#include "contact/hertz.hpp"
#include "contact/punch.hpp"
#include "contact/uniform_dense.hpp"
#include "items.hpp"
#include "num/roots.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

/***
Every row of the table below is computed when this page is made; "refused" means that a clear error is the right answer.

Long patches are the classic danger: near line contact the elliptic integrals lose all digits if they are asked for $1 - (b/a)^2$,
a logarithm with $y + r$ loses them for slender cells, and an iteration may need as many steps as the patch is long. Here the
integrals take $(b/a)^2$ itself, the cells have the form with asinh and the shape of the patch, and the conjugate gradients have a
preconditioner: the matrix acts like a convolution with $1/r$, whose transform is $1/|k|$, so multiplying by $|k|$ on the grid
nearly inverts it. The iterations for $10^{-8}$ on the finest grid, started from the next coarser one:

{{extremes}}
*/

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
const double modulus = effective_modulus(steel);

const char* status(double error, double allowed) {
  return error <= allowed ? "holds" : "fails";
}

Gap example_1() {
  return rail_wheel_gap({wheel_radius, tread_radius, crown_radius, crown_radius});
}
Gap example_2() {
  return rail_wheel_gap({wheel_radius, tread_radius, crown_radius, corner_radius});
}
HertzContact exact_1(double approach) {
  return hertz_from_approach(
      relative_curvature({1 / crown_radius, 0}, {-1 / tread_radius, 1 / wheel_radius}), modulus,
      approach);
}

CgFft by_grid(const Gap& gap, double approach, Eigen::Index nx, Eigen::Index ny,
              bool precondition = true) {
  CgFftOptions options;
  options.nx = nx, options.ny = ny;
  options.cg.precondition = precondition;
  options.cg.most_iterations = 10000;
  return solve_cg_fft(gap, approach, modulus, options);
}

// The ratio of curvatures whose ellipse has the axis ratio wanted.
double curvature_ratio(double axis_ratio) {
  const auto miss = [&](double log_ratio) {
    const HertzContact h = hertz_from_approach({1, std::exp(log_ratio), 0}, modulus, 1e-5);
    return std::log(h.b / h.a / axis_ratio);
  };
  return std::exp(num::find_root(miss, 0, 60, 1e-14).x);
}

void slender(report::Item& item, double axis_ratio, const char* name) {
  const double ratio = curvature_ratio(axis_ratio), delta = 1e-5;
  const HertzContact h = hertz_from_approach({1, ratio, 0}, modulus, delta);
  // Near line contact A/B -> (b/a)^2 (ln(4 a/b) - 1), with an error of order (b/a)^2 ln(a/b).
  const double limit = 1 / (axis_ratio * axis_ratio * (std::log(4 / axis_ratio) - 1));
  const double closed = std::abs(ratio / limit - 1);
  item.stability(fmt::format("slender-hertz-{}", name), fmt::format("b/a = {}, closed form", name),
                 "elliptic integrals near line contact; against their asymptote",
                 fmt::format("ratio of curvatures {:.6e}", ratio), closed,
                 status(closed, 10 * axis_ratio * axis_ratio * std::log(1 / axis_ratio)));
  const CgFft grid = by_grid(quadratic_gap({1, ratio, 0}), delta, 127, 127);
  const double error = std::abs(grid.contact.force / h.force - 1);
  item.stability(fmt::format("slender-{}", name), fmt::format("b/a = {}, CG-FFT 127 x 127", name),
                 "cells as slender as the patch, iterations",
                 fmt::format("{} iterations", grid.levels.back().iterations), error,
                 status(error, 2e-5));
}

void curvature_jump(report::Item& item) {
  CgFftOptions on_edge;
  on_edge.edge_x = 0;
  on_edge.nx = on_edge.ny = 362;
  const double reference = solve_cg_fft(example_2(), delta_2, modulus, on_edge).contact.force;
  on_edge.nx = on_edge.ny = 128;
  const NormalContact edge = solve_cg_fft(example_2(), delta_2, modulus, on_edge).contact;
  CgFftOptions off = on_edge;
  off.edge_x.reset();
  const NormalContact loose = solve_cg_fft(example_2(), delta_2, modulus, off).contact;
  const double error = std::abs(edge.force / reference - 1);
  item.stability(
      "jump", "Example 2, 128 x 128, a cell edge on x = 0",
      "slope of the pressure is infinite at the jump; against 362 x 362",
      fmt::format("F = {:.2f} lbf, claimed error {:.0e}", edge.force / lbf, edge.force_error),
      error, status(error, edge.force_error));
  const double loose_error = std::abs(loose.force / reference - 1);
  item.stability(
      "jump-off", "the same, the edge where it falls", "the jump within a cell",
      fmt::format("F = {:.2f} lbf, claimed error {:.0e}", loose.force / lbf, loose.force_error),
      loose_error, status(loose_error, loose.force_error));
}

void sharp_punch(report::Item& item) {
  const RoundedPunch shape{.flat_radius = 0.5 * inch, .edge_radius = 0};
  const double exact = punch_from_approach(shape, modulus, delta_4).force;
  const NormalContact coarse = by_grid(rounded_punch_gap(shape), delta_4, 64, 64).contact;
  const NormalContact fine = by_grid(rounded_punch_gap(shape), delta_4, 256, 256).contact;
  const double rate = std::log(fine.p_max / coarse.p_max) / std::log(coarse.dx[0] / fine.dx[0]);
  const bool told = fine.reason.find("singular") != std::string::npos;
  item.stability("sharp-punch", "flat punch with a sharp edge, 256 x 256",
                 "infinite pressure at the edge",
                 fmt::format("{}; p_max grows as h^-{:.2f}; the error is that of F",
                             told ? "reported as singular" : "not reported", rate),
                 std::abs(fine.force / exact - 1), told ? "degraded" : "fails");
}

void tiny(report::Item& item) {
  const double delta = 1e-12 * inch;
  const HertzContact h = exact_1(delta);
  const NormalContact grid = by_grid(example_1(), delta, 127, 127).contact;
  const double error = std::abs(grid.force / h.force - 1);
  item.stability("tiny", "approach of 1e-12 in, CG-FFT 127 x 127", "absolute thresholds, underflow",
                 fmt::format("F = {:.5e} lbf", grid.force / lbf), error, status(error, 2e-5));
  CountactOptions options;
  options.columns = uniform_columns(13), options.rows = 13;
  const NormalContact small = countact_2(example_1(), delta, modulus, options).contact;
  const NormalContact usual = countact_2(example_1(), delta_1, modulus, options).contact;
  const double scaled = std::abs(small.force / usual.force * std::pow(delta_1 / delta, 1.5) - 1);
  item.stability("tiny-countact", "approach of 1e-12 in, COUNTACT-2", "F ~ delta^1.5 exactly",
                 fmt::format("F = {:.5e} lbf", small.force / lbf), scaled, status(scaled, 1e-10));
}

void grids(report::Item& item) {
  const double exact = exact_1(delta_1).force;
  const auto one = [&](const char* id, const char* what, const char* stress, Eigen::Index nx,
                       Eigen::Index ny) {
    const CgFft grid = by_grid(example_1(), delta_1, nx, ny);
    const double error = std::abs(grid.contact.force / exact - 1);
    item.stability(id, fmt::format("{} of {} x {} cells", what, nx, ny), stress,
                   fmt::format("{} iterations, {:.2f} GB", grid.levels.back().iterations,
                               memory_needed(nx, ny) / 1e9),
                   error, status(error, grid.contact.force_error));
  };
  one("prime", "grid", "prime numbers, slow transforms", 251, 257);
  const Eigen::Index huge = item.full() ? 2048 : 512;
  one("huge", "grid", "memory, rounding in long sums", huge, huge);
  one("oblong", "grid", "cells some 17 times as long as wide", 64, 512);
}

// COUNTACT's own failures: it must say that it failed.
void boundary_update(report::Item& item) {
  const auto told = [&](const char* id, const char* what, const char* stress,
                        const NormalContact& c, const char* word) {
    const bool good = !c.converged && c.reason.find(word) != std::string::npos;
    item.stability(id, what, stress, c.converged ? "converged" : c.reason, none,
                   good ? "refused" : "fails");
  };
  CountactOptions nine;
  nine.damped = false;
  told("nine-columns", "Example 2 with nine uniform columns",
       "too few columns on the narrow side of the jump",
       countact_1(example_2(), delta_2, modulus, nine).contact, "collapsed");
  CountactOptions parabola;
  parabola.columns = uniform_columns(13), parabola.rows = 13;
  parabola.fit = Fit::three_points, parabola.damped = false;
  told("parabola", "Example 1, three-point parabola as it comes",
       "it bends back; each outward move feeds the next",
       countact_2(example_1(), delta_1, modulus, parabola).contact, "diverged");
  parabola.inward_only = true;
  const NormalContact clamped = countact_2(example_1(), delta_1, modulus, parabola).contact;
  item.stability("parabola-inward", "the same, never moved outward",
                 "an undershoot cannot be undone; error of a",
                 clamped.converged ? "converges, too small" : clamped.reason,
                 std::abs(clamped.x_max / exact_1(delta_1).a - 1), "degraded");
}

void odd_input(report::Item& item) {
  double force = 0;
  bool empty = true;
  for (const NormalContact& c : {solve_cg_fft(example_1(), 0, modulus).contact,
                                 countact_2(example_1(), 0, modulus).contact}) {
    force += std::abs(c.force);
    empty = empty && c.converged && c.p.size() == 0;
  }
  item.stability("empty", "approach 0, CG-FFT and COUNTACT-2", "no cell in contact",
                 empty_contact_reason, force, empty && force == 0 ? "holds" : "fails");
  const Grid grid{0, 0, 1e-3, 1e-3, 3, 3};
  Eigen::VectorXd f = Eigen::VectorXd::Constant(9, 1.0);
  f[4] = 0;
  const CgFft cell = solve_cg_fft(grid, f, 1e-6, modulus);
  // A square of side c under pressure p sinks by 4 c asinh(1) k p at its centre.
  const double alone = 1e-6 * units::pi * modulus * 1e-3 / (4 * std::asinh(1.0));
  const double error = std::abs(cell.contact.force / alone - 1);
  item.stability("one-cell", "one cell in contact", "no neighbours for any fit",
                 fmt::format("F = {:.6g} N", cell.contact.force), error, status(error, 1e-7));
  const auto refused = [&](const char* id, const char* what, const char* stress,
                           const std::function<void()>& attempt) {
    try {
      attempt();
      item.stability(id, what, stress, "not refused", none, "fails");
    } catch (const InputError& e) {
      item.stability(id, what, stress, e.what(), none, "refused");
    }
  };
  refused("nan", "a gap with NaN in it", "NaN passes comparisons", [] {
    (void)solve_cg_fft([](double x, double y) { return x > 1e-3 ? none : x * x + y * y; }, 1e-4,
                       modulus);
  });
  refused("conforming", "bodies with equal curvature", "the patch has no end",
          [] { (void)solve_cg_fft([](double, double y) { return y * y; }, 1e-4, modulus); });
  refused("dense-memory", "dense matrix of 512 x 512 cells", "n^2 numbers", [] {
    const Grid large{-1, -1, 1. / 256, 1. / 256, 512, 512};
    (void)solve_uniform_dense(large, Eigen::VectorXd::Zero(large.cells()), 1, modulus);
  });
  refused("grid-memory", "grid of 100 000 x 100 000 cells", "memory",
          [] { (void)by_grid(example_1(), delta_1, 100000, 100000); });
}

void extremes(report::Item& item) {
  item.columns({"b/a", "cells", "with preconditioner", "without"});
  for (const double axis_ratio : {1.0, 1e-2, 1e-4, 1e-6})
    for (const Eigen::Index n : {48, 96, item.full() ? 384 : 192}) {
      const Gap gap = quadratic_gap({1, axis_ratio == 1 ? 1 : curvature_ratio(axis_ratio), 0});
      const auto iterations = [&](bool precondition) {
        return fmt::format("{}", by_grid(gap, 1e-5, n, n, precondition).levels.back().iterations);
      };
      item.add_row({fmt::format("{:g}", axis_ratio), fmt::format("{} x {}", n, n), iterations(true),
                    iterations(false)});
    }
  slender(item, 1e-4, "1e-4");
  slender(item, 1e-6, "1e-6");
  curvature_jump(item);
  sharp_punch(item);
  tiny(item);
  grids(item);
  boundary_update(item);
  odd_input(item);
  item.reconstructed("not in the paper: our own study of methods");
}

}  // namespace

void contact_chapter::add_extremes(report::Chapter& chapter) {
  chapter.table("extremes", "Iterations against slenderness and grid", extremes);
}
