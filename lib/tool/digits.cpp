#include <railbook/tool/digits.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace railbook::tool {
namespace {

// The power of ten of the first digit that is left after rounding to `digits`: 9.996 has 1 with
// three.
int first_place(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  return std::stoi(text.substr(text.find('e') + 1));
}

double number(const std::string& text) {
  return std::strtod(text.c_str(), nullptr);
}

std::string with_places(double value, int digits) {
  if (value == 0) return "0";
  const int size = first_place(value, digits);
  if (size < -4 || size > 6) return fmt::format("{:.{}e}", value, digits - 1);
  // Before the point as well: what is beyond the digits is zero.
  return fmt::format("{:.{}f}", number(fmt::format("{:.{}e}", value, digits - 1)),
                     std::max(0, digits - 1 - size));
}

}  // namespace

std::string to_significant(double value, int digits) {
  std::string text = with_places(value, digits);
  const auto point = text.find('.');
  const bool exact = std::abs(number(text) - value) <= 1e-12 * std::abs(value);
  if (point == std::string::npos || !exact) return text;
  const auto power = std::min(text.find('e'), text.size());
  auto end = text.find_last_not_of('0', power - 1) + 1;
  if (end == point + 1) --end;
  return text.erase(end, power - end);
}

std::string to_text(double value) {
  constexpr double largest_whole = 1e9;
  if (value == std::round(value) && std::abs(value) < largest_whole)
    return fmt::format("{:.0f}", value == 0 ? 0 : value);
  return to_significant(value, 4);
}

std::string to_digits_of(double value, double error) {
  if (!(error > 0) || std::isinf(error)) return to_text(value);
  const int place = first_place(error, 1);
  if (value == 0) return "0";
  const int digits = std::clamp(first_place(value, 7) - place + 1, 1, 7);
  // Rounding may add a digit: 9.97 +- 0.1 is 10.0.
  const bool grows = digits < 7 && first_place(value, digits) > first_place(value, 7);
  return with_places(grows ? number(fmt::format("{:.{}e}", value, digits - 1)) : value,
                     grows ? digits + 1 : digits);
}

std::string with_error(double value, double error) {
  if (!(error > 0) || std::isinf(error)) return to_digits_of(value, error);
  return fmt::format("{} +- {}", to_digits_of(value, error), to_significant(error, 1));
}

}  // namespace railbook::tool
