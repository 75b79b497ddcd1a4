/***
## Creep times area is constant

If $f=\mu/\mu_c$ depends on $X=G\,ab\,\xi/\mu_cN$ only, then at the same load, friction and force the
product of creep and area is constant: a worn wheel with a larger contact creeps less. The paper
states this for tests whose wear was "kept to a level preserving the elliptical contact with a
preestablished ratio of the major to the minor axis". The function `products` seeks, on any ellipse,
the $X$ at which a given fraction of the friction is used, and turns it into creep times area:

{{code: area_law.cpp products}}

**With that ratio kept** the law is exact in Kalker's theory, which for one ratio of axes, Poisson's
ratio and friction law has no other variable than $X$. It does not depend on how much the area
grows, on the fraction of the friction that is used, or on the direction of the longer axis
{{outcome:table-law/constant}} {{outcome:table-law/scale}}. Carter's plane theory says the same of a
contact that is $2a$ long: for a load $P$ and a traction $Q$ per width,
$\xi a=4\mu_cP\,(1-\sqrt{1-Q/\mu_cP})/\pi E^*$ contains no radius at all
{{outcome:table-law/carter}}.

**When the ratio changes** the law does not hold. Suppose that wear flattens only the profile of the
small wheel and leaves its rolling radius. Then the contact grows across, the ellipse becomes
rounder and then wide, and Kalker's coefficient $C_{11}$ falls with $a/b$.

{{table-law}}

{{fig-law}}

With a profile {{flatter}} times as flat the area grows by {{area-moderate}} and the product rises
by {{rise-moderate}}; with one three times as flat it rises by {{rise-worst}}, and the public
program CONTACT agrees {{outcome:table-law/contact}}. Most of the rise is the initial slope: the
ratio of the computed coefficients $C_{11}$ alone gives {{rise-slope}}.

**Could the rig have seen it?** At the creep that Appendix B prints, {{rise-worst}} is
{{rise-seen}}, less than the 0.0005 to which a reading is accurate. At 80 % of a largest friction of
0.5 the creep is {{creep-80}}, and the rise is {{rise-80}}, or {{rise-80-grown}} for the worn wheel,
whose larger area creeps less; both are more than 0.0005. And a test has many readings. By the
reduction of the section before, with the stated errors, the product of one test has a standard
deviation of {{product-scatter}}. So a pair of tests, new and worn, shows {{rise-worst}} at
{{sigmas-worst}} standard deviations and {{rise-moderate}} at {{sigmas-moderate}}.

The larger rise could have been seen in a few pairs of tests, the smaller not
{{outcome:table-law/visible}}. The paper changed its wheels when the ellipse lost its ratio of axes,
and so kept to the domain in which its law is exact.

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/num/roots.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>

#include "rig.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr std::array used_shares{0.25, 0.5, 0.8};

// What a test of new and one of worn wheels show of a rise of creep times area, in standard deviations.
double sigmas(double rise) {
  const ReductionError error = reduction_error();
  return rise / (std::sqrt(2.0) * std::hypot(error.fitted, error.measured));
}

// Creep times area [m^2] at which the contact uses each of the shares of a friction of 0.3.
std::array<double, 3> products(const contact::HertzContact& c, Eigen::Index cells) {
  const EllipseRolling full(c.a / c.b, poisson, {.along = cells, .rows = cells / 2});
  const RollingCase unit = normalised_case(c.a / c.b, poisson);
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
        used_shares, [&](double one) { return std::abs(one - s.number) < 1e-9; });
    return share == used_shares.end()
               ? units::nan
               : change(1.5, static_cast<std::size_t>(share - used_shares.begin()), true);
  });
  trial.vary("major axis", [&](const report::Setting& s) { return change(1.5, 1, s.index == 0); });
  return trial;
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
  double most = 0, apart = 0;
  for (const double factor : {1.25, 1.5, 1.966, 3.0}) {
    const auto c = rig_contact(paper_load, factor * profile_radius(true));
    const std::string key = fmt::format("x{:g}", factor);
    std::array<double, 3> rise = products(c, 24);
    for (std::size_t k = 0; k < 3; ++k) {
      rise[k] = rise[k] / base[k] - 1;
      most = std::max(most, rise[k]);
      const auto& program = other.at(key, fmt::format("rise_{:g}", 100 * used_shares[k]));
      apart = std::max(apart, std::abs(rise[k] - report::printed_number(program) / 100));
    }
    const double by_slope = slope(fresh) / slope(c) - 1;
    item.add_row(fmt::format("× {:g}", factor), c.a / c.b, units::pi * c.a * c.b / 1e-6,
                 100 * rise[0], 100 * rise[1], 100 * rise[2], 100 * by_slope);
    const double grown = c.a * c.b / (fresh.a * fresh.b);
    if (factor == 1.25) {
      item.value("rise-moderate", 100 * rise[1], "%", "{:.1f}");
      item.value("flatter", factor, "", "{:g}");
      item.value("area-moderate", 100 * (grown - 1), "%", "{:.1f}");
      item.value("sigmas-moderate", sigmas(rise[1]), "", "{:.1f}");
    } else if (factor == 3) {
      item.value("rise-worst", 100 * rise[1], "%", "{:.0f}");
      item.value("rise-slope", 100 * by_slope, "%", "{:.0f}");
      item.value("sigmas-worst", sigmas(rise[1]), "", "{:.1f}");
      item.claims({{"visible", {sigmas(rise[1])}}});
      // Creep at 80 % of a largest friction of 0.5; the products are those of 0.3.
      const double creep_80 = base[2] * (0.5 / 0.3) / (units::pi * fresh.a * fresh.b);
      item.value("creep-80", creep_80, "", "{:.4f}");
      item.value("rise-80", creep_80 * rise[2], "", "{:.5f}");
      item.value("rise-80-grown", creep_80 * rise[2] / grown, "", "{:.5f}");
    }
  }
  item.expect_checks(2);
  item.value("product-scatter",
             100 * std::hypot(reduction_error().fitted, reduction_error().measured), "%", "{:.0f}");
  item.at_most("contact", "largest difference from CONTACT's rises", "", apart, 0.005,
               "its 45 x 45 cells are uncertain by 0.003");
  item.value("rise-seen", most * printed_creep, "", "{:.5f}");
  const report::Trial trial = ratio_kept(item);
  item.claims({{"constant", {}, trial}});
  const auto doubled = contact::hertz_from_force(
      {.a = 0.25 / rolling_radius, .b = 0.25 / profile_radius(true)}, modulus(), paper_load);
  item.agree("scale", "creep times area for half of the friction, both radii doubled", "m^2",
             products(doubled, 24)[1], base[1], 1e-7, "the rig itself");
  // Carter: a^2 = 4 P R/(pi E*) for a load P per width; xi = (1 - sqrt(1 - Q/mu P)) mu a/R.
  const auto carter_product = [](double radius) {
    const double load = 1e5, a = std::sqrt(4 * load * radius / (units::pi * modulus()));
    return (1 - std::sqrt(1 - 0.64)) * 0.3 * a / radius * a;
  };
  item.claims({{"carter", {carter_product(0.2) / carter_product(0.1) - 1}}});
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
    report::table("table-law",
                  "Creep times area rises when only the profile wears flat. Rise of the product on "
                  "the rig against the new wheel, for three fractions of the friction, by the full "
                  "theory; last by the initial slope alone",
                  law),
    report::figure("fig-law",
                   "A contact that grows only across rolling creeps more than the law says. Left: "
                   "creep over that of the new wheel, at constant load and force, against the area "
                   "over that of the new wheel; right: by how much the product of both rises. Grey "
                   "is the paper's law; the paper refers to another report for its check.",
                   law_figure)};
