// The parts of this chapter: each file adds its tables, figures and tools.
#pragma once

#include "report/chapter.hpp"

namespace railbook::creep_chapter {

void add_rig_scene(report::Chapter&);       // Figs 1 and 2
void add_geometry(report::Chapter&);        // the ellipse of the rig: Fig. 9's line
void add_appendix_a(report::Chapter&);      // accuracy of the creep reading
void add_appendix_b(report::Chapter&);      // wear of the wheels, and the printed state
void add_experiment(report::Chapter&);      // synthetic points: Figs 3 to 7
void add_reduction(report::Chapter&);       // their reduction: Figs 8 to 11
void add_state(report::Chapter&);           // the one reading that is printed
void add_area_law(report::Chapter&);        // creep times area
void add_full_curve(report::Chapter&);      // Kalker's full theory
void add_pixels(report::Chapter&);          // CONTACT's own discretisation
void add_carter(report::Chapter&);          // exact: rolling cylinders
void add_cattaneo(report::Chapter&);        // exact: a shift
void add_coefficients(report::Chapter&);    // Kalker's coefficients
void add_kalker_proof(report::Chapter&);    // what proves their computation
void add_tractions(report::Chapter&);       // maps of traction, stick and slip
void add_scene(report::Chapter&);           // one of them in space
void add_full_cost(report::Chapter&);       // error against run time
void add_full_stability(report::Chapter&);  // extreme cases
void add_theories(report::Chapter&);        // the fast theories against the full one
void add_fastsim_cells(report::Chapter&);   // FASTSIM's grid, and the fast theories' stability rows

// Checks a number of the paper's text: the row `key` of `printed`.
inline void check_claim(report::Item& item, const table::CsvTable& printed, const std::string& key,
                        double computed,
                        const report::Tolerance& tolerance = report::last_digit()) {
  item.check(key, printed.at(key, "what"), printed.at(key, "unit"), printed.at(key, "printed"),
             computed, tolerance);
}

}  // namespace railbook::creep_chapter
