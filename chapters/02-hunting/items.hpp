// The parts of this chapter: each file adds its tables, figures and tools.
#pragma once

#include "report/chapter.hpp"

namespace railbook::hunting {

void add_conversions(report::Chapter&);  // quantities printed in two units

// Profiles and geometry of contact.
void add_profiles(report::Chapter&);          // Figs 3, 4, 5
void add_constraint_table(report::Chapter&);  // claims, slopes, tables, jumps
void add_conicity(report::Chapter&);
void add_geometry_cost(report::Chapter&);
void add_geometry_extremes(report::Chapter&);
void add_geometry_tool(report::Chapter&);  // `hunting geometry`

// The car, describing functions, limit cycles.

// Harmonic balance, time, Floquet, scene.

}  // namespace railbook::hunting
