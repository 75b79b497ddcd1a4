/*
A header names its unit after the last underscores; a column that is there without one, or with one of another dimension, is refused rather than guessed.
Distances may be off the marks by a quarter of a sample.
*/
#include "filters/sensor_file.hpp"
#include "units/constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "filters/hybrid_filter.hpp"
#include "table/csv.hpp"
#include "units/input_error.hpp"

namespace railbook::filters_tool {

using namespace geometry_car;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double range(const ChannelInfo& c, const Plausible& p) {
  if (c.dimension == units::length) return p.displacement;
  return c.dimension == units::acceleration ? p.acceleration : p.rate;
}

// Masks single values that stand out; only displacements, which nothing has smoothed.
std::size_t mask_spikes(std::vector<double>& values, double limit) {
  std::size_t masked = 0;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    const double rise = values[i] - values[i - 1], fall = values[i] - values[i + 1];
    if (std::isnan(rise) || std::isnan(fall) || rise * fall <= 0) continue;
    if (std::min(std::abs(rise), std::abs(fall)) <= limit) continue;
    values[i] = nan;
    ++masked;
  }
  return masked;
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
std::optional<long> mark_of(const table::CsvReader& reader, double distance, double first,
                            double sample) {
  if (!std::isfinite(distance)) return std::nullopt;
  const double place = (distance - first) / sample, whole = std::round(place);
  if (std::abs(place - whole) > 0.25 || std::abs(whole) > 1e9)
    throw InputError{fmt::format(
        "file \"{}\", line {}: distance {} m is {:.2f} samples from the first; allowed: "
        "whole samples of {} m, to a quarter",
        reader.file().string(), reader.line(), distance, place, sample)};
  return std::lround(whole);
}

}  // namespace

Record read_sensors(const std::filesystem::path& file, double sample, const Plausible& plausible,
                    Faults& faults, double& first) {
  table::CsvReader reader{file};
  Record record;
  double second = 1, metre = 1;
  const auto elapsed = find(reader, "elapsed", units::time, second);
  if (!elapsed)
    throw InputError{fmt::format("file \"{}\": no column \"elapsed_s\"; there are: {}",
                                 file.string(), fmt::join(reader.header(), ", "))};
  const auto distance = find(reader, "distance", units::length, metre);
  std::vector<std::optional<std::size_t>> column;
  std::vector<double> unit(channels, 1.0);
  for (const ChannelInfo& c : channel_list()) {
    column.push_back(find(reader, c.name, c.dimension, unit[column.size()]));
    if (!column.back()) faults.absent.emplace_back(c.name);
  }
  if (faults.absent.size() == channels)
    throw InputError{fmt::format(
        "file \"{}\": no sensor in it; there are: {}; allowed: vertical_left_m_per_s2 and so on",
        file.string(), fmt::join(reader.header(), ", "))};
  for (std::size_t i = 0; i < reader.header().size(); ++i)
    if (elapsed != i && distance != i && std::find(column.begin(), column.end(), i) == column.end())
      faults.unused.push_back(reader.header()[i]);
  std::vector<std::size_t> beyond(channels, 0);
  first = nan;
  while (reader.next()) {
    double T = reader.number(*elapsed) * second;
    long mark = record.mark.empty() ? 0 : record.mark.back() + 1;
    if (distance) {
      const double s = reader.number(*distance) * metre;
      if (std::isnan(first)) first = s;
      const auto known = mark_of(reader, s, first, sample);
      if (known) mark = *known;
      if (!known) T = nan;
    } else if (!filters::possible_interval(T) && !record.mark.empty()) {
      --mark;  // a pulse too many is no foot of travel
    }
    record.elapsed.push_back(T);
    record.mark.push_back(mark);
    for (const ChannelInfo& c : channel_list()) {
      const auto i = static_cast<std::size_t>(c.channel);
      double value = column[i] ? reader.number(*column[i]) * unit[i] : nan;
      if (!std::isnan(value) && std::abs(value) > range(c, plausible)) {
        ++faults.beyond;
        ++beyond[i];
        value = nan;
      }
      record.values[i].push_back(value);
    }
  }
  if (std::isnan(first)) first = 0;
  for (const ChannelInfo& c : channel_list())
    if (c.dimension == units::length)
      faults.spikes += mask_spikes(record[c.channel], plausible.spike);
  for (const ChannelInfo& c : channel_list())
    if (100 * beyond[static_cast<std::size_t>(c.channel)] > record.size())
      faults.beyond_in.emplace_back(c.name);
  return record;
}

}  // namespace railbook::filters_tool
