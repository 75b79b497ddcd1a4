#include "method/countact.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <railbook/contact/geometry.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "method/parts.hpp"

namespace railbook::contact_chapter {

using namespace contact;

namespace {

using namespace detail;

struct Problem {
  const Gap& gap;
  double approach = 0;
  double k = 0;  // 1/(pi E*), eq. (9)
  const CountactOptions& options;
  bool both_axes = false;
  CellNumbers cells;
};

double right_end(const Problem& q) {
  return interpenetration_distance(q.gap, q.approach, 0);
}

double left_end(const Problem& q) {
  return q.both_axes ? -right_end(q) : -interpenetration_distance(q.gap, q.approach, units::pi);
}

ColumnMesh first_mesh(const Problem& q) {
  ColumnMesh mesh{place_columns(q.options.columns, left_end(q), right_end(q)),
                  Eigen::VectorXd(q.cells.columns)};
  for (int j = 0; j < q.cells.columns; ++j)
    mesh.half_width[j] = interpenetration_half_width(q.gap, q.approach, column_centre(mesh, j));
  return mesh;
}

// Half of the gap is never asked, so that an unsymmetric one would give a number that means
// nothing.
void require_symmetry(const Problem& q, const ColumnMesh& mesh) {
  const auto same = [&](double f, double mirrored, const char* axis) {
    if (std::abs(f - mirrored) > 1e-6 * q.approach)
      throw InputError{std::string{"the gap is not symmetric about the "} + axis +
                       " axis, which this solver relies on"};
  };
  for (Eigen::Index j = 0; j < mesh.half_width.size(); ++j)
    for (const double share : {0.3, 0.7}) {
      const double x = column_centre(mesh, j), y = share * mesh.half_width[j], f = q.gap(x, y);
      same(f, q.gap(x, -y), "x");
      if (q.both_axes) same(f, q.gap(-x, y), "y");
    }
}

// Eqs (14) to (16): fills the pressures, the load and the moment of a step from its mesh.
void solve_pressures(const Problem& q, CountactStep& step) {
  const ColumnMesh& mesh = step.mesh;
  const CellNumbers& cells = q.cells;
  Eigen::VectorXd d(cells.size());
  Eigen::Index i = 0;
  for (int j = cells.first_column; j < cells.columns; ++j)
    for (int k = 0; k < cells.half_rows; ++k) {
      const double f = q.gap(column_centre(mesh, j), cell_centre(mesh, cells, j, k));
      if (!std::isfinite(f)) throw InputError{"gap is not finite inside the contact region"};
      d[i++] = (q.approach - f) / q.k;
    }
  Eigen::MatrixXd b = influence_matrix(mesh, cells);
  const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> lu(b);  // in place
  const Eigen::VectorXd unknowns = lu.solve(d);

  step.p.resize(cells.half_rows, cells.columns);
  for (int j = 0; j < cells.columns; ++j) {
    step.p.col(j) = unknowns.segment(cells.first_of(cells.fold_column(j)), cells.half_rows);
    double line = 2 * step.p.col(j).sum();
    if (cells.rows % 2 == 1) line -= step.p(0, j);
    const double width = mesh.x_edges[j + 1] - mesh.x_edges[j];
    const double load = line * width * cell_height(mesh, cells, j);
    step.force += load;
    if (!q.both_axes) step.moment_y += load * column_centre(mesh, j);
  }
  step.p_max = step.p.maxCoeff();
}

// A region must not leave the bodies: beyond a sharp edge the gap is infinite.
void keep_on_the_bodies(const Problem& q, ColumnMesh& mesh) {
  const auto m = mesh.half_width.size();
  double left = mesh.x_edges[0], right = mesh.x_edges[m];
  if (!std::isfinite(q.gap(right, 0))) right = std::min(right, right_end(q));
  if (!std::isfinite(q.gap(left, 0))) left = std::max(left, left_end(q));
  if (left != mesh.x_edges[0] || right != mesh.x_edges[m])
    mesh.x_edges = place_columns(q.options.columns, left, right);
  for (Eigen::Index j = 0; j < m; ++j) {
    const double x = column_centre(mesh, j);
    double& half = mesh.half_width[j];
    if (!std::isfinite(q.gap(x, half)))
      half = std::min(half, interpenetration_half_width(q.gap, q.approach, x));
  }
}

// The deepest overlap just outside the region, as a share of the approach: inequality (4) asks for
// none.
double deepest_outside(const Problem& q, const CountactStep& step) {
  const ColumnMesh& mesh = step.mesh;
  const CellNumbers& cells = q.cells;
  Eigen::VectorXd unknowns(cells.size()), row(cells.size());
  for (int u = 0; u < cells.unknown_columns; ++u)
    unknowns.segment(cells.first_of(u), cells.half_rows) = step.p.col(cells.first_column + u);
  double deepest = 0;
  const auto look = [&](double x, double y) {
    const double f = q.gap(x, y);
    if (!std::isfinite(f)) return;
    influence_row(mesh, cells, x, y, row);
    deepest = std::max(deepest, (q.approach - f - q.k * row.dot(unknowns)) / q.approach);
  };
  for (int j = cells.first_column; j < cells.columns; ++j)
    look(column_centre(mesh, j), mesh.half_width[j] + cell_height(mesh, cells, j) / 2);
  const auto m = mesh.half_width.size();
  look(1.5 * mesh.x_edges[m] - 0.5 * mesh.x_edges[m - 1], 0);
  if (!q.both_axes) look(1.5 * mesh.x_edges[0] - 0.5 * mesh.x_edges[1], 0);
  return deepest;
}

// Whether the pressure rises towards a boundary beyond which the bodies go on, and the same at a
// sharp edge.
struct Stuck {
  bool unresolved = false;
  bool sharp = false;
};

Stuck stuck(const Problem& q, const CountactStep& step) {
  Stuck s;
  constexpr double beyond = 1 + 1e-9;
  const auto look = [&](double x, double y) {
    (std::isfinite(q.gap(x * beyond, y * beyond)) ? s.unresolved : s.sharp) = true;
  };
  if (step.stuck_right) look(step.mesh.x_edges[step.mesh.x_edges.size() - 1], 0);
  if (step.stuck_left && !q.both_axes) look(step.mesh.x_edges[0], 0);
  for (int j : step.stuck_columns) look(column_centre(step.mesh, j), step.mesh.half_width[j]);
  return s;
}

// A boundary that rests may still be the wrong one; says so.
void judge(const Problem& q, const CountactStep& step, NormalContact& c) {
  const Stuck s = stuck(q, step);
  const double deepest = deepest_outside(q, step);
  if (s.unresolved)
    c.reason =
        "collapsed: along a part of the boundary too few cells lie between the peak and the edge "
        "to find where the pressure is zero";
  else if (deepest > 0.05)
    c.reason = "the bodies still overlap by " + std::to_string(deepest) +
               " of the approach outside the region: too few columns or rows";
  c.converged = c.reason.empty();
  if (c.converged && s.sharp) c.reason = "sharp edge: the pressure there is singular";
}

void list_cells(const CellNumbers& cells, const CountactStep& step, NormalContact& c) {
  for (auto* v : {&c.x, &c.y, &c.dx, &c.dy, &c.p})
    v->resize(Eigen::Index{cells.columns} * cells.rows);
  Eigen::Index at = 0;
  for (int j = 0; j < cells.columns; ++j)
    for (int e = 0; e < cells.rows; ++e) {
      const double p = step.p(cells.fold_row(e), j), height = cell_height(step.mesh, cells, j);
      if (!(p > 0)) continue;
      c.x[at] = column_centre(step.mesh, j);
      c.y[at] = (e + 0.5 - cells.rows / 2.0) * height;
      c.dx[at] = step.mesh.x_edges[j + 1] - step.mesh.x_edges[j];
      c.dy[at] = height;
      c.p[at++] = p;
    }
  for (auto* v : {&c.x, &c.y, &c.dx, &c.dy, &c.p}) v->conservativeResize(at);
  if (at == 0) return;
  c.p_max = c.p.maxCoeff(&at);
  c.x_p_max = c.x[at];
  c.y_p_max = std::abs(c.y[at]);
}

void describe(const Problem& q, const std::vector<CountactStep>& history, NormalContact& c) {
  const CountactStep& step = history.back();
  const auto m = step.mesh.half_width.size();
  c.approach = q.approach;
  c.force = step.force;
  c.moment_y = step.moment_y;
  c.x_min = step.mesh.x_edges[0];
  c.x_max = step.mesh.x_edges[m];
  c.y_max = step.mesh.half_width.maxCoeff();
  c.y_min = -c.y_max;
  c.area = 2 * step.mesh.half_width.dot(step.mesh.x_edges.tail(m) - step.mesh.x_edges.head(m));
  c.force_error = c.p_max_error = std::numeric_limits<double>::quiet_NaN();
  c.iterations = static_cast<int>(history.size());
  c.work = long{c.iterations} * q.cells.size() * q.cells.size();
  list_cells(q.cells, step, c);
}

// How much of each move is made: all of it, and less once the boundary swings without coming to
// rest.
class Damping {
 public:
  double share() const { return share_; }
  void note(const CountactStep& step) {
    const Eigen::VectorXd moves = step.new_half - step.mesh.half_width;
    const bool swings = moves_before_.size() > 0 && moves.dot(moves_before_) < 0;
    if (swings && step.move > 0.5 * move_before_) share_ = std::max(0.3, 0.7 * share_);
    move_before_ = step.move;
    moves_before_ = moves;
  }

 private:
  double share_ = 1, move_before_ = 0;
  Eigen::VectorXd moves_before_;
};

// Why the iteration cannot go on; empty when it can.
std::string reason_to_stop(const Problem& q, const CountactStep& step, const ColumnMesh& first,
                           const ColumnMesh& next, std::size_t steps) {
  const auto grew = [](const Eigen::VectorXd& now, const Eigen::VectorXd& then) {
    return now.cwiseAbs().maxCoeff() > 10 * then.cwiseAbs().maxCoeff();
  };
  if (grew(next.x_edges, first.x_edges) || grew(next.half_width, first.half_width))
    return "diverged: the region grows far outside the interpenetration curve";
  if (step.move >= q.options.tolerance && static_cast<int>(steps) >= q.options.most_iterations)
    return "the boundary still moves by " + std::to_string(step.move) + " of its size";
  return "";
}

// The loop: pressures on the mesh, the boundary where they vanish, a new mesh; until the boundary
// rests.
std::string iterate(const Problem& q, std::vector<CountactStep>& history) {
  ColumnMesh mesh = first_mesh(q);
  const ColumnMesh first = mesh;
  Damping damping;
  while (true) {
    CountactStep& step = history.emplace_back();
    step.mesh = std::move(mesh);
    solve_pressures(q, step);
    Update update = update_boundary(step, q.cells, q.options, damping.share());
    if (!update.reason.empty()) return update.reason;
    mesh = std::move(update.mesh);
    keep_on_the_bodies(q, mesh);
    std::string reason = reason_to_stop(q, step, first, mesh, history.size());
    if (!reason.empty() || step.move < q.options.tolerance) return reason;
    if (q.options.damped) damping.note(step);
  }
}

CountactResult solve(const Gap& gap, double approach, double modulus, const CountactOptions& o,
                     bool both_axes) {
  const Problem q{gap,
                  units::require_finite("approach", approach, "m"),
                  1 / (units::pi * units::require_positive("effective modulus", modulus, "Pa")),
                  o,
                  both_axes,
                  number_cells(o, both_axes)};
  CountactResult result;
  NormalContact& c = result.contact;
  c = empty_contact(approach);
  if (approach <= 0) return result;
  const ColumnMesh mesh = first_mesh(q);
  require_symmetry(q, mesh);
  if (!(mesh.half_width.minCoeff() > 0)) {
    c.converged = false;
    c.reason =
        "the bodies overlap in several pieces along the axis, and a column lies between them";
    return result;
  }
  c.reason = iterate(q, result.history);
  c.converged = c.reason.empty();
  describe(q, result.history, c);
  if (c.converged) judge(q, result.history.back(), c);
  return result;
}

}  // namespace

CountactResult countact_1(const Gap& gap, double approach, double modulus,
                          const CountactOptions& options) {
  return solve(gap, approach, modulus, options, false);
}

CountactResult countact_2(const Gap& gap, double approach, double modulus,
                          const CountactOptions& options) {
  return solve(gap, approach, modulus, options, true);
}

}  // namespace railbook::contact_chapter
