#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include <railbook/table/csv.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>

#include "contact/answer.hpp"
#include "tools.hpp"

namespace railbook::contact_tool {

using namespace contact;

/*
## Your own bodies

`contact solve` answers for two bodies of your own: each by two radii, or by a measured profile and the radius along
the rail. The same options go on the command line or into a file, and a quantity without its unit is refused:

    contact solve --config examples/contact/radii.toml
    contact solve --config examples/contact/profiles.toml --load 100kN --out mine

It prints force, moments, peak pressure, patch and the estimate of its own error; `--out` adds the pressures and the outline as
CSV, the summary as JSON, and a figure. A profile is a CSV file with the columns `x` and `depth` (into the body) or `height`
(towards the other body), each with its unit: `x_mm,height_mm`.

Slender contacts of bodies that are turned to each other are solved along their principal axes. Several patches are listed one
by one. The error of a profile's interpolation is found by leaving out every second of its points.

A contact that reaches a fifth of one of the radii is answered with a warning, one that reaches the whole radius is refused: half
spaces no longer say anything about it. Every refusal is one line, exit status 2, and no file.
*/

namespace {

// x and depth of a profile, x ascending; heights are depths with the other sign.
DepthPoints read_profile(const std::filesystem::path& file) {
  const table::CsvReader reader(file);
  bool height = false, depth = false;
  for (const std::string& header : reader.header()) {
    height = height || table::parse_column(header).name == "height";
    depth = depth || table::parse_column(header).name == "depth";
  }
  if (height && depth)
    throw InputError(fmt::format("file \"{}\" has both a height and a depth; allowed: one of them",
                                 file.string()));
  const auto columns = table::read_columns(
      file, {{"x", units::length}, {height ? "height" : "depth", units::length}});
  const auto vector = [](const std::vector<double>& v) -> Eigen::VectorXd {
    return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
  };
  DepthPoints points{vector(columns[0]), (height ? -1 : 1) * vector(columns[1])};
  if (points.x.size() > 1 && points.x[0] > points.x[points.x.size() - 1]) {
    points.x.reverseInPlace();
    points.depth.reverseInPlace();
  }
  return points;
}

Body body_of(const BodyOptions& options, int number) {
  Body body;
  if (options.radius_along) body.radius_y = *options.radius_along;
  if (options.radius_across) body.radius_x = *options.radius_across;
  if (options.profile.empty()) return body;
  if (options.radius_across)
    throw InputError(
        fmt::format("body {0} has both a profile and a radius across the rail; give one of "
                    "body-{0}-profile and body-{0}-radius-across",
                    number));
  body.profile = read_profile(options.profile);
  return body;
}

CgFft solve(const Options& options, const TouchingBodies& bodies, double modulus) {
  CgFftOptions solver;
  solver.nx = options.cells_x, solver.ny = options.cells_y;
  solver.cg.threads = static_cast<int>(std::thread::hardware_concurrency());
  solver.search = bodies.search;
  if (options.edge) solver.edge_x = *options.edge - bodies.x_touch;
  return options.load ? solve_cg_fft_load(bodies.gap, *options.load, modulus, solver)
                      : solve_cg_fft(bodies.gap, *options.approach, modulus, solver);
}

// Results that are not answers: exit status 1 with the reason.
void require_answer(const CgFft& result, const TouchingBodies& bodies) {
  const NormalContact& c = result.contact;
  if (!c.converged || c.p.size() == 0) throw std::runtime_error("no answer: " + c.reason);
  const double cell = result.levels.back().grid.dx;
  if (c.x_min < bodies.x_min + 2 * cell || c.x_max > bodies.x_max - 2 * cell)
    throw InputError(
        fmt::format("the contact reaches the end of the profile data, x = {:.6g} m to {:.6g} m; "
                    "give more of the profile, or less load",
                    bodies.x_min + bodies.x_touch, bodies.x_max + bodies.x_touch));
}

// What becomes of force, peak pressure, ends and first touch when every second point of the
// profiles is left out, at the same approach on one grid; infinite when there is then no contact to
// solve.
void find_profile_errors(const Options& options, Solved& solved) {
  Options same = options;
  same.load.reset();
  same.approach = solved.result.contact.approach;
  same.cells_x = std::min(options.cells_x, 128L), same.cells_y = std::min(options.cells_y, 128L);
  try {
    const std::vector<TouchingBodies> variants = join_thinned(options.read[0], options.read[1]);
    if (variants.empty()) return;
    const NormalContact all = solve(same, solved.bodies, solved.modulus).contact;
    for (const TouchingBodies& variant : variants) {
      const NormalContact some = solve(same, variant, solved.modulus).contact;
      if (!some.converged) throw InputError(some.reason);
      solved.profile_force_error =
          std::max(solved.profile_force_error, std::abs(some.force / all.force - 1));
      solved.profile_p_max_error =
          std::max(solved.profile_p_max_error, std::abs(some.p_max / all.p_max - 1));
      const double aside = variant.x_touch - solved.bodies.x_touch;
      solved.touch_error = std::max(solved.touch_error, std::abs(aside));
      solved.profile_x_end_error =
          std::max({solved.profile_x_end_error, std::abs(some.x_min + aside - all.x_min),
                    std::abs(some.x_max + aside - all.x_max)});
      solved.profile_y_end_error =
          std::max({solved.profile_y_end_error, std::abs(some.y_min - all.y_min),
                    std::abs(some.y_max - all.y_max)});
    }
    // Higher by the scatter, the bodies come nearer by it, and the ends move like the root of that.
    const double grown = solved.touch_scatter / (2 * all.approach);
    solved.profile_x_end_error += grown * (all.x_max - all.x_min) / 2;
    solved.profile_y_end_error += grown * (all.y_max - all.y_min) / 2;
    solved.touch_error =
        std::max(solved.touch_error, touch_place_error(solved.bodies, solved.touch_scatter));
    // A peak where the curvature jumps is off by more than it changes.
    solved.profile_p_max_error =
        2 * std::max(solved.profile_force_error, solved.profile_p_max_error);
  } catch (const InputError&) {  // of a thinned profile: the given ones have been solved
    solved.profile_force_error = solved.profile_p_max_error = units::infinity;
    solved.profile_x_end_error = solved.profile_y_end_error = units::infinity;
    solved.touch_error = units::infinity;
  }
}

void write_files(const Options& options, const Solved& solved, const tool::Summary& answer,
                 tool::OutFolder& out) {
  const Shown& u = options.system == "metric" ? metric : inches;
  const NormalContact& c = solved.result.contact;
  const Grid& grid = solved.result.levels.back().grid;
  const double x_touch = solved.bodies.x_touch;
  // Every cell within the grid, so that the file is a complete map; cells without contact have
  // pressure 0.
  Eigen::VectorXd p = Eigen::VectorXd::Zero(grid.cells());
  for (Eigen::Index n = 0; n < c.p.size(); ++n)
    p[std::lround((c.y[n] - grid.y(0)) / grid.dy) * grid.nx +
      std::lround((c.x[n] - grid.x(0)) / grid.dx)] = c.p[n];
  std::string cells = fmt::format("x_{0},y_{0},p_{1}\n", u.length_name, u.pressure_name);
  for (Eigen::Index j = 0; j < grid.ny; ++j) {
    for (Eigen::Index i = 0; i < grid.nx; ++i)
      cells += fmt::format("{:.8g},{:.8g},{:.8g}\n", (grid.x(i) + x_touch) / u.length,
                           grid.y(j) / u.length, p[j * grid.nx + i] / u.pressure);
    cells += "\n";
  }
  std::string outline = fmt::format("x_{0},y_low_{0},y_high_{0}\n", u.length_name);
  const Outline& o = solved.result.outline;
  for (Eigen::Index n = 0; n < o.x.size(); ++n) {
    const auto k = static_cast<std::size_t>(n);
    if (k > 0 && o.patch[k] != o.patch[k - 1]) outline += "\n";  // the next patch
    outline += fmt::format("{:.8g},{:.8g},{:.8g}\n", (o.x[n] + x_touch) / u.length,
                           o.low[n] / u.length, o.high[n] / u.length);
  }
  out.add("pressure.csv", cells);
  out.add("outline.csv", outline);
  out.add("contact.json", answer.json());
  const bool turned = solved.bodies.angle != 0;
  out.scratch("units.csv",
              fmt::format("length,pressure,x,y\n{},{},{},{}\n", u.length_name, u.pressure_name,
                          turned ? "first principal axis" : "x across the rail",
                          turned ? "second principal axis" : "y along the rail"));
  out.figure(tools::scripts("contact") / "solve.gp", {"pressure.csv", "outline.csv", "units.csv"},
             "pressure.png");
}

void run(Options options) {
  tool::OutFolder out(options.out, {"pressure.csv", "outline.csv", "contact.json", "pressure.png"});
  if (options.approach.has_value() == options.load.has_value())
    throw InputError("give one of approach and load: the other is the answer");
  const BodyOptions &one = options.bodies[0], &two = options.bodies[1];
  options.read = {body_of(one, 1), body_of(two, 2)};
  Solved solved;
  solved.modulus = effective_modulus(one.material, two.material);
  solved.bodies = join_bodies(options.read[0], options.read[1], options.angle);
  solved.result = solve(options, solved.bodies, solved.modulus);
  require_answer(solved.result, solved.bodies);
  solved.touch_scatter = touch_scatter(options.read[0], options.read[1]);
  find_profile_errors(options, solved);
  const tool::Summary summary = answer(options, solved);
  summary.print();
  if (out) write_files(options, solved, summary, out);
  out.commit();
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  for (int k = 0; k < 2; ++k) {
    BodyOptions& body = options->bodies[static_cast<std::size_t>(k)];
    const std::string name = fmt::format("--body-{}-", k + 1),
                      of = fmt::format("of body {}", k + 1);
    parser.quantity(name + "radius-across", body.radius_across, units::length,
                    "radius across the rail " + of + ", negative if concave; straight without it");
    parser.quantity(name + "radius-along", body.radius_along, units::length,
                    "radius along the rail " + of + "; straight without it");
    parser.file(name + "profile", body.profile,
                "profile across the rail " + of + ": CSV with x and depth or height");
    parser.quantity(name + "young", body.material.young, units::pressure, "Young's modulus " + of,
                    {1e-3 * units::megapascal, 1e12 * units::megapascal});
    parser.quantity(name + "poisson", body.material.poisson, units::number, "Poisson's ratio " + of,
                    {0, 0.5});
  }
  parser.quantity("--angle", options->angle, units::angle,
                  "of body 2 about the common normal (bodies by radii)");
  parser.quantity("--approach", options->approach, units::length, "of the bodies; or give the load",
                  {1e-15, 1});
  parser.quantity("--load", options->load, units::force,
                  "pressing them together; or give the approach", {1e-12, 1e12});
  parser.count("--cells-x", options->cells_x, "cells of the finest grid across the rail", 4, 8192);
  parser.count("--cells-y", options->cells_y, "and along it", 4, 8192);
  parser.quantity("--edge", options->edge, units::length,
                  "an x that gets a cell edge: where the curvature jumps");
  parser.choice("--system", options->system, {"metric", "inch"}, "units of the answer");
  parser.out(options->out);
  parser.help(
      "x is across the rail, y along it, from the bodies' own zero; depths go into a body, heights "
      "towards the other one; approach, force, load and pressures are positive as the bodies "
      "press. "
      "Moments are about the point of first touch. With --out DIR: DIR/pressure.csv has p_MPa, the "
      "pressure of every cell, outline.csv the edges y_low and y_high of each patch over x, "
      "contact.json the answer with its errors under \"errors\".");
  return [options] { run(*options); };
}

}  // namespace

tool::Tool solve_tool() {
  return {"solve", "normal contact of two bodies of your own", declare};
}

}  // namespace railbook::contact_tool
