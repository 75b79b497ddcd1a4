/***
## How accurate is a measured creep?

Creep is a small difference of two large numbers,

$$\xi=1-\frac{N_SR_S}{N_BR_B}, \tag{1}$$

so a relative error of a speed or a radius is an absolute error of the creep. With $u=R_S/R_B$, Appendix A adds up three terms,

$$d\xi=-\frac{N_S}{N_B}\,du+u\frac{N_S}{N_B^2}\,dN_B-\frac{u}{N_B}\,dN_S,\qquad
  du=-\frac{R_S}{R_B^2}\,dR_B+\frac{1}{R_B}\,dR_S, \tag{i}$$

and finds 0.0005. Row by row:

{{table-appendix-a}}

* The terms are added **with their signs**, those of the two radii as well, and cancel in part. The sum is no upper bound: if all four
  errors conspire they make {{xi-conspire}}. {{outcome:table-appendix-a/upper-bound}} As independent errors (root of the sum of squares) they
  make {{xi-rss}}, which bears "accurate to 0.0005" out. {{outcome:table-appendix-a/accurate}}
* The third term uses $u$ = 0.2238, close to the value of Appendix B, where the first two use 0.2256. {{outcome:table-appendix-a/term-3}}
* The text takes the radii to 0.00254 mm; the numbers are those of 0.0254 mm, which the body of the paper has.
  {{outcome:table-appendix-a/radius-unit}}
* One tooth in a minute, 1/144 rpm, is taken for the big wheel, and 0.2 rpm, 29 teeth, for the small one.
* Our copy is damaged in three places: it reads "10.1" for 10.16 cm (4 in), "118" for 116 rpm, "0.009" for 0.0069; the results that follow need the latter.
* With the radii of Appendix A the creep at 518 and 116 rpm would be {{xi-wrong-sign}}, a braked wheel that runs *ahead*;
  with those of Appendix B it is {{xi-right-sign}}.

The worst case is checked without any derivative, by evaluating (1) at all sixteen corners of the errors.

Appendix B asks what wear does to the reading: after five hours at $\mu$ = 0.3 the small wheel has lost 0.00152 cm of
diameter, and the big one is assumed to have lost as much. The speeds are exact here, so only the first term of (i) stays.

{{table-appendix-b}}

The main text has three more numbers. "4449.72 N" is 1000 lb taken as 0.45359 kg each at 9.81 m/s² (1000 lbf are {{load-exact}}), and the force error of 22.249 N
is 5 lb in the same way. The speed of 8.224 km/h at 50 rpm is not that of the wheel: its radius gives {{speed-b}}, and 8.224 km/h would need
{{rpm-needed}}. Neither appendix was run "near 50 rpm": 116 and 99.2 rpm are {{speed-at-116}} and {{speed-at-99}}.

{{table-text}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rig.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

namespace {

// A row of an item's table with a printed value, checked.
struct PrintedRows {
  report::Item& item;
  table::CsvTable table;
  void operator()(const char* key, double computed, const char* note,
                  const report::Expectation& expectation = report::last_digit()) const {
    const std::string &what = table.at(key, "what"), &text = table.at(key, "printed");
    item.add_row(what, text, computed, note);
    item.print(key, what, table.at(key, "unit"), text, computed, expectation);
  }
};

// Lengths in cm and speeds in rpm, as the appendix has them.
struct Reading {
  double small, big, small_speed, big_speed;
  double creep() const { return 1 - small / big * small_speed / big_speed; }
};
constexpr Reading nominal{4 * 2.54, 45.03, 518, 116};
constexpr Reading error{0.00254, 0.00254, 0.2, 1.0 / 144};

double d_ratio(const Reading& r, const Reading& d) {
  return -r.small / (r.big * r.big) * d.big + d.small / r.big;
}

// The three terms of d xi, signed, and what the four errors make if they conspire or are independent.
struct Terms {
  double ratio, big_speed, small_speed;
  double worst, rms;
  double sum() const { return ratio + big_speed + small_speed; }
};
Terms terms(const Reading& r, const Reading& d) {
  const double u = r.small / r.big, speeds = r.small_speed / r.big_speed;
  const double big = speeds * u / r.big * d.big, small = speeds / r.big * d.small;
  const double big_speed = u * speeds / r.big_speed * d.big_speed;
  const double small_speed = u / r.big_speed * d.small_speed;
  return {.ratio = -speeds * d_ratio(r, d),
          .big_speed = big_speed,
          .small_speed = -small_speed,
          .worst = big + small + big_speed + small_speed,
          .rms = std::sqrt(big * big + small * small + big_speed * big_speed +
                           small_speed * small_speed)};
}

// The largest |creep - nominal creep| over all corners of the box of errors: no derivative in it.
double largest_by_corners(const Reading& r, const Reading& d) {
  double largest = 0;
  for (int corner = 0; corner < 16; ++corner) {
    const auto sign = [&](int bit) { return corner >> bit & 1 ? 1.0 : -1.0; };
    const Reading moved{r.small + sign(0) * d.small, r.big + sign(1) * d.big,
                        r.small_speed + sign(2) * d.small_speed,
                        r.big_speed + sign(3) * d.big_speed};
    largest = std::max(largest, std::abs(moved.creep() - r.creep()));
  }
  return largest;
}

void rows(report::Item& item) {
  item.columns({"row", "printed", {"recomputed", "{:.5g}"}, "note"});
  item.expect_checks(14);
  const PrintedRows row{item, item.printed("appendix-a.csv")};
  const Terms t = terms(nominal, error);
  const double u = nominal.small / nominal.big;
  row("u", u, "copy reads 10.1, then 0.16",
      report::restored("10.16 cm = 4 in; our copy has lost a digit"));
  row("big-inch", nominal.big / 2.54, "45.03 cm");
  row("radius-unit", 0.0000564 * 45.03 * 10, "from dR_S/R_B as printed",
      report::corrected(0.0254, 1e-3, "the body of the paper measures to 0.0254 mm"));
  row("du-big", -nominal.small / (nominal.big * nominal.big) * error.big, "");
  row("du-small", error.small / nominal.big, "");
  row("du", d_ratio(nominal, error), "");
  row("tooth", error.big_speed, "cut after the fourth decimal",
      report::absolute(5e-5, "1/144 = 0.00694... is cut after the fourth decimal"));
  row("term-1", t.ratio, "");
  row("term-2", t.big_speed, "copy reads 118 in one denominator",
      report::restored("116 rpm, as in the rest; 118 would give 0.0000583"));
  Reading faster = nominal;
  faster.small_speed += error.small_speed;
  row("term-3", t.small_speed, "u = 0.2238 used, last digit cut",
      report::corrected(faster.creep() - nominal.creep(), 1e-9,
                        "equation (1) at both speeds, with the u of the other terms"));
  row("sum", t.sum(), "last digit cut", report::relative(0.01, "carries the third term's 0.2238"));
  item.claim("accurate", "creep is accurate to 0.0005, errors being independent", t.rms <= 0.0005,
             fmt::format("{:.6f}", t.rms));
  item.refute("upper-bound", "0.0005 is an upper bound for the error of the creep",
              t.worst > 0.00055, fmt::format("all errors together make {:.6f}", t.worst));
  item.agree("worst", "errors that conspire", "", t.worst, largest_by_corners(nominal, error), 1e-3,
             "equation (1) at the corners of the errors");

  item.value("xi-conspire", t.worst, "", "{:.6f}");
  item.value("xi-rss", t.rms, "", "{:.6f}");
  item.value("xi-wrong-sign", nominal.creep(), "", "{:.5f}");
  item.value("xi-right-sign",
             Reading{small_radius, big_radius, nominal.small_speed, nominal.big_speed}.creep(), "",
             "{:+.5f}");
}

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

const report::Section creep_chapter::appendices{
    report::table("table-appendix-a", "Appendix A, row by row", rows),
    report::table("table-appendix-b", "Appendix B, row by row", wear_rows),
    report::table("table-text", "Numbers of the main text", text)};
