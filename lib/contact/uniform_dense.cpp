#include <railbook/contact/uniform_dense.hpp>

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/contact/influence.hpp>
#include <railbook/contact/region.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Displacement [m] at a cell centre under unit pressure on the cell i columns and j rows away.
MatrixXd influence_by_offset(const Grid& grid, double effective_modulus) {
  MatrixXd a(grid.nx, grid.ny);
  const double k = 1 / (units::pi * effective_modulus);
  for (Index j = 0; j < grid.ny; ++j)
    for (Index i = 0; i < grid.nx; ++i) {
      const double x = static_cast<double>(i) * grid.dx, y = static_cast<double>(j) * grid.dy;
      a(i, j) = k * rectangle_influence(x - 0.5 * grid.dx, x + 0.5 * grid.dx, y - 0.5 * grid.dy,
                                        y + 0.5 * grid.dy);
    }
  return a;
}

// The matrix between the cells of a set.
MatrixXd gather(const Grid& grid, const MatrixXd& by_offset, const std::vector<Index>& set) {
  const auto n = static_cast<Index>(set.size());
  MatrixXd a(n, n);
  for (Index c = 0; c < n; ++c)
    for (Index r = c; r < n; ++r) {
      const Index one = set[static_cast<std::size_t>(r)], two = set[static_cast<std::size_t>(c)];
      a(r, c) = by_offset(std::abs(one % grid.nx - two % grid.nx),
                          std::abs(one / grid.nx - two / grid.nx));
    }
  return a;
}

// Displacement at one cell under the pressures of a set.
double displacement(const Grid& grid, const MatrixXd& by_offset, const std::vector<Index>& set,
                    const VectorXd& p, Index cell) {
  double u = 0;
  for (std::size_t k = 0; k < set.size(); ++k)
    u += p[static_cast<Index>(k)] * by_offset(std::abs(set[k] % grid.nx - cell % grid.nx),
                                              std::abs(set[k] / grid.nx - cell / grid.nx));
  return u;
}

void fill(const Grid& grid, const VectorXd& f, const std::vector<Index>& set, const VectorXd& p,
          NormalContact& contact) {
  const auto n = static_cast<Index>(set.size());
  contact.x.resize(n), contact.y.resize(n), contact.p = p;
  contact.dx = VectorXd::Constant(n, grid.dx), contact.dy = VectorXd::Constant(n, grid.dy);
  VectorXd on_grid = VectorXd::Zero(grid.cells());
  for (Index k = 0; k < n; ++k) {
    const Index cell = set[static_cast<std::size_t>(k)];
    contact.x[k] = grid.x(cell % grid.nx);
    contact.y[k] = grid.y(cell / grid.nx);
    on_grid[cell] = p[k];
  }
  const Region region = describe(grid, on_grid, f);
  contact.force = region.force;
  contact.moment_x = region.moment_x, contact.moment_y = region.moment_y;
  contact.p_max = region.p_max;
  contact.x_p_max = region.x_p_max, contact.y_p_max = region.y_p_max;
  contact.x_min = region.ends.x_min, contact.x_max = region.ends.x_max;
  contact.y_min = region.ends.y_min, contact.y_max = region.ends.y_max;
  contact.area = region.area;
  if (region.touches_edge()) {
    contact.converged = false;
    contact.reason = "the contact reaches the edge of the grid";
  }
}

}  // namespace

NormalContact solve_uniform_dense(const Grid& grid, const VectorXd& f, double approach,
                                  double effective_modulus, const UniformDenseOptions& options) {
  units::require_finite("approach", approach, "m");
  units::require_positive("effective modulus", effective_modulus, "Pa");
  units::require_positive("cell size along x", grid.dx, "m");
  units::require_positive("cell size along y", grid.dy, "m");
  if (f.size() != grid.cells())
    throw InputError(
        fmt::format("the gap has {} values, the grid {} x {} cells", f.size(), grid.nx, grid.ny));
  std::vector<Index> set;
  for (Index n = 0; n < f.size(); ++n) {
    if (std::isnan(f[n])) throw InputError(fmt::format("the gap of cell {} is NaN", n));
    if (f[n] < approach) set.push_back(n);
  }
  const double bytes = 8.0 * static_cast<double>(set.size()) * static_cast<double>(set.size());
  if (bytes > static_cast<double>(options.most_bytes))
    throw InputError(
        fmt::format("{} cells may touch: their matrix needs {:.3g} GB, the limit is {:.3g} GB",
                    set.size(), bytes / 1e9, static_cast<double>(options.most_bytes) / 1e9));
  if (set.empty()) return empty_contact(approach);
  NormalContact contact;
  contact.approach = approach;
  contact.force_error = contact.p_max_error = std::numeric_limits<double>::quiet_NaN();
  const MatrixXd by_offset = influence_by_offset(grid, effective_modulus);
  VectorXd p;
  for (contact.iterations = 0; contact.iterations < options.most_updates; ++contact.iterations) {
    VectorXd g(static_cast<Index>(set.size()));
    for (Index k = 0; k < g.size(); ++k) g[k] = approach - f[set[static_cast<std::size_t>(k)]];
    p = gather(grid, by_offset, set).selfadjointView<Eigen::Lower>().llt().solve(g);
    contact.work += static_cast<long>(set.size() * set.size());
    std::vector<char> stays(static_cast<std::size_t>(grid.cells()), 0);
    for (Index k = 0; k < p.size(); ++k)
      stays[static_cast<std::size_t>(set[static_cast<std::size_t>(k)])] = p[k] > 0 ? 1 : 2;
    std::vector<Index> next;
    for (Index n = 0; n < grid.cells(); ++n) {
      const char state = stays[static_cast<std::size_t>(n)];
      const bool joins = state == 0 && f[n] < approach &&
                         displacement(grid, by_offset, set, p, n) < approach - f[n];
      if (state == 1 || joins) next.push_back(n);
    }
    contact.converged = next == set;
    if (contact.converged) break;
    set = std::move(next);
  }
  if (!contact.converged) contact.reason = "the set of cells in contact does not settle";
  if (p.size() == static_cast<Index>(set.size())) fill(grid, f, set, p, contact);
  return contact;
}

}  // namespace railbook::contact
