// Can the sensors be believed? What a record says of itself, before any geometry is made of it.
//
//   Record record = ...;
//   const Health health = examine(record, processing);     // masks what is certainly wrong
//   const Measurement m = reconstruct(record, processing);
//   quality(m, Parameter::gage, processing, health);       // a row under a doubt is not good
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/record.hpp>

namespace railbook::geometry_car {

enum class Fault {
  dead,          // a channel without a value
  still,         // the same value over more rows than its rounding explains; masked
  jump,          // single values that its filter, or a rail, cannot give; masked
  step,          // its zero moved
  level,         // a mean that no track and no car explains
  scale,         // the other sensors say that it is some factor off: a unit, a sign, a gain
  inconsistent,  // sensors contradict each other, and none of them alone explains it
  clock,         // the time between rows cannot be
  place,         // the distance stands still, or moves by more than the rows can
};
inline constexpr std::size_t faults = 9;
const char* name_of(Fault fault);  // "dead", "still" ...

struct Finding {
  Fault fault;
  std::string what;       // "vertical_left", "elapsed", "roll_rate" ...
  std::size_t first = 0;  // row of the record where it begins
  std::size_t rows = 0;   // that it concerns
  double size = 0;        // of the largest jump or step, of the mean (SI), or the factor; else 0
  std::string text;       // for people
};

struct Health {
  std::vector<Finding> findings;
  // Rows not to be trusted: of a channel altogether, or for its mean only (a moved zero); because
  // of the distance, or of the time, which the gage does not need.
  std::array<std::vector<char>, channels> doubted, zero_doubted;
  std::vector<char> place_doubted, clock_doubted;
};

// What a stretch of a longer record knows of the one before it: by how much each channel's zero has
// moved in the run that goes on, the largest of these moves, and whether the speed has leapt.
struct ChannelOffsets {
  std::array<double, channels> moved{}, largest{};
  bool leapt = false;
};

// Judges every channel by itself (robust statistics of its differences, against the record's own),
// and against the others: the inclinometer, both gyros, the accelerometers, heights and sways feel
// the same motion of the body. Values that stand still or jump are masked in `record`. Detected, on
// the default car with typical sensors above 15 mph: a sensor that stands still for 40 rows, a
// spike or a step of 0.05 m/s^2, 0.5 deg/s or 5 mm, a gain off by two, any unit off by its factor,
// a sign where the track moves the sensor at all. On clean records of the simulation fewer than 1
// in 1,000 give a finding. Throws InputError as `reconstruct`.
//
// `carried`: of the run that row 0 goes on with; comes back as it is at row `at`.
Health examine(Record& record, const Processing& processing);
Health examine(Record& record, const Processing& processing, ChannelOffsets& carried,
               std::size_t at);

// As quality(), and nothing that depends on a doubted row is better than unreliable.
std::vector<Quality> quality(const Measurement& measurement, Parameter parameter,
                             const Processing& processing, const Health& health);

}  // namespace railbook::geometry_car
