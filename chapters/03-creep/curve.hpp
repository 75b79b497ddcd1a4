// Kalker's curve for the rig's ellipse by the full theory: the friction that is used, mu/mu_c, over
// X = G a b xi/(mu_c N).
#pragma once

#include "rolling/force_table.hpp"
#include "rolling/rolling_contact.hpp"

namespace railbook::creep_chapter {

// A case with the paper's ellipse and load, mu = 0.3, without creepage.
rolling::RollingCase rig_case();

// The curve from 0 to X = 2 as a table that is linear between its nodes.
rolling::ForceTable curve_table(int nodes, const rolling::RollingOptions& options);

// From such a table, to about 2e-4; odd in X, and beyond X = 2 the value there.
double master_curve(double x);

// The X at which it passes `share`, 0 < share < 0.999.
double master_curve_inverse(double share);

}  // namespace railbook::creep_chapter
