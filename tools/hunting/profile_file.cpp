/*
A profile is a CSV file with columns `inward` and `height` and their units, such as `inward_mm,height_mm`: the place
across, which grows towards the middle of the track, and the height, upwards. A wheel's origin stands `--datum` from
the back of its flange, and the backs of the two flanges are `--back-to-back` apart; its heights need no particular
zero, since the wheel is raised to the rolling `--radius`. A rail is given upright, and the tool leans it by `--cant`
and puts its gauge face in place. Points are joined by a spline through all of them, or by one that stays `--noise`
away from them in the mean; each span of it becomes two arcs, so that the same exact search serves measured and drawn
profiles.

Contact is far more sensitive than a drawing: on a worn tread the relative curvature of wheel and rail is small, and a
ripple that no eye sees makes the contact hop. The example files hold points 0.5 mm apart, rounded to a micrometre;
through all of them the worn wheel's contact jumps dozens of times, and with `--noise 0.001mm` hardly ever. Give some
three times the noise of your gauge ({{gauge-noise}}).
*/

#include "hunting/profile_file.hpp"
#include "units/constants.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "table/csv.hpp"
#include "units/input_error.hpp"
#include "wheelrail/measured_curve.hpp"
#include "wheelrail/paper_pairs.hpp"

namespace railbook::hunting_tool {

using namespace wheelrail;

namespace {

Curve read_profile(const std::filesystem::path& file, double noise) {
  const auto columns =
      table::read_columns(file, {{"inward", units::length}, {"height", units::length}});
  std::vector<Point> points;
  for (std::size_t i = 0; i < columns[0].size(); ++i)
    points.push_back({columns[0][i], columns[1][i]});
  try {
    return measured_curve(std::move(points), noise).curve;
  } catch (const InputError& error) {
    throw InputError(fmt::format("file \"{}\": {}", file.string(), error.what()));
  }
}

// The flange is the lowest part of a wheel, and on its inner side.
void require_flange(const Curve& wheel, const std::filesystem::path& file) {
  if (wheel.end().z < wheel.start().z) return;
  throw InputError(fmt::format(
      "file \"{}\": the wheel is lowest at its outer end; allowed: inward grows towards the "
      "flange, height upwards",
      file.string()));
}

const NamedPair& named(const PairWish& wish) {
  return *std::ranges::find(paper_pairs, wish.pair,
                            [](const NamedPair& p) { return std::string(p.key); });
}

}  // namespace

bool from_files(const PairWish& wish) {
  if (wish.wheel.empty() != wish.rail.empty())
    throw InputError("profiles: give both --wheel and --rail, or neither for a pair of the paper");
  const PairWish usual;
  const bool placed = wish.gauge != usual.gauge || wish.gauge_depth != usual.gauge_depth ||
                      wish.cant != usual.cant || wish.back_to_back != usual.back_to_back ||
                      wish.datum != usual.datum || wish.radius != usual.radius ||
                      wish.half_spacing != usual.half_spacing || wish.noise != usual.noise;
  if (wish.wheel.empty() && placed)
    throw InputError(
        "the paper's pairs have their own place; gauge, cant, back-to-back, datum, radius, half "
        "spacing and noise go with --wheel and --rail");
  return !wish.wheel.empty();
}

WheelsetOnTrack read_pair(const PairWish& wish) {
  if (!from_files(wish)) return named(wish).pair();
  const Curve wheel = read_profile(wish.wheel, wish.noise),
              rail = read_profile(wish.rail, wish.noise);
  require_flange(wheel, wish.wheel);
  return with_radius(placed_wheel(wheel, 0.5 * wish.back_to_back + wish.datum),
                     placed_rail(rail, wish.gauge, wish.gauge_depth, wish.cant), wish.radius);
}

ConstraintFunctions table_of(const WheelsetOnTrack& pair, const PairWish& wish) {
  // Far from where the centred wheelset touches: the whole distance for the half, or another gauge's.
  const double touches = -pair.contact(0).left.on_rail.u;
  units::require_between("half spacing", wish.half_spacing, 0.8 * touches, 1.2 * touches, "m");
  return tabulate(pair, {.half_spacing = wish.half_spacing,
                         .end = wish.end,
                         .step = wish.step,
                         .average = wish.average,
                         .level = wish.level});
}

void add_pair_options(tool::Options& options, PairWish& wish) {
  using tool::Range;
  const Range lengths{1e-3, 10};
  options.choice("--pair", wish.pair, {"new", "cn", "heumann"},
                 "a pair of the paper, reconstructed; used when no files are given");
  options.file("--wheel", wish.wheel,
               "wheel profile, CSV with inward_mm and height_mm or other units");
  options.file("--rail", wish.rail, "rail profile, upright, CSV with the same columns");
  options.quantity("--gauge", wish.gauge, units::length, "between the gauge faces of the rails",
                   lengths);
  options.quantity("--gauge-depth", wish.gauge_depth, units::length,
                   "below the rail's top, where the gauge is measured", Range{1e-3, 0.1});
  options.quantity("--cant", wish.cant, units::number,
                   "lean of the rails inwards, such as 0.025 for 1:40", Range{-0.2, 0.2});
  options.quantity("--back-to-back", wish.back_to_back, units::length,
                   "between the backs of the flanges", lengths);
  options.quantity("--datum", wish.datum, units::length,
                   "of the wheel profile's origin from the back of the flange", Range{-1, 1});
  options.quantity("--radius", wish.radius, units::length, "rolling radius of the centred wheelset",
                   Range{0.05, 5});
  options.quantity("--half-spacing", wish.half_spacing, units::length,
                   "a: half the distance of the rails' heads", lengths);
  options.quantity("--noise", wish.noise, units::length,
                   "rms distance of the measured points from the smoothed profile", Range{0, 1e-3});
  options.quantity("--end", wish.end, units::length, "largest displacement of the table",
                   Range{1e-4, 0.2});
  options.quantity("--step", wish.step, units::length,
                   "of the table; the end is a whole number of steps", Range{1e-6, 0.01});
  options.quantity("--average", wish.average, units::length,
                   "width of the running mean, an even number of steps; 0 for none",
                   Range{0, 0.02});
}

}  // namespace railbook::hunting_tool
