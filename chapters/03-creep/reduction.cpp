/***
## One curve for all

First the friction at constant creep, against the load, the paper's Figure 8. Theory says how it must fall. The group
$X$ goes with $\xi\,ab/N\propto\xi N^{-1/3}$, since the area goes with $N^{2/3}$. In the linear part $\mu=\mu_cC_{11}X$ does
not contain $\mu_c$, so $\mu\propto N^{-1/3}$ whatever the friction does; at large creep $\mu=\mu_c(N)$. The paper calls its lines
"almost parallel". On a linear scale that asks for an exponent well below 1/3 at large creep: lines with slopes $-\frac13\mu_1/N$
and $-q\,\mu_2/N$ are parallel for $q=\frac13\mu_1/\mu_2$.

{{fig-08}}

Then the areas. For smooth new wheels they are Hertz's; for worn ones they are not.

{{fig-09}}

{{fig-10}}

Now the paper's claim. Each synthetic point has a load, a force and a creep; the largest friction is that of its average
curve. Reduced with **Hertz's** area the four tests stay apart, each shifted by its own wear:

{{fig-11-hertz}}

Reduced with the **measured** area they fall on one line, and it is the theory's:

{{fig-11}}

{{table-collapse}}

In numbers: the factor that brings each test onto the curve spreads by {{spread-hertz}} with Hertz's area and by
{{spread-true}} with the measured one; the points scatter about the curve by {{rms-hertz}} against {{rms-true}} (root mean
square of $\mu/\mu_c$), and the second is what the errors of force, creep and area make by
themselves. The fit finds the contact area of a
test from its creep curve alone, without the replica tape, to {{factor-error}}.

The abscissa has a trap. The nomenclature calls $a$ and $b$ "major and minor axes" and equation (4) has $\pi/4$, so the
paper means **full axes**. Kalker's $a$ and $b$ are semi-axes, and with full axes the abscissa is four times as large. The
figure has both scales; without its own axis we cannot tell which one the paper plotted.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiment.hpp"
#include "full.hpp"
#include "items.hpp"
#include "master_curve.hpp"
#include "rig.hpp"
#include "rolling/creep_laws.hpp"
#include "spectra/random_source.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr const char* lost =
    "the paper's measured points are lost; these are synthetic, made from the theory and the "
    "stated errors";
constexpr double mm2 = 1e-6;

double hertz_area(double load) {
  const auto c = rig_contact(load, profile_radius(true));
  return units::pi * c.a * c.b;
}

void constant_creep(report::Item& item) {
  auto& lines = item.data({"load_lbf", "mu_0005", "mu_001", "mu_002", "mu_004", "mu_c"});
  auto& points = item.data("points", {"load_lbf", "mu_0005", "mu_001", "mu_002", "mu_004", "mu_c"});
  const double factor = 1.5;  // one wear for all loads: the lines are smooth
  for (double load = 400; load <= 2700; load += 20) {
    const double n = load * units::lbf;
    const Average wheels{synthetic_friction(n), factor};
    lines.add(load, wheels.mu(n, 0.0005), wheels.mu(n, 0.001), wheels.mu(n, 0.002),
              wheels.mu(n, 0.004), wheels.friction);
  }
  for (const Test& test : experiment()) {
    const Average mean = average(test);
    points.add(test.load / units::lbf, mean.mu(test.load, 0.0005), mean.mu(test.load, 0.001),
               mean.mu(test.load, 0.002), mean.mu(test.load, 0.004), mean.friction);
  }
  item.reconstructed("loads, friction and wear are not printed; ours are stated above");
  item.expect_checks(2);
  const auto exponent = [&](double creep) {
    const double n = paper_load, up = 1.01 * n;
    return std::log(Average{synthetic_friction(up), factor}.mu(up, creep) /
                    Average{synthetic_friction(n), factor}.mu(n, creep)) /
           std::log(1.01);
  };
  item.agree("exponent-linear", "exponent of the load at a creep of 1e-6", "", exponent(1e-6),
             -1.0 / 3, 1e-3, "area proportional to the load to the power 2/3");
  item.agree("exponent-slip", "exponent of the load in full slip", "", exponent(0.1),
             -friction_exponent, 2e-3, "the exponent of the friction put in");
}

void smooth_areas(report::Item& item) {
  auto& line = item.data({"load_lbf", "area_mm2", "across_mm2"});
  auto& points = item.data("points", {"load_lbf", "area_mm2"});
  for (double load = 0; load <= 3000; load += 25) {
    const double n = std::max(load, 1e-3) * units::lbf;
    const auto across = rig_contact(n, profile_radius(false));
    line.add(load, hertz_area(n) / mm2, units::pi * across.a * across.b / mm2);
  }
  const spectra::RandomSource random(1979, 9);
  for (const double load : {500.0, 750.0, 1000.0, 1250.0, 1500.0, 2000.0, 2500.0}) {
    const double noise = random.normal(static_cast<std::uint64_t>(load));
    points.add(load, hertz_area(load * units::lbf) * (1 + 0.03 * noise) / mm2);
  }
  item.reconstructed("Hertz's line is exact for our material and radii; the points are synthetic");
  item.expect_checks(1);
  item.agree("power", "area at 2000 over area at 500 lbf", "",
             hertz_area(2000 * units::lbf) / hertz_area(500 * units::lbf), std::cbrt(16.0), 1e-12,
             "the power 2/3 of the load");
}

void worn_areas(report::Item& item) {
  auto& line = item.data({"load_lbf", "area_mm2"});
  auto& points = item.data("points", {"load_lbf", "area_mm2", "test"});
  for (double load = 0; load <= 3000; load += 25)
    line.add(load, hertz_area(std::max(load, 1e-3) * units::lbf) / mm2);
  int number = 0;
  for (const Test& test : experiment())
    points.add(test.load / units::lbf, hertz_area(test.load) * test.area_measured / mm2,
               fmt::format("test {}: {:.2f}", ++number, test.area_measured));
  item.reconstructed("Hertz's line is exact for our material and radii; the points are synthetic");
}

// mu/mu_c over X, the area Hertz's times `factor` of the test.
struct Reduced {
  double x, share;
};
std::vector<Reduced> reduce(const Test& test, double factor) {
  const double friction = average(test).friction;
  std::vector<Reduced> all;
  for (const Point& p : test.points)
    all.push_back({factor * hertz_group(test.load) * p.creep / friction, p.mu / friction});
  return all;
}

double scatter(bool measured_area) {
  double sum = 0;
  int count = 0;
  for (const Test& test : experiment())
    for (const auto& [x, share] : reduce(test, measured_area ? test.area_measured : 1.0)) {
      sum += std::pow(share - master_curve(x), 2);
      ++count;
    }
  return std::sqrt(sum / count);
}

void dimensionless(report::Item& item, bool measured_area) {
  auto& curves = item.data({"x", "full", "fastsim", "vermeulen_johnson"});
  auto& points = item.data("points", {"x_1", "f_1", "x_2", "f_2", "x_3", "f_3", "x_4", "f_4"});
  const rolling::RollingCase unit = unit_case();
  for (int i = 0; i <= 250; ++i) {
    auto c = unit;
    c.creepage.longitudinal = 1.25 * i / 250;
    curves.add(c.creepage.longitudinal, master_curve(c.creepage.longitudinal),
               rolling::creep_forces(rolling::Theory::fastsim, c).fx,
               rolling::creep_forces(rolling::Theory::vermeulen_johnson, c).fx);
  }
  std::vector<std::vector<Reduced>> all;
  for (const Test& test : experiment())
    all.push_back(reduce(test, measured_area ? test.area_measured : 1.0));
  for (std::size_t k = 0; k < all[0].size(); ++k)
    points.add(all[0][k].x, all[0][k].share, all[1][k].x, all[1][k].share, all[2][k].x,
               all[2][k].share, all[3][k].x, all[3][k].share);
  item.script("dimensionless.gp");
  item.reconstructed(lost);
}

void collapse(report::Item& item) {
  item.columns({"test", "load, lbf", "area over Hertz's: true", "measured", "found from the curve",
                "μ_c: true", "fitted", "shift with Hertz's area", "with the measured area"});
  double low[2] = {1e9, 1e9}, high[2] = {0, 0}, worst = 0;
  int number = 0;
  item.expect_checks(static_cast<int>(experiment().size()));
  for (const Test& test : experiment()) {
    const Average mean = average(test);
    const double shift[2] = {mean.area_factor, mean.area_factor / test.area_measured};
    for (int k = 0; k < 2; ++k)
      low[k] = std::min(low[k], shift[k]), high[k] = std::max(high[k], shift[k]);
    worst = std::max(worst, std::abs(mean.area_factor / test.area_factor - 1));
    item.add_row({fmt::format("{}", ++number), fmt::format("{:.0f}", test.load / units::lbf),
                  fmt::format("{:.2f}", test.area_factor),
                  fmt::format("{:.3f}", test.area_measured),
                  fmt::format("{:.3f}", mean.area_factor), fmt::format("{:.4f}", test.friction),
                  fmt::format("{:.4f}", mean.friction), fmt::format("{:.3f}", shift[0]),
                  fmt::format("{:.3f}", shift[1])});
    item.agree(fmt::format("factor-{}", number),
               fmt::format("area over Hertz's from the curve, test {}", number), "",
               mean.area_factor, test.area_factor, 0.15,
               "the area put in, through 28 points with the stated errors");
  }
  item.reconstructed(lost);
  item.value("spread-hertz", 100 * (high[0] / low[0] - 1), "%", "{:.0f}");
  item.value("spread-true", 100 * (high[1] / low[1] - 1), "%", "{:.0f}");
  item.value("rms-hertz", scatter(false), "", "{:.3f}");
  item.value("rms-true", scatter(true), "", "{:.3f}");
  item.value("factor-error", 100 * worst, "%", "{:.0f}");
}

}  // namespace

void creep_chapter::add_reduction(report::Chapter& chapter) {
  chapter.figure("fig-08", "Friction at constant creep against the load", constant_creep);
  chapter.figure("fig-09", "Contact area of smooth new wheels", smooth_areas);
  chapter.figure("fig-10", "Contact area in four tests", worn_areas);
  chapter.figure("fig-11-hertz", "The dimensionless curve with Hertz's area (synthetic)",
                 [](report::Item& item) { dimensionless(item, false); });
  chapter.figure("fig-11", "The dimensionless curve with the measured area (synthetic)",
                 [](report::Item& item) { dimensionless(item, true); });
  chapter.table("table-collapse", "Four tests on one curve", collapse);
}
