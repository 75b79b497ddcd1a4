/*
A profile is a file of an instrument or a vehicle program (lib/profiles/field_profile.hpp), or a table with the columns
`inward` and `height` and their units, such as `inward_mm,height_mm`: the place
across, which grows towards the middle of the track, and the height, upwards. A wheel's origin stands `--datum` from
the back of its flange, and the backs of the two flanges are `--back-to-back` apart; its heights need no particular
zero, since the wheel is raised to the rolling `--radius`. A rail is given upright, and the tool leans it by `--cant`
and puts its gauge face in place. Points are met by a spline that stays `--noise` away from them in the mean, 0 for one
through all of them; each span of it becomes two arcs, so that the same exact search serves measured and drawn
profiles.

The points are looked at first. Those that stand off the others by far more than their scatter, and holes between them, are
flagged with their place, and with the shifts at which the wheelset stands there; nothing is moved. Points that others hide
(doubled ones, fold-backs) and upright sides at the ends cannot be touched: they are left out, and listed. A wheel that is
turned, mirrored or upside down is refused.

Contact is far more sensitive than a drawing: on a worn tread the relative curvature of wheel and rail is small, and a
ripple that no eye sees makes the contact hop. The example files hold points 0.5 mm apart, rounded to a micrometre;
through all of them the worn wheel's contact jumps dozens of times, and with `--noise 0.001mm` hardly ever. Without
`--noise` the tool takes three times the scatter that it finds in the points. It prints scatter and
distances, and flags a conicity or critical speed that changes when the profiles are smoothed by half or by twice as much.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>

#include <railbook/files/outside.hpp>
#include <railbook/profiles/field_profile.hpp>
#include <railbook/profiles/measured_curve.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/table/line_source.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "hunting/profile_file.hpp"

namespace railbook::hunting_tool {

using namespace profiles;
using namespace wheelset;

namespace {

constexpr double times_scatter = 3;
constexpr double tape = 0.070;  // m from the back of the flange, where wheels are measured
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

Curve read_profile(const std::filesystem::path& file, Body body, const PairOptions& options,
                   ProfileFit& fit) {
  const bool is_file = std::filesystem::is_regular_file(file);
  std::vector<Point> points;
  fit.file = file;
  try {
    if (auto field = is_file ? parse_field_profile(text_of(file), body) : std::nullopt) {
      fit.format = std::move(field->format);
      fit.left_out = std::move(field->left_out);
      fit.warnings = std::move(field->warnings);
      points = std::move(field->points);
    }
  } catch (const InputError& error) {
    throw InputError(fmt::format("file \"{}\": {}", file.string(), error.what()));
  }
  if (fit.format.empty()) points = table_points(file);
  if (options.mirror_rail && body == Body::rail) {
    for (Point& p : points) p.u = -p.u;
    std::erase_if(fit.warnings, [](const PointsWarning& w) { return w.key == "side"; });
  }
  try {
    CheckedPoints checked = check_points(std::move(points), body);
    std::ranges::move(checked.warnings, std::back_inserter(fit.warnings));
    std::ranges::move(checked.left_out, std::back_inserter(fit.left_out));
    points = std::move(checked.points);
    fit.inner_end = points.back().u;
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

namespace {

const NamedPair& named(const PairOptions& options) {
  return *std::ranges::find(paper_pairs, options.pair,
                            [](const NamedPair& p) { return std::string(p.key); });
}

}  // namespace

bool from_files(const PairOptions& options) {
  if (options.wheel.empty() != options.rail.empty())
    throw InputError("profiles: give both --wheel and --rail, or neither for a pair of the paper");
  const PairOptions usual;
  const bool placed = options.gauge != usual.gauge || options.gauge_depth != usual.gauge_depth ||
                      options.cant != usual.cant || options.back_to_back != usual.back_to_back ||
                      options.datum != usual.datum || options.radius != usual.radius ||
                      options.half_spacing != usual.half_spacing || options.noise ||
                      options.mirror_rail;
  if (options.wheel.empty() && placed)
    throw InputError(
        "the paper's pairs have their own place; gauge, cant, back-to-back, datum, radius, half "
        "spacing, noise and mirror-rail go with --wheel and --rail");
  return !options.wheel.empty();
}

bool sides_differ(const PairOptions& options) {
  return !options.right_wheel.empty() || !options.right_rail.empty() || options.right_radius;
}

ReadPair read_pair(const PairOptions& options) {
  if (!from_files(options)) {
    if (sides_differ(options))
      throw InputError(
          "right wheel, right rail and right radius go with --wheel and --rail, which are the left "
          "ones");
    return {named(options).pair(), {}};
  }
  std::vector<ProfileFit> fits;
  const auto read = [&](const char* what, const std::filesystem::path& file) {
    fits.push_back({what});
    const Body body = std::string_view{what}.ends_with("wheel") ? Body::wheel : Body::rail;
    return read_profile(file, body, options, fits.back());
  };
  const auto side = [&](const Curve& wheel, const Curve& rail, double radius) {
    return with_radius(
        placed_wheel(wheel, 0.5 * options.back_to_back + options.datum),
        placed_rail(rail, options.gauge, options.gauge_depth, std::atan(options.cant)), radius);
  };
  const Curve wheel = read("wheel", options.wheel), rail = read("rail", options.rail);
  WheelsetOnTrack left = side(wheel, rail, options.radius);
  if (!sides_differ(options)) return {std::move(left), std::move(fits)};
  const Curve other =
      options.right_wheel.empty() ? wheel : read("right wheel", options.right_wheel);
  const WheelsetOnTrack right =
      side(other, options.right_rail.empty() ? rail : read("right rail", options.right_rail),
           options.radius);
  // Wheels of unlike profiles have the same radius at the tape, or differ there by what is given.
  const double at_tape = -0.5 * options.back_to_back - tape;
  const double radius_left = -left.wheel().height(at_tape),
               radius_right =
                   radius_left + options.right_radius.value_or(options.radius) - options.radius;
  const double raised = -radius_right - right.wheel().height(at_tape);
  return {WheelsetOnTrack(left, {moved(right.wheel(), 0, raised), right.rail()}), std::move(fits)};
}

namespace {

std::string key_of(const ProfileFit& fit) {
  std::string key = fit.what;
  std::ranges::replace(key, ' ', '_');
  return key;
}

}  // namespace

std::string format_note(const ProfileFit& fit) {
  return fit.format.empty() ? "" : fmt::format("read as {}; ", fit.format);
}

void describe_pair(tool::Summary& answer, const PairOptions& options,
                   const std::vector<ProfileFit>& fits) {
  answer.add("pair", "profiles",
             from_files(options) ? options.wheel.string() + " on " + options.rail.string()
                                 : options.pair + ", of the paper, reconstructed");
  if (sides_differ(options)) {
    const auto& wheel = options.right_wheel.empty() ? options.wheel : options.right_wheel;
    const auto& rail = options.right_rail.empty() ? options.rail : options.right_rail;
    answer.add(
        "pair_right", "  on the right",
        fmt::format("{} on {}, radius {:.6g} mm against {:.6g}", wheel.string(), rail.string(),
                    options.right_radius.value_or(options.radius) / units::millimetre,
                    options.radius / units::millimetre));
  }
  for (const ProfileFit& fit : fits)
    answer.add(
        key_of(fit) + "_rms_mm", std::string(fit.what) + ", points to smoothed profile, rms",
        fit.rms / units::millimetre, "mm",
        fmt::format(
            "{}largest {:.3g} mm; scatter of the points {:.2g} mm{}", format_note(fit),
            fit.largest / units::millimetre, fit.scatter / units::millimetre,
            options.noise ? "" : fmt::format(", smoothed by {:g} times that", times_scatter)));
}

void flag_points(tool::Summary& answer, const std::vector<ProfileFit>& fits,
                 const StandsOn& stands) {
  constexpr int most = 6;  // of one kind on one profile
  for (const ProfileFit& fit : fits) {
    std::string left_out;
    for (const PointsWarning& w : fit.left_out) left_out += (left_out.empty() ? "" : "; ") + w.text;
    if (!left_out.empty())
      answer.add(key_of(fit) + "_left_out", fmt::format("{}, left out", fit.what), left_out);
    std::map<std::string, int> count;
    for (const PointsWarning& w : fit.warnings) {
      const int k = ++count[w.key];
      if (k > most) continue;
      const std::string where = stands(fit, w);
      answer.flag(fmt::format("{}_{}_{}", key_of(fit), w.key, k),
                  fmt::format("{} {}: {}{}", fit.what, files::quoted_name(fit.file), w.text,
                              where.empty() ? "" : "; the wheel stands there " + where));
    }
    for (const auto& [key, k] : count)
      if (k > most)
        answer.flag(fmt::format("{}_{}s", key_of(fit), key),
                    fmt::format("{} {}: {} more such places", fit.what,
                                files::quoted_name(fit.file), k - most));
  }
}

namespace {

std::string text_of(const Smoothed& number, double x) {
  if (std::isnan(x)) return "none";
  return fmt::format("{:.4g}{}{}", x, number.unit.empty() ? "" : " ", number.unit);
}

bool differs(const Smoothed& number, double used, double other) {
  if (std::isnan(used) || std::isnan(other)) return std::isnan(used) != std::isnan(other);
  const double change = std::abs(other - used);
  return change > number.relative * std::abs(used) && change > number.absolute;
}

}  // namespace

void flag_smoothing(tool::Summary& answer, const PairOptions& options,
                    const std::vector<ProfileFit>& fits, const std::vector<Smoothed>& numbers,
                    const std::function<std::vector<double>(const PairOptions&)>& values) {
  struct Variant {
    const char* how;
    PairOptions options;
  };
  std::vector<Variant> variants;
  if (std::ranges::any_of(fits, [](const ProfileFit& f) { return f.smoothing > 0; })) {
    variants = {{"smoothed half as much", options}, {"twice as much", options}};
    variants[0].options.smoothing = 0.5;
    variants[1].options.smoothing = 2;
  }
  if (options.noise &&
      std::ranges::any_of(fits, [](const ProfileFit& f) { return f.scatter > 0; })) {
    variants.push_back({"smoothed as the points' scatter asks for", options});
    variants.back().options.noise.reset();
  }
  const auto at = [&](const PairOptions& w) {
    try {
      return values(w);
    } catch (const InputError&) {
      return std::vector<double>(numbers.size(), std::numeric_limits<double>::quiet_NaN());
    }
  };
  if (variants.empty()) return;
  const auto used = at(options);
  std::vector<std::string> others(numbers.size());
  for (const Variant& variant : variants) {
    const auto found = at(variant.options);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (differs(numbers[i], used[i], found[i]))
        others[i] += fmt::format(", {} {}", text_of(numbers[i], found[i]), variant.how);
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!others[i].empty())
      answer.flag(numbers[i].key,
                  fmt::format("{} depends on the smoothing of the profiles: {}{}", numbers[i].what,
                              text_of(numbers[i], used[i]), others[i]));
}

ConstraintFunctions table_of(const WheelsetOnTrack& pair, const PairOptions& options) {
  // Far from where the centred wheelset touches: the whole distance for the half, or another gauge's.
  const double touches = -pair.contact(0).left.on_rail.u;
  units::require_between("half spacing", options.half_spacing, 0.8 * touches, 1.2 * touches, "m");
  return tabulate(pair, {.half_spacing = options.half_spacing,
                         .end = options.end,
                         .step = options.step,
                         .average = options.average,
                         .level = options.level});
}

void add_right_options(tool::OptionParser& parser, PairOptions& options) {
  parser.file("--right-wheel", options.right_wheel,
              "profile of the right wheels; without it as the left, --wheel");
  parser.file("--right-rail", options.right_rail,
              "profile of the right rail; without it as the left, --rail");
  parser.quantity("--right-radius", options.right_radius, units::length,
                  "radius of the right wheel, 70 mm from the back of its flange, where --radius "
                  "is the left one's; "
                  "without it they are the same there",
                  tool::Range{0.05, 5});
}

void add_pair_options(tool::OptionParser& parser, PairOptions& options) {
  using tool::Range;
  const Range lengths{1e-3, 10};
  parser.choice("--pair", options.pair, {"new", "cn", "heumann"},
                "a pair of the paper, reconstructed; used when no files are given");
  parser.file("--wheel", options.wheel,
              "wheel profile: MiniProf, Simpack, VAMPIRE, plain columns, or a table with "
              "inward_mm and height_mm");
  parser.file("--rail", options.rail, "rail profile, upright, in one of the same forms");
  parser.flag("--mirror-rail", options.mirror_rail,
              "the file of the rail has its gauge side where its field side is expected");
  parser.quantity("--gauge", options.gauge, units::length, "between the gauge faces of the rails",
                  lengths);
  parser.quantity("--gauge-depth", options.gauge_depth, units::length,
                  "below the rail's top, where the gauge is measured", Range{1e-3, 0.1});
  parser.quantity("--cant", options.cant, units::number,
                  "slope of the rails inwards, such as 1:40 or 0.025", Range{-0.2, 0.2});
  parser.quantity("--back-to-back", options.back_to_back, units::length,
                  "between the backs of the flanges", lengths);
  parser.quantity("--datum", options.datum, units::length,
                  "of the wheel profile's origin from the back of the flange", Range{-1, 1});
  parser.quantity("--radius", options.radius, units::length,
                  "rolling radius of the centred wheelset", Range{0.05, 5});
  parser.quantity("--half-spacing", options.half_spacing, units::length,
                  "a: half the distance of the rails' heads", lengths);
  parser.quantity(
      "--noise", options.noise, units::length,
      "rms distance of the measured points from the smoothed profile; without it from the "
      "points' own scatter",
      Range{0, 1e-3});
  parser.quantity("--end", options.end, units::length, "largest displacement of the table",
                  Range{1e-4, 0.2});
  parser.quantity("--step", options.step, units::length,
                  "of the table; the end is a whole number of steps", Range{1e-6, 0.01});
  parser.quantity("--average", options.average, units::length,
                  "width of the running mean, an even number of steps; 0 for none", Range{0, 0.02});
}

}  // namespace railbook::hunting_tool
