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
distances, and warns of a conicity or critical speed that changes when the profiles are smoothed by half or by twice as much.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <railbook/profiles/depth_profile.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "hunting/profile_file.hpp"

namespace railbook::hunting_tool {

using namespace profiles;
using namespace wheelset;
using tools::Side;

namespace {

const NamedPair& named(const PairOptions& options) {
  return *std::ranges::find(paper_pairs, options.pair,
                            [](const NamedPair& p) { return std::string(p.key); });
}

// A centred wheelset that stands on its flanges' roots: treads have contact angles of some degrees.
void warn_of_root(const WheelsetOnTrack& pair, std::vector<ProfileFit>& fits) {
  constexpr double steepest_tread = 10 * units::degree;
  const double angle = std::abs(pair.contact(0).left.delta);
  if (angle > steepest_tread)
    fits.front().warnings.push_back(
        {"root",
         fmt::format("the centred wheelset stands on the roots of its flanges, at {:.0f} degrees; "
                     "check gauge, back-to-back and origin",
                     angle / units::degree),
         units::infinity, units::infinity});
}

}  // namespace

bool from_files(const PairOptions& options) {
  if (options.wheel.empty() != options.rail.empty())
    throw InputError("profiles: give both --wheel and --rail, or neither for a pair of the paper");
  const PairOptions usual;
  const bool placed =
      tools::places_differ(options, usual) || options.half_spacing != usual.half_spacing;
  if (options.wheel.empty() && placed)
    throw InputError(
        "the paper's pairs have their own place; gauge, cant, back-to-back, datum, radius, half "
        "spacing, noise and what says how a file is read go with --wheel and --rail");
  return !options.wheel.empty();
}

ReadPair read_pair(const PairOptions& options) {
  if (!from_files(options)) {
    if (sides_differ(options))
      throw InputError(
          "what is said of the right side or of a rail's place goes with --wheel and --rail, which "
          "are "
          "the left ones");
    return {named(options).pair(), {}};
  }
  std::vector<ProfileFit> fits;
  const auto read = [&](const char* what, const std::filesystem::path& file) {
    return tools::read_profile(options, what, file, fits);
  };
  const auto place = [&](Side which, const Curve& wheel, const Curve& rail, double depth) {
    return with_radius(placed_wheel(wheel, tools::tape_from_middle(options)),
                       tools::placed_rail(options, which, rail, depth), options.radius);
  };
  const Curve wheel = read("wheel", options.wheel), rail = read("rail", options.rail);
  double depth = fits.back().depth_below_end;
  WheelsetOnTrack left = place(Side::left, wheel, rail, depth);
  warn_of_root(left, fits);
  if (!sides_differ(options)) return {std::move(left), std::move(fits)};
  const Curve other =
      options.right_wheel.empty() ? wheel : read("right wheel", options.right_wheel);
  const Curve other_rail =
      options.right_rail.empty() ? rail : read("right rail", options.right_rail);
  if (!options.right_rail.empty()) depth = fits.back().depth_below_end;
  const WheelsetOnTrack right = place(Side::right, other, other_rail, depth);
  // Wheels of unlike profiles have the same radius at the tape, or differ there by what is given.
  const double at_tape = -tools::tape_from_middle(options);
  const double radius_left = -left.wheel().height(at_tape),
               radius_right =
                   radius_left + options.right_radius.value_or(options.radius) - options.radius;
  const double raised = -radius_right - right.wheel().height(at_tape);
  return {WheelsetOnTrack(left, {moved(right.wheel(), 0, raised), right.rail()}), std::move(fits)};
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
  tools::describe_fits(answer, options, fits);
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
      answer.warn(numbers[i].key,
                  fmt::format("{} depends on the smoothing of the profiles: {}{}", numbers[i].what,
                              text_of(numbers[i], used[i]), others[i]));
}

ConstraintFunctions table_of(const WheelsetOnTrack& pair, const PairOptions& options) {
  // Far from where the centred wheelset touches: the whole distance for the half, or another
  // gauge's.
  const double touches = -pair.contact(0).left.on_rail.u;
  units::require_between("half spacing", options.half_spacing, 0.8 * touches, 1.2 * touches, "m");
  return tabulate(pair, {.half_spacing = options.half_spacing,
                         .end = options.end,
                         .step = options.step,
                         .average = options.average,
                         .level = options.level});
}

void add_pair_options(tool::OptionParser& parser, PairOptions& options, bool several) {
  using tool::Range;
  const Range lengths{1e-3, 10};
  parser.choice("--pair", options.pair, {"new", "cn", "heumann"},
                "a pair of the paper, reconstructed; used when no files are given");
  tools::add_profile_options(parser, options, several);
  parser.quantity("--radius", options.radius, units::length,
                  "rolling radius of the centred wheelset", Range{0.05, 5});
  parser.quantity("--half-spacing", options.half_spacing, units::length,
                  "a: half the distance of the rails' heads", lengths);
  parser.quantity("--end", options.end, units::length, "largest displacement of the table",
                  Range{1e-4, 0.2});
  parser.quantity("--step", options.step, units::length,
                  "of the table; the end is a whole number of steps", Range{1e-6, 0.01});
  parser.quantity("--average", options.average, units::length,
                  "width of the running mean, an even number of steps; 0 for none", Range{0, 0.02});
}

}  // namespace railbook::hunting_tool
