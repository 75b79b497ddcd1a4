/*
### `creep table`

A table of the forces for a vehicle code, which needs them millions of times. Its axes are the axis ratio and the
reduced creepages $G\,ab\,\xi/\mu N$, $G\,ab\,\eta/\mu N$ and $G(ab)^{3/2}\phi/\mu N$, so that it serves every load,
friction and size; the values are $F_x/\mu N$, $F_y/\mu N$ and $M_z/(\mu N\sqrt{ab})$. Negative longitudinal creepage
turns $F_x$; negative lateral creepage turns $F_y$, $M_z$ and the spin to look up, so that a quarter of the creepages is
enough. The error of linear interpolation is measured against the theory at points off the nodes and stated in the
answer and in the file, with a bound for each place. A fast theory has no error of its own; its table is compared with the full theory at 64 points.

    creep table --ratio-from 0.5 --ratio-to 2 --out mine
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <railbook/contact/material.hpp>
#include <railbook/rolling/force_table.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/progress.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "tools.hpp"

namespace railbook::creep_tool {

using namespace rolling;

namespace {

struct Options {
  ForceTableAxes axes;
  long ratios = 5, longitudinal = 13, lateral = 13, spin = 25, points = 2000, cells = 12;
  double poisson = contact::default_steel.poisson;
  std::string theory = "full", coefficients = "table";
  tool::Destination out;
};

std::string csv(const ForceTable& table, const Options& options, const InterpolationError& error) {
  std::string text = fmt::format(
      "# Creep forces by the theory \"{}\", Poisson's ratio {:g}. x = G a b xi/(mu N), y = G a b "
      "eta/(mu N), "
      "spin = G (a b)^1.5 phi/(mu N); a along rolling.\n"
      "# Symmetry: -x turns fx; -y turns fy, mz and the spin to look up. Interpolate linearly in "
      "ln(ratio) and "
      "arsinh(x/0.5), arsinh(y/0.5), arsinh(spin/0.5).\n"
      "# Error of that, of (fx, fy): largest {:.2g}, rms {:.2g}; of mz: largest {:.2g}, rms {:.2g} "
      "({} points "
      "off the nodes).\n"
      "# Bound of it at one place: the largest force_bound (of mu N) and moment_bound (of mu N "
      "sqrt(a b)) at the corners of its cell; {} of the points were within it.\n"
      "a_over_b,x,y,spin,fx,fy,mz,force_bound,moment_bound\n",
      options.theory, options.poisson, error.largest_force, error.rms_force, error.largest_moment,
      error.rms_moment, error.points, error.within_bound);
  for (std::size_t r = 0; r < table.ratios().size(); ++r)
    for (std::size_t i = 0; i < table.longitudinal().size(); ++i)
      for (std::size_t j = 0; j < table.lateral().size(); ++j)
        for (std::size_t k = 0; k < table.spin().size(); ++k) {
          const ForceShares& f = table.node(r, i, j, k);
          const InterpolationBound& bound = table.node_bound(r, i, j, k);
          text += fmt::format("{:.8g},{:.8g},{:.8g},{:.8g},{:.7g},{:.7g},{:.7g},{:.2g},{:.2g}\n",
                              table.ratios()[r], table.longitudinal()[i], table.lateral()[j],
                              table.spin()[k], f.fx, f.fy, f.mz, bound.force, bound.moment);
        }
  return text;
}

// What the theory itself says of its answers, at nodes and points together.
struct OwnError {
  double answers = 0, warned = 0, squares = 0, moment_squares = 0, largest = 0;
  std::string warning;

  void add(const CreepForces& f) {
    ++answers;
    if (!f.warning.empty()) ++warned, warning = f.warning;
    largest = std::max(largest, f.error);
    squares += f.error * f.error;
    moment_squares += f.mz_error * f.mz_error;
  }
  bool known() const { return std::isfinite(largest); }
  void add_to(tool::Summary& answer) const {
    if (warned > 0)
      answer.warn("range",
                  fmt::format("{} ({:.0f} of {:.0f} nodes and points)", warning, warned, answers));
    if (!known()) return;
    const double rms = std::sqrt(squares / answers);
    answer.add_error("theory_error_largest", "estimate of the theory's own error, largest", largest,
                     "of mu N");
    answer.add_error("theory_error_rms", "  root of the mean square", rms, "of mu N");
    answer.add_error("theory_error_moment_rms", "  of the moment",
                     std::sqrt(moment_squares / answers), "of mu N sqrt(a b)");
    if (rms > 0.1)
      answer.warn(
          "coarse",
          fmt::format("the cells are too coarse: error estimate {:.2g} mu N; give more", rms));
  }
};

// A fast theory has no error of its own: the table, theory and interpolation together, against the
// full theory at a few places off the nodes, and what the full theory's own error adds.
void compare_with_full(const ForceTable& table, const Options& options, tool::Summary& answer) {
  constexpr int places = 64, cells = 24;
  double own = 0, own_moment = 0;
  const ShareTheory full = [&](double ratio) {
    return shares_of(
        [&, solve = solver("full", ratio, options.poisson, cells)](const RollingCase& c) {
          const CreepForces f = solve(c);
          own = std::max(own, f.error), own_moment = std::max(own_moment, f.mz_error);
          return f;
        },
        ratio, options.poisson);
  };
  const char* const what = "table against the full theory, force, largest";
  try {
    const InterpolationError error = table.error(full, places);
    answer.add_error("against_full_force_largest", what, error.largest_force + own, "of mu N");
    answer.add_error("against_full_force_rms", "  root of the mean square",
                     std::hypot(error.rms_force, own), "of mu N");
    answer.add_error("against_full_moment_largest", "  moment, largest",
                     error.largest_moment + own_moment, "of mu N sqrt(a b)");
    answer.add_error("against_full_moment_rms", "  root of the mean square",
                     std::hypot(error.rms_moment, own_moment), "of mu N sqrt(a b)");
    answer.add("against_full_points", "measured at points off the nodes", double(error.points), "");
  } catch (const std::runtime_error& e) {
    answer.absent("against_full_force_largest", what,
                  fmt::format("the full theory has {}; try nearer axis ratios", e.what()));
  }
}

void run(Options options) {
  tool::OutFolder out(options.out, {"table.csv", "table.json"});
  options.axes.ratios = static_cast<int>(options.ratios);
  options.axes.longitudinal = static_cast<int>(options.longitudinal);
  options.axes.lateral = static_cast<int>(options.lateral);
  options.axes.spin = static_cast<int>(options.spin);
  if (options.axes.ratio_from == options.axes.ratio_to) options.axes.ratios = 1;
  tool::Progress progress("nodes and points", double(options.axes.ratios) *
                                                      options.axes.longitudinal *
                                                      options.axes.lateral * options.axes.spin +
                                                  double(options.points));
  OwnError own;
  const ShareTheory theory = [&](double ratio) {
    const Solver solve = solver(options.theory, ratio, options.poisson, options.cells,
                                options.coefficients == "computed");
    return shares_of(
        [&, solve](const RollingCase& c) {
          progress.step();
          const CreepForces f = solve(c);
          own.add(f);
          return f;
        },
        ratio, options.poisson);
  };
  const ForceTable table(options.axes, theory);
  const auto error = table.error(theory, static_cast<int>(options.points));
  progress.end();
  tool::Summary answer("Creep force table");
  answer.add("theory", "theory", options.theory);
  answer.add("nodes", "nodes",
             fmt::format("{} axis ratios x {} x {} x {} spins", table.ratios().size(),
                         table.longitudinal().size(), table.lateral().size(), table.spin().size()));
  answer.add("reach", "largest reduced creepage", options.axes.reach, "");
  answer.add("spin_reach", "largest reduced spin", options.axes.spin_reach, "");
  answer.add_error("error_force_largest", "interpolation error of the force, largest",
                   error.largest_force, "of mu N");
  answer.add_error("error_force_rms", "  root of the mean square", error.rms_force, "of mu N");
  answer.add_error("error_moment_largest", "of the moment, largest", error.largest_moment,
                   "of mu N sqrt(a b)");
  answer.add_error("error_moment_rms", "  root of the mean square", error.rms_moment,
                   "of mu N sqrt(a b)");
  answer.add("error_points", "measured at points off the nodes", double(error.points), "");
  answer.add("within_bound", "  of them within the bound at their place",
             double(error.within_bound), "", "force_bound and moment_bound of table.csv");
  own.add_to(answer);
  if (!own.known()) compare_with_full(table, options, answer);
  answer.print();
  if (out) {
    out.add("table.csv", csv(table, options, error));
    out.add("table.json", answer.json());
  }
  out.commit();
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  parser.choice("--theory", options->theory, theory_names(), "theory of rolling");
  parser.choice("--coefficients", options->coefficients, {"table", "computed"},
                "fast theories: Kalker's coefficients from his table (a/b 0.1 to 10), or computed");
  parser.quantity("--poisson", options->poisson, units::number, "Poisson's ratio",
                  tool::Range{0, 0.5});
  parser.quantity("--ratio-from", options->axes.ratio_from, units::number, "first axis ratio a/b",
                  tool::Range{1e-3, 1e3});
  parser.quantity("--ratio-to", options->axes.ratio_to, units::number, "and last",
                  tool::Range{1e-3, 1e3});
  parser.count("--ratios", options->ratios, "how many, evenly in the logarithm", 1, 1000);
  parser.quantity("--reach", options->axes.reach, units::number,
                  "largest reduced longitudinal and lateral creepage", tool::Range{1e-3, 1e6});
  parser.quantity("--spin-reach", options->axes.spin_reach, units::number, "largest reduced spin",
                  tool::Range{1e-3, 1e6});
  parser.count("--longitudinal", options->longitudinal, "nodes of longitudinal creepage", 2, 1000);
  parser.count("--lateral", options->lateral, "nodes of lateral creepage", 2, 1000);
  parser.count("--spin", options->spin, "nodes of spin, an odd number", 3, 1001);
  parser.count("--points", options->points, "off the nodes, where the error is measured", 1,
               10000000);
  parser.count("--cells", options->cells, "full theory: cells along rolling", 4, 128);
  parser.out(options->out);
  parser.help(
      "Axes: x forward, y to the right, z down. Creepages are the wheel's speed over the rail's "
      "divided by the speed of rolling, spin its turning about z "
      "(positive from x to y). Forces and the moment about z are those of the wheel on the rail: a "
      "positive "
      "creepage gives a positive force. Columns: a_over_b, the creepages x, y and spin, and fx, fy "
      "and mz, all "
      "reduced as the header says; force_bound and moment_bound, of which the largest at the "
      "corners of a cell of nodes is an estimated bound of the error of interpolation in it; the "
      "answer says at how many points it held. A negative longitudinal "
      "creepage turns Fx; a negative "
      "lateral one turns "
      "Fy, Mz and the spin to look up. The answer has the error of interpolation against the "
      "theory itself, and the full theory's own error or, for a fast theory, the error of its "
      "table against the full theory (against_full).");
  return [options] { run(*options); };
}

}  // namespace

tool::Tool table_tool() {
  return {"table", "a table of creep forces for a vehicle code", declare};
}

}  // namespace railbook::creep_tool
