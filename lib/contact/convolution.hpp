// Displacements of constant-pressure cells on a uniform grid as a convolution, by fast Fourier
// transforms.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>

#include <railbook/contact/grid.hpp>
#include <railbook/num/even_filter.hpp>

namespace railbook::contact {

class SplitConvolution;
class InversePreconditioner;

// u = A p: the sum of the surface displacements of both bodies [m] at the cell centres of `grid`
// under a constant pressure on each cell [Pa]; exact for such pressures (eqs. 13-15 of the paper on
// a uniform grid), to 1e-14 where none is negative. The grid is padded with zeros to a good FFT
// size of at least twice its own less one, so nothing wraps round. The digits do not depend on the
// number of threads.
class Convolution {
 public:
  Convolution(const Grid& grid, double effective_modulus, int threads = 1);
  // The same with a kernel of one's own: kernel(i, j) is the displacement times pi E* [m] that a
  // unit pressure on a cell makes i cells along x and j along y from its centre; even in both.
  Convolution(const Grid& grid, double effective_modulus,
              const std::function<double(Eigen::Index, Eigen::Index)>& kernel);
  ~Convolution();
  void apply(const Eigen::VectorXd& p, Eigen::VectorXd& u);
  // u = A p to 1e-6 of the largest |u| where p >= 0 (2e-6 where a cell is more slender than 1:10),
  // at a third of the work (detail/split_convolution.hpp). Where the grid is too small for that to
  // pay, approximates() is false, and this is apply().
  void approximate(const Eigen::VectorXd& p, Eigen::VectorXd& u);
  bool approximates() const { return split_ != nullptr; }
  long approximate_points() const;
  double effective_modulus() const { return effective_modulus_; }
  long points() const;                   // real points of one padded transform
  double self() const { return self_; }  // a diagonal entry of A: a cell's own displacement [m/Pa]
  double* workspace() { return workspace_.data(); }
  // Made once, when first asked for.
  InversePreconditioner& inverse();

 private:
  Grid grid_;
  int threads_ = 1;
  num::EvenFilter filter_;  // A is even in x and y
  num::Workspace workspace_;
  double effective_modulus_;
  double self_ = 0;
  std::unique_ptr<SplitConvolution> split_;
  std::unique_ptr<InversePreconditioner> inverse_;
};

// z = P r, an approximate inverse of A: division by the symbol of A on the grid itself, wrapped
// round. A acts like 1/|k|, so its inverse |k| reaches only as far as 1/r^3 and needs no padding: a
// quarter of the work.
class InversePreconditioner {
 public:
  InversePreconditioner(const Grid& grid, double effective_modulus, int threads = 1);
  void apply(const Eigen::VectorXd& r, Eigen::VectorXd& z, double* workspace);  // the Convolution's
  long points() const;

 private:
  num::EvenFilter filter_;
};

// Bytes that solving on a grid of nx by ny cells takes: transforms, spectra and the vectors of the
// solver.
double memory_needed(Eigen::Index nx, Eigen::Index ny);

}  // namespace railbook::contact
