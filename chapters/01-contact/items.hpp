// The parts of this chapter: each file adds its tables, figures and tools. And the paper's inputs, which they share.
#pragma once

#include "contact/countact.hpp"
#include "contact/geometry.hpp"
#include "report/chapter.hpp"
#include "units/constants.hpp"

namespace railbook::contact_chapter {

void add_cost(report::Chapter&);          // error against run time, Example 1
void add_cost_punch(report::Chapter&);    // and Example 4
void add_example_3(report::Chapter&);     // Figs 11 to 13
void add_extremes(report::Chapter&);      // stability
void add_method(report::Chapter&);        // Figs 1 to 5
void add_conditioning(report::Chapter&);  // the matrix (14)
void add_example_1(report::Chapter&);     // Table 2, Figs 6 and 7
void add_example_2(report::Chapter&);     // Figs 8 to 10 and the scene
void add_example_4(report::Chapter&);     // Fig. 14

// The tread radius that fits the printed Hertz column of Table 2 best, from its a, b and delta.
double fitted_tread(const report::Item&);

// Example 1 by COUNTACT-2 on nine columns of nine cells, the mesh of the paper's Fig. 2; solved once.
const contact::CountactResult& nine_by_nine();

using units::inch;
using units::lbf;
using units::psi;

// Steel on steel, the same in all four examples.
inline const contact::Material steel{30e6 * psi, 0.3, 30e6 * psi, 0.3};

// Radii as drawn in Fig. 8. The tread's radius is the one number we had to read from a damaged "J2.34".
inline constexpr double wheel_radius = 18 * inch;
inline constexpr double tread_radius = 12.34 * inch;
inline constexpr double crown_radius = 10 * inch;
inline constexpr double corner_radius = 1.25 * inch;

// The approach of each example.
inline constexpr double delta_1 = 0.0004 * inch;
inline constexpr double delta_2 = 0.005 * inch;
inline constexpr double delta_4 = 0.001 * inch;

}  // namespace railbook::contact_chapter
