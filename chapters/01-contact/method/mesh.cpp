// COUNTACT's mesh and the coefficients on it.
#include <algorithm>
#include <cmath>

#include <railbook/contact/influence.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "method/parts.hpp"

namespace railbook::contact_chapter {

using namespace contact;

namespace {

std::vector<double> side_edges(const Side& side) {
  if (side.wide < 1 || side.narrow < 0)
    throw InputError{"columns on one side of the origin: " + std::to_string(side.wide) +
                     " wide, must be >= 1, and " + std::to_string(side.narrow) +
                     " narrow, must be >= 0"};
  const double share = side.narrow == 0 ? 0.0 : side.share;
  if (side.narrow > 0) units::require_between("share of the narrow columns", share, 1e-6, 1 - 1e-6);
  std::vector<double> edges{0};
  for (int i = 1; i <= side.wide; ++i) edges.push_back((1 - share) * i / side.wide);
  for (int i = 1; i <= side.narrow; ++i) edges.push_back(1 - share + share * i / side.narrow);
  edges.back() = 1;
  return edges;
}

void require_ascending(const std::vector<double>& edges) {
  bool good = edges.size() >= 2 && edges.front() == 0 && edges.back() == 1;
  for (std::size_t i = 1; i < edges.size(); ++i) good = good && edges[i] > edges[i - 1];
  if (!good) throw InputError{"columns: edges must ascend from 0 to 1, with one column or more"};
}

bool mirrored(const Columns& c) {
  if (c.whole.empty()) return c.left == c.right;
  for (std::size_t i = 0; i < c.whole.size(); ++i)
    if (std::abs(c.whole[i] + c.whole[c.whole.size() - 1 - i] - 1) > 1e-12) return false;
  return true;
}

}  // namespace

Columns uniform_columns(int n) {
  units::require_between("columns", n, 3, 1e6);
  Columns columns;
  for (int i = 0; i <= n; ++i) columns.whole.push_back(double(i) / n);
  return columns;
}

Columns split_columns(const Side& left, const Side& right) {
  return {{}, side_edges(left), side_edges(right)};
}

Columns graded_columns(int left, int right) {
  const auto edges = [](int n) {
    units::require_between("columns on one side of the origin", n, 1, 1e6);
    std::vector<double> t;
    for (int i = 0; i <= n; ++i)
      t.push_back((double(i) / n + (1 - std::cos(units::pi * i / n)) / 2) / 2);
    t.back() = 1;
    return t;
  };
  return {{}, edges(left), edges(right)};
}

Eigen::MatrixXd countact_matrix(const ColumnMesh& mesh, int rows, bool both_axes) {
  const auto m = mesh.half_width.size();
  if (mesh.x_edges.size() != m + 1 || m < 1 || rows < 1)
    throw InputError{"column mesh: one edge more than columns, and one row or more, are needed"};
  return detail::influence_matrix(mesh, {rows, static_cast<int>(m), both_axes});
}

namespace detail {

CellNumbers::CellNumbers(int n_rows, int n_columns, bool both_axes)
    : rows{n_rows},
      half_rows{(n_rows + 1) / 2},
      columns{n_columns},
      unknown_columns{both_axes ? (n_columns + 1) / 2 : n_columns},
      first_column{n_columns - unknown_columns} {}

int CellNumbers::fold_row(int row) const {
  return row >= rows / 2 ? row - rows / 2 : (rows - 1) / 2 - row;
}

int CellNumbers::fold_column(int column) const {
  if (unknown_columns == columns) return column;
  return column >= first_column ? column - first_column : (columns - 1) / 2 - column;
}

CellNumbers number_cells(const CountactOptions& o, bool both_axes) {
  if (o.columns.whole.empty()) {
    require_ascending(o.columns.left);
    require_ascending(o.columns.right);
  } else {
    require_ascending(o.columns.whole);
  }
  if (both_axes && !mirrored(o.columns))
    throw InputError{"COUNTACT-2: columns must be the same left and right of the origin"};
  const std::size_t columns = o.columns.whole.empty()
                                  ? o.columns.left.size() + o.columns.right.size() - 2
                                  : o.columns.whole.size() - 1;
  units::require_between("columns", double(columns), 3, 1e6);
  units::require_between("rows", o.rows, o.fit == Fit::two_points ? 3 : 5, 1e6);
  units::require_between("tolerance of the boundary", o.tolerance, 1e-14, 1);
  units::require_between("iterations", o.most_iterations, 1, 1e6);
  const CellNumbers cells{o.rows, static_cast<int>(columns), both_axes};
  const double n = double(cells.half_rows) * cells.unknown_columns, bytes = 8 * n * n;
  if (!(bytes <= double(o.most_bytes)))
    throw InputError{"the dense matrix of this mesh needs " + std::to_string(bytes / 1048576) +
                     " MiB, allowed are " + std::to_string(double(o.most_bytes) / 1048576) +
                     " MiB: use fewer columns and rows"};
  return cells;
}

double column_centre(const ColumnMesh& mesh, Eigen::Index j) {
  return (mesh.x_edges[j] + mesh.x_edges[j + 1]) / 2;
}

double cell_height(const ColumnMesh& mesh, const CellNumbers& cells, Eigen::Index j) {
  return 2 * mesh.half_width[j] / cells.rows;
}

double cell_centre(const ColumnMesh& mesh, const CellNumbers& cells, Eigen::Index j, int k) {
  return (k + (cells.rows % 2 == 1 ? 0.0 : 0.5)) * cell_height(mesh, cells, j);
}

// Cells of a column share their edges in y, so a column of n cells needs 2 (n + 1) corners and not
// 4 n.
void influence_row(const ColumnMesh& mesh, const CellNumbers& cells, double x, double y,
                   Eigen::VectorXd& row) {
  row.setZero();
  for (int j = 0; j < cells.columns; ++j) {
    const double left = mesh.x_edges[j] - x, right = mesh.x_edges[j + 1] - x;
    const double height = cell_height(mesh, cells, j);
    double* column = row.data() + cells.first_of(cells.fold_column(j));
    double before = 0;
    for (int e = 0; e <= cells.rows; ++e) {
      const double edge = (e - cells.rows / 2.0) * height - y;
      const double side = corner_function(right, edge) - corner_function(left, edge);
      if (e > 0) column[cells.fold_row(e - 1)] += side - before;
      before = side;
    }
  }
}

Eigen::MatrixXd influence_matrix(const ColumnMesh& mesh, const CellNumbers& cells) {
  Eigen::MatrixXd b(cells.size(), cells.size());
  Eigen::VectorXd row(cells.size());
  Eigen::Index i = 0;
  for (int j = cells.first_column; j < cells.columns; ++j)
    for (int k = 0; k < cells.half_rows; ++k) {
      influence_row(mesh, cells, column_centre(mesh, j), cell_centre(mesh, cells, j, k), row);
      b.row(i++) = row;
    }
  return b;
}

Eigen::VectorXd place_columns(const Columns& columns, double x_min, double x_max) {
  const bool split = columns.whole.empty();
  const std::size_t count =
      split ? columns.left.size() + columns.right.size() - 1 : columns.whole.size();
  Eigen::VectorXd edges(static_cast<Eigen::Index>(count));
  Eigen::Index at = 0;
  for (double t : columns.whole) edges[at++] = (1 - t) * x_min + t * x_max;
  if (split) {
    for (std::size_t i = columns.left.size(); i-- > 1;) edges[at++] = columns.left[i] * x_min;
    for (double t : columns.right) edges[at++] = t * x_max;
  }
  return edges;
}

double interpenetration_half_width(const Gap& gap, double approach, double x) {
  if (!(gap(x, 0) < approach)) return 0;
  double low = 0, high = approach;
  while (gap(x, high) < approach && high < 1e6) low = high, high *= 2;
  for (int i = 0; i < 60 && high - low > 1e-15 * high; ++i) {
    const double middle = low + (high - low) / 2;
    (gap(x, middle) < approach ? low : high) = middle;
  }
  return low;
}

}  // namespace detail
}  // namespace railbook::contact_chapter
