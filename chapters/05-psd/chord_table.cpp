/*** ### Of the joints

With its middle on a joint, a chord reads the dip as $|\sin(\pi L/2l)|\,B$; figure {{fig-10}} shows why the 62-ft chord loses so much of
it. Everywhere else it reads less, as the brute-force column of Table 2 confirms: the largest offset over all positions.

{{fig-10}}

{{table-2}}

Ten of the twelve entries come out to the printed digits. They are computed in feet; the rounded metres of the table's headings
fail in the row of the 19-m chord, where the sine is steep. **Two entries are misprints**: 0.99 for the 10.4-m chord on 39-ft and on 30-ft
rail, where we find {{table-2-39}} and {{table-2-30}}. No such chord exists. Near 34 ft,
rounding to 0.99 on 39-ft rail takes a half chord of at least {{half-chord-39}} ft, on 30-ft rail one of at most {{half-chord-30}} ft, and 34 ft give 0.98
on either. Nor does any other length help: the sensitivities repeat after a half chord of 390 ft, and of the {{chords-tried}}
tried up to there, {{chords-found}} read 0.99 on both rails.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sections.hpp"
#include "spectra/chord.hpp"
#include "spectra/rail_line.hpp"
#include "units/constants.hpp"

namespace railbook::psd_chapter {

namespace {

// The largest offset over all positions of the chord, by trying them.
double largest_offset(double chord, double rail) {
  double most = 0.0;
  constexpr int positions = 20000;
  for (int i = 0; i < positions; ++i) {
    const double x = rail * i / positions;
    const double ends = spectra::rectified_sine(x - chord / 2, rail, 1.0) +
                        spectra::rectified_sine(x + chord / 2, rail, 1.0);
    most = std::max(most, std::abs(spectra::rectified_sine(x, rail, 1.0) - ends / 2));
  }
  return most;
}

bool prints_as(double sensitivity, double text) {
  return std::abs(sensitivity - text) <= 0.005;
}

/*** The proof of the misprints is a search: the half chords nearest 17 ft that would print as 0.99, and then all half chords up to
390 ft, the least common multiple of both rails.
*/
void prove_misprints(report::Item& item) {
  const double step = 0.001;
  const auto reads_099 = [](double half_ft, double rail_ft) {
    return prints_as(spectra::rail_chord_sensitivity(2 * half_ft, rail_ft), 0.99);
  };
  double up = 17.0;
  while (!reads_099(up, 39.0)) up += step;
  double down = 17.0;
  while (!reads_099(down, 30.0)) down -= step;
  int found = 0;
  const int tried = 390'000;
  for (int i = 1; i <= tried; ++i) found += reads_099(i * step, 39.0) && reads_099(i * step, 30.0);
  item.value("half-chord-39", up, "", "{:.2f}");
  item.value("half-chord-30", down, "", "{:.2f}");
  item.value("chords-tried", tried, "", "{:.0f}");
  item.value("chords-found", found == 0 ? "none" : fmt::format("{}", found));
}

/*** Feet, metres, and the largest offset found by trying: */
void table_2(report::Item& item) {
  const table::CsvTable printed = item.printed("table-2.csv");
  item.expect_checks(static_cast<int>(printed.rows.size()) + 2);
  item.columns({"chord, ft", "rail, ft", "printed", "feet", "printed metres", "brute force, feet"});
  for (std::size_t i = 0; i < printed.rows.size(); ++i) {
    const auto number = [&](const char* column) {
      return report::printed_number(printed.at(i, column));
    };
    const double chord = number("chord_ft") * units::foot;
    const double rail = number("rail_ft") * units::foot;
    const double computed = spectra::rail_chord_sensitivity(chord, rail);
    const double brute_force = largest_offset(chord, rail);
    const double metric = spectra::rail_chord_sensitivity(number("chord_m"), number("rail_m"));
    item.add_row({printed.at(i, "chord_ft"), printed.at(i, "rail_ft"), printed.at(i, "printed"),
                  fmt::format("{:.4f}", computed), fmt::format("{:.4f}", metric),
                  fmt::format("{:.4f}", brute_force)});
    const report::Row row = item.row(printed, printed.at(i, "key"));
    if (printed.at(i, "note") == "misprint") {
      row.print("printed", computed,
                report::corrected(
                    brute_force, 1e-9,
                    "the corrected value is the largest offset found by trying 20000 positions; no "
                    "chord near 34 ft reads 0.99 here, see the text"));
      item.value("table-2-" + printed.at(i, "rail_ft"), computed, "", "{:.3f}");
    } else {
      row.print("printed", computed);
    }
  }
  const auto sees = [](double rail_ft) {
    return 100 * spectra::rail_chord_sensitivity(62.0, rail_ft);
  };
  item.value("sees-39", sees(39), "%", "{:.0f}");
  item.value("sees-30", sees(30), "%", "{:.0f}");
  const auto row_range = [&](double chord_ft) {
    double low = 1, high = 0;
    for (const double rail_ft : {39.0, 36.0, 33.0, 30.0}) {
      const double s = spectra::rail_chord_sensitivity(chord_ft, rail_ft);
      low = std::min(low, s), high = std::max(high, s);
    }
    return std::pair{low, high};
  };
  const auto [short_low, short_high] = row_range(31);
  const auto [long_low, long_high] = row_range(62);
  item.claim("short-chord", "the 9.5-m chord responds well to all frequent rail lengths",
             short_low > 0.9, fmt::format("{:.2f} to {:.2f} of the dip", short_low, short_high));
  item.claim("long-chord", "the response of the 19-m chord is highly variable",
             long_high > 3 * long_low,
             fmt::format("{:.2f} to {:.2f} of the dip", long_low, long_high));
  prove_misprints(item);
}

/*** Figure 10 is drawn from the same numbers: */
// The rectified sine about a joint, and both chords with their middle on it.
void fig_10(report::Item& item) {
  const table::CsvTable printed = item.printed("equations.csv");
  item.expect_checks(2);
  const double rail = 39 * units::foot;
  report::Data& profile = item.data({"x_m", "z_over_B"});
  for (int i = -600; i <= 600; ++i) {
    const double x = 12.0 * i / 600;
    profile.add(x, spectra::rectified_sine(x, rail, 1.0));
  }
  report::Data& ends = item.data("ends", {"x_m", "short", "long"});
  report::Data& offset = item.data("offset", {"x_m", "z_over_B"});
  const double none = units::nan;
  const double short_half = 15.5 * units::foot;
  const double long_half = 31 * units::foot;
  const double short_height = spectra::rectified_sine(short_half, rail, 1.0);
  const double long_height = spectra::rectified_sine(long_half, rail, 1.0);
  for (const double side : {-1.0, 1.0}) ends.add(side * short_half, short_height, none);
  for (const double side : {-1.0, 1.0}) ends.add(side * long_half, none, long_height);
  offset.add(-0.15, short_height);
  offset.add(0.15, long_height);
  item.row(printed, "mco-9.5")
      .print("printed", spectra::rail_chord_sensitivity(2 * short_half, rail));
  item.row(printed, "mco-19")
      .print("printed", spectra::rail_chord_sensitivity(2 * long_half, rail));
}

}  // namespace

const report::Section chord_table{
    report::figure("fig-10", "Rectified sine under 9.5-m and 19-m chords (Fig. 10)", fig_10),
    report::table("table-2", "Chord sensitivity to a rectified sine (Table 2)", table_2)};

}  // namespace railbook::psd_chapter
