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
class 3, inside by {{zone-12-margin}}, while the paper has it in class 2. Nobody reads a graph that closely, so it is a
borderline rather than a misprint. Half a unit in the last digit of its $A$ and $B$ moves $d$ from {{zone-12-low}} to {{zone-12-high}}.

The plus and minus signs were put by eye: "−" goes with $d$ above 0.85 of the limit (zones 7 and 8, and 12), "+" with a zone that is close
to the next class (6) or far inside the last (13). But zone 10, closer to class 5 than zone 6 is to class 6, has no sign. The text
says that zones 3 and 4 were rebuilt after the survey; the table marks 3 and 5.

### Which coefficient did the paper use?

Each printed class allows a range of $k$; all thirteen, zone 12 included, hold together for {{k-low}} < $k$ ≤ {{k-high}}. The derived one lies
below. So the number in print was either larger than (8) makes it, or the points were placed by eye. The other readings are out:

{{table-k}}

### Figure 11

{{fig-11}}

{{include: answer.cpp}}

On log-log paper each class limit is a rounded corner: up to it the class is set by $A$ alone, right of it by $B$ alone. On the dashed
line both parts weigh the same. Most of the thirteen zones crowd around it, as the paper remarks. Its other remark, that jointed track lies to the right of
the line and welded track to the left, holds for {{jointed-right}} of 6 jointed zones and for {{welded-left}} of 7 welded ones.
*/
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "num/quadrature.hpp"
#include "sections.hpp"
#include "spectra/chord.hpp"
#include "spectra/classify.hpp"
#include "units/input_error.hpp"

namespace railbook::psd_chapter {

namespace {

constexpr double mm = units::millimetre;
const spectra::ClassRule paper_rule{.chord = 19.0};

// The rule with another coefficient of A.
spectra::ClassRule with_coefficient(double k) {
  spectra::ClassRule rule = paper_rule;
  rule.alpha = 1;
  rule.alpha = std::sqrt(k / spectra::random_coefficient(rule));
  return rule;
}

// "5+" is class 5.
int printed_class(const table::CsvTable& table_3, const std::string& zone) {
  return table_3.at(zone, "class")[0] - '0';
}

int class_of(const Zone& zone, const spectra::ClassRule& rule) {
  return spectra::classify(zone.track.A, zone.track.B, rule).track_class;
}

/*** The allowed range of $k$ follows from the limits in closed form. It is found again by trying: the classes of all zones are
counted while $k$ moves, and the ends are bisected.
*/
spectra::CoefficientRange common_range(const std::vector<Zone>& all,
                                       const table::CsvTable& table_3) {
  spectra::CoefficientRange common{0, units::no_limit};
  for (const Zone& zone : all) {
    const auto range = spectra::coefficient_range(zone.track.A, zone.track.B,
                                                  printed_class(table_3, zone.name), paper_rule);
    common = {std::max(common.low, range.low), std::min(common.high, range.high)};
  }
  return common;
}

int zones_as_printed(const std::vector<Zone>& all, const table::CsvTable& table_3, double k) {
  int count = 0;
  for (const Zone& zone : all)
    count += class_of(zone, with_coefficient(k)) == printed_class(table_3, zone.name) ? 1 : 0;
  return count;
}

// Between `wrong` and `right` the count of zones as printed becomes complete.
double end_by_bisection(const std::vector<Zone>& all, const table::CsvTable& table_3, double wrong,
                        double right) {
  const int every = static_cast<int>(all.size());
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (wrong + right);
    (zones_as_printed(all, table_3, middle) == every ? right : wrong) = middle;
  }
  return right;
}

// Equation (8) by quadrature: a period of the gain at a time, and the mean square 3/2 of the gain for the rest.
double variance_by_quadrature(double chord) {
  const int periods = 200;
  double variance = 1.5 * chord / (2.0 * periods);
  for (int i = 0; i < periods; ++i)
    variance += num::integrate(
                    [&](double phi) { return std::pow(spectra::chord_gain(chord, phi) / phi, 2); },
                    i * 2 / chord, (i + 1) * 2 / chord)
                    .value;
  return variance;
}

// The class by the rule with that quadrature in place of (8).
int class_by_quadrature(const Zone& zone) {
  const double random = 9 * zone.track.A * variance_by_quadrature(paper_rule.chord);
  const double d = std::sqrt(random + std::pow(paper_rule.gamma * zone.track.B, 2));
  int best = 0;
  for (int m = 1; m <= spectra::classes; ++m)
    if (d <= paper_rule.limits[static_cast<std::size_t>(m - 1)]) best = m;
  return best;
}

void table_3(report::Item& item) {
  const table::CsvTable printed = item.printed("table-3.csv");
  const auto all = zones(item.printed("table-1.csv"));
  item.expect_checks(static_cast<int>(all.size()) + 1);
  int applies = 0, agrees = 0;
  item.columns({"zone", "3σ, mm", "2B, mm", "d, mm", "class limit, mm", "d / limit", "class",
                "class printed", "railroad's class (km/h)"});
  for (const Zone& zone : all) {
    const auto result = spectra::classify(zone.track.A, zone.track.B, paper_rule);
    const std::string& paper = printed.at(zone.name, "class");
    const double limit = result.deviation / (1 - result.margin);
    if (zone.name == "12") {
      item.print("zone-12", "zone 12, class", "", paper, result.track_class,
                 report::not_confirmed(class_by_quadrature(zone), 1e-9,
                                       "a borderline: d lies inside class 3 by 1.5 %, on the limit "
                                       "within the rounding of A and B"));
    } else {
      item.print_text("zone-" + zone.name, "zone " + zone.name + ", class", paper.substr(0, 1),
                      std::to_string(result.track_class));
    }
    if (zone.name != "3" && zone.name != "5" && zone.name != "13") {
      ++applies;
      agrees += printed.at(zone.name, "railroad_class") == paper.substr(0, 1) ? 1 : 0;
    }
    item.add_row({zone.name, fmt::format("{:.2f}", result.random / mm),
                  fmt::format("{:.1f}", result.periodic / mm),
                  fmt::format("{:.1f}", result.deviation / mm), fmt::format("{:.2f}", limit / mm),
                  fmt::format("{:.3f}", 1 - result.margin), std::to_string(result.track_class),
                  paper,
                  fmt::format("{} ({})", printed.at(zone.name, "railroad_class"),
                              printed.at(zone.name, "railroad_kmh"))});
  }
  item.claim("railroad", "where correct data is available, Figure 11 agrees well with the railroad",
             4 * agrees >= 3 * applies,
             fmt::format("{} of the {} zones whose railroad class applied; zones 7 and 8 are one "
                         "class better",
                         agrees, applies));
  const auto& z = all.at(11).track;
  const auto borderline = spectra::classify(z.A, z.B, paper_rule);
  const auto deviation = [](double A, double B) {
    return spectra::design_deviation(A, B, paper_rule) / mm;
  };
  item.value("zone-12-d", borderline.deviation / mm, "mm", "{:.1f}");
  item.value("zone-12-limit", paper_rule.limits[2] / mm, "mm", "{:.2f}");
  item.value("zone-12-margin", 100 * borderline.margin, "%", "{:.1f}");
  item.value("zone-12-low", deviation(z.A - 0.05e-7, z.B - 0.05 * mm), "mm", "{:.1f}");
  item.value("zone-12-high", deviation(z.A + 0.05e-7, z.B + 0.05 * mm), "mm", "{:.1f}");
}

void table_k(report::Item& item) {
  const table::CsvTable readings = item.printed("coefficients.csv");
  const table::CsvTable table_3 = item.printed("table-3.csv");
  const auto all = zones(item.printed("table-1.csv"));
  const double k_19 = spectra::random_coefficient(paper_rule),
               k_62 = spectra::random_coefficient({});
  const auto range = common_range(all, table_3);
  const double middle = 0.5 * (range.low + range.high);
  item.expect_checks(4);
  item.agree("k-19", "k, chord of 19 m", "m", k_19, 9 * variance_by_quadrature(19), 1e-5,
             "quadrature of (8)");
  item.agree("k-62", "k, chord of 62 ft", "m", k_62, 9 * variance_by_quadrature(62 * units::foot),
             1e-5, "quadrature of (8)");
  item.agree("k-low", "smallest k for all classes as printed", "m", range.low,
             end_by_bisection(all, table_3, 1, middle), 1e-9, "bisection on the classes");
  item.agree("k-high", "largest k for all classes as printed", "m", range.high,
             end_by_bisection(all, table_3, 1e4, middle), 1e-9, "bisection on the classes");
  item.columns({"k, m", "reading", "zones as printed", "not as printed"});
  for (std::size_t i = 0; i < readings.rows.size(); ++i) {
    const std::string& key = readings.at(i, "key");
    const double k = key == "derived"     ? k_19
                     : key == "two-sided" ? 2 * k_19
                     : key == "275 pi"    ? 275 * units::pi
                                          : report::printed_number(key);
    std::string others;
    for (const Zone& zone : all)
      if (class_of(zone, with_coefficient(k)) != printed_class(table_3, zone.name))
        others += (others.empty() ? "" : ", ") + zone.name;
    item.add_row({fmt::format("{:.1f}", k), readings.at(i, "what"),
                  std::to_string(zones_as_printed(all, table_3, k)), others});
  }
  item.value("k-19", k_19, "m", "{:.2f}");
  item.value("k-62", k_62, "m", "{:.2f}");
  item.value("k-low", range.low, "m", "{:.0f}");
  item.value("k-high", range.high, "m", "{:.0f}");
  item.added("the coefficient cannot be read in our copy");
}

// A along the curve d = D, for a dip B; negative beyond its end.
double roughness_at(double D, double B) {
  return (D * D - std::pow(paper_rule.gamma * B, 2)) / spectra::random_coefficient(paper_rule);
}

void fig_11(report::Item& item) {
  auto& limits = item.data({"class", "B_mm", "A_m2_cycle_per_m"});
  for (int m = 1; m <= spectra::classes; ++m) {
    const double D = paper_rule.limits[static_cast<std::size_t>(m - 1)], end = D / paper_rule.gamma;
    // Dense towards the end, where the curve falls to zero.
    limits.add(m, 0.4, roughness_at(D, 0.4 * mm));
    for (double s = 1; s > 1e-4; s *= 0.93)
      if (const double B = end * (1 - s); B > 0) limits.add(m, B / mm, roughness_at(D, B));
    for (double A = roughness_at(D, end * (1 - 1e-4)); A > 1e-9; A *= 0.5)
      limits.add(m, end / mm, A);
    limits.gap();
  }
  auto& zone_points = item.data("zones", {"zone", "B_mm", "A_m2_cycle_per_m", "jointed"});
  const table::CsvTable table_1 = item.printed("table-1.csv");
  int jointed_right = 0, welded_left = 0, near = 0, count = 0;
  double jointed_mean = 0, welded_mean = 0;  // of ln(2B/3σ)
  for (const Zone& zone : zones(table_1)) {
    const bool jointed = table_1.at(zone.name, "comment").find("joint") != std::string::npos;
    zone_points.add(zone.name, zone.track.B / mm, zone.track.A, jointed ? 1.0 : 0.0);
    const auto d = spectra::classify(zone.track.A, zone.track.B, paper_rule);
    const double balance = std::log(d.periodic / d.random);
    (jointed ? jointed_mean : welded_mean) += balance;
    near += std::abs(balance) < std::log(2.0) ? 1 : 0;
    ++count;
    jointed_right += jointed && d.periodic > d.random ? 1 : 0;
    welded_left += !jointed && d.periodic < d.random ? 1 : 0;
  }
  item.value("jointed-right", jointed_right, "", "{:.0f}");
  item.value("welded-left", welded_left, "", "{:.0f}");
  item.expect_checks(3);
  item.claim("cluster", "all points tended to cluster near the line of equal A and B behaviour",
             4 * near >= 3 * count,
             fmt::format("in {} of {} zones neither part is twice the other", near, count));
  item.claim("jointed", "jointed sections have on the average more B than A behaviour",
             jointed_mean > 0, fmt::format("{} of 6 lie right of the line", jointed_right));
  item.claim("welded", "the converse is true of welded rail", welded_mean < 0,
             fmt::format("{} of 7 lie left of the line", welded_left));
  auto& equal = item.data("equal", {"B_mm", "A_m2_cycle_per_m"});
  for (double B = 0.2 * mm; B < 60 * mm; B *= 1.1)
    equal.add(B / mm, std::pow(paper_rule.gamma * B, 2) / spectra::random_coefficient(paper_rule));
  auto& labels = item.data("labels", {"class", "B_mm", "A_m2_cycle_per_m"});
  for (int m = 1; m <= spectra::classes; ++m) {
    const double B = (m % 2 == 1 ? 0.56 : 0.72) * mm;  // staggered, so that they stay apart
    labels.add(m, B / mm, roughness_at(paper_rule.limits[static_cast<std::size_t>(m - 1)], B));
  }
  item.rebuilt(
      "points are the printed A and B; the coefficient of A cannot be read and is derived, the "
      "class limits are taken from the standards the paper refers to");
  class_answer(item);
}

}  // namespace

const report::Section classes{
    report::table("table-3", "Classes of the thirteen zones (Table 3)", table_3),
    report::table("table-k", "Readings of the coefficient of A in rule (10)", table_k),
    report::figure(
        "fig-11", "Roughness against joint dip, with the limits of the classes (Fig. 11)", fig_11)};

}  // namespace railbook::psd_chapter
