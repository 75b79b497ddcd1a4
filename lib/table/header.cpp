// What people write over a column.
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include <railbook/table/csv.hpp>
#include <railbook/table/detail/trim.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/number_text.hpp>

namespace railbook::table {
namespace {

constexpr auto spellings = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"metre", "m"},       {"metres", "m"},          {"meter", "m"},
    {"meters", "m"},      {"millimetre", "mm"},     {"millimetres", "mm"},
    {"millimeter", "mm"}, {"millimeters", "mm"},    {"kilometre", "km"},
    {"kilometres", "km"}, {"kilometer", "km"},      {"kilometers", "km"},
    {"inch", "in"},       {"inches", "in"},         {"in.", "in"},
    {"foot", "ft"},       {"feet", "ft"},           {"ft.", "ft"},
    {"mile", "mi"},       {"miles", "mi"},          {"micron", "um"},
    {"microns", "um"},    {"\xC2\xB5m", "um"},      {"\xCE\xBCm", "um"},
    {"sec", "s"},         {"second", "s"},          {"seconds", "s"},
    {"km/h", "kmh"},      {"degree", "deg"},        {"degrees", "deg"},
    {"\xC2\xB0", "deg"},  {"m/s\xC2\xB2", "m/s^2"}, {"mm/s\xC2\xB2", "mm/s^2"},
});

constexpr auto factors = std::to_array<std::pair<std::string_view, double>>({
    {"1/10", 0.1},
    {"1/100", 0.01},
    {"1/1000", 0.001},
    {"0.1", 0.1},
    {"0,1", 0.1},
    {"0.01", 0.01},
    {"0,01", 0.01},
    {"0.001", 0.001},
    {"0,001", 0.001},
});

constexpr auto divisors = std::to_array<std::pair<std::string_view, double>>(
    {{"/1000", 0.001}, {"/100", 0.01}, {"/10", 0.1}});

// A unit as the project spells it, in letters of either case.
std::optional<std::pair<std::string, units::Unit>> unit_of(std::string_view text) {
  double factor = 1;
  text = trim(text);
  for (const auto& [written, value] : factors)  // "1/10 mm"
    if (factor == 1 && text.starts_with(written) &&
        text.find_first_of("0123456789/.,", written.size()) == text.npos)
      factor = value, text.remove_prefix(written.size());
  for (const auto& [written, value] : divisors)  // "mm/10"
    if (factor == 1 && text.ends_with(written)) factor = value, text.remove_suffix(written.size());
  std::string lower{trim(text)};
  if (lower.empty() || lower.size() > 40) return std::nullopt;
  std::string exact = lower;
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const auto& [spelling, meant] : spellings)
    if (lower == spelling) lower = exact = meant;
  for (const std::string& one : {exact, lower}) {
    try {
      units::Unit unit = units::parse_unit(one);
      if (factor != 1 && !(unit.dimension == units::length)) return std::nullopt;
      unit.si *= factor;
      return std::pair{factor == 1 ? one : units::number_text(factor) + " " + one, unit};
    } catch (const InputError&) {
    }
  }
  return std::nullopt;
}

}  // namespace

units::Header parse_column(std::string_view header) {
  header = trim(header);
  units::Header plain = units::parse_header(header);
  if (!plain.unit_text.empty()) return plain;
  std::optional<std::pair<std::string, units::Unit>> unit;
  std::size_t begin = std::string_view::npos;
  if (header.ends_with(')')) begin = header.rfind('(');
  if (header.ends_with(']')) begin = header.rfind('[');
  if (begin != std::string_view::npos) {
    unit = unit_of(header.substr(begin + 1, header.size() - begin - 2));
  } else {
    // The longest that reads as one behind a comma, a blank, an underscore or a stroke: "Speed,
    // km/h", "Profile / mm".
    begin = header.find_first_of(", _/");
    for (; begin != std::string_view::npos; begin = header.find_first_of(", _/", begin + 1))
      if ((unit = unit_of(header.substr(begin + 1)))) break;
  }
  if (!unit || begin == 0 || unit->first == "1") return plain;
  std::string_view name = trim(header.substr(0, begin));
  while (!name.empty() && (name.back() == ',' || name.back() == '_')) name.remove_suffix(1);
  if (name.ends_with(" in")) name.remove_suffix(3);  // "Distance in metres"
  return {std::string{trim(name)}, unit->first, unit->second};
}

}  // namespace railbook::table
