// The options of a vehicle, shared by the tools.
#pragma once

#include <optional>
#include <string>

#include "items.hpp"
#include "report/options.hpp"
#include "report/summary.hpp"

namespace quality_chapter {

struct CarWish {
  double speed = 0;
  std::string mode = "auto";
  railbook::quality::Suspension roll = quality_chapter::roll;
  std::optional<double> level, stroke;
  std::optional<double> wheel_mass, body_mass, stiffness, damping, bounce_frequency, bounce_damping;
  double wheel_force = wheel_force_limit;
};

void add_car_options(railbook::report::Options& options, CarWish& wish);

// The descriptor asked for. Throws InputError when data of the mode are missing, given twice, or leave no amplitude.
railbook::quality::Descriptor descriptor(const CarWish& wish);

// Speed, limits and corners as lines of the answer.
void add_car(railbook::report::Summary& answer, const railbook::quality::Descriptor& descriptor);

}  // namespace quality_chapter
