/*** ## Table 1: thirteen zones

Every zone is condensed to a roughness $A$, a corner $\varphi_c$ and a dip $B$, read off graphs. The paper prints $C_1$, $\beta$ and $B$, so its own
equation (7) can be put to the test. Both factors have two printed digits; the range in the table carries their rounding through (7). Where the printed
$B$ lies outside, the row contradicts itself, and print alone cannot tell which of the three is off.

{{table-1}}

Seven zones do not close. In six of them $B$ is {{table-1-least}} to {{table-1-most}} above what $C_1$ and $\beta$ give, and never
below, as when the peak is read low or narrow off a steep graph. In zone 13
the exponent of $C_1$ is hardly legible. With $10^{-8}$ the peak would be {{table-1-zone-13-share}} of the random part under it and
could not have been seen; the printed $B$ asks for $C_1$ = {{table-1-zone-13-C1}}. From here on $B$ is used as printed. The
corner lies between $\varphi_0$ and $2\varphi_0$ in {{corner-between}} of the thirteen, "usually" as the paper says. But in {{corner-long}} of them
it lies at wavelengths above 6 m, down to which the paper calls (3) "quite satisfactory"; at 6 m (3) is then up to {{six-metres}} too high.
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
    result.push_back({table_1.at(i, "zone"),
                      {.A = number("A"),
                       .phi_c = number("phi_c"),
                       .phi_0 = number("phi_0"),
                       .B = number("B") * mm},
                      number("C_1"),
                      number("beta")});
  }
  return result;
}

namespace {

// The dip a second way: a rectified sine is sampled and transformed, and scaled until its first line, a quarter of its power as in
// (2), is `line_power`.
double dip_by_transform(double line_power) {
  return std::sqrt(4 * line_power / line_power_by_transform(1));
}

double dip_from_peak(double C_1, double beta) {
  return spectra::dip_from_line_power(spectra::broadened_line_power(C_1, beta),
                                      LineConvention::printed);
}

/*** Where the ranges of both sides meet, the printed $B$ must come out within them. Where they do not, the computed $B$ must agree with
a rectified sine that was sampled, transformed and scaled to the power $\beta C_1$, and the printed one must not.
*/
struct Closure {
  double B = 0;              // by (7), m
  double low = 0, high = 0;  // its range from the rounding of C_1 and beta
  bool doubted = false;      // the printed B lies outside
};

Closure check_row(report::Item& item, const table::CsvTable& printed, const Zone& zone) {
  const report::Row row = item.row(printed, zone.name);
  const auto half_digit = [&](const char* column) {
    return report::half_last_digit(row.printed(column));
  };
  Closure c{.B = dip_from_peak(zone.C_1, zone.beta),
            .low = dip_from_peak(zone.C_1 - half_digit("C_1"), zone.beta - half_digit("beta")),
            .high = dip_from_peak(zone.C_1 + half_digit("C_1"), zone.beta + half_digit("beta")),
            .doubted = false};
  const double rounding = half_digit("B") * mm;
  c.doubted = c.low > zone.track.B + rounding || c.high < zone.track.B - rounding;
  if (c.doubted) {
    row.print("B", c.B / mm,
              report::not_confirmed(
                  dip_by_transform(zone.beta * zone.C_1) / mm, (c.high - c.low) / (2 * c.B),
                  "C₁, β and B of the row do not fit (7) within their rounding: "
                  "graph readings; the value is what C₁ and β give by transform"));
  } else {
    row.print("B", c.B / mm,
              report::absolute((std::max(c.high - c.B, c.B - c.low) + rounding) / mm,
                               "rounding of C₁ and β, two digits each, carried through (7)"));
  }
  item.add_row({zone.name, row.printed("A"), row.printed("phi_c"), row.printed("C_1"),
                row.printed("beta"), row.printed("B"), fmt::format("{:.2f}", c.B / mm),
                fmt::format("{:.2f} to {:.2f}", c.low / mm, c.high / mm),
                fmt::format("{:.2f}", zone.track.B / 2 / mm), row.printed("doubt")});
  return c;
}

void table_1(report::Item& item) {
  const table::CsvTable printed = item.printed("table-1.csv");
  const auto all = zones(item);
  item.expect_checks(static_cast<int>(all.size()) + 4);
  item.columns({"zone", "A", "φ<sub>c</sub>", "C₁", "β", "B printed, mm", "B by (7), mm",
                "range of rounding, mm", "physical dip, mm", "doubt"});
  std::vector<double> excess;
  int corner_between = 0, corner_long = 0;
  double lowest_corner = units::no_limit;
  for (const Zone& zone : all) {
    const Closure c = check_row(item, printed, zone);
    if (c.doubted && zone.name != "13") excess.push_back(zone.track.B / c.B - 1.0);
    corner_between +=
        zone.track.phi_c > zone.track.phi_0 && zone.track.phi_c < 2 * zone.track.phi_0;
    corner_long += zone.track.phi_c < 1 / 6.0;
    lowest_corner = std::min(lowest_corner, zone.track.phi_c);
  }
  const auto [least, most] = std::minmax_element(excess.begin(), excess.end());
  item.value("table-1-least", 100 * *least, "%", "{:.0f}");
  item.value("table-1-most", 100 * *most, "%", "{:.0f}");
  item.value("corner-between", corner_between, "", "{:.0f}");
  const double rail_12 = 1 / all.at(11).track.phi_0;
  item.refute("ten-metres", "the section of very rough track is made of 10-m rail", rail_12 < 9.5,
              fmt::format("its φ₀ of Table 1 is that of {:.1f}-m rail", rail_12));
  item.value("zone-12-rail", rail_12, "m", "{:.1f}");
  const Zone& last = all.back();
  item.value("table-1-zone-13-share",
             100 * last.C_1 / spectra::random_psd(last.track, last.track.phi_0), "%", "{:.0f}");
  item.value("table-1-zone-13-C1",
             spectra::line_power(1, last.track.B, LineConvention::printed) / last.beta,
             "m²/(cycle/m)", "{:.2g}");
  const auto by_A = [](const Zone& a, const Zone& b) { return a.track.A < b.track.A; };
  const auto [smooth, rough] = std::minmax_element(all.begin(), all.end(), by_A);
  item.claim("A-range", "A runs from 1e-8 for very smooth to 1e-6 for very rough surfaces",
             smooth->track.A >= 1e-8 && rough->track.A <= 1e-6,
             fmt::format("{:.1e} to {:.1e} m² cycle/m", smooth->track.A, rough->track.A));
  item.claim("corner", "φ_c usually lies between φ₀ and 2φ₀",
             2 * corner_between > static_cast<int>(all.size()),
             fmt::format("in {} of {} zones", corner_between, all.size()));
  const double too_high = std::pow(lowest_corner * 6, -2);  // (3) over (4) at 6 m
  item.refute(
      "six-metres", "(3) is quite satisfactory for wavelengths longer than 6 m",
      2 * corner_long > static_cast<int>(all.size()),
      fmt::format("{} of {} corners of Table 1 lie at longer ones; at 6 m (3) is up to {:.1f} "
                  "times (4)",
                  corner_long, all.size(), too_high));
  item.value("corner-long", corner_long, "", "{:.0f}");
  item.value("six-metres", too_high, "times", "{:.1f}");
}

}  // namespace

const report::Section table_of_zones{
    report::table("table-1", "Thirteen zones: does B follow from C₁ and β? (Table 1)", table_1)};

}  // namespace railbook::psd_chapter
