// The limits of an FRA class, watched over a column where they can be judged: chords not where they reach over an
// end of the record or a gap.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <railbook/filters/inner_filter.hpp>
#include <railbook/quality/exceptions.hpp>
#include <railbook/quality/sections.hpp>
#include <railbook/records/record.hpp>

#include "quality/deviations.hpp"

namespace railbook::quality_tool {

// Gauge as a column gives it: whole, or as a deviation from 56.5 in; nothing where it is of neither kind, whose limits are not known.
std::optional<double> gauge_datum(std::span<const double> piece);

// Is the chord of which a column is the offset the one of a limit?
bool is_same_chord(double chord, double limits);

class FraWatch {
 public:
  // Class 1 to 9; of classes 6 to 9 only alinement is watched. `offset`: the chord of which a level or an alignment is the offset
  // already; of another chord than the limit's, or of an unknown one (0), it is not watched.
  FraWatch(std::string column, Kind kind, int track_class, const records::RecordStream& record,
           std::optional<double> offset = std::nullopt);
  void push(std::span<const double> piece);
  void finish();

  std::size_t count() const;
  static const char* const header;
  std::string rows() const;  // of a table
  // Samples of the record that could not be judged for what is missing, bridged or taken out.
  std::size_t not_evaluated(const records::RecordStream& record) const;
  bool judged() const { return watched_.empty() ? false : known_; }

 private:
  struct Watched {
    std::string what, chord;
    quality::Exceptions exceptions;
    std::size_t reach = 0;  // samples
  };
  Watched& watch(const char* what, double chord, double low, double high, double reach);

  std::string column_;
  Kind kind_;
  int class_;
  double spacing_;
  std::function<double(std::size_t)> place_;
  std::deque<Watched> watched_;
  std::deque<filters::InnerFilter> filters_;
  std::optional<quality::Warp> warp_;
  bool begun_ = false, known_ = true, direct_ = false;  // direct: watched as the column gives it
};

}  // namespace railbook::quality_tool
