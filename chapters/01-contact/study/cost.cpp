/*** ### The force of Example 1

Hertz's closed form makes every error a true error. Three ways of solving (8):

* **COUNTACT-2**, the paper's: a mesh fitted to the region, a dense matrix, a few refits.
* **Dense, uniform grid**: equal cells over the interpenetration curve, a dense matrix for the cells in contact; cells leave and join until pressure and gap are both right.
* **CG-FFT**: equal cells too, but the sum (14) over all cells is a convolution, so that one product with the matrix costs $n\log n$; conjugate gradients that keep $p\ge0$ do the
  rest. *Raw* is the sum over the cells of the finest grid; *remedied* is the limit estimated from that grid and the two before it.

{{cost-force}}

The force of COUNTACT converges with order {{order-countact}} in the number of columns, that of the raw grid with order {{order-raw}} in the number of cells across. What limits a uniform
grid is its pixelised edge: each cell is in or out, so the force is off by a term $c\,h^2$ and an irregular one, of order $h^{2.5}$, that jumps as the edge moves over the cells.
The grids are placed such that most of the irregular part cancels, and the rest is smooth enough to be extrapolated: the remedied error is smaller by a median factor of {{gain}}. It stays
irregular, so that a single grid may be lucky, and no order can be claimed for it. The solver's own estimate was above the true error on {{covered}} grids.

At an error of $10^{-3}$ in $F$ the cheapest method is {{cheapest-3}}; at $10^{-5}$, held on every finer setting too, {{cheapest-5}}.

{{work-precision: cost-force}}

### The peak under the rounded punch

On Example 4 the closed form is the reference again. Symmetry is worth a great deal: a few dozen rings beat a grid of thousands of cells. Where the rings are is worth as much: the peak
sits in a strip of a fortieth of the radius.

{{cost-punch-peak}}

Equal rings are refused by COUNTAXI itself as long as too few of them lie between the peak and the boundary to find it. The peak of CG-FFT is poor, and said to be so,
until a cell is smaller than the strip.

{{work-precision: cost-punch-peak}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/work_precision.hpp"
#include "contact/cg_fft.hpp"
#include "contact/countaxi.hpp"
#include "contact/hertz.hpp"
#include "contact/punch.hpp"
#include "contact/uniform_dense.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

bench::Outcome force_of(const NormalContact& c) {
  return {{c.force}, static_cast<double>(c.work), c.converged, c.converged ? "" : c.reason};
}

bench::Outcome by_countact(int n) {
  CountactOptions options;
  options.columns = uniform_columns(n);
  options.rows = n;
  return force_of(countact_2(rail_wheel_gap(on_the_crown()), delta_1, modulus, options).contact);
}

bench::Outcome by_dense(int n) {
  const Gap gap = rail_wheel_gap(on_the_crown());
  const Box box = interpenetration_box(gap, delta_1);
  const Grid grid{box.x_min, box.y_min, (box.x_max - box.x_min) / n, (box.y_max - box.y_min) / n,
                  n,         n};
  return force_of(solve_uniform_dense(grid, sample(gap, grid), delta_1, modulus));
}

NormalContact on_grid(const Gap& gap, double approach, int n, bool remedy) {
  CgFftOptions options;
  options.nx = options.ny = n;
  options.remedy = remedy;
  return solve_cg_fft(gap, approach, modulus, options).contact;
}

bench::Method grids(const char* name, const std::vector<int>& sizes, bool remedy) {
  return bench::sweep(name, sizes, [=](int n) {
    return force_of(on_grid(rail_wheel_gap(on_the_crown()), delta_1, n, remedy));
  });
}

constexpr const char* raw = "CG-FFT raw";
constexpr const char* remedied = "CG-FFT remedied";

double exact_force() {
  return hertz_from_approach(
             relative_curvature({1 / crown_radius, 0}, {-1 / tread_radius, 1 / wheel_radius}),
             modulus, delta_1)
      .force;
}

// Median over the grids of the raw error of the force over the remedied one.
double median_gain(const std::vector<report::WorkPrecision>& points) {
  std::vector<double> gains;
  for (const report::WorkPrecision& a : points)
    for (const report::WorkPrecision& b : points)
      if (a.method == raw && b.method == remedied && a.setting == b.setting && b.error > 0)
        gains.push_back(a.error / b.error);
  std::ranges::sort(gains);
  return gains.empty() ? units::nan : gains[gains.size() / 2];
}

// The method and setting that takes least time to an error that every later setting of it keeps, too.
std::string cheapest(const std::vector<report::WorkPrecision>& points, double error) {
  std::string name, first_good;
  double least = units::no_limit, time = units::no_limit;
  const auto close = [&] {
    if (time < least) least = time, name = first_good;
    time = units::no_limit;
  };
  std::string method;
  for (const report::WorkPrecision& p : points) {
    if (p.method != method) close(), method = p.method;
    if (!p.converged || !(p.error <= error))
      time = units::no_limit;
    else if (std::isinf(time))
      time = p.seconds_min,
      first_good = fmt::format("{} at {} ({:.2g} ms)", p.method, p.setting, 1e3 * p.seconds_min);
  }
  close();
  return name.empty() ? "none that was tried" : name;
}

// On how many grids the solver's estimate of the error of the force was above the true error.
std::string covered() {
  int good = 0, all = 0;
  for (int n = 32; n <= 160; n += 8, ++all) {
    const NormalContact c = on_grid(rail_wheel_gap(on_the_crown()), delta_1, n, true);
    good += std::abs(c.force / exact_force() - 1) <= c.force_error;
  }
  return fmt::format("{} of {}", good, all);
}

void cost_force(report::Item& item) {
  std::vector<int> cells{12, 17, 24, 34, 48, 68, 96, 136, 192, 255},
      columns{5, 7, 9, 13, 19, 25, 35};
  if (item.full()) cells.insert(cells.end(), {362, 511, 724}), columns.push_back(49);
  const auto points =
      bench::figure(item, {"F", exact_force(), 1e-13},
                    {bench::sweep("COUNTACT-2", columns, by_countact),
                     bench::sweep("dense uniform grid", {9, 13, 19, 27, 38}, by_dense),
                     grids(raw, cells, false), grids(remedied, cells, true)},
                    0.1);
  // Work is unknowns squared, columns to the fourth power, and points transformed.
  item.value("order-countact", -4 * bench::observed_slope(points, "F", "COUNTACT-2"), "", "{:.1f}");
  item.value("order-raw", -2 * bench::observed_slope(points, "F", raw), "", "{:.1f}");
  item.value("gain", median_gain(points), "", "{:.0f}");
  item.value("covered", covered());
  item.value("cheapest-3", item.timings() ? cheapest(points, 1e-3) : "(not timed)");
  item.value("cheapest-5", item.timings() ? cheapest(points, 1e-5) : "(not timed)");
  item.added("a study of methods; the paper's one time is 5.7 s on an IBM 370/168");
}

bench::Outcome by_rings(int rings, double grading) {
  CountaxiOptions options;
  options.rings = rings;
  options.grading = grading;
  const RingContact c = countaxi(rounded_punch_gap(stamp), delta_4, modulus, options);
  return {{c.p_max}, static_cast<double>(c.work), c.converged, c.reason};
}

void cost_punch_peak(report::Item& item) {
  const std::vector<int> rings{10, 20, 40, 80, 160, 240};
  bench::figure(
      item, {"p_max", punch_peak(punch_from_approach(stamp, modulus, delta_4)).pressure, 1e-10},
      {bench::sweep("COUNTAXI equal rings", rings, [](int n) { return by_rings(n, 1); }),
       bench::sweep("COUNTAXI graded rings", rings, [](int n) { return by_rings(n, 3); }),
       bench::sweep(
           "CG-FFT remedied", {45, 90, 181, 255},
           [](int n) {
             const NormalContact c = on_grid(rounded_punch_gap(stamp), delta_4, n, true);
             return bench::Outcome{{c.p_max}, static_cast<double>(c.work), c.converged, ""};
           })},
      0.1);
  item.added("a study of methods");
}

}  // namespace

const report::Section cost{
    report::figure("cost-force", "Error of the force against cost, Example 1", cost_force),
    report::figure("cost-punch-peak", "Error of the peak pressure against cost, Example 4",
                   cost_punch_peak)};

}  // namespace railbook::contact_chapter
