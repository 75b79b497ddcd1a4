/***
## Creep times area is constant

If $\mu/\mu_c$ depends on $X=G\,ab\,\xi/\mu_cN$ only, then at the same load, friction and traction the product of creep and
area is constant: a worn wheel with a larger contact creeps less. How exact is that law?

**Exact part.** With the same axis ratio, Poisson's ratio and friction law, the full theory has no other variable than $X$
{{outcome:table-law/scale}}, and in Carter's plane theory $\xi a=4\mu PX/\pi E^*$ contains no radius at all {{outcome:table-law/carter}}.

**Inexact part.** Wear does not enlarge the contact that way. It flattens the profile of the small wheel and leaves its
rolling radius: the contact grows across, the ellipse becomes rounder and then wide, and Kalker's coefficient falls with $a/b$.

{{table-law}}

{{fig-law}}

With a profile {{flatter}} times as flat the area grows by {{area-moderate}} and the product rises by {{rise-moderate}}: the law as it is stated
is not confirmed, since the change is many times what the computation can be wrong by {{outcome:table-law/always}}. But
no rig could see it: at the creep that Appendix B prints, even the {{rise-worst}} of a profile three times as flat is a change of {{rise-seen}}, below the 0.0005 to which the
paper's creep is accurate {{outcome:table-law/resolution}}. Most of the rise is the initial slope: the ratio of the computed coefficients $C_{11}$ alone gives
{{rise-slope}}. The paper changed its wheels when the ellipse lost its ratio of axes; with that ratio kept the law is exact, but wear that enlarges the contact so
must act on the rolling radius too, or roughen the surface.
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "num/roots.hpp"
#include "rig.hpp"
#include "rolling/kalker_coefficients.hpp"
#include "rolling/rolling_contact.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr std::array used_shares{0.25, 0.5, 0.8};

// Creep times area [m^2] at which the contact uses each of the shares of a friction of 0.3.
std::array<double, 3> products(const contact::HertzContact& c, Eigen::Index cells) {
  const EllipseRolling full(c.a / c.b, poisson, {.along = cells, .rows = cells / 2});
  const RollingCase unit = unit_case(c.a / c.b, poisson);
  const double slope = kalker_coefficients(c.a / c.b, poisson, 8).c11;
  std::array<double, 3> creep_area{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto miss = [&](double x) {
      return full.solve(with_reduced_creepage(unit, {x, 0, 0})).fx - used_shares[k];
    };
    const double linear = used_shares[k] / slope;  // no ellipse needs twice as much
    creep_area[k] = num::find_root(miss, linear, 2 * linear, 1e-9).x * 0.3 * c.force * units::pi /
                    shear_modulus;
  }
  return creep_area;
}

void law(report::Item& item) {
  item.columns({"profile radius",
                {"a/b", "{:.3f}"},
                {"area, mm²", "{:.3f}"},
                {"rise of ξA for µ/µ_c = 0.25, %", "{:+.1f}"},
                {"0.5, %", "{:+.1f}"},
                {"0.8, %", "{:+.1f}"},
                {"by C11 alone, %", "{:+.1f}"}});
  item.rebuilt("material and profile radius are not printed; those used are stated above");
  const auto other = item.printed("contact.csv");
  const auto fresh = rig_contact(paper_load, profile_radius(true));
  const auto base = products(fresh, 24);
  const auto slope = [](const contact::HertzContact& c) {
    return kalker_coefficients(c.a / c.b, poisson).c11;
  };
  double least = 1, most = 0, apart = 0;
  for (const double factor : {1.25, 1.5, 1.966, 3.0}) {
    const auto c = rig_contact(paper_load, factor * profile_radius(true));
    const std::string key = fmt::format("x{:g}", factor);
    std::array<double, 3> rise = products(c, 24);
    for (std::size_t k = 0; k < 3; ++k) {
      rise[k] = rise[k] / base[k] - 1;
      least = std::min(least, rise[k]), most = std::max(most, rise[k]);
      const auto& program = other.at(key, fmt::format("rise_{:g}", 100 * used_shares[k]));
      apart = std::max(apart, std::abs(rise[k] - report::printed_number(program) / 100));
    }
    const double by_slope = slope(fresh) / slope(c) - 1;
    item.add_row(fmt::format("× {:g}", factor), c.a / c.b, units::pi * c.a * c.b / 1e-6,
                 100 * rise[0], 100 * rise[1], 100 * rise[2], 100 * by_slope);
    if (factor == 1.25) {
      item.value("rise-moderate", 100 * rise[1], "%", "{:.1f}");
      item.value("flatter", factor, "", "{:g}");
      item.value("area-moderate", 100 * (c.a * c.b / (fresh.a * fresh.b) - 1), "%", "{:.1f}");
    } else if (factor == 3) {
      item.value("rise-worst", 100 * rise[1], "%", "{:.0f}");
      item.value("rise-slope", 100 * by_slope, "%", "{:.0f}");
    }
  }
  item.expect_checks(5);
  item.at_most("contact", "largest difference from CONTACT's rises", "", apart, 0.005,
               "its 45 x 45 cells are uncertain by 0.003");
  item.value("rise-seen", most * printed_creep, "", "{:.5f}");
  item.claim("resolution",
             "creep times area is constant, as far as creep accurate to 0.0005 can tell",
             most * printed_creep < 0.0005,
             fmt::format("at the printed creep the change is {:.5f}", most * printed_creep));
  item.refute("always", "the product of the creep and the area of contact must be a constant",
              least > 0.005,
              fmt::format("rises by {:.0f} to {:.0f} % as the profile wears flat, computed to 0.5",
                          100 * least, 100 * most));
  const auto doubled = contact::hertz_from_force(
      {.a = 0.25 / rolling_radius, .b = 0.25 / profile_radius(true)}, modulus(), paper_load);
  item.agree("scale", "creep times area for half of the friction, both radii doubled", "m^2",
             products(doubled, 24)[1], base[1], 1e-7, "the rig itself");
  // Carter: a^2 = 4 P R/(pi E*) for a load P per width; xi = X mu a/R, and X = 1 - sqrt(1 - Q/mu P).
  const auto carter_product = [](double radius) {
    const double load = 1e5, a = std::sqrt(4 * load * radius / (units::pi * modulus()));
    return (1 - std::sqrt(1 - 0.64)) * 0.3 * a / radius * a;
  };
  item.claim("carter", "the law is implied in Carter's analysis",
             std::abs(carter_product(0.2) / carter_product(0.1) - 1) < 1e-12,
             "creep times half width is the same to rounding with the radius doubled");
}

void law_figure(report::Item& item) {
  auto& lines = item.data({"area", "creep_constant", "creep_25", "creep_50", "creep_80"});
  const auto fresh = rig_contact(paper_load, profile_radius(true));
  const auto base = products(fresh, 12);
  for (int i = 0; i <= 12; ++i) {
    const auto c = rig_contact(paper_load, (1 + i / 6.0) * profile_radius(true));
    const auto now = products(c, 12);
    const double grown = c.a * c.b / (fresh.a * fresh.b);
    lines.add(grown, 1 / grown, now[0] / base[0] / grown, now[1] / base[1] / grown,
              now[2] / base[2] / grown);
  }
  item.added("the paper refers to another report for its check of the law");
}

}  // namespace

const report::Section creep_chapter::area_law{
    report::table("table-law", "Creep times area while the small wheel's profile wears flat", law),
    report::figure("fig-law", "Creep against area at constant load and friction used", law_figure)};
