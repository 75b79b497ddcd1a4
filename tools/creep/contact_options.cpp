#include "creep/contact_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <railbook/contact/hertz.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::creep_tool {

using namespace contact;
using namespace rolling;

namespace {

constexpr tool::Range lengths{1e-9, 1e6}, radii{-1e6, 1e6}, moduli{1, 1e15}, ratios{0, 0.5};

double curvature(const char* what, const std::optional<double>& radius) {
  if (!radius) return 0;
  if (std::abs(*radius) < 1e-9)
    throw InputError(
        fmt::format("{} is {:.6g} m; allowed: at least 1e-9 m either way, "
                    "negative for a hollow",
                    what, *radius));
  return 1 / *radius;
}

// A contact that is not small against the radii it follows is no contact of half-spaces.
void judge_size(const ContactOptions& options, const HertzContact& hertz, tool::Summary& answer) {
  double largest = 0;
  for (const auto& [radius, half] :
       {std::pair{options.wheel_radius, hertz.a}, std::pair{options.rail_radius, hertz.a},
        std::pair{options.wheel_profile, hertz.b}, std::pair{options.rail_crown, hertz.b}})
    if (radius)
      largest = std::max(largest, half / *radius);  // a hollow is wider than what is in it
  if (largest >= 1)
    throw InputError(fmt::format(
        "the contact's semi-axis is {:.3g} of a radius; allowed: less than 1; give less load",
        largest));
  if (largest > 0.2)
    answer.add(
        "half_space", "half space",
        fmt::format(
            "the contact reaches {:.2g} of a radius: beyond 0.2 half-spaces are a rough model",
            largest));
}

}  // namespace

RollingCase contact_of(const ContactOptions& options, const MaterialPair& pair,
                       tool::Summary& answer) {
  RollingCase c{.a = 0,
                .b = 0,
                .load = options.load,
                .shear_modulus = pair.shear_modulus,
                .poisson = pair.poisson,
                .friction = options.friction,
                .creepage = {}};
  const bool radii_given =
      options.wheel_radius || options.wheel_profile || options.rail_radius || options.rail_crown;
  if (options.a.has_value() != options.b.has_value() || options.a.has_value() == radii_given)
    throw InputError("give either both semi-axes, a and b, or radii of wheel and rail");
  const char* source = "given";
  if (radii_given) {
    const auto hertz = hertz_from_force({.a = (curvature("wheel radius", options.wheel_radius) +
                                               curvature("rail radius", options.rail_radius)) /
                                              2,
                                         .b = (curvature("wheel profile", options.wheel_profile) +
                                               curvature("rail crown", options.rail_crown)) /
                                              2},
                                        pair.effective_modulus, options.load);
    c.a = hertz.a, c.b = hertz.b;
    judge_size(options, hertz, answer);
    source = "Hertz, from the radii";
    answer.add("p_max_MPa", "largest pressure", hertz.p_max / units::megapascal, "MPa");
  } else {
    c.a = *options.a, c.b = *options.b;
  }
  answer.add("a_mm", "semi-axis a, along rolling", c.a / units::millimetre, "mm", source);
  answer.add("b_mm", "semi-axis b, across", c.b / units::millimetre, "mm", source);
  check(c);
  return c;
}

void ContactOptions::declare(tool::OptionParser& parser) {
  const std::string hollow = "; straight without it, negative if hollow";
  parser.quantity("--a", a, units::length, "semi-axis of the contact along rolling", lengths);
  parser.quantity("--b", b, units::length, "and across", lengths);
  parser.quantity("--wheel-radius", wheel_radius, units::length, "rolling radius of the wheel",
                  radii);
  parser.quantity("--wheel-profile", wheel_profile, units::length,
                  "radius of the wheel's profile" + hollow, radii);
  parser.quantity("--rail-radius", rail_radius, units::length,
                  "radius of the rail along rolling, of a roller" + hollow, radii);
  parser.quantity("--rail-crown", rail_crown, units::length,
                  "radius of the rail's profile" + hollow, radii);
  parser.quantity("--load", load, units::force, "normal load", tool::Range{1e-9, 1e12});
  parser.required();
  parser.quantity("--mu", friction, units::number, "friction coefficient", tool::Range{0, 10});
  parser.quantity("--wheel-young", wheel.young, units::pressure, "Young's modulus", moduli);
  parser.quantity("--wheel-poisson", wheel.poisson, units::number, "Poisson's ratio", ratios);
  parser.quantity("--rail-young", rail.young, units::pressure, "Young's modulus", moduli);
  parser.quantity("--rail-poisson", rail.poisson, units::number, "Poisson's ratio", ratios);
}

}  // namespace railbook::creep_tool
