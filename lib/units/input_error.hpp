// The one exception for bad input, and the checks that throw it.
#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace railbook {

// Bad input from outside: a file, an option, an argument. A chapter program turns it into a
// one-line message and exit status 2. The text names the quantity, the value, its unit and the
// allowed range; it is made printable (units/printable.hpp), and is not longer than 2,000 bytes.
// Long values are better cut where they are quoted.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string_view text);
};

namespace units {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

// Returns `value` if it is finite and lies in [low, high]; throws InputError naming `quantity`, the
// value, `unit` (of the value as given, SI in physics code) and the range otherwise. NaN never
// passes.
double require_between(std::string_view quantity, double value, double low, double high,
                       std::string_view unit = "");

// As require_between, for (0, infinity) and [0, infinity).
double require_positive(std::string_view quantity, double value, std::string_view unit = "");
double require_non_negative(std::string_view quantity, double value, std::string_view unit = "");

// Throws InputError when `value` is NaN or infinite.
double require_finite(std::string_view quantity, double value, std::string_view unit = "");

}  // namespace units
}  // namespace railbook
