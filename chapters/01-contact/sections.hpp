// The sections of the chapter, and the paper's inputs that they share.
#pragma once

#include "contact/countact.hpp"
#include "contact/geometry.hpp"
#include "report/chapter.hpp"
#include "units/constants.hpp"

namespace railbook::contact_chapter {

extern const report::Section method;     // Figs 1 to 5, the matrix (14), units
extern const report::Section example_1;  // Figs 6 and 7, Table 2
extern const report::Section example_2;  // Figs 8 to 10
extern const report::Section example_3;  // Figs 11 to 13
extern const report::Section example_4;  // Fig. 14
extern const report::Section cost;       // study: error against run time
extern const report::Section stability;  // study: stiff and extreme cases

using namespace contact;
using units::inch, units::lbf, units::psi;

// Steel on steel, the same in all four examples.
inline const Material steel{30e6 * psi, 0.3, 30e6 * psi, 0.3};
inline const double modulus = effective_modulus(steel);

// Radii as drawn in Fig. 8. The tread's is read from a damaged "J2.34".
inline constexpr double wheel_radius = 18 * inch;
inline constexpr double tread_radius = 12.34 * inch;
inline constexpr double crown_radius = 10 * inch;
inline constexpr double corner_radius = 1.25 * inch;

// The approach of each example.
inline constexpr double delta_1 = 0.0004 * inch;
inline constexpr double delta_2 = 0.005 * inch;
inline constexpr double delta_3 = 0.00065 * inch;
inline constexpr double delta_4 = 0.001 * inch;

// The bodies of each example; of 3 and 4 only the crown of 85 in is printed.
RailWheel on_the_crown(double tread = tread_radius);
RailWheel on_the_jump(double tread = tread_radius);
CrownedRoller roller(double crown);
inline constexpr RoundedPunch stamp{0.5 * inch, 1 * inch};

void place_answer(report::Item& item);  // of Fig. 9

// Example 1 by COUNTACT-2 on the nine columns of Fig. 2, and nine rows; solved once.
const CountactResult& nine_by_nine();

}  // namespace railbook::contact_chapter
