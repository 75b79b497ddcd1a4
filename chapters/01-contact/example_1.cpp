/*** ## Example 1: a contact that Hertz can check

Wheel and rail meet where all four radii are uniform, so the exact answer is an ellipse. Across the rail, the concave tread of the wheel embraces the
crown; along the rail the wheel rolls:

$$f(x,y)=\frac{x^2}{2}\left(\frac{1}{R_r}-\frac{1}{R_t}\right)+\frac{y^2}{2R_w}.$$

{{fig-06}}

The paper gives the approach, $\delta=.0004$ in, and shows the radii only in drawings: wheel $R_w=18$ in, and a tread radius that the damaged scan
shows as "J2.34". The crown, 10 in, is in the text of Example 2. With $R_t=12.34$ in:

{{table-2}}

{{code: contact/hertz.cpp unit_contact}}

Patch and pressure "have the well-known ellipsoidal distribution": here each cell's pressure is within {{off-ellipsoid}} of the peak of Hertz's, on a mesh of nine by nine. The paper gives no number to
hold this against.

### What the printed ellipse says about the geometry

Hertz's semi-axes and the approach are tied by $a^2=\delta D/(KA)$, $b^2=\delta B_e/(KB)$, where $K$ and its two parts $B_e+D=K$ are complete elliptic
integrals of $b/a$ alone. So the printed $a$, $b$ and $\delta$ give both curvatures back, without the load or the elastic constants: the wheel comes out at
{{fitted-wheel}}, next to the drawn 18, and the tread at {{fitted-tread}}. The tread is the sensitive number: it nearly cancels the crown, and {{tread-per-percent}}
more of it moves $a$ by a whole per cent.
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sections.hpp"

namespace railbook::contact_chapter {

const CountactResult& nine_by_nine() {
  static const CountactResult result = countact_2(on_the_crown(), delta_1, modulus);
  return result;
}

namespace {

struct Shape {
  double along = 0;  // relative radius along the rail [m]
  double tread = 0;  // the tread that makes the other one, on the 10 in crown [m]
};

Shape shape_of(double a, double b, double delta) {
  const EllipticIntegrals i = elliptic_integrals(2 * std::log(b / a));
  const double curvature_a = delta * i.d / (i.k * a * a), curvature_b = delta * i.b / (i.k * b * b);
  return {1 / (2 * curvature_b), 1 / (1 / crown_radius - 2 * curvature_a)};
}

/***
The printed columns say two more things about themselves. The load of Hertz's column is not $\tfrac23\pi ab\,p_0$ of the same column, which is {{printed-load}}, so the
theory was read from a chart or a short table. And the load is the same number in both columns, as if Hertz had been asked for COUNTACT's load and not for the approach.

### Which tread did the program have?

COUNTACT's column depends on its mesh, of which the paper prints the nine columns of Figure 2, and on how the boundary may move. Eight meshes of 7 to 11 columns and 7 to 17 rows,
with free and with inward moves only, against the four numbers of that column; Hertz's column; and Example 2, whose moment is independent of both:

{{treads}}

Hertz's column fits 12.28 in best, the moment of Example 2 {{moment-tread}}, COUNTACT's column with inward moves 12.30 to 12.32, with free moves 12.34: the tread is
12.28 to 12.34 in, and 1 % of force is the resolution of the identification. The drawn 12.34 is used from here on.
*/

constexpr std::array<const char*, 4> keys{"F", "p0", "a", "b"};

// The largest relative deviation from one column of Table 2.
double worst_off(const table::CsvTable& printed, const char* column,
                 const std::array<double, 4>& values) {
  double worst = 0;
  for (std::size_t k = 0; k < 4; ++k)
    worst = std::max(worst,
                     std::abs(values[k] / report::printed_number(printed.at(keys[k], column)) - 1));
  return worst;
}

std::array<double, 4> in_print_units(const HertzContact& h) {
  return {h.force / lbf, h.p_max / psi, h.a / inch, h.b / inch};
}

std::array<double, 4> in_print_units(const NormalContact& c) {
  return {c.force / lbf, c.p_max / psi, c.x_max / inch, c.y_max / inch};
}

// The least deviation from COUNTACT's column over eight meshes.
double best_mesh(const table::CsvTable& printed, double tread, bool inward_only) {
  double best = units::no_limit;
  for (const auto& [columns, rows] :
       {std::pair{7, 7}, {7, 9}, {7, 17}, {9, 7}, {9, 9}, {9, 17}, {11, 9}, {11, 11}}) {
    CountactOptions options{uniform_columns(columns), rows};
    options.inward_only = inward_only;
    const NormalContact c = countact_2(on_the_crown(tread), delta_1, modulus, options).contact;
    if (c.converged) best = std::min(best, worst_off(printed, "countact", in_print_units(c)));
  }
  return best;
}

double moment_of_example_2(double tread) {
  CgFftOptions options;
  options.edge_x = 0;
  return solve_cg_fft(on_the_jump(tread), delta_2, modulus, options).contact.moment_y /
         (inch * lbf);
}

// The largest difference between the cells' pressures and Hertz's ellipsoid, as a share of its peak.
double off_ellipsoid(const NormalContact& c, const HertzContact& h) {
  double worst = 0;
  for (Eigen::Index i = 0; i < c.x.size(); ++i)
    worst = std::max(worst, std::abs(c.p[i] - hertz_pressure(h, c.x[i], c.y[i])) / h.p_max);
  return worst;
}

void table_2(report::Item& item) {
  const table::CsvTable printed = item.printed("table-2.csv");
  const auto in_print = [&](const char* key, const char* column) {
    return report::printed_number(printed.at(key, column));
  };
  const double a = in_print("a", "hertz") * inch, b = in_print("b", "hertz") * inch;
  const Shape shape = shape_of(a, b, delta_1);
  const auto hertz = in_print_units(hertz_1()), fitted = in_print_units(hertz_1(shape.tread));
  const auto countact = in_print_units(nine_by_nine().contact);
  const std::array<double, 4> allowed{0.01, 0.006, 0.015, 0.01};
  item.expect_checks(13);
  for (std::size_t k = 0; k < 4; ++k) {
    const report::Row row = item.row(printed, keys[k]);
    row.print(
        "hertz", hertz[k],
        report::relative(allowed[k],
                         "the tread, read from a damaged drawing, is known to half a per cent"));
    row.print(
        "countact", countact[k],
        report::relative(
            0.005, "the paper's rows and its moves are not printed: eight meshes scatter by this"));
  }
  const auto close = report::relative(0.003, "a and b have four digits, and fix the tread");
  item.print("F-fitted", "force by Hertz, tread fitted to the printed a, b, delta", "lbf",
             printed.at("F", "hertz"), fitted[0], close);
  item.print("p0-fitted", "peak pressure by Hertz, tread fitted to the printed a, b, delta", "psi",
             printed.at("p0", "hertz"), fitted[1], close);
  const auto error = [&](const char* key) {
    return 100 * std::abs(in_print(key, "countact") / in_print(key, "hertz") - 1);
  };
  item.claim("errors", "the column % error: 0, .43, 2 and .1",
             error("F") == 0 && std::abs(error("p0") - 0.43) < 0.005 &&
                 std::abs(error("a") - 2) < 0.5 && std::abs(error("b") - 0.1) < 0.05,
             fmt::format("from the two printed columns: {:.0f}, {:.3f}, {:.2f} and {:.3f}",
                         error("F"), error("p0"), error("a"), error("b")));
  const double load = 2 * units::pi / 3 * a * b * in_print("p0", "hertz") * psi / lbf;
  item.refute("own-load", "F, p0, a and b of Hertz's column belong to one contact",
              std::abs(load / in_print("F", "hertz") - 1) > 5e-4,
              fmt::format("2/3 pi a b p0 is {:.1f} lbf, beyond the rounding of its factors", load));
  double off = 0;
  for (const double p : {hertz[1] / countact[1], hertz[2] / countact[2], hertz[3] / countact[3]})
    off = std::max(off, std::abs(p - 1));
  item.claim("accuracy", "the method agrees with Hertz to 2 % in the worst quantity", off < 0.02,
             fmt::format("{:.1f} % on nine by nine cells", 100 * off));
  item.value("off-ellipsoid", 100 * off_ellipsoid(nine_by_nine().contact, hertz_1()), "%",
             "{:.1f}");
  item.value("fitted-tread", shape.tread / inch, "in", "{:.2f}");
  item.value("fitted-wheel", shape.along / inch, "in", "{:.2f}");
  item.value("tread-per-percent", 100 * (shape.tread / shape_of(1.01 * a, b, delta_1).tread - 1),
             "%", "{:.1f}");
  item.value("printed-load", load, "lbf", "{:.1f}");
}

void treads(report::Item& item) {
  const table::CsvTable printed = item.printed("table-2.csv");
  const double moment = report::printed_number(item.printed("example-2.csv").at("M", "printed"));
  item.columns({{"tread, in", "{:.2f}"},
                {"off Hertz's column, %", "{:.2f}"},
                {"off COUNTACT's, free moves, %", "{:.2f}"},
                {"off COUNTACT's, inward moves, %", "{:.2f}"},
                {"off the moment of Example 2, %", "{:+.2f}"}});
  double drawn = 0, low = 0, high = 0;
  for (const double t : {12.26, 12.28, 12.30, 12.32, 12.34, 12.36}) {
    const double tread = t * inch, m = moment_of_example_2(tread);
    const double free = best_mesh(printed, tread, false), inward = best_mesh(printed, tread, true);
    item.add_row(t, 100 * worst_off(printed, "hertz", in_print_units(hertz_1(tread))), 100 * free,
                 100 * inward, 100 * (m / moment - 1));
    if (t == 12.28) low = m;
    if (t == 12.34) high = m, drawn = 100 * std::min(free, inward);
  }
  const double root = 12.28 + 0.06 * (moment - low) / (high - low);
  item.expect_checks(2);
  item.print("tread", "tread that gives the printed moment", "in", "12.34", root,
             report::relative(0.005, "the drawing is damaged; other columns give 12.28 to 12.34"));
  item.at_most("drawn", "12.34 in against COUNTACT's column, the better rule of moves", "%", drawn,
               0.5, "eight meshes scatter by this");
  item.value("moment-tread", root, "in", "{:.2f}");
}

/***
### How the region is found

Figure 7 of the paper shows the mesh shrinking from the interpenetration curve to the contact "with rapid convergence". So does this one: each region more than halves what the
load lacks, until after four it changes by less than its mesh error.

{{fig-07}}

"The new candidate contact boundary will be inside the old one": the first three are, the fourth move is outward in some columns, by {{outward}} of the half width. A program
that never moves outward cannot undo an undershoot: its contact stays {{inward-short}} short of Hertz's $a$, against {{free-short}} with free moves. The force hardly minds.
The paper's run took 5.7 s on an IBM 370/168 and cost $2.83 with compilation.
*/

void draw_development(report::Item& item, const HertzContact& exact) {
  auto& outlines = item.data({"iteration", "x_in", "y_in"});
  for (std::size_t k = 0; k < 4; ++k) {
    const ColumnMesh& mesh = nine_by_nine().history.at(k).mesh;
    const auto m = mesh.half_width.size();
    outlines.add(double(k), mesh.x_edges[0] / inch, 0.0);
    for (Eigen::Index j = 0; j < 2 * m; ++j)
      outlines.add(double(k), mesh.x_edges[(j + 1) / 2] / inch, mesh.half_width[j / 2] / inch);
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
  CountactOptions options;
  options.inward_only = true;
  const NormalContact inward = countact_2(on_the_crown(), delta_1, modulus, options).contact;
  const double last = result.contact.force, mesh_error = std::abs(last - exact.force);
  std::array<double, 4> outward{}, left{};
  for (std::size_t k = 0; k < 4; ++k) {
    const CountactStep& step = result.history.at(k);
    outward[k] =
        (step.new_half - step.mesh.half_width).maxCoeff() / step.mesh.half_width.maxCoeff();
    left[k] = std::abs(step.force - last);
  }
  item.expect_checks(2);
  item.claim("rapid", "rapid convergence of the mesh to the contact",
             left[1] < left[0] / 2 && left[2] < left[1] / 2 && left[3] < mesh_error,
             fmt::format("\"rapid\" has no number in the paper; here each region more than halves "
                         "what the load lacks, until that is below its mesh error of {:.1f} %",
                         100 * mesh_error / exact.force));
  item.refute(
      "monotone", "the new candidate boundary will be inside the old one",
      outward[0] <= 0 && outward[1] <= 0 && outward[2] <= 0 &&
          outward[3] > CountactOptions{}.tolerance,
      fmt::format("three moves are inward, the fourth outward by {:.1f} % of the half width",
                  100 * outward[3]));
  item.value("outward", 100 * outward[3], "%", "{:.1f}");
  item.value("inward-short", 100 * (1 - inward.x_max / exact.a), "%", "{:.1f}");
  item.value("free-short", 100 * (1 - result.contact.x_max / exact.a), "%", "{:.1f}");
  item.rebuilt("the drawing shows meshes without numbers; the final one is checked in Table 2");
}

void fig_06(report::Item& item) {
  draw::profiles(item, crown_radius, -1.5 * inch, 1.5 * inch);
  item.sketch("the bodies of Example 1, in the plane of the wheel axis");
}

}  // namespace

const report::Section example_1{
    report::figure("fig-06", "Wheel and rail in Hertzian contact (Fig. 6)", fig_06),
    report::table("table-2", "Hertz and COUNTACT-2 at an approach of .0004 in (Table 2)", table_2),
    report::table("treads", "Treads against three sets of printed numbers", treads),
    report::figure("fig-07", "Mesh development and convergence of the contact boundary (Fig. 7)",
                   fig_07)};

}  // namespace railbook::contact_chapter
