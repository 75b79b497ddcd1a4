// What answers on ever finer grids tend to, and how well that is known: a reference where no closed
// form is.
#pragma once

#include <vector>

namespace railbook::bench {

// The answers of one grid, and the number of its cells along a side (or any measure of its
// fineness).
struct Grid {
  double size = 0;
  std::vector<double> answers;
};

// The limit of each answer and its standard error.
struct Limit {
  std::vector<double> answers;
  std::vector<double> uncertainty;
  double order = 0;  // of the error in 1/size
};

// From grids in order, the finest last: fits answer = limit + slope size^-order by least squares,
// with one order for all answers: of 1 to 2.5, in steps of 0.05, the one that leaves least. The
// error is the root of a sum of squares: the jackknife's, how the limit moves as each grid is left
// out, the order sought anew; how it moves as the coarser half is (four stay); and as each answer
// takes an order of its own: where errors are no one power of the size, or not the same, the others
// agree on a wrong limit. Of rolling contact with spin, limits of 24 to 96 cells a side were off by
// .7 to 1 of this, root mean square. Throws std::logic_error with fewer than four grids, or with
// other counts of answers.
Limit limit_of(const std::vector<Grid>& grids);

}  // namespace railbook::bench
