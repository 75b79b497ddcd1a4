// A convolution with 1/r in two parts: a short one on the grid itself, and a smooth one on a grid
// some cells coarser.
#pragma once

#include <Eigen/Core>

#include <railbook/contact/grid.hpp>
#include <railbook/num/even_filter.hpp>

namespace railbook::contact {

// u = A p as Convolution::approximate has it.
// The influence of a cell is divided into F(r), which is 1/r beyond a radius R and the Taylor
// polynomial of 1/r in r^2 within it, and what is left, which ends at R. The short part needs a
// frame that is larger than the grid by R only, instead of twice the grid; the smooth one is
// interpolated by polynomials of degree 7 from a grid of R/8 (Brandt & Lubrecht 1990,
// doi:10.1016/0021-9991(90)90171-V, who sum where we transform).
class SplitConvolution {
 public:
  SplitConvolution(const Grid& grid, double effective_modulus, int threads);
  void apply(const Eigen::VectorXd& p, Eigen::VectorXd& u, double* workspace);
  long points() const;  // real points of both frames

  // What points() would be, without building it.
  static long points(const Grid& grid);

 private:
  // One axis: `step` cells to a coarse one, and the weights of the 8 coarse nodes about each.
  struct Axis {
    Eigen::Index cells, step, coarse;
    Eigen::Matrix<double, 8, Eigen::Dynamic> weights;  // a column a cell of the step
    Axis(Eigen::Index count, Eigen::Index cells_a_node);
  };
  struct Sizes;

  SplitConvolution(const Grid& grid, const Sizes& sizes, double effective_modulus, int threads);
  void gather(const Eigen::VectorXd& p);
  void spread(Eigen::VectorXd& u) const;

  Axis x_, y_;
  int threads_;
  num::EvenFilter near_, far_;
  Eigen::MatrixXd rows_, coarse_;  // a column a row of the grid, coarse along x; and along both
};

}  // namespace railbook::contact
