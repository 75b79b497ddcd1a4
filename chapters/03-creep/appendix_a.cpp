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
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rig.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

namespace {

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

}  // namespace

void creep_chapter::PrintedRows::operator()(const char* key, double computed, const char* note,
                                            const report::Expectation& expectation) const {
  const std::string &what = table.at(key, "what"), &text = table.at(key, "printed");
  item.add_row(what, text, computed, note);
  item.print(key, what, table.at(key, "unit"), text, computed, expectation);
}

namespace {

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

}  // namespace

const report::Section creep_chapter::appendix_a{
    report::table("table-appendix-a", "Appendix A, row by row", rows)};
