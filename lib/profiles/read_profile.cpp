#include <railbook/profiles/read_profile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include <railbook/profiles/measured_curve.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/table/line_source.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/quantity.hpp>

namespace railbook::profiles {
namespace {

constexpr double times_scatter = 3;
constexpr double no_scatter =
    1e-9;  // m: rounding of the numbers in a file, met by a spline through all points

// A file as it is, or unpacked.
std::string text_of(const std::filesystem::path& file) {
  table::LineSource source(file);
  std::string text;
  for (std::string_view line; source.next(line);) (text += line) += '\n';
  return text;
}

std::vector<Point> table_points(const std::filesystem::path& file) {
  try {
    const auto columns =
        table::read_columns(file, {{"inward", units::length}, {"height", units::length}});
    std::vector<Point> points;
    points.reserve(columns[0].size());
    for (std::size_t i = 0; i < columns[0].size(); ++i)
      points.push_back({columns[0][i], columns[1][i]});
    return points;
  } catch (const InputError& error) {
    if (std::string_view{error.what()}.find("no column") == std::string_view::npos) throw;
    throw InputError(fmt::format(
        "{}; a profile is a file of MiniProf, Simpack or VAMPIRE, plain columns of numbers, or a "
        "table with the headers inward_mm,height_mm or other units, inward towards the middle of "
        "the track and height upwards",
        error.what()));
  }
}

}  // namespace

Curve read_profile(const std::filesystem::path& file, Body body, const ReadOptions& options,
                   ProfileFit& fit) {
  const bool is_file = std::filesystem::is_regular_file(file);
  std::vector<Point> points;
  double moved = 0;
  fit.file = file;
  try {
    if (auto field = is_file ? parse_field_profile(text_of(file), body, options) : std::nullopt) {
      fit.format = std::move(field->format);
      fit.left_out = std::move(field->left_out);
      fit.warnings = std::move(field->warnings);
      points = std::move(field->points);
      moved = field->moved;
    }
  } catch (const InputError& error) {
    throw InputError(fmt::format("file \"{}\": {}", file.string(), error.what()));
  }
  if (fit.format.empty()) points = table_points(file);
  for (Point& p : points) p = {options.mirror ? 2 * moved - p.u : p.u, options.flip ? -p.z : p.z};
  if (options.mirror)
    std::erase_if(fit.warnings, [](const PointsWarning& w) { return w.key == "side"; });
  if (body == Body::wheel && options.datum) {
    for (Point& p : points) p.u += tape_circle - *options.datum - moved;
    std::erase_if(fit.warnings, [](const PointsWarning& w) { return w.key == "origin"; });
  }
  try {
    CheckedPoints checked = check_points(std::move(points), body);
    std::ranges::move(checked.warnings, std::back_inserter(fit.warnings));
    std::ranges::move(checked.left_out, std::back_inserter(fit.left_out));
    points = std::move(checked.points);
    fit.inner_end = points.back().u;
    fit.depth_below_end = checked.depth_below_end;
    fit.scatter = scatter(points);
    if (fit.scatter < no_scatter) fit.scatter = 0;
    fit.smoothing = options.smoothing * options.noise.value_or(times_scatter * fit.scatter);
    MeasuredCurve met = measured_curve(std::move(points), fit.smoothing);
    fit.rms = met.rms;
    fit.largest = met.largest;
    return std::move(met.curve);
  } catch (const InputError& error) {
    throw InputError(fmt::format("file \"{}\": {}", file.string(), error.what()));
  }
}

}  // namespace railbook::profiles
