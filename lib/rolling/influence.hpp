// What tangential tractions on a mesh of rows do to the strain that rolling turns into slip.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

namespace railbook::rolling {

// Rows of `along` cells each; every row has its own place, cell length and height. Lengths in any
// one unit.
struct RollingMesh {
  Eigen::Index along = 0;
  Eigen::VectorXd y, dy;   // rows: middle and height
  Eigen::VectorXd x0, dx;  // rows: centre of the first (trailing) cell, and length of a cell
  Eigen::Index rows() const { return y.size(); }
  Eigen::Index cells() const { return along * rows(); }
  double x(Eigen::Index row, Eigen::Index i) const {
    return x0[row] + static_cast<double>(i) * dx[row];
  }
  bool uniform() const;   // all rows alike and evenly spaced
  bool stepped() const;   // but for where they begin, and that mirrored across: see SteppedRows
  bool mirrored() const;  // its own mirror image across
};

// Where the ends of the contact belong on a row of cells of constant traction whose slip comes from
// the upstream difference u(x) - u(x + h): edge_offset() + 1/4 cells behind the centre of the
// trailing cell and edge_offset() + 3/4 cells ahead of the centre of the leading one, where 1/2 and
// 1/2 would fill the row. The discrete half-line has the symbol i sign(t) e^(it/2) R(t), |t| < pi,
// R = 4 sin^2(t/2) sum over m of (-1)^m sign(t + 2 pi m)/(t + 2 pi m)^2. Factorised (Wiener and
// Hopf), the half step e^(it/2) puts the ends at the quarters, as in the 1/4 - 3/4 rule of vortex
// lattices, and R adds edge_offset() = -1/(4 pi) integral from 0 to pi of ln R / sin^2(t/2) dt =
// 0.0753. Cells that just fill the contact make an error of first order in h, which this placing
// removes.
double edge_offset();

// What tractions do at the cell centres: the strain [u(x) - u(x + dx)]/dx, which steady rolling
// turns into slip per metre, or the displacement u itself, for steps in time on a uniform mesh.
enum class Response { strain, displacement };

// Exact influence of cell-constant tractions on half-spaces (Boussinesq-Cerruti). For two bodies of
// shear modulus 1 u_x = 1/pi integral of [(1 - nu)/r + nu X^2/r^3] px + nu X Y/r^3 py, u_y
// likewise.
class TangentialInfluence {
 public:
  // `dense` asks for a matrix (12 bytes a pair of cells), quicker up to some hundred cells; a mesh
  // that is neither uniform nor stepped always has one. Throws InputError where a mesh that needs
  // it is not mirrored().
  TangentialInfluence(const RollingMesh& mesh, double poisson, bool dense,
                      Response response = Response::strain);
  ~TangentialInfluence();
  TangentialInfluence(TangentialInfluence&&) noexcept;
  TangentialInfluence& operator=(TangentialInfluence&&) noexcept;

  // The response at every cell: p and strain are [x parts; y parts], 2 cells() long, row by row.
  void apply(const Eigen::VectorXd& p, Eigen::VectorXd& strain) const;
  // The same to 1e-6 of the largest, of a stepped mesh in half the time; of others apply().
  void approximate(const Eigen::VectorXd& p, Eigen::VectorXd& strain) const;
  // The part of `apply` from a row on itself, along x along each: of tractions along on the
  // response along, and of those across on that across; on one another they have none. With the
  // inverses of the factors L and U of both in one matrix, L's without its diagonal of ones: their
  // leading parts are those of any run of cells.
  struct Row {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> xx, yy, inverse_xx,
        inverse_yy;
  };
  const Row& row(Eigen::Index row) const { return rows_[rows_.size() == 1 ? 0 : std::size_t(row)]; }
  bool rows_alike() const { return rows_.size() == 1; }

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  std::vector<Row> rows_;  // or the one that they share
};

}  // namespace railbook::rolling
