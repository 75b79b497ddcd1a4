// The sections of the chapter.
#pragma once

#include "report/chapter.hpp"

namespace railbook::filters {

// Filters.
void add_chords(report::Chapter& chapter);  // short chord to any chord

// The car: sensors, reconstruction, experiments, tool.

}  // namespace railbook::filters
