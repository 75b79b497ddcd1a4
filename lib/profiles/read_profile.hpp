// A wheel or a rail from its file to a smooth curve.
//
//   ProfileFit fit{"wheel"};
//   const Curve wheel = read_profile("Car 12 left.whl", Body::wheel, {.noise = 1e-5}, fit);
//
// The file is one that parse_field_profile() reads, or a table with the columns inward and height.
// A rail is given upright. Nothing is repaired: `fit` lists what was left out, and what looks
// wrong.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <railbook/profiles/curve.hpp>
#include <railbook/profiles/field_profile.hpp>
#include <railbook/profiles/profile_points.hpp>

namespace railbook::profiles {

constexpr double tape_circle = 0.070;  // m from the back of the flange, where wheels are measured

struct ReadOptions : FieldOptions {
  // rms distance of the points from the smoothed curve [m]; without it three times their scatter.
  std::optional<double> noise;
  double smoothing = 1;  // times that
  bool mirror = false;   // across: the file's other side is the gauge side, or the flange's
  bool flip = false;     // heights: the file has the other sign
  // Of a wheel, how far the file's origin is from the back of the flange [m]; without it the tape
  // circle, or what the file says or shows.
  std::optional<double> datum;
};

// How a measured profile was met, all [m].
struct ProfileFit {
  const char* what;      // "wheel"
  double scatter = 0;    // of the points (scatter.hpp)
  double smoothing = 0;  // asked for
  double rms = 0, largest = 0;
  double inner_end = 0;        // of the points that were kept
  double depth_below_end = 0;  // see CheckedPoints
  std::filesystem::path file = {};
  std::string format = {};  // of the file; empty for a table with inward and height
  // In the coordinates that the curve has: inward and upward, a wheel's from the tape circle.
  std::vector<PointsWarning> warnings = {}, left_out = {};
};

// u inward and z up [m]; a wheel's origin is the tape circle. Throws InputError naming the file.
Curve read_profile(const std::filesystem::path& file, Body body, const ReadOptions& options,
                   ProfileFit& fit);

}  // namespace railbook::profiles
