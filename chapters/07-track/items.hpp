// The parts of this chapter: each file adds its tables, figures and tools.
#pragma once

#include "report/chapter.hpp"

namespace railbook::track_chapter {

void add_stiffness(report::Chapter&);         // rail on its foundation, Fig. 1
void add_chain(report::Chapter&);             // the chain below a tie: Fig. 2
void draw_steps(report::Item&);               // the scene of Fig. 2
void add_ties(report::Chapter&);              // discrete ties against the smeared foundation
void add_lifting(report::Chapter&);           // a bed that cannot pull
void add_joint(report::Chapter&);             // stiffness at a joint: Fig. 3
void add_masses(report::Chapter&);            // effective masses, eqs (15)-(19)
void add_moving(report::Chapter&);            // critical speed and moving load, eq. (9)
void add_trackside(report::Chapter&);         // lumped track, Figs 4 and 5
void add_geometry(report::Chapter&);          // joints, spectra, profiles: Figs 6 and 7
void add_impact(report::Chapter&);            // wheel/rail force over a joint
void add_dynamic_cost(report::Chapter&);      // error against run time, moving load and joint
void add_dynamic_extremes(report::Chapter&);  // stability rows, moving load and joint
void add_static_cost(report::Chapter&);       // error against run time, statics
void add_static_extremes(report::Chapter&);   // stability rows, statics

// Checks a claim of the paper's text: the row `key` of data/claims.csv.
inline void check_claim(report::Item& item, const table::CsvTable& claims, const std::string& key,
                        double computed,
                        const report::Tolerance& tolerance = report::last_digit()) {
  item.check(key, claims.at(key, "what"), claims.at(key, "unit"), claims.at(key, "printed"),
             computed, tolerance);
}

}  // namespace railbook::track_chapter
