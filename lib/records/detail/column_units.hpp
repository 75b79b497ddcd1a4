#pragma once

#include <string>
#include <string_view>

#include <railbook/units/quantity.hpp>

namespace railbook::records {

// column "NAME", as errors name it.
std::string quoted(const std::string& name);

// The unit that a header names. "level in mm" is no product; a length behind a number is a chord or
// a wave, "profile_62_ft", but for a small number before a small unit: "rail_1_mm".
units::Header header_of(const std::string& text);

// A cell of units in the first row, of a length or another dimension: "mm", "[mm]"; empty where it
// is none.
std::string unit_of_cell(std::string_view cell, const units::Dimension& dimension = units::length);

// What one cell of a column is in metres, or in SI units of another dimension: by its header or the
// row of units under it, or else by what the option named says.
double metres(const std::string& header, const std::string& below, const std::string& given,
              const std::string& option, const units::Dimension& dimension = units::length);

}  // namespace railbook::records
