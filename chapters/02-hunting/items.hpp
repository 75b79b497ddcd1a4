// The parts of this chapter: each file adds its tables, figures and tools.
#pragma once

#include "report/chapter.hpp"

namespace railbook::hunting_chapter {

void add_conversions(report::Chapter&);  // quantities printed in two units

// Profiles and geometry of contact.
void add_profiles(report::Chapter&);          // Figs 3, 4, 5
void add_constraint_table(report::Chapter&);  // claims, slopes, tables, jumps
void add_conicity(report::Chapter&);
void add_conicity_benchmark(report::Chapter&);  // EN 15302
void add_geometry_cost(report::Chapter&);
void add_geometry_extremes(report::Chapter&);

// The car, describing functions, limit cycles.
void add_car(report::Chapter&);            // parameters and matrices
void add_describing(report::Chapter&);     // Figs 7, 8, 9
void add_critical(report::Chapter&);       // Hopf points, sensitivities
void add_branches_cost(report::Chapter&);  // what the branches of study.hpp cost
void add_branches(report::Chapter&);       // Fig 11
void add_labels(report::Chapter&);         // stability by three criteria
void add_modes(report::Chapter&);          // Fig 12
void add_algorithm(report::Chapter&);      // the paper's two loops
void add_printed(report::Chapter&);        // what the text claims
void add_df_cost(report::Chapter&);        // error against run time of one cycle

// Harmonic balance, time, Floquet, scene.
void add_balance(report::Chapter&);
void add_histories(report::Chapter&);
void add_floquet(report::Chapter&);
void add_scene(report::Chapter&);
void add_cycle_cost(report::Chapter&);
void add_cycle_extremes(report::Chapter&);

}  // namespace railbook::hunting_chapter
