// Products of the influence between rows whose cells have one length but begin where each row
// begins.
#pragma once

#include <Eigen/Core>
#include <memory>

#include <railbook/rolling/influence.hpp>

namespace railbook::rolling {

// Fourier transforms along the rows turn the strain that rolling makes into one small dense product
// a frequency, between rows; across, the mesh is its own mirror image, which splits it into an even
// and an odd half. The mesh must be stepped(). Memory about 32 (along + 1) rows^2 bytes; a product
// takes as many multiplications as a quarter of that.
class SteppedRows {
 public:
  SteppedRows(const RollingMesh& mesh, double poisson);
  ~SteppedRows();

  // As TangentialInfluence::apply, to 2e-13 of the largest.
  void apply(const Eigen::VectorXd& p, Eigen::VectorXd& strain) const;
  // In single precision, to 1e-6 of it: twice as fast.
  void approximate(const Eigen::VectorXd& p, Eigen::VectorXd& strain) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace railbook::rolling
