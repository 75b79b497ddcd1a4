// The sections of the chapter, and what they share: the paper's inputs, a result, points of
// figures.
#pragma once

#include <array>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/contact/material.hpp>
#include <railbook/report/chapter.hpp>
#include <railbook/units/constants.hpp>

#include "method/countact.hpp"

namespace railbook::contact_chapter {

extern const report::Section first_drawing, method, example_1, example_2, which_tread, example_3,
    example_4;
extern const report::Section cost, errors, stability;  // study/

using namespace contact;
using units::inch, units::lbf, units::psi;

// Steel on steel, the same in all four examples.
inline constexpr Material steel{30e6 * psi, 0.3};
inline const double modulus = effective_modulus(steel, steel);

// Radii as drawn in Fig. 8. The tread's is read from a damaged "J2.34".
inline constexpr double wheel_radius = 18 * inch, tread_radius = 12.34 * inch;
inline constexpr double crown_radius = 10 * inch, corner_radius = 1.25 * inch;

// The approach of each example.
inline constexpr double delta_1 = 0.0004 * inch, delta_2 = 0.005 * inch;
inline constexpr double delta_3 = 0.00065 * inch, delta_4 = 0.001 * inch;

// The bodies of each example; of 3 and 4 only the crown of 85 in is printed. On a grid the jump
// lies between cells.
inline Gap on_the_crown(double tread = tread_radius) {
  return rail_wheel_gap({wheel_radius, tread, crown_radius, crown_radius});
}
inline Gap on_the_jump(double tread = tread_radius) {
  return rail_wheel_gap({wheel_radius, tread, crown_radius, corner_radius});
}
inline NormalContact jump_on_grid(Eigen::Index cells, double tread = tread_radius) {
  CgFftOptions options{cells, cells};
  options.edge_x = 0;
  return solve_cg_fft(on_the_jump(tread), delta_2, modulus, options).contact;
}
inline Gap roller(double crown) {
  return crowned_roller_gap({0.5 * inch, 0.5 * inch, crown});
}
inline constexpr RoundedPunch stamp{0.5 * inch, 1 * inch};

// Example 1 in closed form.
inline HertzContact hertz_1(double tread = tread_radius, double approach = delta_1) {
  return hertz_from_approach(
      relative_curvature({1 / crown_radius, 0}, {-1 / tread, 1 / wheel_radius}), modulus, approach);
}
// Example 1 by COUNTACT-2 on the nine columns of Fig. 2, and nine rows; solved once.
const CountactResult& nine_by_nine();
// The four quantities of Table 2: the keys of its rows, and the values in the units of the print.
inline constexpr std::array<const char*, 4> table_2_keys{"F", "p0", "a", "b"};
std::array<double, 4> in_print_units(const HertzContact&);
std::array<double, 4> in_print_units(const NormalContact&);
// The bodies whose Hertz contact has these semi-axes at this approach, all in m.
struct Shape {
  double along = 0;  // relative radius along the rail [m]
  double tread = 0;  // the tread that makes the other one, on the 10 in crown [m]
};

Shape shape_of(double a, double b, double delta);
// Example 2 by COUNTACT-1 on 30 graded columns, and by CG-FFT on the finest grid; each solved once.
const NormalContact& jump_by_columns();
const NormalContact& jump_by_grid();
// The force of Example 2 by sums over lattices (study); computed once.
double force_by_lattices();

namespace draw {
double centre(const ColumnMesh&, Eigen::Index column);                      // its x [m]
void section(report::Data&, double right_radius, double from, double to);   // rail and wheel across
void profiles(report::Item&, double right_radius, double from, double to);  // Figs 6, 8
void overlap(report::Data&, const Gap&, double approach);  // the interpenetration curve
void axis(report::Data&, const NormalContact&);            // p(x, 0) from end to end
void cells(report::Data&, const NormalContact&, double from_y = -units::infinity);
void in_space(report::Item&, const NormalContact&, const Gap&);
}  // namespace draw

}  // namespace railbook::contact_chapter
