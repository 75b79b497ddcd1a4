// The parts of COUNTACT that do not iterate: mesh, coefficients, boundary. Not for use outside this
// folder, but for its tests.
#pragma once

#include <string>

#include "method/countact.hpp"

namespace railbook::contact_chapter::detail {

// Cell numbering: `half_rows` cells from the axis outward in each of `unknown_columns` columns.
struct CellNumbers {
  int rows = 0;
  int half_rows = 0;
  int columns = 0;
  int unknown_columns = 0;  // all columns, or those at x >= 0 with both axes of symmetry
  int first_column = 0;     // the leftmost of them

  CellNumbers(int rows, int columns, bool both_axes);
  int fold_row(int row) const;        // 0 .. rows - 1 from the bottom, to 0 .. half_rows - 1
  int fold_column(int column) const;  // 0 .. columns - 1, to 0 .. unknown_columns - 1
  Eigen::Index first_of(int unknown_column) const {
    return Eigen::Index{half_rows} * unknown_column;
  }
  int size() const { return half_rows * unknown_columns; }
};

// The numbering for these options; throws InputError when they make no sense or need too much
// memory.
CellNumbers number_cells(const CountactOptions& options, bool both_axes);

double column_centre(const ColumnMesh& mesh, Eigen::Index j);

// Ordinate of cell k (from the axis outward) of column j, and the height of a cell there.
double cell_height(const ColumnMesh& mesh, const CellNumbers& cells, Eigen::Index j);
double cell_centre(const ColumnMesh& mesh, const CellNumbers& cells, Eigen::Index j, int k);

// The coefficients of every unknown at one field point: a row of eq. (14), folded.
void influence_row(const ColumnMesh& mesh, const CellNumbers& cells, double x, double y,
                   Eigen::VectorXd& row);

// The whole matrix of eq. (14).
Eigen::MatrixXd influence_matrix(const ColumnMesh& mesh, const CellNumbers& cells);

// Edges of the columns between the two ends of the region.
Eigen::VectorXd place_columns(const Columns& columns, double x_min, double x_max);

// The half width of the interpenetration curve at x, 0 outside it.
double interpenetration_half_width(const Gap& gap, double approach, double x);

// Where the pressure falls to zero on an outward line of positions s with pressures p, p[0] > 0
// (Figs 3 and 4).
struct Zero {
  double at;
  int positive;  // leading points of positive pressure
  bool stuck;    // the pressure does not fall outward: `at` is the old boundary
};
Zero find_zero(const Eigen::VectorXd& s, const Eigen::VectorXd& p, double boundary, Fit fit,
               bool inward_only);

// Fills the new boundary of a step from its pressures (Figs 3 and 4), makes `share` of each move,
// and returns the mesh that follows (eq. 17). A reason that is not empty means failure.
struct Update {
  ColumnMesh mesh;
  std::string reason;
};
Update update_boundary(CountactStep& step, const CellNumbers& cells, const CountactOptions& options,
                       double share);

}  // namespace railbook::contact_chapter::detail
