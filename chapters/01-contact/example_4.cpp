#include "contact/countaxi.hpp"
#include "contact/punch.hpp"
#include "drawings.hpp"
#include "items.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

namespace {

/***
## Example 4: a flat punch with a rounded edge

The last example is to show the "great resolving power" of the method: a circular stamp, flat in the middle and
rounded at the edge, whose pressure climbs eightfold within a hundredth of an inch. The program is COUNTAXI, which
cuts the disc of contact into rings. The coefficient of a ring is the difference of two discs, and a disc of
uniform pressure has the complete elliptic integrals $K$ and $E$ in its displacement, inside and outside:

$$\int_{r'<c}\frac{dA'}{|r-r'|}=4cE\!\left(\frac rc\right)\ (r<c),\qquad
4r\left[E\!\left(\frac cr\right)-\left(1-\frac{c^2}{r^2}\right)K\!\left(\frac cr\right)\right]\ (r>c).$$

The drawing's dimensions are unreadable; only $\delta=.001$ in is printed. We take a flat of radius $b=.5$ in and an edge of
radius $R=1$ in, so this example is a reconstruction. But it can be checked better than any other, because since 1978 the
problem has been solved in closed form (Jaeger; Ciavarella, Hills and Monno). We bring it to a form in which all terms are
positive, so that it holds without loss from the sphere ($b=0$) to the sharp punch ($R=0$): with
$s^2=a^2-b^2$ and $L=s-b\arctan(s/b)$,

$$\delta=\frac{aL}{R},\qquad F=E^*\left(a\delta+\frac{s^3}{3R}\right),\qquad
p(r)=\frac{E^*}{\pi R}\int_{\max(r,b)}^{a}\frac{s_t+L_t}{\sqrt{t^2-r^2}}\,dt,$$

where $s_t$ and $L_t$ are $s$ and $L$ with $t$ for $a$.
*/

constexpr RoundedPunch stamp{0.5 * inch, 1 * inch};

const PunchContact& exact_stamp() {
  static const PunchContact contact = punch_from_approach(stamp, effective_modulus(steel), delta_4);
  return contact;
}

RingContact stamp_on_rings(int rings) {
  CountaxiOptions options;
  options.rings = rings;
  return countaxi(rounded_punch_gap(stamp), delta_4, effective_modulus(steel), options);
}

/***
{{fig-14}}

Sixty rings, finer towards the edge, give the load and the peak:

{{example-4}}

The peak is {{ratio}} times the pressure in the middle and lies {{beyond}} outside the flat, within a contact that reaches
only {{reach}} beyond it. Equal rings would need {{equal-rings}} to put as many into that strip. So the claim
is confirmed, with the proviso that the rings must be where the gradient is.
*/

void example_4(report::Item& item) {
  const PunchContact& exact = exact_stamp();
  const PunchPeak peak = punch_peak(exact);
  const RingContact rings = stamp_on_rings(60);
  item.reconstructed("the paper's dimensions are unreadable; b = .5 in and R = 1 in are ours");
  item.expect_checks(4);
  const char* method = "closed form";
  item.agree("force", "force", "lbf", rings.force / lbf, exact.force / lbf, 1e-5, method);
  item.agree("width", "reach of the contact beyond the flat", "in",
             (rings.radius - stamp.flat_radius) / inch, exact.edge_width / inch, 1e-3, method);
  item.agree("peak", "peak pressure", "psi", rings.p_max / psi, peak.pressure / psi, 5e-3, method);
  item.agree("centre", "pressure in the middle", "psi", rings.p[0] / psi,
             punch_pressure(exact, rings.r[0]) / psi, 2e-4, method);
  item.value("ratio", peak.pressure / punch_pressure(exact, 0), "", "{:.1f}");
  item.value("beyond", (peak.r - stamp.flat_radius) / inch, "in", "{:.4f}");
  item.value("reach", exact.edge_width / inch, "in", "{:.4f}");
  const auto strip = (rings.edges.array() > stamp.flat_radius).count();
  item.value("equal-rings", double(strip) * exact.radius / exact.edge_width, "", "{:.0f}");
}

void fig_14(report::Item& item) {
  item.reconstructed("the paper's dimensions are unreadable; b = .5 in and R = 1 in are ours");
  draw::punch(item, stamp_on_rings(60), exact_stamp());
}

}  // namespace

void contact_chapter::add_example_4(report::Chapter& chapter) {
  chapter.figure(
      "fig-14", "Flat axisymmetric punch with rounded edges: shape and pressure (Fig. 14)", fig_14);
  chapter.table("example-4", "Example 4: COUNTAXI on 60 rings against the closed form", example_4);
}
