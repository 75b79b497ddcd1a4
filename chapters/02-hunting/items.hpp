// The parts of this chapter: each file adds its tables, figures and tools.
#pragma once

#include "report/chapter.hpp"

namespace railbook::hunting {

void add_conversions(report::Chapter&);  // quantities printed in two units

// Profiles and geometry of contact.

// The car, describing functions, limit cycles.

// Harmonic balance, time, Floquet, scene.

}  // namespace railbook::hunting
