/***
## Why a wheelset steers

A *wheelset* is two wheels on one axle that turn together. The running surface of a wheel, its
*tread*, is a cone or a hollow worn into it; a *flange* at its inner edge keeps it on the rail. When
the wheelset stands a distance $x_w$ left of the middle of the track, its left wheel rolls on a
radius $r_L$ that is larger than the right one, $r_R$. The left side then runs ahead, the wheelset
turns to the right, rolls back across the middle, and the same happens on the other side.

The *conicity* $\lambda$ measures this: $r_L-r_R=2\lambda x_w$ for small $x_w$. So a wheelset runs
in a wave, whose length does not depend on the speed. The faster the car runs through this wave, the
larger are the forces of inertia; above some speed they make the wave grow.

**Constraint functions.** A wheelset on two rails cannot rise or roll about the track's axis by
itself: its place across the track decides how it lies. Five functions of the lateral displacement
$x_w$ therefore say all that the dynamics needs: the rolling radii $r_L$ and $r_R$, the angles
$\delta_L$ and $\delta_R$ between the axle and the planes in which wheel and rail touch, and the
roll angle $\phi_w$, positive when the left side rises. The equations of motion contain them as
three odd functions without a unit,

$$R=\frac{r_L-r_R}{2a},\qquad D=\frac{\delta_L-\delta_R}2,\qquad\Phi=\phi_w,$$

where $a$ is half the distance between the two contact points. $R$ steers; $D$ and $\Phi$ push the
wheelset back to the middle, because the rails' forces lean inwards where the contact planes do.

**Profiles.** The paper takes a new wheel on a worn rail, the Canadian National's worn-wheel profile
A (CN) on a new rail, and a modified Heumann wheel, made to touch the worn rail in one point only.
The *gauge*, the distance between the rails' inner faces, is {{gauge}}. The profiles themselves are
lost. Ours are chains of circular arcs and straight lines without corners:

::: {.fold summary="The arcs of our profiles"}

* Rails have a crown of 10 in radius, shoulders of 1¼ in and corners of 3/8 in when new, are flatter
  and then sharper when worn, and lean inwards by 1:40.
* The new wheel is a cone of 1:20, and an arc of 11/16 in radius (the *throat*) leads to the flange.
  CN profile A has a hollow of {{cn-radius}} radius and the Heumann wheel one of {{heumann-radius}}.
  All flanges stand at 70°.

The remaining lengths were chosen so that the profiles have the properties that the text states.
They can therefore not test those statements; a test of the library makes sure that they have them.
The paper calls $a$ half the gauge, which would be {{half-gauge}}; its value is {{half-spacing}},
half the distance of the rails' *heads*.

:::

**Contact.** Wheelset and rails are rigid, so both sides touch where the vertical gap is least. The
place is found arc by arc:

::: {.fold summary="The least gap between two chains of arcs"}

Let $h(x_w,\phi_w)$ be the least vertical gap between the left wheel and its rail when the wheelset
is moved by $x_w$ and rolled by $\phi_w$ at a given height. Both sides must touch at once, and the
right side is the mirror image of the left one, so

$$h(x_w,\phi_w)=h(-x_w,-\phi_w),$$

which fixes $\phi_w$. The gap between an arc of the wheel (centre $u_w$ across the track, radius
$\rho_w$) and one of the rail ($u_r$, $\rho_r$) is stationary where both have the same slope angle
$\alpha$,

$$\sin\alpha=\frac{u_r-u_w}{\rho_w-\rho_r}.$$

Where that place is not on both arcs, the gap is least at an end of the stretch that they share. The
function `least_gap` walks along both chains at once. On each stretch that an arc of the wheel and
one of the rail share it offers three candidates: the place where the arcs are parallel, if there is
one, and the two ends. The least of all is the contact, exact to rounding.

{{code: wheelset/wheelset_contact.cpp least_gap}}

:::

{{fig-03}}

::: {.fold summary="The same for the CN and the Heumann wheel"}

{{fig-04}}

{{fig-05}}

:::

The lower part of each figure shows the left wheel lifted off its rail; lines join the points that
touch while the wheelset moves from {{far}} right to {{far}} left. Where the contact jumps from one
place to another, two points touch at once, which is called *two-point contact* (the thick pair of
lines), and the functions jump. The equations of motion contain them as tables with a value every
0.0025 in. We smooth the tables by a running mean over {{mean}}, which turns a jump into a ramp;
{{stability-range}} shows what this width does to the results.

**Flange contact** is a term that the paper does not define. Here it begins where the left wheel
leaves its tread for the arc between tread and flange, less half the width of the running mean: at
{{flange-new}} with new wheels, {{flange-cn}} with CN and {{flange-heumann}} with Heumann wheels.
For the new wheel this is the jump to the flange, at {{jump-new}}. The two worn profiles have a
rounding first, a *fillet*. A CN wheel comes to its fillet at a contact angle of only {{fillet-cn}},
and jumps to the flange at {{jump-cn}} ({{jump-heumann}} with Heumann wheels). Where a claim below
needs the jump and not the fillet, its row says so.

::: {.fold summary="How words of the paper, as nearly and much, are read as numbers"}

Each word of the paper is read alike in the whole chapter, by one rule. The rule was written down
when first results were known, so it is no prediction. *Constant*, *vertical*, *the same* mean
within 1 %, the width of a printed line. *Nearly*, *about*, *insignificant* mean a tenth; *small*
and *low* mean below half. *Much*, *large*, *rapidly*, *drastically*, *abruptly* mean by a factor of
1.41 ($\sqrt2$, as near to the same as to twice) or more; *slightly* means by a smaller factor, and
*several* by two or more.

:::

::: {.fold summary="What the text says of the three wheels, and what was found"}

{{geometry-claims}}

:::

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/report/values.hpp>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace profiles;
using namespace wheelset;

constexpr double far = 0.75 * inch;  // the tables' end

double flange_begins(const WheelsetOnTrack& pair, double running_mean) {
  constexpr double knot = 0.0025 * inch, tread_radius = 2 * inch;  // arcs of less are no tread
  const auto fillet = std::ranges::find_if(pair.wheel().pieces(),
                                           [](const Piece& p) { return p.radius < tread_radius; });
  double x = knot;
  while (x < far && pair.contact(x).left.on_wheel.u < fillet->start.u) x += knot;
  return x - knot - running_mean / 2;
}

double flange_jump(const WheelsetOnTrack& pair) {
  return contact_jumps(pair, 0, far, 1e-4).at(0).x;
}

namespace {

constexpr double lift = 0.8;  // of the wheel in the drawing [in]
const double a = paper_track.half_spacing;
const NamedPair &fresh = paper_pairs[0], &cn = paper_pairs[1], &heumann = paper_pairs[2];

void outline(const Curve& curve, double head, double above, report::Data& data) {
  for (int i = 0; i <= 150; ++i) {
    const double u = std::lerp(curve.start().u, curve.end().u, i / 150.0);
    data.add((u - head) / inch, curve.height(u) / inch + above);
  }
}

void join(const SideContact& at, double head, double above, report::Data& data) {
  data.add((at.on_wheel.u - head) / inch, at.on_wheel.z / inch + above);
  data.add((at.on_rail.u - head) / inch, at.on_rail.z / inch);
  data.gap();
}

void constraints(report::Item& item, const NamedPair& named) {
  item.rebuilt("the profiles are lost; these are chains of arcs chosen to the text");
  item.script("constraint.gp");
  const WheelsetOnTrack& pair = named.pair();
  report::Data& functions = item.data(
      {"x_over_a", "r_L_in", "r_R_in", "delta_L_rad", "delta_R_rad", "phi_rad", "R", "D_rad"});
  for (int i = 0; i <= 750; ++i) {
    const double x = far * i / 750;
    const auto at = pair.contact(x);
    functions.add(x / a, at.left.radius / inch, at.right.radius / inch, at.left.delta,
                  at.right.delta, at.roll, (at.left.radius - at.right.radius) / (2 * a),
                  0.5 * (at.left.delta - at.right.delta));
  }
  const double head = pair.rail().point_at_angle(paper_track.cant).u;
  const double above = lift + pair.contact(0).height / inch;
  outline(pair.wheel(), head, above, item.data("wheel", {"u_in", "z_in"}));
  outline(pair.rail(), head, 0, item.data("rail", {"u_in", "z_in"}));
  report::Data& lines = item.data("contacts", {"u_in", "z_in"});
  for (int i = -15; i <= 15; ++i) join(pair.contact(far * i / 15).left, head, above, lines);
  report::Data& twos = item.data("jumps", {"u_in", "z_in"});
  for (const auto& jump : contact_jumps(pair, -far, far, 1e-4)) {
    join(jump.before, head, above, twos);
    join(jump.after, head, above, twos);
  }
}

// How far a wheel's flange rises above the tread's height at the rolling circle [m].
double flange_height(const WheelsetOnTrack& pair) {
  const Curve& wheel = pair.wheel();
  const double circle = wheel.height(pair.contact(0).left.on_wheel.u);
  double lowest = circle;
  for (double t = 0; t <= 1; t += 0.001)
    lowest = std::min(lowest, wheel.height(std::lerp(wheel.start().u, wheel.end().u, t)));
  return circle - lowest;
}

double hollow_radius(const NamedPair& named) {
  return named.pair().wheel().pieces()[1].radius;
}

void geometry_claims(report::Item& item) {
  item.rebuilt("the profiles were chosen to have these properties");
  item.expect_checks(2);
  const ConstraintFunctions &n = fresh.table(), &c = cn.table();
  item.print("gauge-si", "nominal gauge, 56.5 in", "m", "1.435", 56.5 * inch);
  item.print("cn-slope", "slope of R, CN A over the new wheel's", "", "3",
             c.R.slope(0) / n.R.slope(0),
             report::fitted("the hollow's radius was chosen for \"about three times\"",
                            report::relative(words::nearly, "\"about\"")));
  item.columns({{"wheel"},
                {"first point of the fillet, in", "{:.3f}"},
                {"jump to the flange, in", "{:.3f}"}});
  for (const NamedPair& named : paper_pairs) {
    const double begins = flange_begins(named.pair()), jump = flange_jump(named.pair());
    item.add_row(named.name, (begins + table_mean / 2) / inch, jump / inch);
    item.value(fmt::format("flange-{}", named.key), begins / inch, "in", "{:.2f}");
    item.value(fmt::format("jump-{}", named.key), jump / inch, "in", "{:.2f}");
  }
  const double fillet = flange_begins(cn.pair(), 0);
  item.value("fillet-cn", cn.pair().contact(fillet).left.delta / units::degree, "°", "{:.1f}");
  report::values(item, "in", "{:.2f}", "mean", table_mean / inch, "flange-height",
                 flange_height(fresh.pair()) / inch, "half-gauge", 0.5 * paper_track.gauge / inch,
                 "half-spacing", a / inch, "far", far / inch);
  report::values(item, "in", "{:.1f}", "gauge", paper_track.gauge / inch, "cn-radius",
                 hollow_radius(cn) / inch, "heumann-radius", hollow_radius(heumann) / inch);
}

}  // namespace

const report::Section geometry{
    report::figure("fig-03", [](report::Item& item) { constraints(item, fresh); }),
    report::figure("fig-04", [](report::Item& item) { constraints(item, cn); }),
    report::figure("fig-05", [](report::Item& item) { constraints(item, heumann); }),
    report::table("geometry-claims", geometry_claims)};

}  // namespace railbook::hunting_chapter
