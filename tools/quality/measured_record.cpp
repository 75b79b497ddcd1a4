#include "quality/measured_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

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

std::string name_of_chord(double chord) {
  const double feet = chord / units::foot;
  return std::abs(feet - std::round(feet)) < 1e-6 ? fmt::format("chord_{:g}ft", feet)
                                                  : fmt::format("chord_{:g}m", chord);
}

}  // namespace

std::vector<filters::Band> bands_of(const MeasuresOptions& options) {
  std::vector<filters::Band> chosen;
  for (const std::string& name : options.bands) {
    const auto at = std::find_if(filters::bands.begin(), filters::bands.end(),
                                 [&](const filters::Band& b) { return b.name == name; });
    if (at == filters::bands.end())
      throw InputError{fmt::format("bands: \"{}\"; allowed: D0, D1, D2, D3", name)};
    chosen.push_back(*at);
  }
  return chosen;
}

void Channel::push(std::span<const double> piece, const records::RecordStream& record) {
  if (kept_.empty()) begin(record);
  if (column_.kind == Kind::gauge && !begun_) datum_ = gauge_datum(piece);
  begun_ = true;
  if (watch_) watch_->push(piece);
  for (Kept& kept : kept_) {
    if (kept.filter)
      kept.filter->push(piece);
    else if (kept.name.empty() || kept.name == "chord")
      kept.sections.push(piece);
  }
  if (!twist_) return;
  std::vector<double> twist, warp;
  for (const double value : piece) {
    twist.push_back(twist_->push(value));
    warp.push_back(warp_->push(value));
  }
  kept_[kept_.size() - 2].sections.push(twist);
  kept_.back().sections.push(warp);
}

void Channel::finish() {
  for (Kept& kept : kept_)
    if (kept.filter) kept.filter->finish();
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

void Channel::begin(const records::RecordStream& record) {
  const auto place = [&record](std::size_t i) { return record.places().at(i); };
  const auto keep = [&](const std::string& name) -> Kept& {
    return kept_.emplace_back(Kept{name, quality::Sections{options_.section, place}, {}});
  };
  const auto filter = [&](const std::string& name, const filters::FilterTaps& taps,
                          std::size_t margin) {
    Kept& kept = keep(name);
    kept.filter = std::make_unique<filters::InnerFilter>(
        taps, margin, [&kept](std::span<const double> p) { kept.sections.push(p); });
  };
  const auto chord = [&](const std::string& name, double length) {
    const filters::FilterTaps taps = filters::chord_taps(length, record.spacing());
    filter(name, taps, taps.half.size() - 1);
  };
  keep("");
  const std::optional<double> offset = column_.offset(options_, record.header());
  if (options_.fra_class > 0)
    watch_.emplace(column_.name, column_.kind, static_cast<int>(options_.fra_class), record,
                   offset);
  if (column_.kind == Kind::level || column_.kind == Kind::alignment) {
    for (const filters::Band& band : bands_of(options_))
      filter(std::string{band.name},
             filters::band_taps(band, static_cast<int>(options_.passes), record.spacing()),
             filters::band_margin(band, record.spacing()));
    if (!offset)
      chord("chord", quality::fra::profile.chord);
    else if (is_same_chord(*offset, quality::fra::profile.chord))
      keep("chord");
    for (const double length : options_.chords) chord(name_of_chord(length), length);
  }
  if (column_.kind == Kind::crosslevel) {
    twist_.emplace(options_.twist_base, record.spacing());
    keep("twist");
    warp_.emplace(62 * units::foot, record.spacing());
    keep("warp");
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
