/***
## The rig

The big wheel drives the small one, which is braked by its own motor; a gear of 144 teeth on each
axle counts the turns. Forces are measured along three axes.

::: {.fold summary="The three axes, and what a turned wheel does to the forces"}

A small wheel that is turned about the vertical by a small *angle of attack* would mix the forces.
The paper gives neither angles nor such forces, so nothing below uses this angle.

{{fig-02}}

:::

**The contact ellipse.** The text gives the ratio of the ellipse's axes, 1.568, "typical of the
U.S.A. locomotives". It gives the wheels, but not the profile radius of the small wheel that makes
the ellipse so. Hertz's theory gives it back. Along rolling both wheels are round, so the two
curvatures add up: $1/R_x=1/R_S+1/R_B$. Across, only the small wheel is round, with its profile
radius $R_y$, and the big one is a cylinder. The ratio of the axes fixes the ratio of the two radii
through two complete elliptic integrals, usually called B and D; for 1.568 it is
{{curvature-ratio}}. In the function `profile_radius`, `log_m1` is the logarithm of the squared
ratio of the shorter axis to the longer, and `integrals.b` and `integrals.d` are the two integrals:

{{code: rig.cpp profile_radius}}

So the profile radius is {{profile-along}} if the longer axis lies along rolling, and
{{profile-across}} if it lies across. The text does not say which, and each verdict below that
depends on it is given for both. Where one direction had to be taken, we take the longer axis along
rolling, as a locomotive wheel of 40 in has it on a rail whose head is rounded (crowned) to a radius
of 10 in; the ratio is then {{locomotive-ratio}}.

{{table-ellipse}}

**Pressures.** No modulus is printed; used here are Young's modulus 207 GPa and $\nu$ = 0.3, so that
$G$ = {{shear}}. The
paper wants the contact stresses to be "similar to those of the locomotive and rail". The same
locomotive wheel under 30 000 lbf has a largest pressure of {{locomotive-peak}} (1 ksi is 6.895
MPa), and the publisher's summary, which our copy lacks, has 1070 steel and stresses up to about
200 ksi. The rig's
largest pressure at the 4449.72 N of Appendix B is {{peak-along}} with the longer axis along rolling
and {{peak-across}} with it across. Both lie within a factor of two of the locomotive's, which is
how we read "similar" {{outcome:table-ellipse/stresses}}.

{{fold}}
*/

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include <railbook/report/values.hpp>

#include "rig.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

double creep_chapter::profile_radius(bool major_along_rolling) {
  const double log_m1 = -2 * std::log(axis_ratio);
  const auto integrals = contact::elliptic_integrals(log_m1);
  const double ratio = integrals.b / (std::exp(log_m1) * integrals.d);
  return major_along_rolling ? rolling_radius / ratio : rolling_radius * ratio;
}

contact::HertzContact creep_chapter::rig_contact(double load, double profile) {
  return contact::hertz_from_force({.a = 0.5 / rolling_radius, .b = 0.5 / profile}, modulus(),
                                   load);
}

double creep_chapter::hertz_group(double load, bool major_along_rolling) {
  const auto c = rig_contact(load, profile_radius(major_along_rolling));
  return shear_modulus * c.a * c.b / load;
}

namespace {

constexpr double drawn_attack = 12;  // degrees, far too large, to be seen

// The contact at a creep that uses up most of the friction.
rolling::CreepForces solve_drawn(const rolling::RollingCase& c) {
  rolling::CreepForces forces = rolling::solve_rolling(c, {.along = 24, .rows = 13});
  if (!forces.converged) throw std::runtime_error(forces.reason);
  return forces;
}

void scheme(report::Item& item) {
  item.sketch("rig to scale, gears not; contact by the full theory, largest friction 0.3 assumed");
  const rolling::RollingCase c = rolling::with_reduced_creepage(rig_case(), {0.2, 0, 0});
  const rolling::CreepForces forces = solve_drawn(c);
  const rolling::Tractions& t = forces.tractions;
  report::Data& cells = item.data({"x_mm", "y_mm", "dx_mm", "dy_mm", "sticks", "tx_MPa", "ty_MPa"});
  report::Data& middle = item.data("middle", {"x_mm", "traction_MPa", "limit_MPa"});
  middle.add(-c.a / units::millimetre, 0, 0);
  for (Eigen::Index i = 0; i < t.x.size(); ++i) {
    const double x = t.x[i] / units::millimetre, y = t.y[i] / units::millimetre;
    cells.add(x, y, t.dx[i] / units::millimetre, t.dy[i] / units::millimetre, t.stick[i],
              -t.px[i] / units::megapascal, -t.py[i] / units::megapascal);
    if (std::abs(y) < 1e-9)
      middle.add(x, t.px[i] / units::megapascal, t.bound[i] / units::megapascal);
  }
  middle.add(c.a / units::millimetre, 0, 0);
  item.data("wheels", {"small_cm", "big_cm"})
      .add(small_radius / centimetre, big_radius / centimetre);
  item.value("drawn-creep", c.creepage.longitudinal, "", "{:.4f}");
  item.value("drawn-share", 100 * forces.fx / (c.friction * c.load), "%", "{:.0f}");
}

void axes(report::Item& item) {
  item.sketch("axes as the text names them; the angle of attack is drawn far too large");
  item.data({"attack_degree"}).add(drawn_attack);
}

// A wheel of 40 in on a rail crowned to 10 in, under 30 000 lbf.
contact::HertzContact locomotive_contact() {
  return contact::hertz_from_force({.a = 0.5 / (20 * units::inch), .b = 0.5 / (10 * units::inch)},
                                   modulus(), 30e3 * units::lbf);
}

void ellipse(report::Item& item) {
  item.columns({{"load, N", "{:.2f}"},
                "longer axis",
                {"a (along), mm", "{:.4f}"},
                {"b (across), mm", "{:.4f}"},
                {"area π a b, mm²", "{:.4f}"},
                {"largest pressure p<sub>0</sub>, MPa", "{:.1f}"}});
  for (const double load : {500 * units::lbf, paper_load, 2500 * units::lbf})
    for (const bool along : {true, false}) {
      const auto c = rig_contact(load, profile_radius(along));
      item.add_row(load, along ? "along" : "across", c.a / 1e-3, c.b / 1e-3,
                   units::pi * c.a * c.b / 1e-6, c.p_max / units::megapascal);
    }
  item.rebuilt("our copy prints neither material nor profile radius; those used are stated above");
  item.expect_checks(3);
  const auto locomotive = locomotive_contact();
  item.print("ratio", "longer axis by shorter axis, typical of U.S. locomotives", "", "1.568",
             locomotive.a / locomotive.b,
             report::relative(0.02, "wheel of 40 in on a rail crowned to 10 in: rebuilt"));
  item.print("big-diameter", "diameter of the large wheel", "in", "36",
             2 * big_radius / units::inch,
             report::absolute(1.0, "\"approximately 36 in.\"; Appendix B measures 89.8957 cm"));
  item.print(
      "small-diameter", "diameter of the small wheel", "in", "8", 2 * small_radius / units::inch,
      report::absolute(0.1, "nominal; Appendix B measures 20.1097 cm after turning and wear"));

  const double along = profile_radius(true), across = profile_radius(false);
  const auto along_contact = rig_contact(paper_load, along);
  const double along_peak = along_contact.p_max / units::ksi,
               across_peak = rig_contact(paper_load, across).p_max / units::ksi,
               track_peak = locomotive.p_max / units::ksi;
  item.claims(
      {{"stresses",
        {along_peak, across_peak, track_peak, along_peak / track_peak, across_peak / track_peak}}});
  report::values(item, "ksi", "{:.0f}", "locomotive-peak", track_peak, "peak-along", along_peak,
                 "peak-across", across_peak);
  item.value("shear", shear_modulus / units::gigapascal, "GPa", "{:.1f}");
  item.value("contact-share", 100 * 2 * along_contact.b / along, "%", "{:.1f}");
  item.value("curvature-ratio", rolling_radius / along, "", "{:.6f}");
  item.value("profile-along", along / units::millimetre, "mm", "{:.3f}");
  item.value("profile-across", across / units::millimetre, "mm", "{:.2f}");
  item.value("locomotive-ratio", locomotive.a / locomotive.b, "", "{:.3f}");
}

}  // namespace

const report::Section creep_chapter::rig{report::figure("fig-01", scheme),
                                         report::figure("fig-02", axes),
                                         report::table("table-ellipse", ellipse)};
