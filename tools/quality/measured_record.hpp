// A record of track geometry on its way to the measures of `railbook quality measures`: what is
// asked for, and what is kept of each column, section by section.
#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/quality/measure.hpp>
#include <railbook/quality/sections.hpp>
#include <railbook/tool/options.hpp>

#include "quality/column_content.hpp"
#include "quality/deviations.hpp"
#include "quality/limit_watch.hpp"
#include "quality/limits_file.hpp"
#include "record_options.hpp"

namespace railbook::quality_tool {

inline constexpr double fra_chord = 62 * units::foot;
inline constexpr int fra_classes = 5;  // by which sections are judged

struct MeasuresOptions {
  tools::TrackRecordOptions record;
  std::vector<std::string> alignment, bands{"D1", "D2"}, chords;
  std::string gauge, crosslevel;
  double section = 200, twist_base = 3, nominal_gauge = standard_gauge;
  std::optional<double> chord_mean;
  // What the columns of level and alignment are: offsets of this chord, filtered to this band
  // ("by-name" too).
  std::string chord, filtered;
  long passes = 2, fra_class = 0;  // 0: none asked for
  std::filesystem::path limits_file;
  std::vector<std::string> classes;
  std::optional<double> speed;
  tool::Destination out;

  // Those that are watched, of a file or of the FRA's class, and the FRA's of classes 1 to 5, in
  // their order; read by measure_track().
  std::vector<Limit> limits, fra_limits;
};

struct Column {
  std::string name;
  Kind kind;

  ColumnContent content(const MeasuresOptions& options, const std::string& header) const;
};

// What is kept of a column: the channel itself or a filtered one, section by section.
struct Kept {
  std::string name;  // "D1"; empty for the channel as it is
  quality::Measure measure;
  quality::Sections sections;
  std::unique_ptr<quality::MeasureStream> stream = {};
};

// A column on its way: each sample goes to all that is kept of it.
class Channel {
 public:
  Channel(const MeasuresOptions& options, const Column& column)
      : options_(options), column_(column) {}

  void push(std::span<const double> piece, const records::RecordStream& record);
  void finish();

  const Column& column() const { return column_; }
  const std::deque<Kept>& kept() const { return kept_; }
  const ColumnContent& content() const { return content_; }
  const std::optional<LimitWatch>& watch() const { return watch_; }

  // How far from a sample the FRA's measure of it reaches, m.
  double reach() const {
    return column_.kind == Kind::gauge        ? 0
           : column_.kind == Kind::crosslevel ? fra_chord
                                              : 0.5 * fra_chord;
  }

  // The highest FRA class that what is kept of a section allows; NaN where it holds nothing that
  // can be judged.
  double fra_class(std::size_t at) const;

 private:
  void begin(std::span<const double> piece, const records::RecordStream& record);

  const MeasuresOptions& options_;
  Column column_;
  ColumnContent content_;
  std::deque<Kept> kept_;              // references to them are kept
  std::optional<double> datum_ = 0.0;  // of gauge
  std::optional<LimitWatch> watch_;
};

struct Measured {
  std::vector<std::unique_ptr<const records::RecordStream>> records;
  std::deque<Channel> channels;

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const Channel& channel : channels) all.push_back(channel.column().name);
    return all;
  }
};

Measured measure_record(const MeasuresOptions& options, const std::filesystem::path& file);

}  // namespace railbook::quality_tool
