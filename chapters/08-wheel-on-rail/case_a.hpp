// Case A2.2 of the Manchester benchmark: its inputs, and the numbers CONTACT gives.
#pragma once

#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/wheel_contact/wheel.hpp>

namespace railbook::wheel_on_rail_chapter {

constexpr double rail_origin = 0.7605326;  // of the rail's profile from the middle of the track [m]

struct Wheel {
  std::string key;
  double side = 1;  // 1 right, -1 left
  double y = 0;     // [m]
  double roll = 0, angular_velocity = 0;
  double normal = 0, p_max = 0, fx = 0, fy = 0;  // as published: N, MPa
};

// The "left" or "right" wheel at a shift of so many millimetres.
inline Wheel wheel_of(const table::CsvTable& t, const std::string& side, int shift) {
  const std::string key = side + "-" + std::to_string(shift);
  const auto number = [&](const char* column) {
    return std::strtod(t.at(key, column).c_str(), nullptr);
  };
  return {key,
          side == "right" ? 1.0 : -1.0,
          shift * units::millimetre,
          1e-6 * number("roll_urad"),
          number("angular_velocity_rad_per_s"),
          number("normal"),
          number("p-max"),
          number("fx"),
          number("fy")};
}

inline std::vector<Wheel> wheels(const table::CsvTable& t) {
  std::vector<Wheel> all;
  for (const char* side : {"left", "right"})
    for (int shift = 0; shift <= 10; ++shift) all.push_back(wheel_of(t, side, shift));
  return all;
}

inline const wheel_contact::ProfilePair& pair() {
  static const auto p = wheel_contact::s1002_on_60e1(1.0 / 40, profiles::Rail60::benchmark);
  return p;
}

inline wheel_contact::WheelInput wish_of(const Wheel& wheel, wheel_contact::Method method,
                                         long cells = 40) {
  wheel_contact::WheelInput input;
  input.load = 10 * units::kilonewton, input.speed = 2,
  input.angular_velocity = wheel.angular_velocity;
  input.wheel = input.rail = {2 * 82e9 * 1.28, 0.28};
  input.method = method, input.along = input.across = cells;
  return input;
}

// Of the right wheel, or of the left one in the mirror.
inline wheel_contact::Pose pose_of(const Wheel& wheel) {
  const wheel_contact::Pose pose{wheel.y, 2.4 * wheel.y, wheel.roll};
  return wheel.side < 0 ? wheel_contact::mirrored(pose) : pose;
}

inline wheel_contact::WheelResult solve(const Wheel& wheel, wheel_contact::Method method,
                                        long cells = 40) {
  return wheel_contact::solve_wheel(pair(), pose_of(wheel), wish_of(wheel, method, cells));
}

// The same, once for all items.
inline const wheel_contact::WheelResult& solved(const Wheel& wheel, wheel_contact::Method method) {
  static std::map<std::pair<std::string, wheel_contact::Method>, wheel_contact::WheelResult> all;
  const auto key = std::pair{wheel.key, method};
  const auto known = all.find(key);
  return known != all.end() ? known->second : all.emplace(key, solve(wheel, method)).first->second;
}

}  // namespace railbook::wheel_on_rail_chapter
