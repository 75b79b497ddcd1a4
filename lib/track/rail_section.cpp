#include <railbook/track/rail_section.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include <railbook/units/input_error.hpp>

namespace railbook::track {
namespace {

constexpr double inch4 = units::inch * units::inch * units::inch * units::inch;
constexpr double pound_per_yard = units::pound / units::yard;

constexpr std::array<RailSection, 4> sections{{
    {"115RE", 65.5 * inch4, 114.4 * pound_per_yard},
    {"119RE", 71.4 * inch4, 118.7 * pound_per_yard},
    {"132RE", 87.9 * inch4, 131.7 * pound_per_yard},
    {"136RE", 94.9 * inch4, 136.0 * pound_per_yard},
}};

// 60E1 of EN 13674-1, formerly UIC60. Mass in makers' tables; the second moment is in an open code
// as 3.037e-5 m^4.
constexpr std::array<RailSection, 2> european{{
    {"60E1", 3038.3e-8, 60.21},
    {"UIC60", 3038.3e-8, 60.21},
}};

bool same_name(std::string_view a, std::string_view b) {
  const auto upper = [](char c) { return std::toupper(static_cast<unsigned char>(c)); };
  return std::ranges::equal(a, b, {}, upper, upper);
}

}  // namespace

std::span<const RailSection> rail_sections() {
  return sections;
}

const RailSection& rail_section(std::string_view name) {
  const auto found =
      std::ranges::find_if(sections, [&](const auto& s) { return same_name(s.name, name); });
  if (found != sections.end()) return *found;
  std::string known;
  for (const auto& s : sections) known += std::string(s.name) + ", ";
  for (const auto& s : european) {
    if (same_name(s.name, name)) return s;
    known += (&s == european.data() ? "" : ", ") + std::string(s.name);
  }
  throw InputError("rail section \"" + std::string(name) + "\" is not known; known are " + known);
}

}  // namespace railbook::track
