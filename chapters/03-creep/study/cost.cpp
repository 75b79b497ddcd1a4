/***
The whole curve of 19 creepages is one run here: the time is that of all 19, set-up included, and the error the mean of $|f-f_{ref}|$ over
them. The reference is the full theory on the finest grid of the first page, uncertain by its difference from a grid of other proportions, the grey band; grids whose error comes
near it are left out. The work count of the full theory is the number of cells times creepages; the formulas have none.

{{curve-time}}

Each fast theory has one error, whatever time it gets: its own. Per creepage, the full theory takes {{time-coarse}} for a mean error of
{{error-coarse}} with 6 x 4 cells and {{time-middle}} for {{error-middle}} with 12 x 8. Cells that just fill the rows, as the theory is usually
discretised, have {{error-filled-fine}} with 32 x 16.

{{work-precision: curve-time}}
*/

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "../full.hpp"
#include "../rig.hpp"
#include "../sections.hpp"
#include "bench/work_precision.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/fastsim.hpp"
#include "rolling/kalker_coefficients.hpp"
#include "rolling/strip_theory.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

using rolling::CreepForces;
using rolling::RollingCase;

constexpr const char* placed_name = "full theory";
constexpr const char* filled_name = "full theory unplaced";

// Mean error over the curve plus 1, so that 1 is its reference.
bench::Outcome outcome(const std::vector<CurvePoint>& curve, bool full, double work) {
  const auto& reference = reference_curve(full);
  bench::Outcome o{.values = {1.0}, .work = work, .converged = true, .reason = {}};
  for (std::size_t k = 0; k < curve.size(); ++k) {
    o.values[0] +=
        std::abs(curve[k].force - reference[k].force) / static_cast<double>(curve.size());
    o.converged = o.converged && curve[k].converged;
  }
  if (!o.converged) o.reason = "a creepage did not converge";
  return o;
}

bench::Method by_cells(const char* name, bool placed, bool full) {
  bench::Method method{name, {}};
  std::vector<std::pair<int, int>> sizes{{4, 4}, {6, 4}, {8, 6}, {12, 8}};
  if (!placed) sizes.insert(sizes.end(), {{16, 8}, {24, 12}, {32, 16}});
  for (const auto& [n, m] : sizes) {
    const rolling::RollingOptions options{.along = n, .rows = m, .remedy = placed};
    method.settings.push_back({fmt::format("{}x{}", n, m), [=] {
                                 const auto curve = full_curve(options);
                                 return outcome(curve, full,
                                                static_cast<double>(options.along * options.rows) *
                                                    static_cast<double>(curve.size()));
                               }});
  }
  return method;
}

bench::Method by_formula(const char* name, bool full,
                         const std::function<CreepForces(const RollingCase&)>& law) {
  return {name, {{"closed", [=] {
                    const auto rig = rig_case();
                    std::vector<CurvePoint> curve;
                    for (const double x : curve_abscissae())
                      curve.push_back({x,
                                       law(rolling::with_reduced_creepage(rig, {x, 0, 0})).fx /
                                           (rig.friction * rig.load),
                                       0, 0, true});
                    return outcome(curve, full, std::numeric_limits<double>::quiet_NaN());
                  }}}};
}

std::vector<bench::Method> methods(bool full) {
  const auto k = rolling::kalker_coefficients(axis_ratio, poisson);
  std::vector<bench::Method> list{by_cells(placed_name, true, full),
                                  by_cells(filled_name, false, full)};
  list.push_back(by_formula("FASTSIM closed form", full, [k](const RollingCase& c) {
    return rolling::fastsim_without_spin(c, k);
  }));
  list.push_back(by_formula("FaStrip without spin", full,
                            [k](const RollingCase& c) { return rolling::strip_theory(c, k); }));
  list.push_back(by_formula("Shen-Hedrick-Elkins", full, [k](const RollingCase& c) {
    return rolling::shen_hedrick_elkins(c, k);
  }));
  list.push_back(
      by_formula("Polach", full, [k](const RollingCase& c) { return rolling::polach(c, k); }));
  const auto slopes = rolling::vermeulen_johnson_slopes(axis_ratio, poisson);
  list.push_back(by_formula("Vermeulen-Johnson", full, [slopes](const RollingCase& c) {
    return rolling::vermeulen_johnson(c, slopes);
  }));
  return list;
}

const report::WorkPrecision* find(const std::vector<report::WorkPrecision>& points,
                                  const char* method, const char* setting) {
  for (const auto& p : points)
    if (p.method == method && p.setting == setting) return &p;
  return nullptr;
}

void curve_time(report::Item& item) {
  item.added("a study of methods");
  const bool full = item.full();
  const auto& finest = reference_curve(full);
  const auto other = full_curve({.along = 48, .rows = 12});
  double uncertain = 0;
  for (std::size_t k = 0; k < finest.size(); ++k)
    uncertain += std::abs(finest[k].force - other[k].force) / static_cast<double>(finest.size());
  const auto points = bench::measure("curve-time", {{"mean f", 1.0, uncertain}}, methods(full),
                                     item.timings(), 0.15);
  bench::show(item, points, "mean f");
  const auto tell = [&](const char* name, const char* setting) {
    const auto* p = find(points, placed_name, setting);
    item.value(fmt::format("error-{}", name), p->error, "", "{:.1e}");
    item.value(fmt::format("time-{}", name),
               item.timings() ? fmt::format("{:.2g} ms", 1e3 * p->seconds_min / 19)
                              : std::string{"(not timed)"});
  };
  tell("coarse", "6x4");
  tell("middle", "12x8");
  item.value("error-filled-fine", find(points, filled_name, "32x16")->error, "", "{:.1e}");
}

}  // namespace

const report::Section creep_chapter::cost{
    report::figure("curve-time", "Mean error of f over the curve against cost", curve_time)};
