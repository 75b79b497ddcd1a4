// What the cost study and the stability table of the moving load share.
#pragma once

namespace railbook::track_chapter {

// Deflection under the moving load by four roots and residues, for comparison: loses digits near V_c.
double deflection_by_roots(double theta, double zeta);

}  // namespace railbook::track_chapter
