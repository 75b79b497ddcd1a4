/***
A wheelset on rails has no freedom to roll or to rise of its own: where it stands across the track decides how it
lies. Five *constraint functions* of the lateral displacement $x_w$ say everything the dynamics needs: the rolling
radii $r_L$, $r_R$, the angles $\delta_L$, $\delta_R$ of the contact planes to the axle, and the roll angle $\phi_w$.
In the equations of motion they come as three odd functions,

$$R=\frac{r_L-r_R}{2a},\qquad D=\frac{\delta_L-\delta_R}2,\qquad\Phi=\phi_w,$$

the first steers, the other two push the wheelset back to the middle.

**What is lost.** The paper measured its profiles and gives none. It names them: a new wheel on a worn rail, the
Canadian National's worn-wheel profile A on a new rail, and a modified Heumann wheel on the worn rail; the gauge is
{{gauge}}. Its figures, with the constraint functions, are unreadable in the copy that is available, and no usable
coordinates of these profiles were found elsewhere.

**How they are rebuilt.** Each profile is a chain of circular arcs and straight lines that join without a corner, as
drawings of wheels and rails are made. Radii of the rails follow the AREA's manner (10 in crown, 1¼ in shoulder, 3/8
in corner when new; flatter and then sharper when worn), and the rails lean inwards by 1:40. The new wheel is a 1:20
cone with an 11/16 in throat; CN profile A has a hollow of {{cn-radius}} and the Heumann wheel one of
{{heumann-radius}}; all have a 70° flange. The free lengths were chosen so that the geometry has every property that
the text states, and {{geometry-claims}} says how well. The half spacing $a$ is {{half-spacing}}, the half distance of
the rails' *heads*: the paper calls it half the gauge, which would be {{half-gauge}}.

**Contact, exactly.** Roll the wheelset by $\phi$ and look at the vertical gap between wheel and rail on one side. Its
least value $h(x,\phi)$ must be the same on both sides, $h(x,\phi)=h(-x,-\phi)$: that fixes $\phi$. The usual way is
to compare heights on a fine grid, refine, and fear for the second point of contact. With arcs none of that is needed.
Write an arc as $u=u_c+\rho\sin\theta$, $z=z_c+\rho\cos\theta$ with the angle $\theta$ as parameter (rolling only adds
$\phi$ to every angle of the wheel); the gap of a wheel arc and a rail arc is stationary where both have the same
angle, so

$$\sin\theta=\frac{u_c^{rail}-u_c^{wheel}}{\rho_{wheel}-\rho_{rail}},$$

and where that falls outside the stretch the two arcs share, the least gap is at an end of the stretch. One walk along
both chains finds the least gap of the whole profiles to rounding, two-point contact included. The roll follows by
Newton's method in a bracket, with the slope $\partial h/\partial\phi$ from the lever arms of the contact points:
{{evaluations}} walks for one displacement on the average.

{{fig-03}}

{{fig-04}}

{{fig-05}}

In each figure the lower part shows the left wheel lifted off its rail, and straight lines join the points that touch
while the wheelset moves from {{far}} right to {{far}} left. The red pair of lines is a **two-point contact**: there
the wheel leaves one point and takes the other at once, and the functions jump. The new wheel jumps from its tread to
its throat. What the paper says of the Heumann wheel, "closely approximates single-point contact", is true of ours: it
still jumps, but by {{heumann-jump}} of contact angle against {{new-jump}}.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry.hpp"
#include "items.hpp"
#include "units/constants.hpp"

using namespace railbook;
using namespace railbook::hunting_chapter;
using namespace railbook::wheelrail;
using units::inch;

namespace {

constexpr double far = 0.75 * inch;
constexpr double lift = 0.8;  // of the wheel in the drawing [in]

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
  const WheelsetOnTrack& pair = named.pair();
  const double a = paper_track.half_spacing;
  report::Data& functions = item.data(
      {"x_over_a", "r_L_in", "r_R_in", "delta_L_rad", "delta_R_rad", "phi_rad", "R", "D_rad"});
  constexpr int n = 1500;
  double walks = 0;
  for (int i = 0; i <= n; ++i) {
    const double x = far * i / n;
    const auto at = pair.contact(x);
    walks += at.evaluations;
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
  double largest = 0;
  for (const auto& jump : contact_jumps(pair, -far, far, 1e-4)) {
    join(jump.before, head, above, "two", twos);
    join(jump.after, head, above, "two", twos);
    largest = std::max(largest, std::abs(jump.after.delta - jump.before.delta));
  }
  item.script("constraint.gp");
  item.reconstructed("the measured profiles are lost; ours are chains of arcs chosen to the text");
  item.value(std::string(named.key) + "-jump", largest, "rad", "{:.3f}");
  if (named.key == std::string("new")) {
    item.value("gauge", paper_track.gauge / inch, "in", "{:.1f}");
    item.value("half-gauge", 0.5 * paper_track.gauge / inch, "in", "{:.2f}");
    item.value("half-spacing", a / inch, "in", "{:.2f}");
    item.value("cn-radius", cn_wheel_profile().pieces()[1].radius / inch, "in", "{:.1f}");
    item.value("heumann-radius", heumann_wheel_profile().pieces()[1].radius / inch, "in", "{:.1f}");
    item.value("far", far / inch, "in", "{:.2f}");
    item.value("evaluations", 0.5 * walks / (n + 1), "", "{:.1f}");
  }
}

}  // namespace

void hunting_chapter::add_profiles(report::Chapter& chapter) {
  for (std::size_t i = 0; i < paper_pairs.size(); ++i)
    chapter.figure(
        fmt::format("fig-{:02}", i + 3),
        fmt::format("Constraint functions: {} (the paper's Fig. {})", paper_pairs[i].name, i + 3),
        [i](report::Item& item) { constraint_figure(item, paper_pairs[i]); });
}
