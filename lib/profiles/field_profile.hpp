// Profiles of wheels and rails as instruments and vehicle programs write them.
//
//   std::optional<FieldProfile> read = parse_field_profile(text, Body::wheel);
//
// The format is found from the content: MiniProf (the old headers, key=value headers and
// files of one section with [FileInfo]), Simpack's wheel and rail profiles, VAMPIRE's, and plain
// columns of numbers. Each format's signs are stated in its own source file.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/profiles/profile_points.hpp>

namespace railbook::profiles {

struct FieldProfile {
  std::string format;         // "MiniProf"; with what was found from the points instead of stated
  std::vector<Point> points;  // in the file's order, inward and upward [m]
  // A wheel's points are counted from the tape circle, 70 mm from the back of the flange. They were
  // moved inward by this [m] where the file counts from elsewhere.
  double moved = 0;
  std::vector<PointsWarning> left_out;  // lines that hold no point, except comments and headers
  std::vector<PointsWarning> warnings;  // what the file does not state and was assumed
};

// What a file does not say, where its user knows.
struct FieldOptions {
  std::optional<double> unit = {};                         // of the numbers of plain columns [m]
  std::optional<std::array<std::size_t, 2>> columns = {};  // across and height, from 0
  std::optional<long> section = {};                        // of a MiniProf file of several, from 1
};

// Nothing where the text is none of the formats: a table whose header names inward and height, or
// text without points. Throws InputError for a file of a known format that cannot be used: several
// sections of which none is chosen, slices along a rail or round a wheel, a wheel's file given as a
// rail, a damaged number among the points, no points.
std::optional<FieldProfile> parse_field_profile(std::string_view text, Body body,
                                                const FieldOptions& options = {});

}  // namespace railbook::profiles
