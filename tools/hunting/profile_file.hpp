// Wheel and rail as options of a tool: one of the paper's pairs, or profiles from files.
//
//   add_pair_options(options, wish);            // --wheel, --rail, --pair, --gauge, ...
//   const auto pair = read_pair(wish);          // the contact itself
//   const auto table = table_of(pair, wish);    // constraint functions, a running mean over wish.average
#pragma once

#include <filesystem>
#include <string>

#include "tool/options.hpp"
#include "units/constants.hpp"
#include "wheelrail/tabulate.hpp"

namespace railbook::hunting_tool {

// SI. The defaults are the paper's track, and the European places of a wheel's profile (its origin 70 mm
// from the back of the flange, backs 1360 mm apart).
struct PairWish {
  std::string pair = "new";           // of the paper; used when there are no files
  std::filesystem::path wheel, rail;  // CSV: inward and height, with units; both or none
  double gauge = 56.5 * units::inch;
  double gauge_depth = 0.625 * units::inch;
  double cant = 0.025;
  double back_to_back = 1.360;
  double datum = 0.070;                // of the wheel profile's origin from the back of the flange
  double radius = 16.5 * units::inch;  // rolling radius, centred
  double half_spacing = 29.76 * units::inch;
  double noise = 0;
  double end = 0.75 * units::inch;  // of the table
  double step = 0.0025 * units::inch;
  double average = 0.02 * units::inch;
  bool level = false;  // keep the axle from rolling, as EN 15302 does
};

void add_pair_options(tool::Options& options, PairWish& wish);

// Whether profiles come from files.
bool from_files(const PairWish& wish);

// Throw InputError naming the file and what is wrong with it, or with the place of the wheelset on the rails.
wheelrail::WheelsetOnTrack read_pair(const PairWish& wish);
wheelrail::ConstraintFunctions table_of(const wheelrail::WheelsetOnTrack& pair,
                                        const PairWish& wish);

}  // namespace railbook::hunting_tool
