/***
## The actual area, from a replica

The area enters $X$, so it must be known. A worn wheel is neither smooth nor of Hertz's shape, and
the paper measures its contact: a replicating tape is pressed between the wheels and keeps the
impression. With the full axes $a_R$, $b_R$ of the impression and $a_T$, $b_T$ of the contact, their
areas and the ratio of these are

$$A_R=\tfrac\pi4a_Rb_R, \tag{3}$$

$$A_T=\tfrac\pi4a_Tb_T, \tag{4}$$

$$\frac{A_T}{A_R}=\frac{a_Tb_T}{a_Rb_R}. \tag{5}$$

The impression is larger than the contact, since the tape has a thickness. The paper takes the two
to be similar, with one factor $C$ for both axes,

$$\frac{a_T}{a_R}=\frac{b_T}{b_R}=C, \tag{6}$$

$$A_T=C^2A_R, \tag{7}$$

and finds $C$ from the width of the track that rolling leaves. No thickness of the tape and no $C$
is printed, so what follows is a model and no test of the paper: we ask what smooth wheels would
give. Outside the contact their surfaces are apart by the gap

$$g=\frac{x^2}{2R_x}+\frac{y^2}{2R_y}-\delta
   +\frac{p_0ab}{2E^*}\int_\lambda^\infty\left[1-\frac{x^2}{a^2+t}-\frac{y^2}{b^2+t}\right]\frac{dt}{\sqrt{(a^2+t)(b^2+t)\,t}}.$$

Here $y$ is the place across, $\delta$ how far the two wheels approach each other by elastic
deformation, $p_0$ Hertz's largest pressure and $E^*$ the effective modulus of steel on steel.
$\lambda$ is the positive $t$ at which the bracket vanishes, or zero inside the contact. The first
two terms are the gap of the undeformed wheels, the integral is what the pressure adds. The function
`surface` computes the last term. It is needed on the two axes only, where $\lambda$ is $x^2-a^2$ or
$y^2-b^2$, and takes $t=\lambda+a^2v^2$, which removes the root of $t$ from the denominator:

{{code: replica.cpp surface}}

The impression is taken as the region where $g$ is smaller than the thickness of the tape, which
offers no resistance. `impression` seeks its end along one axis:

{{code: replica.cpp impression}}

{{table-replica}}

The impression of such a tape is larger than the contact, as the paper says
{{outcome:table-replica/larger}}, but not similar to it. The thicker the tape, the closer its ratio
of axes comes to {{ratio-gap}}, that of the undeformed gap, $\sqrt{R_x/R_y}$. So equation (7) would
lose {{loss-10}} of the area with a tape of 10 µm. The paper also extrapolates the area to a tape of
no thickness. With this tape a straight line through 10 and 20 µm would end {{line-excess}} above
the true area, since the area grows with a fractional power of the thickness.

The paper found agreement with theory both for the ratio of the axes and for the extrapolated area.

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <railbook/num/quadrature.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/report/values.hpp>

#include "rig.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

namespace {

// The displacement in the gap above, from t = lambda = x^2 - a^2 or y^2 - b^2 on, whichever is
// positive.
double surface(const contact::HertzContact& c, double x, double y) {
  const double lambda = std::max({0.0, x * x - c.a * c.a, y * y - c.b * c.b});
  const double unit = c.a * c.a;
  const auto integrand = [&](double v) {  // t = lambda + a^2 v^2
    const double t = lambda + unit * v * v, a2 = c.a * c.a + t, b2 = c.b * c.b + t;
    return (1 - x * x / a2 - y * y / b2) / std::sqrt(a2 * b2) *
           (t > 0 ? v / std::sqrt(t) : 1 / c.a);
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

// The ratio of the axes of the gap between undeformed wheels.
double gap_ratio(const contact::HertzContact& c) {
  return std::sqrt(c.curvature.b / c.curvature.a);
}

void tape(report::Item& item) {
  item.rebuilt(
      "the tapes and their results are not printed; smooth wheels and a tape without force");
  item.columns({{"thickness, µm", "{:g}"},
                {"ratio of the axes", "{:.3f}"},
                {"area over the contact's", "{:.3f}"},
                {"area by (7) over the contact's", "{:.3f}"}});
  const auto c = rig_contact(paper_load, profile_radius(true));
  double least = units::infinity;  // area over the contact's
  for (const double thickness : {1.0, 2.0, 5.0, 10.0, 20.0}) {
    const Replica r = replica_of(c, thickness * 1e-6);
    least = std::min(least, r.area);
    item.add_row(thickness, r.ratio, r.area, r.by_width);
  }
  const Replica middle = replica_of(c, 10e-6), thick = replica_of(c, 20e-6);
  item.expect_checks(3);
  item.claims({{"larger", {middle.area, least}}});
  item.agree("approach", "displacement of the centre", "m", surface(c, 0, 0), c.approach, 1e-8,
             "Hertz's approach");
  item.agree("thin", "area of the impression of a tape of 1 nm", "", replica_of(c, 1e-9).area, 1,
             5e-3, "the contact's");
  item.at_most("similitude", "area that (7) loses with a tape of 10 µm", "", 1 - middle.by_width,
               1 - gap_ratio(c) / axis_ratio,
               "that of an infinitely thick tape, whose ratio is that of the gap");
  item.value("ratio-gap", gap_ratio(c), "", "{:.3f}");
  report::values(item, "%", "{:.0f}", "loss-10", 100 * (1 - middle.by_width), "line-excess",
                 100 * (2 * middle.area - thick.area - 1));
}

}  // namespace

const report::Section creep_chapter::replica{report::table("table-replica", tape)};
