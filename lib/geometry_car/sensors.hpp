// What sensor and converter add to a clean channel.
#pragma once

#include <array>
#include <cstdint>

#include <railbook/geometry_car/car.hpp>
#include <railbook/geometry_car/record.hpp>

namespace railbook::geometry_car {

// SI, in the unit of the channel; zeros are a perfect sensor.
struct SensorError {
  double bias = 0;
  double scale = 0;    // relative error of the gain
  double density = 0;  // of white noise ahead of the analog filter, unit/sqrt(Hz), one-sided
  double scatter = 0;  // standard deviation of white noise behind it, one value a sample
  double range = 0;    // the converter clips at plus and minus this; 0: it does not
  double step = 0;     // of the converter; 0: none. 12 bits over +-1 g: 2 g/4096
};

struct Sensors {
  std::array<SensorError, channels> errors = {};
  SensorError& operator[](Channel c) { return errors[static_cast<std::size_t>(c)]; }
  const SensorError& operator[](Channel c) const { return errors[static_cast<std::size_t>(c)]; }
};

// An instrument of the time of the paper (ours: it gives no sensor data): accelerometers 20
// ug/sqrt(Hz), 1 mg of bias and 12 bits over
// +-1 g; gyros 0.005 deg/s and 0.005 deg/s/sqrt(Hz); displacement steps of 0.1 mm.
Sensors typical_sensors();

// Adds the errors: gain, noise through the analog filter (a process exact for any interval), bias,
// clipping, step. The same seed gives the same noise. Throws InputError when a density, scatter,
// range or step is negative.
Record measured(const Record& clean, const Layout& layout, const Sensors& sensors,
                std::uint64_t seed);

}  // namespace railbook::geometry_car
