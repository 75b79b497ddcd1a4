#include <string>
#include <vector>

#include "bench/work_precision.hpp"
#include "contact/cg_fft.hpp"
#include "contact/countaxi.hpp"
#include "contact/punch.hpp"
#include "items.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

/***
### The rounded punch

On Example 4 the closed form is the reference again. Symmetry is worth a great deal: a few dozen rings beat a grid of
thousands of cells. Where the rings are is worth as much again for the peak, which sits in a strip of a fortieth of the radius:
*equal* rings against rings *graded* towards the edge.

{{cost-punch}}

{{cost-punch-peak}}

The force of the graded rings falls with order {{order-graded}} in their number. Equal rings are refused by COUNTAXI itself as long as
too few of them lie between the peak and the boundary to find it, and are then marked as failed below; their
numbers would have been within a per cent, but without a reason to trust them. The peak of CG-FFT is poor until a cell is smaller
than the strip.

{{work-precision: cost-punch}}
*/

namespace {

constexpr RoundedPunch stamp{0.5 * inch, 1 * inch};

bench::Method rings(const char* name, double grading, const std::vector<int>& sizes) {
  bench::Method method{name, {}};
  for (const int n : sizes)
    method.settings.push_back({std::to_string(n), [=] {
                                 CountaxiOptions options;
                                 options.rings = n;
                                 options.grading = grading;
                                 const RingContact c = countaxi(rounded_punch_gap(stamp), delta_4,
                                                                effective_modulus(steel), options);
                                 return bench::Outcome{.values = {c.force, c.p_max, c.radius},
                                                       .work = static_cast<double>(c.work),
                                                       .converged = c.converged,
                                                       .reason = c.reason};
                               }});
  return method;
}

bench::Method grids(const std::vector<int>& sizes) {
  bench::Method method{"CG-FFT remedied", {}};
  for (const int n : sizes)
    method.settings.push_back(
        {std::to_string(n), [=] {
           CgFftOptions options;
           options.nx = options.ny = n;
           const NormalContact c =
               solve_cg_fft(rounded_punch_gap(stamp), delta_4, effective_modulus(steel), options)
                   .contact;
           return bench::Outcome{.values = {c.force, c.p_max, 0.5 * (c.x_max - c.x_min)},
                                 .work = static_cast<double>(c.work),
                                 .converged = c.converged,
                                 .reason = c.reason};
         }});
  return method;
}

const std::vector<report::WorkPrecision>& measured(const report::Item& item) {
  static const auto points = [&] {
    const PunchContact exact = punch_from_approach(stamp, effective_modulus(steel), delta_4);
    std::vector<int> numbers{10, 20, 40, 80, 160, 240};
    if (item.full()) numbers.push_back(480);
    return bench::measure("cost-punch",
                          {{"F", exact.force, 1e-13},
                           {"p_max", punch_peak(exact).pressure, 1e-10},
                           {"a", exact.radius, 1e-13}},
                          {rings("COUNTAXI equal rings", 1, numbers),
                           rings("COUNTAXI graded rings", 3, numbers), grids({45, 90, 181, 255})},
                          item.timings(), 0.1);
  }();
  return points;
}

void cost_force(report::Item& item) {
  const auto& points = measured(item);
  bench::show(item, points, "F");
  // Work is rings squared times a nearly constant number of iterations.
  item.value("order-graded", -2 * bench::observed_slope(points, "F", "COUNTAXI graded rings"), "",
             "{:.1f}");
  item.reconstructed("not in the paper: our own study of methods");
}

}  // namespace

void contact_chapter::add_cost_punch(report::Chapter& chapter) {
  chapter.figure("cost-punch", "Error of the force against cost, Example 4", cost_force);
  chapter.figure("cost-punch-peak", "Error of the peak pressure against cost, Example 4",
                 [](report::Item& item) {
                   bench::show(item, measured(item), "p_max");
                   item.reconstructed("not in the paper: our own study of methods");
                 });
}
