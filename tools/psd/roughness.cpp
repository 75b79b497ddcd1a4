/* ### `psd roughness`

Roughness of a rail's running surface in one-third octave bands of wavelength, in the form of EN 15610:

    psd synthesize rail.csv --length 50m --spacing 1mm --roughness 1e-10m^2*cycle/m
    psd roughness rail.csv --column profile --out mine

Narrow peaks (grains on the rail) are replaced by straight lines, and the rail is what a wheel of 375 mm radius rides on; `--keep-spikes` and `--no-wheel` leave that out. Segments that overlap by half, without their straight line, under Hann's window give a spectrum, and its bins in a band the level
10 lg(mean square/(1 um)^2). A segment is as long as four of them have place between the gaps, or as `--segment` says. Bands of waves longer than a quarter of a segment, or shorter than three spacings, are not covered, and the answer says so. Levels are compared with the limit of ISO 3095 that Directive (EU) 2021/1226 prints. Gaps are not bridged unless
`--bridge` says so. Several columns are lines on one rail: their mean squares are averaged as well.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <railbook/spectra/acoustic_roughness.hpp>
#include <railbook/spectra/welch.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "record_options.hpp"
#include "tools.hpp"

namespace railbook::psd_tool {

namespace {

constexpr double mm = units::millimetre;
constexpr std::size_t shortest_segment = 64, longest_segment = 1 << 18;  // samples

struct RoughnessOptions {
  tools::TrackRecordOptions record;
  std::optional<double> segment;
  double wheel = 0.375;
  bool no_wheel = false, keep_spikes = false;
  tool::Destination out;
};

struct RoughLine {
  std::string column;
  std::size_t spikes = 0;  // samples replaced
  spectra::Spectrum spectrum;
  std::vector<spectra::ThirdOctave> bands;
};

// By segments of the length asked for, or the longest of which four have place and hold 95 % of the
// record.
spectra::Spectrum spectrum_of(const std::vector<double>& heights, double spacing,
                              const RoughnessOptions& options) {
  const auto by = [&](std::size_t size) {
    spectra::Welch welch{spacing, {.segment = size}};
    welch.push(heights);
    return welch;
  };
  if (options.segment) {
    const double samples = units::require_between(
        "segment over the spacing", *options.segment / spacing, shortest_segment, longest_segment);
    return by(2 * static_cast<std::size_t>(std::lround(samples / 2))).spectrum();
  }
  for (std::size_t size = longest_segment;; size /= 2) {
    const spectra::Welch welch = by(size);
    const auto present = static_cast<double>(welch.samples() - welch.gap_samples() - welch.ahead());
    if (size == shortest_segment ||
        (welch.segments() >= 4 && static_cast<double>(welch.used_samples()) >= 0.95 * present))
      return welch.spectrum();
  }
}

RoughLine rough_line(const RoughnessOptions& options, const std::string& column,
                     std::vector<double> heights, double spacing) {
  RoughLine line{.column = column, .spikes = 0, .spectrum = {}, .bands = {}};
  if (!options.keep_spikes) line.spikes = spectra::remove_spikes(heights, spacing);
  if (!options.no_wheel) heights = spectra::under_wheel(heights, spacing, options.wheel);
  line.spectrum = spectrum_of(heights, spacing, options);
  line.bands = spectra::third_octaves(line.spectrum);
  return line;
}

// Of lines on one rail.
RoughLine average(const std::vector<RoughLine>& lines) {
  RoughLine mean = lines.front();
  mean.column = "average";
  for (std::size_t i = 0; i < mean.bands.size(); ++i) {
    double sum = 0, errors = 0;
    for (const RoughLine& line : lines) {
      sum += line.bands[i].mean_square;
      errors += std::pow(line.bands[i].mean_square * line.bands[i].relative_error, 2);
    }
    mean.bands[i].mean_square = sum / static_cast<double>(lines.size());
    mean.bands[i].relative_error = std::sqrt(errors) / sum;
  }
  return mean;
}

void add_line(tool::Summary& s, const RoughLine& line, double spacing, bool several) {
  const auto key = [&](const std::string& text) {
    return tools::key_of(line.column, text, several);
  };
  const std::string before = several ? line.column + ": " : "";
  if (line.bands.empty()) {
    s.absent(key("bands"), before + "bands",
             fmt::format("none: a quarter of a segment of {:.4g} m is shorter than three spacings",
                         1 / line.spectrum.df));
    return;
  }
  s.add(key("segment_m"), before + "length of a segment", 1 / line.spectrum.df, "m",
        fmt::format("{} segments", line.spectrum.segments));
  s.add(key("bands"), "  bands covered", static_cast<double>(line.bands.size()), "",
        fmt::format("{:g} mm (a quarter of a segment) to {:g} mm (three spacings of {:g} mm)",
                    line.bands.front().wavelength / mm, line.bands.back().wavelength / mm,
                    spacing / mm));
  s.add(key("spikes"), "  samples replaced in spikes", static_cast<double>(line.spikes), "");
  std::string above;
  for (const spectra::ThirdOctave& band : line.bands)
    if (band.level() > spectra::roughness_limit(band.wavelength))
      above += fmt::format("{}{:g}", above.empty() ? "" : ", ", band.wavelength / mm);
  s.add(key("above_limit_mm"), "  bands above the limit of ISO 3095, mm",
        above.empty() ? std::string{"none"} : above);
  for (const spectra::ThirdOctave& band : line.bands) {
    const double limit = spectra::roughness_limit(band.wavelength);
    s.add(key(fmt::format("level_{:g}_mm_dB", band.wavelength / mm)),
          fmt::format("{}level at {:g} mm", &band == &line.bands.front() ? before : "",
                      band.wavelength / mm),
          tool::Estimate{band.level(), band.level_error()}, "dB",
          std::isnan(limit) ? "" : fmt::format("limit {:g}", limit));
  }
}

std::string table_of(const std::vector<RoughLine>& lines) {
  std::string text = "column,wavelength_mm,level_dB,error_dB,limit_dB\n";
  for (const RoughLine& line : lines)
    for (const spectra::ThirdOctave& band : line.bands)
      text += fmt::format("{},{},{},{},{}\n", table::csv_cell(line.column),
                          table::csv_number(band.wavelength / mm), table::csv_number(band.level()),
                          table::csv_number(band.level_error()),
                          table::csv_number(spectra::roughness_limit(band.wavelength)));
  return text;
}

std::string picture_of(const std::vector<RoughLine>& lines) {
  std::string text;
  for (const RoughLine& line : lines) {
    text += fmt::format("wavelength_mm,level_dB,{}\n", table::csv_cell(line.column));
    for (const spectra::ThirdOctave& band : line.bands)
      text += fmt::format("{:g},{:.6g},\n", band.wavelength / mm, band.level());
    text += "\n\n";
  }
  text += "wavelength_mm,level_dB,limit of ISO 3095\n";
  for (const spectra::ThirdOctave& band : lines.front().bands)
    if (const double limit = spectra::roughness_limit(band.wavelength); std::isfinite(limit))
      text += fmt::format("{:g},{:g},\n", band.wavelength / mm, limit);
  return text;
}

void roughness_of_rail(const RoughnessOptions& options) {
  tool::OutFolder out(options.out,
                      {"roughness.csv", "warnings.csv", "roughness.json", "roughness.png"});
  records::RecordFile file = tools::record_file(options.record, options.record.batch.only());
  if (!options.record.bridge) file.bridge = 0;  // of waves of millimetres, a metre is no small gap
  const std::vector<std::string>& columns = options.record.columns;
  std::vector<std::vector<double>> heights(columns.size());
  std::vector<records::RecordSink> sinks;
  for (std::vector<double>& kept : heights)
    sinks.emplace_back([&kept](std::span<const double> piece, const records::RecordStream&) {
      kept.insert(kept.end(), piece.begin(), piece.end());
    });
  const tools::Records records = records::read_records(file, columns, sinks);
  const double spacing = records.front()->spacing();
  std::vector<RoughLine> lines;
  for (std::size_t i = 0; i < columns.size(); ++i)
    lines.push_back(rough_line(options, columns[i], std::move(heights[i]), spacing));
  const bool alike = std::all_of(lines.begin(), lines.end(), [&](const RoughLine& line) {
    return line.bands.size() == lines.front().bands.size();
  });
  if (columns.size() > 1 && alike) lines.push_back(average(lines));
  tool::Summary s{"roughness of " + options.record.batch.only().string()};
  tools::add_records(s, columns, records);
  if (columns.size() > 1 && !alike)
    s.warn("average",
           "gaps leave the columns segments of different lengths: no average; give one "
           "with --segment");
  for (const RoughLine& line : lines) add_line(s, line, spacing, columns.size() > 1);
  s.print();
  if (out) {
    out.add("roughness.csv", table_of(lines));
    out.add("warnings.csv", tools::warnings_of(columns, records));
    out.add("roughness.json", s.json());
    out.scratch("picture.csv", picture_of(lines));
    out.figure(tools::scripts("psd") / "roughness.gp", {"picture.csv"}, "roughness.png");
  }
  out.commit();
}

}  // namespace

tool::Tool roughness_tool() {
  return {
      "roughness", "acoustic roughness of a rail in third octaves of wavelength",
      [](tool::OptionParser& o) {
        auto options = std::make_shared<RoughnessOptions>();
        tools::add_record_options(o, options->record);
        o.quantity("--segment", options->segment, units::length,
                   "length of a segment; left out: the longest of which four have place",
                   {1e-3, 1e6});
        o.quantity("--wheel-radius", options->wheel, units::length,
                   "of the wheel that bridges what is narrower than it", {0.01, 10});
        o.flag("--no-wheel", options->no_wheel, "the rail as it was measured, no wheel on it");
        o.flag("--keep-spikes", options->keep_spikes,
               "narrow peaks stay, which are grains on the rail by EN 15610");
        o.out(options->out);
        o.help(std::string{tools::record_help} +
               "\n\nroughness.csv has a row a band: column, its nominal wavelength_mm, level_dB re "
               "1 um (of the rms height in the band),\n"
               "error_dB (one standard error, for roughness that is alike along the record) and "
               "limit_dB of ISO 3095 as Directive\n"
               "(EU) 2021/1226 prints it. Peaks must point upward: heights are positive outward "
               "from the rail. The longest bands are few\n"
               "bins wide: a wave in them reads up to 2 dB too low. EN 15610 asks for samples at "
               "most 1 mm apart. The standard was not at\n"
               "hand: its steps are those that public programs describe. Joints and welds are to "
               "be taken out before."
               "\n\nExample: railbook psd roughness rail.csv --column left --out mine");
        return [options] { roughness_of_rail(*options); };
      }};
}

}  // namespace railbook::psd_tool
