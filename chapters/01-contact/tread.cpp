/*** ### Which tread did the program have?

::: {.fold summary="The tread from which each printed number follows: 12.25 in to 12.32 in"}

The first two of Hertz's formulas in Example 1 give both curvatures back from the printed $a$, $b$
and $\delta$, without the force or the elastic constants. The function `shape_of` does this. The
wheel comes out at {{fitted-wheel}}, next to the drawn 18. The tread comes out at {{fitted-tread}}.
It is the sensitive number, because its curvature nearly cancels that of the crown: a tread
{{tread-per-percent}} larger changes $a$ by 1 %.

{{code: tread.cpp shape_of}}

For each printed number that depends on the tread there is a tread that gives it exactly. The force
and the moment of Example 2 are computed without a mesh of columns. COUNTACT's column of Table 2
depends on rows and moves of the boundary that the paper does not print. So eight meshes of 7 to 11
columns and 7 to 17 rows are tried, with free moves and with inward moves only, and the closest
result is shown:

{{treads}}

The numbers do not agree on one tread. The force of Example 2 follows from {{force-tread}}, Hertz's
column from {{fitted-tread}}, the moment of Example 2 from {{moment-tread}}, and COUNTACT's column
from about {{column-tread}}. The mesh of the paper's program may explain a part of this: on ten
graded columns the force comes out {{coarse-force}} too high, and then the printed one follows from
{{coarse-tread}}.

All lie within {{treads-off}} of 12.34 in, which this page uses because the lettering shows it. With
12.28 in, closer to the three results that do not depend on a mesh, the force of Example 2 would be
{{near-force}} off and the moment {{near-moment}}. The tread is known from nothing but the lettering
and these numbers; so "consistent" means here that no printed number asks for a tread more than
{{treads-off}} from 12.34 in.

The force of Hertz's column is not that of its own ellipse: $\tfrac23\pi ab\,p_0$ of the same column
is {{printed-load}}, with the rounding of its factors {{printed-load-range}}. Our text may misread a
digit ({{misread}}), Hertz's coefficients may come from a table of three digits, or the force may be
copied from COUNTACT's column, which has the same five digits. We cannot tell which.
{{outcome:table-2/own-load}}

:::

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "sections.hpp"

namespace railbook::contact_chapter {

Shape shape_of(double a, double b, double delta) {
  const EllipticIntegrals i = elliptic_integrals(2 * std::log(b / a));
  const double curvature_a = delta * i.d / (i.k * a * a), curvature_b = delta * i.b / (i.k * b * b);
  return {1 / (2 * curvature_b), 1 / (1 / crown_radius - 2 * curvature_a)};
}

std::array<double, 4> in_print_units(const HertzContact& h) {
  return {h.force / lbf, h.p_max / psi, h.a / inch, h.b / inch};
}

std::array<double, 4> in_print_units(const NormalContact& c) {
  return {c.force / lbf, c.p_max / psi, c.x_max / inch, c.y_max / inch};
}

namespace {

// The largest relative deviation from one column of Table 2.
double worst_off(const table::CsvTable& printed, const char* column,
                 const std::array<double, 4>& values) {
  double worst = 0;
  for (std::size_t k = 0; k < 4; ++k)
    worst = std::max(
        worst,
        std::abs(values[k] / report::printed_number(printed.at(table_2_keys[k], column)) - 1));
  return worst;
}

// Example 1 on the eight meshes that the paper may have had.
std::vector<NormalContact> on_eight_meshes(double tread, bool inward_only) {
  std::vector<NormalContact> found;
  for (const auto& [columns, rows] :
       {std::pair{7, 7}, {7, 9}, {7, 17}, {9, 7}, {9, 9}, {9, 17}, {11, 9}, {11, 11}}) {
    CountactOptions options{uniform_columns(columns), rows};
    options.inward_only = inward_only;
    found.push_back(countact_2(on_the_crown(tread), delta_1, modulus, options).contact);
  }
  return found;
}

// The least deviation from COUNTACT's column over them.
double best_mesh(const table::CsvTable& printed, double tread, bool inward_only) {
  double best = units::infinity;
  for (const NormalContact& c : on_eight_meshes(tread, inward_only))
    if (c.converged) best = std::min(best, worst_off(printed, "COUNTACT-2", in_print_units(c)));
  return best;
}

// By how much their contacts are shorter than Hertz's: "0.1 to 1.4 %".
std::string shortfalls() {
  double least = units::infinity, most = -units::infinity;
  for (const bool inward_only : {false, true})
    for (const NormalContact& c : on_eight_meshes(tread_radius, inward_only)) {
      const double missing = 1 - c.x_max / hertz_1().a;
      least = std::min(least, missing), most = std::max(most, missing);
    }
  return fmt::format("{:.1f} to {:.1f} %", 100 * least, 100 * most);
}

NormalContact example_2_with(double tread) {
  CgFftOptions options;
  options.edge_x = 0;
  return solve_cg_fft(on_the_jump(tread), delta_2, modulus, options).contact;
}

// COUNTACT-1 on as many columns as the paper may have had.
double coarse_force(double tread) {
  return countact_1(on_the_jump(tread), delta_2, modulus, {graded_columns(6, 4), 9}).contact.force;
}

// The tread at which `values`, one a tread, reach a printed number: linear between neighbours.
double asks_for(const std::vector<double>& treads, const std::vector<double>& values,
                double printed) {
  for (std::size_t i = 1; i < treads.size(); ++i) {
    const double share = (printed - values[i - 1]) / (values[i] - values[i - 1]);
    if (share >= 0 && share <= 1) return treads[i - 1] + share * (treads[i] - treads[i - 1]);
  }
  return units::nan;
}

// The tread of the least deviation.
double best(const std::vector<double>& treads, const std::vector<double>& off) {
  return treads[static_cast<std::size_t>(std::min_element(off.begin(), off.end()) - off.begin())];
}

void treads(report::Item& item) {
  const table::CsvTable printed = item.printed("table-2.csv"), jump = item.printed("example-2.csv");
  const double force = report::printed_number(jump.at("F", "printed"));
  const double moment = report::printed_number(jump.at("M", "printed"));
  item.columns({{"tread, in", "{:.2f}"},
                {"off Hertz's column, %", "{:.2f}"},
                {"off COUNTACT's, free moves, %", "{:.2f}"},
                {"off COUNTACT's, inward moves, %", "{:.2f}"},
                {"off the force of Example 2, %", "{:+.2f}"},
                {"off the moment of Example 2, %", "{:+.2f}"}});
  const std::vector<double> treads{12.24, 12.26, 12.28, 12.30, 12.32, 12.34, 12.36};
  std::vector<double> forces, coarse, moments, free, inward;
  for (const double t : treads) {
    const double tread = t * inch;
    const NormalContact c = example_2_with(tread);
    forces.push_back(c.force / lbf);
    coarse.push_back(coarse_force(tread) / lbf);
    moments.push_back(c.moment_y / (inch * lbf));
    free.push_back(best_mesh(printed, tread, false));
    inward.push_back(best_mesh(printed, tread, true));
    item.add_row(t, 100 * worst_off(printed, "Hertz", in_print_units(hertz_1(tread))),
                 100 * free.back(), 100 * inward.back(), 100 * (forces.back() / force - 1),
                 100 * (moments.back() / moment - 1));
  }
  const double by_force = asks_for(treads, forces, force);
  const double by_moment = asks_for(treads, moments, moment);
  const auto print = [&](const char* key) {
    return report::printed_number(printed.at(key, "Hertz"));
  };
  const double by_hertz = shape_of(print("a") * inch, print("b") * inch, delta_1).tread / inch;
  item.add_row("each asks for", fmt::format("{:.2f} in", by_hertz),
               fmt::format("{:.2f} in", best(treads, free)),
               fmt::format("{:.2f} in", best(treads, inward)), fmt::format("{:.3f} in", by_force),
               fmt::format("{:.3f} in", by_moment));
  const auto signed_percents = [](double found, double print) {
    const double off = 100 * (found / print - 1);
    return fmt::format("{}{:.2f} %", off < 0 ? "−" : "+", std::abs(off));
  };
  item.value("near-force", signed_percents(forces[2], force));  // of 12.28 in
  item.value("near-moment", signed_percents(moments[2], moment));
  double off = 0;
  for (const double t : {by_force, by_moment, by_hertz})
    off = std::max(off, std::abs(t * inch / tread_radius - 1));
  const double column =
      std::min(best_mesh(printed, tread_radius, false), best_mesh(printed, tread_radius, true));
  const double finer = example_2_with(tread_radius).force / lbf;
  item.expect_checks(2);
  item.at_most("asked", "12.34 in against the tread that any number without a mesh asks for", "%",
               100 * off, 1, "1 % of force in Example 2 is 1 % of the tread");
  item.at_most("drawn", "12.34 in against COUNTACT's column, the better rule of moves", "%",
               100 * column, 0.5, "eight meshes scatter by this");
  item.value("a-short", shortfalls());
  item.value("force-tread", by_force, "in", "{:.2f}");
  item.value("moment-tread", by_moment, "in", "{:.2f}");
  item.value("column-tread", best(treads, inward), "in", "{:.2f}");
  item.value("coarse-force", 100 * (coarse_force(tread_radius) / lbf / finer - 1), "%", "{:.1f}");
  item.value("coarse-tread", asks_for(treads, coarse, force), "in", "{:.2f}");
  item.value("treads-off", 100 * off, "%", "{:.1f}");
}

}  // namespace

const report::Section which_tread{report::table("treads", treads)};

}  // namespace railbook::contact_chapter
