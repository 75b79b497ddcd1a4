// Kalker's simplified theory (FASTSIM, 1982): the surface is a bed of independent springs, so
// tractions grow from the leading edge in proportion to the slip until they meet the bound.
#pragma once

#include <railbook/rolling/case.hpp>
#include <railbook/rolling/kalker_table.hpp>

namespace railbook::rolling {

// mu times the pressure that bounds the tractions. `parabolic` is what fits the simplified theory
// (stick then grows as the exact theory says); `elliptic` is mu times Hertz's own pressure.
enum class Bound { parabolic, elliptic };

struct FastsimOptions {
  Bound bound = Bound::parabolic;
  int along = 40;   // cells in each strip
  int strips = 40;  // across
  bool keep_tractions = false;
};

// Creepage without spin, in closed form: no grid, no quadrature; rounding only. The three
// flexibilities are those that give C11, C22 and C23. No tractions. Throws InputError for spin.
CreepForces fastsim_without_spin(const RollingCase& c, const KalkerCoefficients& k,
                                 Bound bound = Bound::parabolic);

// Any creepage, on strips of cells that follow the ellipse. The bound is integrated exactly over
// every cell, so that the force of full slip is mu N to rounding and |F| <= mu N always. Against
// the closed form the error falls with the square of the cell; 40 x 40 cells are good to about 1e-3
// of mu N. Throws InputError unless 1 <= cells <= 4096.
CreepForces fastsim_grid(const RollingCase& c, const KalkerCoefficients& k,
                         const FastsimOptions& options = {});

// The closed form without spin, and the grid with it or where tractions are wanted.
CreepForces fastsim(const RollingCase& c, const KalkerCoefficients& k,
                    const FastsimOptions& options = {});

}  // namespace railbook::rolling
