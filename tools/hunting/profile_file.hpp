// Wheel and rail as options of a tool: one of the paper's pairs, or profiles from files.
//
//   add_pair_options(options, options);            // --wheel, --rail, --pair, --gauge, ...
//   const auto [pair, fits] = read_pair(options);  // the contact, and how well points were met
//   const auto table = table_of(pair, options);    // constraint functions, their running mean
//   describe_pair(answer, options, fits);
//   flag_smoothing(answer, options, fits,
//                  {{"conicity_at_3_mm", "conicity at 3 mm", "", 0.05, 0.005}},
//                  [&](const PairOptions& w) { ... });
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <railbook/tool/options.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/wheelset/tabulate.hpp>

#include "pair_options.hpp"

namespace railbook::hunting_tool {

// The track's defaults are the paper's.
struct PairOptions : tools::PairOptions {
  std::string pair = "new";  // of the paper; used when there are no files
  double half_spacing = 29.76 * units::inch;
  double end = 0.75 * units::inch;  // of the table
  double step = 0.0025 * units::inch;
  double average = 0.02 * units::inch;
  bool level = false;  // keep the axle from rolling, as EN 15302 does
  PairOptions() {
    gauge = 56.5 * units::inch, gauge_depth = 0.625 * units::inch;
    radius = 16.5 * units::inch;  // rolling radius, centred
  }
};

void add_pair_options(tool::OptionParser& parser, PairOptions& options, bool several = false);

// Whether profiles come from files.
bool from_files(const PairOptions& options);

using profiles::ProfileFit;
using tools::flag_points;
using tools::sides_differ;

struct ReadPair {
  wheelset::WheelsetOnTrack pair;
  std::vector<ProfileFit> fits;  // none for the paper's pairs
};

// Throw InputError naming the file and what is wrong with it, or with the place of the wheelset on
// the rails.
ReadPair read_pair(const PairOptions& options);
wheelset::ConstraintFunctions table_of(const wheelset::WheelsetOnTrack& pair,
                                       const PairOptions& options);

// Where the profiles come from, and how well they were met.
void describe_pair(tool::Summary& answer, const PairOptions& options,
                   const std::vector<ProfileFit>& fits);

// Flags each number that changes by more than both tolerances when the profiles are smoothed half
// or twice as much, or, with a noise given, as their own scatter asks for. `values` computes them,
// NaN for none; an InputError of it counts as none at all.
struct Smoothed {
  std::string key, what, unit;
  double relative, absolute;
};
void flag_smoothing(tool::Summary& answer, const PairOptions& options,
                    const std::vector<ProfileFit>& fits, const std::vector<Smoothed>& numbers,
                    const std::function<std::vector<double>(const PairOptions&)>& values);

}  // namespace railbook::hunting_tool
