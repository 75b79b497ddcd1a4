// A record of track geometry on its way to the measures of `railbook quality measures`: what is asked for, and what is
// kept of each column, section by section.
#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/filters/inner_filter.hpp>
#include <railbook/filters/wavelength_band.hpp>
#include <railbook/quality/fra_limits.hpp>
#include <railbook/quality/sections.hpp>
#include <railbook/tool/options.hpp>

#include "quality/column_names.hpp"
#include "quality/deviations.hpp"
#include "quality/exceptions.hpp"
#include "record_options.hpp"

namespace railbook::quality_tool {

struct MeasuresOptions {
  tools::TrackRecordOptions record;
  std::vector<std::string> alignment, bands{"D1", "D2"};
  std::string gauge, crosslevel;
  double section = 200, twist_base = 3;
  std::vector<double> chords;
  std::optional<double> chord;     // of which the levels and alignments are the offsets
  long passes = 2, fra_class = 0;  // 0: none asked for
  tool::Destination out;
};

struct Column {
  std::string name;
  Kind kind;

  // The chord of which it is the offset; 0 where only its header says that it is one.
  std::optional<double> offset(const MeasuresOptions& options, const std::string& header) const {
    if (kind > Kind::alignment) return std::nullopt;
    if (options.chord) return options.chord;
    return is_offset_by_name(header) ? std::optional{0.0} : std::nullopt;
  }
};

// Throws InputError when a band has no name of EN 13848.
std::vector<filters::Band> bands_of(const MeasuresOptions& options);

// What is kept of a column: the channel itself or a filtered one, section by section.
struct Kept {
  std::string name;  // "D1"; empty for the channel as it is
  quality::Sections sections;
  std::unique_ptr<filters::InnerFilter> filter;
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
  const std::optional<FraWatch>& watch() const { return watch_; }

  // How far from a sample the FRA's measure of it reaches, m.
  double reach() const {
    return column_.kind == Kind::gauge        ? 0
           : column_.kind == Kind::crosslevel ? quality::fra::profile.chord
                                              : 0.5 * quality::fra::profile.chord;
  }

  // The highest FRA class that what is kept of a section allows; NaN where it holds nothing that can be judged.
  double fra_class(std::size_t at) const;

 private:
  void begin(const records::RecordStream& record);

  const MeasuresOptions& options_;
  Column column_;
  std::deque<Kept> kept_;  // references to them are kept
  std::optional<quality::Twist> twist_;
  std::optional<quality::Warp> warp_;
  std::optional<double> datum_;  // of gauge
  bool begun_ = false;
  std::optional<FraWatch> watch_;
};

struct Measured {
  std::vector<std::unique_ptr<const records::RecordStream>> records;
  std::deque<Channel> channels;

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const Channel& channel : channels) all.push_back(channel.column().name);
    return all;
  }

  double exceptions() const {
    std::size_t n = 0;
    for (const Channel& channel : channels) n += channel.watch() ? channel.watch()->count() : 0;
    return static_cast<double>(n);
  }
};

Measured measure_record(const MeasuresOptions& options, const std::filesystem::path& file);

}  // namespace railbook::quality_tool
