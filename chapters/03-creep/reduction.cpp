/***
## Friction and area against the load

At constant creep the friction falls with the load. The area goes with $N^{2/3}$, so $X\propto\xi N^{-1/3}$, and in the linear part $\mu=\mu_cC_{11}X\propto N^{-1/3}$ whatever $\mu_c$ does; at
large creep $\mu=\mu_c(N)$. The paper's "almost parallel" lines ask for an exponent well below 1/3 there: slopes $-\frac13\mu_1/N$ and $-q\,\mu_2/N$ are equal for $q=\frac13\mu_1/\mu_2$. The paper says that "this trend is predicted" by Vermeulen and Johnson and by Kalker: it is, for small creep
{{outcome:fig-08/trend}}; the largest friction is an input of those theories and its trend is not in them {{outcome:fig-08/largest}}.

{{fig-08}}

Then the areas. For smooth new wheels they are Hertz's; for worn ones they are not.

{{fig-09}}

{{fig-10}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiment.hpp"
#include "rig.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

namespace {

// [mm^2] at a load [lbf]
double hertz_area(double load, bool major_along_rolling) {
  const auto c =
      rig_contact(std::max(load, 1e-3) * units::lbf, profile_radius(major_along_rolling));
  return units::pi * c.a * c.b / 1e-6;
}

void constant_creep(report::Item& item) {
  auto& lines = item.data({"load_lbf", "mu_0005", "mu_001", "mu_002", "mu_004", "mu_c"});
  auto& points = item.data("points", {"load_lbf", "mu_0005", "mu_001", "mu_002", "mu_004", "mu_c"});
  const double factor = 1.5;  // one wear for all loads: the lines are smooth
  const auto add = [](report::Data& data, double load, const Average& a) {
    data.add(load / units::lbf, a.mu(load, 0.0005), a.mu(load, 0.001), a.mu(load, 0.002),
             a.mu(load, 0.004), a.friction);
  };
  for (double load = 400; load <= 2700; load += 20)
    add(lines, load * units::lbf, {synthetic_friction(load * units::lbf), factor});
  for (const Test& test : tests()) add(points, test.load, test.average);
  item.rebuilt("loads, friction and wear are not printed; those used are stated above");
  item.expect_checks(2);
  const auto exponent = [&](double creep) {
    const double n = paper_load, up = 1.01 * n;
    return std::log(Average{synthetic_friction(up), factor}.mu(up, creep) /
                    Average{synthetic_friction(n), factor}.mu(n, creep)) /
           std::log(1.01);
  };
  item.claim(
      "trend", "the fall of friction with the load is predicted by the theories, at small creep",
      std::abs(exponent(1e-6) + 1.0 / 3) < 1e-3, fmt::format("exponent {:.4f}", exponent(1e-6)));
  item.refute("largest", "the theories predict the fall of the largest friction",
              std::abs(exponent(0.1) + friction_exponent) < 2e-3,
              fmt::format("in full slip the exponent is that of the friction put in, {:.3f}",
                          exponent(0.1)));
}

void smooth_areas(report::Item& item) {
  auto& line = item.data({"load_lbf", "area_mm2", "across_mm2"});
  for (double load = 0; load <= 3000; load += 25)
    line.add(load, hertz_area(load, true), hertz_area(load, false));
  item.rebuilt("Hertz's lines for the material and radii used; the paper's points are lost");
}

void worn_areas(report::Item& item) {
  auto& line = item.data({"load_lbf", "area_mm2"});
  auto& points = item.data("points", {"load_lbf", "area_mm2", "test"});
  for (double load = 0; load <= 3000; load += 25) line.add(load, hertz_area(load, true));
  int number = 0;
  for (const Test& test : tests())
    points.add(test.load / units::lbf,
               hertz_area(test.load / units::lbf, true) * test.area_measured,
               fmt::format("test {}: {:.2f}", ++number, test.area_measured));
  item.rebuilt("Hertz's line is exact for the material and radii used; the points are synthetic");
}

}  // namespace

const report::Section creep_chapter::reduction{
    report::figure("fig-08", "Friction at constant creep against the load", constant_creep),
    report::figure("fig-09", "Contact area of smooth new wheels", smooth_areas),
    report::figure("fig-10", "Contact area in four tests", worn_areas)};
