// Options of the grid solver with so many cells, and a single grid of one's own.
#pragma once

#include <stdexcept>

#include <railbook/contact/cg_fft.hpp>

// One grid, as it is: p solves the bounded problem for the gap f at its cell centres.
inline railbook::contact::Region solve_on(const railbook::contact::Grid& grid,
                                          const Eigen::VectorXd& f, double approach, double modulus,
                                          Eigen::VectorXd& p, double tolerance = 1e-8) {
  railbook::contact::Convolution a(grid, modulus);
  p.setZero(grid.cells());
  if (!solve_bounded_cg(a, f, approach, p, {.tolerance = tolerance}).converged)
    throw std::runtime_error("conjugate gradients did not converge");
  return describe(grid, p, f);
}

inline railbook::contact::CgFftOptions cells(Eigen::Index nx, Eigen::Index ny) {
  railbook::contact::CgFftOptions options;
  options.nx = nx;
  options.ny = ny;
  return options;
}
