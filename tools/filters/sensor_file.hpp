// A record of the car's sensors from a CSV file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry_car/record.hpp"

namespace railbook::filters_tool {

// What no sensor of this car can say, SI. A spike is a displacement that differs by more than this, and in the same sense, from the
// one before it and the one behind it.
struct Plausible {
  double acceleration = 20, rate = 1, displacement = 1, spike = 0.05;
};

// What the record lacks or does wrong, besides what Measurement says.
struct Faults {
  std::vector<std::string> absent, unused;
  std::size_t beyond = 0, spikes = 0;  // values masked
  std::vector<std::string> beyond_in;  // columns where more than one value in a hundred was
};

// Reads the file in constant memory but for the record itself; `sample` (m) is the distance between rows, `first` becomes the
// distance (m) of mark 0. Throws InputError naming the column or the line that cannot be used.
geometry_car::Record read_sensors(const std::filesystem::path& file, double sample,
                                  const Plausible& plausible, Faults& faults, double& first);

}  // namespace railbook::filters_tool
