/***
### The true area, from a replica

A worn wheel is neither smooth nor of Hertz's shape, so the paper measures the contact. A
replicating tape is pressed between the wheels; its impression has the axes $a_R$, $b_R$, the
contact $a_T$, $b_T$, and with

$$A_R=\tfrac\pi4a_Rb_R, \tag{3}$$

$$A_T=\tfrac\pi4a_Tb_T, \tag{4}$$

$$\frac{A_T}{A_R}=\frac{a_Tb_T}{a_Rb_R}, \tag{5}$$

$$\frac{a_T}{a_R}=\frac{b_T}{b_R}=C, \tag{6}$$

$$A_T=C^2A_R \tag{7}$$

the width of the track that rolling leaves gives $C$. No tape thickness and no $C$ is printed. What
would smooth wheels give? Outside the contact the surfaces are apart by

$$g=Ax^2+By^2-\delta+\frac{p_0ab}{2E^*}\int_\lambda^\infty\left[1-\frac{x^2}{a^2+s}-\frac{y^2}{b^2+s}\right]\frac{ds}{\sqrt{(a^2+s)(b^2+s)s}},$$

$\lambda$ the positive root at which the bracket vanishes. Here $A$ and $B$ are half the curvatures
of the gap along and across, $\delta$ is Hertz's approach, $p_0$ his largest pressure and $E^*$ the
modulus of steel on steel. The impression is taken as the region where $g$ is smaller than the
thickness of the tape, which offers no resistance.

{{table-replica}}

The impression of such a tape is larger than the contact, as the paper says
{{outcome:table-replica/larger}}, but not similar to it: its ratio of axes falls towards
$\sqrt{B/A}$ = {{ratio-gap}} of the undeformed gap. So equation (7) would lose {{loss-10}} of the
area with a tape of 10 µm, and a straight line through 10 and 20 µm, extrapolated to zero thickness,
would end {{line-excess}} above the true area, since the area grows with a fractional power of the
thickness. The paper found agreement in both. Its tape is not described, and one that is squeezed
flat acts thinner than it is; so this is a fact about the tape assumed here, not about the paper's.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <railbook/num/quadrature.hpp>
#include <railbook/num/roots.hpp>

#include "rig.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

namespace {

// The integral above from lambda = x^2 - a^2 or y^2 - b^2 on, whichever is positive.
double surface(const contact::HertzContact& c, double x, double y) {
  const double lambda = std::max({0.0, x * x - c.a * c.a, y * y - c.b * c.b});
  const double unit = c.a * c.a;
  const auto integrand = [&](double v) {  // s = lambda + a^2 v^2
    const double s = lambda + unit * v * v, p = c.a * c.a + s, q = c.b * c.b + s;
    return (1 - x * x / p - y * y / q) / std::sqrt(p * q) * (s > 0 ? v / std::sqrt(s) : 1 / c.a);
  };
  const double whole =
      num::integrate(integrand, 0, std::numeric_limits<double>::infinity(), 1e-10).value;
  return c.p_max * c.a * c.b / modulus() * unit * whole;
}

// Half an axis of the impression of a tape, along x or across.
double impression(const contact::HertzContact& c, double thickness, bool along) {
  const double half = along ? c.a : c.b, curvature = along ? c.curvature.a : c.curvature.b;
  const auto miss = [&](double r) {
    return curvature * r * r - c.approach + surface(c, along ? r : 0, along ? 0 : r) - thickness;
  };
  return num::find_root(miss, half * (1 + 1e-9), 8 * half, 1e-9).x;
}

struct Replica {
  double ratio = 0;     // of its axes
  double area = 0;      // over that of the contact
  double by_width = 0;  // C^2 A_R over the area of the contact, C from the track's width
};
Replica replica_of(const contact::HertzContact& c, double thickness) {
  const double a = impression(c, thickness, true), b = impression(c, thickness, false);
  const double area = a * b / (c.a * c.b), share = c.b / b;
  return {a / b, area, share * share * area};
}

void tape(report::Item& item) {
  item.rebuilt(
      "the tapes and their results are not printed; smooth wheels and a tape without force");
  item.columns({{"thickness, µm", "{:g}"},
                {"ratio of the axes", "{:.3f}"},
                {"area over the contact's", "{:.3f}"},
                {"area by (7) over the contact's", "{:.3f}"}});
  const auto c = rig_contact(paper_load, profile_radius(true));
  bool larger = true;
  for (const double thickness : {1.0, 2.0, 5.0, 10.0, 20.0}) {
    const Replica r = replica_of(c, thickness * 1e-6);
    larger = larger && r.area > 1;
    item.add_row(thickness, r.ratio, r.area, r.by_width);
  }
  const Replica middle = replica_of(c, 10e-6), thick = replica_of(c, 20e-6);
  const double of_gap = std::sqrt(c.curvature.b / c.curvature.a);  // between undeformed wheels
  item.expect_checks(4);
  item.consistent("larger", "for smooth surfaces the replica's area is larger than the contact's",
                  larger, fmt::format("{:.2f} times at 10 µm", replica_of(c, 10e-6).area),
                  "the tape is not described; computed for one that gives way freely");
  item.agree("approach", "displacement of the centre", "m", surface(c, 0, 0), c.approach, 1e-8,
             "Hertz's approach");
  item.agree("thin", "area of the impression of a tape of 1 nm", "", replica_of(c, 1e-9).area, 1,
             5e-3, "the contact's");
  item.at_most("similitude", "area that (7) loses with a tape of 10 µm", "", 1 - middle.by_width,
               1 - of_gap / axis_ratio,
               "that of an infinitely thick tape, whose ratio is that of the gap");
  item.value("ratio-gap", of_gap, "", "{:.3f}");
  item.value("loss-10", 100 * (1 - middle.by_width), "%", "{:.0f}");
  item.value("line-excess", 100 * (2 * middle.area - thick.area - 1), "%", "{:.0f}");
}

}  // namespace

const report::Section creep_chapter::replica{
    report::table("table-replica", "What a tape between smooth wheels shows", tape)};
