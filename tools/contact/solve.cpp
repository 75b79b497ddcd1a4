#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <tuple>

#include "contact/bodies.hpp"
#include "contact/cg_fft.hpp"
#include "contact/hertz.hpp"
#include "table/csv.hpp"
#include "tool/out_folder.hpp"
#include "tool/summary.hpp"
#include "tools.hpp"
#include "units/constants.hpp"

namespace railbook::contact_tool {

using namespace contact;

/*
## Your own bodies

`contact solve` answers for two bodies of your own: each by two radii, or by a measured profile and the radius along
the rail. The same options go on the command line or into a file, and a quantity without its unit is refused:

    contact solve --config chapters/01-contact/examples/radii.toml
    contact solve --config chapters/01-contact/examples/profiles.toml --load 100kN --out build/mine

It prints force, moments, peak pressure, patch and the estimate of its own error; `--out` adds the pressures and the outline as
CSV, the summary as JSON, and a figure. A profile is a CSV file with the columns `x` and `depth` (into the body) or `height`
(towards the other body), each with its unit: `x_mm,height_mm`.

A contact that reaches a fifth of one of the radii is answered with a doubt, one that reaches the whole radius is refused: half
spaces no longer say anything about it. Every refusal is one line, exit status 2, and no file.
*/

namespace {

struct BodyWish {
  std::optional<double> radius_across, radius_along;
  std::filesystem::path profile;
  double young = 206.8 * units::gigapascal, poisson = 0.3;
};

struct Wish {
  std::array<BodyWish, 2> bodies;
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
constexpr Shown metric{units::millimetre,
                       units::micrometre,
                       units::megapascal,
                       units::kilonewton,
                       "mm",
                       "um",
                       "MPa",
                       "kN"};
constexpr Shown inches{units::inch, 1e-3 * units::inch, units::psi, units::lbf, "in", "mil", "psi",
                       "lbf"};

// x and depth of a profile; heights are depths with the other sign.
Profile read_profile(const std::filesystem::path& file) {
  const table::CsvReader reader(file);
  bool height = false, depth = false;
  for (const std::string& header : reader.header()) {
    height = height || units::parse_header(header).name == "height";
    depth = depth || units::parse_header(header).name == "depth";
  }
  if (height && depth)
    throw InputError(fmt::format("file \"{}\" has both a height and a depth; allowed: one of them",
                                 file.string()));
  const auto columns = table::read_columns(
      file, {{"x", units::length}, {height ? "height" : "depth", units::length}});
  const auto vector = [](const std::vector<double>& v) -> Eigen::VectorXd {
    return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
  };
  return {vector(columns[0]), (height ? -1 : 1) * vector(columns[1])};
}

Body body_of(const BodyWish& wish, int number) {
  Body body;
  if (wish.radius_along) body.radius_y = *wish.radius_along;
  if (wish.radius_across) body.radius_x = *wish.radius_across;
  if (wish.profile.empty()) return body;
  if (wish.radius_across)
    throw InputError(
        fmt::format("body {0} has both a profile and a radius across the rail; give one of "
                    "body-{0}-profile and body-{0}-radius-across",
                    number));
  body.profile = read_profile(wish.profile);
  return body;
}

CgFft solve(const Wish& wish, const TouchingBodies& bodies, double modulus) {
  CgFftOptions options;
  options.nx = wish.cells_x, options.ny = wish.cells_y;
  options.search = bodies.search;
  if (wish.edge) options.edge_x = *wish.edge - bodies.x_touch;
  return wish.load ? solve_cg_fft_load(bodies.gap, *wish.load, modulus, options)
                   : solve_cg_fft(bodies.gap, *wish.approach, modulus, options);
}

// Results that are not answers: exit status 1 with the reason.
void require_answer(const CgFft& result, const TouchingBodies& bodies) {
  const NormalContact& c = result.contact;
  if (!c.converged) throw std::runtime_error("no answer: " + c.reason);
  const double cell = result.levels.back().grid.dx;
  if (c.x_min < bodies.x_min + 2 * cell || c.x_max > bodies.x_max - 2 * cell)
    throw InputError(
        fmt::format("the contact reaches the end of the profile data, x = {:.6g} m to {:.6g} m; "
                    "give more of the profile, or less load",
                    bodies.x_min + bodies.x_touch, bodies.x_max + bodies.x_touch));
}

// Half of what the contact covers in the direction at `angle` from x towards y.
double half_extent(const NormalContact& c, double angle) {
  const Eigen::VectorXd along = c.x * std::cos(angle) + c.y * std::sin(angle);
  return (along.maxCoeff() - along.minCoeff()) / 2;
}

// How large the contact is against the radii that it follows. As large as a radius: not a half space at all.
std::string half_space_note(const Wish& wish, const NormalContact& c) {
  double largest = 0;
  for (int k = 0; k < 2; ++k) {
    const BodyWish& body = wish.bodies[static_cast<std::size_t>(k)];
    const double angle = k == 1 ? wish.angle : 0;
    for (const auto& [name, radius, half] :
         {std::tuple{"across", body.radius_across, half_extent(c, angle)},
          std::tuple{"along", body.radius_along, half_extent(c, angle + units::pi / 2)}}) {
      if (!radius) continue;
      const double share = half / std::abs(*radius);
      if (share >= 1)
        throw InputError(fmt::format(
            "the half width of the contact is {:.4g} m, with a radius of {:.4g} m {} the rail of "
            "body {}; allowed: less than the radius; give less {}",
            half, *radius, name, k + 1, wish.load ? "load" : "approach"));
      largest = std::max(largest, share);
    }
  }
  if (largest < 0.2) return "";
  return fmt::format("the contact reaches {:.2g} of a radius: beyond 0.2 half spaces are doubtful",
                     largest);
}

// Zero for what is only rounding beside a number of size `scale`.
double clean(double value, double scale) {
  return std::abs(value) < 1e-9 * scale ? 0 : value;
}

tool::Summary summarise(const CgFft& result, const TouchingBodies& bodies, double modulus,
                        const Shown& u) {
  const NormalContact& c = result.contact;
  tool::Summary answer("Normal contact of two half spaces");
  const auto length = [&](const char* key, const char* what, double value) {
    answer.add(fmt::format("{}_{}", key, u.length_name), what, value / u.length, u.length_name);
  };
  answer.add(fmt::format("effective_modulus_{}", u.pressure_name), "effective modulus E*",
             modulus / u.pressure, u.pressure_name);
  length("x_touch", "first touch at x", clean(bodies.x_touch, c.x_max - c.x_min));
  answer.add(fmt::format("approach_{}", u.small_name), "approach", c.approach / u.small,
             u.small_name);
  answer.add(fmt::format("force_{}", u.force_name), "force F", c.force / u.force, u.force_name,
             fmt::format("relative error about {:.0e}", c.force_error));
  const std::string moment = fmt::format("{} {}", u.force_name, u.length_name);
  answer.add("moment_x", "moment M_x = -sum of y p dA",
             clean(c.moment_x, c.force * c.y_max) / (u.force * u.length), moment,
             "about the point of first touch");
  answer.add("moment_y", "moment M_y = sum of x p dA",
             clean(c.moment_y, c.force * (c.x_max - c.x_min)) / (u.force * u.length), moment,
             "about the point of first touch");
  answer.add(fmt::format("p_max_{}", u.pressure_name), "peak pressure", c.p_max / u.pressure,
             u.pressure_name,
             std::isinf(c.p_max_error) ? "of this grid; no limit"
                                       : fmt::format("relative error about {:.0e}", c.p_max_error));
  length("x_p_max", "  at x", clean(c.x_p_max, c.x_max - c.x_min) + bodies.x_touch);
  length("y_p_max", "  at y", clean(c.y_p_max, c.y_max));
  length("x_min", "contact from x", c.x_min + bodies.x_touch);
  length("x_max", "          to x", c.x_max + bodies.x_touch);
  length("y_min", "contact from y", c.y_min);
  length("y_max", "          to y", c.y_max);
  answer.add(fmt::format("area_{}2", u.length_name), "area", c.area / (u.length * u.length),
             fmt::format("{}^2", u.length_name));
  answer.add("grid", "finest grid",
             fmt::format("{} x {} cells, {} in contact", result.levels.back().grid.nx,
                         result.levels.back().grid.ny, c.p.size()));
  answer.add("iterations", "iterations, all grids", c.iterations, "");
  if (!c.reason.empty()) answer.add("note", "note", c.reason);
  return answer;
}

// Bodies by radii have Hertz's closed form: what it says at the same approach, and how far the grid is from it.
void add_hertz(const Wish& wish, const CgFft& result, double modulus, const Shown& u,
               tool::Summary& answer) {
  const auto curvature = [](const Body& body, double angle) {
    return Curvature{1 / body.radius_x, 1 / body.radius_y, angle};
  };
  const HertzContact h =
      hertz_from_approach(relative_curvature(curvature(body_of(wish.bodies[0], 1), 0),
                                             curvature(body_of(wish.bodies[1], 2), wish.angle)),
                          modulus, result.contact.approach);
  const auto against = [](double ours, double exact) {
    return fmt::format("the grid is off by {:.1e}", ours / exact - 1);
  };
  answer.add(fmt::format("hertz_force_{}", u.force_name), "Hertz: force at this approach",
             h.force / u.force, u.force_name, against(result.contact.force, h.force));
  answer.add(fmt::format("hertz_p_max_{}", u.pressure_name), "Hertz: peak pressure",
             h.p_max / u.pressure, u.pressure_name, against(result.contact.p_max, h.p_max));
  answer.add(fmt::format("hertz_a_{}", u.length_name), "Hertz: semi-axes", h.a / u.length,
             u.length_name);
  answer.add(fmt::format("hertz_b_{}", u.length_name), "", h.b / u.length, u.length_name);
}

void write_files(const CgFft& result, const TouchingBodies& bodies, const tool::Summary& answer,
                 const Shown& u, tool::OutFolder& out) {
  const NormalContact& c = result.contact;
  const Grid& grid = result.levels.back().grid;
  // Every cell within the grid, so that the file is a complete map; cells without contact have pressure 0.
  Eigen::VectorXd p = Eigen::VectorXd::Zero(grid.cells());
  for (Eigen::Index n = 0; n < c.p.size(); ++n)
    p[std::lround((c.y[n] - grid.y(0)) / grid.dy) * grid.nx +
      std::lround((c.x[n] - grid.x(0)) / grid.dx)] = c.p[n];
  std::string cells = fmt::format("x_{0},y_{0},p_{1}\n", u.length_name, u.pressure_name);
  for (Eigen::Index j = 0; j < grid.ny; ++j) {
    for (Eigen::Index i = 0; i < grid.nx; ++i)
      cells += fmt::format("{:.8g},{:.8g},{:.8g}\n", (grid.x(i) + bodies.x_touch) / u.length,
                           grid.y(j) / u.length, p[j * grid.nx + i] / u.pressure);
    cells += "\n";
  }
  std::string outline = fmt::format("x_{0},y_low_{0},y_high_{0}\n", u.length_name);
  for (Eigen::Index n = 0; n < result.outline.x.size(); ++n)
    outline +=
        fmt::format("{:.8g},{:.8g},{:.8g}\n", (result.outline.x[n] + bodies.x_touch) / u.length,
                    result.outline.low[n] / u.length, result.outline.high[n] / u.length);
  out.add("pressure.csv", cells);
  out.add("outline.csv", outline);
  out.add("contact.json", answer.json());
  out.scratch("units.csv", fmt::format("length,pressure\n{},{}\n", u.length_name, u.pressure_name));
  out.figure(tools::scripts("contact") / "solve.gp", {"pressure.csv", "outline.csv", "units.csv"},
             "pressure.png");
}

void run(const Wish& wish) {
  tool::OutFolder out(wish.out, {"pressure.csv", "outline.csv", "contact.json", "pressure.png"});
  if (wish.approach.has_value() == wish.load.has_value())
    throw InputError("give one of approach and load: the other is the answer");
  const BodyWish &one = wish.bodies[0], &two = wish.bodies[1];
  const double modulus = effective_modulus({one.young, one.poisson, two.young, two.poisson});
  const TouchingBodies bodies = join_bodies(body_of(one, 1), body_of(two, 2), wish.angle);
  const CgFft result = solve(wish, bodies, modulus);
  require_answer(result, bodies);
  const std::string doubt = half_space_note(wish, result.contact);
  const Shown& u = wish.system == "metric" ? metric : inches;
  tool::Summary answer = summarise(result, bodies, modulus, u);
  if (one.profile.empty() && two.profile.empty()) add_hertz(wish, result, modulus, u, answer);
  if (!doubt.empty()) answer.add("half_space", "half space", doubt);
  answer.print();
  if (out) write_files(result, bodies, answer, u, out);
  out.commit();
}

std::function<void()> declare(tool::Options& options) {
  const auto wish = std::make_shared<Wish>();
  for (int k = 0; k < 2; ++k) {
    BodyWish& body = wish->bodies[static_cast<std::size_t>(k)];
    const std::string name = fmt::format("--body-{}-", k + 1),
                      of = fmt::format("of body {}", k + 1);
    options.quantity(name + "radius-across", body.radius_across, units::length,
                     "radius across the rail " + of + ", negative if concave; straight without it");
    options.quantity(name + "radius-along", body.radius_along, units::length,
                     "radius along the rail " + of + "; straight without it");
    options.file(name + "profile", body.profile,
                 "profile across the rail " + of + ": CSV with x and depth or height");
    options.quantity(name + "young", body.young, units::pressure, "Young's modulus " + of,
                     {1e-3 * units::megapascal, 1e12 * units::megapascal});
    options.quantity(name + "poisson", body.poisson, units::number, "Poisson's ratio " + of,
                     {0, 0.5});
  }
  options.quantity("--angle", wish->angle, units::angle,
                   "of body 2 about the common normal (bodies by radii)");
  options.quantity("--approach", wish->approach, units::length, "of the bodies; or give the load",
                   {1e-15, 1});
  options.quantity("--load", wish->load, units::force,
                   "pressing them together; or give the approach", {1e-12, 1e12});
  options.count("--cells-x", wish->cells_x, "cells of the finest grid across the rail", 4, 8192);
  options.count("--cells-y", wish->cells_y, "and along it", 4, 8192);
  options.quantity("--edge", wish->edge, units::length,
                   "an x that gets a cell edge: where the curvature jumps");
  options.choice("--system", wish->system, {"metric", "inch"}, "units of the answer");
  options.out(wish->out);
  return [wish] { run(*wish); };
}

}  // namespace

tool::Tool solve_tool() {
  return {"solve", "normal contact of two bodies of your own", declare};
}

}  // namespace railbook::contact_tool
