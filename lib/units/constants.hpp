// Unit constants: multiply by one to come in to SI, divide by it to go out.
//
//   const double delta = 0.0004 * units::inch;          // metres inside
//   table.value(force / units::lbf);                    // pounds at the edge
//
// Exact by definition (BIPM SI brochure; NIST SP 811) unless marked.
#pragma once

#include <numbers>

namespace railbook::units {

inline constexpr double pi = std::numbers::pi;

inline constexpr double metre = 1.0;
inline constexpr double millimetre = 1e-3;
inline constexpr double micrometre = 1e-6;
inline constexpr double kilometre = 1e3;
inline constexpr double inch = 0.0254;
inline constexpr double foot = 12 * inch;
inline constexpr double yard = 3 * foot;
inline constexpr double mile = 5280 * foot;

inline constexpr double second = 1.0;
inline constexpr double millisecond = 1e-3;
inline constexpr double hour = 3600.0;
inline constexpr double kilometre_per_hour = kilometre / hour;
inline constexpr double mph = mile / hour;

inline constexpr double standard_gravity = 9.80665;

inline constexpr double kilogram = 1.0;
inline constexpr double pound = 0.45359237;
inline constexpr double newton = 1.0;
inline constexpr double kilonewton = 1e3;
inline constexpr double lbf = pound * standard_gravity;
inline constexpr double kip = 1e3 * lbf;
inline constexpr double slug = lbf / foot;              // lbf s^2 / ft
inline constexpr double inch_system_mass = lbf / inch;  // lbf s^2 / in

inline constexpr double pascal = 1.0;
inline constexpr double megapascal = 1e6;
inline constexpr double gigapascal = 1e9;
inline constexpr double psi = lbf / (inch * inch);
inline constexpr double ksi = 1e3 * psi;

inline constexpr double degree = pi / 180.0;

}  // namespace railbook::units
