#include <railbook/records/record_file.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <railbook/records/detail/cells.hpp>
#include <railbook/records/detail/column_units.hpp>
#include <railbook/records/detail/positions.hpp>
#include <railbook/records/resample.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/number_text.hpp>

namespace railbook::records {
namespace {

constexpr double bridged_length = 1;  // m
constexpr std::size_t block = 1024;   // rows: their columns stay in the fastest memory

bool is_empty_row(const table::CsvReader& reader) {
  for (std::size_t i = 0; i < reader.header().size(); ++i)
    if (!reader.cell(i).empty()) return false;
  return true;
}

std::size_t column_of(const table::CsvReader& reader, const std::string& name) {
  if (const auto found = reader.find(name)) return *found;
  try {
    return reader.column(name);
  } catch (const InputError& error) {
    throw InputError{error.what() + std::string{"; --skip if lines stand before the headers"}};
  }
}

constexpr const char* yards_advice =
    "; allowed: --distance-unit mi.yd if what stands behind the point of its miles are yards";

// Whether positions in miles are miles and yards, 12.0440: none is past .1760 in over a mile.
struct Miles {
  bool in_miles = false;
  double most = 0, lowest = 0, highest = 0;  // of the fractions; miles
  bool any = false;

  void watch(std::span<const double> positions) {
    if (!in_miles || most >= 0.176) return;
    for (const double position : positions) {
      if (std::isnan(position)) continue;
      const double miles = position / mile;
      if (!any) lowest = highest = miles;
      any = true;
      lowest = std::min(lowest, miles);
      highest = std::max(highest, miles);
      most = std::max(most, miles - std::floor(miles + 1e-9));
    }
  }
  bool may_be_yards() const { return any && most < 0.176; }
  bool are_yards() const { return may_be_yards() && highest - lowest > 1; }
  static constexpr double mile = 1609.344;  // m
};

double two_digits(double value) {
  if (!(value > 0)) return value;
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::round(value / unit) * unit;
}

std::string resampled_text(const Resampler& r, std::size_t column) {
  std::string text = "heights stand on straight lines between the samples, at " +
                     units::number_text(r.spacing()) + " m; they are off by about " +
                     units::number_text(two_digits(1e3 * r.error(column))) +
                     " mm (rms, judged by leaving out each sample in turn)";
  if (r.repeated() > 0)
    text += "; " + std::to_string(r.repeated()) + " rows at the place of the one before left out";
  if (r.turned() > 0) text += "; positions turn back " + std::to_string(r.turned()) + " times";
  return text;
}

}  // namespace

std::vector<std::unique_ptr<const RecordStream>> read_records(
    const RecordFile& source, const std::vector<std::string>& columns,
    const std::vector<RecordSink>& sinks) {
  table::CsvReader reader{source.file,
                          {source.skip, source.header_lines, source.encoding, source.sheet,
                           source.dataset, source.decimal}};
  std::vector<std::size_t> column;
  column.reserve(columns.size());
  for (const std::string& name : columns) column.push_back(column_of(reader, name));
  const auto dimension = [&](std::size_t i) {
    return source.dimensions.empty() ? units::length : source.dimensions[i];
  };
  // A row of units: none of the columns asked for holds a number, each of them names a unit.
  bool pending = reader.next();
  std::vector<std::string> below(reader.header().size());
  const auto unit_below = [&](std::size_t i) {
    return unit_of_cell(reader.cell(column[i]), dimension(i));
  };
  bool units_below = pending;
  for (std::size_t i = 0; pending && i < column.size(); ++i)
    units_below = units_below && !unit_below(i).empty();
  if (units_below) {
    for (std::size_t c = 0; c < below.size(); ++c) {
      const std::string text{reader.cell(c)};
      below[c] = text.find('+') != std::string::npos ? text : unit_of_cell(text);
    }
    for (std::size_t i = 0; i < column.size(); ++i) below[column[i]] = unit_below(i);
    pending = false;
  }
  std::vector<double> metre;
  metre.reserve(columns.size());
  for (std::size_t i = 0; i < column.size(); ++i)
    metre.push_back(metres(reader.header()[column[i]], below[column[i]],
                           i == 0 || source.dimensions.empty() ? source.unit : "", "--unit",
                           dimension(i)));
  const auto positions = positions_of(source, reader, below);
  std::optional<Resampler> resampler;
  if (source.resample) {
    if (!positions)
      throw InputError{table::quoted_name(source.file) +
                       ": resample needs a column of positions (--distance)"};
    resampler.emplace(*source.resample, columns.size());
  }
  Where where{source.where, reader};
  std::vector<std::unique_ptr<RecordStream>> records(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i)
    records[i] = std::make_unique<RecordStream>(
        RecordOptions{.spacing = source.spacing,
                      .bridge = source.bridge.value_or(0),
                      .bridge_length = source.bridge ? 0 : bridged_length,
                      .screening = source.screening,
                      .unit = metre[i],
                      .resync = source.resync,
                      .header = reader.header()[column[i]],
                      .si = units::si_name(dimension(i))},
        [&sinks, &records, i](std::span<const double> piece) { sinks[i](piece, *records[i]); });
  Miles miles;
  miles.in_miles = positions && positions->columns.size() == 1 && !positions->yards &&
                   std::abs(positions->metre[0] / Miles::mile - 1) < 1e-6;
  const Cells cells{source, reader};
  // Where the columns are in a row whose cells are all plain numbers.
  std::vector<std::size_t> plain = column;
  if (positions) plain.insert(plain.end(), positions->columns.begin(), positions->columns.end());
  std::sort(plain.begin(), plain.end());
  plain.erase(std::unique(plain.begin(), plain.end()), plain.end());
  const auto place_of = [&](std::size_t of) {
    return static_cast<std::size_t>(std::lower_bound(plain.begin(), plain.end(), of) -
                                    plain.begin());
  };
  std::vector<std::size_t> height_at, position_at;
  for (const std::size_t c : column) height_at.push_back(place_of(c));
  if (positions)
    for (const std::size_t c : positions->columns) position_at.push_back(place_of(c));
  const std::optional<table::TwoParts> parts = positions ? positions->two_parts() : std::nullopt;
  std::vector<double> numbers(plain.size() * block), at(positions ? block : 0),
      heights(columns.size() * block), row(columns.size());
  std::size_t unreported = 0, empty = 0;
  const auto named = [&](std::size_t i, const std::string& what) {
    return InputError{table::quoted_name(source.file) + ", " + quoted(reader.header()[column[i]]) +
                      ": " + what};
  };
  const auto add = [&](std::size_t i, std::span<const double> places,
                       std::span<const double> values) {
    try {
      if (positions)
        records[i]->add(places, values);
      else
        records[i]->add(values);
    } catch (const InputError& error) {
      throw named(i, error.what() + std::string{miles.may_be_yards() ? yards_advice : ""});
    }
  };
  const auto hand_on = [&] {
    for (std::size_t i = 0; i < columns.size(); ++i)
      add(i, resampler->positions(), resampler->heights(i));
    resampler->clear();
  };
  // The rows in `at` and `heights`.
  const auto add_rows = [&](std::size_t rows) {
    for (std::size_t i = 0; !resampler && i < columns.size(); ++i)
      add(i, {at.data(), positions ? rows : 0}, {&heights[i * block], rows});
    if (!resampler) return;
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t i = 0; i < columns.size(); ++i) row[i] = heights[i * block + r];
      resampler->push(at[r], row);
    }
    hand_on();
  };
  while (true) {
    std::size_t rows =
        pending || !where.all() ? 0 : reader.numbers(plain, numbers, parts ? &*parts : nullptr);
    const bool all_plain = rows > 0;
    if (!all_plain && !pending && !reader.next()) break;
    pending = false;
    if (!all_plain) rows = 1;
    if (!all_plain && is_empty_row(reader)) {
      empty += positions ? 0 : 1;
      continue;
    }
    if (!all_plain && !where.fits()) continue;
    for (; empty > 0; --empty) {
      for (std::size_t i = 0; i < columns.size(); ++i) heights[i * block] = lost;
      add_rows(1);
    }
    if (positions && !all_plain) at[0] = read_position(*positions, reader, cells);
    if (all_plain && parts) std::copy_n(&numbers[position_at[0] * block], rows, at.data());
    if (all_plain && !parts) std::fill_n(at.begin(), positions ? rows : 0, 0.0);
    for (std::size_t i = 0; all_plain && !parts && i < position_at.size(); ++i) {
      const double* const from = &numbers[position_at[i] * block];
      for (std::size_t r = 0; r < rows; ++r) {
        at[r] += positions->metres(i, from[r]);
        if (std::isnan(at[r]) && !std::isnan(from[r]))
          throw InputError{table::quoted_name(source.file) + ", line " +
                           std::to_string(reader.line()) +
                           " or before: " + quoted(reader.header()[positions->columns[i]]) +
                           " has more than 1760 yards behind the point of its miles"};
      }
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double* const from = &numbers[height_at[i] * block];
      double* const height = &heights[i * block];
      if (!all_plain) height[0] = cells.height(column[i]) * metre[i];
      for (std::size_t r = 0; all_plain && r < rows; ++r) height[r] = from[r] * metre[i];
      for (std::size_t r = 0; all_plain && !source.missing.empty() && r < rows; ++r)
        height[r] = cells.unless_missing(from[r]) * metre[i];
    }
    if (positions) miles.watch({at.data(), rows});
    add_rows(rows);
    unreported += rows;
    if (!source.progress || unreported < 16 * block || reader.share() < 0) continue;
    source.progress(reader.share());
    unreported = 0;
  }
  std::vector<std::unique_ptr<const RecordStream>> result;
  where.require_found();
  if (miles.are_yards())
    throw InputError{table::quoted_name(source.file) + ": " +
                     quoted(reader.header()[positions->columns[0]]) +
                     " never has more than .1760 behind the point of its miles" + yards_advice};
  if (resampler) {
    resampler->finish();
    hand_on();
  }
  for (std::size_t i = 0; i < records.size(); ++i) {
    try {
      records[i]->finish();
    } catch (const InputError& error) {
      throw named(i, error.what());
    }
    if (resampler) records[i]->note({"resampled", resampled_text(*resampler, i)});
    result.push_back(std::move(records[i]));
  }
  return result;
}

std::unique_ptr<const RecordStream> read_record(const RecordFile& source, const RecordSink& sink) {
  return std::move(read_records(source, {source.column}, {sink}).front());
}

}  // namespace railbook::records
