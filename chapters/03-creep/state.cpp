/***
## The one reading that is printed

Appendix B gives a complete reading: 4449.72 N, $\mu$ = 0.3 for five hours, 442.6 and 99.2 rpm, and
both radii. With the speeds as printed the creep is {{creep}}, and with the longer axis along rolling
$G\,ab\,\xi/N$ = {{group}} by Hertz's area. Is this evidence for the paper's claim?

No friction law can exceed the linear theory, $f\le C_{11}X$. With Hertz's area that allows only
$\mu\le C_{11}\,G\,ab\,\xi/N$ = {{mu-most}} for *any* $\mu_c$, less than the measured 0.3. So the
reading would need a larger area. The function `least_factor` divides the measured 0.3 by that
bound, and `factor` asks the full curve for the area at a given $\mu_c$:

{{code: state.cpp factor}}

{{code: state.cpp least_factor}}

{{table-state}}

It is no evidence. The two speeds are printed to 0.1 rpm, and within that rounding the creep is
{{creep-range}}: its second digit is unknown. The area that is needed at the least, for a very large
$\mu_c$, is then {{least-along}} times Hertz's with the longer axis along rolling and {{least-across}}
times with it across. With the errors of Appendix A it is {{least-independent}} along if they are
independent, and {{least-worst}} at worst. So Hertz's area explains the reading as well as a worn one
does, if $\mu_c$ is large; for $\mu_c$ = 0.5 the factor as printed is {{half-along}} along and
{{half-across}} across. {{outcome:table-state/true-area}}

{{fig-state}}

One more doubt remains. If the abscissa was computed with full axes and compared with Kalker's curve
for semi-axes, the reading fits Hertz's area along rolling at $\mu_c$ = {{mu-full-axes}} without any
wear.

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/num/roots.hpp>
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
      "areas are over Hertz's; from the printed speeds, radii, load and friction; the "
      "material and the direction of the major axis are not printed");
  const auto add = [&](const std::string& what, double creep) {
    item.add_row(what, creep, friction_at_most(creep, true), least_factor(creep, true),
                 factor(0.5, creep, true), friction_at_most(creep, false),
                 least_factor(creep, false), factor(0.5, creep, false));
  };
  const CreepError error = appendix_a_error();
  add("as printed", printed_creep);
  add("radii as printed, their last digits cut", 1 - 10.0548 / 44.9478 * small_rpm / big_rpm);
  add("442.65 and 99.15 rpm", least_creep);
  add("442.55 and 99.25 rpm", most_creep);
  add("smaller by Appendix A's errors, independent", printed_creep - error.independent);
  add("larger by them", printed_creep + error.independent);
  add("smaller by Appendix A's errors at their worst", printed_creep - error.worst);
  add("larger by them", printed_creep + error.worst);

  const auto range = [&](bool along) {
    return fmt::format("{:.2f} to {:.2f}", least_factor(most_creep, along),
                       least_factor(least_creep, along));
  };
  item.expect_checks(1);
  item.consistent("true-area",
                  "in order to obtain a single curve the actual area of contact must be used",
                  std::max(least_factor(least_creep, true), least_factor(least_creep, false)) > 1,
                  fmt::format("the printed reading needs at least {} times Hertz's area along, {} "
                              "across",
                              range(true), range(false)),
                  "one reading, whose creep the rounding of its speeds leaves open; the points are "
                  "lost");
  item.value("creep", printed_creep, "", "{:.4f}");
  item.value("creep-range", fmt::format("{:.4f} to {:.4f}", least_creep, most_creep));
  item.value("group", hertz_group(paper_load) * printed_creep, "", "{:.3f}");
  item.value("mu-most", friction_at_most(printed_creep, true), "", "{:.2f}");
  item.value("least-along", range(true));
  item.value("least-across", range(false));
  const auto within = [&](double off) {
    return fmt::format("{:.2f} to {:.2f}", least_factor(printed_creep + off, true),
                       least_factor(printed_creep - off, true));
  };
  item.value("least-independent", within(error.independent));
  item.value("least-worst", within(error.worst));
  item.value("half-along", factor(0.5, printed_creep, true), "", "{:.1f}");
  item.value("half-across", factor(0.5, printed_creep, false), "", "{:.1f}");
  const auto misread = [&](double friction) {
    return friction * master_curve(4 * hertz_group(paper_load) * printed_creep / friction) -
           printed_friction;
  };
  item.value("mu-full-axes", num::find_root(misread, 0.29, 0.6, 1e-9).x, "", "{:.2f}");
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
  item.rebuilt("from the printed speeds, radii, load and friction; the material is not printed");
}

}  // namespace

const report::Section creep_chapter::state{
    report::table("table-state",
                  "Within the rounding of its speeds the reading needs a larger area, or does not. "
                  "The area over Hertz's that gives the printed friction: at the least, and for a "
                  "largest friction of 0.5; with the longer axis along rolling or across",
                  needed_area),
    report::figure(
        "fig-state",
        "The printed reading does not decide between Hertz's area and a larger one. The area that "
        "it needs, over Hertz's, against the largest friction that is assumed; lines as printed, "
        "bands for the rounding of the two speeds; the band of the longer axis across reaches "
        "below 1, which is Hertz's area. From the numbers of Appendix B.",
        reading)};
