#include "quality/exceptions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "measures/band.hpp"
#include "measures/fra_limits.hpp"
#include "table/csv.hpp"
#include "units/constants.hpp"

namespace railbook::quality_tool {
namespace {

namespace ms = railbook::measures;
constexpr double mm = units::millimetre;

}  // namespace

FraWatch::FraWatch(std::string column, bool alinement, int track_class,
                   const spectra::RecordStream& record)
    : column_(std::move(column)) {
  const auto place = [&record](std::size_t i) { return record.places().at(i); };
  const auto watch = [&](double chord, double limit, const quality::FilterTaps& taps) {
    const std::size_t n = watched_.size();
    watched_.push_back({.chord = fmt::format("{:g}", chord / units::foot),
                        .exceptions = ms::Exceptions{limit, place},
                        .filter = quality::FilterStream{taps,
                                                        [this, n](std::span<const double> p) {
                                                          judge(watched_[n], p);
                                                        }},
                        .reach = taps.half.size() - 1});
  };
  if (track_class <= ms::fra_classes) {
    const ms::FraLimit& limit = alinement ? ms::fra::alinement : ms::fra::profile;
    watch(limit.chord, limit.limit[static_cast<std::size_t>(track_class - 1)],
          ms::chord_taps(limit.chord, record.spacing()));
  } else if (alinement) {
    for (const ms::fra::Uniformity& u : ms::fra::uniformity)
      watch(u.chord, u.limit[static_cast<std::size_t>(track_class - ms::fra_classes - 1)],
            ms::uniformity_taps(u.chord, record.spacing()));
  }
}

void FraWatch::push(std::span<const double> piece) {
  for (const double value : piece) {
    if (std::isnan(value)) {
      if (gaps_.empty() || gaps_.back().end != samples_) gaps_.push_back({samples_, samples_});
      ++gaps_.back().end;
    }
    ++samples_;
  }
  for (Watched& w : watched_) w.filter.push(piece);
}

void FraWatch::finish() {
  gaps_.push_back({samples_, samples_ + 1});
  for (Watched& w : watched_) w.filter.finish();
}

// An offset comes when the samples within its reach are known, and the gaps among them.
void FraWatch::judge(Watched& w, std::span<const double> offsets) {
  judged_.assign(offsets.begin(), offsets.end());
  for (double& offset : judged_) {
    const std::size_t at = w.at++;
    while (w.gap < gaps_.size() && gaps_[w.gap].end + w.reach <= at) ++w.gap;
    const bool cut = w.gap < gaps_.size() && gaps_[w.gap].begin <= at + w.reach;
    if (at < w.reach || cut) offset = std::nan("");
  }
  w.exceptions.push(judged_);
}

std::size_t FraWatch::count() const {
  std::size_t n = 0;
  for (const Watched& w : watched_) n += w.exceptions.all().size();
  return n;
}

std::string FraWatch::header() {
  return "column,chord_ft,from_m,to_m,largest_mm,largest_at_m,limit_mm\n";
}

std::string FraWatch::rows() const {
  std::string text;
  for (const Watched& w : watched_)
    for (const ms::Exception& e : w.exceptions.all())
      text += fmt::format("{},{},{},{},{},{},{}\n", table::csv_cell(column_), w.chord,
                          table::csv_number(e.from), table::csv_number(e.to),
                          table::csv_number(e.largest / mm), table::csv_number(e.at),
                          table::csv_number(w.exceptions.limit() / mm));
  return text;
}

}  // namespace railbook::quality_tool
