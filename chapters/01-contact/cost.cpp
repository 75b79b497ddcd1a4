#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "bench/work_precision.hpp"
#include "contact/cg_fft.hpp"
#include "contact/countact.hpp"
#include "contact/hertz.hpp"
#include "contact/uniform_dense.hpp"
#include "items.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

/***
Example 1 has a closed form, so every error below is a true error. Three ways of solving the same integral
equation (8) compete on it:

* **COUNTACT-2**, the paper's method: a mesh fitted to the region, a dense matrix, a few refits.
* **Dense, uniform grid**: equal cells over the interpenetration curve, a dense matrix for the cells in contact; cells leave and
  join until pressure and gap are both right.
* **CG-FFT**: equal cells too, but the sum (14) over all cells is a convolution, so that one product with the matrix
  costs $n \log n$; conjugate gradients that keep $p \ge 0$ do the rest. *Raw* is the sum over the cells of the finest grid;
  *remedied* is the limit estimated from that grid and the two before it.

The pixelised edge is what limits a uniform grid. Each cell is in or out, so the edge is wrong by part of a cell,
and the force by a term $c\,h^2$ plus an irregular one, of order $h^{2.5}$, that jumps as the edge moves over the cells.
Most of the irregular part comes from the four places where the edge runs parallel to the cells, and its sign depends on
where in a cell the edge lies there. The grids are therefore placed such that the edge cuts the outermost cells at 0.9 of their length
at the $x$ ends and at 0.4 at the $y$ ends, half a period apart, so that the parts cancel; what remains is smooth
enough to be extrapolated.

{{cost-force}}

The force of COUNTACT converges with order {{order-countact}} in the number of columns, that of the raw grid with
order {{order-raw}} in the number of cells across. The remedy divides its error by {{gain}} (geometric mean over the grids). What is
left is irregular, so that a single grid may be lucky, and no order can be claimed for it; the solver's own estimate of its
error was above the true one on {{covered}} grids.
A relative error of $10^{-5}$ in $F$, by the cheapest setting from which on every finer one has it too, takes {{time-countact}} with COUNTACT,
{{time-dense}} with the dense grid, {{time-raw}} with the raw and {{time-remedied}} with the remedied CG-FFT. For three digits
COUNTACT is as good as any: its refitted mesh spends no cells outside the contact.

{{cost-peak}}

The peak pressure is where the grid does best: it lies far from the edge, and its error is smooth.

{{cost-axis}}

The semi-axis is first order in all methods, because the pressure falls to zero with a vertical tangent and the
last cell decides. COUNTACT continues the pressure outward by a parabola; the grid continues $p^2$, which is smooth across the edge, takes
the extreme of a curve through many rows, and its remedy extrapolates that over the grids (with order 1.25, as measured).

The work count is each method's own: unknowns squared, summed over the solves, for the dense ones, and points transformed for
CG-FFT. They compare a method with itself, not with another.

{{work-precision: cost}}
*/

namespace {

RelativeCurvature curvature() {
  return relative_curvature({1 / crown_radius, 0}, {-1 / tread_radius, 1 / wheel_radius});
}

Gap gap_1() {
  return rail_wheel_gap({.wheel_radius = wheel_radius,
                         .wheel_profile_radius = tread_radius,
                         .rail_radius_left = crown_radius,
                         .rail_radius_right = crown_radius});
}

bench::Outcome outcome(const NormalContact& c) {
  return {.values = {c.force, c.p_max, 0.5 * (c.x_max - c.x_min), 0.5 * (c.y_max - c.y_min)},
          .work = static_cast<double>(c.work),
          .converged = c.converged,
          .reason = c.reason};
}

bench::Outcome by_countact(int n, double modulus) {
  CountactOptions options;
  options.columns = uniform_columns(n);
  options.rows = n;
  return outcome(countact_2(gap_1(), delta_1, modulus, options).contact);
}

bench::Outcome by_dense(int n, double modulus) {
  const Gap gap = gap_1();
  const Box box = interpenetration_box(gap, delta_1);
  const Grid grid{box.x_min, box.y_min, (box.x_max - box.x_min) / n, (box.y_max - box.y_min) / n,
                  n,         n};
  return outcome(solve_uniform_dense(grid, sample(gap, grid), delta_1, modulus));
}

bench::Outcome by_cg_fft(int n, double modulus, bool remedy) {
  CgFftOptions options;
  options.nx = options.ny = n;
  options.remedy = remedy;
  return outcome(solve_cg_fft(gap_1(), delta_1, modulus, options).contact);
}

bench::Method sweep(const char* name, const std::vector<int>& sizes,
                    const std::function<bench::Outcome(int)>& run) {
  bench::Method method{name, {}};
  for (const int n : sizes) method.settings.push_back({std::to_string(n), [=] { return run(n); }});
  return method;
}

constexpr const char* countact_name = "COUNTACT-2";
constexpr const char* dense_name = "dense uniform grid";
constexpr const char* raw_name = "CG-FFT raw";
constexpr const char* remedied_name = "CG-FFT remedied";

const std::vector<report::WorkPrecision>& measured(const report::Item& item) {
  static const auto points = [&] {
    const double modulus = effective_modulus(steel);
    const HertzContact exact = hertz_from_approach(curvature(), modulus, delta_1);
    std::vector<int> grids{32, 45, 64, 90, 128, 181, 255};
    std::vector<int> columns{5, 7, 9, 13, 19, 25, 35};
    if (item.full())
      grids.insert(grids.end(), {362, 511, 724, 1023}), columns.insert(columns.end(), {49, 69});
    constexpr double closed_form = 1e-13;
    return bench::measure(
        "cost",
        {{"F", exact.force, closed_form},
         {"p0", exact.p_max, closed_form},
         {"a", exact.a, closed_form},
         {"b", exact.b, closed_form}},
        {sweep(countact_name, columns, [=](int n) { return by_countact(n, modulus); }),
         sweep(dense_name, {9, 13, 19, 27, 38}, [=](int n) { return by_dense(n, modulus); }),
         sweep(raw_name, grids, [=](int n) { return by_cg_fft(n, modulus, false); }),
         sweep(remedied_name, grids, [=](int n) { return by_cg_fft(n, modulus, true); })},
        item.timings(), 0.1);
  }();
  return points;
}

// A run that did not converge has NaN, which must not be compared: that is trapped.
bool has_error(const report::WorkPrecision& point) {
  return !std::isnan(point.error) && point.error > 0;
}

// Least-squares slope of -log(error) over log(setting): the order in the number of cells across.
double order(const std::vector<report::WorkPrecision>& points, const std::string& method) {
  double s = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const report::WorkPrecision& point : points) {
    if (point.method != method || point.quantity != "F" || !has_error(point)) continue;
    const double x = std::log(std::stod(point.setting)), y = -std::log(point.error);
    s += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (s * sxy - sx * sy) / (s * sxx - sx * sx);
}

// Time of the cheapest setting from which on the error in F stays at or below 1e-5; NaN when there is none.
double time_to_five_digits(const std::vector<report::WorkPrecision>& points,
                           const std::string& method) {
  double time = std::numeric_limits<double>::quiet_NaN();
  for (const report::WorkPrecision& point : points) {
    if (point.method != method || point.quantity != "F") continue;
    if (std::isnan(point.error) || point.error > 1e-5)
      time = std::numeric_limits<double>::quiet_NaN();
    else if (std::isnan(time))
      time = point.seconds_min;
  }
  return time;
}

// Geometric mean over the grids of the raw error of the force over the remedied one.
double gain(const std::vector<report::WorkPrecision>& points) {
  double sum = 0, count = 0;
  for (const report::WorkPrecision& point : points) {
    if (point.quantity != "F" || !has_error(point)) continue;
    if (point.method == raw_name) sum += std::log(point.error), count += 1;
    if (point.method == remedied_name) sum -= std::log(point.error);
  }
  return std::exp(sum / count);
}

// On how many grids the solver's estimate of the error of the force was above the true error.
std::string covered() {
  const double modulus = effective_modulus(steel);
  const double exact = hertz_from_approach(curvature(), modulus, delta_1).force;
  int good = 0, all = 0;
  for (int n = 32; n <= 160; n += 8, ++all) {
    CgFftOptions options;
    options.nx = options.ny = n;
    const NormalContact c = solve_cg_fft(gap_1(), delta_1, modulus, options).contact;
    good += std::abs(c.force / exact - 1) <= c.force_error;
  }
  return fmt::format("{} of {}", good, all);
}

void cost_force(report::Item& item) {
  const auto& points = measured(item);
  bench::show(item, points, "F");
  item.value("order-countact", order(points, countact_name), "", "{:.1f}");
  item.value("order-raw", order(points, raw_name), "", "{:.1f}");
  item.value("gain", gain(points), "", "{:.0f}");
  item.value("covered", covered());
  const auto time = [&](const char* id, const char* method) {
    const double t = time_to_five_digits(points, method);
    item.value(id, !item.timings() ? "(not timed)"
                   : std::isnan(t) ? "more than was tried"
                                   : fmt::format("{:.3g} ms", 1e3 * t));
  };
  time("time-countact", countact_name);
  time("time-dense", dense_name);
  time("time-raw", raw_name);
  time("time-remedied", remedied_name);
  item.reconstructed(
      "not in the paper: our own study of methods; its one time is 5.7 s on an IBM 370/168");
}

}  // namespace

void contact_chapter::add_cost(report::Chapter& chapter) {
  chapter.figure("cost-force", "Error of the force against cost, Example 1", cost_force);
  chapter.figure("cost-peak", "Error of the peak pressure against cost, Example 1",
                 [](report::Item& item) {
                   bench::show(item, measured(item), "p0");
                   item.reconstructed("not in the paper: our own study of methods");
                 });
  chapter.figure("cost-axis", "Error of the longer semi-axis against cost, Example 1",
                 [](report::Item& item) {
                   bench::show(item, measured(item), "a");
                   item.reconstructed("not in the paper: our own study of methods");
                 });
}
