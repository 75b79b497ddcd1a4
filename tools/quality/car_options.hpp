// The options of a vehicle, shared by the tools. Its defaults are the vehicle and the limits of
// Corbin and Fazio.
#pragma once

#include <optional>
#include <string>

#include <railbook/quality/descriptor.hpp>
#include <railbook/tool/options.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::quality_tool {

inline constexpr double cm = 0.01;
inline constexpr double kmh = units::kilometre_per_hour;
inline constexpr double kN = units::kilonewton;

struct CarOptions {
  double speed = 0;
  std::string mode = "auto";
  quality::Suspension roll{.frequency = 0.5, .damping = 0.2};  // SI, as all below
  std::optional<double> level, stroke;
  std::optional<double> wheel_mass, body_mass, stiffness, damping, bounce_frequency, bounce_damping;
  double wheel_force = 143 * units::kilonewton;
};

void add_car_options(tool::OptionParser& parser, CarOptions& options);

// The descriptor asked for. Throws InputError when data of the mode are missing, given twice, or
// leave no amplitude.
quality::Descriptor descriptor(const CarOptions& options);

// Speed, limits and corners as lines of the answer.
void add_car(tool::Summary& answer, const quality::Descriptor& descriptor);

}  // namespace railbook::quality_tool
