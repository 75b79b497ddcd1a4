/*** ## Example 1: a contact that Hertz can check

Wheel and rail touch on the crown, where no radius changes. The gap is then quadratic, and Hertz's
answer is exact: the contact is an ellipse. Across the rail the tread is *hollow*: it is curved in
the same sense as the crown and nearly fits it. Along the rail the round wheel stands on a straight
rail:

$$f(x,y)=\alpha x^2+\beta y^2,\qquad \alpha=\frac12\left(\frac{1}{R_r}-\frac{1}{R_t}\right),\qquad \beta=\frac{1}{2R_w}.$$

$R_r$ is the radius of the rail's crown, $R_t$ that of the hollow tread and $R_w$ that of the wheel;
$\alpha$ and $\beta$ are half the curvatures of the gap.

::: {.fold summary="The section across the rail"}

{{fig-06}}


:::
The paper gives the approach, $\delta=0.0004$ in, and the radii in a drawing only. Its lettering
reads "R*18" in our text, the wheel's radius of 18 in, and "R=J2.34", the radius of the tread, which
we read as 12.34 in. The crown's radius, 10 in, stands in the text of Example 2.

Hertz's answer is in closed form. Let $a$ and $b$ be the half lengths of the contact across the rail
and along it, and $p_0$ its peak pressure. The formulas need the complete elliptic integral
$\mathrm{K}$ of the modulus $\kappa=\sqrt{1-(b/a)^2}$, which is split into two parts (D and B in
tables, `d` and `b` in the code):

$$\mathrm{K}=\int_0^{\pi/2}\frac{d\theta}{\sqrt{1-\kappa^2\sin^2\theta}}=\mathrm{K}_a+\mathrm{K}_b,\qquad \mathrm{K}_a=\int_0^{\pi/2}\frac{\sin^2\theta\,d\theta}{\sqrt{1-\kappa^2\sin^2\theta}}.$$

With them

$$a^2=\frac{\delta\,\mathrm{K}_a}{\alpha\,\mathrm{K}},\qquad b^2=\frac{\delta\,\mathrm{K}_b}{\beta\,\mathrm{K}},\qquad p_0=\frac{E^*\delta}{b\,\mathrm{K}},\qquad F=\tfrac23\pi ab\,p_0.$$

The function `unit_contact` evaluates these formulas for $\delta=1$ and $E^*=1$; all other contacts follow by scaling. Its `flat` and `sharp` are the smaller and the larger of $\alpha$ and
$\beta$. It first finds the shape $b/a$ that the first two formulas give for the ratio of the two.
It solves for $\ln[(b/a)^2]$ and not for $1-(b/a)^2$, from which a small $b/a$ cannot be recovered.

{{code: contact/hertz.cpp unit_contact}}

The paper's Table 2 has these four quantities, $F$, $p_0$, $a$ and $b$. It gives each by Hertz and
by COUNTACT-2, the variant of the program for two axes of symmetry, with the error in per cent. The
numbers of COUNTACT-2 depend on its mesh; our mesh has nine columns, as in the paper's Figure 2, and
nine rows.

{{table-2: rows}}

The method agrees with Hertz to {{accuracy-range}} in the worst of the four quantities when mesh and
tread are varied. The paper says that patch and pressure are ellipsoidal, without a number. Here no
cell's pressure differs from Hertz's by more than {{off-ellipsoid}} of the peak. In the single rows
the paper's errors, 0 to 2 %, differ from ours. Its error in $a$ is more than on any of the eight
meshes of {{treads}} ({{a-short}}). Most of it has another reason: the printed $a$ of COUNTACT is
{{printed-a-short}} below Hertz's for 12.34 in, much like ours, but the printed $a$ of Hertz belongs
to another tread.

### Does the region only shrink?

The paper's Figure 7 shows, by its caption, the mesh shrinking from the interpenetration curve to
the contact, with "rapid convergence of the solution". Here each step more than halves what the
force still lacks of its last value. After three steps the half lengths are within {{after-three}} of
Hertz's; after four, what the force lacks is less than the error of the mesh.

{{fig-07}}

"The new candidate contact boundary will be inside the old one", says the paper. This is what
happens on every mesh until the candidate comes within {{outward-margin}} of the true boundary (the
moves of step 4 are meant). But a mesh locates the edge to about a per cent, so on every mesh a move
goes too far, to a boundary inside the true one. Later moves then bring it back, outward by up to {{outward}} of the half width. The outermost
place from which a boundary moved outward is {{outward-from}} times as far out as Hertz's ellipse,
depending on the mesh.

::: {.fold summary="Each mesh, and where its boundary moves outward"}

{{moves}}

:::

Forbidding outward moves costs little. If the boundary may only move inward, the iteration
converges as well, to a contact {{inward-short}} shorter than Hertz's, against {{free-short}} with
free moves; the force changes by less than {{inward-force}}.

The paper's run took 5.7 s on an IBM 370/168 and cost $2.83 with compilation.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sections.hpp"

namespace railbook::contact_chapter {

const CountactResult& nine_by_nine() {
  static const CountactResult result = countact_2(on_the_crown(), delta_1, modulus);
  return result;
}

namespace {

// The largest difference between the cells' pressures and Hertz's ellipsoid, as a share of its
// peak.
double off_ellipsoid(const NormalContact& c, const HertzContact& h) {
  double worst = 0;
  for (Eigen::Index i = 0; i < c.x.size(); ++i)
    worst = std::max(worst, std::abs(c.p[i] - hertz_pressure(h, c.x[i], c.y[i])) / h.p_max);
  return worst;
}

struct Range {
  double low, high;
};

// What a printed text may stand for.
Range rounded(const std::string& text) {
  const double value = report::printed_number(text), half = report::half_last_digit(text);
  return {value - half, value + half};
}

// 2/3 pi a b p0 [lbf] of texts, with their rounding.
Range load_of(const std::string& a, const std::string& b, const std::string& p0) {
  const Range x = rounded(a), y = rounded(b), p = rounded(p0);
  return {2 * units::pi / 3 * x.low * y.low * p.low, 2 * units::pi / 3 * x.high * y.high * p.high};
}

bool overlap(const Range& one, const Range& other) {
  return one.low <= other.high && other.low <= one.high;
}

// The texts that differ from this one in one digit.
std::vector<std::string> misread(const std::string& text) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < text.size() && text[i] != 'e'; ++i)
    for (char digit = '0'; digit <= '9'; ++digit)
      if (text[i] != '.' && text[i] != digit)
        all.push_back(std::string{text}.replace(i, 1, 1, digit));
  return all;
}

// The readings of a, b or p0 of Hertz's column that differ in one digit, follow the printed %
// error, and make the column one contact.
std::vector<std::string> readings(const table::CsvTable& printed) {
  const auto text = [&](const char* key, const char* column) { return printed.at(key, column); };
  std::vector<std::string> found;
  for (const std::string key : {"a", "b", "p0"})
    for (const std::string& reading : misread(text(key.c_str(), "Hertz"))) {
      const auto or_read = [&](const char* other) {
        return other == key ? reading : text(other, "Hertz");
      };
      const Range hertz = rounded(reading), countact = rounded(text(key.c_str(), "COUNTACT-2"));
      const double one = 100 * (countact.low / hertz.high - 1);
      const double two = 100 * (countact.high / hertz.low - 1);
      const Range error{std::min(std::abs(one), std::abs(two)),
                        std::max(std::abs(one), std::abs(two))};
      if (overlap(error, rounded(text(key.c_str(), "error"))) &&
          overlap(load_of(or_read("a"), or_read("b"), or_read("p0")), rounded(text("F", "Hertz"))))
        found.push_back(fmt::format("{} = {} for {}", key, reading, text(key.c_str(), "Hertz")));
    }
  return found;
}

// The largest relative deviation of COUNTACT-2 from Hertz, of F, p0, a and b.
double worst_quantity(int cells, double tread) {
  const auto exact = in_print_units(hertz_1(tread));
  const auto found = in_print_units(
      countact_2(on_the_crown(tread), delta_1, modulus, {uniform_columns(cells), cells}).contact);
  double worst = 0;
  for (std::size_t k = 0; k < 4; ++k) worst = std::max(worst, std::abs(found[k] / exact[k] - 1));
  return worst;
}

// All of Table 2, as it is printed and as it is computed.
void show_table_2(report::Item& item, const table::CsvTable& printed,
                  const std::array<double, 4>& hertz, const std::array<double, 4>& countact) {
  item.columns({"", "Hertz, printed", "computed", "COUNTACT-2, printed", "computed",
                "error in %, printed", "computed"});
  const std::array<const char*, 4> names{"F, lbf", "p₀, psi", "a, in", "b, in"};
  const std::array<int, 4> decimals{1, 0, 5, 5};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto text = [&](const char* column) {
      const std::string& print = printed.at(table_2_keys[k], column);
      return k == 1 ? fmt::format("{:.0f}", report::printed_number(print)) : print;
    };
    const auto value = [&](double x) { return fmt::format("{:.{}f}", x, decimals[k]); };
    item.add_row(names[k], text("Hertz"), value(hertz[k]), text("COUNTACT-2"), value(countact[k]),
                 printed.at(table_2_keys[k], "error"),
                 fmt::format("{:.2f}", 100 * std::abs(countact[k] / hertz[k] - 1)));
  }
}

void table_2(report::Item& item) {
  const table::CsvTable printed = item.printed("table-2.csv");
  const auto in_print = [&](const char* key, const char* column) {
    return report::printed_number(printed.at(key, column));
  };
  const double a = in_print("a", "Hertz") * inch, b = in_print("b", "Hertz") * inch;
  const Shape shape = shape_of(a, b, delta_1);
  const auto hertz = in_print_units(hertz_1()), fitted = in_print_units(hertz_1(shape.tread));
  const auto countact = in_print_units(nine_by_nine().contact);
  const double load = 2 * units::pi / 3 * a * b * in_print("p0", "Hertz") * psi / lbf;
  show_table_2(item, printed, hertz, countact);
  const std::array<double, 4> allowed{0.01, 0.006, 0.015, 0.01};
  item.expect_checks(12);
  for (std::size_t k = 0; k < 4; ++k) {
    const report::Row row = item.row(printed, table_2_keys[k]);
    row.print("Hertz", hertz[k],
              report::relative(allowed[k],
                               "a tread within 1 % of 12.34 in would give the print; the "
                               "tread is a damaged number, not known otherwise"));
    row.print(
        "COUNTACT-2", countact[k],
        report::relative(
            0.005, "the paper's rows and its moves are not printed: eight meshes scatter by this"));
  }
  const auto close = report::relative(0.003, "a and b have four digits, and fix the tread");
  item.print("F-fitted", "force by Hertz, tread fitted to the printed a, b, δ", "lbf",
             printed.at("F", "Hertz"), fitted[0], close);
  item.print("p0-fitted", "peak pressure p₀ by Hertz, tread fitted to the printed a, b, δ", "psi",
             printed.at("p0", "Hertz"), fitted[1], close);
  const auto error = [&](const char* key) {
    return 100 * std::abs(in_print(key, "COUNTACT-2") / in_print(key, "Hertz") - 1);
  };
  item.claims({{"errors", {error("F"), error("p0"), error("a"), error("b")}}});
  const Range loads =
      load_of(printed.at("a", "Hertz"), printed.at("b", "Hertz"), printed.at("p0", "Hertz"));
  const std::vector<std::string> others = readings(printed);
  item.consistent(
      "own-load", "F, p₀, a and b of Hertz's column belong to one contact, but for one digit",
      !overlap(loads, rounded(printed.at("F", "Hertz"))) && !others.empty(),
      fmt::format(
          "as printed they do not: $\\frac23\\pi ab\\,p_0$ is {:.1f} to {:.1f} lbf with its "
          "rounding; with {} they do",
          loads.low, loads.high, fmt::join(others, " or ")),
      "a digit that our text misreads is one of three possible reasons");
  report::Trial trial = item.trial("accuracy", "the largest error against Hertz", "{:.1f} %",
                                   [](double percent) { return percent < 2; });
  trial.vary("columns and rows", [](const report::Setting& s) {
    return 100 * worst_quantity(static_cast<int>(s.number), tread_radius);
  });
  trial.vary("tread",
             [](const report::Setting& s) { return 100 * worst_quantity(9, s.number * inch); });
  item.claim("accuracy", "the method agrees with Hertz to 2 % in the worst quantity", trial,
             trial.range() + " in the worst quantity");
  item.value("printed-a-short", 100 * (1 - in_print("a", "COUNTACT-2") / hertz[2]), "%", "{:.1f}");
  item.value("off-ellipsoid", 100 * off_ellipsoid(nine_by_nine().contact, hertz_1()), "%",
             "{:.1f}");
  item.value("accuracy-range", trial.range());
  item.value("fitted-tread", shape.tread / inch, "in", "{:.2f}");
  item.value("fitted-wheel", shape.along / inch, "in", "{:.1f}");
  item.value("tread-per-percent", 100 * (shape.tread / shape_of(1.01 * a, b, delta_1).tread - 1),
             "%", "{:.1f}");
  item.value("printed-load", load, "lbf", "{:.1f}");
  item.value("printed-load-range", fmt::format("{:.1f} to {:.1f} lbf", loads.low, loads.high));
  item.value("printed-load-off", 100 * (in_print("F", "Hertz") / load - 1), "%", "{:.1f}");
  item.value("misread", fmt::format("{}", fmt::join(others, " or ")));
}

void draw_development(report::Item& item, const HertzContact& exact) {
  auto& outlines = item.data({"iteration", "x_in", "y_in"});
  for (std::size_t k = 0; k < 4; ++k) {
    const ColumnMesh& mesh = nine_by_nine().history.at(k).mesh;
    const auto m = mesh.half_width.size();
    outlines.add(double(k), mesh.x_edges[0] / inch, 0.0);
    for (Eigen::Index j = 0; j < m; ++j)
      outlines.add(double(k), draw::centre(mesh, j) / inch, mesh.half_width[j] / inch);
    outlines.add(double(k), mesh.x_edges[m] / inch, 0.0);
    outlines.gap();
  }
  draw::cells(item.data("mesh", {"x_in", "y_in", "dx_in", "dy_in"}), nine_by_nine().contact,
              -1e-9 * exact.b);
  auto& ellipse = item.data("hertz", {"x_in", "y_in"});
  for (int i = 0; i <= 180; ++i) {
    const double t = i * units::degree;
    ellipse.add(exact.a * std::cos(t) / inch, exact.b * std::sin(t) / inch);
  }
}

void fig_07(report::Item& item) {
  const CountactResult& result = nine_by_nine();
  const HertzContact exact = hertz_1();
  draw_development(item, exact);
  const double last = result.contact.force, mesh_error = std::abs(last - exact.force);
  std::array<double, 4> left{};
  for (std::size_t k = 0; k < 4; ++k) left[k] = std::abs(result.history.at(k).force - last);
  item.claims({{"rapid",
                {100 * mesh_error / exact.force, left[1] / left[0], left[2] / left[1],
                 left[3] / mesh_error}}});
  const ColumnMesh& third = result.history.at(3).mesh;
  item.value("after-three",
             100 * std::max(std::abs(third.x_edges[third.x_edges.size() - 1] / exact.a - 1),
                            std::abs(third.half_width.maxCoeff() / exact.b - 1)),
             "%", "{:.1f}");
  item.rebuilt("our text has the caption of the figure; the final mesh is checked in Table 2");
}

// The moves of the boundary on one mesh of Example 1.
struct Moves {
  bool converged = false;
  double outward = 0;  // the largest outward move, relative to the half width
  double from = 0;     // the outermost point that moves outward, in units of Hertz's ellipse
  double off_a = 0,
         off_force = 0;  // the contact against Hertz's: what a lacks, what F has too much
};

// Moves below the tolerance at which the iteration stops are none.
Moves moves_on(int cells, Fit fit, bool inward_only) {
  CountactOptions options{uniform_columns(cells), cells, fit};
  options.inward_only = inward_only;
  const CountactResult run = countact_2(on_the_crown(), delta_1, modulus, options);
  const HertzContact exact = hertz_1();
  Moves moves{run.contact.converged, 0, 0, 1 - run.contact.x_max / exact.a,
              run.contact.force / exact.force - 1};
  const auto note = [&](double move, double start) {
    if (move <= options.tolerance) return;
    moves.outward = std::max(moves.outward, move);
    moves.from = std::max(moves.from, start);
  };
  for (const CountactStep& step : run.history) {
    const ColumnMesh& mesh = step.mesh;
    const auto m = mesh.half_width.size();
    note((step.new_x_max - mesh.x_edges[m]) / mesh.x_edges[m], mesh.x_edges[m] / exact.a);
    for (Eigen::Index j = 0; j < m; ++j)
      note((step.new_half[j] - mesh.half_width[j]) / mesh.half_width.maxCoeff(),
           std::hypot(draw::centre(mesh, j) / exact.a, mesh.half_width[j] / exact.b));
  }
  return moves;
}

// "0.5 to 3.6 %".
std::string percents(std::pair<double, double> range) {
  return fmt::format("{:.1f} to {:.1f} %", 100 * range.first, 100 * range.second);
}

void moves(report::Item& item) {
  item.columns({"columns and rows",
                "points of the parabola",
                {"largest outward move, %", "{:.1f}"},
                {"from, in units of Hertz's ellipse", "{:.3f}"},
                {"a too short, free moves, %", "{:.2f}"},
                {"a too short, inward moves, %", "{:.2f}"},
                {"F too large, free moves, %", "{:.2f}"},
                {"F too large, inward moves, %", "{:.2f}"}});
  bool rule = true;
  double force_change = 0;
  std::array<std::pair<double, double>, 6> ranges;
  ranges.fill({units::infinity, -units::infinity});
  for (const int cells : {9, 13, 17, 25})
    for (const Fit fit : {Fit::two_points, Fit::three_points_guarded}) {
      const Moves free = moves_on(cells, fit, false), inward = moves_on(cells, fit, true);
      // An edge that the mesh locates to 1 % counts as the true one.
      rule = rule && free.converged && inward.converged && free.outward > 0 && free.from < 1.01;
      const std::array<double, 6> row{free.outward, free.from,      free.off_a,
                                      inward.off_a, free.off_force, inward.off_force};
      for (std::size_t k = 0; k < row.size(); ++k)
        ranges[k] = {std::min(ranges[k].first, row[k]), std::max(ranges[k].second, row[k])};
      force_change = std::max(force_change, std::abs(inward.off_force - free.off_force));
      item.add_row(fmt::format("{}", cells), fit == Fit::two_points ? "2" : "3, one-valued",
                   100 * row[0], row[1], 100 * row[2], 100 * row[3], 100 * row[4], 100 * row[5]);
    }
  item.expect_checks(1);
  item.consistent(
      "inside",
      "the new candidate boundary will be inside the old one, while that encloses the contact",
      rule,
      fmt::format(
          "no outward move starts beyond {:.3f} of Hertz's ellipse; nearer to it every mesh "
          "has some, of {} of the half width",
          ranges[1].second, percents(ranges[0])),
      "the paper states no condition; it prints neither its fit nor the tolerance at which it "
      "stops");
  item.value("outward", 100 * ranges[0].second, "%", "{:.1f}");
  item.value("outward-margin", 100 * (ranges[1].second - 1), "%", "{:.1f}");
  item.value("outward-from", fmt::format("{:.3f} to {:.3f}", ranges[1].first, ranges[1].second));
  item.value("free-short", percents(ranges[2]));
  item.value("inward-short", percents(ranges[3]));
  item.value("inward-force", 0.05 * std::ceil(100 * force_change / 0.05), "%", "{:.2f}");
}

void fig_06(report::Item& item) {
  draw::profiles(item, crown_radius, -1.5 * inch, 1.5 * inch);
  item.sketch("the bodies of Example 1, in the plane of the wheel axis");
}

}  // namespace

const report::Section example_1{report::figure("fig-06", fig_06), report::table("table-2", table_2),
                                report::figure("fig-07", fig_07), report::table("moves", moves)};

}  // namespace railbook::contact_chapter
