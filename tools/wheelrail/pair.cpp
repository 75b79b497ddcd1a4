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
                     const std::optional<double>& noise,
                     std::vector<hunting_tool::ProfileFit>& fits) {
  hunting_tool::PairWish smoothing;
  smoothing.noise = noise;
  fits.push_back({what});
  return hunting_tool::read_profile(file, body, smoothing, fits.back());
}

using Noise = std::optional<double>;

Profile wheel_profile(const PairWish& wish, const Noise& noise,
                      std::vector<hunting_tool::ProfileFit>& fits) {
  if (wish.wheel.empty()) return s1002();
  const profiles::Curve curve = read("wheel", wish.wheel, profiles::Body::wheel, noise, fits);
  return Profile(profiles::moved(curve, 0, -curve.height(0)));
}

profiles::Curve rail_curve(const PairWish& wish, const Noise& noise,
                           std::vector<hunting_tool::ProfileFit>& fits) {
  if (wish.rail.empty())
    return rail_60e1(wish.head == "60E1" ? Rail60::drawing : Rail60::benchmark, wish.cant < 0.02);
  return read("rail", wish.rail, profiles::Body::rail, noise, fits);
}

ReadPair read_pair(const PairWish& wish, const Noise& of_wheel, const Noise& of_rail) {
  std::vector<hunting_tool::ProfileFit> fits;
  Profile wheel = wheel_profile(wish, of_wheel, fits);
  Profile rail(wheelset::placed_rail(rail_curve(wish, of_rail, fits), wish.gauge, wish.gauge_depth,
                                     std::atan(wish.cant)));
  return {{std::move(wheel), std::move(rail), wish.radius, 0.5 * wish.back_to_back + wish.datum},
          std::move(fits)};
}

}  // namespace

ReadPair read_pair(const PairWish& wish) {
  ReadPair read = read_pair(wish, wish.noise, wish.noise);
  require_fit(read.pair);
  return read;
}

Pair half_as_smooth(const PairWish& wish, const std::vector<hunting_tool::ProfileFit>& fits) {
  Noise of_wheel, of_rail;
  for (const hunting_tool::ProfileFit& fit : fits)
    (std::string_view{fit.what} == "wheel" ? of_wheel : of_rail) = 0.5 * fit.smoothing;
  return read_pair(wish, of_wheel, of_rail).pair;
}

bool stands_on(const PairWish& wish, const WheelResult& wheel, double shift,
               const hunting_tool::ProfileFit& fit, const profiles::PointsWarning& warning) {
  constexpr double reach = 4 * units::millimetre;  // half a long patch
  if (std::string_view{fit.what} != "wheel") return false;
  const double running_circle = 0.5 * wish.back_to_back + wish.datum;
  return std::ranges::any_of(wheel.patches, [&](const PatchResult& p) {
    const double inward = running_circle + shift - p.patch.frame.origin.y();
    return inward > warning.from - reach && inward < warning.to + reach;
  });
}

void describe_pair(tool::Summary& answer, const PairWish& wish,
                   const std::vector<hunting_tool::ProfileFit>& fits) {
  answer.add("wheel", "wheel", wish.wheel.empty() ? "S1002" : wish.wheel.string());
  answer.add("rail", "rail", wish.rail.empty() ? wish.head : wish.rail.string());
  answer.add("cant", "cant of the rails", wish.cant, "");
  for (const hunting_tool::ProfileFit& fit : fits)
    answer.add(
        fmt::format("{}_rms_mm", fit.what),
        fmt::format("{}: points to smoothed profile, rms", fit.what), fit.rms / units::millimetre,
        "mm",
        fmt::format("largest {:.2g} mm; scatter of the points {:.2g} mm, smoothed by {:.2g} mm",
                    fit.largest / units::millimetre, fit.scatter / units::millimetre,
                    fit.smoothing / units::millimetre));
}

Method method_of(const std::string& name) {
  return name == "hertz" ? Method::hertz : name == "strips" ? Method::strips : Method::full;
}

WheelWish wheel_wish(const PairWish& wish) {
  WheelWish w = wish.wheel_wish;
  w.speed = wish.speed;
  w.method = method_of(wish.method);
  w.along = w.across = wish.cells;
  return w;
}

void add_pair_options(tool::Options& options, PairWish& wish) {
  const Range lengths{1e-3, 10}, moduli{1, 1e15}, ratios{0, 0.5};
  options.file("--wheel", wish.wheel,
               "wheel profile, CSV with inward_mm and height_mm or other units; S1002 without it");
  options.file("--rail", wish.rail, "rail profile, upright, CSV with the same columns");
  options.choice("--head", wish.head, {"60E1", "60E1-benchmark"},
                 "rail without a file: of the drawing, or of the Manchester benchmark");
  options.quantity("--cant", wish.cant, units::number,
                   "lean of the rails inwards, such as 0.025 for 1:40", Range{-0.2, 0.2});
  options.quantity("--gauge", wish.gauge, units::length, "between the gauge faces of the rails",
                   lengths);
  options.quantity("--gauge-depth", wish.gauge_depth, units::length,
                   "below the rail's top, where the gauge is measured", Range{1e-3, 0.1});
  options.quantity("--back-to-back", wish.back_to_back, units::length,
                   "between the backs of the flanges", lengths);
  options.quantity("--datum", wish.datum, units::length,
                   "of the wheel profile's origin from the back of the flange", Range{-1, 1});
  options.quantity("--radius", wish.radius, units::length, "rolling radius at that origin",
                   Range{0.05, 5});
  options.quantity("--noise", wish.noise, units::length,
                   "rms distance of measured points from the smoothed profile; without it from "
                   "the points' own scatter",
                   Range{0, 1e-3});
  WheelWish& w = wish.wheel_wish;
  for (const auto& [name, steel] : {std::pair{"wheel", &w.wheel}, std::pair{"rail", &w.rail}}) {
    const std::string of = name;
    options.quantity("--" + of + "-young", steel->young, units::pressure,
                     "Young's modulus of the " + of, moduli);
    options.quantity("--" + of + "-poisson", steel->poisson, units::number,
                     "Poisson's ratio of the " + of, ratios);
  }
  options.quantity("--speed", wish.speed, units::speed, "of the wheelset along the track",
                   Range{1e-6, 1e3});
  options.required();
  options.quantity("--mu-left", w.friction.left, units::number,
                   "share of the friction left at high slip speed; 1 is constant friction",
                   Range{0, 1});
  options.quantity("--mu-speed", w.friction.speed, units::speed,
                   "slip speed over which the rest falls to 1/e", Range{1e-6, 1e6});
  options.choice("--method", wish.method, {"full", "strips", "hertz"},
                 "half-space and Kalker's full theory, semi-Hertzian strips, or Hertz's ellipse; "
                 "the last two with FASTSIM");
  options.count("--cells", wish.cells, "full: cells along a patch, and across", 8, 256);
}

}  // namespace railbook::wheelrail_tool
