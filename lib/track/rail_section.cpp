#include "track/rail_section.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "units/input_error.hpp"

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
  for (const auto& s : sections) known += (known.empty() ? "" : ", ") + std::string(s.name);
  throw InputError("rail section \"" + std::string(name) + "\" is not known; known are " + known);
}

}  // namespace railbook::track
