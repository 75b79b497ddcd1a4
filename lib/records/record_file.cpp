#include <railbook/records/record_file.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>
#include <railbook/units/quantity.hpp>

namespace railbook::records {
namespace {

constexpr double bridged_length = 1;                   // m
constexpr std::array forms{"km+m", "mi+ft", "mi+yd"};  // of a position in two parts
constexpr const char* miles_and_yards = "mi.yd";       // four digits behind the point
constexpr std::size_t block = 1024;  // rows: their columns stay in the fastest memory

std::string quoted(const std::string& name) {
  return "column \"" + units::printable(name) + "\"";
}

// The unit that a header names. "level in mm" is no product; a length behind a number is a chord or
// a wave, "profile_62_ft", but for a small number before a small unit: "rail_1_mm".
units::Header header_of(const std::string& text) {
  units::Header header = table::parse_column(text);
  const units::Dimension d = header.unit.dimension;
  if (d.length > 1 && d == units::Dimension{.length = d.length} &&
      header.unit_text.find('*') != std::string::npos) {
    const std::string last = header.unit_text.substr(header.unit_text.rfind('*') + 1);
    header.unit = units::parse_unit(last);
    header.unit_text = last;
    return header;
  }
  if (header.unit_text.empty() || text.ends_with(')') || text.ends_with(']')) return header;
  const std::string& name = header.name;
  const std::size_t letter = name.find_last_not_of("0123456789.,");
  const std::size_t digit = letter == std::string::npos ? 0 : letter + 1;
  const bool apart =
      digit == 0 || std::string_view{" _-/"}.find(name[digit - 1]) != std::string_view::npos;
  if (digit == name.size() || !apart) return header;
  const bool index = name.size() - digit == 1 && header.unit.si < 0.1;
  return index ? header : units::Header{text, "", {}};
}

// A cell of units in the first row, a length: "mm", "[mm]"; empty where it is none.
std::string unit_of_cell(std::string_view cell) {
  if (cell.size() > 2 && (cell.front() == '[' || cell.front() == '('))
    cell = cell.substr(1, cell.size() - 2);
  if (cell.empty() || cell.size() > 40 || std::isdigit(static_cast<unsigned char>(cell.front())))
    return "";
  const units::Header header = table::parse_column("x (" + std::string{cell} + ")");
  return header.unit.dimension == units::length ? header.unit_text : "";
}

// What one cell of a column is in metres: by its header or the row of units under it, or else by
// what the option named says.
double metres(const std::string& header, const std::string& below, const std::string& given,
              const std::string& option) {
  units::Header named = header_of(header);
  if (named.unit_text.empty() && !below.empty()) named = table::parse_column("x (" + below + ")");
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

// The columns of positions: one, or two that add up; what the two parts of 12+345.6 are in one
// column.
struct Positions {
  std::vector<std::size_t> columns;
  std::vector<double> metre;
  double major = 0, minor = 0;  // m; 0: not known
  bool in_two = false;          // all cells must be written so
  bool yards = false;           // 12.0440: miles, and yards behind the point

  // Metres of a plain number of column i; NaN where it is no such position.
  double metres(std::size_t i, double number) const {
    if (!yards) return number * metre[i];
    const double miles = std::floor(number), rest = 1e4 * (number - miles);
    return rest < 1760 ? miles * 1609.344 + std::round(1e6 * rest) / 1e6 * 0.9144
                       : std::numeric_limits<double>::quiet_NaN();
  }
};

// "Km" and "metres" over a column of positions are its unit.
std::string unit_in_name(const std::string& header) {
  const units::Header as_unit = table::parse_column("x (" + header + ")");
  return as_unit.unit.dimension == units::length ? as_unit.unit_text : "";
}

double metres_of_position(const std::string& header, const std::string& below,
                          const std::string& given) {
  const bool bare = header_of(header).unit_text.empty() && below.empty();
  const std::string by_name = given.empty() && bare ? unit_in_name(header) : given;
  if (bare && by_name.empty())
    throw InputError{quoted(header) +
                     " names no length; allowed: a header such as distance_m, or "
                     "its unit with --distance-unit, such as m, km or km+m"};
  return metres(header, below, by_name, "--distance-unit");
}

// One column, whose cells may be written in two parts.
Positions one_column(std::size_t column, const std::string& header, const std::string& below,
                     const std::string& given) {
  std::string both = given;
  if (given == miles_and_yards ||
      (given.empty() &&
       (header.find(miles_and_yards) != std::string::npos || below == miles_and_yards))) {
    Positions p{{column}, {1.0}};
    p.yards = true;
    return p;
  }
  for (const char* form : forms)
    if (both.empty() && (header.find(form) != std::string::npos || below == form)) both = form;
  Positions p{{column}, {1.0}};
  if (const auto [major, minor] = cut_at_plus(both); !minor.empty()) {
    p.major = units::parse_quantity("unit of positions", "1" + major, units::length);
    p.minor = units::parse_quantity("unit of positions", "1" + minor, units::length);
    p.in_two = true;
    const units::Header named = header_of(header);
    if (!named.unit_text.empty() && named.unit.si != p.major && named.unit.si != p.minor)
      throw InputError{quoted(header) + " is in " + named.unit_text + " by its header, in " + both +
                       " by --distance-unit"};
    return p;
  }
  const double metre = p.metre[0] = metres_of_position(header, below, given);
  if (metre == 1 || metre == 1000)
    p.major = 1000, p.minor = 1;
  else if (std::abs(metre - 0.3048) < 1e-4)
    p.major = 100 * metre, p.minor = metre;
  return p;
}

std::optional<Positions> positions_of(const RecordFile& source, const table::CsvReader& reader,
                                      const std::vector<std::string>& below) {
  const auto [first, second] = cut_at_plus(source.distance);
  if (!second.empty() && !reader.find(source.distance)) {
    const auto [major, minor] = cut_at_plus(source.distance_unit);
    const std::array columns{reader.column(first), reader.column(second)};
    return Positions{{columns[0], columns[1]},
                     {metres_of_position(reader.header()[columns[0]], below[columns[0]], major),
                      metres_of_position(reader.header()[columns[1]], below[columns[1]], minor)},
                     1000,
                     1};
  }
  const auto find = [&](const std::string& name) {
    auto found = reader.find(name);
    for (const char* form : forms)
      if (!found) found = reader.find(name + " [" + form + "]");
    if (!found) found = reader.find(name + " [" + miles_and_yards + "]");
    return found;
  };
  auto column = find(source.distance);
  if (!column && source.distance == "distance" && !source.spacing)
    for (const char* name : {"position", "chainage", "mileage", "kilometre", "kilometer", "km"})
      if (!column) column = find(name);
  if (column)
    return one_column(*column, reader.header()[*column], below[*column], source.distance_unit);
  if (source.spacing) return std::nullopt;
  std::string there;
  for (const std::string& header : reader.header()) there += (there.empty() ? "" : ", ") + header;
  throw InputError{"file \"" + units::printable(source.file.string(), 300) + "\": no " +
                   quoted(source.distance) + "; there are: " + units::printable(there, 1000) +
                   "; allowed: a column of positions (--distance) or --spacing, such as 1ft; "
                   "--skip if lines stand before the headers"};
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
  Cells(const RecordFile& source, const table::CsvReader& reader) : reader_(reader) {
    for (const std::string& text : source.missing) {
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
    try {
      return unless_missing(reader_.number(column));
    } catch (const InputError& error) {
      throw InputError{error.what() + std::string{" (--missing \""} + units::printable(cell, 40) +
                       "\" if it stands for a lost sample)"};
    }
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
        const bool metric = cell.find('+', 1) == std::string_view::npos;
        if (!metric && p.major == 0)
          refuse(p.columns[i], "allowed: its two parts in --distance-unit, as mi+ft or mi+yd");
        sum += metric ? 1000 * major + minor : p.major * major + p.minor * minor;
      } else {
        const double number = reader_.number(p.columns[i]);
        if (p.in_two && !std::isnan(number))
          refuse(p.columns[i], "allowed: 12+345, as the unit of this column says");
        const double metres = p.metres(i, number);
        if (std::isnan(metres) && !std::isnan(number))
          refuse(p.columns[i],
                 "allowed: miles, and behind the point yards below 1760 in four digits");
        sum += metres;
      }
    }
    return sum;
  }

  [[noreturn]] void refuse(std::size_t column, const std::string& why) const {
    throw InputError{table::quoted_name(reader_.file()) + ", line " +
                     std::to_string(reader_.line()) + ": position \"" +
                     units::printable(reader_.cell(column), 40) + "\" in " +
                     quoted(reader_.header()[column]) + "; " + why};
  }

 private:
  const table::CsvReader& reader_;
  std::vector<double> numbers_;
  std::vector<std::string> texts_;
};

// Which rows of a table of several records are read.
class Where {
 public:
  Where(const std::vector<std::string>& wanted, const table::CsvReader& reader) : reader_(reader) {
    for (const std::string& one : wanted) {
      const std::size_t at = one.find('=');
      if (at == std::string::npos || at == 0)
        throw InputError{"where is \"" + units::printable(one, 100) +
                         "\"; allowed: COLUMN=VALUE, as rail=left"};
      columns_.push_back(reader.column(one.substr(0, at)));
      values_.push_back(one.substr(at + 1));
    }
  }

  bool all() const { return columns_.empty(); }

  bool fits() {
    bool fit = true;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::string cell{reader_.cell(columns_[i])};
      fit = fit && cell == values_[i];
      if (seen_.size() < 8 && std::find(seen_.begin(), seen_.end(), cell) == seen_.end())
        seen_.push_back(cell);
    }
    found_ = found_ || fit;
    return fit;
  }

  void require_found() const {
    if (all() || found_) return;
    std::string there;
    for (const std::string& cell : seen_) there += (there.empty() ? "" : ", ") + cell;
    throw InputError{table::quoted_name(reader_.file()) +
                     ": no row is as --where asks; there are: " + units::printable(there, 300)};
  }

 private:
  const table::CsvReader& reader_;
  std::vector<std::size_t> columns_;
  std::vector<std::string> values_, seen_;
  bool found_ = false;
};

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

}  // namespace

std::vector<std::unique_ptr<const RecordStream>> read_records(
    const RecordFile& source, const std::vector<std::string>& columns,
    const std::vector<RecordSink>& sinks) {
  table::CsvReader reader{source.file, source.skip};
  std::vector<std::size_t> column;
  for (const std::string& name : columns) column.push_back(column_of(reader, name));
  // A row of units: none of the columns asked for holds a number, each of them names a unit.
  bool pending = reader.next();
  std::vector<std::string> below(reader.header().size());
  if (pending && std::all_of(column.begin(), column.end(), [&](std::size_t c) {
        return !unit_of_cell(reader.cell(c)).empty();
      })) {
    for (std::size_t c = 0; c < below.size(); ++c) {
      const std::string text{reader.cell(c)};
      below[c] = text.find('+') != std::string::npos ? text : unit_of_cell(text);
    }
    pending = false;
  }
  std::vector<double> metre;
  for (const std::size_t c : column)
    metre.push_back(metres(reader.header()[c], below[c], source.unit, "--unit"));
  const auto positions = positions_of(source, reader, below);
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
                      .header = reader.header()[column[i]]},
        [&sinks, &records, i](std::span<const double> piece) { sinks[i](piece, *records[i]); });
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
  std::vector<double> numbers(plain.size() * block), at(positions ? block : 0), height(block);
  std::size_t unreported = 0, empty = 0;
  const auto add = [&](std::size_t i, std::size_t rows) {
    const std::span heights{height.data(), rows};
    try {
      if (positions)
        records[i]->add({at.data(), rows}, heights);
      else
        records[i]->add(heights);
    } catch (const InputError& error) {
      throw InputError{table::quoted_name(source.file) + ", " + quoted(reader.header()[column[i]]) +
                       ": " + error.what()};
    }
  };
  while (true) {
    std::size_t rows = pending || !where.all() ? 0 : reader.numbers(plain, numbers);
    const bool all_plain = rows > 0;
    if (!all_plain && !pending && !reader.next()) break;
    pending = false;
    if (!all_plain) rows = 1;
    if (!all_plain && is_empty_row(reader)) {
      empty += positions ? 0 : 1;
      continue;
    }
    if (!all_plain && !where.fits()) continue;
    if (all_plain && positions && positions->in_two) {
      throw InputError{table::quoted_name(source.file) + ", line " + std::to_string(reader.line()) +
                       ": " + quoted(reader.header()[positions->columns[0]]) +
                       " holds a plain number; allowed: 12+345, as its unit says"};
    }
    for (; empty > 0; --empty) {
      height[0] = lost;
      for (std::size_t i = 0; i < columns.size(); ++i) add(i, 1);
    }
    std::fill_n(at.begin(), positions ? rows : 0, 0.0);
    if (positions && !all_plain) at[0] = cells.position(*positions);
    for (std::size_t i = 0; all_plain && i < position_at.size(); ++i) {
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
      if (!all_plain) height[0] = cells.height(column[i]) * metre[i];
      for (std::size_t r = 0; all_plain && r < rows; ++r)
        height[r] = cells.unless_missing(from[r]) * metre[i];
      add(i, rows);
    }
    unreported += rows;
    if (!source.progress || unreported < 16 * block || reader.share() < 0) continue;
    source.progress(reader.share());
    unreported = 0;
  }
  std::vector<std::unique_ptr<const RecordStream>> result;
  where.require_found();
  for (std::size_t i = 0; i < records.size(); ++i) {
    try {
      records[i]->finish();
    } catch (const InputError& error) {
      throw InputError{table::quoted_name(source.file) + ", " + quoted(reader.header()[column[i]]) +
                       ": " + error.what()};
    }
    result.push_back(std::move(records[i]));
  }
  return result;
}

std::unique_ptr<const RecordStream> read_record(const RecordFile& source, const RecordSink& sink) {
  return std::move(read_records(source, {source.column}, {sink}).front());
}

}  // namespace railbook::records
