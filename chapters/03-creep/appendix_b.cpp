/***
Appendix B asks what wear does to the reading: after five hours at $\mu$ = 0.3 the small wheel has lost 0.00152 cm of
diameter, and the big one is assumed to have lost as much. The speeds are exact here, so only the first term of (i) stays.

{{table-appendix-b}}

The main text has three more numbers. "4449.72 N" is 1000 lb taken as 0.45359 kg each at 9.81 m/s² (1000 lbf are {{load-exact}}), and the force error of 22.249 N
is 5 lb in the same way. The speed of 8.224 km/h at 50 rpm is not that of the wheel: its radius gives {{speed-b}}, and 8.224 km/h would need
{{rpm-needed}}. Neither appendix was run "near 50 rpm": 116 and 99.2 rpm are {{speed-at-116}} and {{speed-at-99}}.

{{table-text}}
*/

#include <fmt/format.h>

#include <cmath>

#include "rig.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

namespace {

constexpr double centimetre = 0.01;

// Rim speed [km/h] of a wheel of `radius` [m].
double rim_speed(double radius, double rpm) {
  return 2 * units::pi * radius * rpm / 60 / units::kilometre_per_hour;
}

void wear_rows(report::Item& item) {
  item.columns({"row", "printed", {"recomputed", "{:.6g}"}, "note"});
  item.expect_checks(11);
  const PrintedRows row{item, item.printed("appendix-b.csv")};
  const double change = 0.00152 / 2;  // cm, both wheels
  const double s = small_radius / centimetre, b = big_radius / centimetre,
               speeds = small_rpm / big_rpm;
  const double from_big = -s / (b * b) * change, from_small = change / b;
  const double du = from_big + from_small, dxi = -du * speeds;
  // Equation (1) at both radii, no differential.
  const double creep_change = (s / b - (s - change) / (b - change)) * speeds;
  const auto cut = [](double allowed) {
    return report::absolute(allowed, "the printed value is cut, not rounded");
  };
  row("small", s, "half of 20.1097, last digit cut", cut(1e-4));
  row("big", b, "half of 89.8957, last digit cut", cut(1e-4));
  row("radius-change", change, "half of 0.00152");
  row("radius-change-mm", change * 10, "the same in mm");
  row("du-big", from_big, "one digit less than the next", cut(1e-7));
  row("du-small", from_small, "");
  row("du", du, "sum of the two rounded terms",
      report::absolute(1e-7, "the printed terms are rounded before they are added"));
  row("dxi", -dxi, "sign dropped", report::relative(0.01, "carries the rounding of du"));
  row("text", -dxi, "cut to one digit; rounded it is 0.00006",
      report::corrected(creep_change, 1e-3, "equation (1) at both radii"));
  item.claim("small-error", "not taking the wear into account is a very small error", -dxi < 0.0001,
             "less than one in the last digit of the 0.0005 of Appendix A");
  item.agree("creep-change", "change of creep", "", creep_change, -dxi, 1e-3,
             "the differential of Appendix B");
}

void text(report::Item& item) {
  item.columns({"number of the text", "printed", {"recomputed", "{:.6g}"}, "note"});
  item.expect_checks(3);
  const PrintedRows row{item, item.printed("text.csv")};
  row("load", paper_load, "1000 × 0.45359 kg × 9.81 m/s²",
      report::fitted("the factors are chosen to meet it"));
  row("force-error", 5 * paper_pound_force, "5 lb with the same factors",
      report::fitted("5 lb is chosen to meet it"));
  row("speed", rim_speed(big_radius, 50), "not the speed of the rim",
      report::corrected(rim_speed(small_radius, 50 * small_rpm / big_rpm), 0.003,
                        "the rim of the small wheel, which rolls with it but for the creep"));
  item.value("load-exact", 1000 * units::lbf, "N", "{:.3f}");
  item.value("speed-b", rim_speed(big_radius, 50), "km/h", "{:.3f}");
  item.value("rpm-needed",
             report::printed_number(row.table.at("speed", "printed")) / rim_speed(big_radius, 1),
             "rpm", "{:.2f}");
  item.value("speed-at-116", rim_speed(big_radius, 116), "km/h", "{:.1f}");
  item.value("speed-at-99", rim_speed(big_radius, 99.2), "km/h", "{:.1f}");
}

}  // namespace

const report::Section creep_chapter::appendix_b{
    report::table("table-appendix-b", "Appendix B, row by row", wear_rows),
    report::table("table-text", "Numbers of the main text", text)};
