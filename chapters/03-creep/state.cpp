/***
## The one reading that is printed

Appendix B gives a complete reading: 4449.72 N, $\mu$ = 0.3 for five hours, 442.6 and 99.2 rpm, and
both radii. With the speeds as printed the creep is {{creep}}, and with the longer axis along
rolling $G\,ab\,\xi/N$ = {{group}} by Hertz's area. Is this evidence for the paper's claim?

In Kalker's theory sliding only takes force away from a contact in which nothing slides, so that
$f\le C_{11}X$, as the computed curve has it everywhere. With Hertz's area this allows only $\mu\le
C_{11}\,G\,ab\,\xi/N$ = {{mu-most}} for *any* $\mu_c$, less than the measured 0.3. So the reading
would need a larger area. How much larger depends on $\mu_c$: `factor` seeks the $X$ at which the
full curve gives 0.3 for a given $\mu_c$, and turns it into an area over Hertz's.

{{code: state.cpp factor}}

The least area is that of a $\mu_c$ without limit. `least_factor` divides the measured 0.3 by the
bound above, which is `friction_at_most`:

{{code: state.cpp least_factor}}

{{table-state}}

The reading does not decide the question. The two speeds are printed to 0.1 rpm, and within that
rounding the creep is {{creep-range}}: not one digit of it is certain. Without a limit of friction
the reading needs {{least-along}} times Hertz's area with the longer axis along rolling, and
{{least-across}} times with it across. With the errors of Appendix A instead of the rounding it is
{{least-independent}} along if they are independent, and {{least-worst}} at worst; both together, at
worst, give {{least-together}}. If these errors are rpm where the speeds are counts of teeth in a
second, they alone give {{least-teeth-independent}} and {{least-teeth-worst}}.

A finite $\mu_c$ raises these numbers. At $\mu_c$ = 0.5 they are {{half-along-range}} along and
{{half-across-range}} across, and along they stay above {{one-along-low}} even at $\mu_c$ = 1, a
friction higher than is usual for dry steel. So within the rounding of the speeds Hertz's area
explains the reading if the longer axis lies across, and hardly if it lies along. The paper does not
say how it lay {{outcome:table-state/true-area}}.

{{fig-state}}

If the paper computed $X$ with full axes, four times as large, and compared
it with Kalker's curve for semi-axes, then its plot puts this reading on the curve with Hertz's area
too, on the flat end for $\mu_c$ = {{mu-full-axes}}, and proves nothing.

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/num/roots.hpp>
#include <railbook/report/values.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>

#include "rig.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr double half_digit = 0.05;  // of the speeds, rpm

double creep_at(double small_speed, double big_speed) {
  return 1 - small_radius / big_radius * small_speed / big_speed;
}
const double least_creep = creep_at(small_rpm + half_digit, big_rpm - half_digit),
             most_creep = creep_at(small_rpm - half_digit, big_rpm + half_digit);

// The area over Hertz's that gives mu = 0.3 at a creep, for a largest friction.
double factor(double friction, double creep, bool along) {
  const auto miss = [&](double x) { return friction * master_curve(x, along) - printed_friction; };
  return num::find_root(miss, 0, 2, 1e-13).x * friction / (hertz_group(paper_load, along) * creep);
}

// The largest friction that Hertz's area allows at a creep, by the linear theory.
double friction_at_most(double creep, bool along) {
  const double ratio = along ? axis_ratio : 1 / axis_ratio;
  return kalker_coefficients(ratio, poisson).c11 * hertz_group(paper_load, along) * creep;
}

// The same area for a friction without limit.
double least_factor(double creep, bool along) {
  return printed_friction / friction_at_most(creep, along);
}

// What the printed friction asks for at a creep.
struct Need {
  double friction_at_most = 0, least_area = 0, area_at_half = 0;  // areas over Hertz's
};
Need need(double creep, bool along) {
  return {friction_at_most(creep, along), least_factor(creep, along), factor(0.5, creep, along)};
}

// The creep of the printed reading, by what could be read otherwise.
std::vector<std::pair<const char*, double>> possible_creeps() {
  const CreepError error = appendix_a_error();
  return {{"as printed", printed_creep},
          {"radii as printed, their last digits cut", 1 - 10.0548 / 44.9478 * small_rpm / big_rpm},
          {"442.65 and 99.15 rpm", least_creep},
          {"442.55 and 99.25 rpm", most_creep},
          {"less Appendix A's errors, independent", printed_creep - error.independent},
          {"plus Appendix A's errors, independent", printed_creep + error.independent},
          {"less Appendix A's errors at worst", printed_creep - error.worst},
          {"plus Appendix A's errors at worst", printed_creep + error.worst}};
}

// The largest friction at which Hertz's area gives the reading if X is taken with full axes.
double friction_by_full_axes() {
  const auto miss = [&](double friction) {
    return friction * master_curve(4 * hertz_group(paper_load) * printed_creep / friction) -
           printed_friction;
  };
  return num::find_root(miss, 0.29, 0.6, 1e-9).x;
}

void needed_area(report::Item& item) {
  item.columns({"creep",
                {"ξ", "{:.5f}"},
                {"along: µ at most", "{:.3f}"},
                {"along: area at least", "{:.2f}"},
                {"along: area for µ_c = 0.5", "{:.2f}"},
                {"across: µ at most", "{:.3f}"},
                {"across: area at least", "{:.2f}"},
                {"across: area for µ_c = 0.5", "{:.2f}"}});
  item.rebuilt(
      "areas are over Hertz's; from the printed speeds, radii, load and friction; our copy prints "
      "neither material nor direction; errors in the unit of the speeds");
  for (const auto& [what, creep] : possible_creeps()) {
    const Need along = need(creep, true), across = need(creep, false);
    item.add_row(what, creep, along.friction_at_most, along.least_area, along.area_at_half,
                 across.friction_at_most, across.least_area, across.area_at_half);
  }
  const auto range = [&](std::string_view id, double low, double high) {
    item.value(id, fmt::format("{:.2f} to {:.2f}", low, high));
  };
  const Need along_low = need(most_creep, true), along_high = need(least_creep, true),
             across_low = need(most_creep, false), across_high = need(least_creep, false);
  item.claims(
      {{"true-area",
        {along_low.least_area, along_high.least_area, across_low.least_area, across_high.least_area,
         std::max(along_high.least_area, across_high.least_area)}}});
  item.value("creep", printed_creep, "", "{:.4f}");
  item.value("creep-range", fmt::format("{:.4f} to {:.4f}", least_creep, most_creep));
  item.value("group", hertz_group(paper_load) * printed_creep, "", "{:.3f}");
  range("least-along", along_low.least_area, along_high.least_area);
  range("least-across", across_low.least_area, across_high.least_area);
  range("half-along-range", along_low.area_at_half, along_high.area_at_half);
  range("half-across-range", across_low.area_at_half, across_high.area_at_half);
  const CreepError error = appendix_a_error();
  range("least-independent", least_factor(printed_creep + error.independent, true),
        least_factor(printed_creep - error.independent, true));
  range("least-worst", least_factor(printed_creep + error.worst, true),
        least_factor(printed_creep - error.worst, true));
  range("least-together", least_factor(most_creep + error.worst, true),
        least_factor(least_creep - error.worst, true));
  range("least-teeth-independent", least_factor(printed_creep + error.independent_by_teeth, true),
        least_factor(printed_creep - error.independent_by_teeth, true));
  range("least-teeth-worst", least_factor(printed_creep + error.worst_by_teeth, true),
        least_factor(printed_creep - error.worst_by_teeth, true));
  report::values(item, "", "{:.2f}", "mu-most", friction_at_most(printed_creep, true),
                 "one-along-low", factor(1, most_creep, true), "mu-full-axes",
                 friction_by_full_axes());
}

void reading(report::Item& item) {
  auto& lines = item.data(
      {"mu_c", "along", "along_low", "along_high", "across", "across_low", "across_high"});
  for (int i = 0; i <= 349; ++i) {
    const double friction = 0.302 + 0.002 * i;
    lines.add(friction, factor(friction, printed_creep, true), factor(friction, most_creep, true),
              factor(friction, least_creep, true), factor(friction, printed_creep, false),
              factor(friction, most_creep, false), factor(friction, least_creep, false));
  }
  item.rebuilt("from the printed speeds, radii, load and friction; our copy prints no material");
}

}  // namespace

const report::Section creep_chapter::state{report::table("table-state", needed_area),
                                           report::figure("fig-state", reading)};
