/* ## Classify your own track

    psd synthesize track.csv --length 20km --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m --dip 11mm
    psd classify track.csv --column profile --rail 39ft --out mine

reads a profile record and answers with $A$, $\varphi_c$ and $B$, their standard errors, the class, and the odds of each
class. A column's unit is the end of its header (`profile_mm`) or given with `--unit mm`; positions come from a column
`distance`, or even spacing is promised with `--spacing 1ft`. If the record is a mid-chord offset, say which: `--chord 62ft`; old rails
of another length under the present ones are named with `--foreign 33ft`. A file of any length streams through the memory of one
segment.

Empty cells and `nan` are gaps; those of up to 1 m are bridged by a straight line (`--bridge` says otherwise), after longer ones the segments begin anew, and the last
one before a gap ends at it; they are made shorter until 95 % of the samples are in one. A segment is about 1250 m long unless `--segment` says how many samples.

Positions that do not ascend evenly, a missing column or unit, a constant signal, a record shorter than a segment, a chord longer than an eighth of
one and a chord that is blind to the rail are refused, and a record shorter than a rail, unless `--no-rail` says that the track has no joints. Codes for lost samples and heights that no track can have are taken out. Outliers, a
sensor that stuck and a step of the datum may be defects: they are kept unless `--screen` names them, and named in warnings above the answer; so are a spacing that changes, heights that are in another unit than said, a line of another rail length (used instead of the default
39 ft; one given with `--rail` is kept), and residuals beyond chance. From twice the residuals of chance on no class is pronounced: the record is filtered, or of another shape than the model's.
*/
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <railbook/spectra/classify.hpp>
#include <railbook/spectra/line_mask.hpp>
#include <railbook/spectra/record_spectrum.hpp>
#include <railbook/spectra/reference_spectra.hpp>
#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/batch.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "psd/references.hpp"
#include "record_options.hpp"
#include "tools.hpp"

namespace railbook::psd_tool {

namespace {

constexpr double mm = units::millimetre;
constexpr double misfit_warned = 1.25, misfit_refused = 2;  // times the residuals of chance
constexpr double usual_scatter = 0.2;                       // of the dips of joints

struct Options {
  tools::TrackRecordOptions record;
  std::string window = "hann", noise = "automatic", slopes = "two";
  std::optional<double> chord, rail, segment;
  bool no_rail = false;
  spectra::FitOptions fit;
  std::vector<std::string> references;
  tool::Destination out;
};

void add_options(tool::OptionParser& o, Options& w) {
  tools::add_record_options(o, w.record);
  o.quantity("--chord", w.chord, units::length, "the column is the mid-chord offset of this chord",
             {0.1, 1e6});
  o.quantity("--rail", w.rail, units::length,
             "rail length; left out: 39 ft, or what the spectrum shows", {0.1, 1e3});
  o.flag("--no-rail", w.no_rail,
         "track without joints: no line of a rail is looked for, and B is 0");
  o.quantities("--foreign", w.fit.foreign_lengths, units::length, "lengths of former rails",
               {0.1, 1e3});
  o.quantity("--segment", w.segment, units::number,
             "samples a segment, even; left out: about 1250 m", {64, 1 << 18});
  o.choice("--window", w.window, {"hann", "hamming", "blackman-harris", "dpss", "boxcar"},
           "window");
  o.choice("--noise", w.noise, {"automatic", "none", "fitted"}, "white noise floor of the sensor");
  o.choice("--slopes", w.slopes, {"two", "one"}, "of the random part: equation (4) or (3)");
  o.quantity("--low", w.fit.low, units::wavenumber, "lower end of the band fitted", {1e-6, 1e4});
  o.quantity("--high", w.fit.high, units::wavenumber, "upper end of the band fitted", {1e-6, 1e4});
  o.texts("--reference", w.references,
          "spectra to draw behind, and to compare with: german-low, fra-5, hamid-yang-5, china-hsr "
          "...");
  o.quantity("--section", w.record.section, units::length,
             "a row for each such stretch as well, as 1km", {1, 1e6});
  o.out(w.out);
  o.help(
      std::string{tools::record_help} +
      "\n\nspectrum.csv holds the one-sided density of the heights over wavenumber in cycles per "
      "metre (of a chord's record,\n"
      "of the profile behind it), the fit, and its line A/phi^2. classes.csv has, for each class, "
      "the dips B and roughness A\n"
      "at which its limit of the 62-ft chord is reached; point.csv the record's own with standard "
      "errors. B is positive: the\n"
      "depth of a joint below the middle of the rail. odds are probabilities, 0 to 1. A table of "
      "several columns or records\n"
      "has a row for each, and for each --section; its last column lists the warnings."
      "\n\nColumns of spectrum.csv: phi_cycle_per_m, S_m2_per_cycle_per_m, fitted and A_line; of "
      "classes.csv and point.csv: B_mm and\n"
      "A_m2_cycle_per_m with their standard errors B_error_mm and A_error; of warnings.csv: "
      "column, "
      "warning, position in m,\n"
      "size and text."
      "\n\nExample: railbook psd classify track.csv --column profile --out mine\n"
      "         railbook psd classify runs/*.csv --column left,right --section 1km "
      "--out mine");
}

spectra::FitOptions fit_options(const Options& options) {
  spectra::FitOptions adjusted = options.fit;
  if (options.rail && options.no_rail) throw InputError{"give one of rail and no-rail"};
  if (options.rail) adjusted.rail_length = *options.rail;
  if (options.no_rail) adjusted.rail_length = units::infinity;
  adjusted.chord = options.chord.value_or(0.0);
  adjusted.noise = options.noise == "none"     ? spectra::NoiseModel::none
                   : options.noise == "fitted" ? spectra::NoiseModel::fitted
                                               : spectra::NoiseModel::automatic;
  adjusted.slopes = options.slopes == "one" ? spectra::Slopes::one : spectra::Slopes::two;
  return adjusted;
}

struct Fitted {
  spectra::FitOptions fit_options;
  spectra::SpectrumFit fit;
  std::optional<double> contradicting;  // rail length
};

// A rail length that nobody gave is read from the spectrum where that contradicts the default.
Fitted fit_track(const Options& options, const spectra::Spectrum& spectrum) {
  Fitted f{fit_options(options), {}, {}};
  f.fit = spectra::fit_track_spectrum(spectrum, f.fit_options);
  f.contradicting = spectra::contradicting_rail(spectrum, f.fit_options, f.fit);
  if (f.contradicting && !options.rail) {
    f.fit_options.rail_length = *f.contradicting;
    f.fit = spectra::fit_track_spectrum(spectrum, f.fit_options);
  }
  return f;
}

void add_warnings(tool::Summary& s, const Options& options, const spectra::RecordSpectrum& m,
                  const Fitted& f) {
  const auto& [fit_options, fit, contradicting] = f;
  if (contradicting && !options.rail)
    s.warn("rail",
           fmt::format("the spectrum shows rails of {:.4g} m, not the default of 39 ft: taken "
                       "instead; say which with --rail",
                       *contradicting));
  else if (contradicting)
    s.warn("rail", fmt::format("the spectrum shows rails of {:.4g} m, not of {:.4g} m: see --rail",
                               *contradicting, *options.rail));
  else if (const auto stray = spectra::stray_line(m.spectrum, fit_options, fit))
    s.warn("stray_line",
           fmt::format("a line at {:.4g} cycle/m ({:.4g} m) belongs to no rail named: former "
                       "rails (--foreign), a wheel, or another rail length (--rail)?",
                       stray->phi, 1 / stray->phi));
  if (fit.corner == spectra::CornerState::at_low_bound)
    s.warn("corner",
           fmt::format("corner below {:.3g} cycle/m: A is a lower bound, only A phi_c^2 = "
                       "{:.3g} m^2 (cycle/m)^3 is known; class too good",
                       fit.phi_c.value, fit.steep.value));
  if (fit.misfit > misfit_warned)
    s.warn("misfit",
           fmt::format("residuals {:.2f} times those of chance: lines not named (--foreign), noise "
                       "(--noise), a record that is filtered or an offset (--chord), or another "
                       "shape of spectrum{}",
                       fit.misfit, fit.misfit > misfit_refused ? "; no class is pronounced" : ""));
  if (const auto phi = spectra::high_pass(m.spectrum, fit_options, fit))
    s.warn("high_pass",
           fmt::format("waves longer than {:.3g} m are missing: the record is high-passed, and A "
                       "comes out too low; fit what is above with --low {:.2g}cycle/m",
                       1 / *phi, 2 * *phi));
  if (m.spectrum.segments < 4)
    s.warn("short", fmt::format("only {} segment(s) averaged: a longer record is needed",
                                m.spectrum.segments));
}

void add_notes(tool::Summary& s, const spectra::RecordSpectrum& m, const Fitted& f) {
  const auto note = [&](const char* key, const std::string& text) { s.add(key, "note", text); };
  const spectra::SpectrumFit& fit = f.fit;
  if (!fit.line_significant && fit.phi_0 > 0)
    note("line_note",
         fmt::format("no significant line: without joints 1 record in 20 shows B > {:.2f} mm",
                     fit.B_threshold / mm));
  if (fit.corner == spectra::CornerState::at_high_bound)
    note("corner_note",
         fmt::format("no corner below {:.3g} cycle/m: one slope of -2 fitted", fit.phi_c.value));
  if (!fit.converged) note("noise_note", "a noise floor was asked for, but none could be fitted");
  if (m.shortened)
    note("segment_note", "gaps, or the end of the record, ask for shorter segments than 1250 m");
  if (fit.line_significant)
    note("scatter_note",
         fmt::format(
             "dips that scatter by {:.0f} % would add {:.1f} % to A, which its error does not hold",
             100 * usual_scatter,
             100 * spectra::scatter_bias(m.spectrum, f.fit_options, fit, usual_scatter)));
}

void add_class(tool::Summary& s, const spectra::SpectrumFit& fit) {
  if (fit.misfit > misfit_refused)
    return s.absent("class", "class", "none: the model does not apply");
  const spectra::ClassRule rule;
  const auto result = spectra::classify(fit.A.value, fit.B_printed.value, rule);
  const auto odds = spectra::class_probabilities(fit, rule);
  s.add("deviation_mm", "deviation d expected of a 62-ft chord", result.deviation / mm, "mm",
        fmt::format("random {}, joints {}", tool::to_text(result.random / mm),
                    tool::to_text(result.periodic / mm)));
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
}

tool::Summary answer(const Options& options, const spectra::RecordSpectrum& m, const Fitted& f) {
  const spectra::SpectrumFit& fit = f.fit;
  tool::Summary s{"track of " + options.record.batch.only().string()};
  const auto with_error = [&](const std::string& key, const char* what, spectra::Estimate e,
                              double unit, const char* unit_name,
                              const char* note = "standard error") {
    s.add(key, what, tool::Estimate{e.value / unit, e.error / unit}, unit_name, note);
    s.add_to_json(key + "_error", e.error / unit, unit_name);
  };
  tools::add_record(s, *m.record);
  s.add("segment_m", "length of a segment", static_cast<double>(m.segment) * m.record->spacing(),
        "m", fmt::format("{} samples", m.segment));
  s.add("segments", "segments averaged", static_cast<double>(m.spectrum.segments), "",
        fmt::format("{} samples in none", m.spectrum.unused));
  with_error("A", "roughness A", fit.A, 1, "m^2*cycle/m");
  if (fit.corner == spectra::CornerState::fitted)
    with_error("phi_c", "corner phi_c", fit.phi_c, 1, "cycle/m");
  if (fit.noise.value > 0) with_error("noise", "noise floor", fit.noise, 1, "m^2/(cycle/m)");
  if (fit.phi_0 > 0) {
    s.add("rail_m", "rail length", f.fit_options.rail_length, "m",
          options.rail             ? ""
          : f.contradicting        ? "as the spectrum shows"
          : f.fit.line_significant ? "the default, and its line is there"
                                   : "assumed: no line shows it; --rail names another");
    with_error("B_printed_mm", "joint dip B, printed convention", fit.B_printed, mm, "mm",
               "standard error; as in Table 1");
    with_error("B_exact_mm", "joint dip, physical", fit.B_exact, mm, "mm");
    s.add("C_1", "peak of the line C_1", fit.C_1, "m^2/(cycle/m)");
    s.add("beta", "its width Q_1/C_1", fit.beta, "cycle/m");
  } else {
    s.absent("rail_m", "rail length", "none: track without joints, B is 0");
  }
  add_class(s, fit);
  add_references(s, options.references, m.spectrum, fit_options(options));
  add_notes(s, m, f);
  add_warnings(s, options, m, f);
  return s;
}

spectra::RecordSpectrumOptions measure_options(const Options& options) {
  spectra::RecordSpectrumOptions m{.columns = options.record.columns,
                                   .segment = {},
                                   .window = spectra::parse_window(options.window),
                                   .section = options.record.section};
  if (options.segment) m.segment = static_cast<std::size_t>(*options.segment);
  return m;
}

void add_fit(tool::Row& row, const Fitted& f) {
  const spectra::SpectrumFit& fit = f.fit;
  row.add("A_m2_cycle_per_m", fit.A.value);
  row.add("A_error", fit.A.error);
  row.add("phi_c_cycle_per_m",
          fit.corner == spectra::CornerState::fitted ? fit.phi_c.value : std::nan(""));
  row.add("rail_m", fit.phi_0 > 0 ? f.fit_options.rail_length : std::nan(""));
  row.add("B_printed_mm", fit.B_printed.value / mm);
  row.add("B_printed_error_mm", fit.B_printed.error / mm);
  row.add("misfit", fit.misfit);
  if (fit.misfit > misfit_refused) return row.warn("misfit");
  const spectra::ClassRule rule;
  const auto result = spectra::classify(fit.A.value, fit.B_printed.value, rule);
  row.add("deviation_mm", result.deviation / mm);
  row.add("class", static_cast<double>(result.track_class));
  const auto odds = spectra::class_probabilities(fit, rule);
  row.add("odds", 1e-4 * std::round(1e4 * odds[static_cast<std::size_t>(result.track_class)]));
}

tool::Row row_of_section(const Options& options, const records::RecordStream& record,
                         const spectra::SpectrumSection& s, double rail,
                         const std::string& column) {
  tool::Row row;
  row.add("kind", "section");
  row.add("column", column);
  row.add("from_m", record.places().at(s.first));
  row.add("to_m", record.places().at(s.first + s.count));
  row.add("samples", static_cast<double>(s.count));
  row.add("missing", static_cast<double>(s.missing));
  try {
    if (!s.spectrum) throw InputError{"gaps leave no segment whole"};
    Fitted f{fit_options(options), {}, {}};
    f.fit_options.rail_length = rail;
    f.fit = spectra::fit_track_spectrum(*s.spectrum, f.fit_options);
    add_fit(row, f);
  } catch (const InputError& error) {
    row.add("status", "refused");
    row.add("reason", error.what());
  }
  return row;
}

// A row for each column, and one for each of its sections.
std::vector<tool::Row> rows_of(const Options& options, const std::filesystem::path& file) {
  const spectra::RecordSpectrumOptions measure_it = measure_options(options);
  std::vector<std::vector<spectra::SpectrumSection>> sections(measure_it.columns.size());
  const auto all =
      spectra::record_spectra(tools::record_file(options.record, file), measure_it,
                              [&](std::size_t column, const spectra::SpectrumSection& s) {
                                sections[column].push_back(s);
                              });
  std::vector<tool::Row> rows;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const spectra::RecordSpectrum& m = all[i];
    const Fitted f = fit_track(options, m.spectrum);
    tool::Row& row = rows.emplace_back();
    row.add("kind", "record");
    row.add("column", measure_it.columns[i]);
    tools::add_record(row, *m.record);
    row.add("segment_m", static_cast<double>(m.segment) * m.record->spacing());
    row.add("segments", static_cast<double>(m.spectrum.segments));
    add_fit(row, f);
    tool::Summary warned{""};
    add_warnings(warned, options, m, f);
    for (const auto& [key, text] : warned.warnings()) row.warn(key);
    for (const spectra::SpectrumSection& s : sections[i])
      rows.push_back(
          row_of_section(options, *m.record, s, f.fit_options.rail_length, measure_it.columns[i]));
  }
  return rows;
}

void write_files(tool::OutFolder& out, const Options& options, const spectra::RecordSpectrum& m,
                 const spectra::SpectrumFit& fit, const tool::Summary& summary) {
  std::string text = "phi_cycle_per_m,S_m2_per_cycle_per_m,fitted,A_line\n";
  for (Eigen::Index k = 1; k < m.spectrum.density.size(); ++k) {
    const double phi = m.spectrum.frequency(k);
    const double gain = spectra::squared_gain(options.chord.value_or(0), phi);
    if (gain < options.fit.least_gain) {  // left out, as in the fit: an empty line breaks the curve
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
  out.add("warnings.csv",
          tools::warnings_header + tools::warning_rows(options.record.columns.front(), *m.record));
  std::vector<std::string> drawn{"spectrum.csv"};
  if (!options.references.empty()) {
    out.scratch("references.csv", reference_table(options.references, m.spectrum.frequency(1), 2));
    drawn.emplace_back("references.csv");
  }
  out.figure(tools::scripts("psd") / "classify_spectrum.gp", drawn, "spectrum.png");
  out.figure(tools::scripts("psd") / "classify_class.gp", {"classes.csv", "point.csv"},
             "class.png");
}

void classify_track(const Options& options) {
  for (const std::string& name : options.references) (void)spectra::reference(name);
  if (options.record.batch.many() || options.record.columns.size() > 1 || options.record.section)
    return tool::run_batch(options.record.batch, options.out, "classify",
                           [&](const auto& file) { return rows_of(options, file); });
  tool::OutFolder out(options.out, {"spectrum.csv", "classes.csv", "point.csv", "warnings.csv",
                                    "classify.json", "spectrum.png", "class.png"});
  const auto file = tools::record_file(options.record, options.record.batch.only());
  const spectra::RecordSpectrum measured =
      std::move(spectra::record_spectra(file, measure_options(options)).front());
  const Fitted fitted = fit_track(options, measured.spectrum);
  const tool::Summary summary = answer(options, measured, fitted);
  summary.print();
  if (out) write_files(out, options, measured, fitted.fit, summary);
  out.commit();
}

}  // namespace

tool::Tool classify_tool() {
  return {"classify", "A, corner, dip and class of a track record", [](tool::OptionParser& o) {
            auto options = std::make_shared<Options>();
            add_options(o, *options);
            return [options] { classify_track(*options); };
          }};
}

}  // namespace railbook::psd_tool
