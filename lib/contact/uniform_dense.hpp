// Normal contact on a uniform grid with a dense matrix: the peer of the conjugate gradients with FFT.
#pragma once

#include <cstddef>

#include <railbook/contact/grid.hpp>
#include <railbook/contact/normal_contact.hpp>

namespace railbook::contact {

struct UniformDenseOptions {
  int most_updates = 60;                          // of the set of cells in contact
  std::size_t most_bytes = std::size_t{1} << 30;  // of the dense matrix
};

// The contact of a gap given by its values f at the cell centres of `grid` [m; infinity: no body], at an
// approach delta [m], E* > 0 [Pa]: the same discrete problem as solve_cg_fft, solved on the cells in contact by
// Cholesky's factors; cells under tension leave and cells that penetrate join, until neither happens (a primal-
// dual active set, which needs no starting region). Exact but for rounding; the work counts unknowns^2. No error
// estimate (NaN). Throws InputError on NaN in f, bad arguments or a matrix beyond the limit; converged is
// false when the set does not settle or reaches the edge of the grid.
[[nodiscard]] NormalContact solve_uniform_dense(const Grid& grid, const Eigen::VectorXd& f,
                                                double approach, double effective_modulus,
                                                const UniformDenseOptions& options = {});

}  // namespace railbook::contact
