/*** ## Example 4: a flat punch with a rounded edge

The last example shows the "great resolving power" of the method: a circular stamp is flat in the
middle and rounded at the edge, and its pressure has a narrow peak at the edge. Our text has the
approach, $\delta=0.001$ in, and not the drawing with the dimensions. We take a flat of radius
$\rho_0=0.5$ in and an edge of radius $R_e=1$ in. The peak is then {{ratio}} times the pressure in
the middle, and the pressure falls to zero within {{reach}} of the flat.

Stamp and contact are round, so everything depends on the distance $\rho$ from the axis alone, and
the variant COUNTAXI of the program cuts the contact into rings. The integral (15) over a ring is
the difference of the integrals over two discs. That over a disc of radius $c$ follows from
$\mathrm{K}_a$ and $\mathrm{K}_b$ of Example 1, here for the modulus in the brackets:

$$\int_{\text{disc}}\frac{dA}{r}=4c\left[\mathrm{K}_b\!\left(\frac{\rho}{c}\right)+\left(1-\frac{\rho^2}{c^2}\right)\mathrm{K}_a\!\left(\frac{\rho}{c}\right)\right]\ (\rho<c),\qquad \frac{4c^2}{\rho}\,\mathrm{K}_b\!\left(\frac{c}{\rho}\right)\ (\rho>c).$$

This is the function `disc_influence`, whose `r` is our $\rho$. All terms are positive, so no digits
cancel at the edge of the disc.

{{code: contact/influence.cpp disc_influence}}

This example can be checked better than any other: the pressure under any axisymmetric profile is a
single integral (Sneddon 1965). With the lengths

$$S(t)=\sqrt{t^2-\rho_0^2},\qquad T(t)=S(t)-\rho_0\arctan\frac{S(t)}{\rho_0}$$

and the radius $\rho_c$ of the contact, approach, force and pressure are

$$\delta=\frac{\rho_cT(\rho_c)}{R_e},\qquad F=E^*\left(\rho_c\delta+\frac{S(\rho_c)^3}{3R_e}\right),\qquad p(\rho)=\frac{E^*}{\pi R_e}\int_{\max(\rho,\rho_0)}^{\rho_c}\frac{S(t)+T(t)}{\sqrt{t^2-\rho^2}}\,dt.$$

All terms are positive, so no digits cancel for any edge, from the sphere ($\rho_0=0$) to the nearly
sharp punch ($R_e\to0$).

{{fig-14}}

Sixty rings, finer towards the edge, give the force, the reach and the peak:

{{example-4}}

The peak lies {{beyond}} outside the flat, in a contact that reaches only {{reach}} beyond it, so
the rings must be narrow there.

{{fold}}
*/
#include <fmt/format.h>

#include <cmath>

#include "method/countaxi.hpp"
#include "method/punch.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

constexpr const char* stamp_rebuilt =
    "our text has no dimensions of the stamp; a flat of 0.5 in and an edge of 1 in are ours";

const PunchContact& exact_stamp() {
  static const PunchContact contact = punch_from_approach(stamp, modulus, delta_4);
  return contact;
}

const RingContact& sixty_rings() {
  static const RingContact result = countaxi(rounded_punch_gap(stamp), delta_4, modulus);
  return result;
}

void by_rings(report::Item& item) {
  const PunchContact& exact = exact_stamp();
  const PunchPeak peak = punch_peak(exact);
  const RingContact& rings = sixty_rings();
  item.expect_checks(2);
  item.columns({"", {"60 rings", "{:.7g}"}, {"closed form", "{:.7g}"}});
  item.add_row("force, lbf", rings.force / lbf, exact.force / lbf);
  item.add_row("reach beyond the flat, in", (rings.radius - stamp.flat_radius) / inch,
               exact.edge_width / inch);
  item.add_row("peak pressure, psi", rings.p_max / psi, peak.pressure / psi);
  item.agree("force", "force", "lbf", rings.force / lbf, exact.force / lbf, 1e-5, "closed form");
  item.agree("peak", "peak pressure", "psi", rings.p_max / psi, peak.pressure / psi, 5e-3,
             "closed form");
  const double off = std::abs(rings.p_max / peak.pressure - 1);
  const double smooth = report::printed_number(item.printed("table-2.csv").at("p0", "error"));
  const double ratio = peak.pressure / punch_pressure(exact, 0);
  item.claims({{"resolving", {ratio, 100 * off, smooth, 100 * off / smooth}}});
  item.value("ratio", ratio, "", "{:.1f}");
  item.value("beyond", (peak.r - stamp.flat_radius) / inch, "in", "{:.4f}");
  item.value("reach", exact.edge_width / inch, "in", "{:.4f}");
  item.rebuilt(stamp_rebuilt);
}

// The exact pressure, at radii that crowd towards the edge.
void add_pressure(report::Data& data, const PunchContact& c, int n) {
  for (int i = 0; i < n; ++i) {
    const double r = c.radius * (1 - std::pow(1 - double(i) / n, 3));
    data.add(r / inch, punch_pressure(c, r) / (1e4 * psi));
  }
}

void fig_14(report::Item& item) {
  auto& points = item.data({"r_in", "p_1e4_psi"});
  for (Eigen::Index i = 0; i < sixty_rings().r.size(); ++i)
    points.add(sixty_rings().r[i] / inch, sixty_rings().p[i] / (1e4 * psi));
  add_pressure(item.data("exact", {"r_in", "p_1e4_psi"}), exact_stamp(), 400);
  auto& profile = item.data("profile", {"r_in", "gap_1e-3_in"});
  const Gap gap = rounded_punch_gap(stamp);
  for (int i = 0; i <= 60; ++i) profile.add(0.01 * i, gap(0.01 * i * inch, 0) / (1e-3 * inch));
  add_pressure(item.data("sharp", {"r_in", "p_1e4_psi"}),
               punch_from_approach({stamp.flat_radius, 0}, modulus, delta_4), 200);
  item.rebuilt(stamp_rebuilt);
}

}  // namespace

const report::Section example_4{report::figure("fig-14", fig_14),
                                report::table("example-4", by_rings)};

}  // namespace railbook::contact_chapter
