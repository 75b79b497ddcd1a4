/*
### `filters integrate`: heights from one accelerometer

    filters integrate axlebox.csv --column acceleration --speed-column speed --band D1 --out mine

integrates the vertical acceleration of something that follows the track (an axle box, or a body together with its height over the axle)
twice, along the track and without phase, in a band of wavelengths. At a speed `v` a wave of length `L` and height `z` is an acceleration
`(2 pi v/L)^2 z`: what the accelerometer cannot tell grows with the square of `L/v`, and the answer says how high that is.
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <railbook/filters/double_integral.hpp>
#include <railbook/num/median.hpp>
#include <railbook/num/pile.hpp>
#include <railbook/spectra/reference_spectra.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "record_options.hpp"
#include "tools.hpp"

namespace railbook::filters_tool {

namespace {

using units::millimetre;

struct IntegrateOptions {
  tools::TrackRecordOptions record;
  std::optional<double> speed;  // m/s
  std::string speed_column, band = "D1";
  tool::Destination out;
};

struct Motion {
  std::vector<double> acceleration, speed;  // m/s^2, m/s
  tools::Records records;                   // of both
  double slowest = units::infinity, fastest = 0;
};

Motion read(const IntegrateOptions& options) {
  if (options.speed.has_value() == !options.speed_column.empty())
    throw InputError{"speed: give --speed, or its column with --speed-column"};
  records::RecordFile file = tools::record_file(options.record, options.record.batch.only());
  file.screening.codes = false;  // accelerations have no slope that is too steep
  std::vector<std::string> columns = options.record.columns;
  if (columns.size() != 1)
    throw InputError{fmt::format("{} columns of acceleration; allowed: one", columns.size())};
  file.dimensions = {units::acceleration};
  Motion motion;
  const auto into = [](std::vector<double>& all) {
    return [&all](std::span<const double> piece, const records::RecordStream&) {
      all.insert(all.end(), piece.begin(), piece.end());
    };
  };
  std::vector<records::RecordSink> sinks{into(motion.acceleration)};
  if (!options.speed) {
    columns.push_back(options.speed_column);
    file.dimensions.push_back(units::speed);
    sinks.push_back(into(motion.speed));
  }
  motion.records = records::read_records(file, columns, sinks);
  if (options.speed) motion.speed.assign(motion.acceleration.size(), *options.speed);
  for (const double v : motion.speed) {
    if (std::isnan(v)) continue;
    motion.slowest = std::min(motion.slowest, v);
    motion.fastest = std::max(motion.fastest, v);
  }
  if (!(motion.slowest > 0))
    throw InputError{
        fmt::format("column \"{}\": speed falls to {:g} m/s; allowed: above 0, without "
                    "stops and reversals (--where, or a part of the file)",
                    options.speed_column, motion.slowest)};
  return motion;
}

// The step in which a column is written: the smallest difference of any two; 0 where all are alike.
double smallest_step(std::vector<double> values) {
  std::erase_if(values, [](double v) { return std::isnan(v); });
  std::ranges::sort(values);
  double step = units::infinity;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (const double d = values[i] - values[i - 1]; d > 1e-12) step = std::min(step, d);
  return std::isinf(step) ? 0 : step;
}

// A hundred times the median of their sizes: beyond it are codes.
double far_off(const std::vector<double>& values) {
  std::vector<double> sizes;
  for (const double v : values)
    if (!std::isnan(v)) sizes.push_back(std::abs(v));
  return 100 * num::upper_median(sizes);
}

// Where an accelerometer stands at an end of its range.
struct Clipped {
  std::vector<double> ends;
  std::size_t samples = 0, first = 0, last = 0;
};

// In single precision: crests of computed waves differ in the last digits. One stretch alone is a
// sensor that stuck, or a code.
Clipped find_clipped(const std::vector<double>& values) {
  std::vector<double> rounded;
  for (const double v : values) rounded.push_back(static_cast<float>(v));
  Clipped clipped;
  const double limit = far_off(values);
  for (const double sign : {1.0, -1.0}) {
    const auto end = num::pile(rounded, sign);
    if (!end || std::abs(*end) > limit) continue;
    std::size_t samples = 0, stretches = 0, first = 0, last = 0;
    for (std::size_t i = 0; i < rounded.size(); ++i) {
      if (rounded[i] != *end) continue;
      if (samples == 0) first = i;
      if (samples == 0 || last + 1 < i) ++stretches;
      last = i;
      ++samples;
    }
    if (stretches < 3) continue;
    clipped.first = clipped.ends.empty() ? first : std::min(first, clipped.first);
    clipped.last = std::max(last, clipped.last);
    clipped.samples += samples;
    clipped.ends.push_back(*end);
  }
  return clipped;
}

// What the reading says; of the speed only what it says of places and samples.
void add_warnings(tool::Summary& s, const Motion& motion) {
  constexpr std::array of_samples{"counted", "unplaced", "kilometre",
                                  "bridged", "spacing",  "still"};
  const records::RecordStream& record = *motion.records[0];
  const Clipped clipped = find_clipped(motion.acceleration);
  if (!clipped.ends.empty())
    s.warn("clipped",
           fmt::format("{} samples are at an end of the range, {}{:.4g} m/s^2, the first at {:g} "
                       "m: does the accelerometer clip? They are kept; what is cut off is missing "
                       "in the heights",
                       clipped.samples,
                       clipped.ends.size() > 1 ? fmt::format("{:.4g} or ", clipped.ends[0]) : "",
                       clipped.ends.back(), record.places().at(clipped.first)));
  const bool only_clipped = std::ranges::all_of(record.faults(), [&](const auto& fault) {
    return fault.fault != records::Fault::stuck ||
           std::ranges::find(clipped.ends, static_cast<float>(fault.value)) != clipped.ends.end();
  });
  bool named = false;  // a code
  for (std::size_t i = 0; i < motion.records.size(); ++i)
    for (const units::Warning& warning : motion.records[i]->warnings()) {
      const std::string what = i == 0 ? "acceleration" : "speed", key = what + "_" + warning.key;
      named = named || warning.key == "codes" || warning.key == "outliers";
      if (warning.key == "resampled")
        s.warn(key, what + ": straight lines between the samples, at the spacing of --resample");
      else if (i == 0 ? warning.key != "stuck" || !only_clipped
                      : std::ranges::find(of_samples, warning.key) != of_samples.end())
        s.warn(key, what + ": " + warning.text);
    }
  const double limit = far_off(motion.acceleration);
  const auto at = std::ranges::find_if(motion.acceleration,
                                       [&](double v) { return limit > 0 && std::abs(v) > limit; });
  if (!named && at != motion.acceleration.end())
    s.warn("far_off", fmt::format("the acceleration is {:.4g} m/s^2 at {:g} m, over 100 times its "
                                  "median: a code for a lost sample? (--missing)",
                                  *at,
                                  record.places().at(
                                      static_cast<std::size_t>(at - motion.acceleration.begin()))));
}

// A row for each place; for all that is clipped, one.
std::string warnings_of(const std::string& column, const Motion& motion) {
  const records::RecordStream& record = *motion.records[0];
  std::string text = "column,warning,from_m,to_m,samples,size_m_per_s2,taken_out,option\n" +
                     tools::warning_rows(column, record, "", 1);
  if (const Clipped c = find_clipped(motion.acceleration); !c.ends.empty())
    text += fmt::format("{},clipped,{},{},{},{},no,\n", table::csv_cell(column),
                        table::csv_number(record.places().at(c.first)),
                        table::csv_number(record.places().at(c.last)), c.samples,
                        table::csv_number(c.ends.front()));
  return text;
}

// The rms that a reference spectrum of heights has in a band.
double rms_in(const spectra::Reference& reference, const filters::Band& band) {
  constexpr int points = 400;
  const double low = 0.3 / band.longest, high = 3 / band.shortest;
  double squares = 0;
  for (int i = 0; i <= points; ++i) {
    const double phi = low * std::pow(high / low, static_cast<double>(i) / points);
    squares += std::pow(filters::band_gain(band, 2, phi), 2) * reference.density(phi) * phi;
  }
  return std::sqrt(squares * std::log(high / low) / points);
}

// Noise and wrong units: heights far from those of all reference spectra, where these have waves.
void judge_size(tool::Summary& s, const filters::Band& band, double height) {
  if (band.shortest < 1 || band.longest > 300) return;
  const spectra::Reference *least = nullptr, *most = nullptr;
  for (const spectra::Reference& r : spectra::references()) {
    if (r.channel != "vertical") continue;
    if (!least || rms_in(r, band) < rms_in(*least, band)) least = &r;
    if (!most || rms_in(r, band) > rms_in(*most, band)) most = &r;
  }
  if (const double limit = 2 * rms_in(*most, band); height > limit)
    s.warn("unit", fmt::format("the heights are more than twice those of the roughest reference "
                               "spectrum ({}, {:.2g} mm): noise of the accelerometer, or a wrong "
                               "unit or speed?",
                               most->name, 0.5 * limit / millimetre));
  if (const double limit = rms_in(*least, band); height < limit)
    s.warn("unit", fmt::format("the heights are below those of the smoothest reference spectrum "
                               "({}, {:.2g} mm): is the unit right, and does the accelerometer "
                               "follow the track?",
                               least->name, limit / millimetre));
}

double rms(const std::vector<double>& values) {
  double squares = 0, n = 0;
  for (const double v : values)
    if (!std::isnan(v)) squares += v * v, ++n;
  return std::sqrt(squares / n);
}

void integrate(const IntegrateOptions& options) {
  tool::OutFolder out(options.out, {"heights.csv", "warnings.csv", "integrate.json"});
  const filters::Band band = filters::parse_band("band", options.band);
  const Motion motion = read(options);
  const records::RecordStream& record = *motion.records.front();
  const double spacing = record.spacing();
  const std::vector<double> heights =
      filters::integrate_twice(motion.acceleration, motion.speed, band, spacing);
  const double margin =
      spacing * static_cast<double>(filters::double_integral_margin(band, spacing));
  const auto answered = static_cast<std::size_t>(
      std::count_if(heights.begin(), heights.end(), [](double z) { return !std::isnan(z); }));
  if (answered == 0)
    throw InputError{fmt::format(
        "the record is {:g} m long, or has gaps; allowed: more than {:.0f} m without a gap, since "
        "the filter of the band decays in {:.0f} m at each end{}",
        spacing * static_cast<double>(heights.size()), 2 * margin, margin,
        motion.fastest > motion.slowest ? ", and as much again where the speed changes" : "")};
  // White noise of the accelerometer's steps, through the filter.
  const filters::FilterTaps taps = filters::double_integral_taps(band, spacing);
  double squares = -taps.half[0] * taps.half[0];
  for (const double w : taps.half) squares += 2 * w * w;
  const double step = smallest_step(motion.acceleration);
  const double noise =
      step / std::sqrt(12.0) * std::sqrt(squares) / (motion.slowest * motion.slowest);
  double change = 0;  // c of integrate_twice()
  for (std::size_t i = 1; i < motion.speed.size(); ++i) {
    const double before = motion.speed[i - 1], after = motion.speed[i];
    const double rate = std::abs(after - before) / (spacing * std::min(before, after));
    if (rate > 0) change = std::max(change, band.longest / (2 * units::pi) * rate);
  }
  const double left = std::max(change * change, change / 4);
  const double height = rms(heights);
  tool::Summary s{"heights in " + options.record.batch.only().string()};
  add_warnings(s, motion);
  s.add("length_km", "length", spacing * static_cast<double>(heights.size()) / 1000, "km",
        fmt::format("{} samples, {} missing, {} bridged", record.samples(), record.missing(),
                    record.bridged()));
  s.add("spacing_m", "spacing", spacing, "m");
  s.add("slowest_m_per_s", "speed, slowest", motion.slowest, "m/s");
  s.add("fastest_m_per_s", "  fastest", motion.fastest, "m/s");
  s.add("band", "band", fmt::format("{:g} to {:g} m", band.shortest, band.longest));
  s.add("height_mm", "height in the band, rms", height / millimetre, "mm");
  s.add(
      "answered", "samples with a height", static_cast<double>(answered), "",
      fmt::format("not within {:.0f} m of an end or a gap{}", margin,
                  motion.fastest > motion.slowest ? ", twice that for a speed that changes" : ""));
  s.add("steps_mm", "of it from the steps of the column", noise / millimetre, "mm",
        fmt::format("steps of {:.3g} m/s^2, at the slowest speed", step));
  for (const double length : {band.shortest, band.longest})
    s.add(length == band.shortest ? "shortest_m_per_s2" : "longest_m_per_s2",
          fmt::format("acceleration of 1 mm at {:g} m", length),
          millimetre * std::pow(2 * units::pi * motion.slowest / length, 2), "m/s^2",
          "at the slowest speed; an error as large is as high");
  judge_size(s, band, height);
  if (noise > 0.05 * height)
    s.warn("steps", fmt::format("the column's steps of {:.3g} m/s^2 make {:.2g} mm of {:.2g} mm: a "
                                "shorter band, a higher speed or more digits are needed",
                                step, noise / millimetre, height / millimetre));
  if (left > 0.05)
    s.warn("speed", fmt::format("the speed changes by so much within a wave that {:.0f} % of the "
                                "heights may be wrong",
                                std::min(100.0, 100 * left)));
  s.print();
  if (out) {
    std::string text = "distance_m,height_mm\n";
    for (std::size_t i = 0; i < heights.size(); ++i) {
      table::append_number(text, record.places().at(i), 12);
      text += ',';
      if (!std::isnan(heights[i])) table::append_number(text, heights[i] / millimetre, 7);
      text += '\n';
    }
    out.add("heights.csv", text);
    out.add("warnings.csv", warnings_of(options.record.columns.front(), motion));
    out.add("integrate.json", s.json());
  }
  out.commit();
}

}  // namespace

tool::Tool integrate_tool() {
  return {
      "integrate", "heights of the track from one accelerometer", [](tool::OptionParser& o) {
        auto options = std::make_shared<IntegrateOptions>();
        options->record.columns = {"acceleration"};
        tools::add_record_options(o, options->record);
        o.quantity("--speed", options->speed, units::speed, "of the whole record", {0.1, 200});
        o.text("--speed-column", options->speed_column, "the column that holds it");
        o.text("--band", options->band, "of wavelengths: D0 to D3, or two of them, as 3m-35m");
        o.out(options->out);
        o.help(
            std::string{tools::record_help} +
            "\n\n--column is the vertical acceleration, upward, in the unit that its header or "
            "--unit names, m/s^2 or g; positions are along the track, or with --resample put on "
            "a grid.\n"
            "Accelerations are screened as heights are, but codes are kept, too (--missing, or "
            "--screen outliers, takes them out).\n"
            "warnings.csv: column, warning, place and size, here size_m_per_s2. The command also "
            "warns of samples at an end of the range, as of\n"
            "an accelerometer that clips, and, in\n"
            "bands from 1 m to 300 m, of heights over twice those of the roughest reference "
            "spectrum "
            "of psd classify, or below those of the\n"
            "smoothest, as of noise or a wrong unit.\n"
            "heights.csv: distance_m and height_mm, positive upward, in the band of --band, "
            "empty beside ends and gaps until the band's\n"
            "filter has decayed to 2 % (51 m in D1, 236 m in D2, 664 m in D3, 1.2 km in "
            "100m-150m); in the first wave beyond that, what\n"
            "they hide may still add 2 % of the rms. Of an accelerometer on a body heights are "
            "the body's.\n"
            "A constant error of the accelerometer, and one that drifts evenly, leave nothing: "
            "a line is taken off each stretch without a gap."
            "\n\nExample: railbook filters integrate axlebox.csv --column az --speed 80km/h "
            "--band 3m-25m --out mine");
        return [options] { integrate(*options); };
      }};
}

}  // namespace railbook::filters_tool
