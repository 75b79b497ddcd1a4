// A file of limits of track geometry: a row a limit, of a channel, a measure of it, a kind of
// value, and a class or a range of speeds.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <railbook/quality/measure.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "quality/deviations.hpp"

namespace railbook::quality_tool {

struct Limit {
  Kind channel{};
  quality::Measure measure;
  bool deviation = false;         // of a standard deviation, instead of single values
  std::string what, track_class;  // as in the file: "level chord 62ft", "crosslevel twist 3m sd"
  double speed_from = 0, speed_to = units::infinity;      // m/s, the first not included
  double low = -units::infinity, high = units::infinity;  // m; m/m of a twist

  bool is_twist() const { return measure.kind == quality::Measure::Kind::twist; }
  double unit() const { return is_twist() ? 1e-3 : units::millimetre; }
  const char* unit_name() const { return is_twist() ? "mm/m" : "mm"; }
};

// The limits of a file that hold for some classes (none named: for all) and a speed, m/s. Throws
// InputError that names the file and the line of what it cannot read, and when no limit is left, or
// limits depend on the speed and none is given.
std::vector<Limit> read_limits(const std::filesystem::path& file,
                               const std::vector<std::string>& classes,
                               std::optional<double> speed);

}  // namespace railbook::quality_tool
