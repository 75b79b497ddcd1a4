/*** ## Table 1: thirteen zones

By what the table calls graphical analysis, the paper condenses every zone to a roughness $A$, a
corner $\varphi_c$ and a dip $B$. It also prints $C_1$ and $\beta$, so that its own equation (7) can
be put to the test: does $B$ follow from them? $C_1$ and $\beta$ are printed with two digits, and
{{table-1}} gives the range of $B$ that their rounding allows. Nothing in the paper tests the other
columns; we use them as printed.

{{table-1: rows}}

{{ends-half}} of the 13 printed $B$ end in .0 or .5 mm. If every last digit were equally likely,
this would happen in one of {{ends-half-chance}} tables, so the authors seem to have rounded $B$
often to half a millimetre. With this rounding the dips of zones 7 and 11 fit (7). Four zones do
not: in zones 1, 3, 6 and 8 (7) gives {{table-1-least}} to {{table-1-most}} less than the printed
$B$. The print cannot tell which of the three numbers is off, and the verdict rests on the digits as
our copy has them. The last column but one gives the $C_1$ that the printed $B$ would need.

Zone 13 is not tested, because the exponent of its $C_1$ can hardly be read. If it is $10^{-8}$, the
peak would be {{table-1-zone-13-share}} of the random part under it and could not have been seen;
the printed $B$ needs $C_1$ = {{table-1-zone-13-C1}}. From here on $B$ is used as printed.

The corner lies between $\varphi_0$ and $2\varphi_0$ in {{corner-between}} of the thirteen zones,
"usually" as the paper says. The paper calls (3) "quite satisfactory for wavelengths longer than 6
m" and goes on: "Somewhere in this range, there is a transition to a faster rate of roll-off". In
{{corner-long}} zones the corner lies at waves longer than 6 m. At 6 m (3) is then too high, by a
factor of {{six-metres-median}} in the median of the zones and of {{six-metres}} at the most.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sections.hpp"

namespace railbook::psd_chapter {

std::vector<Zone> zones(const report::Item& item) {
  const table::CsvTable table_1 = item.printed("table-1.csv");
  std::vector<Zone> result;
  for (std::size_t i = 0; i < table_1.rows.size(); ++i) {
    const auto number = [&](const char* column) {
      return report::printed_number(table_1.at(i, column));
    };
    const auto half_digit = [&](const char* column) {
      return report::half_last_digit(table_1.at(i, column));
    };
    result.push_back({.name = table_1.at(i, "zone"),
                      .track = {.A = number("A"),
                                .phi_c = number("phi_c"),
                                .phi_0 = number("phi_0"),
                                .B = number("B") * mm},
                      .C_1 = number("C_1"),
                      .beta = number("beta"),
                      .C_1_half = half_digit("C_1"),
                      .beta_half = half_digit("beta"),
                      .A_half = half_digit("A"),
                      .B_half = half_digit("B") * mm,
                      .peak_legible = table_1.at(i, "zone") != "13"});
  }
  return result;
}

double dip_by_7(const Zone& zone, Rounding rounding) {
  const double way = rounding == Rounding::up ? 1 : rounding == Rounding::down ? -1 : 0;
  return spectra::dip_from_line_power(
      spectra::broadened_line_power(zone.C_1 + way * zone.C_1_half,
                                    zone.beta + way * zone.beta_half),
      LineConvention::printed);
}

namespace {

bool ends_in_half(const std::string& number) {
  return number.ends_with(".0") || number.ends_with(".5");
}

// What the printed B may be off from the one before rounding, so that it can come from (7): half a
// unit of its last digit, a quarter of a millimetre if it ends in .0 or .5; NaN if neither will do.
double rounding_of_B(const Zone& zone, const std::string& printed_B) {
  const auto fits = [&](double half) {
    return dip_by_7(zone, Rounding::down) <= zone.track.B + half &&
           dip_by_7(zone, Rounding::up) >= zone.track.B - half;
  };
  if (fits(zone.B_half)) return zone.B_half;
  return ends_in_half(printed_B) && fits(0.25 * mm) ? 0.25 * mm : units::nan;
}

// How `check_row` judges a row: where the ranges of both sides meet, B by (7) must come out within
// them. Where they do not, the gap between them is what is tried: it must stay open for either
// rounding of C_1 and beta, and for a coarser rounding of B.
void check_row(report::Item& item, const report::Row& row, const Zone& zone) {
  const double computed = dip_by_7(zone), half = rounding_of_B(zone, row.printed("B"));
  const double spread =
      std::max(dip_by_7(zone, Rounding::up) - computed, computed - dip_by_7(zone, Rounding::down));
  if (std::isfinite(half))
    return row.print("B", computed / mm,
                     report::absolute((spread + half) / mm,
                                      half == zone.B_half
                                          ? "rounding of C₁ and β, two digits each, carried "
                                            "through (7)"
                                          : "rounding of C₁ and β carried through (7), and of B to "
                                            "half a millimetre: the print ends in .0 or .5"));
  report::Trial trial =
      item.trial(zone.name + "-B", "gap between the printed B, less its rounding, and (7)",
                 "{:.2f} mm", [](double gap) { return gap > 0; });
  trial.vary("rounding of C₁ and β", [&](const report::Setting& s) {
    const auto rounding = s.text == "down" ? Rounding::down
                          : s.text == "up" ? Rounding::up
                                           : Rounding::none;
    return (zone.track.B - zone.B_half - dip_by_7(zone, rounding)) / mm;
  });
  trial.vary("rounding of B, with C₁ and β rounded up", [&](const report::Setting& s) {
    return (zone.track.B - dip_by_7(zone, Rounding::up)) / mm - s.number / 2;
  });
  row.print(
      "B", computed / mm,
      report::not_confirmed("C₁, β and B of the row do not fit (7) within their rounding", trial));
}

// The chance that at least `least` of `n` happen, each with the chance p.
double chance_of_at_least(int least, int n, double p) {
  double sum = 0;
  for (int k = least; k <= n; ++k)
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0)) *
           std::pow(p, k) * std::pow(1 - p, n - k);
  return sum;
}

// What the table says as a whole.
struct Survey {
  std::vector<double> excess;         // of B over (7), of B, where no rounding explains it, rising
  std::vector<double> at_six_metres;  // (3) over (4) at a wave of 6 m, rising
  int corner_between = 0, corner_long = 0, ends_half = 0;  // zones
};

Survey survey_of(const std::vector<Zone>& all, const table::CsvTable& table_1) {
  Survey found;
  for (const Zone& zone : all) {
    const std::string& B = table_1.at(zone.name, "B");
    const spectra::TrackParameters& track = zone.track;
    if (zone.peak_legible && !std::isfinite(rounding_of_B(zone, B)))
      found.excess.push_back(1 - dip_by_7(zone) / track.B);
    found.ends_half += ends_in_half(B);
    found.corner_between += track.phi_c > track.phi_0 && track.phi_c < 2 * track.phi_0;
    found.corner_long += track.phi_c < 1 / 6.0;
    found.at_six_metres.push_back(spectra::random_psd({.A = track.A}, 1 / 6.0) /
                                  spectra::random_psd(track, 1 / 6.0));
  }
  std::ranges::sort(found.excess);
  std::ranges::sort(found.at_six_metres);
  return found;
}

// The height of a peak of the printed width from which the printed B follows by (7).
double C_1_of_B(const Zone& zone) {
  return spectra::line_power(1, zone.track.B, LineConvention::printed) / zone.beta;
}

void table_1(report::Item& item) {
  const table::CsvTable printed = item.printed("table-1.csv");
  const auto all = zones(item);
  item.expect_checks(static_cast<int>(all.size()) - 1);
  item.columns({"zone", "A, m²·cycle/m", "φ<sub>c</sub>, cycle/m", "C₁, m²/(cycle/m)", "β, cycle/m",
                "B printed, mm", "B by (7), mm", "range of rounding, mm",
                "C₁ for the printed B, m²/(cycle/m)", "doubt"});
  for (const Zone& zone : all) {
    const report::Row row = item.row(printed, zone.name);
    if (zone.peak_legible) check_row(item, row, zone);
    item.add_row({zone.name, row.printed("A"), row.printed("phi_c"), row.printed("C_1"),
                  row.printed("beta"), row.printed("B"), fmt::format("{:.2f}", dip_by_7(zone) / mm),
                  fmt::format("{:.2f} to {:.2f}", dip_by_7(zone, Rounding::down) / mm,
                              dip_by_7(zone, Rounding::up) / mm),

                  fmt::format("{:.1e}", C_1_of_B(zone)), row.printed("doubt")});
  }
  const Survey survey = survey_of(all, printed);
  const auto [smooth, rough] =
      std::ranges::minmax(all, {}, [](const Zone& zone) { return zone.track.A; });
  const double median = survey.at_six_metres[survey.at_six_metres.size() / 2];
  item.claims({{"A-range", {smooth.track.A, rough.track.A}},
               {"corner", {double(survey.corner_between), double(all.size())}},
               {"six-metres", {median, survey.at_six_metres.back()}}});
  item.value("table-1-least", 100 * survey.excess.front(), "", "{:.1f}");
  item.value("table-1-most", 100 * survey.excess.back(), "%", "{:.1f}");
  report::values(item, "", "{:.0f}", "corner-between", survey.corner_between, "corner-long",
                 survey.corner_long, "ends-half", survey.ends_half, "ends-half-chance",
                 1 / chance_of_at_least(survey.ends_half, 13, 0.2));
  report::values(item, "", "{:.1f}", "six-metres-median", median, "six-metres",
                 survey.at_six_metres.back());
  const double rail_12 = 1 / all.at(11).track.phi_0;
  item.value("zone-12-rail",
             fmt::format("{:.0f}-ft rail ({:.1f} m)", rail_12 / units::foot, rail_12));
  const Zone& last = all.back();
  item.value("table-1-zone-13-share",
             100 * last.C_1 / spectra::random_psd(last.track, last.track.phi_0), "%", "{:.0f}");
  item.value("table-1-zone-13-C1", C_1_of_B(last), "m²/(cycle/m)", "{:.2g}");
}

}  // namespace

const report::Section table_of_zones{report::table("table-1", table_1)};

}  // namespace railbook::psd_chapter
