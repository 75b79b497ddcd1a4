/*** All panels have the same axes: the error of one number against the time of the whole solution, grids of the ladder and refits included, on one core. Crosses at the top are answers refused.
What a user would take without this library is among the methods: equal cells over the overlap of the bodies and a dense matrix.

### Example 2: the rail's radius jumps

No closed form exists. The reference is CG-FFT on {{reference-cells}} cells; how far its neighbours of other sizes scatter is its uncertainty, and what is not 100 times larger is grey. By
another route, COUNTACT-1 on two meshes, continued to cells of no size, the force is the same within {{other-route}}.

{{cost-jump-force}}

{{cost-jump-force-answer}} Equal columns fail, which is what the paper's footnote on two widths is about. Raw sums of the grid are held up by their pixelised edge; the fit over three grids removes what is
regular in it.

{{cost-jump-peak}}

{{cost-jump-peak-answer}}

{{cost-jump-length}}

{{cost-jump-length-answer}}

{{work-precision: cost-jump-force}}

### Example 4: the rounded edge

The closed form is the reference. Symmetry is worth a great deal, and so is where the rings are: the peak sits in a strip of a fortieth of the radius.

{{cost-punch-force}}

{{cost-punch-force-answer}}

{{cost-punch-peak}}

{{cost-punch-peak-answer}} Equal rings are refused as long as too few of them lie between the peak and the boundary to find it.

{{cost-punch-length}}

{{cost-punch-length-answer}}

{{work-precision: cost-punch-force}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/work_precision.hpp"
#include "contact/cg_fft.hpp"
#include "contact/countaxi.hpp"
#include "contact/punch.hpp"
#include "contact/uniform_dense.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

constexpr int reference_cells = 400;

// What is asked of a contact: force, peak pressure, and length across the rail.
std::vector<double> wanted(const NormalContact& c) {
  return {c.force, c.p_max, c.x_max - c.x_min};
}

bench::Outcome outcome(const NormalContact& c) {
  return {wanted(c), static_cast<double>(c.work), c.converged, c.converged ? "" : c.reason};
}

NormalContact on_grid(const Gap& gap, double approach, int n, std::optional<double> edge = {},
                      bool remedy = true) {
  CgFftOptions options{n, n};
  options.edge_x = edge;
  options.remedy = remedy;
  return solve_cg_fft(gap, approach, modulus, options).contact;
}

// Equal cells over the overlap of the bodies, with two empty ones on each side.
NormalContact by_dense(const Gap& gap, double approach, int n) {
  const Box box = interpenetration_box(gap, approach);
  const double dx = (box.x_max - box.x_min) / (n - 4), dy = (box.y_max - box.y_min) / (n - 4);
  const Grid grid{box.x_min - 2 * dx, box.y_min - 2 * dy, dx, dy, n, n};
  return solve_uniform_dense(grid, sample(gap, grid), approach, modulus);
}

NormalContact by_columns(const Columns& columns, int rows) {
  return countact_1(on_the_jump(), delta_2, modulus, {columns, rows}).contact;
}

// One task by all methods: three quantities of the same runs, a panel each.
struct Study {
  std::vector<bench::Reference> references;
  std::vector<bench::Method> methods;
  std::vector<report::WorkPrecision> points = {};
};

// The reference and, as its uncertainty, the largest difference to grids of other sizes.
std::vector<bench::Reference> jump_references() {
  std::vector<bench::Reference> references{{"F"}, {"p_max"}, {"length"}};
  for (const int n : {reference_cells, 362, 330}) {
    const std::vector<double> found = wanted(on_grid(on_the_jump(), delta_2, n, 0));
    for (std::size_t q = 0; q < 3; ++q)
      if (n == reference_cells)
        references[q].value = found[q];
      else
        references[q].uncertainty =
            std::max(references[q].uncertainty, std::abs(found[q] / references[q].value - 1));
  }
  return references;
}

const Study& jump(const report::Item& item) {
  static const Study study = [&] {
    const auto grids = [](bool remedy) {
      return [=](int n) { return outcome(on_grid(on_the_jump(), delta_2, n, 0, remedy)); };
    };
    Study s{jump_references(),
            {bench::sweep("COUNTACT-1 equal columns", {9, 15, 21, 31},
                          [](int n) { return outcome(by_columns(uniform_columns(n), n)); })
                 .counts("unknowns squared"),
             bench::sweep("COUNTACT-1 graded columns", {10, 15, 20, 30},
                          [](int n) {
                            const Columns columns = graded_columns(3 * n / 5, 2 * n / 5);
                            return outcome(by_columns(columns, n / 2 * 2 - 1));
                          })
                 .counts("unknowns squared"),
             bench::sweep("dense matrix", {9, 13, 19, 27, 38},
                          [](int n) { return outcome(by_dense(on_the_jump(), delta_2, n)); })
                 .counts("unknowns squared"),
             bench::sweep("CG-FFT raw", {12, 17, 24, 34, 48, 68, 96, 136, 192, 255}, grids(false))
                 .counts("points transformed"),
             bench::sweep("CG-FFT", {12, 17, 24, 34, 48, 68, 96, 136, 192, 255}, grids(true))
                 .counts("points transformed")}};
    s.points = bench::measure("cost-jump-force", s.references, s.methods, item.timings(), 0.05);
    return s;
  }();
  return study;
}

const Study& punch(const report::Item& item) {
  static const Study study = [&] {
    const Gap gap = rounded_punch_gap(stamp);
    const PunchContact exact = punch_from_approach(stamp, modulus, delta_4);
    const auto rings = [=](double grading) {
      return [=](int n) {
        CountaxiOptions options;
        options.rings = n, options.grading = grading;
        const RingContact c = countaxi(gap, delta_4, modulus, options);
        return bench::Outcome{
            {c.force, c.p_max, 2 * c.radius}, static_cast<double>(c.work), c.converged, c.reason};
      };
    };
    Study s{{{"F", exact.force, 1e-13},
             {"p_max", punch_peak(exact).pressure, 1e-10},
             {"length", 2 * exact.radius, 1e-13}},
            {bench::sweep("COUNTAXI equal rings", {10, 20, 40, 80, 160, 240}, rings(1))
                 .counts("unknowns squared"),
             bench::sweep("COUNTAXI graded rings", {10, 20, 40, 80, 160, 240}, rings(3))
                 .counts("unknowns squared"),
             bench::sweep("dense matrix", {9, 13, 19, 27, 38},
                          [=](int n) { return outcome(by_dense(gap, delta_4, n)); })
                 .counts("unknowns squared"),
             bench::sweep("CG-FFT", {17, 24, 34, 48, 68, 96, 136, 192, 255}, [=](int n) {
               return outcome(on_grid(gap, delta_4, n));
             }).counts("points transformed")}};
    s.points = bench::measure("cost-punch-force", s.references, s.methods, item.timings(), 0.05);
    return s;
  }();
  return study;
}

void panel(report::Item& item, const Study& study, const std::string& quantity) {
  bench::show(item, study.points, quantity, study.methods, {1e-8, 1, 1e-5, 3});
  item.value(item.id() + "-answer", bench::answer(study.points, quantity, {1e-2, 1e-3, 1e-4}));
  item.added("a study of methods");
}

// What COUNTACT-1 tends to: its error falls with the square of the cell, so that two meshes can be continued.
double other_route() {
  const double coarse = by_columns(graded_columns(18, 12), 15).force;
  const double fine = by_columns(graded_columns(27, 18), 23).force;
  return fine + (fine - coarse) / (1.5 * 1.5 - 1);
}

void jump_force(report::Item& item) {
  panel(item, jump(item), "F");
  const bench::Reference& reference = jump(item).references.front();
  item.value("reference-cells", fmt::format("{0} x {0}", reference_cells));
  item.value("uncertainty", reference.uncertainty, "", "{:.0e}");
  item.expect_checks(1);
  item.agree("other-route", "the reference of the force", "N", reference.value, other_route(), 1e-4,
             "COUNTACT-1, continued");
  item.value("other-route", std::abs(reference.value / other_route() - 1), "", "{:.0e}");
}

}  // namespace

const report::Section cost{
    report::figure("cost-jump-force", "Force of Example 2: error against run time", jump_force),
    report::figure("cost-jump-peak", "Peak pressure of Example 2: error against run time",
                   [](report::Item& item) { panel(item, jump(item), "p_max"); }),
    report::figure("cost-jump-length", "Length of the patch of Example 2: error against run time",
                   [](report::Item& item) { panel(item, jump(item), "length"); }),
    report::figure("cost-punch-force", "Force of Example 4: error against run time",
                   [](report::Item& item) { panel(item, punch(item), "F"); }),
    report::figure("cost-punch-peak", "Peak pressure of Example 4: error against run time",
                   [](report::Item& item) { panel(item, punch(item), "p_max"); }),
    report::figure("cost-punch-length",
                   "Diameter of the contact of Example 4: error against run time",
                   [](report::Item& item) { panel(item, punch(item), "length"); })};

}  // namespace railbook::contact_chapter
