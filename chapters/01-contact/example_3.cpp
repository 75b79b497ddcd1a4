/*** ## Example 3: a crowned roller

A long cylinder lies on another with a parallel axis. Were its ends cut off square, the pressure
would be infinite along the edges. So the ends are crowned: beyond a straight middle part the
profile bends away with a large radius, 85 in. How much does the crown help?

{{fig-11}}

The text gives the crown radius $R_c=85$ in and the approach, $\delta=0.00065$ in. The other
dimensions stand in a drawing that we do not have. We take two cylinders of 1 in radius, which touch
like one cylinder of radius $R=0.5$ in and a plane, and a straight part of the length $2L=1$ in:

$$f(x,y)=\frac{y^2}{2R}+\frac{\max(|x|-L,\,0)^2}{2R_c}.$$

So the numbers of this example are not the paper's, and only its claims can be tested. The patch is
{{slenderness}} times as long as it is wide. The paper says that the method
"can handle problems with extremely large radii"; here COUNTACT's force and peak agree with those of
the grid within {{worst-off}}.

{{fig-12}}

The pressure is nearly even over the straight part. Just beyond its end, at $|x|$ = {{peak-place}},
it rises to {{peak-ratio}} times its value at the centre, and then it falls to zero as on any smooth
body. Whether {{peak-percent}} is what the paper calls negligible cannot be tested: the dimensions
of its rollers are missing, and the word has no number. The slope of the gap is continuous at the
end of the straight part, but its curvature jumps from zero to $1/R_c$. Under a jump of curvature
the slope of the pressure is logarithmically infinite: the peak is a rounded shoulder with a steep
inner flank.

With square ends the peak has no value. As the width $h$ of the cells shrinks, the pressure of the
last cell grows like $h^{-1/2}$ if the pressure at the edge is infinite, and tends to a limit if it
is finite. Let it grow like $h^{-n}$. From grid to grid, each twice as fine along the axis, we find
$n$ = {{sharp-rates}}. The force is smaller than with the crown, because the patch is shorter.

{{fig-13}}

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

constexpr const char* roller_rebuilt =
    "our text has the crown radius and the approach; the other dimensions are ours";

CgFft roller_on_grid(double crown,
                     Eigen::Index cells) {  // odd: the middle row of cells is on the axis
  return solve_cg_fft(roller(crown), delta_3, modulus, {cells, cells});
}

// The paper's crown on the finest grid, computed once for all items.
const CgFft& crowned() {
  static const CgFft result = roller_on_grid(85 * inch, 301);
  return result;
}

// COUNTACT-2 with narrow columns towards the ends, where the pressure falls.
const NormalContact& roller_by_columns() {
  static const NormalContact result = [] {
    const Side side{.wide = 10, .narrow = 10, .share = 0.4};
    return countact_2(roller(85 * inch), delta_3, modulus, {split_columns(side, side), 13}).contact;
  }();
  return result;
}

double pressure_at_centre(const NormalContact& c) {
  Eigen::Index centre = 0;
  (c.x.array().square() + c.y.array().square()).minCoeff(&centre);
  return c.p[centre];
}

void fig_11(report::Item& item) {
  report::Data& shape = item.data({"x_in", "crowned_mil"});
  for (int k = -100; k <= 100; ++k) {
    const double x = k * 0.009 * inch;
    shape.add(x / inch, roller(85 * inch)(x, 0) / (1e-3 * inch));
  }
  item.sketch("the profile is rebuilt, with the height magnified");
}

// The exponents n of the pressure h^-n at a square end, each from two grids of which one is twice
// as fine along the axis.
std::vector<double> square_end_rates() {
  std::vector<double> rates;
  double pressure = 0, width = 0;
  for (const Eigen::Index cells : {101, 201, 401, 801, 1601}) {
    const NormalContact c = solve_cg_fft(roller(0), delta_3, modulus, {cells, 51}).contact;
    if (pressure > 0) rates.push_back(std::log(c.p_max / pressure) / std::log(width / c.dx[0]));
    pressure = c.p_max;
    width = c.dx[0];
  }
  return rates;
}

// "0.39, 0.44".
std::string list_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers)
    text += fmt::format("{}{:.2f}", text.empty() ? "" : ", ", number);
  return text;
}

void fig_12(report::Item& item) {
  const NormalContact &smooth = crowned().contact, &columns = roller_by_columns();
  const NormalContact sharp = roller_on_grid(0, 201).contact;
  draw::axis(item.data({"x_in", "p_1e5psi"}), smooth);
  draw::axis(item.data("countact", {"x_in", "p_1e5psi"}), columns);
  draw::axis(item.data("square", {"x_in", "p_1e5psi"}), sharp);
  draw::axis(item.data("crown-10", {"x_in", "p_1e5psi"}), roller_on_grid(10 * inch, 201).contact);
  const double ratio = smooth.p_max / pressure_at_centre(smooth);
  const std::vector<double> rates = square_end_rates();
  const double off = std::max(std::abs(columns.force / smooth.force - 1),
                              std::abs(columns.p_max / smooth.p_max - 1));
  const double shown = report::printed_number(item.printed("table-2.csv").at("p0", "error"));
  item.expect_checks(1);
  item.claims({{"radii", {100 * off, shown, 100 * off / shown}}});
  item.claim("infinite", "sharp edges would produce infinite contact pressure",
             std::is_sorted(rates.begin(), rates.end()) && std::abs(rates.back() - 0.5) < 0.02,
             "the pressure of the last cell grows as $h^{-n}$, with $n$ = " + list_of(rates) +
                 " on finer and finer grids, towards the 1/2 of a square edge");
  item.value("slenderness", smooth.x_max / smooth.y_max, "", "{:.0f}");
  item.value("worst-off", 100 * off, "%", "{:.2f}");
  item.value("peak-ratio", ratio, "", "{:.3f}");
  item.value("peak-percent", 100 * (ratio - 1), "%", "{:.1f}");
  item.value("peak-place", std::abs(smooth.x_p_max) / inch, "in", "{:.3f}");
  item.value("sharp-rates", list_of(rates));
  item.rebuilt(roller_rebuilt);
}

void fig_13(report::Item& item) {
  const Outline& o = crowned().outline;
  report::Data& edge = item.data({"x_in", "y_in"});
  for (Eigen::Index n = 0; n < o.x.size(); ++n) edge.add(o.x[n] / inch, o.low[n] / inch);
  for (Eigen::Index n = o.x.size() - 1; n >= 0; --n) edge.add(o.x[n] / inch, o.high[n] / inch);
  edge.add(o.x[0] / inch, o.low[0] / inch);
  draw::cells(item.data("mesh", {"x_in", "y_in", "dx_in", "dy_in"}), roller_by_columns());
  item.rebuilt(roller_rebuilt);
}

}  // namespace

const report::Section example_3{report::figure("fig-11", fig_11), report::figure("fig-12", fig_12),
                                report::figure("fig-13", fig_13)};

}  // namespace railbook::contact_chapter
