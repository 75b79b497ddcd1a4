#include <railbook/units/quantity.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::units {
namespace {

struct Named {
  std::string_view name;
  Unit unit;
};

constexpr auto names = std::to_array<Named>({
    {"m", {1, length}},
    {"mm", {millimetre, length}},
    {"um", {micrometre, length}},
    {"cm", {1e-2, length}},
    {"km", {kilometre, length}},
    {"in", {inch, length}},
    {"ft", {foot, length}},
    {"yd", {yard, length}},
    {"mi", {mile, length}},
    {"kg", {1, mass}},
    {"g", {1e-3, mass}},
    {"t", {1e3, mass}},
    {"lb", {pound, mass}},
    {"slug", {slug, mass}},
    {"s", {1, time}},
    {"ms", {1e-3, time}},
    {"min", {60, time}},
    {"h", {hour, time}},
    {"N", {1, force}},
    {"kN", {1e3, force}},
    {"MN", {1e6, force}},
    {"lbf", {lbf, force}},
    {"kip", {kip, force}},
    {"Pa", {1, pressure}},
    {"kPa", {1e3, pressure}},
    {"MPa", {1e6, pressure}},
    {"GPa", {1e9, pressure}},
    {"psi", {psi, pressure}},
    {"ksi", {ksi, pressure}},
    {"Hz", {1, frequency}},
    {"kHz", {1e3, frequency}},
    {"mph", {mph, speed}},
    {"kph", {kilometre_per_hour, speed}},
    {"kmh", {kilometre_per_hour, speed}},
    {"fps", {foot, speed}},
    {"rad", {1, angle}},
    {"mrad", {1e-3, angle}},
    {"deg", {degree, angle}},
    {"cycle", {1, number}},
    {"cycles", {1, number}},
    {"%", {1e-2, number}},
    {"percent", {1e-2, number}},
    {"1", {1, number}},
});

std::optional<Unit> find(std::string_view name) {
  for (const Named& n : names)
    if (n.name == name) return n.unit;
  return std::nullopt;
}

std::string all_names() {
  std::string all;
  for (const Named& n : names) all += (all.empty() ? "" : " ") + std::string{n.name};
  return all;
}

// Far beyond any quantity of this world, and far from where a double or a power of it overflows.
bool sane(const Unit& unit) {
  const auto small = [](int power) { return std::abs(power) <= 20; };
  const Dimension& d = unit.dimension;
  return unit.si > 1e-60 && unit.si < 1e60 && small(d.length) && small(d.mass) && small(d.time) &&
         small(d.angle);
}

// One factor: a name with an optional whole power, "in^3", "in3" or "s".
std::optional<Unit> factor(std::string_view text) {
  if (auto plain = find(text)) return plain;
  if (text.empty() || text.back() < '1' || text.back() > '9') return std::nullopt;
  const int power = text.back() - '0';
  text.remove_suffix(1);
  if (!text.empty() && text.back() == '^') text.remove_suffix(1);
  const auto base = find(text);
  if (!base) return std::nullopt;
  Unit unit;
  for (int i = 0; i < power; ++i) {
    unit.si *= base->si;
    unit.dimension = unit.dimension * base->dimension;
  }
  return unit;
}

std::string_view trim(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

Unit parse_unit(std::string_view text) {
  text = trim(text);
  Unit unit;
  if (text.empty()) return unit;
  const std::string quoted = "unit \"" + printable(text) + "\"";
  if (text.front() == '/' || text.front() == '*')
    throw InputError{quoted + " begins with " + text.front() +
                     "; allowed: a name, or 1 before a division (\"1/m\")"};
  bool divide = false;
  while (true) {
    const std::size_t cut = text.find_first_of("*/");
    const std::string_view name = trim(text.substr(0, cut));
    if (name.empty()) throw InputError{quoted + " lacks a name after * or /"};
    const auto one = factor(name);
    if (!one) {
      throw InputError{quoted + ": \"" + printable(name) + "\" is not a known unit; known are " +
                       all_names()};
    }
    unit.si = divide ? unit.si / one->si : unit.si * one->si;
    unit.dimension = divide ? unit.dimension / one->dimension : unit.dimension * one->dimension;
    if (!sane(unit))
      throw InputError{quoted +
                       " is out of range; allowed: from 1e-60 to 1e60 in SI, powers to 20"};
    if (cut == std::string_view::npos) return unit;
    divide = text[cut] == '/';
    text.remove_prefix(cut + 1);
  }
}

double parse_quantity(std::string_view quantity, std::string_view text, const Dimension& expected) {
  text = trim(text);
  const std::string quoted = std::string{quantity} + " is \"" + printable(text) + "\"";
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool two_signs = text.starts_with("+-");
  if (status == std::errc::result_out_of_range || std::fpclassify(value) == FP_SUBNORMAL)
    throw InputError{quoted +
                     ", which a double cannot hold; allowed: 0, or 1e-307 to 1e308 in size"};
  if (status != std::errc{} || !std::isfinite(value) || two_signs)
    throw InputError{quoted + "; allowed: a finite number with a unit of " + si_name(expected)};
  const auto rest = trim({end, static_cast<std::size_t>(digits.data() + digits.size() - end)});
  if (rest.starts_with(':') && expected == number) {  // a ratio, as slopes are written: 1:40
    const double below = parse_quantity(quantity, rest.substr(1), number);
    if (!(below > 0)) throw InputError{quoted + "; allowed: a ratio to a number greater than 0"};
    return value / below;
  }
  if (rest.empty() && !(expected == number))
    throw InputError{quoted + ", without a unit; allowed: a unit of " + si_name(expected)};
  Unit unit;
  try {
    unit = parse_unit(rest);
  } catch (const InputError& error) {
    throw InputError{quoted + "; " + error.what()};
  }
  if (!(unit.dimension == expected)) {
    throw InputError{quoted + ", a quantity in " + si_name(unit.dimension) +
                     "; allowed: a unit of " + si_name(expected)};
  }
  const double si = value * unit.si;
  if (!std::isfinite(si) || (value != 0 && !std::isnormal(si)))
    throw InputError{quoted + ", which a double cannot hold in " + si_name(expected)};
  return si;
}

std::string si_name(const Dimension& d) {
  constexpr std::array<std::pair<Dimension, std::string_view>, 4> common{
      {{number, "1 (a pure number)"}, {pressure, "Pa"}, {frequency, "Hz"}, {angle, "rad"}}};
  for (const auto& [dimension, name] : common)
    if (d == dimension) return std::string{name};
  std::string over;
  std::string under;
  const auto add = [&](std::string_view name, int power) {
    if (power == 0) return;
    std::string& side = power > 0 ? over : under;
    const int size = std::abs(power);
    if (power > 0 && !side.empty()) side += "*";
    if (power < 0) side += "/";
    side += name;
    if (size > 1) side += "^" + std::to_string(size);
  };
  // A force over or times something: N*m/rad, not kg*m^2/s^2/rad.
  const bool forceful = d.mass == 1 && d.time < 0;
  const Dimension rest = forceful ? d / force : d;
  if (forceful) over = "N";
  add("kg", rest.mass);
  add("m", rest.length);
  add("s", rest.time);
  add("rad", rest.angle);
  return (over.empty() ? "1" : over) + under;
}

Header parse_header(std::string_view header) {
  header = trim(header);
  constexpr std::size_t longest = 60;  // of a suffix: a header that goes on for pages costs no more
  const std::size_t begin = header.size() - std::min(header.size(), longest + 1);
  // Try the longest suffix first: "p_lbf_per_in2" has the unit lbf/in^2, not in^2.
  for (std::size_t cut = header.find('_', begin); cut != std::string_view::npos;
       cut = header.find('_', cut + 1)) {
    std::string unit_text{header.substr(cut + 1)};
    for (std::size_t at; (at = unit_text.find("_per_")) != std::string::npos;)
      unit_text.replace(at, 5, "/");
    for (std::size_t at; (at = unit_text.find('_')) != std::string::npos;)
      unit_text.replace(at, 1, "*");
    if (unit_text.starts_with("per*")) unit_text.replace(0, 4, "1/");
    try {
      const Unit unit = parse_unit(unit_text);
      if (!unit_text.empty() && unit_text != "1")
        return {std::string{header.substr(0, cut)}, unit_text, unit};
    } catch (const InputError&) {
      continue;
    }
  }
  return {std::string{header}, "", Unit{}};
}

}  // namespace railbook::units
