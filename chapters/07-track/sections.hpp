// The sections of this chapter, in the paper's order, and of its study.
#pragma once

#include "report/chapter.hpp"

namespace railbook::track_chapter {

extern const report::Section stiffness;  // rail on its foundation: Fig. 1
extern const report::Section chain;      // from pad to subgrade: Fig. 2
extern const report::Section joint;      // stiffness near a joint: Fig. 3
extern const report::Section moving;     // critical speed and moving load
extern const report::Section lumped;     // on car and at trackside: Figs 4 and 5
extern const report::Section masses;     // effective masses and damping
extern const report::Section geometry;   // joints, spectra, profiles: Figs 6 and 7
extern const report::Section impact;     // what the model does with a joint

extern const report::Section cost, extremes;  // study/

void draw_steps(report::Item&);  // the scene of Fig. 2

}  // namespace railbook::track_chapter
