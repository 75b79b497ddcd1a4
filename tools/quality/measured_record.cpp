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
  else if (is_offset_by_name(header))
    content.offset.emplace();
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

double Channel::fra_class(std::size_t at) const {
  double fra = std::nan("");
  for (const Kept& kept : kept_) {
    const quality::Section& s = kept.sections.all()[at];
    if (s.samples == s.missing) continue;
    const auto judge = [&](const quality::FraLimit& limit) {
      fra = std::fmin(fra, quality::fra_class(limit, s.largest()));
    };
    if (kept.name == "chord")
      judge(column_.kind == Kind::level ? quality::fra::profile : quality::fra::alinement);
    if (kept.name == "warp") judge(quality::fra::warp);
    if (kept.name.empty() && column_.kind == Kind::crosslevel) judge(quality::fra::crosslevel);
    if (kept.name.empty() && column_.kind == Kind::gauge && datum_)
      fra = s.lowest + *datum_ < quality::fra::least_gauge
                ? 0
                : quality::fra_class(quality::fra::gauge, s.highest + *datum_);
  }
  return fra;
}

void Channel::begin(std::span<const double> piece, const records::RecordStream& record) {
  using quality::Measure;
  const auto place = [&record](std::size_t i) { return record.places().at(i); };
  const auto keep = [&](const std::string& name, const Measure& measure) {
    Kept& kept = kept_.emplace_back(Kept{name, quality::Sections{options_.section, place}});
    kept.stream = std::make_unique<quality::MeasureStream>(
        measure, static_cast<int>(options_.passes), record.spacing(),
        [&kept](std::span<const double> values) { kept.sections.push(values); });
  };
  const bool rail = column_.kind <= Kind::alignment;
  if (column_.kind == Kind::gauge) datum_ = gauge_datum(piece, quality::fra::nominal_gauge);
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
    keep(band, content_.for_measure(measure).value_or(measure));
  }
  if (rail && !content_.band) {
    const auto chord = [&](const std::string& text) {
      return Measure{.kind = Measure::Kind::chord, .chord = quality::parse_chord("chords", text)};
    };
    if (const auto measure = content_.for_measure(chord("62ft"))) keep("chord", *measure);
    for (const std::string& text : options_.chords) {
      Measure measure = chord(text);
      if (options_.chord_mean)
        measure.mean = Measure::Mean::subtracted, measure.mean_length = *options_.chord_mean;
      keep("chord_" + text, content_.for_measure(measure).value_or(measure));
    }
  }
  if (column_.kind == Kind::crosslevel) {
    keep("twist", {.kind = Measure::Kind::twist, .length = options_.twist_base});
    keep("warp", {.kind = Measure::Kind::change, .length = 62 * units::foot});
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
