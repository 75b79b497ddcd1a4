/***
## The rig

{{fig-01}}

The small wheel is pressed onto the big one, which drives it, and is braked by its own motor; a gear
of 144 teeth on each axle counts the turns. Forces are measured along three axes, which a misaligned
small wheel, turned by the angle of attack, would mix:

{{fig-02}}

## The contact ellipse

The text gives the ratio of the ellipse's axes, 1.568, "typical of the U.S.A. locomotives", and the
wheels, but not the profile radius of the small wheel that makes the ellipse so. Hertz's theory
gives it back. Along rolling both wheels are round, $1/R_x=1/R_S+1/R_B$; across, only the small
wheel is, the big one being a cylinder. The ratio of the axes fixes the ratio of the two radii of
curvature through elliptic integrals; for 1.568 it is {{curvature-ratio}}. So the profile radius is
{{profile-along}} if the major axis lies along rolling, {{profile-across}} if it lies across.

{{table-ellipse}}

The text does not say which, so each verdict below that depends on it is given for both. Where one
had to be taken, the major axis lies along rolling. There are two reasons: a locomotive wheel of 40
in on a rail with a 10-in crown has its major axis there, with a ratio of {{locomotive-ratio}}; and
a profile of {{profile-along-inch}} fits a wheel of 8 in better than one of {{profile-across-inch}}.

No modulus is printed; used here are $E$ = 207 GPa and $\nu$ = 0.3. The paper wants the contact
stresses to be "similar to those of the locomotive and rail". The same locomotive wheel under 30 000
lb has a largest pressure of {{locomotive-peak}}, and the publisher's summary, which our copy lacks,
has stresses up to about 200 ksi. The rig's largest pressure at the 4449.72 N of Appendix B is
{{peak-along}} with the major axis along rolling and {{peak-across}} with it across, which is
similar either way {{outcome:table-ellipse/stresses}}. On the rig a largest pressure of 200 000 psi
takes {{load-200-along}} along and {{load-200-across}} across.
*/

#include <fmt/format.h>

#include <cmath>

#include <railbook/scene/labelled.hpp>
#include <railbook/scene/shapes.hpp>

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

constexpr double in_cm = 100;  // a metre in the picture's unit

constexpr double small_r = small_radius * in_cm, big_r = big_radius * in_cm, top = small_r + big_r;

// The big cylinder and the small wheel on it with its crowned rim.
scene::Scene wheels(const scene::Point& axle) {
  constexpr int n = 24;
  constexpr double half = 2.2;
  const double crown = profile_radius(true) * in_cm;
  scene::Outline outline(n + 3, 2);
  outline.row(0) << 0, 0;
  for (int i = 0; i <= n; ++i) {
    const double y = half * (2.0 * i / n - 1);
    outline.row(i + 1) << y + half, small_r - crown + std::sqrt(crown * crown - y * y);
  }
  outline.row(n + 2) << 2 * half, 0;
  scene::Scene s;
  s.meshes.push_back(scene::cylinder({0, -4, 0}, {0, 4, 0}, big_r, scene::steel));
  s.meshes.push_back(scene::revolution(scene::Point{0, 0, top} - half * axle, axle, outline));
  return s;
}

scene::Lines arrow(const scene::Point& from, const scene::Point& along,
                   const scene::Colour& colour) {
  scene::Lines lines{scene::Points(2, 3), scene::Segments(1, 2), colour, 3.0};
  lines.vertices << from.transpose(), (from + along).transpose();
  lines.segments << 0, 1;
  return lines;
}

void both_wheels(report::Item& item) {
  item.sketch(
      "the wheels to scale, profile radius and widths rebuilt; the paper's figure is a scheme");
  scene::Scene s = wheels({0, 1, 0});
  s.meshes.push_back(scene::cylinder({0, -16, 0}, {0, 16, 0}, 4, scene::stone));
  s.meshes.push_back(scene::cylinder({0, -16, top}, {0, 16, top}, 1.6, scene::stone));
  s.meshes.push_back(scene::cylinder({0, -14.5, 0}, {0, -13, 0}, 9, scene::wood));
  s.meshes.push_back(scene::cylinder({0, -14.5, top}, {0, -13, top}, 5, scene::wood));
  const scene::Size size{1000, 470};
  const auto camera = scene::looking_at(s, {1.0, -1.5, 0.5}, size, true);
  scene::labelled(item, "wheels.gp", s, camera, size,
                  {{{17, 0, top + 2}, "small wheel (braked): the locomotive's"},
                   {{-52, 0, top + 4}, "gear of 144 teeth"},
                   {{17, 0, big_r + 3}, "contact"},
                   {{44, 0, 30}, "big wheel (drives): the rail"},
                   {{-24, -20, -16}, "gear of 144 teeth"}});
}

void axes(report::Item& item) {
  item.sketch("axes as the text names them; the angle of attack is drawn far too large");
  const double attack = 12 * units::degree;
  scene::Scene s = wheels({-std::sin(attack), std::cos(attack), 0});
  const scene::Colour red{0.84, 0.37, 0.0}, blue{0.0, 0.45, 0.70}, black{0, 0, 0};
  const scene::Point along{std::cos(attack), std::sin(attack), 0}, contact{0, 0, big_r},
      crown{0, 0, 2 * small_r};
  s.lines = {arrow(contact, {34, 0, 0}, red), arrow(contact, 34 * along, red),
             arrow(contact, {0, -26, 0}, blue), arrow(contact + crown, {0, 0, 12}, black)};
  const scene::Size size{1000, 470};
  const auto camera = scene::looking_at(s, {1.0, -1.3, 1.3}, size, true);
  scene::labelled(item, "wheels.gp", s, camera, size,
                  {{contact + scene::Point{34, -4, 0}, "z: longitudinal"},
                   {contact + 36 * along, "z' of a misaligned wheel"},
                   {contact + scene::Point{-10, -27, 0}, "y: axial"},
                   {contact + crown + scene::Point{2, 0, 12}, "x: transversal (the load N)"}});
}

void ellipse(report::Item& item) {
  item.columns({{"load, N", "{:.2f}"},
                "major axis",
                {"a (along), mm", "{:.4f}"},
                {"b (across), mm", "{:.4f}"},
                {"area π a b, mm²", "{:.4f}"},
                {"p_0, MPa", "{:.1f}"}});
  for (const double load : {500 * units::lbf, paper_load, 2500 * units::lbf})
    for (const bool along : {true, false}) {
      const auto c = rig_contact(load, profile_radius(along));
      item.add_row(load, along ? "along" : "across", c.a / 1e-3, c.b / 1e-3,
                   units::pi * c.a * c.b / 1e-6, c.p_max / units::megapascal);
    }
  item.rebuilt("material and profile radius are not printed; those used are stated above");
  item.expect_checks(4);
  const auto locomotive = contact::hertz_from_force(
      {.a = 0.5 / (20 * units::inch), .b = 0.5 / (10 * units::inch)}, modulus(), 30e3 * units::lbf);
  item.print("ratio", "major axis by minor axis, typical of U.S. locomotives", "", "1.568",
             locomotive.a / locomotive.b,
             report::relative(0.02, "wheel of 40 in on a rail crowned to 10 in: rebuilt"));
  item.print("big-diameter", "diameter of the large wheel", "in", "36",
             2 * big_radius / units::inch,
             report::absolute(1.0, "\"approximately 36 in.\"; Appendix B measures 89.8957 cm"));
  item.print(
      "small-diameter", "diameter of the small wheel", "in", "8", 2 * small_radius / units::inch,
      report::absolute(0.1, "nominal; Appendix B measures 20.1097 cm after turning and wear"));

  const double along_peak = rig_contact(paper_load, profile_radius(true)).p_max / units::ksi,
               across_peak = rig_contact(paper_load, profile_radius(false)).p_max / units::ksi,
               track_peak = locomotive.p_max / units::ksi;
  const auto similar = [&](double rig) { return rig > 0.5 * track_peak && rig < 2 * track_peak; };
  item.consistent(
      "stresses", "contact stresses similar to those of the locomotive and rail",
      similar(along_peak) && similar(across_peak),
      fmt::format("largest pressures {:.0f} ksi (major axis along) or {:.0f} ksi "
                  "(across), locomotive {:.0f} ksi",
                  along_peak, across_peak, track_peak),
      "the locomotive, its load and the steel are ours: 40 in, crown of 10 in, 30 000 lb");
  const auto load_at_200 = [](double peak) {
    return paper_load / units::lbf * std::pow(200 / peak, 3);
  };
  item.value("locomotive-peak", track_peak, "ksi", "{:.0f}");
  item.value("peak-along", along_peak, "ksi", "{:.0f}");
  item.value("peak-across", across_peak, "ksi", "{:.0f}");
  item.value("load-200-along", load_at_200(along_peak), "lbf", "{:.0f}");
  item.value("load-200-across", load_at_200(across_peak), "lbf", "{:.0f}");
  const auto ellipse_now = rig_contact(paper_load, profile_radius(true));
  item.value("contact-share", 100 * 2 * ellipse_now.b / profile_radius(true), "%", "{:.1f}");
  const double along = profile_radius(true), across = profile_radius(false);
  item.value("curvature-ratio", rolling_radius / along, "", "{:.6f}");
  item.value("profile-along", along / units::millimetre, "mm", "{:.3f}");
  item.value("profile-across", across / units::millimetre, "mm", "{:.2f}");
  item.value("profile-along-inch", along / units::inch, "in", "{:.3f}");
  item.value("profile-across-inch", across / units::inch, "in", "{:.3f}");
  item.value("locomotive-ratio", locomotive.a / locomotive.b, "", "{:.3f}");
}

}  // namespace

const report::Section creep_chapter::rig{
    report::figure("fig-01", "The two wheels of the rig", both_wheels),
    report::figure("fig-02", "Axes of the forces, and the angle of attack", axes),
    report::table("table-ellipse", "The contact ellipse of the rig by Hertz", ellipse)};
