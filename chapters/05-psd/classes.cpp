/*** ## Classes

A class is a speed limit. Freight trains may run at 10, 25, 40, 60, 80 and 110 mph on track of
classes 1 to 6; the speeds that the paper prints are those of passenger trains. The federal
standards limit what a 62-ft chord may read on track of class $m$ to $D_m$: 3, 2¾, 2¼, 2, 1¼ and
½ in for classes 1 to 6 (the paper refers to them without printing them).

A spectrum gives a standard deviation and a dip, but a limit is for the largest value. The paper
takes $\alpha=3$ standard deviations for the random part and $\gamma=2$ times the dip for the joints,
and adds the two as squares; with (8) that is a *design deviation* $d$, the offset to expect:

$$(\alpha\sigma)^2+(\gamma B)^2\le D_m(L)^2, \qquad \alpha=3,\ \gamma=2, \tag{9}$$

$$d^2 = kA + 4B^2 \le D_m(19)^2, \qquad k = \tfrac92\pi^2 L. \tag{10}$$

The bracket behind $D_m$ is the length of the chord. The factor $\gamma$ "includes the effect of
chord sensitivity" and of joints that are not equally low. The number $k$ in front of $A$ cannot be
read in our copy. Derived from (8) it is {{k-19}} for a chord of 19 m and {{k-62}} for 62 ft. The
class of a zone is the highest $m$ with $d\le D_m$, which is what `highest_class` computes.

{{code: method.cpp highest_class}}

### Table 3

Does the rule give the classes of the paper's Table 3? {{table-3}} has $d$ from the printed $A$ and
$B$. It also has the range of $d$ when $A$ and $B$ are varied within their rounding, and when $B$ is
taken from $C_1$ and $\beta$ by (7), within theirs (except in zone 13, whose $C_1$ cannot be read).

{{table-3: rows}}

Over these ranges {{table-3-steady}} zones have one class, the printed one. Zone 12 has two. With
the printed $A$ and $B$ its $d$ is {{zone-12-d}} ({{zone-12-low}} to {{zone-12-high}} for half a
unit in their last digits), inside the limit of class 3, {{zone-12-limit}}. With $B$ from the
printed $C_1$ and $\beta$ it is {{zone-12-low-7}} to {{zone-12-high-7}}, on both sides of it. The
printed class, 2, is compatible with the row.

::: {.fold summary="The plus and minus signs of Table 3"}

The plus and minus signs were put by eye. A minus stands at zones 7 and 8, which lie in the lower
half of their class as the paper says, a plus at a zone that is close to the next class (6) or far
inside the last (13). But zone 10, closer to class 5 than zone 6 is to class 6, has no sign. The
text says that zones 3 and 4 were rebuilt after the survey; the table marks 3 and 5.

:::

### Which coefficient did the paper use?

The classes do not tell. Twelve or thirteen of them come out as printed for any $k$ from
{{k-most-low}} to {{k-most-high}}, and all thirteen, with the printed $A$ and $B$, for {{k-low}} <
$k$ ≤ {{k-high}}. These are the readings that we tried:

::: {.fold summary="Readings of the damaged coefficient"}

{{table-k}}

:::

### Figure 11

{{fig-11}}

The [figure at the head of the page](#live-psd) makes a track of any roughness $A$ and dip $B$,
measures a stretch of it, and says which class rule (10) gives it and how sure that is.

Left of the bend of a limit curve $A$ alone sets the class, below the bend $B$ alone. On the dashed
line both parts weigh the same. "All points tended to cluster near the line", says the paper: the
ratio of the two parts, $2B/3\sigma$, lies between {{cluster-low}} and {{cluster-high}} for all
zones, while $d$ itself spans a factor of {{cluster-span}}. A rougher random part goes with deeper
joints: the correlation of $\ln A$ and $\ln B$ is {{correlation}}, or {{correlation-range}} with
zone 12, zone 13 or all welded zones left out. The six welded main lines alone, whose $A$ hardly
differ, show none ({{correlation-welded}}). The paper says that jointed track has, on the average,
more of $B$: this is true of {{jointed-right}} of 6 zones. It says the converse of welded track.
This is true of the mean of $2B/3\sigma$ over the welded zones, {{welded-mean}}, but not of the
median, {{welded-median}}: only {{welded-left}} of 7 zones have more of $A$.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/spectra/classify.hpp>

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

struct Range {
  double low = 0, high = 0;
};

// d with B by (7), A, C_1 and beta at either end of their rounding; and the same with the printed A and B.
Range deviation_by_7(const Zone& zone) {
  return {
      spectra::design_deviation(zone.track.A - zone.A_half, dip_by_7(zone, Rounding::down),
                                rule_10),
      spectra::design_deviation(zone.track.A + zone.A_half, dip_by_7(zone, Rounding::up), rule_10)};
}

Range deviation_printed(const Zone& zone) {
  return {
      spectra::design_deviation(zone.track.A - zone.A_half, zone.track.B - zone.B_half, rule_10),
      spectra::design_deviation(zone.track.A + zone.A_half, zone.track.B + zone.B_half, rule_10)};
}

Range deviations(const Zone& zone) {
  const Range printed = deviation_printed(zone);
  if (!zone.peak_legible) return printed;
  const Range by_7 = deviation_by_7(zone);
  return {std::min(printed.low, by_7.low), std::max(printed.high, by_7.high)};
}

int class_of_deviation(double d) {
  return spectra::classify(0, d / rule_10.gamma, rule_10).track_class;
}

void table_3(report::Item& item) {
  const table::CsvTable printed = item.printed("table-3.csv");
  const auto all = zones(item);
  item.expect_checks(static_cast<int>(all.size()));
  int applies = 0, agrees = 0, most_off = 0, in_class_5 = 0, steady = 0;
  item.columns({"zone",
                {"3σ, mm", "{:.2f}"},
                {"2B, mm", "{:.1f}"},
                {"d, mm", "{:.1f}"},
                "d within the roundings, mm",
                {"class limit, mm", "{:.2f}"},
                {"class", "{:.0f}"},
                "class within the roundings",
                "class printed",
                "railroad's class (km/h)"});
  for (const Zone& zone : all) {
    const auto result = spectra::classify(zone.track.A, zone.track.B, rule_10);
    const std::string& paper = printed.at(zone.name, "class");
    const Range d = deviations(zone);
    const int best = class_of_deviation(d.low), worst = class_of_deviation(d.high);
    steady += best == worst;
    if (best != worst) {
      const Range as_printed = deviation_printed(zone), by_7 = deviation_by_7(zone);
      item.consistent(
          "zone-" + zone.name, fmt::format("zone {} is in class {}", zone.name, paper),
          std::to_string(worst) == paper,
          fmt::format("d is {:.1f} to {:.1f} mm with the printed B and {:.1f} to {:.1f} mm with B "
                      "from C₁ and β; class {} ends at {:.2f} mm",
                      as_printed.low / mm, as_printed.high / mm, by_7.low / mm, by_7.high / mm,
                      best, rule_10.limits[static_cast<std::size_t>(best - 1)] / mm),
          "the rounding of the row's own numbers reaches both classes");
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
                 fmt::format("{:.1f} to {:.1f}", d.low / mm, d.high / mm),
                 result.deviation / (1 - result.margin) / mm, double(result.track_class),
                 best == worst ? std::to_string(best) : fmt::format("{} or {}", worst, best), paper,
                 fmt::format("{} ({})", printed.at(zone.name, "railroad_class"),
                             printed.at(zone.name, "railroad_kmh")));
  }

  const double middle = 0.5 * (rule_10.limits[4] + rule_10.limits[5]);
  const auto deviation = [](double A, double B) {
    return spectra::design_deviation(A, B, rule_10);
  };
  const double d_7 = deviation(all.at(6).track.A, all.at(6).track.B),
               d_8 = deviation(all.at(7).track.A, all.at(7).track.B);

  item.claims(
      {{"railroad", {double(agrees), double(applies), double(most_off), double(agrees) / applies}},
       {"lower-range",
        {d_7 / mm, d_8 / mm, rule_10.limits[5] / mm, rule_10.limits[4] / mm,
         std::min(d_7, d_8) - middle}},
       {"most-5", {double(in_class_5)}}});
  const Zone& zone_12 = all.at(11);
  item.value("table-3-steady", steady, "", "{:.0f}");
  item.value("zone-12-d", deviation(zone_12.track.A, zone_12.track.B) / mm, "mm", "{:.1f}");
  item.value("zone-12-limit", rule_10.limits[2] / mm, "mm", "{:.2f}");
  item.value("zone-12-low", deviation_printed(zone_12).low / mm, "", "{:.1f}");
  item.value("zone-12-high", deviation_printed(zone_12).high / mm, "mm", "{:.1f}");
  item.value("zone-12-low-7", deviation_by_7(zone_12).low / mm, "", "{:.1f}");
  item.value("zone-12-high-7", deviation_by_7(zone_12).high / mm, "mm", "{:.1f}");
}

// The range of k about `k` in which at least `enough` zones have their printed class. How many have it changes only
// at the limits that one zone's class sets, and those are known in closed form.
Range coefficients(const std::vector<Zone>& all, const table::CsvTable& table_3, double k,
                   int enough) {
  const auto of = [&](const Zone& zone) {
    return spectra::coefficient_range(zone.track.A, zone.track.B, printed_class(table_3, zone.name),
                                      rule_10);
  };
  std::vector<double> limits{0};
  for (const Zone& zone : all)
    for (const double limit : {of(zone).low, of(zone).high})
      if (limit > 0 && std::isfinite(limit)) limits.push_back(limit);
  std::sort(limits.begin(), limits.end());
  const auto as_printed = [&](double low, double high) {
    return std::count_if(all.begin(), all.end(), [&](const Zone& zone) {
      return of(zone).low <= low && high <= of(zone).high;
    });
  };
  Range found{k, k};
  for (std::size_t i = 1; i < limits.size(); ++i)
    if (limits[i] >= found.high && limits[i - 1] <= found.high &&
        as_printed(limits[i - 1], limits[i]) >= enough)
      found.high = limits[i];
  for (std::size_t i = limits.size() - 1; i > 0; --i)
    if (limits[i - 1] <= found.low && limits[i] >= found.low &&
        as_printed(limits[i - 1], limits[i]) >= enough)
      found.low = limits[i - 1];
  return found;
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
  // All thirteen printed classes.
  spectra::CoefficientRange range{0, units::infinity};
  for (const Zone& zone : all) {
    const auto of = spectra::coefficient_range(zone.track.A, zone.track.B,
                                               printed_class(table_3, zone.name), rule_10);
    range = {std::max(range.low, of.low), std::min(range.high, of.high)};
  }
  const Range most = coefficients(all, table_3, k_19, 12);
  item.value("k-19", k_19, "m", "{:.1f}");
  item.value("k-62", spectra::random_coefficient({}), "m", "{:.1f}");
  item.value("k-low", range.low, "m", "{:.0f}");
  item.value("k-high", range.high, "m", "{:.0f}");
  item.value("k-most-low", most.low, "", "{:.0f}");
  item.value("k-most-high", most.high, "m", "{:.0f}");
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

bool is_jointed(const table::CsvTable& table_1, const Zone& zone) {
  return table_1.at(zone.name, "comment").find("joint") != std::string::npos;
}

// Of ln A and ln B.
double correlation_of(const std::vector<Zone>& some) {
  const auto n = static_cast<Eigen::Index>(some.size());
  Eigen::ArrayXd a(n), b(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    a[i] = std::log(some[static_cast<std::size_t>(i)].track.A);
    b[i] = std::log(some[static_cast<std::size_t>(i)].track.B);
  }
  a -= a.mean();
  b -= b.mean();
  return (a * b).sum() / std::sqrt(a.square().sum() * b.square().sum());
}

void fig_11(report::Item& item) {
  item.rebuilt(
      "points are the printed A and B; the coefficient of A cannot be read and is derived, the "
      "class limits are taken from the standards the paper refers to");
  limit_curves(item);
  auto& zone_points = item.data("zones", {"zone", "B_mm", "A_m2_cycle_per_m", "jointed"});
  const table::CsvTable table_1 = item.printed("table-1.csv");
  const auto all = zones(item);
  double ratio_low = units::infinity, ratio_high = 0, d_low = units::infinity, d_high = 0;
  int jointed_right = 0, welded_left = 0;
  std::vector<double> welded_ratios;
  for (const Zone& zone : all) {
    const bool jointed = is_jointed(table_1, zone);
    zone_points.add(zone.name, zone.track.B / mm, zone.track.A, jointed ? 1.0 : 0.0);
    const auto d = spectra::classify(zone.track.A, zone.track.B, rule_10);
    jointed_right += jointed && d.periodic > d.random;
    welded_left += !jointed && d.periodic < d.random;
    if (!jointed) welded_ratios.push_back(d.periodic / d.random);
    ratio_low = std::min(ratio_low, d.periodic / d.random);
    ratio_high = std::max(ratio_high, d.periodic / d.random);
    d_low = std::min(d_low, d.deviation);
    d_high = std::max(d_high, d.deviation);
  }

  report::Trial together = item.trial("together", "correlation of ln A and ln B", "{:.2f}",
                                      [](double correlation) { return correlation > 0.5; });
  together.vary("zones", [&](const report::Setting& s) {
    std::vector<Zone> chosen;
    for (const Zone& zone : all) {
      if (s.text == "without zone 13" && zone.name == "13") continue;
      if (s.text == "without zone 12" && zone.name == "12") continue;
      if (s.text == "jointed" && !is_jointed(table_1, zone)) continue;
      chosen.push_back(zone);
    }
    return correlation_of(chosen);
  });
  const double correlation = correlation_of(all);

  // The mean of ln(2B/3σ) over the zones of one kind, as a ratio.
  const auto mean_ratio = [&](bool jointed, bool by_7 = false) {
    double sum = 0;
    int n = 0;
    for (const Zone& zone : all) {
      if (is_jointed(table_1, zone) != jointed) continue;
      const double B = by_7 && zone.peak_legible ? dip_by_7(zone) : zone.track.B;
      const auto d = spectra::classify(zone.track.A, B, rule_10);
      sum += std::log(d.periodic / d.random);
      ++n;
    }
    return std::exp(sum / n);
  };
  report::Trial of_jointed =
      item.trial("jointed", "mean of 2B/3σ", "{:.2f}", [](double ratio) { return ratio > 1; });
  of_jointed.vary("B",
                  [&](const report::Setting& s) { return mean_ratio(true, s.text == "by (7)"); });

  std::ranges::sort(welded_ratios);
  const double welded_mean = mean_ratio(false), median = welded_ratios[welded_ratios.size() / 2];
  item.claims(
      {{"cluster", {ratio_low, ratio_high, d_high / d_low}},
       {"together", {correlation}, together},
       {"jointed", {mean_ratio(true), double(jointed_right)}, of_jointed},
       {"welded", {welded_mean, median, double(welded_left), double(welded_ratios.size())}}});
  item.value("welded-mean", welded_mean, "", "{:.2f}");
  item.value("welded-median", median, "", "{:.2f}");
  item.value("correlation", correlation, "", "{:.2f}");
  item.value("correlation-range", together.range());
  item.value("correlation-welded", correlation_of({all.begin(), all.begin() + 6}), "", "{:.1f}");
  item.value("cluster-low", ratio_low, "", "{:.2f}");
  item.value("cluster-high", ratio_high, "", "{:.2f}");
  item.value("cluster-span", d_high / d_low, "", "{:.0f}");
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
}

}  // namespace

const report::Section classes{
    report::table(
        "table-3",
        "Twelve of thirteen printed classes come out within all roundings. Parts of the design "
        "deviation, its range within the rounding of the printed numbers, and the class (Table 3).",
        table_3),
    report::table("table-k",
                  "The classes do not tell the coefficient k. Readings of the damaged number in "
                  "(10), and how many printed classes each gives.",
                  table_k),
    report::figure(
        "fig-11",
        "Rough track has deep joints. Each zone by its dip B and roughness A, with the limits of "
        "the classes by (10): a zone has the class of the first curve above it. On the dashed line "
        "roughness and joints contribute the same to the offset (Fig. 11).",
        fig_11)};

}  // namespace railbook::psd_chapter
