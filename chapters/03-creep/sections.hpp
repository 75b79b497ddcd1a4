// The sections of the chapter, in reading order.
#pragma once

#include "report/chapter.hpp"

namespace railbook::creep_chapter {

extern const report::Section rig_scene;    // Figs 1 and 2
extern const report::Section geometry;     // the ellipse of contact
extern const report::Section replica;      // equations (3) to (7)
extern const report::Section appendix_a;   // equation (1), accuracy of the creep
extern const report::Section appendix_b;   // wear of the wheels; numbers of the text
extern const report::Section experiment;   // Figs 3 to 7
extern const report::Section reduction;    // Figs 8 to 10
extern const report::Section full_theory;  // Kalker's curve
extern const report::Section collapse;     // Fig. 11
extern const report::Section state;        // the one reading that is printed
extern const report::Section area_law;     // creep times area
extern const report::Section cost;         // study
extern const report::Section extremes;     // study

// A row of an item's table with a printed value, checked.
struct PrintedRows {
  report::Item& item;
  table::CsvTable table;
  void operator()(const char* key, double computed, const char* note,
                  const report::Expectation& expectation = report::last_digit()) const;
};

void contact_answer(report::Item& item);  // of fig-full-curve

}  // namespace railbook::creep_chapter
