/*** ## Deterioration: how the histogram spreads

The paper likens the histogram of a deteriorating track to a viscous blob on a table. Taken at its word the blob obeys $h_t=\frac13(h^3h_x)_x$; the plain alternative is diffusion, which
keeps a normal histogram normal. Both have exact solutions, and one solver does both (implicit, conservative finite volumes), so the blob's can be used for other starts.

{{fig-10}}

The difference is in the tails, which is where the thresholds are. Diffusion reaches any threshold at once, and $s$ grows with $t^{1/2}$. The blob has an edge that moves as
$x_N\propto t^{1/5}$, here {{blob-front}} at $t=1$: beyond it nothing is ever exceeded. Its standard deviation is $\sqrt{3/11}$ of $x_N$. As a model of exceedances the literal blob is not on the safe side.

The edge, where the slope is infinite, is a test for the solver:

{{table-blob}}

The edge's place is right to {{place-cells}} of a cell on every grid, so it converges with first order, if irregularly: it depends on where in its cell the edge stands. The largest error, next to it, falls with
order {{order-largest}} only, as a cube root must; the mean error with {{order-mean}}, the 4/3 of a cube root over one cell. Away from the edge the error is at most {{inside-most}} and of order
{{order-inside}}, the edge's irregularity sent inwards. Area is kept to {{area-error}}.

{{fig-11}}

Figure 11 in the paper is two curves without numbers: segments A (ties renewed) and B (only surfaced) start alike and part. Ours assume diffusion, B four times as fast. The index $n$ of B falls to 3, taken as the
end of basic maintenance, after {{basic-B}} units of tonnage, that of A after {{basic-A}}. The histogram after surfacing tells nothing about which is which, as the paper says: the
rate is not in it.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "items.hpp"
#include "num/gsl.hpp"
#include "quality/quality_index.hpp"
#include "quality/spreading.hpp"

namespace railbook::quality_chapter {

using namespace railbook;
using quality::Profile;

namespace {

// A result that has converged.
Profile after(const quality::Spreading& law, Profile start, double from, double to, int steps) {
  quality::Spread s = spread(law, std::move(start), from, to, steps);
  if (!s.converged) throw num::NumericalError("spreading did not converge");
  return s.profile;
}

template <class Height>
Profile profile(double half, int cells, const Height& height) {
  Profile p{-half + half / cells, 2 * half / cells, {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(cells); ++i) {
    double sum = 0;  // cell mean, the edge resolved
    for (int j = 0; j < 16; ++j) sum += height(p.x(i) + p.width * ((j + 0.5) / 16 - 0.5));
    p.height.push_back(sum / 16);
  }
  return p;
}

double gaussian(double x, double s) {
  return std::exp(-0.5 * x * x / (s * s)) / (s * std::sqrt(2 * units::pi));
}

constexpr double diffusivity = 0.01, initial = 0.25;

void fig_10(report::Item& item) {
  auto& exact = item.data({"t", "x", "diffusion", "blob"});
  auto& volumes = item.data("volumes", {"t", "x", "diffusion", "blob"});
  item.expect_checks(4);
  const auto sd = [](double t) { return quality::diffused_deviation(initial, diffusivity, t - 1); };
  for (const double t : {1.0, 8.0, 64.0}) {
    for (int i = -400; i <= 400; ++i) {
      const double x = 0.01 * i;
      exact.add(t, x, gaussian(x, sd(t)), quality::blob_height(x, t));
    }
    exact.gap();
    if (t == 1) continue;
    const auto blob =
        after({}, profile(4, 400, [](double x) { return quality::blob_height(x, 1); }), 1, t, 200);
    const auto diffused = after(
        {diffusivity, 0}, profile(6, 600, [&](double x) { return gaussian(x, sd(1)); }), 1, t, 200);
    for (std::size_t i = 0; i < 600; i += 10) {
      const double x = diffused.x(i);
      const double h = std::abs(x) < 4 ? blob.height[static_cast<std::size_t>((x + 4) / 0.02)] : 0;
      volumes.add(t, x, diffused.height[i], h);
    }
    volumes.gap();
    const std::string name = fmt::format("{:g}", t);
    item.agree("diffusion-" + name, "standard deviation, diffusion, t = " + name, "",
               deviation(diffused), sd(t), 1e-3, "s² = s₀² + 2Dt");
    item.agree("blob-" + name, "standard deviation, blob, t = " + name, "", deviation(blob),
               std::sqrt(3.0 / 11) * quality::blob_front(t), 3e-3, "similarity solution");
  }
  item.value("blob-front", quality::blob_front(1), "", "{:.3f}");
  item.reconstructed("the paper's figure is a sketch; both laws and all numbers are ours");
}

struct BlobError {
  double mean = 0, inside = 0, largest = 0, front = 0, area = 0;
};

BlobError blob_error(int cells) {
  const double end = 10;
  const auto start = profile(1.5, cells, [](double x) { return quality::blob_height(x, 1); });
  const auto result = after({}, start, 1, end, cells);
  const auto exact = profile(1.5, cells, [&](double x) { return quality::blob_height(x, end); });
  BlobError e;
  const double front = quality::blob_front(end), top = quality::blob_height(0, end);
  for (std::size_t i = 0; i < exact.height.size(); ++i) {
    const double d = std::abs(result.height[i] - exact.height[i]) / top;
    e.mean += d * exact.width;
    e.largest = std::max(e.largest, d);
    if (std::abs(exact.x(i)) < 0.7 * front) e.inside = std::max(e.inside, d);
  }
  // The place where h is a tenth of its top, linear between cells, against the exact one.
  const double place = front * std::sqrt(1 - 1e-3);
  for (std::size_t i = exact.height.size() / 2; i + 1 < exact.height.size(); ++i) {
    const double a = result.height[i] - 0.1 * top, b = result.height[i + 1] - 0.1 * top;
    if (a >= 0 && b < 0) e.front = std::abs(exact.x(i) + exact.width * a / (a - b) - place);
  }
  e.area = std::abs(area(result) / area(start) - 1);
  return e;
}

void table_blob(report::Item& item) {
  const std::vector<int> cells{50, 100, 200, 400, 800};
  item.columns({"cells", "mean error", "largest, |x| < 0.7 x_N", "largest", "place of h = h₀/10",
                "area lost"});
  std::vector<BlobError> errors;
  double lost = 0;
  for (const int n : cells) {
    errors.push_back(blob_error(n));
    const BlobError& e = errors.back();
    lost = std::max(lost, e.area);
    item.add_row({fmt::format("{}", n), fmt::format("{:.1e}", e.mean),
                  fmt::format("{:.1e}", e.inside), fmt::format("{:.1e}", e.largest),
                  fmt::format("{:.1e}", e.front), fmt::format("{:.0e}", e.area)});
  }
  const auto order =
      [&](double BlobError::*
              error) {  // over the whole range: single steps scatter with the cell the edge is in
        return std::log(errors.front().*error / errors.back().*error) /
               std::log(static_cast<double>(cells.back()) / cells.front());
      };
  item.expect_checks(3);
  double cells_off = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells_off = std::max(cells_off, errors[i].front / (3.0 / cells[i]));
  item.check("place", "edge off its place, worst of the grids", "cells", "0.5", cells_off,
             report::at_most("first order: within half a cell on every grid"));
  item.check("order-mean", "order of the mean error", "", "1.3333", order(&BlobError::mean),
             report::absolute(0.1,
                              "4/3 for a cube root lost over one cell; the edge stands elsewhere "
                              "in its cell on each grid"));
  item.check("area", "area lost", "", "1e-12", lost,
             report::at_most("rounding: the scheme is conservative"));
  item.value("place-cells", cells_off, "", "{:.1f}");
  item.value("order-mean", order(&BlobError::mean), "", "{:.2f}");
  item.value("inside-most", std::max(errors[0].inside, errors[1].inside), "", "{:.0e}");
  item.value("order-inside", order(&BlobError::inside), "", "{:.2f}");
  item.value("order-largest", order(&BlobError::largest), "", "{:.2f}");
  item.value("area-error", lost, "", "{:.0e}");
  item.reconstructed("the paper names the blob and no equation");
}

/*** The two segments: $\bar x$ = 0.2, $s_0$ = 0.15 and $T_2$ = 1, tonnage in units in which $2D$ = 0.005 for A. */
constexpr double centre = 0.2, threshold = 1.0, start_deviation = 0.15;

double margin(double D, double tonnage) {
  return (threshold - centre) / quality::diffused_deviation(start_deviation, D, tonnage);
}

void fig_11(report::Item& item) {
  auto& data = item.data({"tonnage", "s_A", "s_B", "n_A", "n_B"});
  constexpr double D_A = 0.0025, D_B = 4 * D_A;
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.1 * i;
    data.add(t, quality::diffused_deviation(start_deviation, D_A, t),
             quality::diffused_deviation(start_deviation, D_B, t), margin(D_A, t), margin(D_B, t));
  }
  const auto until = [](double D) {
    const double s = (threshold - centre) / 3;
    return (s * s - start_deviation * start_deviation) / (2 * D);
  };
  item.expect_checks(2);
  for (const auto& [name, D] : {std::pair{"A", D_A}, std::pair{"B", D_B}}) {
    const auto p =
        after({D, 0}, profile(2.5, 1000, [](double x) { return gaussian(x, start_deviation); }), 1,
              1 + until(D), 100);
    item.agree(std::string{"n-"} + name,
               std::string{"n of segment "} + name + " when basic maintenance ends", "",
               (threshold - centre) / deviation(p), 3, 1e-3, "closed form; ours by finite volumes");
    item.value(std::string{"basic-"} + name, until(D), "", "{:.2f}");
  }
  item.reconstructed("two curves without numbers in the paper; law and rates are ours");
}

}  // namespace

void add_spreading(report::Chapter& chapter) {
  chapter.figure("fig-10",
                 "Figure 10. Three histograms in succession, by diffusion and as a viscous blob",
                 fig_10);
  chapter.table("table-blob",
                "The blob by finite volumes against its similarity solution, t = 1 to 10",
                table_blob);
  chapter.figure("fig-11", "Figure 11. Two segments that start alike", fig_11);
}

}  // namespace railbook::quality_chapter
