// A car as options of a tool: every datum of the paper's table, in any fitting unit.
//
//   add_car_options(options, options);     // --body-mass, --suspension, --pair, --wheel, ...
//   const CarCase c = read_case(options);  // geometry and quasi-linear car
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <railbook/tool/summary.hpp>
#include <railbook/vehicle/quasi_linear.hpp>

#include "hunting/profile_file.hpp"

namespace railbook::hunting_tool {

struct CarOptions {
  PairOptions pair;
  vehicle::CarParameters data;
  std::string suspension = "dampers";
  std::optional<double> lateral_damper, vertical_damper, warp_damper, centre_plate_damper;
};

void add_car_options(tool::OptionParser& parser, CarOptions& options);

struct CarCase {
  wheelset::ConstraintFunctions table;
  vehicle::QuasiLinearCar car;
  std::vector<ProfileFit> fits;
};
// Throws InputError for data that no car has, profiles that do not fit, or a damper given beside
// friction.
CarCase read_case(const CarOptions& options);

// Where the geometry comes from, its slopes, and the data that are not the paper's.
void describe_case(tool::Summary& answer, const CarOptions& options, const CarCase& c);

// Flags a first critical speed in the range [m/s] that depends on the smoothing of measured
// profiles by more than 2 %.
void flag_smoothing(tool::Summary& answer, const CarOptions& options, const CarCase& c,
                    double lowest, double highest);

}  // namespace railbook::hunting_tool
