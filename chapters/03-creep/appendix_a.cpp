/***
Creep is a small difference of two large numbers, $\xi=1-u\,N_S/N_B$ with $u=R_S/R_B$, equation (1), so a relative error
of a speed or a radius is an absolute error of the creep. Appendix A adds up three terms,

$$d\xi=-\frac{N_S}{N_B}\,du+u\frac{N_S}{N_B^2}\,dN_B-\frac{u}{N_B}\,dN_S,\qquad
  du=-\frac{R_S}{R_B^2}\,dR_B+\frac{1}{R_B}\,dR_S,$$

and finds 0.0005. Row by row:

{{table-appendix-a}}

The arithmetic can be followed to the last digit, and each of these slips with it:

* The text takes the radii to 0.00254 mm; the numbers that follow are those of 0.00254 **cm**, the 0.0254 mm of the
  body of the paper. (And the tape gives that precision for the *diameter*: the radius is twice as good.)
* The small radius reads 10.1 cm; only 4 in, 10.16 cm, gives the ratio 0.2256.
* $1/144$ is used as 0.0069 and shown as 0.009.
* The second term shows 118 rpm in its denominator; its result needs the 116 rpm of the rest.
* The third term uses $u$ = 0.2238, close to the value of Appendix B, where the first two use 0.2256. It is cut, not
  rounded, to 0.0003858.
* An error of 1/144 rpm, one tooth in a minute, is taken for the big wheel, and 0.2 rpm, 29 teeth, for the small one,
  on the same kind of counter.
* The terms are added **with their signs**, those of the two radii as well, so that they cancel in part. The sum is no
  upper bound. If all four errors conspire they make {{xi-conspire}}; as independent errors (root of the sum of squares)
  {{xi-rss}}. The claim "accurate to 0.0005" survives as the second and not as the first.
* With the radii of Appendix A the creep at 518 and 116 rpm would be {{xi-wrong-sign}}, a braked wheel that runs *ahead*;
  with those of Appendix B it is {{xi-right-sign}}.

The worst case is checked without any derivative, by evaluating equation (1) at all sixteen corners of the errors.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "items.hpp"
#include "rig.hpp"

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

void rows(report::Item& item) {
  item.columns({"row", "printed", "recomputed, all digits", "from what the row shows", "slip"});
  const auto printed = item.printed("appendix-a.csv");
  const auto add = [&](const char* key, double ours, double shown, const char* slip) {
    item.add_row({printed.at(key, "what"), printed.at(key, "printed"), fmt::format("{:.5g}", ours),
                  fmt::format("{:.5g}", shown), slip});
  };
  const Terms t = terms(nominal, error);
  const double u = nominal.small / nominal.big;
  add("u", u, 10.1 / 45.03, "10.1 cm shown, 10.16 cm = 4 in used");
  add("big-inch", nominal.big / 2.54, nominal.big / 2.54, "");
  const double from_big = -nominal.small / (nominal.big * nominal.big) * error.big;
  add("du-big", from_big, from_big / 10, "text: 0.00254 mm; used: 0.00254 cm");
  add("du-small", error.small / nominal.big, error.small / nominal.big / 10, "the same");
  add("du", d_ratio(nominal, error), d_ratio(nominal, error) / 10, "the same");
  add("tooth", error.big_speed, error.big_speed, "cut; shown as 0.009");
  add("term-1", t.ratio, -0.0000437 * 518 / 116, "0.0000437 × 518/116 rounds to 0.0001951");
  add("term-2", t.big_speed, 0.2256 * 518 / (118.0 * 118.0) * 0.0069, "118 shown, 116 used");
  add("term-3", t.small_speed, -0.2238 / 116 * 0.2, "u = 0.2238 used; last digit cut");
  add("sum", t.sum(), -0.0001951 + 0.000060 - 0.0003858, "last digit cut");

  item.expect_checks(13);
  const auto check = [&](const char* key, double computed,
                         const report::Tolerance& tolerance = report::last_digit()) {
    check_claim(item, printed, key, computed, tolerance);
  };
  check("u", u);
  check("big-inch", nominal.big / 2.54);
  check("du-big", from_big);
  check("du-small", error.small / nominal.big);
  check("du", d_ratio(nominal, error));
  check("tooth", error.big_speed,
        report::absolute(5e-5, "1/144 = 0.00694... is cut after the fourth decimal"));
  check("term-1", t.ratio);
  check("term-2", t.big_speed, report::absolute(1e-6, "0.0069 for 1/144 makes it 0.0000599"));
  check("term-3", t.small_speed,
        report::misprint(-(10.16 / 45.03) * (0.2 / 116), 1e-12,
                         "u = 0.2238 in this term, 0.2256 in the others"));
  check("sum", t.sum(), report::relative(0.01, "carries the 0.2238 of the third term"));
  check("claim", t.rms, report::at_most("as independent errors, not as an upper bound"));
  item.agree("worst", "errors that conspire", "", t.worst, largest_by_corners(nominal, error), 1e-3,
             "equation (1) at the corners of the errors");
  item.agree("third", "the third term as printed", "", 0.2238 * 0.2 / 116, 0.0003858, 2e-4,
             "its printed value, cut");

  item.value("xi-conspire", t.worst, "", "{:.6f}");
  item.value("xi-rss", t.rms, "", "{:.6f}");
  item.value("xi-wrong-sign", nominal.creep(), "", "{:.5f}");
  item.value("xi-right-sign",
             Reading{small_radius, big_radius, nominal.small_speed, nominal.big_speed}.creep(), "",
             "{:+.5f}");
}

}  // namespace

void creep_chapter::add_appendix_a(report::Chapter& chapter) {
  chapter.table("table-appendix-a", "Appendix A, row by row", rows);
}
