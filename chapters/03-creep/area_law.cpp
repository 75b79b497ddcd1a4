/***
## Creep times area is constant

If $f=\mu/\mu_c$ depends on $X=G\,ab\,\xi/\mu_cN$ only, then at the same load, largest friction and
force the product of creep and area is constant: a worn wheel with a larger contact creeps less. The
paper states this for tests whose wear was "kept to a level preserving the elliptical contact with a
preestablished ratio of the major to the minor axis". The function `products` seeks, on any ellipse,
the $X$ at which a given fraction of the friction is used. It looks between the $X$ of the linear
theory and twice that, and turns what it finds into creep times area, $\pi X\mu_cN/G$ with $\mu_c$ =
0.3:

{{code: area_law.cpp products}}

**With that ratio kept** the law is exact in Kalker's theory, which for one ratio of axes, Poisson's
ratio and friction law has no other variable than $X$. It does not depend on how much the area
grows, on the fraction of the friction that is used, or on the direction of the longer axis
{{outcome:table-law/constant}} {{outcome:table-law/scale}}. Carter's plane theory says the same of a
contact that is $2a$ long and endless across: for a load $P$ and a traction $Q$ per width,
$\xi a=4\mu_cP\,(1-\sqrt{1-Q/\mu_cP})/\pi E^*$ contains no radius at all
{{outcome:table-law/carter}}.

**When the ratio changes** the law does not hold. Suppose that wear flattens only the profile of the
small wheel and leaves its rolling radius. Then the contact widens across and shortens along
rolling, and Kalker's coefficient $C_{11}$ falls with $a/b$.

{{table-law}}

{{fig-law}}

With a profile {{flatter}} times as flat the area grows by {{area-moderate}} and the product rises
by {{rise-moderate}}; with one three times as flat it rises by {{rise-worst}}, and the public
program CONTACT agrees {{outcome:table-law/contact}}. Nearly all of the rise comes from
$C_{11}$: its change alone gives {{rise-slope}}, and sliding takes a little off.

**Could the rig have seen it?** With {{worst-area}} times the area the law lets the worn wheel creep
less than the new one, and the rise adds {{rise-worst}} to that smaller creep. At the creep of
Appendix B this is {{rise-seen}}, less than the 0.0005 that the paper states for a reading. Near the
friction limit, at 80 % of it with $\mu_c$ = 0.5, the new wheel creeps {{creep-80}}, and the rise of
{{rise-worst-80}} is {{rise-80-grown}}: a single reading could barely show it.

And a test has many readings. It gives the product from its fitted curve and its measured area, and
with the paper's errors of creep and force and our 3 % for the area these have a standard deviation
of {{product-scatter}} together, and {{pair-scatter}} for the ratio of two tests. So a pair of
tests, new and worn, shows the rise of {{rise-worst}} at {{sigmas-worst}} standard deviations
{{outcome:table-law/visible}} (at {{sigmas-1}} if the areas are known to 1 %, at {{sigmas-5}} if to
5 %) and that of {{rise-moderate}} at {{sigmas-moderate}}, which is not seen. That is the best case,
since the paper's own points scattered more. The paper changed its wheels when the ellipse lost its
ratio of axes, and so kept to the domain in which its law is exact.

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/num/roots.hpp>
#include <railbook/report/values.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>

#include "rig.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr std::array used_fractions{0.25, 0.5, 0.8};

// Relative standard deviation of creep times area in one test, by that of the measured area.
double product_scatter(double measured_area = reduction_error().measured) {
  return std::hypot(reduction_error().fitted, measured_area);
}

// What a test of new and one of worn wheels show of a rise of creep times area, in standard
// deviations.
double sigmas(double rise, double measured_area = reduction_error().measured) {
  return rise / (std::sqrt(2.0) * product_scatter(measured_area));
}

// Creep times area [m^2] at which the contact uses each of the shares of a friction of 0.3.
std::array<double, 3> products(const contact::HertzContact& c, Eigen::Index cells) {
  const EllipseRolling full(c.a / c.b, poisson, {.along = cells, .rows = cells / 2});
  const RollingCase unit = normalised_case(c.a / c.b, poisson);
  const double slope = kalker_coefficients(c.a / c.b, poisson, 8).c11;
  std::array<double, 3> creep_area{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto miss = [&](double x) {
      return full.solve(with_reduced_creepage(unit, {x, 0, 0})).fx - used_fractions[k];
    };
    const double linear = used_fractions[k] / slope;  // no ellipse needs twice as much
    creep_area[k] = num::find_root(miss, linear, 2 * linear, 1e-9).x * 0.3 * c.force * units::pi /
                    shear_modulus;
  }
  return creep_area;
}

// The law in the paper's domain: the area grows, the ratio of the axes stays.
report::Trial ratio_kept(const report::Item& item) {
  report::Trial trial = item.trial("constant", "change of creep times area", "{:.6f}",
                                   [](double change) { return change < 1e-6; });
  const auto change = [](double growth, std::size_t share, bool along) {
    const auto ellipse = [&](double size) {  // both radii times `size`
      return contact::hertz_from_force(
          {.a = 0.5 / (size * rolling_radius), .b = 0.5 / (size * profile_radius(along))},
          modulus(), paper_load);
    };
    return std::abs(
        products(ellipse(std::pow(growth, 1.5)), 12)[share] / products(ellipse(1), 12)[share] - 1);
  };
  trial.vary("growth of the area",
             [&](const report::Setting& s) { return change(s.number, 1, true); });
  trial.vary("fraction of the friction used", [&](const report::Setting& s) {
    const auto share = std::ranges::find_if(
        used_fractions, [&](double one) { return std::abs(one - s.number) < 1e-9; });
    return share == used_fractions.end()
               ? units::nan
               : change(1.5, static_cast<std::size_t>(share - used_fractions.begin()), true);
  });
  trial.vary("longer axis", [&](const report::Setting& s) { return change(1.5, 1, s.index == 0); });
  return trial;
}

const std::array<double, 3>& products_of_new_wheel() {
  static const auto products_now = products(rig_contact(paper_load, profile_radius(true)), 24);
  return products_now;
}

// A wheel whose profile has worn flatter, over the new one.
struct WornWheel {
  double flatter = 1;  // profile radius
  contact::HertzContact contact = rig_contact(paper_load, flatter* profile_radius(true));
  double area = 1;
  std::array<double, 3> product{};  // creep times area at each fraction of the friction
  double by_slope = 1;              // the same by the initial slope alone
};

WornWheel worn_wheel(double flatter) {
  WornWheel worn{.flatter = flatter};
  const auto fresh = rig_contact(paper_load, profile_radius(true));
  const auto slope = [](const contact::HertzContact& c) {
    return kalker_coefficients(c.a / c.b, poisson).c11;
  };
  worn.area = worn.contact.a * worn.contact.b / (fresh.a * fresh.b);
  worn.product = products(worn.contact, 24);
  for (std::size_t k = 0; k < 3; ++k) worn.product[k] /= products_of_new_wheel()[k];
  worn.by_slope = slope(fresh) / slope(worn.contact);
  return worn;
}

// The largest difference of the rises from those of CONTACT.
double apart_from(const table::CsvTable& program, const std::vector<WornWheel>& wheels) {
  double apart = 0;
  for (const WornWheel& worn : wheels)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& theirs = program.at(fmt::format("x{:g}", worn.flatter),
                                      fmt::format("rise_{:g}", 100 * used_fractions[k]));
      apart = std::max(apart, std::abs(worn.product[k] - 1 - report::printed_number(theirs) / 100));
    }
  return apart;
}

// Creep times half width of Carter's plane contact at 0.64 of a friction of 0.3:
// a^2 = 4 P R/(pi E*) for a load P per width; xi = (1 - sqrt(1 - Q/mu P)) mu a/R.
double carter_product(double radius) {
  const double load = 1e5, a = std::sqrt(4 * load * radius / (units::pi * modulus()));
  return (1 - std::sqrt(1 - 0.64)) * 0.3 * a / radius * a;
}

void law(report::Item& item) {
  item.columns({"profile radius",
                {"a/b", "{:.3f}"},
                {"area, mm²", "{:.3f}"},
                {"rise of creep × area at f = 0.25, %", "{:+.1f}"},
                {"at f = 0.5, %", "{:+.1f}"},
                {"at f = 0.8, %", "{:+.1f}"},
                {"by C<sub>11</sub> alone, %", "{:+.1f}"}});
  item.rebuilt("our copy prints neither material nor profile radius; those used are stated above");
  item.expect_checks(2);
  const auto fresh = rig_contact(paper_load, profile_radius(true));
  const std::vector wheels{worn_wheel(1.25), worn_wheel(1.5), worn_wheel(1.966), worn_wheel(3)};
  const auto percent = [](double ratio) { return 100 * (ratio - 1); };
  for (const WornWheel& w : wheels)
    item.add_row(fmt::format("× {:g}", w.flatter), w.contact.a / w.contact.b,
                 units::pi * w.contact.a * w.contact.b / 1e-6, percent(w.product[0]),
                 percent(w.product[1]), percent(w.product[2]), percent(w.by_slope));
  const WornWheel &moderate = wheels.front(), &worst = wheels.back();
  item.value("flatter", moderate.flatter, "", "{:g}");
  report::values(item, "%", "{:.1f}", "rise-moderate", percent(moderate.product[1]),
                 "area-moderate", percent(moderate.area));
  report::values(item, "%", "{:.0f}", "rise-worst", percent(worst.product[1]), "rise-slope",
                 percent(worst.by_slope), "rise-worst-80", percent(worst.product[2]));
  report::values(item, "%", "{:.1f}", "product-scatter", 100 * product_scatter(), "pair-scatter",
                 100 * std::sqrt(2.0) * product_scatter());
  report::values(item, "", "{:.1f}", "sigmas-moderate", sigmas(moderate.product[1] - 1),
                 "sigmas-worst", sigmas(worst.product[1] - 1), "sigmas-1",
                 sigmas(worst.product[1] - 1, 0.01), "sigmas-5",
                 sigmas(worst.product[1] - 1, 0.05));
  // Creep at 80 % of a largest friction of 0.5; the products are those of 0.3.
  const double creep_80 =
      products_of_new_wheel()[2] * (0.5 / 0.3) / (units::pi * fresh.a * fresh.b);

  item.value("creep-80", creep_80, "", "{:.4f}");
  report::values(item, "", "{:.5f}", "rise-80-grown",
                 creep_80 * (worst.product[2] - 1) / worst.area, "rise-seen",
                 (worst.product[1] - 1) * printed_creep / worst.area);
  item.value("worst-area", worst.area, "", "{:.2f}");
  item.claims({{"visible", {sigmas(worst.product[1] - 1)}},
               {"constant", {}, ratio_kept(item)},
               {"carter", {carter_product(0.2) / carter_product(0.1) - 1}}});
  item.at_most("contact", "largest difference from CONTACT's rises", "",
               apart_from(item.printed("contact.csv"), wheels), 0.005,
               "its 45 x 45 cells are uncertain by 0.003");
  const auto doubled = contact::hertz_from_force(
      {.a = 0.25 / rolling_radius, .b = 0.25 / profile_radius(true)}, modulus(), paper_load);
  item.agree("scale", "creep times area for half of the friction, both radii doubled", "m^2",
             products(doubled, 24)[1], products_of_new_wheel()[1], 1e-7, "the rig itself");
}

void law_figure(report::Item& item) {
  item.added("the paper refers to another report for its check of the law");
  auto& lines = item.data({"area", "creep_constant", "creep_25", "creep_50", "creep_80"});
  for (int i = 0; i <= 12; ++i) {
    const WornWheel worn = worn_wheel(1 + i / 6.0);
    const auto creep = [&](std::size_t k) { return worn.product[k] / worn.area; };
    lines.add(worn.area, 1 / worn.area, creep(0), creep(1), creep(2));
  }
}

}  // namespace

const report::Section creep_chapter::area_law{report::table("table-law", law),
                                              report::figure("fig-law", law_figure)};
