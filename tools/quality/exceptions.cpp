#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/filters/wavelength_band.hpp>
#include <railbook/quality/fra_limits.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>

#include "quality/exceptions.hpp"

namespace railbook::quality_tool {
namespace {

constexpr double mm = units::millimetre;

}  // namespace

bool is_same_chord(double chord, double limits) {
  return std::abs(chord / limits - 1) < 0.01;
}

std::optional<double> gauge_datum(std::span<const double> piece) {
  std::vector<double> there;
  for (const double value : piece)
    if (!std::isnan(value)) there.push_back(value);
  if (there.empty()) return 0.0;
  const auto middle = there.begin() + static_cast<std::ptrdiff_t>(there.size() / 2);
  std::nth_element(there.begin(), middle, there.end());
  if (std::abs(*middle - quality::fra::nominal_gauge) < 0.05) return 0.0;
  if (std::abs(*middle) < 0.05) return quality::fra::nominal_gauge;
  return std::nullopt;
}

FraWatch::FraWatch(std::string column, Kind kind, int track_class,
                   const records::RecordStream& record, std::optional<double> offset)
    : column_(std::move(column)),
      kind_(kind),
      class_(track_class),
      spacing_(record.spacing()),
      place_([&record](std::size_t i) { return record.places().at(i); }) {
  const auto limit = [&](const quality::FraLimit& of) {
    return of.limit[static_cast<std::size_t>(track_class - 1)];
  };
  const auto chord = [&](const char* what, double length, double most,
                         const filters::FilterTaps& taps) {
    if (offset && !is_same_chord(*offset, length)) return;
    Watched& w = watch(what, length, -most, most, offset ? 0 : 0.5 * length);
    direct_ = offset.has_value();
    if (direct_) return;
    filters_.emplace_back(taps, taps.half.size() - 1,
                          [&w](std::span<const double> p) { w.exceptions.push(p); });
  };
  const bool low_speed = track_class <= quality::fra_classes;
  if (kind == Kind::level && low_speed)
    chord("profile", quality::fra::profile.chord, limit(quality::fra::profile),
          filters::chord_taps(quality::fra::profile.chord, spacing_));
  if (kind == Kind::alignment && low_speed)
    chord("alinement", quality::fra::alinement.chord, limit(quality::fra::alinement),
          filters::chord_taps(quality::fra::alinement.chord, spacing_));
  if (kind == Kind::alignment && !low_speed && !offset)
    for (const quality::fra::Uniformity& u : quality::fra::uniformity)
      chord("alinement", u.chord,
            u.limit[static_cast<std::size_t>(track_class - quality::fra_classes - 1)],
            filters::uniformity_taps(u.chord, spacing_));
  if (kind == Kind::crosslevel && low_speed) {
    const double level = limit(quality::fra::crosslevel), warp = limit(quality::fra::warp);
    watch("crosslevel", 0, -level, level, 0);
    watch("warp", 62 * units::foot, -warp, warp, 62 * units::foot);
    warp_.emplace(62 * units::foot, spacing_);
  }
}

FraWatch::Watched& FraWatch::watch(const char* what, double chord, double low, double high,
                                   double reach) {
  return watched_.emplace_back(Watched{what,
                                       chord > 0 ? fmt::format("{:g}", chord / units::foot) : "",
                                       quality::Exceptions{low, high, place_},
                                       static_cast<std::size_t>(std::ceil(reach / spacing_))});
}

void FraWatch::push(std::span<const double> piece) {
  if (kind_ == Kind::gauge && !begun_ && class_ <= quality::fra_classes) {
    const auto datum = gauge_datum(piece);
    known_ = datum.has_value();
    const double high = quality::fra::gauge.limit[static_cast<std::size_t>(class_ - 1)];
    if (known_) watch("gauge", 0, quality::fra::least_gauge - *datum, high - *datum, 0);
  }
  begun_ = true;
  for (filters::InnerFilter& filter : filters_) filter.push(piece);
  if ((kind_ == Kind::gauge || direct_) && !watched_.empty()) watched_[0].exceptions.push(piece);
  if (!warp_) return;
  watched_[0].exceptions.push(piece);
  std::vector<double> warp;
  for (const double value : piece) warp.push_back(warp_->push(value));
  watched_[1].exceptions.push(warp);
}

void FraWatch::finish() {
  for (filters::InnerFilter& filter : filters_) filter.finish();
}

std::size_t FraWatch::count() const {
  std::size_t n = 0;
  for (const Watched& w : watched_) n += w.exceptions.all().size();
  return n;
}

std::size_t FraWatch::not_evaluated(const records::RecordStream& record) const {
  std::size_t most = 0;
  for (const Watched& w : watched_)
    most = std::max(most, record.unread(0, record.samples(), w.reach));
  return most;
}

const char* const FraWatch::header =
    "column,measure,chord_ft,from_m,to_m,largest_mm,largest_at_m,limit_mm\n";

std::string FraWatch::rows() const {
  std::string text;
  for (const Watched& w : watched_)
    for (const quality::Exception& e : w.exceptions.all())
      text += fmt::format("{},{},{},{},{},{},{},{}\n", table::csv_cell(column_), w.what, w.chord,
                          table::csv_number(e.from), table::csv_number(e.to),
                          table::csv_number(e.largest / mm), table::csv_number(e.at),
                          table::csv_number(w.exceptions.limit(e) / mm));
  return text;
}

}  // namespace railbook::quality_tool
