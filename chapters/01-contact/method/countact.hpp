// COUNTACT: the simply discretized method on a mesh that is fitted anew to every candidate contact
// region.
//
// The region is symmetric about x, and cut into columns; each column of half width c is cut into
// `rows` equal cells of constant pressure. COUNTACT-1 uses this one symmetry, COUNTACT-2 also that
// about y.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include <railbook/contact/normal_contact.hpp>

namespace railbook::contact_chapter {

using contact::Gap, contact::NormalContact;

// How the x diameter is cut: column edges as fractions. Either `whole` alone, from 0 (x_min) to 1
// (x_max), or `left` and `right`, from 0 (the origin) to 1 (that end): then an edge stays on x = 0.
struct Columns {
  std::vector<double> whole;
  std::vector<double> left, right;
};

// n >= 3 columns of one width over the whole diameter, as in the paper's Fig. 2.
Columns uniform_columns(int n);

// Two widths on each side of the origin (the paper's footnote 1): `wide` columns next to the origin
// and `narrow` ones over the outer `share` (0 < share < 1) of the side; narrow = 0 leaves equal
// columns.
struct Side {
  int wide = 0;
  int narrow = 0;
  double share = 0.25;
};
Columns split_columns(const Side& left, const Side& right);

// `left` and `right` columns (each >= 1) on the two sides of the origin, whose width falls smoothly
// to about half the mean towards the origin and towards the end: the mean of equal and of cosine
// spacing.
Columns graded_columns(int left, int right);

// How the pressure is continued to zero beyond the outermost cells of a column (Fig. 4).
enum class Fit {
  two_points,           // y = c0 + c2 p^2: what suits p ~ sqrt(distance from the boundary)
  three_points,         // y = c0 + c1 p + c2 p^2, as it comes: unstable, kept to show it
  three_points_guarded  // the same, but two points where it would make p two-valued in y
};

struct CountactOptions {
  Columns columns = uniform_columns(9);
  int rows = 9;  // cells in a full column, >= 3 (three points: 5); odd puts one on the axis
  Fit fit = Fit::two_points;
  bool inward_only = false;  // never move the boundary outside the previous one
  bool damped = true;  // shorten the moves once they stop shrinking; false is the paper's full move
  double tolerance = 1e-3;  // on the largest move of the boundary, relative to its size
  int most_iterations = 60;
  std::size_t most_bytes = std::size_t{1} << 30;  // of the dense matrix; a larger one is refused
};

// A candidate region and its mesh: the columns' edges (m + 1) and half widths (m) [m].
struct ColumnMesh {
  Eigen::VectorXd x_edges;
  Eigen::VectorXd half_width;
};

// One iteration: the mesh, what was found on it, and where that puts the boundary.
struct CountactStep {
  ColumnMesh mesh;
  Eigen::MatrixXd p;         // pressures [Pa]: cells from the axis outward x columns (all of them)
  Eigen::VectorXd new_half;  // new half width on the old columns [m], 0 where the column is dropped
  double new_x_min = 0, new_x_max = 0;
  double force = 0, moment_y = 0, p_max = 0;
  double move = 0;  // largest move of the boundary asked for, relative to its size
  // Where too few cells show the pressure fall outward, so that the boundary was not located.
  std::vector<int> stuck_columns;
  bool stuck_left = false, stuck_right = false;
};

struct CountactResult {
  NormalContact
      contact;  // `reason` tells of divergence, collapse, or a region that is not the contact
  std::vector<CountactStep> history;
};

// Solves the normal contact at approach delta [m] (<= 0: empty, without history) for a gap that is
// symmetric about the x axis (COUNTACT-1) or about both axes (COUNTACT-2; its columns must be
// symmetric too); only that half or quarter is solved. effective_modulus E* [Pa]. The first region
// is the interpenetration curve. Throws InputError on bad input, a gap without the symmetry, or a
// matrix larger than most_bytes; every failure of the iteration is in the result. F and p_max are
// second order in the cell size, the boundary first order; no error estimate of its own (NaN).
[[nodiscard]] CountactResult countact_1(const Gap& gap, double approach, double effective_modulus,
                                        const CountactOptions& options = {});
[[nodiscard]] CountactResult countact_2(const Gap& gap, double approach, double effective_modulus,
                                        const CountactOptions& options = {});

// The matrix b_ij [m] of eq. (14) on a mesh, folded over its symmetry: unknowns are numbered from
// the axis outward in each column, columns from left to right (both_axes: from the axis to the
// right).
Eigen::MatrixXd countact_matrix(const ColumnMesh& mesh, int rows, bool both_axes);

}  // namespace railbook::contact_chapter
