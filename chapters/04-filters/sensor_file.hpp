// A record of the car's sensors from a CSV file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry_car/record.hpp"

namespace railbook::filters {

inline constexpr std::size_t long_still = 200;  // equal samples in a row that no rounding explains

// What the record lacks or does wrong, besides what Measurement says.
struct Faults {
  std::vector<std::string> absent, stuck;
  std::size_t beyond = 0;  // values no sensor can have
};

// Reads the file in constant memory but for the record itself; `sample` (m) is the distance between rows, `first` becomes the
// distance (m) of mark 0. Throws InputError naming the column or the line that cannot be used.
geometry_car::Record read_sensors(const std::filesystem::path& file, double sample, Faults& faults,
                                  double& first);

}  // namespace railbook::filters
