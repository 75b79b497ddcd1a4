#include <fmt/format.h>
#include <string_view>

#include <cmath>

#include "contact/countact.hpp"
#include "contact/hertz.hpp"
#include "drawings.hpp"
#include "items.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

namespace {

/***
## Example 1: a contact that Hertz can check

Wheel and rail meet where all four radii are uniform, so the exact answer is an ellipse. Across the rail, the
concave tread of the wheel embraces the crown; along the rail the wheel rolls:

$$f(x,y)=\frac{x^2}{2}\left(\frac{1}{R_r}-\frac{1}{R_t}\right)+\frac{y^2}{2R_w}.$$

{{fig-06}}

The paper gives the approach, $\delta=.0004$ in, and shows the radii only in drawings: wheel $R_w=18$ in, and a tread
radius that a damaged scan shows as "J2.34". The crown, 10 in, is in the text of Example 2. We read
$R_t=12.34$ in, and then ask the printed results whether that is right.
*/

RailWheel on_the_crown(double tread) {
  return {wheel_radius, tread, crown_radius, crown_radius};
}

RelativeCurvature curvature_with(double tread) {
  return relative_curvature({1 / wheel_radius, -1 / tread, units::pi / 2},
                            {1 / crown_radius, 0, 0});
}

HertzContact hertz_with(double tread) {
  return hertz_from_approach(curvature_with(tread), effective_modulus(steel), delta_1);
}

/***
### What the printed ellipse says about the geometry

Hertz's semi-axes and the approach are tied by $a^2=\delta D/(KA)$, $b^2=\delta B_e/(KB)$, where $K$ and its two parts
$B_e+D=K$ are complete elliptic integrals of $b/a$ alone. So the printed $a$, $b$ and $\delta$ give
both curvatures back, without the load or the elastic constants:
*/

struct Shape {
  double across = 0, along = 0;  // relative radii
  double tread = 0;              // and the tread that makes the first, on the 10 in crown
};

Shape shape_of(double a, double b, double delta) {
  const EllipticIntegrals i = elliptic_integrals(2 * std::log(b / a));
  const double curvature_a = delta * i.d / (i.k * a * a), curvature_b = delta * i.b / (i.k * b * b);
  return {1 / (2 * curvature_a), 1 / (2 * curvature_b), 1 / (1 / crown_radius - 2 * curvature_a)};
}

/***
The wheel comes out at {{fitted-wheel}}, next to the drawn 18; the tread at {{fitted-tread}} where we read
12.34. The tread is the sensitive number: it nearly cancels the crown, and {{tread-per-percent}} more of it moves $a$ by a
whole per cent. With 12.34 the printed Hertz column is met within {{misfit-drawn}}; with the fitted tread, within
{{misfit-fitted}}:

{{table-2}}

Three more things the printed columns say about themselves. Their last column follows from the other two, to the digits
printed. Their $F$ is not $\tfrac23\pi ab\,p_0$ of the same column, which is {{printed-load}}: the theory was
read from a chart or a short table. And the load is the same number in both columns, as if Hertz had been asked
for COUNTACT's load and not for the approach; for that load the tread of 12.34 gives $p_0$ = {{p0-at-load}},
the very number in the *other* column.

Our own COUNTACT-2, on nine columns as in the paper's Figure 2 and nine rows, agrees with the printed COUNTACT-2
within {{misfit-countact}} in the pressure and both axes **with 12.34**. With the fitted tread it would give $a$ = {{countact-a-fitted}} and
$p_0$ = {{countact-p0-fitted}} instead of the printed .1562 in and 39 410 psi. So the paper's program ran with 12.34; this is used
from here on, and 1 % is the resolution of the identification.
*/

struct Quantity {
  const char* key;
  double unit, hertz, fitted, countact, hertz_allowed, countact_allowed;
};

void table_2(report::Item& item) {
  const table::CsvTable printed = item.printed("table-2.csv");
  const auto in_print = [&](const char* key, const char* column) {
    return report::printed_number(printed.at(key, column));
  };
  const double a = in_print("a", "hertz") * inch, b = in_print("b", "hertz") * inch;
  const Shape shape = shape_of(a, b, delta_1);
  const HertzContact drawn = hertz_with(tread_radius), fitted = hertz_with(shape.tread);
  const NormalContact& c = nine_by_nine().contact;

  // The worst of the printed numbers that each reading misses; the load of the COUNTACT column is left out.
  double drawn_off = 0, fitted_off = 0, countact_off = 0;
  const auto widen = [](double& off, double ours, double theirs) {
    off = std::max(off, 100 * std::abs(ours / theirs - 1));
  };
  item.expect_checks(16);
  for (const Quantity& q : {Quantity{"F", lbf, drawn.force, fitted.force, c.force, 0.01, 0.005},
                            Quantity{"p0", psi, drawn.p_max, fitted.p_max, c.p_max, 0.006, 0.001},
                            Quantity{"a", inch, drawn.a, fitted.a, c.x_max, 0.015, 0.001},
                            Quantity{"b", inch, drawn.b, fitted.b, c.y_max, 0.01, 0.001}}) {
    const report::Row row = item.row(printed, q.key);
    row.check("hertz", q.hertz / q.unit,
              report::relative(q.hertz_allowed, "tread radius read from a damaged drawing"));
    row.check("countact", q.countact / q.unit,
              report::relative(q.countact_allowed, "rows of the paper's mesh are not printed"));
    item.check(fmt::format("{}-error", q.key), "% error, from the two printed columns", "%",
               row.printed("error"),
               100 * std::abs(in_print(q.key, "countact") / in_print(q.key, "hertz") - 1));
    item.check(fmt::format("{}-fitted", q.key), "the same, tread fitted to the printed ellipse",
               printed.at(q.key, "unit"), row.printed("hertz"), q.fitted / q.unit,
               report::relative(0.003, "one tread radius for four printed numbers"));
    widen(drawn_off, q.hertz / q.unit, in_print(q.key, "hertz"));
    widen(fitted_off, q.fitted / q.unit, in_print(q.key, "hertz"));
    if (std::string_view{q.key} != "F")
      widen(countact_off, q.countact / q.unit, in_print(q.key, "countact"));
  }
  item.value("misfit-drawn", drawn_off, "%", "{:.1f}");
  item.value("misfit-fitted", fitted_off, "%", "{:.1f}");
  item.value("misfit-countact", countact_off, "%", "{:.1f}");
  item.value("fitted-tread", shape.tread / inch, "in", "{:.2f}");
  item.value("fitted-wheel", shape.along / inch, "in", "{:.2f}");
  item.value("tread-per-percent", 100 * (shape.tread / shape_of(1.01 * a, b, delta_1).tread - 1),
             "%", "{:.1f}");
  item.value("printed-load", 2 * units::pi / 3 * a * b * in_print("p0", "hertz") * psi / lbf, "lbf",
             "{:.1f}");
  const NormalContact other =
      countact_2(rail_wheel_gap(on_the_crown(shape.tread)), delta_1, effective_modulus(steel))
          .contact;
  item.value("countact-a-fitted", other.x_max / inch, "in", "{:.4f}");
  item.value("countact-p0-fitted", other.p_max / psi, "psi", "{:.0f}");
  const double load = in_print("F", "hertz") * lbf;
  item.value(
      "p0-at-load",
      hertz_from_force(curvature_with(tread_radius), effective_modulus(steel), load).p_max / psi,
      "psi", "{:.0f}");
}

/***
### How the region is found

Figure 7 of the paper shows the mesh shrinking from the interpenetration curve to the contact "with rapid
convergence". Ours does the same: the load of the first four regions is {{first-loads}}, against the exact
{{exact-load}}. After that the boundary only swings by less than a cell's width, and the load by less than
its mesh error, so that the paper's stop after about four solves was the right one.

{{fig-07}}

The paper's run took 5.7 s on an IBM 370/168 and cost $2.83 with compilation. The same {{unknowns}} unknowns and
{{iterations}} iterations are {{corners}} evaluations of one corner function here; what
they cost today is measured under *Error against run time*.
*/

void fig_07(report::Item& item) {
  const CountactResult& result = nine_by_nine();
  const auto& history = result.history;
  const HertzContact exact = hertz_with(tread_radius);
  draw::mesh_development(item, result, exact);
  item.explained("the drawing shows meshes without numbers; the final one is checked in Table 2");
  item.expect_checks(2);
  item.agree("force", "load of the final mesh", "lbf", result.contact.force / lbf,
             exact.force / lbf, 0.005, "Hertz's closed form");
  item.agree("force-4", "load after four solves", "lbf", history.at(3).force / lbf,
             exact.force / lbf, 0.005, "Hertz's closed form");
  item.value("first-loads",
             fmt::format("{:.0f}, {:.0f}, {:.0f} and {:.0f} lbf", history[0].force / lbf,
                         history[1].force / lbf, history[2].force / lbf, history[3].force / lbf));
  item.value("exact-load", exact.force / lbf, "lbf", "{:.1f}");
  const double iterations = result.contact.iterations;
  const double unknowns = std::sqrt(double(result.contact.work) / iterations);
  item.value("unknowns", unknowns, "", "{:.0f}");
  item.value("iterations", iterations, "", "{:.0f}");
  item.value("corners", iterations * unknowns * 9 * 10 * 2, "",
             "{:.0f}");  // 2 a column and row edge
}

void fig_06(report::Item& item) {
  item.sketch("the bodies of Example 1, in the plane of the wheel axis");
  draw::profiles(item, on_the_crown(tread_radius), -1.5 * inch, 1.5 * inch);
}

}  // namespace

double contact_chapter::fitted_tread(const report::Item& item) {
  const table::CsvTable printed = item.printed("table-2.csv");
  return shape_of(report::printed_number(printed.at("a", "hertz")) * inch,
                  report::printed_number(printed.at("b", "hertz")) * inch, delta_1)
      .tread;
}

void contact_chapter::add_example_1(report::Chapter& chapter) {
  chapter.figure("fig-06", "Wheel and rail in Hertzian contact (Fig. 6)", fig_06);
  chapter.table("table-2", "Hertz and COUNTACT-2 at an approach of .0004 in (Table 2)", table_2);
  chapter.figure("fig-07", "Mesh development and convergence of the contact boundary (Fig. 7)",
                 fig_07);
}
