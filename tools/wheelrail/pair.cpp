#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include <railbook/units/constants.hpp>
#include <railbook/wheelset/wheelset_contact.hpp>

#include "hunting/profile_file.hpp"
#include "wheelrail/pair.hpp"

namespace railbook::wheelrail_tool {

using namespace profiles;
using namespace wheel_contact;
using tool::Range;

namespace {

profiles::Curve read(const char* what, const std::filesystem::path& file, profiles::Body body,
                     const PairOptions& options, const std::optional<double>& noise,
                     std::vector<hunting_tool::ProfileFit>& fits) {
  hunting_tool::PairOptions smoothing;
  smoothing.noise = noise;
  smoothing.mirror_rail = options.mirror_rail;
  fits.push_back({what});
  return hunting_tool::read_profile(file, body, smoothing, fits.back());
}

using Noise = std::optional<double>;

Profile wheel_profile(const PairOptions& options, const Noise& noise,
                      std::vector<hunting_tool::ProfileFit>& fits) {
  if (options.wheel.empty()) return s1002();
  const profiles::Curve curve =
      read("wheel", options.wheel, profiles::Body::wheel, options, noise, fits);
  return Profile(profiles::moved(curve, 0, -curve.height(0)));
}

profiles::Curve rail_curve(const PairOptions& options, const Noise& noise,
                           std::vector<hunting_tool::ProfileFit>& fits) {
  if (options.rail.empty())
    return rail_60e1(options.head == "60E1" ? Rail60::drawing : Rail60::benchmark,
                     options.cant < 0.02);
  return read("rail", options.rail, profiles::Body::rail, options, noise, fits);
}

ReadPair read_pair(const PairOptions& options, const Noise& of_wheel, const Noise& of_rail) {
  std::vector<hunting_tool::ProfileFit> fits;
  Profile wheel = wheel_profile(options, of_wheel, fits);
  Profile rail(wheelset::placed_rail(rail_curve(options, of_rail, fits), options.gauge,
                                     options.gauge_depth, std::atan(options.cant)));
  return {{std::move(wheel), std::move(rail), options.radius,
           0.5 * options.back_to_back + options.datum},
          std::move(fits)};
}

}  // namespace

ReadPair read_pair(const PairOptions& options) {
  ReadPair read = read_pair(options, options.noise, options.noise);
  require_fit(read.pair);
  return read;
}

ProfilePair half_as_smooth(const PairOptions& options,
                           const std::vector<hunting_tool::ProfileFit>& fits) {
  Noise of_wheel, of_rail;
  for (const hunting_tool::ProfileFit& fit : fits)
    (std::string_view{fit.what} == "wheel" ? of_wheel : of_rail) = 0.5 * fit.smoothing;
  return read_pair(options, of_wheel, of_rail).pair;
}

bool stands_on(const PairOptions& options, const WheelResult& wheel, double shift,
               const hunting_tool::ProfileFit& fit, const profiles::PointsWarning& warning) {
  constexpr double reach = 4 * units::millimetre;  // half a long patch
  if (std::string_view{fit.what} != "wheel") return false;
  const double running_circle = 0.5 * options.back_to_back + options.datum;
  return std::ranges::any_of(wheel.patches, [&](const PatchResult& p) {
    const double inward = running_circle + shift - p.patch.frame.origin.y();
    return inward > warning.from - reach && inward < warning.to + reach;
  });
}

void describe_pair(tool::Summary& answer, const PairOptions& options,
                   const std::vector<hunting_tool::ProfileFit>& fits) {
  answer.add("wheel", "wheel", options.wheel.empty() ? "S1002" : options.wheel.string());
  answer.add("rail", "rail", options.rail.empty() ? options.head : options.rail.string());
  answer.add("cant", "cant of the rails", options.cant, "");
  for (const hunting_tool::ProfileFit& fit : fits)
    answer.add(
        fmt::format("{}_rms_mm", fit.what),
        fmt::format("{}: points to smoothed profile, rms", fit.what), fit.rms / units::millimetre,
        "mm",
        fmt::format("{}largest {:.2g} mm; scatter of the points {:.2g} mm, smoothed by {:.2g} mm",
                    hunting_tool::format_note(fit), fit.largest / units::millimetre,
                    fit.scatter / units::millimetre, fit.smoothing / units::millimetre));
}

Method method_of(const std::string& name) {
  return name == "hertz" ? Method::hertz : name == "strips" ? Method::strips : Method::full;
}

WheelInput wheel_input(const PairOptions& options) {
  WheelInput w = options.wheel_input;
  w.speed = options.speed;
  w.method = method_of(options.method);
  w.along = w.across = options.cells;
  return w;
}

void add_pair_options(tool::OptionParser& parser, PairOptions& options) {
  const Range lengths{1e-3, 10}, moduli{1, 1e15}, ratios{0, 0.5};
  parser.file("--wheel", options.wheel,
              "wheel profile: MiniProf, Simpack, VAMPIRE, plain columns, or a table with "
              "inward_mm and height_mm; S1002 without it");
  parser.file("--rail", options.rail, "rail profile, upright, in one of the same forms");
  parser.flag("--mirror-rail", options.mirror_rail,
              "the file of the rail has its gauge side where its field side is expected");
  parser.choice("--head", options.head, {"60E1", "60E1-benchmark"},
                "rail without a file: of the drawing, or of the Manchester benchmark");
  parser.quantity("--cant", options.cant, units::number,
                  "slope of the rails inwards, such as 1:40 or 0.025", Range{-0.2, 0.2});
  parser.quantity("--gauge", options.gauge, units::length, "between the gauge faces of the rails",
                  lengths);
  parser.quantity("--gauge-depth", options.gauge_depth, units::length,
                  "below the rail's top, where the gauge is measured", Range{1e-3, 0.1});
  parser.quantity("--back-to-back", options.back_to_back, units::length,
                  "between the backs of the flanges", lengths);
  parser.quantity("--datum", options.datum, units::length,
                  "of the wheel profile's origin from the back of the flange", Range{-1, 1});
  parser.quantity("--radius", options.radius, units::length, "rolling radius at that origin",
                  Range{0.05, 5});
  parser.quantity("--noise", options.noise, units::length,
                  "rms distance of measured points from the smoothed profile; without it from "
                  "the points' own scatter",
                  Range{0, 1e-3});
  WheelInput& w = options.wheel_input;
  for (const auto& [name, steel] : {std::pair{"wheel", &w.wheel}, std::pair{"rail", &w.rail}}) {
    const std::string of = name;
    parser.quantity("--" + of + "-young", steel->young, units::pressure,
                    "Young's modulus of the " + of, moduli);
    parser.quantity("--" + of + "-poisson", steel->poisson, units::number,
                    "Poisson's ratio of the " + of, ratios);
  }
  parser.quantity("--speed", options.speed, units::speed, "of the wheelset along the track",
                  Range{1e-6, 1e3});
  parser.required();
  parser.quantity("--mu-high-speed-share", w.friction.high_speed_share, units::number,
                  "share of the friction left at high slip speed; 1 is constant friction",
                  Range{0, 1});
  parser.quantity("--mu-speed", w.friction.speed, units::speed,
                  "slip speed over which the rest falls to 1/e", Range{1e-6, 1e6});
  parser.choice("--method", options.method, {"full", "strips", "hertz"},
                "half-space and Kalker's full theory, semi-Hertzian strips, or Hertz's ellipse; "
                "the last two with FASTSIM");
  parser.count("--cells", options.cells, "full: cells along a patch, and across", 8, 256);
}

}  // namespace railbook::wheelrail_tool
