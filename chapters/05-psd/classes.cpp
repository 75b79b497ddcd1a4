/*** ## Classes

The federal standards limit what a 62-ft chord reads. The paper asks the random part to stay within three standard
deviations and the joints within twice their dip, and adds the two as squares; with (8) that is

$$(\alpha\sigma)^2+(\gamma B)^2\le D_m(L)^2, \qquad \alpha=3,\ \gamma=2, \tag{9}$$

$$d^2 = kA + 4B^2 \le D_m(19)^2, \qquad k = \tfrac92\pi^2 L. \tag{10}$$

The class of a zone is the highest $m$ whose limit $D_m$ its $d$ keeps. The limits themselves are not printed in the paper; they are
3, 2¾, 2¼, 2, 1¼ and ½ in for classes 1 to 6. The number in front of $A$ cannot be read in the copy at hand. Derived from (8) it is
$k$ = {{k-19}} for a chord of 19 m and {{k-62}} for 62 ft.

### Table 3

{{table-3}}

Twelve of the thirteen classes come out as printed. Zone 12 does not: its $d$ is {{zone-12-d}} against a limit of {{zone-12-limit}} for
class 3, inside by {{zone-12-margin}}, while the paper has it in class 2: a borderline rather than a misprint, for half a unit in the last digit of its
$A$ and $B$ moves $d$ from {{zone-12-low}} to {{zone-12-high}}.

The plus and minus signs were put by eye: "−" stands at zones 7 and 8, which lie in the lower half of their class as the paper says, "+" at a zone
that is close to the next class (6) or far inside the last (13). But zone 10, closer to class 5 than zone 6 is to class 6, has no sign. The text
says that zones 3 and 4 were rebuilt after the survey; the table marks 3 and 5.

### Which coefficient did the paper use?

Each printed class allows a range of $k$; all thirteen, zone 12 included, hold together for {{k-low}} < $k$ ≤ {{k-high}}. The derived one lies
below. So the number in print was either larger than (8) makes it, or the points were placed by eye. The other readings:

{{table-k}}

### Figure 11

{{fig-11}}

Below {{fig-11}} a track can be chosen by its roughness $A$ and its dip $B$: the class that rule (10) gives it, and how much of the deviation each part has.

Up to the rounded corner of a limit the class is set by $A$ alone, right of it by $B$ alone. On the dashed
line both parts weigh the same. "All points tended to cluster" near it, says the paper, "thus" a rougher random part goes with deeper joints: the
correlation of $\ln A$ and $\ln B$ is {{correlation}}. That on the average jointed track lies to the right of
the line and welded track to the left holds for {{jointed-right}} of 6 jointed zones and for {{welded-left}} of 7 welded ones.
*/
#include "spectra/classify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/answer.hpp"
#include "sections.hpp"

namespace railbook::psd_chapter {

namespace {

const spectra::ClassRule rule_10{.chord = 19.0};

// The rule with another coefficient of A.
spectra::ClassRule with_coefficient(double k) {
  spectra::ClassRule rule = rule_10;
  rule.alpha = 1;
  rule.alpha = std::sqrt(k / spectra::random_coefficient(rule));
  return rule;
}

// "5+" is class 5.
int printed_class(const table::CsvTable& table_3, const std::string& zone) {
  return table_3.at(zone, "class")[0] - '0';
}

int class_by(const Zone& zone, const spectra::ClassRule& rule) {
  return spectra::classify(zone.track.A, zone.track.B, rule).track_class;
}

void table_3(report::Item& item) {
  const table::CsvTable printed = item.printed("table-3.csv");
  const auto all = zones(item);
  item.expect_checks(static_cast<int>(all.size()) + 3);
  int applies = 0, agrees = 0, most_off = 0, in_class_5 = 0;
  item.columns({"zone",
                {"3σ, mm", "{:.2f}"},
                {"2B, mm", "{:.1f}"},
                {"d, mm", "{:.1f}"},
                {"class limit, mm", "{:.2f}"},
                {"d / limit", "{:.3f}"},
                {"class", "{:.0f}"},
                "class printed",
                "railroad's class (km/h)"});
  for (const Zone& zone : all) {
    const auto result = spectra::classify(zone.track.A, zone.track.B, rule_10);
    const std::string& paper = printed.at(zone.name, "class");
    if (zone.name == "12") {
      // The same rule with (8) by quadrature.
      const double k = 9 * variance_by_quadrature(rule_10.chord);
      item.print("zone-12", "zone 12, class", "", paper, result.track_class,
                 report::not_confirmed(
                     class_by(zone, with_coefficient(k)), 1e-9,
                     fmt::format("a borderline: d lies inside class 3 by {:.1f} %, on the limit "
                                 "within the rounding of A and B",
                                 100 * result.margin)));
    } else {
      item.print_text("zone-" + zone.name, "zone " + zone.name + ", class", paper.substr(0, 1),
                      std::to_string(result.track_class));
    }
    in_class_5 += result.track_class == 5;
    if (printed.at(zone.name, "comment").empty()) {  // the railroad's class applied at the survey
      const int off = printed.at(zone.name, "railroad_class")[0] - paper[0];
      ++applies;
      agrees += off == 0;
      most_off = std::max(most_off, std::abs(off));
    }
    item.add_row(zone.name, result.random / mm, result.periodic / mm, result.deviation / mm,
                 result.deviation / (1 - result.margin) / mm, 1 - result.margin,
                 double(result.track_class), paper,
                 fmt::format("{} ({})", printed.at(zone.name, "railroad_class"),
                             printed.at(zone.name, "railroad_kmh")));
  }
  item.claim(
      "railroad", "where correct data is available, Figure 11 agrees well with the railroad",
      2 * agrees > applies && most_off <= 1,
      fmt::format("{} of the {} zones whose railroad class applied agree, no other is off by "
                  "more than {}",
                  agrees, applies, most_off));
  const double middle = 0.5 * (rule_10.limits[4] + rule_10.limits[5]);
  const auto deviation = [](double A, double B) {
    return spectra::design_deviation(A, B, rule_10);
  };
  const double d_7 = deviation(all.at(6).track.A, all.at(6).track.B),
               d_8 = deviation(all.at(7).track.A, all.at(7).track.B);
  item.claim("lower-range", "zones 7 and 8 are in the lower range of class 5",
             std::min(d_7, d_8) > middle,
             fmt::format("d = {:.1f} and {:.1f} mm, the class goes from {:.1f} to {:.1f} mm",
                         d_7 / mm, d_8 / mm, rule_10.limits[5] / mm, rule_10.limits[4] / mm));
  item.claim("most-5", "most of the zones studied ended up as class 5", 2 * in_class_5 > 13,
             fmt::format("{} of 13", in_class_5));
  const auto& z = all.at(11).track;
  const auto borderline = spectra::classify(z.A, z.B, rule_10);
  item.value("zone-12-d", borderline.deviation / mm, "mm", "{:.1f}");
  item.value("zone-12-limit", rule_10.limits[2] / mm, "mm", "{:.2f}");
  item.value("zone-12-margin", 100 * borderline.margin, "%", "{:.1f}");
  item.value("zone-12-low", deviation(z.A - 0.05e-7, z.B - 0.05 * mm) / mm, "mm", "{:.1f}");
  item.value("zone-12-high", deviation(z.A + 0.05e-7, z.B + 0.05 * mm) / mm, "mm", "{:.1f}");
}

void table_k(report::Item& item) {
  const table::CsvTable readings = item.printed("coefficients.csv");
  const table::CsvTable table_3 = item.printed("table-3.csv");
  const auto all = zones(item);
  const double k_19 = spectra::random_coefficient(rule_10);
  item.expect_checks(1);
  item.agree("k-19", "k, chord of 19 m", "m", k_19, 9 * variance_by_quadrature(19), 1e-5,
             "quadrature of (8)");
  item.columns({{"k, m", "{:.1f}"}, "reading", {"zones as printed", "{:.0f}"}, "not as printed"});
  for (std::size_t i = 0; i < readings.rows.size(); ++i) {
    const std::string& key = readings.at(i, "key");
    const double k = key == "derived"     ? k_19
                     : key == "two-sided" ? 2 * k_19
                     : key == "275 pi"    ? 275 * units::pi
                                          : report::printed_number(key);
    std::string others;
    int as_printed = 0;
    for (const Zone& zone : all)
      if (class_by(zone, with_coefficient(k)) == printed_class(table_3, zone.name))
        ++as_printed;
      else
        others += (others.empty() ? "" : ", ") + zone.name;
    item.add_row(k, readings.at(i, "what"), double(as_printed), others);
  }
  // The range of k that a printed class allows follows from its limits in closed form.
  spectra::CoefficientRange range{0, units::no_limit};
  for (const Zone& zone : all) {
    const auto of = spectra::coefficient_range(zone.track.A, zone.track.B,
                                               printed_class(table_3, zone.name), rule_10);
    range = {std::max(range.low, of.low), std::min(range.high, of.high)};
  }
  item.value("k-19", k_19, "m", "{:.2f}");
  item.value("k-62", spectra::random_coefficient({}), "m", "{:.2f}");
  item.value("k-low", range.low, "m", "{:.0f}");
  item.value("k-high", range.high, "m", "{:.0f}");
  item.added("the coefficient cannot be read in our copy");
}

// A along the curve d = D, for a dip B; negative beyond its end.
double roughness_at(double D, double B) {
  return (D * D - std::pow(rule_10.gamma * B, 2)) / spectra::random_coefficient(rule_10);
}

void limit_curves(report::Item& item) {
  auto& limits = item.data({"class", "B_mm", "A_m2_cycle_per_m"});
  for (int m = 1; m <= spectra::classes; ++m) {
    const double D = rule_10.limits[static_cast<std::size_t>(m - 1)], end = D / rule_10.gamma;
    // Dense towards the end, where the curve falls to zero.
    limits.add(m, 0.4, roughness_at(D, 0.4 * mm));
    for (double s = 1; s > 1e-4; s *= 0.93)
      if (const double B = end * (1 - s); B > 0) limits.add(m, B / mm, roughness_at(D, B));
    for (double A = roughness_at(D, end * (1 - 1e-4)); A > 1e-9; A *= 0.5)
      limits.add(m, end / mm, A);
    limits.gap();
  }
}

// The answer below the figure.
void class_answer(report::Item& item) {
  report::Answer answer{item,
                        {"A_m²-cycle/m", "B_mm"},
                        {{"random part of the spectrum", "wavenumber, cycle/m",
                          "density, m²/(cycle/m)", 0.005, 1, 1e-9, 0.1, "log"},
                         {"design deviation", "class", "mm", 0.5, 6.5, 0, 80},
                         {.name = "class", .kind = "says"}}};
  for (int i = 0; i <= 10; ++i) {
    const double A = 1e-8 * std::pow(10.0, 0.25 * i);
    for (double B = 0; B < 21; B += 2) {
      const auto c = spectra::classify(A, B * mm, rule_10);
      answer.at({A, B});
      for (const double phi : {0.005, 1.0})  // a straight line on these axes
        answer.point("random part of the spectrum", "", phi, spectra::random_psd({.A = A}, phi));
      for (int m = 1; m <= spectra::classes; ++m)
        answer.point("design deviation", "limit of the class", m,
                     rule_10.limits[static_cast<std::size_t>(m - 1)] / mm);
      answer.point("design deviation", "this track", 0.5, c.deviation / mm);
      answer.point("design deviation", "this track", 6.5, c.deviation / mm);
      answer.says("class", "class", c.track_class);
      answer.says("class", "deviation d, mm", c.deviation / mm);
      answer.says("class", "of the random part, mm", c.random / mm);
      answer.says("class", "of the joints, mm", c.periodic / mm);
    }
  }
}

void fig_11(report::Item& item) {
  item.rebuilt(
      "points are the printed A and B; the coefficient of A cannot be read and is derived, the "
      "class limits are taken from the standards the paper refers to");
  limit_curves(item);
  auto& zone_points = item.data("zones", {"zone", "B_mm", "A_m2_cycle_per_m", "jointed"});
  const table::CsvTable table_1 = item.printed("table-1.csv");
  const auto all = zones(item);
  Eigen::ArrayXd log_A(13), log_B(13);
  int jointed_right = 0, welded_left = 0;
  double jointed_mean = 0, welded_mean = 0;  // of ln(2B/3σ)
  for (Eigen::Index i = 0; i < 13; ++i) {
    const Zone& zone = all.at(static_cast<std::size_t>(i));
    const bool jointed = table_1.at(zone.name, "comment").find("joint") != std::string::npos;
    zone_points.add(zone.name, zone.track.B / mm, zone.track.A, jointed ? 1.0 : 0.0);
    const auto d = spectra::classify(zone.track.A, zone.track.B, rule_10);
    (jointed ? jointed_mean : welded_mean) += std::log(d.periodic / d.random);
    jointed_right += jointed && d.periodic > d.random;
    welded_left += !jointed && d.periodic < d.random;
    log_A[i] = std::log(zone.track.A);
    log_B[i] = std::log(zone.track.B);
  }
  const auto a = log_A - log_A.mean(), b = log_B - log_B.mean();
  const double correlation = (a * b).sum() / std::sqrt(a.square().sum() * b.square().sum());
  // Student's t of a correlation; 1.796 is passed by chance once in twenty, with 13 - 2 degrees of freedom.
  const double t = correlation * std::sqrt(11 / (1 - correlation * correlation));
  item.expect_checks(3);
  item.claim(
      "cluster",
      "all points cluster near the line of equal A and B behaviour: a rougher random part goes "
      "with deeper joints",
      t > 1.796, fmt::format("the correlation of ln A and ln B is {:.2f}", correlation));
  item.claim("jointed", "jointed sections have on the average more B than A behaviour",
             jointed_mean > 0, fmt::format("{} of 6 lie right of the line", jointed_right));
  item.claim("welded", "the converse is true of welded rail", welded_mean < 0,
             fmt::format("{} of 7 lie left of the line", welded_left));
  item.value("correlation", correlation, "", "{:.2f}");
  item.value("jointed-right", jointed_right, "", "{:.0f}");
  item.value("welded-left", welded_left, "", "{:.0f}");
  auto& equal = item.data("equal", {"B_mm", "A_m2_cycle_per_m"});
  for (double B = 0.2 * mm; B < 60 * mm; B *= 1.1)
    equal.add(B / mm, std::pow(rule_10.gamma * B, 2) / spectra::random_coefficient(rule_10));
  auto& labels = item.data("labels", {"class", "B_mm", "A_m2_cycle_per_m"});
  for (int m = 1; m <= spectra::classes; ++m) {
    const double B = (m % 2 == 1 ? 0.56 : 0.72) * mm;  // staggered, so that they stay apart
    labels.add(m, B / mm, roughness_at(rule_10.limits[static_cast<std::size_t>(m - 1)], B));
  }
  class_answer(item);
}

}  // namespace

const report::Section classes{
    report::table("table-3", "Classes of the thirteen zones (Table 3)", table_3),
    report::table("table-k", "Readings of the coefficient of A in rule (10)", table_k),
    report::figure(
        "fig-11", "Roughness against joint dip, with the limits of the classes (Fig. 11)", fig_11)};

}  // namespace railbook::psd_chapter
