// Normal contact on a uniform grid: bounded conjugate gradients with FFT convolution, and a remedy
// for the error that the pixelised edge of the contact makes.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <railbook/contact/bounded_cg.hpp>
#include <railbook/contact/grid.hpp>
#include <railbook/contact/normal_contact.hpp>
#include <railbook/contact/region.hpp>

namespace railbook::contact {

struct CgFftOptions {
  Eigen::Index nx = 127,
               ny = 127;  // cells of the finest grid, which is fitted to the region; at least 4
  BoundedCgOptions cg = {};
  bool remedy = true;  // extrapolate over the grids; false: the sums of the finest grid
  // Where to look for contact at an approach; empty: found from the gap, outward from the origin
  // or, when the gap there is larger than the approach, from a place near it where it is not.
  std::function<Box(double)> search = {};
  std::optional<double> edge_x = {};  // a cell edge is put on this x (a jump of the curvature) ...
  std::optional<double> edge_y = {};  // ... or y
  double memory_limit = 4e9;          // bytes
};

// One grid of the ladder, as solved.
struct CgFftLevel {
  Grid grid;
  Region region;
  int iterations = 0;
  double residual = 0;
};

// `contact` is the answer: p on the finest grid (sum p dA is the unremedied force), and force,
// moments, p_max and their error estimates extrapolated over `levels`, the last of which is the
// finest grid.
struct CgFft {
  NormalContact contact;
  std::vector<CgFftLevel> levels;
  Outline outline;  // on the finest grid

  // contact.work in pairs of Fourier transforms of the finest grid, padded with zeros to twice its
  // size: what one product with the matrix takes. An empty contact takes none.
  double transform_pairs() const;
};

// The contact of two bodies of gap f pressed to an approach delta [m]; E* > 0 [Pa].
// Method: grids each sqrt(2) finer than the last, each started from the one before and fitted to
// the region seen there (grown where the region touches its edge), each solved to
// options.cg.tolerance. The force of one grid is off by c h^2 and by an irregular part of order
// h^2.5 that depends on how the edge meets the cells, mostly where the edge is parallel to them.
// The grids are placed so that these parts cancel between the x and y ends, and c h^2 is then
// removed by a fit over the last three grids (order 1 where body edges make one). The ends of the
// region, first order on one grid, are extrapolated likewise. An approach <= 0 is an empty contact:
// force 0, converged, and the reason says so. The errors stated for force and p_max were never
// exceeded by Hertz's contacts of any slenderness and direction. p_max_error is infinite where the
// contact ends at the edge of a body or more steeply than the grid resolves, both errors are where
// the contact is narrower than 5 cells (or between them: then no cell bears); the reason says so.
// Throws InputError on NaN in the gap or an argument, E* <= 0, sizes < 4, a ladder beyond the
// memory limit, or bodies that never separate or do not come closer than the approach near the
// origin. converged is false, with the reason, when a grid is not solved to tolerance.
[[nodiscard]] CgFft solve_cg_fft(const Gap& gap, double approach, double effective_modulus,
                                 const CgFftOptions& options = {});

// The same for a given load [N, > 0]: the approach is sought, first on a coarse grid, until the
// (remedied) force is within 1e-7 of the load or, on a grid too coarse for that, within its stated
// error, which the reason then says; converged is false when 40 solves do not find it. Needs a gap
// whose force grows with the approach, that is any gap that is finite near the origin.
[[nodiscard]] CgFft solve_cg_fft_load(const Gap& gap, double load, double effective_modulus,
                                      const CgFftOptions& options = {});

}  // namespace railbook::contact
