/***
The whole curve of 19 creepages is one run here: the time is that of all 19, set-up included, and the error the mean of $|f-f_{ref}|$ over
them. The reference is the full theory on the finest grid of this page, which is itself uncertain by the grey band. The work count of the
full theory is the number of cells times creepages; the formulas have none.

{{curve-time}}

Each fast theory has one error, whatever time it gets: its own. Per creepage, the full theory takes {{time-coarse}} for a mean error of
{{error-coarse}} with 6 x 4 cells, {{time-middle}} for {{error-middle}} with 12 x 8, and {{time-fine}} for {{error-fine}} with
24 x 12. Cells that just fill the rows, which is how the theory is usually discretised, need {{cells-ratio}} times the cells for the
error that 6 x 4 placed ones have.

{{work-precision: curve-time}}

The same three grids against both references, the finest grid of this page and the extrapolated curve of {{table-full-curve}}, which is itself {{listed-apart}}
from the former in the mean. The solver's estimate of its own error is no bound; the last column counts where it is one.

{{curve-errors}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/work_precision.hpp"
#include "full.hpp"
#include "items.hpp"
#include "rig.hpp"
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
  for (const auto& [n, m] :
       {std::pair{4, 4}, {6, 4}, {8, 6}, {12, 8}, {16, 8}, {24, 12}, {32, 16}}) {
    const int along = n, rows = m;
    method.settings.push_back(
        {fmt::format("{}x{}", along, rows), [=, along = along, rows = rows] {
           rolling::RollingOptions options;
           options.along = along, options.rows = rows, options.remedy = placed;
           const auto curve = full_curve(options);
           return outcome(curve, full,
                          static_cast<double>(along * rows) * static_cast<double>(curve.size()));
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
  bench::Method grid{"FASTSIM grid", {}};
  for (const int n : {10, 20, 40}) {
    auto one = by_formula("", full, [k, n](const RollingCase& c) {
      rolling::FastsimOptions options;
      options.along = options.strips = n;
      return rolling::fastsim_grid(c, k, options);
    });
    one.settings[0].label = fmt::format("{}x{}", n, n);
    grid.settings.push_back(one.settings[0]);
  }
  list.push_back(grid);
  list.push_back(by_formula("FaStrip without spin", full,
                            [k](const RollingCase& c) { return rolling::strip_theory(c, k); }));
  list.push_back(by_formula("Shen-Hedrick-Elkins", full, [k](const RollingCase& c) {
    return rolling::shen_hedrick_elkins(c, k);
  }));
  list.push_back(
      by_formula("Polach", full, [k](const RollingCase& c) { return rolling::polach(c, k); }));
  list.push_back(by_formula("Vermeulen-Johnson", full, [](const RollingCase& c) {
    return rolling::vermeulen_johnson(c, rolling::vermeulen_johnson_slopes(c.a / c.b, c.poisson));
  }));
  return list;
}

const report::WorkPrecision* find(const std::vector<report::WorkPrecision>& points,
                                  const char* method, const char* setting) {
  for (const auto& p : points)
    if (p.method == method && p.setting == setting) return &p;
  return nullptr;
}

// The share of cells by which the filled rows' error, falling with the cell size, misses that of 6 x 4 placed ones.
double cells_needed(const std::vector<report::WorkPrecision>& points) {
  const auto* small = find(points, placed_name, "6x4");
  const auto* fine = find(points, filled_name, "32x16");
  const double finer =
      fine->error / small->error;  // first order: that many times more in each direction
  return 32.0 * 16.0 * finer * finer / 24.0;
}

void cost(report::Item& item) {
  item.reconstructed("not in the paper: our own study of methods");
  const bool full = item.full();
  double uncertain = 0;
  for (const auto& p : reference_curve(full)) uncertain += p.error / 19;
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
  tell("fine", "24x12");
  item.value("cells-ratio", cells_needed(points), "", "{:.0f}");
}

// Mean over the curve of |f - reference|, and the points at which the solver's estimate is no less.
struct Against {
  double mean = 0, most = 0;
  int covered = 0;
};
Against against(const std::vector<CurvePoint>& curve, const std::vector<double>& reference) {
  Against a;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const double e = std::abs(curve[k].force - reference[k]);
    a.mean += e / static_cast<double>(curve.size());
    a.most = std::max(a.most, e);
    a.covered += curve[k].error >= e ? 1 : 0;
  }
  return a;
}

void errors(report::Item& item) {
  item.reconstructed("not in the paper: our own study of methods");
  const auto program = item.printed("contact-curve.csv");
  std::vector<double> own, listed;
  for (const auto& p : reference_curve(item.full())) {
    own.push_back(p.force);
    listed.push_back(report::printed_number(program.at(fmt::format("{}", p.x), "f")));
  }
  item.columns({"cells", "mean error", "largest", "mean against CONTACT", "largest",
                "estimate above error, of 19"});
  for (const auto& [n, m] : {std::pair{6, 4}, {12, 8}, {24, 12}}) {
    const auto curve = full_curve({.along = n, .rows = m});
    const Against a = against(curve, own), b = against(curve, listed);
    item.add_row({fmt::format("{} x {}", n, m), fmt::format("{:.1e}", a.mean),
                  fmt::format("{:.1e}", a.most), fmt::format("{:.1e}", b.mean),
                  fmt::format("{:.1e}", b.most), fmt::format("{}", a.covered)});
  }
  item.value("listed-apart", against(reference_curve(item.full()), listed).mean, "", "{:.1e}");
}

}  // namespace

void creep_chapter::add_full_cost(report::Chapter& chapter) {
  chapter.figure("curve-time", "Mean error of f over the curve against cost", cost);
  chapter.table("curve-errors", "The full theory against two references, 19 creepages", errors);
}
