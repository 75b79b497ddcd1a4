#include <railbook/records/detail/column_units.hpp>

#include <string_view>

#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::records {
namespace {

// "mm", "inches", "1/10 mm".
units::Unit unit_given(const std::string& text) {
  const units::Header header = table::parse_column("x (" + text + ")");
  return header.unit_text.empty() ? units::parse_unit(text) : header.unit;
}

}  // namespace

std::string quoted(const std::string& name) {
  return "column \"" + units::printable(name) + "\"";
}

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

std::string unit_of_cell(std::string_view cell, const units::Dimension& dimension) {
  if (cell.size() > 2 && (cell.front() == '[' || cell.front() == '('))
    cell = cell.substr(1, cell.size() - 2);
  if (cell.empty() || cell.size() > 40) return "";
  const units::Header header = table::parse_column("x (" + std::string{cell} + ")");
  return header.unit.dimension == dimension ? header.unit_text : "";
}

double metres(const std::string& header, const std::string& below, const std::string& given,
              const std::string& option, const units::Dimension& dimension) {
  const std::string example = dimension == units::length  ? "a length, such as mm"
                              : dimension == units::speed ? "a speed, such as km/h"
                                                          : "an acceleration, such as m/s^2";
  units::Header named = header_of(header);
  if (named.unit_text.empty() && !below.empty()) named = table::parse_column("x (" + below + ")");
  if (given.empty() && named.unit_text.empty())
    throw InputError{quoted(header) + " names no unit; give one with " + option + ": " + example};
  units::Unit unit = given.empty() ? named.unit : unit_given(given);
  // Of accelerations g is that of gravity and no gram.
  if (dimension == units::acceleration && (given.empty() ? named.unit_text : given) == "g")
    unit = {units::standard_gravity, units::acceleration};
  if (!(unit.dimension == dimension))
    throw InputError{quoted(header) + " has the unit " + (given.empty() ? named.unit_text : given) +
                     "; allowed: " + example};
  if (!given.empty() && !named.unit_text.empty() && unit.si != named.unit.si)
    throw InputError{quoted(header) + " is in " + named.unit_text + " by its header, in " + given +
                     " by " + option};
  return unit.si;
}

}  // namespace railbook::records
