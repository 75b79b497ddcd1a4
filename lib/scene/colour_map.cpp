#include <railbook/scene/colour_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::scene {
namespace {

constexpr std::array<std::array<int, 3>, 10> table = {{{0x44, 0x01, 0x54},
                                                       {0x48, 0x28, 0x78},
                                                       {0x3E, 0x4A, 0x89},
                                                       {0x31, 0x68, 0x8E},
                                                       {0x26, 0x82, 0x8E},
                                                       {0x1F, 0x9E, 0x89},
                                                       {0x35, 0xB7, 0x79},
                                                       {0x6D, 0xCD, 0x59},
                                                       {0xB4, 0xDE, 0x2C},
                                                       {0xFD, 0xE7, 0x25}}};

Colour entry(std::size_t i) {
  return Colour(table[i][0], table[i][1], table[i][2]) / 255.0;
}

}  // namespace

Colour viridis(double value, double low, double high) {
  units::require_finite("value to colour", value);
  units::require_finite("lower end of the colours", low);
  units::require_finite("upper end of the colours", high);
  units::require_positive("span of the colours", high - low);
  constexpr std::size_t last = table.size() - 1;
  const double place = last * std::clamp((value - low) / (high - low), 0.0, 1.0);
  const double below = std::floor(place);
  const auto i = static_cast<std::size_t>(below);
  return entry(i) + (place - below) * (entry(std::min(i + 1, last)) - entry(i));
}

Points viridis(const Eigen::VectorXd& values, double low, double high) {
  Points colours(values.size(), 3);
  for (Eigen::Index i = 0; i < values.size(); ++i) colours.row(i) = viridis(values[i], low, high);
  return colours;
}

}  // namespace railbook::scene
