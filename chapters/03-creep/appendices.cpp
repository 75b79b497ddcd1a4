/***
## How accurate is a measured creep?

Creep is a small difference of two large numbers, so a relative error of a speed or a radius is an
absolute error of the creep. The paper's Appendix A puts numbers on it. With the ratio of the radii,
$u=R_S/R_B$, the differential of (1) has three terms,

$$d\xi=-\frac{N_S}{N_B}\,du+u\frac{N_S}{N_B^2}\,dN_B-\frac{u}{N_B}\,dN_S,\qquad
  du=-\frac{R_S}{R_B^2}\,dR_B+\frac{1}{R_B}\,dR_S. \tag{i}$$

The appendix adds them up and finds 0.0005. Row by row, the print and its recomputation:

{{table-appendix-a}}

**Is the sum an upper bound?** The paper calls it one. But the terms are added with their signs,
those of the two radii as well, and so they cancel in part. If all four errors act in the same
direction they make {{xi-worst}}; other roundings and readings of the printed numbers give
{{worst-range}} {{outcome:table-appendix-a/upper-bound}}. Taken as independent errors, by the root
of the sum of their squares, they make {{xi-rss}}. In that sense the creep is accurate to 0.0005
{{outcome:table-appendix-a/accurate}}. Here and below the errors have the unit of the speeds, as in
the appendix's sum; which unit that is does not matter. If the speeds are counts of teeth in a
second (see the fold on load and speed) and the errors rpm, all four make {{counts-rss}} if
independent and {{counts-worst}} at worst.

The worst case is checked without any derivative. `largest_by_corners` evaluates (1) at all sixteen
corners of the box of errors, each of which is either added or subtracted, and takes the largest
distance from the creep in the middle:

{{code: appendices.cpp largest_by_corners}}

::: {.fold summary="What is damaged in the appendix, and what slipped"}

* The text of the appendix, as we have it, says 0.00254 mm for the error of a radius. Its numbers
  are those of 0.00254 **cm**, which is the 0.0254 mm of the body of the paper
  {{outcome:table-appendix-a/radius-unit}}. With 0.00254 mm the four errors would make
  {{worst-by-mm}} at worst, and 0.0005 would bound them; but the paper's own terms rule this out.
* The third term uses $u$ = 0.2238 {{outcome:table-appendix-a/term-3}}, close to the value of
  Appendix B, where the first two use 0.2256. With 0.2256 it would be {{third-term}}.
* Our copy is damaged in four places: it reads "10.1" for 10.16 cm (4 in), "118" for 116 rpm,
  "0.009" for 0.0069 and "22238" for 0.2238. The paper's results need the second of each pair.
* For the big wheel 1/144 is taken, in rpm one tooth in a minute, and for the small one 0.2. The
  paper does not explain the difference.
* The radii of Appendix A cannot be those of its two speeds. At 518 and 116 rpm they give a creep of
  {{xi-wrong-sign}}: a braked wheel would run *ahead*. With the radii of Appendix B it is
  {{xi-right-sign}}. The sizes of the errors hardly depend on this.

:::

**Could the radii be left out?** Before each test the longitudinal force was brought to zero with
the small motor. A creep counted from that zero would be free of the errors of the radii. But it
would be the difference of two readings, so the errors of the speeds would count twice:
{{zero-worst}} at worst, {{zero-rss}} if independent. The paper computes its creep by (1), from the
radii.

**Wear during a test.** Appendix B asks what wear does to a reading. After five hours at $\mu$ = 0.3
the small wheel has lost 0.00152 cm of diameter, and the big one is assumed to have lost as much.
The speeds are exact here, so only the first term of (i) stays.

{{table-appendix-b}}

The appendix prints 0.0000588, the body of the paper 0.00005, which is the same number cut to one
digit. {{outcome:table-appendix-b/text}}

::: {.fold summary="The load and the speed that the text prints"}

"4449.72 N" is 1000 lb taken as 0.45359 kg each at 9.81 m/s² (1000 lbf are
{{load-exact}}), and the force error of 22.249 N is 5 lb in the same way. The third number is the
speed of 8.224 km/h for "near 50 rpm". At exactly 50 rpm the rim of the big wheel runs at
{{speed-50}}, and 8.224 km/h is {{rpm-needed}}.

{{table-text}}

The nomenclature gives the speeds of the wheels in rpm. But 116 and 99.2 rpm, those of the two
appendices, are {{speed-at-116}} and {{speed-at-99}}, twice as fast. If they are counts of the
gear's 144 teeth in a *second*, Appendix A's 116 are {{rpm-by-teeth}}, which is near 50, and
{{speed-by-teeth}}, close to the print; Appendix B's 99.2 are then {{rpm-99-by-teeth}}. The
publisher's listing has 5 miles per hour, {{five-mph}}. {{outcome:table-text/speed}} So the speeds
seem to be counts of teeth. The creep does not depend on it, since only the ratio of the speeds
enters, and the errors of Appendix A do only if their unit is another one.

:::

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/report/values.hpp>

#include "rig.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

namespace {

// The printed values of a table, each checked once.
struct PrintedRows {
  report::Item& item;
  table::CsvTable table;
  void operator()(const char* key, double computed,
                  const report::Expectation& expectation = report::last_digit()) const {
    item.print(key, table.at(key, "what"), table.at(key, "unit"), table.at(key, "printed"),
               computed, expectation);
  }
};

// Lengths in cm and speeds in rpm, as the appendix has them.
struct Reading {
  double small, big, small_speed, big_speed;
  double creep() const { return 1 - small / big * small_speed / big_speed; }
};
constexpr Reading nominal{4 * 2.54, 45.03, 518, 116};
constexpr Reading error{0.00254, 0.00254, 0.2, 1.0 / 144};

// rpm of a wheel whose gear of 144 teeth passes `counts` in a second.
double rpm_by_teeth(double counts) {
  return counts * 60 / 144;
}

// The same if the speeds are counts of teeth in a second.
Reading nominal_by_teeth() {
  return {nominal.small, nominal.big, rpm_by_teeth(nominal.small_speed),
          rpm_by_teeth(nominal.big_speed)};
}

double d_ratio(const Reading& r, const Reading& d) {
  return -r.small / (r.big * r.big) * d.big + d.small / r.big;
}

// The three terms of d xi, signed, and what the four errors make at worst or if they are
// independent; then the same for the errors of the two speeds alone.
struct Terms {
  double ratio, big_speed, small_speed;
  double worst, rms;
  double speeds_worst, speeds_rms;
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
                           small_speed * small_speed),
          .speeds_worst = big_speed + small_speed,
          .speeds_rms = std::hypot(big_speed, small_speed)};
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

// The u that the third term prints.
constexpr double third_ratio = 0.2238;

// What is rounded in Appendix A, or could be read otherwise: its errors at their worst stay above
// the 0.0005 that they are said to be bounded by.
report::Trial upper_bound(const report::Item& item) {
  report::Trial trial = item.trial("upper-bound", "errors of Appendix A at worst", "{:.5f}",
                                   [](double worst) { return worst > 0.00055; });
  const auto worst = [](const Reading& r, const Reading& d) { return terms(r, d).worst; };
  trial.vary("rounding of radii and speeds", [&](const report::Setting& s) {
    const double sign = static_cast<double>(s.index) - 1;  // least, as printed, most
    return worst({nominal.small + sign * 0.005, nominal.big - sign * 0.005,
                  nominal.small_speed + sign * 0.5, nominal.big_speed - sign * 0.5},
                 error);
  });
  trial.vary("error of the radii", [&](const report::Setting& s) {
    return worst(nominal, {s.number, s.number, error.small_speed, error.big_speed});
  });
  trial.vary("error of the small wheel's speed", [&](const report::Setting& s) {
    return worst(nominal, {error.small, error.big, s.number, error.big_speed});
  });
  trial.vary("error of the big wheel's speed", [&](const report::Setting& s) {
    return worst(nominal, {error.small, error.big, error.small_speed, s.number});
  });
  trial.vary("unit of the speeds, their errors in rpm", [&](const report::Setting& s) {
    return worst(s.index == 0 ? nominal : nominal_by_teeth(), error);
  });
  const Terms t = terms(nominal, error);
  trial.vary("errors of the two radii", [&](const report::Setting& s) {
    return s.index == 0 ? t.worst : std::abs(t.ratio) + t.speeds_worst;
  });
  trial.vary("u of the third term", [&](const report::Setting& s) {
    return t.worst +
           (s.number - nominal.small / nominal.big) * error.small_speed / nominal.big_speed;
  });
  return trial;
}

// The error of a radius [mm] that the printed terms are computed with.
report::Trial radius_unit(const report::Item& item, const std::string& printed,
                          const table::CsvTable& rows) {
  report::Trial trial = item.trial("radius-unit", "error of a radius by the printed terms",
                                   "{:.4f} mm", report::misses(printed));
  const auto term = [&](const char* key) {
    return std::abs(report::printed_number(rows.at(key, "printed")));
  };
  const double by_small = term("du-small") * nominal.big * 10;
  trial.vary("printed term", [&](const report::Setting& s) {
    const double by_big = term("du-big") * nominal.big * nominal.big / nominal.small * 10;
    const double by_sum = term("du") / (1 / nominal.big - nominal.small / std::pow(nominal.big, 2));
    return s.index == 0 ? by_small : s.index == 1 ? by_big : by_sum * 10;
  });
  trial.vary("rounding of the term 0.0000564",
             [&](const report::Setting& s) { return s.number * nominal.big * 10; });
  trial.vary("radius of the big wheel",
             [&](const report::Setting& s) { return term("du-small") * s.number * 10; });
  return trial;
}

void rows(report::Item& item) {
  item.expect_checks(13);
  const PrintedRows row{item, item.printed("appendix-a.csv")};
  const Terms t = terms(nominal, error), by_teeth = terms(nominal_by_teeth(), error);
  const double u = nominal.small / nominal.big;
  row("u", u, report::restored("10.16 cm = 4 in; our copy has lost a digit"));
  row("big-inch", nominal.big / 2.54);
  row("radius-unit", report::printed_number(row.table.at("du-small", "printed")) * nominal.big * 10,
      report::corrected(0.0254, 1e-3, "the body of the paper measures to 0.0254 mm",
                        radius_unit(item, row.table.at("radius-unit", "printed"), row.table)));
  row("du-big", -nominal.small / (nominal.big * nominal.big) * error.big);
  row("du-small", error.small / nominal.big);
  row("du", d_ratio(nominal, error));
  row("tooth", error.big_speed,
      report::absolute(5e-5, "1/144 = 0.00694... is cut after the fourth decimal"));
  row("term-1", t.ratio);
  row("term-2", t.big_speed, report::restored("116 rpm, as in the rest; 118 would give 0.0000583"));
  const double third = -third_ratio / nominal.big_speed * error.small_speed;
  row("term-3", third,
      report::restored("the line has u = 0.2238, in our copy \"22238\"",
                       report::absolute(1e-7, "cut after the seventh decimal")));
  row("sum", t.ratio + t.big_speed + third, report::absolute(1e-6, "cut after the sixth decimal"));
  item.claims({{"accurate", {t.rms, by_teeth.rms}}});
  const report::Trial trial = upper_bound(item);
  item.refute(
      "upper-bound", "the sum of Appendix A, 0.0005, is an upper bound for its errors", trial,
      fmt::format("at worst they make {:.5f}, {} with other readings", t.worst, trial.range()));
  item.agree("worst", "the four errors at their worst", "", t.worst,
             largest_by_corners(nominal, error), 1e-3, "equation (1) at the corners of the errors");

  const Reading in_mm{error.small / 10, error.big / 10, error.small_speed, error.big_speed},
      other_radii{small_radius, big_radius, nominal.small_speed, nominal.big_speed};
  item.value("worst-range", trial.range());
  report::values(item, "", "{:.5f}", "xi-worst", t.worst, "worst-by-mm",
                 terms(nominal, in_mm).worst, "xi-rss", t.rms, "zero-worst", 2 * t.speeds_worst,
                 "zero-rss", std::sqrt(2.0) * t.speeds_rms, "xi-wrong-sign", nominal.creep(),
                 "counts-worst", by_teeth.worst, "counts-rss", by_teeth.rms);
  item.value("third-term", t.small_speed, "", "{:.6f}");
  item.value("xi-right-sign", other_radii.creep(), "", "{:+.5f}");
}

// Rim speed [km/h] of a wheel of `radius` [m].
double rim_speed(double radius, double rpm) {
  return 2 * units::pi * radius * rpm / 60 / units::kilometre_per_hour;
}

// What five hours of wear do to the reading of Appendix B.
struct Wear {
  static constexpr double change = 0.00152 / 2;  // of a radius, cm, both wheels
  Reading reading{small_radius / centimetre, big_radius / centimetre, small_rpm, big_rpm};
  double from_big = -reading.small / (reading.big * reading.big) * change;
  double from_small = change / reading.big, du = from_big + from_small;
  double dxi = -du * (small_rpm / big_rpm);
  // Equation (1) at both radii, no differential.
  double creep_change() const {
    return (reading.small / reading.big - (reading.small - change) / (reading.big - change)) *
           (small_rpm / big_rpm);
  }
};

void wear_rows(report::Item& item) {
  item.expect_checks(10);
  const PrintedRows row{item, item.printed("appendix-b.csv")};
  const Wear wear;
  const auto cut = [](double allowed) {
    return report::absolute(allowed, "the printed value is cut, not rounded");
  };
  row("small", wear.reading.small, cut(1e-4));
  row("big", wear.reading.big, cut(1e-4));
  row("radius-change", wear.change);
  row("radius-change-mm", wear.change * 10);
  row("du-big", wear.from_big, cut(1e-7));
  row("du-small", wear.from_small);
  row("du", wear.du, report::absolute(1e-7, "the printed terms are rounded before they are added"));
  row("dxi", -wear.dxi, report::relative(0.01, "carries the rounding of du"));
  row("text", -wear.dxi, report::absolute(1e-5, "0.0000588 cut to one digit"));
  item.claims({{"small-error", {-wear.dxi}}});
  item.agree("creep-change", "change of creep", "", wear.creep_change(), -wear.dxi, 1e-3,
             "the differential of Appendix B");
}

void text(report::Item& item) {
  item.expect_checks(3);
  const PrintedRows row{item, item.printed("text.csv")};
  row("load", paper_load, report::fitted("the factors are chosen to meet it"));
  row("force-error", 5 * paper_pound_force, report::fitted("5 lb is chosen to meet it"));
  const double big = nominal.big * centimetre;
  const double by_teeth = rim_speed(big, rpm_by_teeth(nominal.big_speed));
  row("speed", by_teeth,
      report::relative(0.005, "\"near 50 rpm\" is read as Appendix A's 116, in counts a second"));
  item.value("five-mph", 5 * units::mph / units::kilometre_per_hour, "km/h", "{:.2f}");
  item.value("load-exact", 1000 * units::lbf, "N", "{:.3f}");
  report::values(item, "km/h", "{:.2f}", "speed-50", rim_speed(big, 50), "speed-by-teeth",
                 by_teeth);
  report::values(item, "km/h", "{:.1f}", "speed-at-116", rim_speed(big, nominal.big_speed),
                 "speed-at-99", rim_speed(big_radius, big_rpm));
  report::values(item, "rpm", "{:.1f}", "rpm-needed",
                 report::printed_number(row.table.at("speed", "printed")) / rim_speed(big, 1),
                 "rpm-by-teeth", rpm_by_teeth(nominal.big_speed), "rpm-99-by-teeth",
                 rpm_by_teeth(big_rpm));
}

}  // namespace

creep_chapter::CreepError creep_chapter::appendix_a_error() {
  const Terms t = terms(nominal, error), by_teeth = terms(nominal_by_teeth(), error);
  return {t.worst, t.rms, by_teeth.worst, by_teeth.rms};
}

const report::Section creep_chapter::appendices{report::table("table-appendix-a", rows),
                                                report::table("table-appendix-b", wear_rows),
                                                report::table("table-text", text)};
