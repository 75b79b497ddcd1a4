// What the car brings home: the channels of all sensors, one row a foot of travel.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <railbook/units/quantity.hpp>

namespace railbook::geometry_car {

// The sensors of the paper. The encoder is the record's `elapsed`.
enum class Channel {
  vertical_left,  // accelerometers in the body above the measuring axle, less gravity, m/s^2
  vertical_right,
  lateral,       // accelerometer on the truck's beam, m/s^2
  inclinometer,  // lateral accelerometer on the floor above the measuring axle, m/s^2
  yaw_rate,      // gyros in the body, rad/s
  roll_rate,
  height_left,  // body over axle, m
  height_right,
  sway_front_a,  // body to truck, lateral, m: two at the front truck, one at the rear
  sway_front_b,
  sway_rear,
  gage_left,  // beam to gage face, 5/8 in below the top of the rail, m
  gage_right,
};
inline constexpr std::size_t channels = 13;

struct ChannelInfo {
  Channel channel;
  std::string_view name;  // as in the header of a file, without the unit
  units::Dimension dimension;
  std::string_view unit;  // of the file
  double si;              // one of it
  int filter;             // order of the analog filter before the converter: 0, 1 (B) or 2 (F)
};
const std::array<ChannelInfo, channels>& channel_list();

struct Record {
  std::vector<double>
      elapsed;  // s since the row before (time between samples); the first one from the start
  std::vector<long>
      mark;  // number of the foot mark, up or down by one a row; a repeated mark is a reversal
  std::array<std::vector<double>, channels> values;

  std::size_t size() const { return mark.size(); }
  std::vector<double>& operator[](Channel c) { return values[static_cast<std::size_t>(c)]; }
  const std::vector<double>& operator[](Channel c) const {
    return values[static_cast<std::size_t>(c)];
  }
};

}  // namespace railbook::geometry_car
