#include <railbook/num/eigenvalues.hpp>

#include <gsl/gsl_eigen.h>

#include <algorithm>
#include <stdexcept>

#include <railbook/num/gsl.hpp>

namespace railbook::num {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// A copy, which GSL works in; its iterations may not see a NaN.
RowMajor finite(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  if (!matrix.allFinite()) throw std::runtime_error{"eigenvalues of a matrix that is not finite"};
  return matrix;
}

gsl_matrix_view view(RowMajor& a) {
  return gsl_matrix_view_array(a.data(), std::size_t(a.rows()), std::size_t(a.cols()));
}

// GSL's complex numbers are two doubles, as ours.
template <class Complexes>
double* doubles(Complexes& z) {
  return reinterpret_cast<double*>(z.data());
}

void require_converged(int status) {
  if (status != GSL_SUCCESS) throw std::runtime_error{"eigenvalues do not converge"};
}

}  // namespace

Eigen::VectorXcd eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  use_gsl_status_codes();
  RowMajor a = finite(matrix);
  const auto n = std::size_t(a.rows());
  const auto space = gsl_owned(gsl_eigen_nonsymm_alloc(n), gsl_eigen_nonsymm_free);
  Eigen::VectorXcd values(a.rows());
  gsl_matrix_view in = view(a);
  gsl_vector_complex_view out = gsl_vector_complex_view_array(doubles(values), n);
  require_converged(gsl_eigen_nonsymm(&in.matrix, &out.vector, space.get()));
  return values;
}

Eigenpairs eigenpairs(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  use_gsl_status_codes();
  RowMajor a = finite(matrix);
  const auto n = std::size_t(a.rows());
  const auto space = gsl_owned(gsl_eigen_nonsymmv_alloc(n), gsl_eigen_nonsymmv_free);
  Eigenpairs pairs{Eigen::VectorXcd(a.rows()), Eigen::MatrixXcd(a.rows(), a.rows())};
  gsl_matrix_view in = view(a);
  gsl_vector_complex_view values = gsl_vector_complex_view_array(doubles(pairs.values), n);
  gsl_matrix_complex_view rows = gsl_matrix_complex_view_array(doubles(pairs.vectors), n, n);
  require_converged(gsl_eigen_nonsymmv(&in.matrix, &values.vector, &rows.matrix, space.get()));
  pairs.vectors.transposeInPlace();  // GSL's matrices stand row by row
  return pairs;
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  use_gsl_status_codes();
  RowMajor a = finite(matrix);
  const auto n = std::size_t(a.rows());
  const auto space = gsl_owned(gsl_eigen_symm_alloc(n), gsl_eigen_symm_free);
  Eigen::VectorXd values(a.rows());
  gsl_matrix_view in = view(a);
  gsl_vector_view out = gsl_vector_view_array(values.data(), n);
  require_converged(gsl_eigen_symm(&in.matrix, &out.vector, space.get()));
  std::sort(values.begin(), values.end());
  return values;
}

}  // namespace railbook::num
