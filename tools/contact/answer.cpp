#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <railbook/contact/hertz.hpp>
#include <railbook/units/input_error.hpp>

#include "contact/answer.hpp"

namespace railbook::contact_tool {

using namespace contact;

namespace {

// Half of what the contact covers in the direction at `angle` from the grid's x towards its y.
double half_extent(const NormalContact& c, double angle) {
  const Eigen::VectorXd along = c.x * std::cos(angle) + c.y * std::sin(angle);
  return (along.maxCoeff() - along.minCoeff()) / 2;
}

// How large the contact is against the radii that it follows. As large as a radius: not a half
// space at all.
void judge_half_space(const Options& options, const Solved& solved, tool::Summary& answer) {
  double largest = 0;
  for (int k = 0; k < 2; ++k) {
    const BodyOptions& body = options.bodies[static_cast<std::size_t>(k)];
    const double angle = (k == 1 ? options.angle : 0) - solved.bodies.angle;
    const NormalContact& c = solved.result.contact;
    for (const auto& [name, radius, half] :
         {std::tuple{"across", body.radius_across, half_extent(c, angle)},
          std::tuple{"along", body.radius_along, half_extent(c, angle + units::pi / 2)}}) {
      if (!radius) continue;
      const double share = half / std::abs(*radius);
      if (share >= 1)
        throw InputError(fmt::format(
            "the half width of the contact is {:.4g} m, with a radius of {:.4g} m {} the rail of "
            "body {}; allowed: less than the radius; give less {}",
            half, *radius, name, k + 1, options.load ? "load" : "approach"));
      largest = std::max(largest, share);
    }
  }
  if (largest >= 0.2)
    answer.warn(
        "half-space",
        fmt::format(
            "the contact reaches {:.2g} of a radius: beyond 0.2 half-spaces are a rough model",
            largest));
}

void judge_errors(const Solved& solved, tool::Summary& answer) {
  if (!solved.result.contact.reason.empty())
    answer.warn("resolution", solved.result.contact.reason);
  const NormalContact& c = solved.result.contact;
  if (c.reason.empty() && !(c.force_error < 0.5 && c.p_max_error < 0.5))
    answer.warn("cells", "too few cells for an error: give more with --cells-x and --cells-y");
  else if (c.reason.empty() && !(c.force_error < 0.05 && c.p_max_error < 0.05))
    answer.warn("cells", fmt::format("the error may be {:.0f} % of the force and {:.0f} % of the "
                                     "peak pressure: give more cells",
                                     100 * c.force_error, 100 * c.p_max_error));
  if (solved.profile_force_error > 3e-4 || solved.profile_p_max_error > 0.01)
    answer.warn(
        "profile",
        std::isfinite(solved.profile_force_error)
            ? fmt::format(
                  "every second point of the profiles alone would change the force by {:.1e}, the "
                  "peak pressure by {:.1e} of it: more points, or smoother ones, are needed",
                  solved.profile_force_error, solved.profile_p_max_error)
            : "every second point of the profiles alone would not do: their points are too few");
  const double scatter = solved.scatter_force_error();
  if (std::isfinite(solved.profile_force_error) && scatter > 3e-4 &&
      scatter > solved.profile_force_error)
    answer.warn("scatter",
                fmt::format("the points of the profiles scatter, or are rounded, so that their "
                            "first touch may be off by {:.1g} um, and the force at an approach by "
                            "{:.1e} of it: smoother points, or more digits, are needed",
                            solved.touch_scatter / units::micrometre, scatter));
}

// A value with its error from the grid and from the profiles, shares of it; infinite where one of
// them is not known.
tool::Estimate estimate(double value, double unit, double grid, double profile) {
  const bool known = grid < 0.5 && std::isfinite(profile);
  return {value / unit, known ? (grid + profile) * std::abs(value) / unit : units::infinity};
}

// What else is to be said of it.
std::string source_of(double grid, double profile) {
  if (!(grid < 0.5) || std::isinf(profile)) return "of this grid";
  if (profile == 0) return "";
  return fmt::format("{:.0f} % of the error from the profiles", 100 * profile / (grid + profile));
}

// Zero for what is only rounding beside a number of size `scale`.
double clean(double value, double scale) {
  return std::abs(value) < 1e-9 * scale ? 0 : value;
}

// The contact's ends in the bodies' axes. A turned grid is for bodies by radii, whose contact is an
// ellipse about the origin.
Box ends_of(const Solved& solved) {
  const NormalContact& c = solved.result.contact;
  const double cosine = std::cos(solved.bodies.angle), sine = std::sin(solved.bodies.angle);
  if (sine == 0) return {c.x_min, c.x_max, c.y_min, c.y_max};
  const double a = (c.x_max - c.x_min) / 2, b = (c.y_max - c.y_min) / 2;
  const double x = std::hypot(a * cosine, b * sine), y = std::hypot(a * sine, b * cosine);
  return {-x, x, -y, y};
}

// How far the ends along an axis may be off [m]; infinite: not known.
struct EndErrors {
  double x = 0, y = 0;
};

// The whole contact's, extrapolated over the grids. A turned grid's ends are turned with it.
EndErrors end_errors(const Solved& solved) {
  const NormalContact& c = solved.result.contact;
  const double x = c.x_end_error + solved.profile_x_end_error,
               y = c.y_end_error + solved.profile_y_end_error;
  const double cosine = std::cos(solved.bodies.angle), sine = std::sin(solved.bodies.angle);
  if (sine == 0) return {x, y};
  return {std::hypot(x * cosine, y * sine), std::hypot(x * sine, y * cosine)};
}

// A patch's, which are those of the finest grid, not extrapolated: 0.4 cell, an assumption that
// no test has tried.
EndErrors patch_end_errors(const Solved& solved) {
  const Grid& grid = solved.result.levels.back().grid;
  return {0.4 * grid.dx + solved.profile_x_end_error, 0.4 * grid.dy + solved.profile_y_end_error};
}

void add_ends(const std::string& prefix, const std::string& what, const Box& box,
              const EndErrors& errors, double x_touch, const Shown& u, tool::Summary& answer) {
  for (const auto& [name, text, value, error] :
       {std::tuple{"x_min", " from x", box.x_min + x_touch, errors.x},
        std::tuple{"x_max", "      to x", box.x_max + x_touch, errors.x},
        std::tuple{"y_min", " from y", box.y_min, errors.y},
        std::tuple{"y_max", "      to y", box.y_max, errors.y}})
    answer.add(fmt::format("{}{}_{}", prefix, name, u.length_name), what + text,
               tool::Estimate{value / u.length, error / u.length}, u.length_name);
}

void add_forces(const Solved& solved, bool by_load, const Box& ends, const Shown& u,
                tool::Summary& answer) {
  const NormalContact& c = solved.result.contact;
  answer.add(fmt::format("effective_modulus_{}", u.pressure_name), "effective modulus E*",
             solved.modulus / u.pressure, u.pressure_name);
  const double width = ends.x_max - ends.x_min;
  answer.add(
      fmt::format("x_touch_{}", u.length_name), "first touch at x",
      tool::Estimate{clean(solved.bodies.x_touch, width) / u.length, solved.touch_error / u.length},
      u.length_name);
  // What was asked for has no error: the other one has it, an approach not more than the force,
  // which grows faster.
  const double profiles = std::max(solved.profile_force_error, solved.scatter_force_error());
  const std::string approach = fmt::format("approach_{}", u.small_name),
                    force = fmt::format("force_{}", u.force_name);
  const auto uncertain = [&](const std::string& key, const char* what, double value, double unit,
                             const char* name) {
    answer.add(key, what, estimate(value, unit, c.force_error, profiles), name,
               source_of(c.force_error, profiles));
  };
  if (by_load) {
    uncertain(approach, "approach", c.approach, u.small, u.small_name);
    answer.add(force, "force F", c.force / u.force, u.force_name, "as asked");
  } else {
    answer.add(approach, "approach", c.approach / u.small, u.small_name, "as asked");
    uncertain(force, "force F", c.force, u.force, u.force_name);
  }
  const std::string moment = fmt::format("{}*{}", u.force_name, u.length_name);
  answer.add("moment_x", "moment M_x = -sum of y p dA",
             clean(c.moment_x, c.force * ends.y_max) / (u.force * u.length), moment,
             "about the point of first touch");
  answer.add("moment_y", "moment M_y = sum of x p dA",
             clean(c.moment_y, c.force * width) / (u.force * u.length), moment,
             "about the point of first touch");
  answer.add(fmt::format("p_max_{}", u.pressure_name), "peak pressure",
             estimate(c.p_max, u.pressure, c.p_max_error, solved.profile_p_max_error),
             u.pressure_name, source_of(c.p_max_error, solved.profile_p_max_error));
  const auto place = [&](const char* key, const char* what, double value) {
    answer.add(fmt::format("{}_{}", key, u.length_name), what, value / u.length, u.length_name);
  };
  // The peak is on the grid's x: the bodies are the same on both sides of it.
  place("x_p_max", "  at x",
        clean(c.x_p_max * std::cos(solved.bodies.angle), width) + solved.bodies.x_touch);
  place("y_p_max", "  at y", clean(c.x_p_max * std::sin(solved.bodies.angle), ends.y_max));
}

// Several patches one by one; a single one is the whole contact.
void add_patches(const Solved& solved, const Shown& u, tool::Summary& answer) {
  constexpr std::size_t most = 20;
  const auto& patches = solved.result.levels.back().region.patches;
  answer.add("patches", "patches", static_cast<double>(patches.size()), "",
             patches.size() > 1
                 ? "apart by a cell of the grid or more; their sums are of the finest grid"
                 : "");
  if (patches.size() == 1) return;
  for (std::size_t k = 0; k < std::min(patches.size(), most); ++k) {
    const PressurePatch& patch = patches[k];
    const std::string prefix = fmt::format("patch_{}_", k + 1),
                      name = fmt::format("patch {}", k + 1);
    answer.add(fmt::format("{}force_{}", prefix, u.force_name), name + ": force",
               patch.force / u.force, u.force_name);
    answer.add(fmt::format("{}area_{}2", prefix, u.length_name), "  area",
               patch.area / (u.length * u.length), fmt::format("{}^2", u.length_name));
    answer.add(fmt::format("{}p_max_{}", prefix, u.pressure_name), "  peak pressure",
               patch.p_max / u.pressure, u.pressure_name);
    add_ends(prefix, " ", patch.ends, patch_end_errors(solved), solved.bodies.x_touch, u, answer);
  }
  if (patches.size() > most)
    answer.add("patches_left_out", "patches left out", static_cast<double>(patches.size() - most),
               "", "those that carry least");
}

// Bodies by radii have Hertz's closed form: what it says at the same load, or approach, whichever
// was asked for, and how far the grid is from it.
void add_hertz(const Options& options, const Solved& solved, const Shown& u,
               tool::Summary& answer) {
  const auto curvature = [](const Body& body, double angle) {
    return Curvature{1 / body.radius_x, 1 / body.radius_y, angle};
  };
  const RelativeCurvature relative =
      relative_curvature(curvature(options.read[0], 0), curvature(options.read[1], options.angle));
  const HertzContact h = options.load
                             ? hertz_from_force(relative, solved.modulus, *options.load)
                             : hertz_from_approach(relative, solved.modulus, *options.approach);
  const NormalContact& c = solved.result.contact;
  const auto against = [](double ours, double exact) {
    return fmt::format("the grid is off by {:.1e}", ours / exact - 1);
  };
  answer.add(fmt::format("hertz_approach_{}", u.small_name),
             options.load ? "Hertz: approach at this load" : "Hertz: approach",
             h.approach / u.small, u.small_name,
             options.load ? against(c.approach, h.approach) : "as asked");
  answer.add(fmt::format("hertz_force_{}", u.force_name),
             options.load ? "Hertz: force" : "Hertz: force at this approach", h.force / u.force,
             u.force_name, options.load ? "as asked" : against(c.force, h.force));
  answer.add(fmt::format("hertz_p_max_{}", u.pressure_name), "Hertz: peak pressure",
             h.p_max / u.pressure, u.pressure_name, against(c.p_max, h.p_max));
  answer.add(fmt::format("hertz_a_{}", u.length_name), "Hertz: semi-axes", h.a / u.length,
             u.length_name);
  answer.add(fmt::format("hertz_b_{}", u.length_name), "", h.b / u.length, u.length_name);
}

}  // namespace

tool::Summary answer(const Options& options, const Solved& solved) {
  tool::Summary answer("Normal contact of two half spaces");
  judge_errors(solved, answer);
  judge_half_space(options, solved, answer);
  const Shown& u = options.system == "metric" ? metric : inches;
  const NormalContact& c = solved.result.contact;
  const Box ends = ends_of(solved);
  add_forces(solved, options.load.has_value(), ends, u, answer);
  add_ends("", "contact", ends, end_errors(solved), solved.bodies.x_touch, u, answer);
  answer.add(fmt::format("area_{}2", u.length_name), "area", c.area / (u.length * u.length),
             fmt::format("{}^2", u.length_name));
  add_patches(solved, u, answer);
  const Grid& grid = solved.result.levels.back().grid;
  answer.add("grid", "finest grid",
             fmt::format("{} x {} cells, {} in contact", grid.nx, grid.ny, c.p.size()));
  if (solved.bodies.angle != 0)
    answer.add("grid_angle_deg", "  turned by", solved.bodies.angle / units::degree, "deg",
               "x and y of pressure.csv and outline.csv are along the principal axes");
  answer.add("iterations", "iterations, all grids", c.iterations, "");
  answer.add("transform_pairs", "pairs of Fourier transforms of the finest grid",
             solved.result.transform_pairs(), "", "coarser and smaller ones by their points");
  if (!options.read[0].profile && !options.read[1].profile) add_hertz(options, solved, u, answer);
  return answer;
}

}  // namespace railbook::contact_tool
