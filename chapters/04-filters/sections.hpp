// The sections of the chapter: of the paper, and of the study.
#pragma once

#include <railbook/report/chapter.hpp>

namespace railbook::filters_chapter {

extern const report::Section flow, system, scene_of_car;  // the idea, the car and its sensors
extern const report::Section hybrid, independence;        // Figures 7 to 9
extern const report::Section curvature, crosslevel;       // and what corrects them
extern const report::Section profile, speeds;             // Figure 13, error against speed
extern const report::Section mismatch, cost, stability;   // the study
extern const report::Section digits;

}  // namespace railbook::filters_chapter
