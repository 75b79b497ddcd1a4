/*
### `creep curve`

The forces over a range of longitudinal creepage, with lateral creepage and spin held, for a contact of your own: its
semi-axes, or the radii of the bodies, from which Hertz's theory makes them. Whatever is not given is assumed and
marked so in the answer. Quantities carry their unit; a TOML file (`--config`) may hold the same options.

    creep curve --a 6mm --b 4mm --load 80kN --mu 0.3 --spin 0.2rad/m --out mine
    creep curve --wheel-radius 460mm --rail-crown 300mm --load 80kN \
                --theory fastsim --lateral 0.001 --to 0.01

With `--force` it also seeks the creepage that gives a force, as on the rig, where the brake sets the force and the creep is
read. Positive creepage gives positive force, that of the wheel on the rail; `spin` is the rotation per metre rolled.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <railbook/num/roots.hpp>
#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/material_pair.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/progress.hpp>
#include <railbook/tool/session.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "creep/contact_options.hpp"
#include "tools.hpp"

namespace railbook::creep_tool {

using namespace rolling;

namespace {

struct Options {
  ContactOptions contact;
  double lateral = 0, spin = 0, from = 0;
  std::string spin_text = "0rad/m";
  std::optional<double> to, force;
  long points = 21, cells = 24;
  std::string theory = "full", coefficients = "table";
  tool::Destination out;
};

// Radians are no dimension to most people: 0.2rad/m and 0.2 1/m are the same spin. Cycles are not.
double spin_of(const std::string& text) {
  const auto holds = [&](const char* unit) { return text.find(unit) != std::string::npos; };
  const bool per_length = holds("/") && !holds("rad") && !holds("deg") && !holds("cycle");
  const double spin = units::parse_quantity(
      "spin", text, per_length ? units::wavenumber : units::angle / units::length);
  return units::require_between("spin", spin, -1e4, 1e4, "rad/m");
}

struct Row {
  Creepage creepage;
  CreepForces forces;
};

constexpr double coarse_error = 0.1;  // of mu N: from here on an answer has a warning

// The warning of a row; empty without one.
std::string warning_of(const CreepForces& f, bool full) {
  if (!f.warning.empty()) return std::string(f.warning);
  if (std::isfinite(f.error) && f.error > coarse_error)
    return full ? fmt::format(
                      "the cells are too coarse: error estimate above {:g} mu N; give more "
                      "cells",
                      coarse_error)
                : fmt::format("this theory is more than {:g} mu N off the full one", coarse_error);
  return "";
}

// Zero for what is only rounding beside the bound.
void clean(CreepForces& f, double bound, double length) {
  for (double* force : {&f.fx, &f.fy})
    if (std::abs(*force) < 1e-12 * bound) *force = 0;
  if (std::abs(f.mz) < 1e-12 * bound * length) f.mz = 0;
}

// A theory without an estimate of its own beside the full theory, at up to 21 of the rows evenly
// spread: the errors of those rows. Where the full theory has no answer, they stay unknown.
void compare_with_full(std::vector<Row>& all, RollingCase c) {
  if (all.empty() || std::isfinite(all.front().forces.error) || c.friction == 0) return;
  constexpr std::size_t most = 21;
  const Solver full = solver("full", c.a / c.b, c.poisson, 24);
  const double bound = c.friction * c.load, unit = bound * std::sqrt(c.a * c.b);
  const std::size_t rows = std::min(most, all.size());
  for (std::size_t k = 0; k < rows; ++k) {
    auto& [creepage, f] = all[rows == 1 ? 0 : k * (all.size() - 1) / (rows - 1)];
    c.creepage = creepage;
    const CreepForces exact = full(c);
    if (!exact.converged) continue;
    f.error = std::hypot(f.fx - exact.fx, f.fy - exact.fy) / bound + exact.error;
    f.mz_error = std::abs(f.mz - exact.mz) / unit + exact.mz_error;
  }
}

// The largest errors that are known, and the warnings of the rows.
void add_warnings(tool::Summary& answer, const std::vector<Row>& all, double unit, bool full) {
  double error = units::nan, moment = units::nan;
  for (const auto& [creepage, f] : all)
    if (std::isfinite(f.error)) {
      error = std::fmax(error, f.error);
      moment = std::fmax(moment, f.mz_error);
    }
  if (std::isfinite(error)) {
    answer.add_error("error_share",
                     full ? "largest error estimate of the force" : "largest error against full",
                     error, "of mu N");
    answer.add_error("mz_error_N_m", "and of the moment", moment * unit, "N*m");
  } else {
    answer.absent("error_share", "error estimate",
                  unit > 0 ? "not known: the full theory has no answer for this contact"
                           : "none: without friction there is no force");
  }
  std::vector<std::string> seen;
  for (const auto& [creepage, f] : all) {
    const std::string warning = warning_of(f, full);
    if (warning.empty() || std::ranges::find(seen, warning) != seen.end()) continue;
    const auto count = std::ranges::count_if(
        all, [&](const Row& r) { return warning_of(r.forces, full) == warning; });
    seen.push_back(warning);
    answer.warn(fmt::format("range_{}", seen.size()),
                fmt::format("{} ({} of {} rows)", warning, count, all.size()));
  }
}

std::vector<Row> rows(const Options& options, RollingCase c, const Solver& solve, double to) {
  std::vector<Row> all;
  for (long i = 0; i < options.points; ++i) {
    const double share = options.points == 1 ? 0 : double(i) / double(options.points - 1);
    c.creepage.longitudinal = options.from + (to - options.from) * share;
    auto f = solve(c);
    if (!f.converged)
      throw std::runtime_error(
          fmt::format("no answer at creepage {:.6g}: {}; another number of --cells may do, or a "
                      "fast --theory",
                      c.creepage.longitudinal, f.reason));
    clean(f, c.friction * c.load, c.a + c.b);
    all.push_back({c.creepage, f});
  }
  return all;
}

// The creepage of the range at which the force along is `force`.
double creepage_for(double force, RollingCase c, const Solver& solve, double from, double to) {
  const auto fx = [&](double creepage) {
    c.creepage.longitudinal = creepage;
    return solve(c).fx;
  };
  const auto [low, high] = std::minmax({fx(from), fx(to)});
  if (!(low <= force && force <= high))
    throw InputError(
        fmt::format("force is {:.6g} N; allowed: what the range of creepage gives, "
                    "from {:.6g} to {:.6g} N",
                    force, low, high));
  return num::find_root([&](double creepage) { return fx(creepage) - force; }, std::min(from, to),
                        std::max(from, to), 1e-10)
      .x;
}

// The full theory's with the digits of its error; fast theories have none of their own.
void print_rows(const std::vector<Row>& all, double bound, double unit, bool full) {
  std::FILE* const to = tool::session().taken ? stderr : stdout;
  fmt::print(to, "\n{:>12} {:>12} {:>12} {:>12} {:>8} {:>7}\n", "creepage", "fx, N", "fy, N",
             "mz, N*m", "F/(mu N)", "stick");
  const auto text = [full](double value, double error) {
    return full ? tool::to_digits_of(value, error) : tool::to_text(value);
  };
  const auto share_text = [&](const CreepForces& f) {
    if (!(bound > 0)) return std::string{"-"};
    const double share = std::hypot(f.fx, f.fy) / bound;
    return full ? tool::to_digits_of(share, f.error) : tool::to_text(share);
  };
  for (const auto& [creepage, f] : all)
    fmt::print(to, "{:>12} {:>12} {:>12} {:>12} {:>8} {:>7.3f}\n",
               tool::to_text(creepage.longitudinal), text(f.fx, f.error * bound),
               text(f.fy, f.error * bound), text(f.mz, f.mz_error * unit), share_text(f),
               std::abs(f.stick_share));
}

// `unit` of the moment's error: mu N sqrt(a b) [N m].
std::string csv(const std::vector<Row>& all, double unit, bool full) {
  const auto estimate = [](double x, double of) {
    return std::isfinite(x) ? fmt::format("{:.2g}", x * of) : "nan";
  };
  std::string text =
      "longitudinal,lateral,spin_1_per_m,fx_N,fy_N,mz_N_m,stick_share,error_share,mz_error_N_m,"
      "warning\n";
  for (const auto& [creepage, f] : all)
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.6g},{},{},{}\n",
                        creepage.longitudinal, creepage.lateral, creepage.spin, f.fx, f.fy, f.mz,
                        std::abs(f.stick_share), estimate(f.error, 1), estimate(f.mz_error, unit),
                        table::csv_cell(warning_of(f, full)));
  return text;
}

void run(const Options& options) {
  tool::OutFolder out(options.out, {"curve.csv", "curve.json", "curve.png"});
  tool::Summary answer("Creep curve");
  answer.add("theory", "theory", options.theory);
  const MaterialPair pair = combine(options.contact.wheel, options.contact.rail);
  RollingCase c = contact_of(options.contact, pair, answer);
  c.creepage = {options.from, options.lateral, options.spin};
  const double bound = c.friction * c.load;
  if (!options.to && bound == 0)
    throw InputError("friction is 0, so that no creepage is large: give the end of the range, to");
  // Without an end: where the linear force is six times the bound, beyond the end of stick.
  const double slope = vermeulen_johnson_slopes(c.a / c.b, c.poisson).longitudinal;
  const double to = options.to ? *options.to : 6 / slope * bound / (c.shear_modulus * c.a * c.b);
  if (options.points > 1 && to == options.from)
    throw InputError(fmt::format("to is {:.6g}, and so is from; give a range, or points 1", to));
  answer.add("load_kN", "load N", c.load / units::kilonewton, "kN");
  answer.add("friction", "friction coefficient mu", c.friction, "");
  answer.add("shear_modulus_GPa", "shear modulus G", c.shear_modulus / units::gigapascal, "GPa");
  answer.add("poisson", "Poisson's ratio", c.poisson, "");
  if (std::abs(pair.dissimilarity) > 0.02)
    answer.warn(
        "similarity",
        fmt::format(
            "unlike materials (K = {:.3f}): their coupling of pressure and traction is left out",
            pair.dissimilarity));
  answer.add("lateral", "lateral creepage", options.lateral, "");
  answer.add("spin_1_per_m", "spin creepage", options.spin, "1/m");
  tool::Progress progress("points", double(options.points) + (options.force ? 12 : 0));
  const Solver solve = [&progress,
                        one = solver(options.theory, c.a / c.b, c.poisson, options.cells,
                                     options.coefficients == "computed")](const RollingCase& at) {
    progress.step();
    return one(at);
  };
  auto all = rows(options, c, solve, to);
  const bool full = options.theory == "full";
  compare_with_full(all, c);
  const auto size_of = [](const Row& row) { return std::hypot(row.forces.fx, row.forces.fy); };
  const Row& largest = *std::ranges::max_element(all, {}, size_of);
  answer.add("largest_force_N", "largest force",
             tool::Estimate{size_of(largest), largest.forces.error * bound}, "N");
  if (options.force) {
    answer.add("force_N", "force along, wanted", *options.force, "N");
    answer.add("creepage_at_force", "creepage for it",
               creepage_for(*options.force, c, solve, options.from, to), "");
  }
  progress.end();
  const double moment = bound * std::sqrt(c.a * c.b);
  add_warnings(answer, all, moment, full);
  if (!all.back().forces.reason.empty()) answer.add("note", "note", all.back().forces.reason);
  answer.print();
  if (!tool::session().json) print_rows(all, bound, moment, full);
  if (out) {
    out.add("curve.csv", csv(all, moment, full));
    out.add("curve.json", answer.json());
    out.figure(tools::scripts("creep") / "curve.gp", {"curve.csv"}, "curve.png");
  }
  out.commit();
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  options->contact.declare(parser);
  parser.quantity("--lateral", options->lateral, units::number, "lateral creepage",
                  tool::Range{-1, 1});
  parser.text("--spin", options->spin_text, "spin creepage, such as 0.2rad/m or 0.2 1/m");
  parser.quantity("--from", options->from, units::number, "longitudinal creepage, first",
                  tool::Range{-1, 1});
  parser.quantity("--to", options->to, units::number,
                  "and last; without it well beyond the end of stick", tool::Range{-1, 1});
  parser.quantity("--force", options->force, units::force,
                  "along; the creepage that gives it is sought in the range",
                  tool::Range{-1e12, 1e12});
  parser.count("--points", options->points, "of the range", 1, 100000);
  parser.choice("--theory", options->theory, theory_names(), "theory of rolling");
  parser.choice("--coefficients", options->coefficients, {"table", "computed"},
                "fast theories: Kalker's coefficients from his table (a/b 0.1 to 10), or computed");
  parser.count("--cells", options->cells, "full theory: cells along rolling", 4, 256);
  parser.out(options->out);
  parser.help(
      "Axes: x forward, y to the right, z down. Creepages are the wheel's speed over the rail's "
      "divided by the speed of rolling, spin its turning about z "
      "(positive from x to y). Forces and the moment about z are those of the wheel on the rail: a "
      "positive "
      "creepage gives a positive force. curve.csv: fx and fy in N, the moment mz in N m, "
      "stick_share, the part of the area that sticks, error_share, the error of the force over "
      "what friction bears, mz_error_N_m, that of the moment, and a warning.");
  return [options] {
    options->spin = spin_of(options->spin_text);
    run(*options);
  };
}

}  // namespace

tool::Tool curve_tool() {
  return {"curve", "creep forces of a contact of your own", declare};
}

}  // namespace railbook::creep_tool
