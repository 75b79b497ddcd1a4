#include "spectra/record_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "table/csv.hpp"
#include "units/input_error.hpp"
#include "units/printable.hpp"
#include "units/quantity.hpp"

namespace railbook::spectra {
namespace {

constexpr double bridged_length = 1;  // m
constexpr std::size_t block = 1024;   // rows: their columns stay in the fastest memory

std::string quoted(const std::string& name) {
  return "column \"" + units::printable(name) + "\"";
}

// What one cell of a column is in metres: by its header, or else by what the option named says.
double metres(const std::string& header, const std::string& given, const std::string& option) {
  const units::Header named = table::parse_column(header);
  if (given.empty() && named.unit_text.empty())
    throw InputError{quoted(header) + " names no unit; give one with " + option + ", such as mm"};
  const units::Unit unit = given.empty() ? named.unit : units::parse_unit(given);
  if (!(unit.dimension == units::length))
    throw InputError{quoted(header) + " has the unit " + (given.empty() ? named.unit_text : given) +
                     "; allowed: a length, such as mm"};
  if (!given.empty() && !named.unit_text.empty() && unit.si != named.unit.si)
    throw InputError{quoted(header) + " is in " + named.unit_text + " by its header, in " + given +
                     " by " + option};
  return unit.si;
}

std::pair<std::string, std::string> cut_at_plus(const std::string& text) {
  const std::size_t at = text.find('+');
  if (at == std::string::npos || at == 0 || at + 1 == text.size()) return {text, ""};
  return {text.substr(0, at), text.substr(at + 1)};
}

// The columns of positions: one, or two that add up.
struct Positions {
  std::vector<std::size_t> columns;
  std::vector<double> metre;
};

// "Km" and "metres" over a column of positions are its unit.
std::string unit_in_name(const std::string& header) {
  const units::Header as_unit = table::parse_column("x (" + header + ")");
  return as_unit.unit.dimension == units::length ? as_unit.unit_text : "";
}

double metres_of_position(const std::string& header, const std::string& given) {
  const bool bare = table::parse_column(header).unit_text.empty();
  const std::string by_name = given.empty() && bare ? unit_in_name(header) : given;
  if (bare && by_name.empty())
    throw InputError{quoted(header) +
                     " names no length; allowed: a header such as distance_m, or "
                     "its unit with --distance-unit"};
  return metres(header, by_name, "--distance-unit");
}

std::optional<Positions> positions_of(const RecordFile& wish, const table::CsvReader& reader) {
  const auto [first, second] = cut_at_plus(wish.distance);
  if (!second.empty() && !reader.find(wish.distance)) {
    const auto [major, minor] = cut_at_plus(wish.distance_unit);
    const std::array columns{reader.column(first), reader.column(second)};
    return Positions{{columns[0], columns[1]},
                     {metres_of_position(reader.header()[columns[0]], major),
                      metres_of_position(reader.header()[columns[1]], minor)}};
  }
  auto column = reader.find(wish.distance);
  if (!column && wish.distance == "distance" && !wish.spacing)
    for (const char* name : {"position", "chainage", "mileage", "kilometre", "kilometer", "km"})
      if (!column) column = reader.find(name);
  if (column)
    return Positions{{*column}, {metres_of_position(reader.header()[*column], wish.distance_unit)}};
  if (wish.spacing) return std::nullopt;
  std::string there;
  for (const std::string& header : reader.header()) there += (there.empty() ? "" : ", ") + header;
  throw InputError{"file \"" + units::printable(wish.file.string(), 300) + "\": no " +
                   quoted(wish.distance) + "; there are: " + units::printable(there, 1000) +
                   "; allowed: a column of positions (--distance) or --spacing, such as 1ft"};
}

// 12+345.6 and 12K345.6M: thousands and ones. False when the cell is neither.
bool kilometres_and_metres(std::string_view cell, double& major, double& minor) {
  if (cell.ends_with('M') || cell.ends_with('m')) cell.remove_suffix(1);
  const std::size_t at = cell.find_first_of("+Kk", 1);
  if (at == std::string_view::npos) return false;
  std::string rest{cell.substr(at + 1)};
  std::replace(rest.begin(), rest.end(), ',', '.');
  if (rest.empty() || !std::isdigit(static_cast<unsigned char>(rest.front()))) return false;
  const auto whole = [](std::string_view text, double& value) {
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    return status == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
  };
  return whole(cell.substr(0, at), major) && whole(rest, minor) && major == std::floor(major);
}

class Cells {
 public:
  Cells(const RecordFile& wish, const table::CsvReader& reader) : reader_(reader) {
    for (const std::string& text : wish.missing) {
      double number = 0;
      const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
      if (status == std::errc{} && end == text.data() + text.size())
        numbers_.push_back(number);
      else
        texts_.push_back(text);
    }
  }

  double height(std::size_t column) const {
    const std::string_view cell = reader_.cell(column);
    if (!texts_.empty() && std::find(texts_.begin(), texts_.end(), cell) != texts_.end())
      return lost;
    return unless_missing(reader_.number(column));
  }

  double unless_missing(double value) const {
    return numbers_.empty() || std::find(numbers_.begin(), numbers_.end(), value) == numbers_.end()
               ? value
               : lost;
  }

  double position(const Positions& p) const {
    double sum = 0;
    for (std::size_t i = 0; i < p.columns.size(); ++i) {
      const std::string_view cell = reader_.cell(p.columns[i]);
      double major = 0, minor = 0;
      const bool marked = !cell.empty() && !std::isdigit(static_cast<unsigned char>(cell.back()));
      if (cell.size() > 2 && (marked || cell.find('+', 1) != std::string_view::npos) &&
          kilometres_and_metres(cell, major, minor)) {
        const bool feet = std::abs(p.metre[i] - 0.3048) < 1e-4;
        sum += feet ? (100 * major + minor) * p.metre[i] : 1000 * major + minor;
      } else {
        sum += reader_.number(p.columns[i]) * p.metre[i];
      }
    }
    return sum;
  }

 private:
  const table::CsvReader& reader_;
  std::vector<double> numbers_;
  std::vector<std::string> texts_;
};

}  // namespace

std::vector<std::unique_ptr<const RecordStream>> read_records(
    const RecordFile& wish, const std::vector<std::string>& columns,
    const std::vector<RecordSink>& sinks) {
  table::CsvReader reader{wish.file, wish.skip};
  std::vector<std::size_t> column;
  std::vector<double> metre;
  for (const std::string& name : columns) {
    column.push_back(reader.column(name));
    metre.push_back(metres(reader.header()[column.back()], wish.unit, "--unit"));
  }
  const auto positions = positions_of(wish, reader);
  std::vector<std::unique_ptr<RecordStream>> records(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i)
    records[i] = std::make_unique<RecordStream>(
        RecordOptions{.spacing = wish.spacing,
                      .bridge = wish.bridge.value_or(0),
                      .bridge_length = wish.bridge ? 0 : bridged_length},
        [&sinks, &records, i](std::span<const double> piece) { sinks[i](piece, *records[i]); });
  const Cells cells{wish, reader};
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
  std::vector<double> numbers(plain.size() * block), at(positions ? block : 0), height(block);
  std::size_t told = 0;
  while (true) {
    std::size_t rows = reader.numbers(plain, numbers);
    const bool all_plain = rows > 0;
    if (!all_plain && !reader.next()) break;
    if (!all_plain) rows = 1;
    std::fill_n(at.begin(), positions ? rows : 0, 0.0);
    if (positions && !all_plain) at[0] = cells.position(*positions);
    for (std::size_t i = 0; all_plain && i < position_at.size(); ++i) {
      const double* const from = &numbers[position_at[i] * block];
      for (std::size_t r = 0; r < rows; ++r) at[r] += from[r] * positions->metre[i];
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double* const from = &numbers[height_at[i] * block];
      if (!all_plain) height[0] = cells.height(column[i]) * metre[i];
      for (std::size_t r = 0; all_plain && r < rows; ++r)
        height[r] = cells.unless_missing(from[r]) * metre[i];
      const std::span heights{height.data(), rows};
      if (positions)
        records[i]->add({at.data(), rows}, heights);
      else
        records[i]->add(heights);
    }
    told += rows;
    if (!wish.progress || told < 16 * block || reader.share() < 0) continue;
    wish.progress(reader.share());
    told = 0;
  }
  std::vector<std::unique_ptr<const RecordStream>> result;
  for (auto& record : records) {
    record->finish();
    result.push_back(std::move(record));
  }
  return result;
}

std::unique_ptr<const RecordStream> read_record(const RecordFile& wish, const RecordSink& sink) {
  return std::move(read_records(wish, {wish.column}, {sink}).front());
}

}  // namespace railbook::spectra
