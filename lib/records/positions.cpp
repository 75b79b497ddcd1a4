#include <railbook/records/detail/positions.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include <railbook/records/detail/column_units.hpp>
#include <railbook/table/dates.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>
#include <railbook/units/quantity.hpp>

namespace railbook::records {
namespace {

constexpr std::array forms{"km+m", "mi+ft", "mi+yd"};  // of a position in two parts
constexpr const char* miles_and_yards = "mi.yd";       // four digits behind the point

std::pair<std::string, std::string> cut_at_plus(const std::string& text) {
  const std::size_t at = text.find('+');
  if (at == std::string::npos || at == 0 || at + 1 == text.size()) return {text, ""};
  return {text.substr(0, at), text.substr(at + 1)};
}

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

// 12+345.6, K12+345.6 and 12K345.6M: thousands and ones. False when the cell is none of them.
bool kilometres_and_metres(std::string_view cell, double& major, double& minor) {
  if (cell.starts_with('K') || cell.starts_with('k')) cell.remove_prefix(1);
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

// Refuses the position in column `of` of the row last read.
[[noreturn]] void refuse(const table::CsvReader& reader, std::size_t of, const std::string& why) {
  throw InputError{table::quoted_name(reader.file()) + ", line " + std::to_string(reader.line()) +
                   ": position \"" + units::printable(reader.cell(of), 40) + "\" in " +
                   quoted(reader.header()[of]) + "; " + why};
}

// A recorder's clock is no place on the track.
void refuse_time(const table::CsvReader& reader, std::size_t of) {
  if (table::is_date_or_time(reader.cell(of)))
    refuse(reader, of,
           "this is a date or a time; allowed: places along the track, their column named by "
           "--distance, or --distance none with --spacing, such as 25cm, of samples that are even");
}

}  // namespace

double Positions::metres(std::size_t i, double number) const {
  if (!yards) return number * metre[i];
  const double miles = std::floor(number), rest = 1e4 * (number - miles);
  return rest < 1760 ? miles * 1609.344 + std::round(1e6 * rest) / 1e6 * 0.9144
                     : std::numeric_limits<double>::quiet_NaN();
}

std::optional<table::TwoParts> Positions::two_parts() const {
  if (columns.size() != 1 || yards || major == 0) return std::nullopt;
  return table::TwoParts{columns[0], major, minor, in_two ? 0 : metre[0]};
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
    for (const char* name :
         {"position", "chainage", "mileage", "kilometre", "kilometer", "km", "km+m"})
      if (!column) column = find(name);
  if (column) {
    refuse_time(reader, *column);
    return one_column(*column, reader.header()[*column], below[*column], source.distance_unit);
  }
  if (source.spacing) return std::nullopt;
  throw InputError{table::quoted_name(source.file) + ": no " + quoted(source.distance) + "; " +
                   reader.columns_there() +
                   "; allowed: a column of positions (--distance) or --spacing, such as 1ft; "
                   "--skip if lines stand before the headers"};
}

double read_position(const Positions& p, const table::CsvReader& reader, const Cells& cells) {
  double sum = 0;
  for (std::size_t i = 0; i < p.columns.size(); ++i) {
    const std::string_view cell = reader.cell(p.columns[i]);
    double major = 0, minor = 0;
    const bool marked = !cell.empty() && !std::isdigit(static_cast<unsigned char>(cell.back()));
    if (cell.size() > 2 && (marked || cell.find('+', 1) != std::string_view::npos) &&
        kilometres_and_metres(cell, major, minor)) {
      const bool metric = cell.find('+', 1) == std::string_view::npos;
      if (!metric && p.major == 0)
        refuse(reader, p.columns[i],
               "allowed: its two parts in --distance-unit, as mi+ft or mi+yd");
      sum += metric ? 1000 * major + minor : p.major * major + p.minor * minor;
    } else {
      refuse_time(reader, p.columns[i]);
      const double number = [&] {
        try {
          return cells.number(p.columns[i]);
        } catch (const InputError& error) {
          throw InputError{error.what() + std::string{"; places may be written 12+345.6, too"}};
        }
      }();
      if (p.in_two && !std::isnan(number))
        refuse(reader, p.columns[i], "allowed: 12+345, as the unit of this column says");
      const double metres = p.metres(i, number);
      if (std::isnan(metres) && !std::isnan(number))
        refuse(reader, p.columns[i],
               "allowed: miles, and behind the point yards below 1760 in four digits");
      sum += metres;
    }
  }
  return sum;
}

}  // namespace railbook::records
