// Quantities with units as text: "0.5in", "60 mph", "80kN", "1500 lbf/in^2" to SI doubles,
// dimension checked.
#pragma once

#include <string>
#include <string_view>

namespace railbook::units {

// Exponents of the base dimensions. Angle is kept apart so that a bare number is never taken for
// degrees.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int angle = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

constexpr Dimension operator*(Dimension a, Dimension b) {
  return {a.length + b.length, a.mass + b.mass, a.time + b.time, a.angle + b.angle};
}
constexpr Dimension operator/(Dimension a, Dimension b) {
  return {a.length - b.length, a.mass - b.mass, a.time - b.time, a.angle - b.angle};
}

inline constexpr Dimension number{};
inline constexpr Dimension length{1, 0, 0, 0};
inline constexpr Dimension mass{0, 1, 0, 0};
inline constexpr Dimension time{0, 0, 1, 0};
inline constexpr Dimension angle{0, 0, 0, 1};
inline constexpr Dimension area = length * length;
inline constexpr Dimension volume = area * length;
inline constexpr Dimension speed = length / time;
inline constexpr Dimension acceleration = speed / time;
inline constexpr Dimension frequency = number / time;
inline constexpr Dimension wavenumber = number / length;  // cycles per length
inline constexpr Dimension force = mass * acceleration;
inline constexpr Dimension moment = force * length;
inline constexpr Dimension pressure = force / area;  // also track modulus, lbf/in per in
inline constexpr Dimension stiffness = force / length;
inline constexpr Dimension damping = stiffness * time;
inline constexpr Dimension subgrade_modulus = pressure / length;  // lbf/in^3
inline constexpr Dimension mass_per_length = mass / length;
inline constexpr Dimension density = mass / volume;
inline constexpr Dimension second_moment_of_area = area * area;

// A unit: what one of it is in SI, and its dimension.
struct Unit {
  double si = 1.0;
  Dimension dimension;
};

// Reads a unit such as "mm", "lbf/in^2", "N*s/m" or "1/m": names joined by * and /, each with an
// optional whole power; the empty text is the pure number. Names: m mm um cm km in ft yd mi, kg g t
// lb slug, s ms min h, N kN MN lbf kip, Pa kPa MPa GPa psi ksi, Hz kHz, mph kph kmh fps, rad mrad
// deg, cycle cycles % percent 1. "lb" is a mass; a force is "lbf"; "1/s" is the dimension of Hz.
// Throws InputError naming the part it does not know, and where a unit, read from the left, goes
// beyond 1e-60 to 1e60 in SI or the power of a dimension beyond 20. Accurate to 1e-15 for each
// power of each name.
Unit parse_unit(std::string_view text);

// Reads a number followed by its unit and returns the SI value; a pure number may be a ratio,
// "1:40". A missing unit, a unit of another dimension, trailing text, two signs, NaN, infinity, or
// a value that overflows or underflows as written or in SI throws InputError naming `quantity` and
// a fitting unit. Accurate as its unit.
double parse_quantity(std::string_view quantity, std::string_view text, const Dimension& expected);

// The SI unit of a dimension as text, "kg/s^2" style, with the common names (m, N, Pa, N/m, ...)
// where one fits; with powers up to 8 parse_unit() reads it back, but for "1 (a pure number)".
std::string si_name(const Dimension& dimension);

// A column header of a CSV file names its unit after the last underscore: "distance_m" is
// {"distance", metre}. In such a suffix "_per_" is a division and a digit after a name a power
// ("p_lbf_per_in2"). Only the longest suffix, of up to 60 characters, that reads as a unit counts;
// a header without one has an empty `unit_text` and the pure number.
struct Header {
  std::string name;
  std::string unit_text;
  Unit unit;
};
Header parse_header(std::string_view header);

}  // namespace railbook::units
