/***
Appendix B asks what wear does to the reading: after five hours at $\mu$ = 0.3 the small wheel has lost 0.00152 cm of
diameter, and the big one is assumed to have lost as much. The speeds are exact here, so only the first term stays.

{{table-appendix-b}}

The body of the paper rounds the result down, to 0.00005, and drops its sign.

The main text has a few more numbers, in a third table. Two of them look odd and have a simple origin. "4449.72 N" is 1000 lb
taken as 0.45359 kg each at 9.81 m/s² (it should be {{load-exact}}), and the force error of 22.249 N is 5 lb in the same
way. The speed of 8.224 km/h at 50 rpm is not that of the wheel: its radius gives {{speed-b}}, and 8.224 km/h would need
{{rpm-needed}}. What does give 8.224 is a circumference of 9 ft, three times 36 in: 450 ft a minute are {{mph-nine-feet}},
which rounded to 5.11 and times 1.6094 is {{speed-nine-feet}}; the abstract says "approximately 5 miles per hour". And
neither appendix was run at 50 rpm: 116 and 99.2 rpm are {{speed-at-116}} and {{speed-at-99}}.

{{table-text}}
*/

#include <fmt/format.h>

#include <cmath>

#include "items.hpp"
#include "rig.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

namespace {

constexpr double cm = 0.01;
constexpr double small_speed = 442.6, big_speed = 99.2;  // rpm

// Rim speed [km/h] of a wheel of `radius` [m].
double rim_speed(double radius, double rpm) {
  return 2 * units::pi * radius * rpm / 60 / units::kilometre_per_hour;
}

void rows(report::Item& item) {
  item.columns({"row", "printed", "recomputed", "note"});
  const auto printed = item.printed("appendix-b.csv");
  item.expect_checks(10);
  const auto row = [&](const char* key, double computed, const char* note,
                       const report::Tolerance& tolerance = report::last_digit()) {
    item.add_row({printed.at(key, "what"), printed.at(key, "printed"),
                  fmt::format("{:.6g}", computed), note});
    check_claim(item, printed, key, computed, tolerance);
  };
  const double change = 0.00152 / 2;  // cm, both wheels
  const double s = small_radius / cm, b = big_radius / cm;
  const double from_big = -s / (b * b) * change, from_small = change / b;
  const double du = from_big + from_small, dxi = -du * small_speed / big_speed;
  const auto cut = [](double allowed) {
    return report::absolute(allowed, "the printed value is cut, not rounded");
  };
  row("small", s, "half of 20.1097, last digit cut", cut(1e-4));
  row("big", b, "half of 89.8957, last digit cut", cut(1e-4));
  row("radius-change", change, "half of 0.00152");
  row("radius-change-mm", change * 10, "the same in mm");
  row("du-big", from_big, "", report::absolute(1e-7, "-3.78e-6 is printed with one digit less"));
  row("du-small", from_small, "");
  row("du", du, "sum of the two rounded terms",
      report::absolute(1e-7, "the printed terms are rounded before they are added"));
  row("dxi", -dxi, "sign dropped; carries the rounding of du",
      report::relative(0.01, "carries the rounding of du"));
  row("text", -dxi, "the body rounds it down to 0.00005",
      report::misprint(std::abs(1 - (s - change) / (b - change) * small_speed / big_speed -
                                (1 - s / b * small_speed / big_speed)),
                       1e-3, "0.0000586 cut to one digit; rounded it is 0.00006"));
  item.agree("creep-change", "change of creep by equation (1) at both radii", "",
             (1 - (s - change) / (b - change) * small_speed / big_speed) -
                 (1 - s / b * small_speed / big_speed),
             -dxi, 1e-3, "its differential, Appendix B");
}

void text(report::Item& item) {
  item.columns({"number of the text", "printed", "recomputed", "note"});
  const auto printed = item.printed("text.csv");
  item.expect_checks(4);
  const auto row = [&](const char* key, double computed, const char* note,
                       const report::Tolerance& tolerance = report::last_digit()) {
    item.add_row({printed.at(key, "what"), printed.at(key, "printed"),
                  fmt::format("{:.6g}", computed), note});
    check_claim(item, printed, key, computed, tolerance);
  };
  row("load", paper_load, "1000 × 0.45359 kg × 9.81 m/s²");
  row("force-error", 5 * paper_pound_force, "5 lb in the same way");
  row("speed", rim_speed(big_radius, 50), "not the wheel's speed: see above",
      report::misprint(rim_speed(small_radius, 50 * small_speed / big_speed), 0.003,
                       "the rim of the small wheel, which rolls with it but for the creep"));
  const double nine_feet = 450 * units::foot * 60 / units::mile;  // mph, at 50 rpm
  row("speed-as-9-ft", std::round(nine_feet * 100) / 100 * 1.6094,
      "9 ft a turn, 5.11 mph, times 1.6094");

  item.value("load-exact", 1000 * units::lbf, "N", "{:.3f}");
  item.value("speed-b", rim_speed(big_radius, 50), "km/h", "{:.3f}");
  item.value("rpm-needed",
             report::printed_number(printed.at("speed", "printed")) / rim_speed(big_radius, 1),
             "rpm", "{:.2f}");
  item.value("mph-nine-feet", nine_feet, "mph", "{:.4f}");
  item.value("speed-nine-feet", std::round(nine_feet * 100) / 100 * 1.6094, "km/h", "{:.3f}");
  item.value("speed-at-116", rim_speed(big_radius, 116), "km/h", "{:.1f}");
  item.value("speed-at-99", rim_speed(big_radius, 99.2), "km/h", "{:.1f}");
}

}  // namespace

void creep_chapter::add_appendix_b(report::Chapter& chapter) {
  chapter.table("table-appendix-b", "Appendix B, row by row", rows);
  chapter.table("table-text", "Numbers of the main text", text);
}
