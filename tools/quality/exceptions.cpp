#include "quality/exceptions.hpp"

#include <fmt/format.h>

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
    ms::Exceptions& exceptions = exceptions_.emplace_back(limit, place);
    chords_.push_back(fmt::format("{:g}", chord / units::foot));
    filters_.emplace_back(taps, taps.half.size() - 1,
                          [&exceptions](std::span<const double> p) { exceptions.push(p); });
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
  for (ms::InnerFilter& filter : filters_) filter.push(piece);
}

void FraWatch::finish() {
  for (ms::InnerFilter& filter : filters_) filter.finish();
}

std::size_t FraWatch::count() const {
  std::size_t n = 0;
  for (const ms::Exceptions& e : exceptions_) n += e.all().size();
  return n;
}

std::string FraWatch::header() {
  return "column,chord_ft,from_m,to_m,largest_mm,largest_at_m,limit_mm\n";
}

std::string FraWatch::rows() const {
  std::string text;
  for (std::size_t i = 0; i < exceptions_.size(); ++i)
    for (const ms::Exception& e : exceptions_[i].all())
      text += fmt::format("{},{},{},{},{},{},{}\n", table::csv_cell(column_), chords_[i],
                          table::csv_number(e.from), table::csv_number(e.to),
                          table::csv_number(e.largest / mm), table::csv_number(e.at),
                          table::csv_number(exceptions_[i].limit() / mm));
  return text;
}

}  // namespace railbook::quality_tool
