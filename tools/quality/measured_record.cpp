#include "quality/measured_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "quality/column_names.hpp"

namespace railbook::quality_tool {

namespace {

std::vector<Column> columns_of(const MeasuresOptions& options) {
  std::vector<Column> columns;
  for (const std::string& name : options.record.columns)
    if (name != "none") columns.push_back({name, Kind::level});
  for (const std::string& name : options.alignment) columns.push_back({name, Kind::alignment});
  if (!options.gauge.empty()) columns.push_back({options.gauge, Kind::gauge});
  if (!options.crosslevel.empty()) columns.push_back({options.crosslevel, Kind::crosslevel});
  if (columns.empty()) throw InputError{"column is none; allowed: none beside other columns"};
  return columns;
}

}  // namespace

ColumnContent Column::content(const MeasuresOptions& options, const std::string& header) const {
  ColumnContent content;
  if (kind > Kind::alignment) return content;
  content.band_name =
      options.filtered != "by-name" ? options.filtered : band_in_name(header).value_or("");
  if (!content.band_name.empty())
    content.band = filters::parse_band("filtered", content.band_name);
  else if (!options.chord.empty())
    content.offset = quality::parse_chord("chord", options.chord);
  else if (is_offset_by_name(header) || high_pass_in_name(header))
    content.offset.emplace();  // of no chord that is known: nothing is judged by it
  return content;
}

void Channel::push(std::span<const double> piece, const records::RecordStream& record) {
  if (kept_.empty()) begin(piece, record);
  if (watch_) watch_->push(piece);
  for (Kept& kept : kept_) kept.stream->push(piece);
}

void Channel::finish() {
  for (Kept& kept : kept_) kept.stream->finish();
  if (watch_) watch_->finish();
}

// Each class allows less than the one below.
double Channel::fra_class(std::size_t at) const {
  double highest = std::nan("");
  for (const Limit& limit : options_.fra_limits) {
    const auto kept = std::ranges::find_if(
        kept_, [&](const Kept& k) { return k.measure.is_like(limit.measure); });
    if (limit.channel != column_.kind || kept == kept_.end() || !datum_ ||
        !content_.for_measure(limit.measure))
      continue;
    const quality::Section& s = kept->sections.all()[at];
    if (s.samples == s.missing) continue;
    const bool allowed = s.lowest + *datum_ >= limit.low && s.highest + *datum_ <= limit.high;
    highest = std::fmin(highest, allowed ? fra_classes : std::stoi(limit.track_class) - 1);
  }
  return highest;
}

void Channel::begin(std::span<const double> piece, const records::RecordStream& record) {
  using quality::Measure;
  const auto place = [&record](std::size_t i) { return record.places().at(i); };
  // A measure of the rail that a column may hold already.
  const auto keep = [&](const std::string& name, const Measure& measure) {
    Kept& kept =
        kept_.emplace_back(Kept{name, measure, quality::Sections{options_.section, place}});
    kept.stream = std::make_unique<quality::MeasureStream>(
        content_.for_measure(measure).value_or(measure), static_cast<int>(options_.passes),
        record.spacing(), [&kept](std::span<const double> values) { kept.sections.push(values); });
  };
  const bool rail = column_.kind <= Kind::alignment;
  if (column_.kind == Kind::gauge) datum_ = gauge_datum(piece, standard_gauge);
  content_ = column_.content(options_, record.header());
  keep("", {});
  if (!options_.limits.empty())
    watch_.emplace(
        column_.kind, content_, options_.limits,
        WatchOptions{options_.section, static_cast<int>(options_.passes), options_.nominal_gauge},
        record);
  const auto bands = !rail           ? std::vector<std::string>{}
                     : content_.band ? std::vector{content_.band_name}
                                     : options_.bands;
  for (const std::string& band : bands) {
    const Measure measure{.kind = Measure::Kind::band, .band = filters::parse_band("bands", band)};
    keep(band, measure);
  }
  if (rail && !content_.band) {
    const auto chord = [&](const std::string& text) {
      return Measure{.kind = Measure::Kind::chord, .chord = quality::parse_chord("chords", text)};
    };
    if (content_.for_measure(chord("62ft"))) keep("chord", chord("62ft"));
    for (const std::string& text : options_.chords) {
      Measure measure = chord(text);
      if (options_.chord_mean)
        measure.mean = Measure::Mean::subtracted, measure.mean_length = *options_.chord_mean;
      keep("chord_" + text, measure);
    }
  }
  if (column_.kind == Kind::crosslevel) {
    keep("twist", {.kind = Measure::Kind::twist, .length = options_.twist_base});
    keep("warp", {.kind = Measure::Kind::change, .length = fra_chord});
  }
}

Measured measure_record(const MeasuresOptions& options, const std::filesystem::path& file) {
  Measured m;
  std::vector<std::string> names;
  std::vector<records::RecordSink> sinks;
  for (const Column& column : columns_of(options)) {
    names.push_back(column.name);
    Channel& channel = m.channels.emplace_back(options, column);
    sinks.emplace_back([&channel](std::span<const double> piece, const records::RecordStream& r) {
      channel.push(piece, r);
    });
  }
  m.records = records::read_records(tools::record_file(options.record, file), names, sinks);
  for (Channel& channel : m.channels) channel.finish();
  return m;
}

}  // namespace railbook::quality_tool
