// Strip theory after Haines and Ollerton (1963), as FaStrip (Sichani, Enblom and Berg 2016) uses
// it: every strip of the ellipse along rolling is a line contact with Carter's tractions, and
// Kalker's coefficients set the initial slope.
#pragma once

#include <railbook/rolling/case.hpp>
#include <railbook/rolling/kalker_table.hpp>

namespace railbook::rolling {

struct StripOptions {
  int along = 40;  // cells of the tractions, where they are wanted
  int strips = 40;
  bool keep_tractions = false;
};

// Creepage without spin, in closed form. The stick area is the contact's outline moved back from
// the leading edge by one length in all strips, as Haines and Ollerton saw it in photoelastic
// models. The bound is Hertz's pressure times mu, in stick and slip. Throws InputError for spin
// (FaStrip itself adds it from FASTSIM) and on a case out of range.
CreepForces strip_theory(const RollingCase& c, const KalkerCoefficients& k,
                         const StripOptions& options = {});

}  // namespace railbook::rolling
