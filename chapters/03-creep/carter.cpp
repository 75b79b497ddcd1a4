/***
### Two problems with exact answers

*Carter's* cylinders are the plane case. A leading strip sticks, and with $X=\xi R/\mu a$ the force is
$Q/\mu P=1-(1-X)^2$, the strip's share of the width $1-X$. One row of our cells, made very wide, is this problem, so it tests
the whole solver. It also shows where the ends of a row belong. The discrete half-line has the symbol
$i\,\mathrm{sign}(t)\,e^{it/2}R(t)$, with
$R=4\sin^2\frac t2\sum_m(-1)^m\,\mathrm{sign}(t+2\pi m)/(t+2\pi m)^2$; factorised after Wiener and Hopf, $e^{it/2}$ puts the ends at
quarters of a cell, as in the quarter-points of aerodynamics' vortex lattices, and $R$ adds

$$\delta=-\frac1{4\pi}\int_0^\pi\frac{\ln R(t)}{\sin^2\frac t2}\,dt = {{delta}}.$$

{{carter}}

{{fig-carter}}

Carter's formula also gives the example that comes with CONTACT: $\mu$ = 0.3, $a/R$ = 1/500, $Q=0.64\,\mu P$.
*/

#include "rolling/carter.hpp"

#include <fmt/format.h>

#include <cmath>

#include "items.hpp"
#include "rolling/rolling_influence.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr double loads[] = {0.2, 0.64, 0.9};

double error(double q, Eigen::Index cells, bool placed) {
  return rolling::carter_by_cells(rolling::carter_creepage(q), cells, placed).force - q;
}

void tabulate(report::Item& item) {
  item.value("delta", rolling::edge_offset(), "", "{:.6f}");
  item.value("end-behind", 0.25 + rolling::edge_offset(), "", "{:.3f}");
  item.value("end-ahead", 0.75 + rolling::edge_offset(), "", "{:.3f}");
  item.columns({"Q/μP", "X", "stick share, exact", "200 cells", "error of Q/μP: 25 cells fill",
                "200 cells fill", "25 placed", "200 placed"});
  item.expect_checks(2 + 3);
  const auto printed = item.printed("carter.csv");
  const auto row = [&](const char* key, double computed) {
    item.check(key, printed.at(key, "what"), "", printed.at(key, "printed"), computed);
  };
  row("creepage", 0.3 / 500 * rolling::carter_creepage(0.64));
  row("stick", rolling::carter(rolling::carter_creepage(0.64)).stick);
  for (const double q : loads) {
    const double x = rolling::carter_creepage(q);
    const auto cells = rolling::carter_by_cells(x, 200);
    item.add_row(
        {fmt::format("{}", q), fmt::format("{:.6f}", x),
         fmt::format("{:.4f}", rolling::carter(x).stick), fmt::format("{:.3f}", cells.stick),
         fmt::format("{:.2e}", error(q, 25, false)), fmt::format("{:.2e}", error(q, 200, false)),
         fmt::format("{:.2e}", error(q, 25, true)), fmt::format("{:.2e}", error(q, 200, true))});
    item.agree(fmt::format("q-{}", q), "Q/μP by 200 cells", "", cells.force, q, 2e-5,
               "Carter's formula");
  }
}

void figure(report::Item& item) {
  item.explained("Carter's formulas, and cells against them");
  auto& traction = item.data({"s", "low", "middle", "high", "bound"});
  for (int k = 0; k <= 400; ++k) {
    const double s = -std::cos(k * 0.0078539816339744830);  // pi/400: dense at the ends
    const auto p = [&](double q) {
      return rolling::carter_traction(rolling::carter_creepage(q), s);
    };
    traction.add(s, p(loads[0]), p(loads[1]), p(loads[2]), std::sqrt((1 - s) * (1 + s)));
  }
  auto& errors = item.data("errors", {"cells", "filled", "placed"});
  for (const int n : {6, 12, 25, 50, 100, 200, 400})
    errors.add(n, std::abs(error(0.64, n, false)), std::abs(error(0.64, n, true)));
}

}  // namespace

void creep_chapter::add_carter(report::Chapter& chapter) {
  chapter.table("carter", "Carter's cylinders by cells", tabulate);
  chapter.figure("fig-carter", "Carter's tractions, and the error of the force by cells", figure);
}
