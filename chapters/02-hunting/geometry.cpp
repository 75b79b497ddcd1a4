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
drawings of wheels and rails are made. Rails follow the AREA's manner (10 in crown, 1¼ in shoulder, 3/8
in corner when new; flatter and then sharper when worn) and lean inwards by 1:40. The new wheel is a 1:20
cone with an 11/16 in throat; CN profile A has a hollow of {{cn-radius}} and the Heumann wheel one of
{{heumann-radius}}; all have a 70° flange. The free lengths were chosen so that the geometry has what
the text states ({{geometry-claims}}). The half spacing $a$ is {{half-spacing}}, the half distance of
the rails' *heads*; the paper calls it half the gauge, which would be {{half-gauge}}.

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

{{geometry-claims}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sections.hpp"
#include "units/constants.hpp"
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

std::string times(double ratio) {
  return fmt::format("{:.2f} times", ratio);
}

void straightness(report::Item& item) {
  const auto &fresh = new_wheel_table(), &cn = cn_table(), &heumann = heumann_table();
  const auto most = [](const ConstraintFunctions& f, double end) {
    return std::max(bend(f.R, end), bend(f.Phi, end));
  };
  const double new_bend = std::max(most(fresh, 0.39 * inch), bend(fresh.D, 0.39 * inch));
  item.claim("new-straight", "new wheel: all functions are nearly linear until the flange",
             new_bend < 0.01, fmt::format("within {:.1f} % up to 0.39 in", 100 * new_bend));
  const double cn_bend = most(cn, 0.36 * inch);
  item.claim("cn-straight", "CN A: R and Φ are nearly linear until the flange (within 15 %)",
             cn_bend < 0.15, fmt::format("within {:.1f} % up to 0.36 in", 100 * cn_bend));
  const double cn_angle = bend(cn.D, 0.36 * inch);
  item.refute("cn-straight-D", "CN A: D is nearly linear until the flange", cn_angle > 0.15,
              fmt::format("off its tangent by {:.0f} %: the rail's shoulder ends the crown",
                          100 * cn_angle));
  const double small = most(heumann, 0.1 * inch);
  item.claim("heumann-straight", "Heumann: linear for small displacements", small < 0.05,
             fmt::format("R and Φ within {:.1f} % up to 0.1 in", 100 * small));
}

void geometry_claims(report::Item& item) {
  item.rebuilt("the profiles were chosen to have these properties");
  item.expect_checks(10);
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
                            report::relative(0.05, "\"about\"")));
  item.refute("cn-roll-slope", "CN A: the slope of Φ is about three times the new wheel's",
              cn.Phi < fresh.Phi, times(cn.Phi / fresh.Phi) + ", as the paper says of Φ elsewhere");
  item.claim("heumann-steep", "Heumann: R and D are steeper than either of the others",
             heumann.R > std::max(cn.R, fresh.R) && heumann.D > std::max(cn.D, fresh.D),
             fmt::format("R: {} the new wheel's, {} CN's", times(heumann.R / fresh.R),
                         times(heumann.R / cn.R)));
  item.claim("heumann-several",
             "Heumann: all three slopes are several (over 2) times the new wheel's",
             heumann.R > 2 * fresh.R && heumann.D > 2 * fresh.D && heumann.Phi > 2 * fresh.Phi,
             fmt::format("R {}, Φ {}, D {:.2f} against 0", times(heumann.R / fresh.R),
                         times(heumann.Phi / fresh.Phi), heumann.D));
  const double small = largest_jump(heumann_pair()), large = largest_jump(new_wheel_pair());
  item.claim("heumann-single", "Heumann: contact closely approximates a single point",
             small < 0.1 * large,
             fmt::format("its angle jumps by {:.3f} rad, the new wheel's by {:.3f}", small, large));
  item.value("gauge", paper_track.gauge / inch, "in", "{:.1f}");
  item.value("half-gauge", 0.5 * paper_track.gauge / inch, "in", "{:.2f}");
  item.value("half-spacing", paper_track.half_spacing / inch, "in", "{:.2f}");
  item.value("cn-radius", cn_wheel_profile().pieces()[1].radius / inch, "in", "{:.1f}");
  item.value("heumann-radius", heumann_wheel_profile().pieces()[1].radius / inch, "in", "{:.1f}");
  item.value("far", far / inch, "in", "{:.2f}");
  item.value("new-jump", large, "rad", "{:.3f}");
}

}  // namespace

const report::Section geometry{
    report::figure("fig-03", "Constraint functions: new wheel, worn rail (Fig. 3)", fig_03),
    report::figure("fig-04", "Constraint functions: CN profile A, new rail (Fig. 4)", fig_04),
    report::figure("fig-05", "Constraint functions: modified Heumann, worn rail (Fig. 5)", fig_05),
    report::table("geometry-claims", "What the text says of the three pairs", geometry_claims)};

}  // namespace railbook::hunting_chapter
