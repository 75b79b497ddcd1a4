/*** ## Classes

A class is a speed limit. Freight trains may run at 10, 25, 40, 60, 80 and 110 mph on track of
classes 1 to 6; the speeds that the paper prints are those of passenger trains. The federal
standards limit what a 62-ft chord may read on track of class $m$ to $D_m$: 3, 2¾, 2¼, 2, 1¼ and
½ in for classes 1 to 6 (the paper refers to them without printing them).

A spectrum gives a standard deviation and a dip, but a limit is for the largest value. The paper
takes $\alpha=3$ standard deviations for the random part and $\gamma=2$ times the dip for the
joints, and adds the two as squares; with (8) that is a *design deviation* $d$, the offset to
expect:

$$(\alpha\sigma)^2+(\gamma B)^2\le D_m(L)^2, \qquad \alpha=3,\ \gamma=2, \tag{9}$$

$$d^2 = kA + 4B^2 \le D_m(19)^2, \qquad k = \tfrac92\pi^2 L. \tag{10}$$

The length of the chord (m) stands in brackets behind $D_m$. The factor $\gamma$ "includes the
effect of chord sensitivity" and of joints that are not equally low; it multiplies the printed $B$,
so it counts the physical dip four times. The number $k$ in front of $A$ cannot be read in our copy.
Derived from (8) it is {{k-19}} for a chord of 19 m and {{k-62}} for 62 ft. The class of a zone is
the highest $m$ with $d\le D_m$, which is what `highest_class` computes.

{{code: method.cpp highest_class}}

### Table 3

Does the rule give the classes of the paper's Table 3? {{table-3}} has $d$ from the printed $A$ and
$B$. It also has the range of $d$ when $A$ and $B$ are varied within their rounding, and when $B$ is
taken from $C_1$ and $\beta$ by (7), within theirs (except in zone 13, whose $C_1$ cannot be read).

{{table-3: rows}}

Over these ranges {{table-3-steady}} zones keep one class, the printed one. Zone 12 has two. With
the printed $A$ and $B$ its $d$ is {{zone-12-d}} ({{zone-12-low}} to {{zone-12-high}} for half a
unit in their last digits), inside the limit of class 3, {{zone-12-limit}}. With $B$ from the
printed $C_1$ and $\beta$ it is {{zone-12-low-7}} to {{zone-12-high-7}}, on both sides of it. The
printed class, 2, is compatible with the row. If the broad peaks of zones 2, 10, 11 and 12 are
resonance curves, (6) makes their $B$ too small; with the larger $B$, {{resonance-changed}} would
change class.

::: {.fold summary="The plus and minus signs of Table 3"}

The plus and minus signs were put by eye. A minus stands at zones 7 and 8, which lie in the lower
half of their class as the paper says, a plus at a zone that is close to the next class (6) or far
inside the last (13). But zone 10, closer to class 5 (relative to the limit) than zone 6 is to class
6, has no sign. The text says that zones 3 and 4 were rebuilt after the survey; the table marks 3
and 5.

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

The [figure at the head of the page](#live-psd) makes synthetic track of any roughness $A$ and dip
$B$, measures a stretch of it, and says which class rule (10) gives it and how sure that is.

On the flat part of a limit curve the roughness alone decides the class, on the steep part the dip
alone. On the dashed line both parts weigh the same. "All points tended to cluster near the line",
says the paper: the ratio of the two parts, $2B/3\sigma$, lies between {{cluster-low}} and
{{cluster-high}} for all zones, while $d$ itself spans a factor of {{cluster-span}}. A rougher
random part goes with deeper joints: the correlation of $\ln A$ and $\ln B$ is {{correlation}}, or
{{correlation-range}} with zone 12, zone 13 or all welded zones left out. The six welded main lines
alone, whose $A$ hardly differ, show none ({{correlation-welded}}). The paper says that jointed
track has, on the average, more of $B$: this is true of {{jointed-right}} of 6 zones. It says the
converse of welded track. This is true of the geometric mean of $2B/3\sigma$ over the welded zones,
{{welded-mean}}, but without zone 13, whose $B$ is doubtful, the mean is {{welded-but-13}}, and the
median is {{welded-median}}: only {{welded-left}} of 7 zones have more of $A$.
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

// d with B by (7), A, C_1 and beta at either end of their rounding; and the same with the printed A
// and B.
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

// A zone by rule (10): the class, and the classes at either end of the roundings.
struct Classified {
  spectra::Classification by_rule;
  Range d, d_printed, d_by_7;
  int best = 0, worst = 0;
  bool steady() const { return best == worst; }
};

Classified classified(const Zone& zone) {
  const Range d = deviations(zone);
  return {.by_rule = spectra::classify(zone.track.A, zone.track.B, rule_10),
          .d = d,
          .d_printed = deviation_printed(zone),
          .d_by_7 = deviation_by_7(zone),
          .best = class_of_deviation(d.low),
          .worst = class_of_deviation(d.high)};
}

double limit_of_class(int m) {
  return rule_10.limits[static_cast<std::size_t>(m - 1)];
}

// The paper's classes against those of the railroad, where these applied at the survey by Table 3,
// and how many agree if the text's zones 3 and 4 are left out.
struct Agreement {
  int zones = 0, same = 0, most_off = 0, off_13 = 0, same_by_text = 0;
};

Agreement with_railroad(const table::CsvTable& table_3) {
  Agreement found;
  for (std::size_t i = 0; i < table_3.rows.size(); ++i) {
    const std::string& zone = table_3.at(i, "zone");
    const int off = table_3.at(i, "railroad_class")[0] - table_3.at(i, "class")[0];
    if (zone == "13") found.off_13 = std::abs(off);
    found.same_by_text += off == 0 && zone != "3" && zone != "4" && zone != "13";
    if (!table_3.at(i, "comment").empty()) continue;
    ++found.zones;
    found.same += off == 0;
    found.most_off = std::max(found.most_off, std::abs(off));
  }
  return found;
}

// The zones of another class with another dip in rule (10), as "zones 1 and 2".
template <class Dip>
std::string changed_zones(const std::vector<Zone>& all, const Dip& dip) {
  std::vector<std::string> names;
  for (const Zone& zone : all)
    if (class_by(zone, rule_10) != spectra::classify(zone.track.A, dip(zone), rule_10).track_class)
      names.push_back(fmt::format("{} (to class {})", zone.name,
                                  spectra::classify(zone.track.A, dip(zone), rule_10).track_class));
  if (names.empty()) return "no zone";
  if (names.size() == 1) return "zone " + names[0];
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("zones {} and {}", fmt::join(names, ", "), last);
}

void check_class(report::Item& item, const Zone& zone, const Classified& c,
                 const std::string& paper) {
  if (c.steady())
    return item.print_text("zone-" + zone.name, "zone " + zone.name + ", class", paper.substr(0, 1),
                           std::to_string(c.by_rule.track_class));
  item.consistent(
      "zone-" + zone.name, fmt::format("zone {} is in class {}", zone.name, paper),
      std::to_string(c.worst) == paper,
      fmt::format("d is {:.1f} to {:.1f} mm with the printed B and {:.1f} to {:.1f} mm with B "
                  "from C₁ and β; class {} ends at {:.2f} mm",
                  c.d_printed.low / mm, c.d_printed.high / mm, c.d_by_7.low / mm,
                  c.d_by_7.high / mm, c.best, limit_of_class(c.best) / mm),
      "the rounding of the row's own numbers reaches both classes");
}

void table_3(report::Item& item) {
  const table::CsvTable printed = item.printed("table-3.csv");
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
  std::vector<Classified> all;
  for (const Zone& zone : zones(item)) {
    const Classified& c = all.emplace_back(classified(zone));
    const std::string& paper = printed.at(zone.name, "class");
    check_class(item, zone, c, paper);
    item.add_row(
        zone.name, c.by_rule.random / mm, c.by_rule.periodic / mm, c.by_rule.deviation / mm,
        fmt::format("{:.1f} to {:.1f}", c.d.low / mm, c.d.high / mm),
        c.by_rule.deviation / (1 - c.by_rule.margin) / mm, double(c.by_rule.track_class),
        c.steady() ? std::to_string(c.best) : fmt::format("{} or {}", c.worst, c.best), paper,
        fmt::format("{} ({})", printed.at(zone.name, "railroad_class"),
                    printed.at(zone.name, "railroad_kmh")));
  }
  item.expect_checks(static_cast<int>(all.size()));
  const Agreement railroad = with_railroad(printed);
  const Classified& zone_12 = all.at(11);
  const double d_7 = all.at(6).by_rule.deviation, d_8 = all.at(7).by_rule.deviation,
               from = limit_of_class(6), to = limit_of_class(5);
  item.claims({{"railroad",
                {double(railroad.same), double(railroad.zones), double(railroad.most_off),
                 double(railroad.same) / railroad.zones, double(railroad.off_13),
                 double(railroad.same_by_text)}},
               {"lower-range",
                {d_7 / mm, d_8 / mm, from / mm, to / mm, std::min(d_7, d_8) - (from + to) / 2}},
               {"most-5", {double(std::ranges::count(all, 5, [](const Classified& c) {
                  return c.by_rule.track_class;
                }))}}});
  item.value("table-3-steady", double(std::ranges::count_if(all, &Classified::steady)), "",
             "{:.0f}");
  item.value("physical-changed",
             changed_zones(zones(item), [](const Zone& zone) { return zone.track.B / 2; }));
  item.value("resonance-changed", changed_zones(zones(item), [](const Zone& zone) {
               return zone.track.B * (zone.beta > 0.03 ? std::sqrt(units::pi / 2) : 1);
             }));
  item.value("zone-12-limit", limit_of_class(3) / mm, "mm", "{:.2f}");
  report::values(item, "", "{:.1f}", "zone-12-low", zone_12.d_printed.low / mm, "zone-12-low-7",
                 zone_12.d_by_7.low / mm);
  report::values(item, "mm", "{:.1f}", "zone-12-d", zone_12.by_rule.deviation / mm, "zone-12-high",
                 zone_12.d_printed.high / mm, "zone-12-high-7", zone_12.d_by_7.high / mm);
}

// The range of k about `k` in which at least `enough` zones have their printed class. How many have
// it changes only at the limits that one zone's class sets, and those are known in closed form.
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

// The k at which all zones have their printed class.
spectra::CoefficientRange all_as_printed(const std::vector<Zone>& all,
                                         const table::CsvTable& table_3) {
  spectra::CoefficientRange range{0, units::infinity};
  for (const Zone& zone : all) {
    const auto of = spectra::coefficient_range(zone.track.A, zone.track.B,
                                               printed_class(table_3, zone.name), rule_10);
    range = {std::max(range.low, of.low), std::min(range.high, of.high)};
  }
  return range;
}

// The names of the zones that a coefficient gives another class than the printed one.
std::vector<std::string> not_as_printed(const std::vector<Zone>& all,
                                        const table::CsvTable& table_3, double k) {
  std::vector<std::string> others;
  for (const Zone& zone : all)
    if (class_by(zone, with_coefficient(k)) != printed_class(table_3, zone.name))
      others.push_back(zone.name);
  return others;
}

void table_k(report::Item& item) {
  item.added("the coefficient cannot be read in our copy");
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
    const auto others = not_as_printed(all, table_3, k);
    item.add_row(k, readings.at(i, "what"), double(all.size() - others.size()),
                 fmt::format("{}", fmt::join(others, ", ")));
  }
  const auto range = all_as_printed(all, table_3);
  const Range most = coefficients(all, table_3, k_19, 12);
  report::values(item, "m", "{:.1f}", "k-19", k_19, "k-62", spectra::random_coefficient({}));
  report::values(item, "m", "{:.0f}", "k-low", range.low, "k-high", range.high, "k-most-high",
                 most.high);
  item.value("k-most-low", most.low, "", "{:.0f}");
}

// A along the curve d = D, for a dip B; negative beyond its end.
double roughness_at(double D, double B) {
  return (D * D - std::pow(rule_10.gamma * B, 2)) / spectra::random_coefficient(rule_10);
}

void add_limit_curves(report::Data& limits) {
  for (int m = 1; m <= spectra::classes; ++m) {
    const double D = limit_of_class(m), end = D / rule_10.gamma;
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

// The two parts of d against each other, 2B/3σ.
struct Balance {
  std::vector<double> jointed, welded;
  double low = units::infinity, high = 0;
  double d_low = units::infinity, d_high = 0;
};

Balance balance_of(const std::vector<Zone>& all, const table::CsvTable& table_1,
                   bool B_by_7 = false) {
  Balance found;
  for (const Zone& zone : all) {
    const double B = B_by_7 && zone.peak_legible ? dip_by_7(zone) : zone.track.B;
    const auto d = spectra::classify(zone.track.A, B, rule_10);
    const double ratio = d.periodic / d.random;
    (is_jointed(table_1, zone) ? found.jointed : found.welded).push_back(ratio);
    found.low = std::min(found.low, ratio);
    found.high = std::max(found.high, ratio);
    found.d_low = std::min(found.d_low, d.deviation);
    found.d_high = std::max(found.d_high, d.deviation);
  }
  std::ranges::sort(found.welded);
  return found;
}

// The mean of the logarithms, as a ratio.
double mean_ratio(const std::vector<double>& ratios) {
  double sum = 0;
  for (const double ratio : ratios) sum += std::log(ratio);
  return std::exp(sum / static_cast<double>(ratios.size()));
}

// All zones, or those that a setting of the trial names.
std::vector<Zone> chosen_zones(const std::vector<Zone>& all, const table::CsvTable& table_1,
                               const std::string& which) {
  std::vector<Zone> chosen;
  for (const Zone& zone : all)
    if (which != "without zone " + zone.name && (which != "jointed" || is_jointed(table_1, zone)))
      chosen.push_back(zone);
  return chosen;
}

void draw_zones(report::Item& item, const std::vector<Zone>& all, const table::CsvTable& table_1) {
  add_limit_curves(item.data({"class", "B_mm", "A_m2_cycle_per_m"}));
  auto& points = item.data("zones", {"zone", "B_mm", "A_m2_cycle_per_m", "jointed"});
  for (const Zone& zone : all)
    points.add(zone.name, zone.track.B / mm, zone.track.A, is_jointed(table_1, zone) ? 1.0 : 0.0);
  auto& equal = item.data("equal", {"B_mm", "A_m2_cycle_per_m"});
  for (double B = 0.2 * mm; B < 60 * mm; B *= 1.1)
    equal.add(B / mm, std::pow(rule_10.gamma * B, 2) / spectra::random_coefficient(rule_10));
  auto& labels = item.data("labels", {"class", "B_mm", "A_m2_cycle_per_m"});
  for (int m = 1; m <= spectra::classes; ++m)  // at the foot of each limit
    labels.add(m, limit_of_class(m) / rule_10.gamma / mm, 1.1e-8);
}

void fig_11(report::Item& item) {
  item.rebuilt(
      "points are the printed A and B; the coefficient of A cannot be read and is derived, the "
      "class limits are taken from the standards the paper refers to");
  const table::CsvTable table_1 = item.printed("table-1.csv");
  const auto all = zones(item);
  draw_zones(item, all, table_1);
  const Balance balance = balance_of(all, table_1);
  const auto above_1 = std::ranges::count_if(balance.jointed, [](double r) { return r > 1; });
  const auto below_1 = std::ranges::count_if(balance.welded, [](double r) { return r < 1; });
  const double welded_mean = mean_ratio(balance.welded), correlation = correlation_of(all),
               median = balance.welded[balance.welded.size() / 2],
               welded_correlation = correlation_of({all.begin(), all.begin() + 6});
  report::Trial together =
      item.trial("together", "correlation of ln A and ln B, jointed zones included", "{:.2f}",
                 [](double found) { return found > 0.5; });
  together.vary("zones", [&](const report::Setting& s) {
    return correlation_of(chosen_zones(all, table_1, s.text));
  });
  report::Trial of_jointed = item.trial("jointed", "geometric mean of 2B/3σ", "{:.2f}",
                                        [](double ratio) { return ratio > 1; });
  of_jointed.vary("B", [&](const report::Setting& s) {
    return mean_ratio(balance_of(all, table_1, s.text == "by (7)").jointed);
  });
  item.claims({{"cluster", {balance.low, balance.high, balance.d_high / balance.d_low}},
               {"together", {correlation, welded_correlation}, together},
               {"jointed", {mean_ratio(balance.jointed), double(above_1)}, of_jointed},
               {"welded", {welded_mean, median, double(below_1), double(balance.welded.size())}}});
  report::values(item, "", "{:.2f}", "welded-mean", welded_mean, "welded-median", median,
                 "welded-but-13", mean_ratio({balance.welded.begin() + 1, balance.welded.end()}),
                 "correlation", correlation, "cluster-low", balance.low, "cluster-high",
                 balance.high);
  item.value("correlation-range", together.range());
  item.value("correlation-welded", welded_correlation, "", "{:.1f}");
  report::values(item, "", "{:.0f}", "cluster-span", balance.d_high / balance.d_low,
                 "jointed-right", double(above_1), "welded-left", double(below_1));
}

}  // namespace

const report::Section classes{report::table("table-3", table_3), report::table("table-k", table_k),
                              report::figure("fig-11", fig_11)};

}  // namespace railbook::psd_chapter
