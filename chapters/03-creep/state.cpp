/***
### The one state that is printed

Appendix B gives a complete reading: 4449.72 N, $\mu$ = 0.3 for five hours, 442.6 and 99.2 rpm, and both radii. The creep
is {{creep}} from the diameters as measured, and {{creep-cut}} from the radii as printed, whose last digits are cut: so much hangs
on the digits. With Hertz's area $G\,ab\,\xi/N$ = {{group}}, so that even the linear theory, which no friction law can
exceed, allows $\mu\le C_{11}G\,ab\,\xi/N$ = {{mu-most}} **for any** $\mu_c$: below the 0.3 that was measured. Hertz's area
contradicts it. What area would not?

{{fig-state}}

For $\mu_c$ = 0.5 the area must be {{factor-05}} times Hertz's, for a very large $\mu_c$ still {{factor-least}} times; for
$\mu_c$ near 0.3 more than twice. So the paper's main claim, that the true area is the one to use, is supported by the only
reading it prints. Two reservations: a creep that is too small by the 0.0005 of Appendix A would do as well, though only for
a large $\mu_c$ (then {{factor-creep}}); and if the abscissa was computed with full axes and compared with Kalker's curve for
semi-axes, the reading fits Hertz's area at $\mu_c$ = {{mu-full-axes}} without any wear.
*/

#include <fmt/format.h>

#include <cmath>

#include "num/roots.hpp"
#include "rig.hpp"
#include "rolling/kalker_coefficients.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr double creep = printed_creep, printed_mu = printed_friction;

// The area over Hertz's that gives mu = 0.3 at this creep, for a largest friction.
double factor(double friction, double measured_creep) {
  const auto miss = [&](double x) { return friction * master_curve(x) - printed_mu; };
  return num::find_root(miss, 0, 2, 1e-13).x * friction /
         (hertz_group(paper_load) * measured_creep);
}

void reading(report::Item& item) {
  auto& lines = item.data({"mu_c", "factor", "creep_larger", "creep_smaller"});
  for (double friction = 0.302; friction <= 1.0; friction += 0.002)
    lines.add(friction, factor(friction, creep), factor(friction, creep + 0.0005),
              factor(friction, creep - 0.0005));
  item.rebuilt("from the printed speeds, radii, load and friction; the material is not printed");
  item.expect_checks(1);
  const double group = hertz_group(paper_load) * creep;
  const double slope = rolling::kalker_coefficients(axis_ratio, poisson).c11;
  const double least = printed_mu / (slope * group);  // for a friction without limit
  item.at_most("true-area", "largest friction that Hertz's area allows at the printed creep", "",
               slope * group, printed_mu, "the friction that the paper prints for this reading");
  item.value("creep", creep, "", "{:.7f}");
  item.value("creep-cut", 1 - 10.0548 / 44.9478 * small_rpm / big_rpm, "", "{:.7f}");
  item.value("group", group, "", "{:.5f}");
  item.value("mu-most", slope * group, "", "{:.3f}");
  item.value("factor-05", factor(0.5, creep), "", "{:.2f}");
  item.value("factor-least", least, "", "{:.2f}");
  item.value("factor-creep", least * creep / (creep + 0.0005), "", "{:.2f}");
  const auto misread = [&](double friction) {
    return friction * master_curve(4 * group / friction) - printed_mu;
  };
  item.value("mu-full-axes", num::find_root(misread, 0.29, 0.6, 1e-9).x, "", "{:.2f}");
}

}  // namespace

const report::Section creep_chapter::state{
    report::figure("fig-state", "The area that the printed reading needs", reading)};
