// Wheel and rail as options of a tool: one of the paper's pairs, or profiles from files.
//
//   add_pair_options(options, options);            // --wheel, --rail, --pair, --gauge, ...
//   const auto [pair, fits] = read_pair(options);  // the contact itself, and how well points were met
//   const auto table = table_of(pair, options);    // constraint functions, a running mean over options.average
//   describe_pair(answer, options, fits);
//   flag_smoothing(answer, options, fits, {{"conicity_at_3_mm", "conicity at 3 mm", "", 0.05, 0.005}},
//                  [&](const PairOptions& w) { ... });
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <railbook/profiles/profile_points.hpp>
#include <railbook/tool/options.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/wheelset/tabulate.hpp>

namespace railbook::hunting_tool {

// SI. The defaults are the paper's track, and the European places of a wheel's profile (its origin 70 mm
// from the back of the flange, backs 1360 mm apart).
struct PairOptions {
  std::string pair = "new";           // of the paper; used when there are no files
  std::filesystem::path wheel, rail;  // CSV: inward and height, with units; both or none
  std::filesystem::path right_wheel, right_rail;  // where they are not the left ones
  double gauge = 56.5 * units::inch;
  double gauge_depth = 0.625 * units::inch;
  double cant = 0.025;
  double back_to_back = 1.360;
  double datum = 0.070;                // of the wheel profile's origin from the back of the flange
  double radius = 16.5 * units::inch;  // rolling radius, centred
  std::optional<double> right_radius;  // of the right wheel
  double half_spacing = 29.76 * units::inch;
  std::optional<double> noise;  // rms distance that the smoothing takes; without it from the points
  double smoothing = 1;         // times that
  double end = 0.75 * units::inch;  // of the table
  double step = 0.0025 * units::inch;
  double average = 0.02 * units::inch;
  bool mirror_rail = false;
  bool level = false;  // keep the axle from rolling, as EN 15302 does
};

void add_pair_options(tool::OptionParser& parser, PairOptions& options);

// The options for a right side of its own.
void add_right_options(tool::OptionParser& parser, PairOptions& options);
bool sides_differ(const PairOptions& options);

// Whether profiles come from files.
bool from_files(const PairOptions& options);

// How a measured profile was met, all [m].
struct ProfileFit {
  const char* what;      // "wheel"
  double scatter = 0;    // of the points (profiles::scatter)
  double smoothing = 0;  // asked for
  double rms = 0, largest = 0;
  double inner_end = 0;  // of the points that were kept
  std::filesystem::path file = {};
  std::string format = {};  // of the file; empty for a table with inward and height
  std::vector<profiles::PointsWarning> warnings = {}, left_out = {};  // in the file's coordinates
};
// One profile from its file, and how it was met; of the options only the smoothing is used. Throws InputError naming the file.
profiles::Curve read_profile(const std::filesystem::path& file, profiles::Body body,
                             const PairOptions& options, ProfileFit& fit);
// "read as MiniProf; ", or nothing.
std::string format_note(const ProfileFit& fit);
// Lists the points that were left out, and flags what looks wrong with the others. `stands` says where the contact stands on a doubtful place, if it
// does: "at shifts of 1 to 3 mm", or nothing.
using StandsOn =
    std::function<std::string(const ProfileFit& fit, const profiles::PointsWarning& warning)>;
void flag_points(tool::Summary& answer, const std::vector<ProfileFit>& fits,
                 const StandsOn& stands);

struct ReadPair {
  wheelset::WheelsetOnTrack pair;
  std::vector<ProfileFit> fits;  // none for the paper's pairs
};

// Throw InputError naming the file and what is wrong with it, or with the place of the wheelset on the rails.
ReadPair read_pair(const PairOptions& options);
wheelset::ConstraintFunctions table_of(const wheelset::WheelsetOnTrack& pair,
                                       const PairOptions& options);

// Where the profiles come from, and how well they were met.
void describe_pair(tool::Summary& answer, const PairOptions& options,
                   const std::vector<ProfileFit>& fits);

// Flags each number that changes by more than both tolerances when the profiles are smoothed half or twice as much, or, with
// a noise given, as their own scatter asks for. `values` computes them, NaN for none; an InputError of it counts as none at all.
struct Smoothed {
  std::string key, what, unit;
  double relative, absolute;
};
void flag_smoothing(tool::Summary& answer, const PairOptions& options,
                    const std::vector<ProfileFit>& fits, const std::vector<Smoothed>& numbers,
                    const std::function<std::vector<double>(const PairOptions&)>& values);

}  // namespace railbook::hunting_tool
