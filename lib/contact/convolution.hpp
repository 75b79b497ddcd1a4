// Displacements of constant-pressure cells on a uniform grid as a convolution, by fast Fourier transforms.
#pragma once

#include <Eigen/Core>

#include "contact/grid.hpp"
#include "num/fft.hpp"

namespace railbook::contact {

// u = A p: the sum of the surface displacements of both bodies [m] at the cell centres of `grid` under a
// constant pressure on each cell [Pa]; exact for such pressures (eqs. 13-15 of the paper on a uniform grid).
// The grid is padded with zeros to a good FFT size of at least twice its own less one, so nothing wraps round.
class Convolution {
 public:
  Convolution(const Grid& grid, double effective_modulus);
  void apply(const Eigen::VectorXd& p, Eigen::VectorXd& u);
  double effective_modulus() const { return effective_modulus_; }
  long points() const;                   // real points of one padded transform
  double self() const { return self_; }  // a diagonal entry of A: a cell's own displacement [m/Pa]

 private:
  Eigen::Index nx_, ny_;
  num::RealFft2d fft_;
  double effective_modulus_;
  double self_ = 0;
  // A is even in x and y, so its transform is real and a quarter of it is enough: (rows/2+1) x (columns/2+1).
  std::vector<double> spectrum_;
};

// z = P r, an approximate inverse of A: division by the symbol of A on the grid itself, wrapped round. A acts
// like 1/|k|, so its inverse |k| reaches only as far as 1/r^3 and needs no padding: a quarter of the work.
class InversePreconditioner {
 public:
  InversePreconditioner(const Grid& grid, double effective_modulus);
  void apply(const Eigen::VectorXd& r, Eigen::VectorXd& z);
  long points() const;

 private:
  Eigen::Index nx_, ny_;
  num::RealFft2d fft_;
  std::vector<double> inverse_;
};

// Bytes that solving on a grid of nx by ny cells takes: transforms, spectra and the vectors of the solver.
double memory_needed(Eigen::Index nx, Eigen::Index ny);

}  // namespace railbook::contact
