#include <railbook/geometry_car/record.hpp>

#include <railbook/units/constants.hpp>

namespace railbook::geometry_car {

const std::array<ChannelInfo, channels>& channel_list() {
  using enum Channel;
  constexpr units::Dimension rate = units::angle / units::time;
  constexpr double mm = units::millimetre, degree = units::degree;
  static const std::array<ChannelInfo, channels> list{{
      {vertical_left, "vertical_left", units::acceleration, "m_per_s2", 1, 2},
      {vertical_right, "vertical_right", units::acceleration, "m_per_s2", 1, 2},
      {lateral, "lateral", units::acceleration, "m_per_s2", 1, 2},
      {inclinometer, "inclinometer", units::acceleration, "m_per_s2", 1, 2},
      {yaw_rate, "yaw_rate", rate, "deg_per_s", degree, 1},
      {roll_rate, "roll_rate", rate, "deg_per_s", degree, 1},
      {height_left, "height_left", units::length, "mm", mm, 0},
      {height_right, "height_right", units::length, "mm", mm, 0},
      {sway_front_a, "sway_front_a", units::length, "mm", mm, 0},
      {sway_front_b, "sway_front_b", units::length, "mm", mm, 0},
      {sway_rear, "sway_rear", units::length, "mm", mm, 0},
      {gage_left, "gage_left", units::length, "mm", mm, 0},
      {gage_right, "gage_right", units::length, "mm", mm, 0},
  }};
  return list;
}

}  // namespace railbook::geometry_car
