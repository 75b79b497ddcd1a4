/*
A header names its unit after the last underscores; a column that is there without one, or with one of another dimension, is refused rather than guessed.
Distances may be off the marks by a quarter of a sample.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "filters/sensor_file.hpp"

namespace railbook::filters_tool {

using namespace geometry_car;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double range(const ChannelInfo& c, const Plausible& p) {
  if (c.dimension == units::length) return p.displacement;
  return c.dimension == units::acceleration ? p.acceleration : p.rate;
}

// A value on the same side of both its neighbours by more than the limit.
bool is_spike(double before, double value, double behind, double limit) {
  const double rise = value - before, fall = value - behind;
  return std::isgreater(std::abs(rise), limit) && std::isgreater(std::abs(fall), limit) &&
         (rise > 0) == (fall > 0);
}

std::optional<std::size_t> find(const table::CsvReader& reader, std::string_view name,
                                const units::Dimension& dimension, double& si) {
  for (std::size_t i = 0; i < reader.header().size(); ++i) {
    const units::Header header = table::parse_column(reader.header()[i]);
    if (header.name != name) continue;
    if (header.unit_text.empty() || !(header.unit.dimension == dimension))
      throw InputError{
          fmt::format("column \"{}\" names no unit that fits; allowed: one of the dimension of {}",
                      reader.header()[i], units::si_name(dimension))};
    si = header.unit.si;
    return i;
  }
  return std::nullopt;
}

// The number of the foot mark, or nothing when the cell is empty.
std::optional<long> mark_of(const std::filesystem::path& file, std::size_t line, double distance,
                            double first, double sample) {
  if (!std::isfinite(distance)) return std::nullopt;
  const double place = (distance - first) / sample, whole = std::round(place);
  if (std::abs(place - whole) > 0.25 || std::abs(whole) > 1e9)
    throw InputError{fmt::format(
        "file \"{}\", line {}: distance {} m is {:.2f} samples from the first; allowed: "
        "whole samples of {} m, to a quarter",
        file.string(), line, distance, place, sample)};
  return std::lround(whole);
}

}  // namespace

SensorFile::SensorFile(const std::filesystem::path& file, double sample, const Plausible& plausible)
    : reader_(file), sample_(sample) {
  elapsed_ = find(reader_, "elapsed", units::time, second_);
  if (!elapsed_)
    throw InputError{fmt::format("file \"{}\": no column \"elapsed_s\"; there are: {}",
                                 file.string(), fmt::join(reader_.header(), ", "))};
  distance_ = find(reader_, "distance", units::length, metre_);
  for (std::size_t i = 0; i < channels; ++i) {
    const ChannelInfo& c = channel_list()[i];
    column_[i] = find(reader_, c.name, c.dimension, unit_[i]);
    range_[i] = range(c, plausible);
    spike_[i] = c.dimension == units::length ? plausible.spike : units::infinity;
    if (!column_[i]) faults_.absent.emplace_back(c.name);
  }
  if (faults_.absent.size() == channels)
    throw InputError{fmt::format(
        "file \"{}\": no sensor in it; there are: {}; allowed: vertical_left_m_per_s2 and so on",
        file.string(), fmt::join(reader_.header(), ", "))};
  for (std::size_t i = 0; i < reader_.header().size(); ++i) {
    place_.push_back(columns_.size());
    if (elapsed_ == i || distance_ == i ||
        std::find(column_.begin(), column_.end(), i) != column_.end())
      columns_.push_back(i);
    else
      faults_.unused.push_back(reader_.header()[i]);
  }
  before_.fill(nan);
  numbers_.resize(columns_.size() * most_rows);
}

bool SensorFile::next_row() {
  if (++in_block_ < block_) return true;
  in_block_ = 0;
  block_ = reader_.numbers(columns_, numbers_);
  return block_ > 0 || reader_.next();
}

// A row as it stands in the file, what is beyond a sensor's range masked.
bool SensorFile::read(Row& row) {
  if (!next_row()) return false;
  double T = number(*elapsed_) * second_;
  const bool begins = rows_++ == 0;
  long mark = begins ? 0 : mark_ + 1;
  if (distance_) {
    const double s = number(*distance_) * metre_;
    if (!first_ && !std::isnan(s)) first_ = s;
    const auto known = mark_of(reader_.file(), line(), s, first_.value_or(nan), sample_);
    if (known) mark = *known;
    if (!known) T = nan;
  } else if (!filters::possible_interval(T) && !begins) {
    --mark;  // a pulse too many is no foot of travel
  }
  row.elapsed = T;
  row.mark = mark_ = mark;
  for (std::size_t i = 0; i < channels; ++i) {
    row.values[i] = column_[i] ? number(*column_[i]) * unit_[i] : nan;
    if (!std::isgreater(std::abs(row.values[i]), range_[i])) continue;
    ++faults_.beyond;
    ++beyond_[i];
    row.values[i] = nan;
  }
  return true;
}

bool SensorFile::next(Row& row) {
  if (!ahead_) {
    if (rows_ > 0 || !read(ahead_.emplace())) return false;
  }
  row = *ahead_;
  if (!read(*ahead_)) {
    ahead_.reset();
    for (std::size_t i = 0; i < channels; ++i)
      if (100 * beyond_[i] > rows_) faults_.beyond_in.emplace_back(channel_list()[i].name);
    return true;
  }
  for (std::size_t i = 0; i < channels; ++i) {
    if (is_spike(before_[i], row.values[i], ahead_->values[i], spike_[i])) {
      row.values[i] = nan;
      ++faults_.spikes;
    }
    before_[i] = row.values[i];
  }
  return true;
}

}  // namespace railbook::filters_tool
