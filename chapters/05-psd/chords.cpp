/*** ## What a chord sees

The class depends on the mid-chord offset, the distance between the rail and the middle of a chord
of the length $L$ = 62 ft (19 m) stretched along it. To go from the spectrum to the class one must
know what the chord reads. For a sine of wavenumber $\varphi$ it reads $1-\cos\pi L\varphi$ times
the amplitude.

### Of the random part

On the random part $A/\varphi^2$ the variance of the offset is $A\int_0^\infty(1-\cos\pi
L\varphi)^2\varphi^{-2}d\varphi$. The integral is $\frac12\pi^2L$, and so its standard deviation is

$$\sigma(L)=\pi\sqrt{\tfrac12AL}. \tag{8}$$

This is the paper's (8), but for the ½ under the root, which our copy shows as a %. For a one-sided
density the integral makes it ½; for a two-sided one nothing would stand there. That a sign stands
there is why we take the paper's densities as one-sided.

The paper leaves the corner out, since long chords respond most below $\varphi_c$. With the corner
the integral has a closed form in sine integrals. For the corners of Table 1, (8) is above it, on
the safe side: by {{equation-8-least}} to {{equation-8-most}} for the 19-m chord and by up to
{{equation-8-ten}} for one of 10 m, the shortest that the paper means.

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
#include <utility>

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

// By how much (8) is too high in the zones, %, because it leaves the corner out, and how many of
// them are of another class without it.
struct CornerLeftOut {
  double least = units::infinity, most = 0, ten_most = 0;
  int changed = 0;
};

CornerLeftOut corner_left_out(const std::vector<Zone>& all) {
  CornerLeftOut found;
  for (const Zone& zone : all) {
    const double phi_c = zone.track.phi_c, high = 100 * (1 / ratio(phi_c, long_chord) - 1);
    found.least = std::min(found.least, high);
    found.most = std::max(found.most, high);
    found.ten_most = std::max(found.ten_most, 100 * (1 / ratio(phi_c, 10) - 1));
    spectra::ClassRule rule{.chord = 19.0};
    const int without = spectra::classify(zone.track.A, zone.track.B, rule).track_class;
    rule.alpha *= ratio(phi_c, rule.chord);
    found.changed += spectra::classify(zone.track.A, zone.track.B, rule).track_class != without;
  }
  return found;
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
  const CornerLeftOut high = corner_left_out(zones(item));
  report::values(item, "%", "{:.1f}", "equation-8-least", high.least, "equation-8-most", high.most);
  item.value("equation-8-ten", high.ten_most, "%", "{:.0f}");
  item.claims({{"corner-ignored", {high.least, high.most, double(high.changed), high.ten_most}}});
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

With its middle on a joint, a chord reads the dip as $|\sin(\pi L/2l)|\,b$. {{fig-10}} shows why the
62-ft chord reads so little of it: its ends lie on the slopes towards the next joints. Everywhere
else the chord reads less. The last column of {{table-2}}, for which all positions were tried,
confirms this.

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

// Row i of Table 2: the lengths as printed, and the sensitivity from those in feet.
struct Sensitivity {
  double chord_ft, rail_ft, chord_m, rail_m;
  double by_feet() const { return spectra::rail_chord_sensitivity(chord_ft, rail_ft); }
  double by_metres() const { return spectra::rail_chord_sensitivity(chord_m, rail_m); }
};

Sensitivity sensitivity(const table::CsvTable& table_2, std::size_t i) {
  const auto number = [&](const char* column) {
    return report::printed_number(table_2.at(i, column));
  };
  return {number("chord_ft"), number("rail_ft"), number("chord_m"), number("rail_m")};
}

// The least and the largest sensitivity of a chord over the four lengths of rail.
std::pair<double, double> sensitivities(double chord_ft) {
  std::array<double, 4> of_rails{39, 36, 33, 30};  // ft
  for (double& rail : of_rails) rail = spectra::rail_chord_sensitivity(chord_ft, rail);
  const auto [least, most] = std::ranges::minmax(of_rails);
  return {least, most};
}

// A misprint: no rounding of the lengths brings the sensitivity to the printed one.
void correct(report::Item& item, const report::Row& row, const std::string& key,
             const Sensitivity& s) {
  report::Trial trial = item.trial(key + "-printed", "largest offset over the dip", "{:.3f}",
                                   report::misses(row.printed("printed")));
  trial.vary("lengths", [&](const report::Setting& setting) {
    return setting.text == "feet" ? s.by_feet() : s.by_metres();
  });
  trial.vary("chord of 10.4 m", [&](const report::Setting& setting) {
    return spectra::rail_chord_sensitivity(setting.number, s.rail_m);
  });
  trial.vary("rail of " + row.printed("rail_m") + " m", [&](const report::Setting& setting) {
    return spectra::rail_chord_sensitivity(s.chord_m, setting.number);
  });
  row.print("printed", s.by_feet(),
            report::corrected(largest_offset(s.chord_ft, s.rail_ft), 1e-9,
                              "the corrected value is the largest offset found by trying 20000 "
                              "positions",
                              trial));
  item.value("table-2-" + row.printed("rail_ft"), s.by_feet(), "", "{:.3f}");
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
    const Sensitivity s = sensitivity(printed, i);
    item.add_row(printed.at(i, "chord_ft"), printed.at(i, "rail_ft"), printed.at(i, "printed"),
                 s.by_feet(), s.by_metres(), largest_offset(s.chord_ft, s.rail_ft));
    const std::string& key = printed.at(i, "key");
    if (printed.at(i, "note") == "misprint")
      correct(item, item.row(printed, key), key, s);
    else
      item.row(printed, key).print("printed", s.by_feet());
  }
  const auto [short_least, short_most] = sensitivities(31);
  const auto [long_least, long_most] = sensitivities(62);
  item.claims(
      {{"short-chord", {short_least, short_most}},
       {"long-chord", {long_least, long_most, long_most / long_least, short_most / short_least}}});
  report::values(item, "%", "{:.0f}", "sees-39", 100 * long_most, "sees-30", 100 * long_least);
  // The rule counts four times the physical dip.
  item.value("safe-39", 4 / long_most, "", "{:.1f}");
  item.value("safe-30", 4 / long_least, "", "{:.0f}");
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

const report::Section chords{report::table("equation-8", equation_8),
                             report::figure("fig-10", fig_10), report::table("table-2", table_2)};

}  // namespace railbook::psd_chapter
