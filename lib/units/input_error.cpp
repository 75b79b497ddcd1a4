#include <railbook/units/input_error.hpp>

#include <cmath>
#include <cstdio>

#include <railbook/units/printable.hpp>

namespace railbook {

InputError::InputError(std::string_view text) : std::runtime_error(units::printable(text, 2000)) {}

}  // namespace railbook

namespace railbook::units {
namespace {

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

// All text is made in functions of its own: what passes the checks pays for no room for it.
[[noreturn]] void refuse(std::string_view quantity, double value, std::string_view unit,
                         std::string_view allowed) {
  std::string text{quantity};
  text += " is " + short_number(value);
  if (!unit.empty()) text += " " + std::string{unit};
  text += "; allowed: ";
  text += allowed;
  throw InputError{text};
}

[[noreturn]] void refuse_outside(std::string_view quantity, double value, double low, double high,
                                 std::string_view unit) {
  std::string range = "from " + short_number(low) + " to " + short_number(high);
  if (!std::isfinite(high)) range = "at least " + short_number(low);
  if (!std::isfinite(low)) range = "at most " + short_number(high);
  refuse(quantity, value, unit, range);
}

}  // namespace

double require_finite(std::string_view quantity, double value, std::string_view unit) {
  if (!std::isfinite(value)) refuse(quantity, value, unit, "a finite number");
  return value;
}

double require_between(std::string_view quantity, double value, double low, double high,
                       std::string_view unit) {
  if (std::isfinite(value) && value >= low && value <= high) return value;
  refuse_outside(quantity, value, low, high, unit);
}

double require_positive(std::string_view quantity, double value, std::string_view unit) {
  if (std::isfinite(value) && value > 0) return value;
  refuse(quantity, value, unit, "greater than 0, finite");
}

double require_non_negative(std::string_view quantity, double value, std::string_view unit) {
  if (std::isfinite(value) && value >= 0) return value;
  refuse(quantity, value, unit, "0 or greater, finite");
}

}  // namespace railbook::units
