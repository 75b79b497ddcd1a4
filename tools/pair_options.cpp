#include "pair_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include <railbook/files/outside.hpp>
#include <railbook/profiles/gauges.hpp>
#include <railbook/tool/batch.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/wheelset_contact.hpp>

namespace railbook::tools {

using profiles::Body;
using profiles::Curve;
using profiles::ProfileFit;
using tool::Range;
using units::millimetre;

namespace {

constexpr const char* found = "found";

// "2,3": the columns of across and height, counted from 1.
std::optional<std::array<std::size_t, 2>> columns_of(const std::string& text, const char* option) {
  if (text == found) return std::nullopt;
  std::array<std::size_t, 2> columns{};
  const char *at = text.data(), *const end = at + text.size();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto [next, error] = std::from_chars(at, end, columns[k]);
    const bool last = k + 1 == columns.size();
    if (error != std::errc{} || columns[k] < 1 || columns[k] > 100 || (next == end) != last ||
        (!last && *next != ','))
      throw InputError(fmt::format(
          "{} \"{}\"; allowed: two columns counted from 1, across and height, such as 1,2", option,
          text));
    columns[k] -= 1;
    at = next + 1;
  }
  return columns;
}

std::optional<double> unit_of(const std::string& name) {
  if (name == found) return std::nullopt;
  return name == "mm" ? millimetre : name == "in" ? units::inch : 1.0;
}

bool differs(const ProfileForm& a, const ProfileForm& b) {
  return a.mirror != b.mirror || a.flip != b.flip || a.unit != b.unit || a.columns != b.columns ||
         a.section != b.section;
}
bool differs(const RailPlace& a, const RailPlace& b) {
  return a.shift != b.shift || a.lift != b.lift || a.roll != b.roll;
}

std::string key_of(const ProfileFit& fit) {
  std::string key = fit.what;
  std::ranges::replace(key, ' ', '_');
  return key;
}

void add_place_options(tool::OptionParser& parser, const std::string& side, RailPlace& place) {
  const Range near{-0.1, 0.1};
  parser.quantity("--" + side + "-rail-shift", place.shift, units::length,
                  "of the " + side + " rail to the right, off its place", near);
  parser.quantity("--" + side + "-rail-lift", place.lift, units::length,
                  "of the " + side + " rail upwards", near);
  parser.quantity("--" + side + "-rail-roll", place.roll, units::angle,
                  "of the " + side + " rail, its right side down, about its gauge face at the top",
                  near);
}

// A flange that no wheel has, as where the profile's origin is not the tape circle: new ones have
// up to 35 mm.
void warn_of_thickness(const Curve& wheel, ProfileFit& fit) {
  constexpr double thickest = 36 * millimetre;
  try {
    const double thickness = profiles::wheel_gauges(wheel).thickness;
    if (thickness > thickest)
      fit.warnings.push_back(
          {"thickness",
           fmt::format("the flange would be {:.1f} mm thick (Sd), where wheels have up to 35 mm: "
                       "is the origin the tape circle? See --datum",
                       thickness / millimetre),
           units::infinity, units::infinity});
  } catch (const InputError&) {
    // no flange, which is said elsewhere
  }
}

}  // namespace

std::vector<PairFiles> pairs_of(const PairOptions& options) {
  const auto or_none = [](const auto& files) {
    return files.empty() ? std::vector<std::filesystem::path>(1) : files;
  };
  std::vector<PairFiles> pairs;
  for (const auto& wheel : or_none(options.wheels))
    for (const auto& rail : or_none(options.rails)) pairs.push_back({wheel, rail});
  return pairs;
}

void run_pairs(const std::vector<PairFiles>& pairs, const tool::Destination& out,
               const std::string& name,
               const std::function<tool::Summary(const PairFiles&)>& answer) {
  tool::RecordFiles names;
  std::map<std::filesystem::path, PairFiles> files;
  for (const PairFiles& pair : pairs) {
    const std::string both = pair.wheel.empty() ? pair.rail.string()
                             : pair.rail.empty()
                                 ? pair.wheel.string()
                                 : pair.wheel.string() + " on " + pair.rail.string();
    names.files.emplace_back(both);
    files[both] = pair;
  }
  tool::run_batch(names, out, name, [&](const auto& both) {
    return std::vector{tool::row_of(answer(files.at(both)))};
  });
}

bool sides_differ(const PairOptions& o) {
  const RailPlace mirrored{-o.right_place.shift, o.right_place.lift, -o.right_place.roll};
  return !o.right_wheel.empty() || !o.right_rail.empty() || o.right_radius || o.right_cant ||
         differs(o.left_place, mirrored);
}

bool places_differ(const PairOptions& a, const PairOptions& b) {
  return a.gauge != b.gauge || a.gauge_depth != b.gauge_depth || a.cant != b.cant ||
         a.back_to_back != b.back_to_back || a.datum != b.datum || a.radius != b.radius ||
         a.noise != b.noise || differs(a.wheel_form, b.wheel_form) ||
         differs(a.rail_form, b.rail_form) || differs(a.left_place, b.left_place) ||
         differs(a.right_place, b.right_place);
}

Curve read_profile(const PairOptions& options, const char* what, const std::filesystem::path& file,
                   std::vector<ProfileFit>& fits) {
  const bool wheel = std::string_view{what}.ends_with("wheel");
  const ProfileForm& form = wheel ? options.wheel_form : options.rail_form;
  profiles::ReadOptions read;
  read.noise = options.noise, read.smoothing = options.smoothing, read.datum = options.datum;
  read.mirror = form.mirror, read.flip = form.flip;
  read.unit = unit_of(form.unit);
  read.columns = columns_of(form.columns, wheel ? "--wheel-columns" : "--rail-columns");
  if (form.section > 0) read.section = form.section;
  fits.push_back({what});
  Curve curve = profiles::read_profile(file, wheel ? Body::wheel : Body::rail, read, fits.back());
  if (wheel) warn_of_thickness(curve, fits.back());
  return curve;
}

Curve placed_rail(const PairOptions& options, Side side, const Curve& rail,
                  double depth_below_end) {
  const bool left = side == Side::left;
  const double cant = left ? options.cant : options.right_cant.value_or(options.cant);
  Curve placed = wheelset::placed_rail(rail, options.gauge, options.gauge_depth, std::atan(cant),
                                       depth_below_end);
  const RailPlace& off = left ? options.left_place : options.right_place;
  const double inward = left ? 1 : -1, face = -0.5 * options.gauge;
  if (off.roll != 0)
    placed = profiles::moved(profiles::turned(profiles::moved(placed, -face, 0), inward * off.roll),
                             face, 0);
  if (off.shift != 0 || off.lift != 0)
    placed = profiles::moved(placed, inward * off.shift, off.lift);
  return placed;
}

double tape_from_middle(const PairOptions& options) {
  return 0.5 * options.back_to_back + profiles::tape_circle;
}

void describe_fits(tool::Summary& answer, const PairOptions& options,
                   const std::vector<ProfileFit>& fits) {
  for (const ProfileFit& fit : fits)
    answer.add(key_of(fit) + "_rms_mm",
               fmt::format("{}, points to smoothed profile, rms", fit.what), fit.rms / millimetre,
               "mm",
               fmt::format("{}largest {:.3g} mm; scatter of the points {:.2g} mm{}",
                           fit.format.empty() ? "" : fmt::format("read as {}; ", fit.format),
                           fit.largest / millimetre, fit.scatter / millimetre,
                           options.noise ? "" : ", smoothed by 3 times that"));
}

void flag_points(tool::Summary& answer, const std::vector<ProfileFit>& fits,
                 const StandsOn& stands) {
  constexpr int most = 6;  // of one kind on one profile
  for (const ProfileFit& fit : fits) {
    std::string left_out;
    for (const auto& w : fit.left_out) left_out += (left_out.empty() ? "" : "; ") + w.text;
    if (!left_out.empty())
      answer.add(key_of(fit) + "_left_out", fmt::format("{}, left out", fit.what), left_out);
    std::map<std::string, int> count;
    for (const auto& w : fit.warnings) {
      const int k = ++count[w.key];
      if (k > most) continue;
      const std::string where = stands(fit, w);
      answer.warn(fmt::format("{}_{}_{}", key_of(fit), w.key, k),
                  fmt::format("{} {}: {}{}", fit.what, files::quoted_name(fit.file), w.text,
                              where.empty() ? "" : "; the wheel stands there " + where));
    }
    for (const auto& [key, k] : count)
      if (k > most)
        answer.warn(fmt::format("{}_{}s", key_of(fit), key),
                    fmt::format("{} {}: {} more such places", fit.what,
                                files::quoted_name(fit.file), k - most));
  }
}

void add_form_options(tool::OptionParser& parser, const std::string& body, ProfileForm& form) {
  const std::string end = body.empty() ? "" : "-" + body, begin = body.empty() ? "" : body + "-";
  parser.flag("--mirror" + end, form.mirror,
              "the file's other side is the gauge side of a rail, or the flange's of a wheel");
  parser.flag("--flip" + end, form.flip, "the heights have the other sign than the one found");
  parser.choice("--" + begin + "unit", form.unit, {found, "mm", "m", "in"},
                "of plain columns of numbers; found from the width of the profile");
  parser.text("--" + begin + "columns", form.columns,
              "of plain columns of numbers, those of across and height, such as 2,3");
  parser.count("--" + begin + "section", form.section,
               "of a MiniProf file of several (.mpt), counted from 1; 0 where there is one", 0,
               1000);
}

void add_datum_options(tool::OptionParser& parser, PairOptions& options) {
  parser.quantity("--datum", options.datum, units::length,
                  "of the wheel profile's origin from the back of the flange; without it 70 mm, or "
                  "what the file says or shows",
                  Range{-1, 1});
  parser.quantity(
      "--noise", options.noise, units::length,
      "rms distance of the measured points from the smoothed profile; without it from the "
      "points' own scatter",
      Range{0, 1e-3});
}

void add_profile_options(tool::OptionParser& parser, PairOptions& options, bool several) {
  const Range lengths{1e-3, 10};
  const std::string wheel =
      "wheel profile: MiniProf, Simpack, VAMPIRE, plain columns, or a table with inward_mm and "
      "height_mm";
  const std::string rail = "rail profile, upright, in one of the same forms";
  if (several) {
    parser.files("--wheel", options.wheels, wheel + "; of several each is set on each rail");
    parser.files("--rail", options.rails, rail);
  } else {
    parser.file("--wheel", options.wheel, wheel);
    parser.file("--rail", options.rail, rail);
  }
  add_form_options(parser, "wheel", options.wheel_form);
  add_form_options(parser, "rail", options.rail_form);
  parser.quantity("--gauge", options.gauge, units::length, "between the gauge faces of the rails",
                  lengths);
  parser.quantity("--gauge-depth", options.gauge_depth, units::length,
                  "below the rail's top, down to where the gauge is the least distance",
                  Range{1e-3, 0.1});
  parser.quantity("--cant", options.cant, units::number,
                  "slope of the rails inwards, such as 1:40 or 0.025", Range{-0.2, 0.2});
  parser.quantity("--back-to-back", options.back_to_back, units::length,
                  "between the backs of the flanges", lengths);
  add_datum_options(parser, options);
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
                  Range{0.05, 5});
  parser.quantity("--right-cant", options.right_cant, units::number,
                  "slope of the right rail inwards; without it as the left, --cant",
                  Range{-0.2, 0.2});
  add_place_options(parser, "left", options.left_place);
  add_place_options(parser, "right", options.right_place);
}

}  // namespace railbook::tools
