// The limits of a file, watched over a column where they can be judged.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <railbook/quality/exceptions.hpp>
#include <railbook/quality/measure.hpp>
#include <railbook/quality/sections.hpp>
#include <railbook/records/record.hpp>

#include "quality/column_content.hpp"
#include "quality/limits_file.hpp"

namespace railbook::quality_tool {

inline constexpr double standard_gauge = 56.5 * units::inch;

// Gauge as a column gives it: 0 where it is whole, the nominal gauge (m) where it is the deviation
// from that; nothing where it is neither, whose limits are not known.
std::optional<double> gauge_datum(std::span<const double> piece, double nominal);

struct WatchOptions {
  double section = 0;        // m, of standard deviations
  int passes = 2;            // of band_taps
  double nominal_gauge = 0;  // m
};

// A limit that is left: `size` m (m/m of a twist), the value farthest beyond `bound`, both as the
// column counts.
struct Exceedance {
  const Limit* limit = nullptr;
  quality::Exception place;
  double bound = 0;
};

class LimitWatch {
 public:
  // Of `limits`, which outlive it, those of the column's kind.
  LimitWatch(Kind kind, const ColumnContent& content, const std::vector<Limit>& limits,
             const WatchOptions& options, const records::RecordStream& record);
  LimitWatch(const LimitWatch&) = delete;  // its streams refer to it
  void push(std::span<const double> piece);
  void finish();

  // In the order of the limits, and along the track. A deviation is judged where its section is
  // half there at the least.
  std::vector<Exceedance> exceedances() const;
  bool judges(const Limit& limit) const;
  // Samples of the record that could not be judged for what is missing, bridged or taken out.
  std::size_t not_evaluated(const records::RecordStream& record) const;
  // Samples at each end of the record that some measure has no value of, at the most.
  std::size_t reach() const;

 private:
  struct Watched {
    quality::Measure measure;
    std::vector<const Limit*> deviations;
    std::optional<quality::Sections> sections;
    std::deque<std::pair<const Limit*, quality::Exceptions>> peaks;
    std::optional<quality::MeasureStream> stream;
  };
  void begin(std::span<const double> piece);

  Kind kind_;
  ColumnContent content_;
  const std::vector<Limit>& limits_;
  WatchOptions options_;
  double spacing_;
  std::function<double(std::size_t)> place_;
  std::deque<Watched> watched_;
  bool begun_ = false;
};

}  // namespace railbook::quality_tool
