#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include <railbook/units/constants.hpp>

#include "wheelrail/pair.hpp"

namespace railbook::wheelrail_tool {

using profiles::Profile;
using profiles::Rail60;
using profiles::rail_60e1;
using profiles::s1002;
using namespace wheel_contact;
using tool::Range;

namespace {

using profiles::Curve;
using profiles::ProfileFit;
using tools::Side;

Profile wheel_profile(const PairOptions& options, const char* what,
                      const std::filesystem::path& file, std::vector<ProfileFit>& fits) {
  if (file.empty()) return s1002();
  const Curve curve = tools::read_profile(options, what, file, fits);
  return Profile(profiles::moved(curve, 0, -curve.height(0)));
}

Profile rail_profile(const PairOptions& options, Side side, const char* what,
                     const std::filesystem::path& file, std::vector<ProfileFit>& fits) {
  const double cant = side == Side::left ? options.cant : options.right_cant.value_or(options.cant);
  double depth = 0;
  Curve curve =
      rail_60e1(options.head == "60E1" ? Rail60::drawing : Rail60::benchmark, cant < 0.02);
  if (!file.empty()) {
    curve = tools::read_profile(options, what, file, fits);
    depth = fits.back().depth_below_end;
  }
  return Profile(tools::placed_rail(options, side, curve, depth));
}

ReadPair read_sides(const PairOptions& options) {
  std::vector<ProfileFit> fits;
  const double half = tools::tape_from_middle(options);
  const ProfilePair left{wheel_profile(options, "wheel", options.wheel, fits),
                         rail_profile(options, Side::left, "rail", options.rail, fits),
                         options.radius, half};
  ProfilePair right = left;
  if (tools::sides_differ(options)) {
    const bool own_rail = !options.right_rail.empty();
    std::vector<ProfileFit> again;  // of the left rail in the right one's place
    if (!options.right_wheel.empty())
      right.wheel = wheel_profile(options, "right wheel", options.right_wheel, fits);
    right.rail =
        rail_profile(options, Side::right, "right rail",
                     own_rail ? options.right_rail : options.rail, own_rail ? fits : again);
    right.radius = options.right_radius.value_or(options.radius);
  }
  return {left, std::move(right), std::move(fits)};
}

}  // namespace

ReadPair read_pair(const PairOptions& options) {
  ReadPair read = read_sides(options);
  require_fit(read.left);
  if (tools::sides_differ(options)) require_fit(read.right);
  return read;
}

ReadPair half_as_smooth(const PairOptions& options) {
  PairOptions half = options;
  half.smoothing *= 0.5;
  return read_sides(half);
}

bool stands_on(const PairOptions& options, Side side, const WheelResult& wheel, double shift,
               const ProfileFit& fit, const profiles::PointsWarning& warning) {
  constexpr double reach = 4 * units::millimetre;  // half a long patch
  const bool of_right = side == Side::right && !options.right_wheel.empty();
  if (std::string_view{fit.what} != (of_right ? "right wheel" : "wheel")) return false;
  const double running_circle = tools::tape_from_middle(options);
  return std::ranges::any_of(wheel.patches, [&](const PatchResult& p) {
    const double inward = running_circle + shift - p.patch.frame.origin.y();
    return inward > warning.from - reach && inward < warning.to + reach;
  });
}

void describe_pair(tool::Summary& answer, const PairOptions& options,
                   const std::vector<ProfileFit>& fits) {
  const auto or_left = [](const auto& right, const auto& left) {
    return right.empty() ? left : right;
  };
  const auto wheel_name = [](const auto& file) { return file.empty() ? "S1002" : file.string(); };
  const auto rail_name = [&](const auto& file) {
    return file.empty() ? options.head : file.string();
  };
  answer.add("wheel", "wheel", wheel_name(options.wheel));
  answer.add("rail", "rail", rail_name(options.rail));
  answer.add("cant", "cant of the rails", options.cant, "");
  if (tools::sides_differ(options)) {
    answer.add("right_wheel", "right wheel",
               wheel_name(or_left(options.right_wheel, options.wheel)));
    answer.add("right_rail", "right rail", rail_name(or_left(options.right_rail, options.rail)));
    answer.add("right_cant", "  its cant", options.right_cant.value_or(options.cant), "");
    answer.add("right_radius_mm", "radius of the right wheel",
               options.right_radius.value_or(options.radius) / units::millimetre, "mm",
               fmt::format("left {:.6g} mm", options.radius / units::millimetre));
  }
  tools::describe_fits(answer, options, fits);
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

void add_pair_options(tool::OptionParser& parser, PairOptions& options, bool several) {
  const Range moduli{1, 1e15}, ratios{0, 0.5};
  tools::add_profile_options(parser, options, several);
  tools::add_right_options(parser, options);
  parser.choice("--head", options.head, {"60E1", "60E1-benchmark"},
                "rail without a file (a wheel without one is S1002): of the drawing, or of the "
                "Manchester benchmark");
  parser.quantity("--radius", options.radius, units::length,
                  "rolling radius, 70 mm from the back of the flange", Range{0.05, 5});
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
  parser.quantity("--mu-flange", w.friction.flange, units::number,
                  "friction from a contact angle of 40 degrees on, where --mu holds up to 20 and "
                  "lines join them; without it as on the tread",
                  Range{0, 2});
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
