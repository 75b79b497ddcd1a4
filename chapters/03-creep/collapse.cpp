/***
## One curve for all

The paper's claim: with the actual area of contact all tests fall on one curve. Each synthetic point has a load, a force and a creep; the largest friction is that of its average
curve. Reduced with **Hertz's** area the four tests stay apart, each shifted by its own wear:

{{fig-11-hertz}}

Reduced with the **measured** area they fall on one line, and it is the theory's:

{{fig-11}}

{{table-collapse}}

In numbers: the factor that brings each test onto the curve spreads by {{spread-hertz}} with Hertz's area and by
{{spread-true}} with the measured one; the points scatter about the curve by {{rms-hertz}} against {{rms-true}} (root mean
square of $\mu/\mu_c$), and the second is what the errors of force, creep and area make by
themselves. The fit finds the contact area of a
test from its creep curve alone, without the replica tape, to {{factor-error}}. This shows what the reduction can do, not that the paper's own points did so.

The figure has two scales: the paper's $a$ and $b$ are **full axes** by its nomenclature and its equation (4), Kalker's are semi-axes.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curve.hpp"
#include "experiment.hpp"
#include "rig.hpp"
#include "rolling/creep_laws.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

// A point as X and mu/mu_c, with Hertz's area or the measured one.
struct Reduced {
  double x, share;
};
Reduced reduced(const Test& test, const Point& p, bool measured_area) {
  const double friction = test.average.friction, factor = measured_area ? test.area_measured : 1;
  return {factor * hertz_group(test.load) * p.creep / friction, p.mu / friction};
}

// Root mean square distance of all points from the curve.
double scatter(bool measured_area) {
  double sum = 0, count = 0;
  for (const Test& test : tests())
    for (const Point& p : test.points) {
      const auto [x, share] = reduced(test, p, measured_area);
      sum += std::pow(share - master_curve(x), 2), ++count;
    }
  return std::sqrt(sum / count);
}

void dimensionless(report::Item& item, bool measured_area) {
  auto& curves = item.data({"x", "full", "fastsim", "vermeulen_johnson"});
  auto& points = item.data("points", {"x", "f", "test"});
  for (int i = 0; i <= 250; ++i) {
    const double x = 1.25 * i / 250;
    const auto c = with_reduced_creepage(rolling::unit_case(axis_ratio, poisson), {x, 0, 0});
    curves.add(x, master_curve(x), creep_forces(Theory::fastsim, c).fx,
               creep_forces(Theory::vermeulen_johnson, c).fx);
  }
  for (const Test& test : tests())
    for (const Point& p : test.points) {
      const auto [x, share] = reduced(test, p, measured_area);
      points.add(x, share, std::round(test.load / units::lbf));
    }
  item.script("dimensionless.gp");
  item.rebuilt(synthetic);
}

void four_tests(report::Item& item) {
  item.columns({"test",
                {"load, lbf", "{:.0f}"},
                {"area over Hertz's: true", "{:.2f}"},
                {"measured", "{:.3f}"},
                {"found from the curve", "{:.3f}"},
                {"μ_c: true", "{:.4f}"},
                {"fitted", "{:.4f}"},
                {"over the measured", "{:.3f}"}});
  std::vector<double> by_hertz, by_measured, off;
  int number = 0;
  item.expect_checks(static_cast<int>(tests().size()));
  for (const Test& test : tests()) {
    const Average& mean = test.average;
    by_hertz.push_back(mean.area_factor);
    by_measured.push_back(mean.area_factor / test.area_measured);
    off.push_back(std::abs(mean.area_factor / test.area_factor - 1));
    item.add_row(fmt::format("{}", ++number), test.load / units::lbf, test.area_factor,
                 test.area_measured, mean.area_factor, test.friction, mean.friction,
                 by_measured.back());
    item.agree(fmt::format("factor-{}", number),
               fmt::format("area over Hertz's from the curve, test {}", number), "",
               mean.area_factor, test.area_factor, 0.15,
               "the area put in, through 28 points with the stated errors");
  }
  const auto spread = [](const std::vector<double>& shifts) {
    const auto [low, high] = std::ranges::minmax(shifts);
    return 100 * (high / low - 1);
  };
  item.rebuilt(synthetic);
  item.value("spread-hertz", spread(by_hertz), "%", "{:.0f}");
  item.value("spread-true", spread(by_measured), "%", "{:.0f}");
  item.value("rms-hertz", scatter(false), "", "{:.3f}");
  item.value("rms-true", scatter(true), "", "{:.3f}");
  item.value("factor-error", 100 * std::ranges::max(off), "%", "{:.0f}");
}

}  // namespace

const report::Section creep_chapter::collapse{
    report::figure("fig-11-hertz", "The dimensionless curve with Hertz's area (synthetic)",
                   [](report::Item& item) { dimensionless(item, false); }),
    report::figure("fig-11", "The dimensionless curve with the measured area (synthetic)",
                   [](report::Item& item) { dimensionless(item, true); }),
    report::table("table-collapse", "Four tests on one curve", four_tests)};
