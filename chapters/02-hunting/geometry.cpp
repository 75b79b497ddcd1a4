/***
## Geometry of wheel and rail

A wheelset on rails has no freedom to roll or to rise of its own: where it stands across the track decides how it
lies. Five *constraint functions* of the lateral displacement $x_w$ say all that the dynamics needs: the rolling
radii $r_L$, $r_R$, the angles $\delta_L$, $\delta_R$ of the contact planes to the axle, and the roll angle $\phi_w$.
In the equations of motion they come as three odd functions,

$$R=\frac{r_L-r_R}{2a},\qquad D=\frac{\delta_L-\delta_R}2,\qquad\Phi=\phi_w;$$

the first steers, the other two push the wheelset back to the middle.

**What is lost.** The paper measured its profiles and gives none. It names them: a new wheel on a worn rail, the
Canadian National's worn-wheel profile A on a new rail, and a modified Heumann wheel on the worn rail, at a gauge of
{{gauge}}. Its figures are unreadable in the copy that is available.

**How they are rebuilt.** Each profile is a chain of circular arcs and straight lines without corners, as
drawings of wheels and rails are made. Rails have a 10 in crown, 1¼ in shoulders and 3/8
in corners when new, are flatter and then sharper when worn, and lean inwards by 1:40. The new wheel is a 1:20
cone with an 11/16 in throat; CN profile A has a hollow of {{cn-radius}} and the Heumann wheel one of
{{heumann-radius}}; all have a 70° flange. The free lengths were chosen so that the geometry has what
the text states, which these profiles therefore cannot test; {{geometry-claims}} holds them to it. The half spacing $a$ is {{half-spacing}}, the half
distance of the rails' *heads*; the paper calls it half the gauge, which would be {{half-gauge}}.

**Contact.** Roll the wheelset by $\phi$ and look at the vertical gap between wheel and rail on one side. Its
least value must be the same on both sides, $h(x,\phi)=h(-x,-\phi)$: that fixes $\phi$. With arcs $u=u_c+\rho\sin\theta$, $z=z_c+\rho\cos\theta$ the gap of
wheel and rail is stationary where both have the same angle,

$$\sin\theta=\frac{u_c^{rail}-u_c^{wheel}}{\rho_{wheel}-\rho_{rail}},$$

and where that falls outside the stretch the two arcs share, it is least at an end of the stretch. One walk along
both chains finds the least gap to rounding, two-point contact included:

{{code: wheelrail/wheelset_contact.cpp parallel}}

{{code: wheelrail/wheelset_contact.cpp least_gap}}

{{fig-03}}

{{fig-04}}

{{fig-05}}

In each figure the lower part shows the left wheel lifted off its rail; straight lines join the points that touch
while the wheelset moves from {{far}} right to {{far}} left. The red pair is a **two-point contact**: there
the wheel leaves one point and takes the other at once, and the functions jump. The equations of motion take them as tables with a knot every
0.0025 in and a running mean over 0.02 in, which makes a jump a ramp.

**Words as numbers.** The paper's statements are in words. Each word is read alike in the whole chapter, by one rule that was written down when first results were known:
*constant*, *vertical*, *the same*: within 1 %, the width of a printed line; *nearly*, *about*, *insignificant*: a tenth; *small*, *low*: below half;
*much*, *large*, *drastically*, *abruptly*: by $\sqrt2$ or more, nearer to twice than to the same; *slightly*: by less; *several*: twice or more.

{{geometry-claims}}

That all slopes with CN wheels are about three times those with new ones cannot be: the paper itself says later that the describing function of $\Phi$, which for small amplitudes is the slope, is slightly
smaller with CN wheels.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sections.hpp"
#include "units/constants.hpp"
#include "vehicles.hpp"
#include "wheelrail/paper_pairs.hpp"

namespace railbook::hunting_chapter {

using namespace wheelrail;
using units::inch;

namespace {

constexpr double far = 0.75 * inch;
constexpr double lift = 0.8;  // of the wheel in the drawing [in]
constexpr const char* profiles_lost =
    "the measured profiles are lost; these are chains of arcs chosen to the text";

// A curve as a polyline, in inches from the middle of the rail's head.
void outline(const Curve& curve, double head, double above, report::Data& data) {
  for (const Piece& p : curve.pieces()) {
    const int n = p.is_line() ? 1 : 24;
    for (int i = 0; i <= n; ++i) {
      const double angle = p.angle_start + (p.angle_end - p.angle_start) * i / n;
      const Point at = p.is_line() ? (i == 0 ? p.start : p.end)
                                   : Point{p.centre.u + p.radius * std::sin(angle),
                                           p.centre.z + p.radius * std::cos(angle)};
      data.add((at.u - head) / inch, at.z / inch + above);
    }
  }
}

void join(const SideContact& at, double head, double above, const char* kind, report::Data& data) {
  data.add((at.on_wheel.u - head) / inch, at.on_wheel.z / inch + above, kind);
  data.add((at.on_rail.u - head) / inch, at.on_rail.z / inch, kind);
  data.gap();
}

void constraint_figure(report::Item& item, const NamedPair& named) {
  item.rebuilt(profiles_lost);
  item.script("constraint.gp");
  const WheelsetOnTrack& pair = named.pair();
  const double a = paper_track.half_spacing;
  report::Data& functions = item.data(
      {"x_over_a", "r_L_in", "r_R_in", "delta_L_rad", "delta_R_rad", "phi_rad", "R", "D_rad"});
  constexpr int n = 1500;
  for (int i = 0; i <= n; ++i) {
    const double x = far * i / n;
    const auto at = pair.contact(x);
    functions.add(x / a, at.left.radius / inch, at.right.radius / inch, at.left.delta,
                  at.right.delta, at.roll, (at.left.radius - at.right.radius) / (2 * a),
                  0.5 * (at.left.delta - at.right.delta));
  }
  const double head = pair.rail().point_at_angle(paper_track.cant).u;
  const double above = lift + pair.contact(0).height / inch;
  outline(pair.wheel(), head, above, item.data("wheel", {"u_in", "z_in"}));
  outline(pair.rail(), head, 0, item.data("rail", {"u_in", "z_in"}));
  report::Data& lines = item.data("contacts", {"u_in", "z_in", "kind"});
  for (int i = -15; i <= 15; ++i) join(pair.contact(far * i / 15).left, head, above, "one", lines);
  report::Data& twos = item.data("jumps", {"u_in", "z_in", "kind"});
  for (const auto& jump : contact_jumps(pair, -far, far, 1e-4)) {
    join(jump.before, head, above, "two", twos);
    join(jump.after, head, above, "two", twos);
  }
}

void fig_03(report::Item& item) {
  constraint_figure(item, paper_pairs[0]);
}
void fig_04(report::Item& item) {
  constraint_figure(item, paper_pairs[1]);
}
void fig_05(report::Item& item) {
  constraint_figure(item, paper_pairs[2]);
}

struct Slopes {
  double R, D, Phi;  // per x/a
};

Slopes slopes(const WheelsetOnTrack& pair) {
  const double h = 1e-6;
  const auto at = pair.contact(h);
  return {0.5 * (at.left.radius - at.right.radius) / h,
          0.5 * (at.left.delta - at.right.delta) / h * paper_track.half_spacing,
          at.roll / h * paper_track.half_spacing};
}

// The largest departure of a function from its tangent at 0 for 0 < x < end, as a part of the tangent's value at the
// end.
double bend(const OddTable& f, double end) {
  double worst = 0;
  const double slope = f.slope(0);
  for (double x = 0; x < end; x += f.step()) worst = std::max(worst, std::abs(f(x) - slope * x));
  return slope == 0 ? worst : worst / (slope * end);
}

double largest_jump(const WheelsetOnTrack& pair) {
  double largest = 0;
  for (const auto& jump : contact_jumps(pair, 0, far, 1e-4))
    largest = std::max(largest, std::abs(jump.after.delta - jump.before.delta));
  return largest;
}

void straightness(report::Item& item) {
  const auto most = [](const NamedPair& named, double end) {
    const ConstraintFunctions& f = named.table();
    return std::max(bend(f.R, end), bend(f.Phi, end));
  };
  item.at_most("new-straight", "new wheel: R and Φ off their tangents before the flange", "",
               most(paper_pairs[0], flange_begins(new_wheel_pair())), words::nearly,
               "\"nearly linear until the flange\"");
  item.at_most("cn-straight", "CN A: R and Φ off their tangents before the flange", "",
               most(paper_pairs[1], flange_begins(cn_pair())), words::nearly,
               "\"nearly linear until flange contact\"");
  item.at_most("heumann-straight", "Heumann: R and Φ off their tangents up to 0.1 in", "",
               most(paper_pairs[2], 0.1 * inch), words::nearly,
               "\"approximately linear for small displacements\"");
}

void geometry_claims(report::Item& item) {
  item.rebuilt("the profiles were chosen to have these properties");
  item.expect_checks(9);
  item.columns(
      {"pair", {"R' at the centre, per x/a", "{:.5f}"}, {"D'", "{:.4f}"}, {"Φ'", "{:.5f}"}});
  for (const NamedPair& named : paper_pairs) {
    const Slopes s = slopes(named.pair());
    item.add_row(named.name, s.R, std::abs(s.D) < 1e-6 ? 0.0 : s.D, s.Phi);
  }
  item.print("gauge-si", "nominal gauge, 56.5 in", "m", "1.435", 56.5 * inch);
  straightness(item);
  const Slopes fresh = slopes(new_wheel_pair()), cn = slopes(cn_pair()),
               heumann = slopes(heumann_pair());
  item.print("cn-slope", "slope of R, CN A over the new wheel's", "", "3", cn.R / fresh.R,
             report::fitted("the hollow's radius was chosen for \"about three times\"",
                            report::relative(words::nearly, "\"about\"")));
  item.refute("cn-roll-slope", "CN A: the slope of Φ is about three times the new wheel's",
              cn.Phi < fresh.Phi, fmt::format("{:.2f} times", cn.Phi / fresh.Phi));
  item.at_least("heumann-steep", "Heumann: slopes of R and D over CN's, the lesser", "",
                std::min(heumann.R / cn.R, heumann.D / cn.D), words::much,
                "\"much steeper than those of either\"");
  item.at_least("heumann-several", "Heumann: slopes of R and Φ over the new wheel's, the lesser",
                "", std::min(heumann.R / fresh.R, heumann.Phi / fresh.Phi), words::several,
                "\"several times larger\"");
  item.at_most("heumann-single", "Heumann: largest jump of the angle over the new wheel's", "",
               largest_jump(heumann_pair()) / largest_jump(new_wheel_pair()), words::nearly,
               "\"closely approximates single-point contact\"");
  item.value("gauge", paper_track.gauge / inch, "in", "{:.1f}");
  item.value("half-gauge", 0.5 * paper_track.gauge / inch, "in", "{:.2f}");
  item.value("half-spacing", paper_track.half_spacing / inch, "in", "{:.2f}");
  item.value("cn-radius", cn_pair().wheel().pieces()[1].radius / inch, "in", "{:.1f}");
  item.value("heumann-radius", heumann_pair().wheel().pieces()[1].radius / inch, "in", "{:.1f}");
  item.value("far", far / inch, "in", "{:.2f}");
}

}  // namespace

double flange_begins(const WheelsetOnTrack& pair) {
  const auto throat = std::ranges::find_if(pair.wheel().pieces(),
                                           [](const Piece& p) { return p.radius < 2 * inch; });
  const double step = 0.0025 * inch;
  double x = step;
  while (x < far && pair.contact(x).left.on_wheel.u < throat->start.u) x += step;
  return x - step - 0.01 * inch;
}

const report::Section geometry{
    report::figure("fig-03", "Constraint functions: new wheel, worn rail (Fig. 3)", fig_03),
    report::figure("fig-04", "Constraint functions: CN profile A, new rail (Fig. 4)", fig_04),
    report::figure("fig-05", "Constraint functions: modified Heumann, worn rail (Fig. 5)", fig_05),
    report::table("geometry-claims", "What the text says of the three pairs", geometry_claims)};

}  // namespace railbook::hunting_chapter
