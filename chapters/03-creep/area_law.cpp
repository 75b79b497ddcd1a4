/***
## Creep times area is constant

If $\mu/\mu_c$ depends on $X=G\,ab\,\xi/\mu_cN$ only, then at the same load, friction and traction the product of creep and
area is constant: a worn wheel with a larger contact creeps less. How exact is that law?

**Exact part.** With the same axis ratio, Poisson's ratio and friction law, the full theory has no other variable than $X$
(and Carter's plane theory as well, where $\xi a=4\mu PX/\pi E^*$ contains no radius). Both radii doubled at constant load:
the friction at the same product differs by rounding.

**Inexact part.** Wear does not enlarge the contact that way. It flattens the profile of the small wheel and leaves its
rolling radius: the contact grows across, the ellipse becomes rounder and then wide, and Kalker's coefficient falls with $a/b$.

{{table-law}}

{{fig-law}}

With a profile {{flatter}} times as flat the area grows by {{area-moderate}} and the product rises by {{rise-moderate}}: taken as "the
product is constant", the law holds to five percent, and so does the paper's habit of changing the wheel when the ellipse no
longer has its ratio. But taken as "creep falls as the area grows" it promises twice too much: the creep falls by
{{creep-moderate}} only. With a profile three times as flat the product is off by {{rise-worst}}. Most of that is the initial
slope: the ratio of the computed coefficients $C_{11}$ alone gives {{rise-slope}}. The law is about a contact that grows alike in
both directions, and wear that does that must act on the rolling radius, too, or roughen the surface.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "num/roots.hpp"
#include "rig.hpp"
#include "rolling/carter.hpp"
#include "rolling/kalker_coefficients.hpp"
#include "rolling/theory.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr double friction = 0.3;
constexpr double profile_factors[] = {1, 1.25, 1.5, 1.966, 3};
constexpr double shares[] = {0.25, 0.5, 0.8};

rolling::RollingCase rolling(const contact::HertzContact& c, double creep) {
  return {.a = c.a,
          .b = c.b,
          .load = c.force,
          .shear_modulus = shear_modulus,
          .poisson = poisson,
          .friction = friction,
          .creepage = {creep, 0, 0}};
}

// Creep times area [m^2] at which the contact uses `share` of its friction.
double product(const contact::HertzContact& c, const Solver& full, double share) {
  const double unit = friction * c.force / (shear_modulus * c.a * c.b);
  const auto miss = [&](double x) {
    return full(rolling(c, x * unit)).fx / (friction * c.force) - share;
  };
  return num::find_root(miss, 1e-6, 1, 1e-9).x * unit * units::pi * c.a * c.b;
}

void law(report::Item& item) {
  item.columns(
      {"profile radius", "a/b", "area, mm²", "ξA for µ/µ_c = 0.25", "0.5", "0.8", "by C11 alone"});
  item.rebuilt("material and profile radius are not printed; those used are stated above");
  const auto other = item.printed("contact.csv");
  item.expect_checks(16);
  double base[3] = {}, slope = 0, area = 0, moderate = 0, most = 0;
  for (const double factor : profile_factors) {
    const auto c = rig_contact(paper_load, factor * profile_radius(true));
    const Solver full = solver("full", c.a / c.b, poisson, 24);
    const double c11 = rolling::kalker_coefficients(c.a / c.b, poisson).c11;
    if (factor == 1) slope = c11, area = c.a * c.b;
    std::vector<std::string> cells{fmt::format("× {:g}", factor), fmt::format("{:.3f}", c.a / c.b),
                                   fmt::format("{:.3f}", units::pi * c.a * c.b / 1e-6)};
    for (int k = 0; k < 3; ++k) {
      const double now = product(c, full, shares[k]);
      if (factor == 1) base[k] = now;
      cells.push_back(fmt::format("{:+.1f} %", 100 * (now / base[k] - 1)));
      if (factor == 1) continue;
      (factor == 1.25 ? moderate : most) =
          std::max(factor == 1.25 ? moderate : most, now / base[k] - 1);
      const std::string key = fmt::format("x{:g}", factor);
      const double reference =
          report::printed_number(other.at(key, fmt::format("rise_{:g}", 100 * shares[k])));
      item.agree(fmt::format("{}-{:g}", key, 100 * shares[k]),
                 fmt::format("ξA at {:g} of the friction, profile × {:g}", shares[k], factor), "",
                 now / base[k], 1 + reference / 100, 0.005,
                 "the program CONTACT on 45 x 45 cells, uncertain by 0.003");
      if (k == 1 && factor == 1.25) {
        item.value("rise-moderate", 100 * (now / base[k] - 1), "%", "{:.1f}");
        item.value("creep-moderate", 100 * (1 - now / base[k] * area / (c.a * c.b)), "%", "{:.1f}");
        item.value("flatter", factor, "", "{:g}");
        item.value("area-moderate", 100 * (c.a * c.b / area - 1), "%", "{:.1f}");
      }
      if (k == 1 && factor == 3) item.value("rise-worst", 100 * (now / base[k] - 1), "%", "{:.0f}");
    }
    cells.push_back(fmt::format("{:+.1f} %", 100 * (slope / c11 - 1)));
    if (factor == 3) item.value("rise-slope", 100 * (slope / c11 - 1), "%", "{:.0f}");
    item.add_row(cells);
  }
  item.claim("moderate", "creep times area is constant, to five percent under moderate wear",
             moderate < 0.05, fmt::format("rises by {:.1f} %", 100 * moderate));
  item.refute(
      "always", "creep times area is constant whatever the wear", most > 0.15,
      fmt::format("rises by {:.0f} % as the profile wears three times as flat", 100 * most));
  // The exact part: both radii doubled, the same load and creep times area.
  const double creep = 0.0024;
  const auto small = rig_contact(paper_load, profile_radius(true));
  const auto large = contact::hertz_from_force(
      {.a = 0.25 / rolling_radius, .b = 0.25 / profile_radius(true)}, modulus(), paper_load);
  const double same = creep * small.a * small.b / (large.a * large.b);
  item.agree("scale", "friction with both radii doubled, at the same creep times area", "",
             solver("full", large.a / large.b, poisson, 24)(rolling(large, same)).fx,
             solver("full", small.a / small.b, poisson, 24)(rolling(small, creep)).fx, 1e-9,
             "the rig itself");
  // Carter: a^2 = 4 P R/(pi E*) for a load P per width; xi = X mu a/R.
  const auto carter_product = [](double radius) {
    const double load = 1e5, a = std::sqrt(4 * load * radius / (units::pi * modulus()));
    return rolling::carter_creepage(0.64) * friction * a / radius * a;
  };
  item.claim("carter", "the law is implied in Carter's analysis",
             std::abs(carter_product(0.2) / carter_product(0.1) - 1) < 1e-12,
             "creep times half width is the same to rounding with the radius doubled");
}

void law_figure(report::Item& item) {
  auto& lines = item.data({"area", "creep_constant", "creep_25", "creep_50", "creep_80"});
  double base[3] = {}, area = 0;
  for (int i = 0; i <= 12; ++i) {
    const auto c = rig_contact(paper_load, (1 + i / 6.0) * profile_radius(true));
    const Solver full = solver("full", c.a / c.b, poisson, 12);
    double creep[3];
    if (i == 0) area = c.a * c.b;
    const double grown = c.a * c.b / area;
    for (int k = 0; k < 3; ++k) {
      creep[k] = product(c, full, shares[k]) / (c.a * c.b);
      if (i == 0) base[k] = creep[k];
      creep[k] /= base[k];
    }
    lines.add(grown, 1 / grown, creep[0], creep[1], creep[2]);
  }
  item.added("the paper refers to another report for its check of the law");
}

}  // namespace

const report::Section creep_chapter::area_law{
    report::table("table-law", "Creep times area while the small wheel's profile wears flat", law),
    report::figure("fig-law", "Creep against area at constant load and friction used", law_figure)};
