/* ## Classify your own track

    psd synthesize track.csv --length 20km --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m --dip 11mm
    psd classify track.csv --column profile --rail 39ft --out mine

reads a profile record and answers with $A$, $\varphi_c$ and $B$, their standard errors, the class, and the odds of each
class. A column's unit is the end of its header (`profile_mm`) or given with `--unit mm`; positions come from a column
`distance`, or even spacing is promised with `--spacing 1ft`. If the record is a mid-chord offset, say which: `--chord 62ft`; old rails
of another length under the present ones are named with `--foreign 33ft`. A file of any length streams through the memory of one
segment.

Empty cells and `nan` are gaps. They cost the segments that hold them, unless `--bridge 5` joins short ones by a straight line. Positions that
do not ascend evenly, a missing column or unit, a constant signal, a record shorter than a segment, a chord longer than an eighth of
one and a chord that is blind to the rail are refused. What is doubtful without being wrong is said in a note: a line not
significant, a corner out of sight, a noise floor that cannot be fitted, residuals beyond chance, a sensor that stuck, a roughness no
track has (a wrong unit?).
*/
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "spectra/classify.hpp"
#include "spectra/line_mask.hpp"
#include "spectra/record.hpp"
#include "table/csv.hpp"
#include "tool/out_folder.hpp"
#include "tool/summary.hpp"
#include "tools.hpp"
#include "units/constants.hpp"

namespace railbook::psd_tool {

namespace {

constexpr double mm = units::millimetre;
constexpr std::size_t long_still = 100;  // equal samples in a row that no rounding explains

struct Wish {
  std::filesystem::path file;
  std::string column = "profile", distance = "distance", unit, window = "hann", noise = "automatic",
              slopes = "two";
  std::optional<double> spacing, chord;
  long segment = 4096, bridge = 0;
  spectra::FitOptions fit;
  tool::Destination out;
};

void add_options(tool::Options& o, Wish& w) {
  o.file("record", w.file, "CSV file with a column of heights");
  o.required();
  o.text("--column", w.column, "name of that column, with or without its unit");
  o.text("--unit", w.unit, "unit of the column, if its header names none");
  o.text("--distance", w.distance, "column of positions along the track");
  o.quantity("--spacing", w.spacing, units::length, "distance between samples", tool::positive);
  o.quantity("--chord", w.chord, units::length, "the column is the mid-chord offset of this chord",
             tool::positive);
  o.quantity("--rail", w.fit.rail_length, units::length, "rail length", tool::positive);
  o.quantities("--foreign", w.fit.foreign_lengths, units::length, "lengths of former rails",
               tool::positive);
  o.count("--segment", w.segment, "samples a segment, even", 64, 1 << 24);
  o.count("--bridge", w.bridge, "longest gap, in samples, to bridge by a straight line", 0, 1000);
  o.choice("--window", w.window, {"hann", "hamming", "blackman-harris", "dpss", "boxcar"},
           "window");
  o.choice("--noise", w.noise, {"automatic", "none", "fitted"}, "white noise floor of the sensor");
  o.choice("--slopes", w.slopes, {"two", "one"}, "of the random part: equation (4) or (3)");
  o.quantity("--low", w.fit.low, units::wavenumber, "lower end of the band fitted", tool::positive);
  o.quantity("--high", w.fit.high, units::wavenumber, "upper end of the band fitted",
             tool::positive);
  o.out(w.out);
}

// What one cell of the column is in metres.
double unit_of(const Wish& wish, const std::string& header) {
  const units::Header named = units::parse_header(header);
  if (wish.unit.empty() && named.unit_text.empty())
    throw InputError{
        fmt::format("column \"{}\" names no unit; give one with --unit, such as mm", header)};
  const units::Unit unit = wish.unit.empty() ? named.unit : units::parse_unit(wish.unit);
  if (!(unit.dimension == units::length))
    throw InputError{fmt::format("column \"{}\" has the unit {}; allowed: a length, such as mm",
                                 header, wish.unit.empty() ? named.unit_text : wish.unit)};
  if (!wish.unit.empty() && !named.unit_text.empty() && unit.si != named.unit.si)
    throw InputError{fmt::format("column \"{}\" is in {} by its header, in {} by --unit", header,
                                 named.unit_text, wish.unit)};
  return unit.si;
}

// The column of positions, if the file has it; it must be there when no spacing is given.
std::optional<std::size_t> position_column(const table::CsvReader& reader, const Wish& wish) {
  for (std::size_t i = 0; i < reader.header().size(); ++i)
    if (reader.header()[i] == wish.distance ||
        units::parse_header(reader.header()[i]).name == wish.distance)
      return i;
  if (!wish.spacing)
    throw InputError{
        fmt::format("file \"{}\": no column \"{}\"; there are: {}; allowed: a column "
                    "of positions (--distance) or --spacing, such as 1ft",
                    reader.file().string(), wish.distance, fmt::join(reader.header(), ", "))};
  return std::nullopt;
}

struct Measured {
  spectra::Spectrum spectrum;
  std::size_t samples, missing, bridged, still;
  double spacing;
};

// The spectrum is taken at unit spacing while the record streams by; its true spacing is known at the end.
Measured measure(const Wish& wish) {
  table::CsvReader reader{wish.file};
  const std::size_t column = reader.column(wish.column);
  const double unit = unit_of(wish, reader.header()[column]);
  const auto positions = position_column(reader, wish);
  double metre = 1;
  if (positions) {
    const units::Header header = units::parse_header(reader.header()[*positions]);
    if (!(header.unit.dimension == units::length))
      throw InputError{fmt::format("column \"{}\" names no length; allowed: a header such as {}_m",
                                   reader.header()[*positions], wish.distance)};
    metre = header.unit.si;
  }
  const auto segment = static_cast<std::size_t>(wish.segment);
  spectra::Welch welch{1.0, {.segment = segment, .window = spectra::parse_window(wish.window)}};
  spectra::RecordStream record{
      {.spacing = wish.spacing, .bridge = static_cast<std::size_t>(wish.bridge)},
      [&](std::span<const double> piece) { welch.push(piece); }};
  std::vector<std::string> cells;
  while (reader.next(cells)) {
    const double value = reader.number(cells, column) * unit;
    if (positions)
      record.add(reader.number(cells, *positions) * metre, value);
    else
      record.add(value);
  }
  record.finish();
  if (welch.segments() == 0)
    throw InputError{
        fmt::format("the record has {} samples, {} of them missing; allowed: {} in a row "
                    "without a gap (--segment for shorter ones, --bridge for gaps)",
                    record.samples(), record.missing(), wish.segment)};
  return {spectra::respaced(welch.spectrum(), record.spacing()),
          record.samples(),
          record.missing(),
          record.bridged(),
          record.still(),
          record.spacing()};
}

spectra::FitOptions fit_options(const Wish& wish) {
  spectra::FitOptions options = wish.fit;
  options.chord = wish.chord.value_or(0.0);
  options.noise = wish.noise == "none"     ? spectra::NoiseModel::none
                  : wish.noise == "fitted" ? spectra::NoiseModel::fitted
                                           : spectra::NoiseModel::automatic;
  options.slopes = wish.slopes == "one" ? spectra::Slopes::one : spectra::Slopes::two;
  return options;
}

void add_notes(tool::Summary& s, const Measured& m, const spectra::FitOptions& options,
               const spectra::SpectrumFit& fit) {
  const auto note = [&](const char* key, const std::string& text) { s.add(key, "note", text); };
  if (!fit.line_significant)
    note("line_note",
         fmt::format("no significant line: without joints 1 record in 20 shows B > {:.2f} mm",
                     fit.B_threshold / mm));
  if (fit.corner == spectra::CornerState::at_low_bound)
    note("corner_note",
         fmt::format("corner below {:.3g} cycle/m: A is a lower bound, only A phi_c^2 = "
                     "{:.3g} m^2 (cycle/m)^3 is known; class too good",
                     fit.phi_c.value, fit.steep.value));
  if (fit.corner == spectra::CornerState::at_high_bound)
    note("corner_note",
         fmt::format("no corner below {:.3g} cycle/m: one slope of -2 fitted", fit.phi_c.value));
  if (!fit.converged) note("noise_note", "a noise floor was asked for, but none could be fitted");
  if (fit.misfit > 1.25)
    note("misfit_note", fmt::format("residuals {:.2f} times those of chance: lines not named "
                                    "(--foreign), noise (--noise), or another shape of spectrum",
                                    fit.misfit));
  if (const auto stray = spectra::stray_line(m.spectrum, options, fit))
    note("stray_note",
         fmt::format("a line at {:.4g} cycle/m ({:.4g} m) belongs to no rail named: former "
                     "rails (--foreign), a wheel, or another rail length (--rail)?",
                     stray->phi, 1 / stray->phi));
  if (m.still >= long_still)
    note("still_note", fmt::format("{} samples in a row are equal: a sensor that stuck?", m.still));
  if (m.spectrum.segments < 4)
    note("length_note", fmt::format("only {} segment(s) averaged: a longer record is needed",
                                    m.spectrum.segments));
  if (!(fit.A.value > 1e-10 && fit.A.value < 1e-4))
    note("unit_note", "no track has such a roughness (1e-8 to 1e-6 is usual): is the unit right?");
}

tool::Summary answer(const Wish& wish, const Measured& m, const spectra::SpectrumFit& fit) {
  const spectra::ClassRule rule;
  const auto result = spectra::classify(fit.A.value, fit.B_printed.value, rule);
  const auto odds = spectra::class_probabilities(fit, rule);
  tool::Summary s{"track of " + wish.file.string()};
  const auto with_error = [&](const std::string& key, const char* what, spectra::Estimate e,
                              double unit, const char* unit_name, const char* note = "") {
    s.add(key, what, e.value / unit, unit_name, note);
    s.add(key + "_error", "  its standard error", e.error / unit, unit_name);
  };
  s.add("length_km", "length", static_cast<double>(m.samples) * m.spacing / units::kilometre, "km",
        fmt::format("{} samples, {} missing, {} bridged", m.samples, m.missing, m.bridged));
  s.add("spacing_m", "spacing", m.spacing, "m");
  s.add("segments", "segments averaged", static_cast<double>(m.spectrum.segments), "",
        fmt::format("{} dropped", m.spectrum.dropped));
  with_error("A", "roughness A", fit.A, 1, "m^2 cycle/m");
  if (fit.corner == spectra::CornerState::fitted)
    with_error("phi_c", "corner phi_c", fit.phi_c, 1, "cycle/m");
  if (fit.noise.value > 0) with_error("noise", "noise floor", fit.noise, 1, "m^2/(cycle/m)");
  with_error("B_printed_mm", "joint dip B, printed convention", fit.B_printed, mm, "mm",
             "as in Table 1");
  with_error("B_exact_mm", "joint dip, physical", fit.B_exact, mm, "mm");
  s.add("C_1", "peak of the line C_1", fit.C_1, "m^2/(cycle/m)");
  s.add("beta", "its width Q_1/C_1", fit.beta, "cycle/m");
  s.add("deviation_mm", "deviation d expected of a 62-ft chord", result.deviation / mm, "mm",
        fmt::format("random {:.1f}, joints {:.1f}", result.random / mm, result.periodic / mm));
  s.add("class", "class", static_cast<double>(result.track_class), "",
        result.track_class > 0 ? fmt::format("margin {:.1f} %", 100 * result.margin)
                               : std::string{"not even class 1"});
  for (int i = 1; i <= spectra::classes; ++i) {
    const auto at = static_cast<std::size_t>(i);
    s.add(fmt::format("limit_{}_mm", i), fmt::format("  limit of class {}", i),
          rule.limits[at - 1] / mm, "mm",
          fmt::format("d is {:.0f} % of it", 100 * result.deviation / rule.limits[at - 1]));
    s.add(fmt::format("odds_{}", i), fmt::format("  odds of class {}", i),
          1e-4 * std::round(1e4 * odds[at]), "");
  }
  add_notes(s, m, fit_options(wish), fit);
  return s;
}

void write_files(tool::OutFolder& out, const Wish& wish, const Measured& m,
                 const spectra::SpectrumFit& fit, const tool::Summary& summary) {
  std::string text = "phi_cycle_per_m,S_m2_per_cycle_per_m,fitted,A_line\n";
  for (Eigen::Index k = 1; k < m.spectrum.density.size(); ++k) {
    const double phi = m.spectrum.frequency(k);
    const double gain = spectra::squared_gain(wish.chord.value_or(0), phi);
    if (gain < wish.fit.least_gain) {  // left out, as in the fit: an empty line breaks the curve
      if (!text.ends_with("\n\n")) text += "\n";
      continue;
    }
    text +=
        fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}\n", phi, m.spectrum.density[k] / gain,
                    std::exp(fit.regression.log_density(std::log(phi))), fit.A.value / (phi * phi));
  }
  out.add("spectrum.csv", text);
  const spectra::ClassRule rule;
  std::string limits = "class,B_mm,A_m2_cycle_per_m\n";
  for (int i = 1; i <= spectra::classes; ++i) {
    const double D = rule.limits[static_cast<std::size_t>(i - 1)];
    for (int j = 0; j < 200; ++j) {
      const double share = std::sin(0.5 * units::pi * j / 200.0);  // 2B/D
      limits += fmt::format("{},{:.6g},{:.6g}\n", i, share * D / rule.gamma / mm,
                            D * D * (1 - share * share) / spectra::random_coefficient(rule));
    }
    limits += "\n";
  }
  out.add("classes.csv", limits);
  out.add("point.csv", fmt::format("B_mm,B_error_mm,A_m2_cycle_per_m,A_error\n{},{},{},{}\n",
                                   fit.B_printed.value / mm, fit.B_printed.error / mm, fit.A.value,
                                   fit.A.error));
  out.add("classify.json", summary.json());
  out.figure(tools::scripts("psd") / "classify_spectrum.gp", {"spectrum.csv"}, "spectrum.png");
  out.figure(tools::scripts("psd") / "classify_class.gp", {"classes.csv", "point.csv"},
             "class.png");
}

void classify_track(const Wish& wish) {
  tool::OutFolder out(wish.out, {"spectrum.csv", "classes.csv", "point.csv", "classify.json",
                                 "spectrum.png", "class.png"});
  const Measured measured = measure(wish);
  const auto fit = spectra::fit_track_spectrum(measured.spectrum, fit_options(wish));
  const tool::Summary summary = answer(wish, measured, fit);
  summary.print();
  if (out) write_files(out, wish, measured, fit, summary);
  out.commit();
}

}  // namespace

tool::Tool classify_tool() {
  return {"classify", "A, corner, dip and class of a track record", [](tool::Options& o) {
            auto wish = std::make_shared<Wish>();
            add_options(o, *wish);
            return [wish] { classify_track(*wish); };
          }};
}

}  // namespace railbook::psd_tool
