/*** ## What a chord sees

The class depends on the mid-chord offset, the height of the rail above the middle of a chord of the
length $L$ = 62 ft (19 m) stretched along it. To go from the spectrum to the class one must know
what the chord reads. For a sine of wavenumber $\varphi$ it reads $1-\cos\pi L\varphi$ times the
amplitude.

### Of the random part

On the random part $A/\varphi^2$ the variance of the offset is
$A\int_0^\infty(1-\cos\pi L\varphi)^2\varphi^{-2}d\varphi$. The integral is $\frac12\pi^2L$, and so
its standard deviation is

$$\sigma(L)=\pi\sqrt{\tfrac12AL}, \tag{8}$$

which is the paper's (8); the ½ under the root is damaged in our copy, and the integral confirms it.
It holds for a one-sided density; with a two-sided $A$ the $\frac12$ would be missing. The paper
leaves the corner out of it, since long chords respond most below $\varphi_c$. With the corner the
integral has a closed form in sine integrals. For the corners of Table 1, (8) is
{{equation-8-least}} to {{equation-8-most}} above it for the 19-m chord, on the safe side, and up to
{{equation-8-short}} for the 9.5-m chord.

::: {.fold summary="What the corner changes, and the probabilities of three sigma"}

{{equation-8}}

The paper's two probabilities for three sigma are truncated, not rounded: 0.99 for a normal offset
(exactly {{normal-share}}) and 0.8 for the worst possible distribution (by Chebyshev's inequality,
{{chebyshev-share}}).

:::
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/classify.hpp>

#include "sections.hpp"

namespace railbook::psd_chapter {

double variance_by_quadrature(double chord) {
  const int periods = 200;
  double variance =
      1.5 * chord / (2.0 * periods);  // the mean 3/2 of the squared gain, for the rest
  for (int i = 0; i < periods; ++i)
    variance += num::integrate(
                    [&](double phi) { return std::pow(spectra::chord_gain(chord, phi) / phi, 2); },
                    i * 2 / chord, (i + 1) * 2 / chord)
                    .value;
  return variance;
}

namespace {

constexpr double long_chord = 62 * units::foot, short_chord = 31 * units::foot;
constexpr double A = 5e-7;  // every ratio below is free of it

double ratio(double phi_c, double chord) {
  return spectra::chord_sigma({.A = A, .phi_c = phi_c}, chord) / spectra::chord_sigma(A, chord);
}

void equation_8(report::Item& item) {
  item.expect_checks(3);
  item.agree("sigma", "(8) for the 62-ft chord", "m", spectra::chord_sigma(A, long_chord),
             std::sqrt(A * variance_by_quadrature(long_chord)), 1e-5, "quadrature");
  item.columns({{"corner φ<sub>c</sub>, cycle/m", "{:.2f}"},
                {"σ/(8), 9.5-m chord", "{:.4f}"},
                {"σ/(8), 19-m chord", "{:.4f}"}});
  for (const double phi_c : {0.10, 0.13, 0.25})
    item.add_row(phi_c, ratio(phi_c, short_chord), ratio(phi_c, long_chord));
  double least = units::infinity, most = 0, short_most = 0;  // how far (8) is too high, %
  int changed = 0;  // zones of another class when the corner is not left out
  for (const Zone& zone : zones(item)) {
    const double phi_c = zone.track.phi_c, high = 100 * (1 / ratio(phi_c, long_chord) - 1);
    least = std::min(least, high);
    most = std::max(most, high);
    short_most = std::max(short_most, 100 * (1 / ratio(phi_c, short_chord) - 1));
    spectra::ClassRule rule{.chord = 19.0};
    const int without = spectra::classify(zone.track.A, zone.track.B, rule).track_class;
    rule.alpha *= ratio(phi_c, rule.chord);
    changed += spectra::classify(zone.track.A, zone.track.B, rule).track_class != without;
  }
  item.value("equation-8-least", least, "%", "{:.1f}");
  item.value("equation-8-most", most, "%", "{:.1f}");
  item.value("equation-8-short", short_most, "%", "{:.0f}");
  item.claims({{"corner-ignored", {least, most, double(changed), short_most}}});
  const table::CsvTable printed = item.printed("equations.csv");
  const auto share = [&](const char* key, double exact) {
    const report::Row row = item.row(printed, key);
    row.print("printed", exact, truncated(row.printed("printed")));
    item.value(fmt::format("{}-share", key), exact, "", "{:.4f}");
  };
  share("normal", 1 - spectra::normal_exceedance(3));
  share("chebyshev", 1 - spectra::chebyshev_exceedance(3));
}

/*** ### Of the joints

With its middle on a joint, a chord reads the dip as $|\sin(\pi L/2l)|\,B$. {{fig-10}} shows why the
62-ft chord loses so much of it: its ends lie in the next dips. Everywhere else it reads less. The
function `largest_offset` tries all positions, and the last column of {{table-2}} confirms this.

{{fig-10}}

{{table-2: checks}}

Ten of the twelve entries come out to the printed digits. They are computed in feet; the rounded
metres of the table's headings fail in the row of the 19-m chord, where the sine is steep. **Two
entries are misprints**: 0.99 for the 10.4-m chord on 39-ft and on 30-ft rail, where it reads
{{table-2-39}} and {{table-2-30}}. The rounding of the chord and of the rail to 0.1 m does not bring
them to 0.99.
*/
// The largest offset over all positions of the chord, by trying them.
double largest_offset(double chord, double length) {
  double most = 0.0;
  constexpr int positions = 20000;
  for (int i = 0; i < positions; ++i) {
    const double x = length * i / positions;
    const double ends = spectra::rectified_sine(x - chord / 2, length, 1.0) +
                        spectra::rectified_sine(x + chord / 2, length, 1.0);
    most = std::max(most, std::abs(spectra::rectified_sine(x, length, 1.0) - ends / 2));
  }
  return most;
}

void table_2(report::Item& item) {
  const table::CsvTable printed = item.printed("table-2.csv");
  item.expect_checks(static_cast<int>(printed.rows.size()));
  item.columns({"chord, ft",
                "rail, ft",
                "printed",
                {"feet", "{:.4f}"},
                {"printed metres", "{:.4f}"},
                {"brute force, feet", "{:.4f}"}});
  for (std::size_t i = 0; i < printed.rows.size(); ++i) {
    const auto number = [&](const char* column) {
      return report::printed_number(printed.at(i, column));
    };
    const double chord = number("chord_ft"), length = number("rail_ft");
    const double computed = spectra::rail_chord_sensitivity(chord, length);
    const double brute_force = largest_offset(chord, length);
    item.add_row(printed.at(i, "chord_ft"), printed.at(i, "rail_ft"), printed.at(i, "printed"),
                 computed, spectra::rail_chord_sensitivity(number("chord_m"), number("rail_m")),
                 brute_force);
    const report::Row row = item.row(printed, printed.at(i, "key"));
    if (printed.at(i, "note") == "misprint") {
      const double chord_m = number("chord_m"), rail_m = number("rail_m");
      report::Trial trial =
          item.trial(printed.at(i, "key") + "-printed", "largest offset over the dip", "{:.3f}",
                     report::misses(row.printed("printed")));
      trial.vary("lengths", [&](const report::Setting& s) {
        return s.text == "feet" ? computed : spectra::rail_chord_sensitivity(chord_m, rail_m);
      });
      trial.vary("chord of 10.4 m", [&](const report::Setting& s) {
        return spectra::rail_chord_sensitivity(s.number, rail_m);
      });
      trial.vary(fmt::format("rail of {} m", printed.at(i, "rail_m")),
                 [&](const report::Setting& s) {
                   return spectra::rail_chord_sensitivity(chord_m, s.number);
                 });
      row.print("printed", computed,
                report::corrected(brute_force, 1e-9,
                                  "the corrected value is the largest offset found by trying 20000 "
                                  "positions",
                                  trial));
      item.value("table-2-" + printed.at(i, "rail_ft"), computed, "", "{:.3f}");
    } else {
      row.print("printed", computed);
    }
  }
  const auto row_range = [&](double chord_ft) {
    std::array<double, 4> of_rails{39, 36, 33, 30};  // ft
    for (double& rail : of_rails) rail = spectra::rail_chord_sensitivity(chord_ft, rail);
    return std::ranges::minmax(of_rails);
  };
  const auto small = row_range(31), large = row_range(62);
  item.claims(
      {{"short-chord", {small.min, small.max}},
       {"long-chord", {large.min, large.max, large.max / large.min, small.max / small.min}}});

  item.value("sees-39", 100 * spectra::rail_chord_sensitivity(62, 39), "%", "{:.0f}");
  item.value("sees-30", 100 * spectra::rail_chord_sensitivity(62, 30), "%", "{:.0f}");
}

// The rectified sine about a joint, and both chords with their middle on it.
void fig_10(report::Item& item) {
  const table::CsvTable printed = item.printed("equations.csv");
  item.expect_checks(2);
  report::Data& profile = item.data({"x_m", "z_over_B"});
  for (int i = -600; i <= 600; ++i)
    profile.add(0.02 * i, spectra::rectified_sine(0.02 * i, rail, 1.0));
  report::Data& ends = item.data("ends", {"x_m", "short", "long"});
  report::Data& offset = item.data("offset", {"x_m", "z_over_B"});
  for (const bool lengthy : {false, true}) {
    const double length = lengthy ? long_chord : short_chord;
    const double height = spectra::rectified_sine(length / 2, rail, 1.0);
    for (const double side : {-0.5, 0.5})
      ends.add(side * length, lengthy ? units::nan : height, lengthy ? height : units::nan);
    offset.add(lengthy ? 0.15 : -0.15, height);
  }
  item.row(printed, "mco-9.5").print("printed", spectra::rail_chord_sensitivity(short_chord, rail));
  item.row(printed, "mco-19").print("printed", spectra::rail_chord_sensitivity(long_chord, rail));
}

}  // namespace

const report::Section chords{
    report::table("equation-8",
                  "Leaving the corner out costs a few per cent on the 19-m chord. Standard "
                  "deviation of the offset with the corner over that by (8).",
                  equation_8),
    report::figure("fig-10",
                   "The long chord has its ends in the next dips and reads less. A rectified sine "
                   "of 39-ft rails under chords of 31 ft (9.5 m) and 62 ft (19 m) with their "
                   "middle on a joint (Fig. 10).",
                   fig_10),
    report::table("table-2",
                  "Ten of the twelve printed sensitivities come out; two are misprints. What a "
                  "chord reads of a joint's dip, as a fraction (Table 2).",
                  table_2)};

}  // namespace railbook::psd_chapter
