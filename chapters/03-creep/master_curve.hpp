// Kalker's curve for the rig's ellipse: the friction that is used, mu/mu_c, over X = G a b xi/(mu_c N).
#pragma once

namespace railbook::creep_chapter {

// By the full theory, from 0 to X = 2 and the value there beyond; odd in X. Solved once, at 73 places; between them
// cubic, to about 1e-4.
double master_curve(double x);

// The X at which the curve passes `share`, 0 < share < 0.999.
double master_curve_inverse(double share);

}  // namespace railbook::creep_chapter
