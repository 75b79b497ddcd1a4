// The sections of this chapter: each file registers its tables and figures.
#pragma once

#include "report/chapter.hpp"

namespace railbook::hunting_chapter {

extern const report::Section geometry, car, describing, critical, branches, modes, algorithm,
    stability, scenes;
extern const report::Section cost, extremes;  // study/

}  // namespace railbook::hunting_chapter
