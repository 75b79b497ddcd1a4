// What `contact solve` was asked, and its answer as a table.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include <railbook/contact/bodies.hpp>
#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/material.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::contact_tool {

struct BodyOptions {
  std::optional<double> radius_across, radius_along;
  std::filesystem::path profile;
  contact::Material material = contact::default_steel;
};

struct Options {
  std::array<BodyOptions, 2> bodies;
  std::array<contact::Body, 2> read;  // the same with their profiles read
  double angle = 0;
  std::optional<double> approach, load, edge;
  long cells_x = 127, cells_y = 127;
  std::string system = "metric";
  tool::Destination out;
};

// The units that answers are in.
struct Shown {
  double length, small, pressure, force;
  const char *length_name, *small_name, *pressure_name, *force_name;
};
inline constexpr Shown metric{units::millimetre,
                              units::micrometre,
                              units::megapascal,
                              units::kilonewton,
                              "mm",
                              "um",
                              "MPa",
                              "kN"};
inline constexpr Shown inches{
    units::inch, 1e-3 * units::inch, units::psi, units::lbf, "in", "mil", "psi", "lbf"};

// What is solved, in the frame of the grid.
struct Solved {
  contact::TouchingBodies bodies;
  contact::CgFft result;
  double modulus = 0;  // E* [Pa]
  // What the interpolation of the profiles may do to force and peak pressure, as shares of them; 0
  // for radii.
  double profile_force_error = 0, profile_p_max_error = 0;
  double touch_scatter =
      0;  // how far the scatter of the profiles' points may move the first touch [m]

  double touch_error = 0;  // of the place of first touch [m]
  // Of the contact's ends [m], from the profiles; infinite: not known.
  double profile_x_end_error = 0, profile_y_end_error = 0;

  // What that scatter does to the force at an approach, as a share of it: F grows as its power 3/2.
  double scatter_force_error() const { return 1.5 * touch_scatter / result.contact.approach; }
};

// The table, with its warnings: a contact as large as a fifth of a radius, narrower than a few
// cells, at an edge, profiles with too few points. Throws InputError for a contact as large as a
// radius.
tool::Summary answer(const Options& options, const Solved& solved);

}  // namespace railbook::contact_tool
