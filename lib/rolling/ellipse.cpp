#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/parts.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::rolling {

using Eigen::Index;

namespace {

// Adds to the rigid slip `w` what turns the slip of each sliding cell of `first` into the mean with
// that of the cell behind it: the part across the traction, since only that part turns it. A cell
// that has just begun to slide has no direction of its own yet, so that the turn fades with its
// slip; without that the forces would jump with every cell that changes state.
void turn_sliding(const RollingGrid& grid, const StickSlip& first, Eigen::VectorXd& w) {
  const Index n = grid.mesh.cells();
  const Eigen::VectorXd& s = first.slip;
  for (Index k = 1; k < n; ++k) {
    if (k % grid.mesh.along == 0 || grid.bound[k - 1] <= 0 ||
        !first.slides[static_cast<std::size_t>(k)])
      continue;
    const double x = -first.p[k + n] / grid.bound[k], y = first.p[k] / grid.bound[k];
    const double turn = (x * (s[k - 1] - s[k]) + y * (s[k + n - 1] - s[k + n])) / 2;
    const double own = std::hypot(s[k], s[k + n]), size = std::hypot(own, 2 * turn);
    if (size == 0) continue;
    const double part = (own / size) * (own / size) * turn;
    w[k] += part * x;
    w[k + n] += part * y;
  }
}

// `s` of the cells of `old`, on those of `grid`.
StickSlip carried(const StickSlip& s, const RollingGrid& old, double unit,
                  const RollingGrid& grid) {
  const RollingMesh &from = old.mesh, &to = grid.mesh;
  const Index n = to.cells(), m = from.cells();
  StickSlip start;
  start.p.setZero(2 * n);
  start.slides.assign(static_cast<std::size_t>(n), false);
  for (Index j = 0; j < to.rows(); ++j) {
    const double across = (to.y[j] / unit - from.y[0]) / from.dy[0];
    const auto below = static_cast<Index>(std::floor(across));
    for (Index i = 0; i < to.along; ++i) {
      const Index k = j * to.along + i;
      if (grid.bound[k] <= 0) continue;
      double sum = 0, slides = 0, x = 0, y = 0;
      for (const Index row : {below, below + 1}) {
        if (row < 0 || row >= from.rows()) continue;
        const double along = (to.x(j, i) / unit - from.x0[row]) / from.dx[row];
        const auto behind = static_cast<Index>(std::floor(along));
        for (const Index column : {behind, behind + 1}) {
          const Index c = row * from.along + column;
          if (column < 0 || column >= from.along || old.bound[c] <= 0) continue;
          const double weight = (1 - std::abs(across - static_cast<double>(row))) *
                                (1 - std::abs(along - static_cast<double>(column)));
          sum += weight;
          x += weight * s.p[c] / old.bound[c], y += weight * s.p[c + m] / old.bound[c];
          if (s.slides[static_cast<std::size_t>(c)]) slides += weight;
        }
      }
      if (!(sum > 0)) continue;
      start.p[k] = grid.bound[k] * x / sum, start.p[k + n] = grid.bound[k] * y / sum;
      start.slides[static_cast<std::size_t>(k)] = slides > 0.5 * sum;
    }
  }
  return start;
}

}  // namespace

StickSlipPair carried(const StickSlipPair& from, const RollingGrid& old, double unit,
                      const RollingGrid& grid) {
  return {carried(from.first, old, unit, grid), carried(from.second, old, unit, grid)};
}

StickSlipPair solve_pair(const TangentialInfluence& influence, const RollingGrid& grid,
                         const Creepage& reduced, const RollingOptions& options,
                         const StickSlipPair* start, const Eigen::VectorXd* driven) {
  Eigen::VectorXd w = rigid_slip(grid.mesh, reduced);
  if (driven) w += *driven;
  SlidingRows own;
  StickSlipOptions solver = options.solver;
  if (!solver.kept) solver.kept = &own;
  const auto solve = [&](const StickSlip* from) {
    return solve_stick_slip(influence, grid.mesh, grid.bound, w, solver, from);
  };
  StickSlipPair found;
  found.first = solve(start ? &start->first : nullptr);
  if (!found.first.converged || !options.remedy) {
    found.second = found.first;
    return found;
  }
  turn_sliding(grid, found.first, w);
  // What the turn changed before it will change again.
  StickSlip turned = found.first;
  if (start) turned.p += start->second.p - start->first.p;
  found.second = solve(&turned);
  found.second.newton += found.first.newton;
  found.second.products += found.first.products;
  return found;
}

Resultants resultants(const RollingMesh& mesh, const Eigen::VectorXd& p) {
  Resultants r;
  const Index n = mesh.cells();
  for (Index j = 0; j < mesh.rows(); ++j)
    for (Index i = 0; i < mesh.along; ++i) {
      const Index k = j * mesh.along + i;
      const double cell = mesh.dx[j] * mesh.dy[j];
      r.fx += cell * p[k];
      r.fy += cell * p[k + n];
      r.mz += cell * (mesh.x(j, i) * p[k + n] - mesh.y[j] * p[k]);
    }
  return r;
}

CreepForces in_units(const RollingGrid& grid, const StickSlip& s, double force, double length) {
  CreepForces out;
  const RollingMesh& mesh = grid.mesh;
  const Resultants r = resultants(mesh, s.p);
  out.fx = force * r.fx;
  out.fy = force * r.fy;
  out.mz = force * length * r.mz;
  out.iterations = s.newton;
  out.products = s.products;
  out.converged = s.converged;
  if (!s.converged) out.reason = "the stick and slip areas did not settle";
  const double pressure = force / (length * length);
  const Index n = mesh.cells(), inside = (grid.bound.array() > 0).count();
  Tractions& t = out.tractions;
  for (Eigen::VectorXd* v : {&t.x, &t.y, &t.dx, &t.dy, &t.px, &t.py, &t.bound, &t.stick})
    v->resize(inside);
  double area = 0, stick = 0;
  for (Index k = 0, m = 0; k < n; ++k) {
    if (grid.bound[k] <= 0) continue;
    const Index j = k / mesh.along;
    t.x[m] = length * mesh.x(j, k % mesh.along), t.y[m] = length * mesh.y[j];
    t.dx[m] = length * mesh.dx[j], t.dy[m] = length * mesh.dy[j];
    t.px[m] = pressure * s.p[k], t.py[m] = pressure * s.p[k + n];
    t.bound[m] = pressure * grid.bound[k];
    t.stick[m] = s.slides[static_cast<std::size_t>(k)] ? 0 : 1;
    area += mesh.dx[j] * mesh.dy[j], stick += t.stick[m] * mesh.dx[j] * mesh.dy[j];
    ++m;
  }
  out.stick_share = area > 0 ? stick / area : 1;
  return out;
}

namespace {

// Root of the mean square distance from the origin, by the pressure.
double mean_arm(const RollingGrid& grid) {
  const RollingMesh& mesh = grid.mesh;
  double sum = 0;
  for (Index j = 0; j < mesh.rows(); ++j)
    for (Index i = 0; i < mesh.along; ++i) {
      const double x = mesh.x(j, i), y = mesh.y[j];
      sum += mesh.dx[j] * mesh.dy[j] * grid.bound[j * mesh.along + i] * (x * x + y * y);
    }
  return std::sqrt(sum);
}

}  // namespace

void estimate(CreepForces& fine, const RollingGrid& grid, const Resultants& coarse, double force,
              double length) {
  // Any one difference may vanish by chance, all three together hardly; a moment over the root mean
  // square of the distance from the origin is a force.
  const double arm = mean_arm(grid);
  fine.error = 2 * std::hypot(fine.fx / force - coarse.fx, fine.fy / force - coarse.fy,
                              (fine.mz / (force * length) - coarse.mz) / arm);
  fine.mz_error = arm * fine.error;
}

namespace {

// The same on rows that end on the ellipse. If the coarser grid has cells of just twice the size
// (`halved`), the second-order error is taken off the forces, which stay within mu N, first.
void extrapolate(CreepForces& fine, const RollingGrid& grid, const Resultants& coarse, bool halved,
                 double force, double length) {
  // Second order: a grid of twice the cell size is off by four times as much.
  const double dx = fine.fx / force - coarse.fx, dy = fine.fy / force - coarse.fy;
  const double dm = fine.mz / (force * length) - coarse.mz;
  if (halved) {
    fine.fx += dx / 3 * force;
    fine.fy += dy / 3 * force;
    fine.mz += dm / 3 * force * length;
  }
  const double beyond = std::hypot(fine.fx, fine.fy) / force;
  if (beyond > 1) fine.fx /= beyond, fine.fy /= beyond;
  // Of the differences about a half (where they have been taken off, hardly less: under large spin
  // the order is below two). The moment's is among the force's, since both seldom vanish at the
  // same creepages. And what differences do not see: slip begins at the rim in whole cells. One
  // more or less in a row is of the order h^1.5, at random from row to row, and nothing where all
  // sticks or all slides. The rim is root 5 times as far out as the mean arm. The factors are
  // chosen on random cases.
  const double part = halved ? 0.5 : 0.55, share = std::min(1.0, beyond);
  const double cells = 0.7 * std::pow(static_cast<double>(grid.mesh.along), -1.5) *
                       std::pow(static_cast<double>(grid.mesh.rows()), -0.5) *
                       std::sqrt(share * (1 - share));
  const double arm = mean_arm(grid), forces = std::hypot(dx, dy), moment = std::abs(dm) / arm;
  fine.error = part * (forces + 0.5 * moment) + cells;
  fine.mz_error = arm * (part * (moment + 0.5 * forces) + std::sqrt(5) * cells);
}

}  // namespace

CreepForces without_friction() {
  CreepForces out;
  out.error = out.mz_error = 0;
  out.stick_share = 0;
  out.converged = true;
  out.reason = "no friction: no tangential forces";
  return out;
}

namespace {

struct Level {
  RollingGrid grid;
  TangentialInfluence influence;
  Level(double ratio, double poisson, const RollingOptions& o, Index coarser, bool stepped)
      : grid(ellipse_grid(ratio, (o.along + coarser - 1) / coarser,
                          (o.rows + coarser - 1) / coarser, o.remedy, stepped)),
        influence(grid.mesh, poisson, !stepped) {}
};

// Rows fitted to the ellipse come nearer with as many cells, but need a matrix: from here on it is
// much slower than transforms, and soon too large.
constexpr Index most_dense = 1024;

bool is_stepped(const RollingOptions& o) {
  return o.along * o.rows > most_dense && o.along >= 16;
}

// Bytes: products between rows, their factors, and vectors of GMRES; or the matrix of all cells.
double memory_of(const RollingOptions& o) {
  const double n = static_cast<double>(o.along), rows = static_cast<double>(o.rows);
  const double cells = n * rows;
  return is_stepped(o) ? 36 * n * rows * rows + 24 * n * cells + 1600 * cells
                       : 12 * cells * cells * (o.estimate ? 17.0 / 16 : 1);
}

}  // namespace

struct EllipseRolling::Parts {
  double ratio = 0, poisson = 0;
  RollingOptions options;
  std::vector<Level> levels;  // finest last
};

EllipseRolling::EllipseRolling(double axis_ratio, double poisson, const RollingOptions& options)
    : parts_(std::make_unique<Parts>()) {
  units::require_positive("axis ratio a/b", axis_ratio);
  units::require_between("Poisson's ratio", poisson, 0, 0.5);
  units::require_between("cells along rolling", static_cast<double>(options.along), 1, 4096);
  units::require_between("rows across", static_cast<double>(options.rows), 1, 4096);
  units::require_between("memory for the cells", memory_of(options), 0, 2.2e9, "bytes");
  *parts_ = {axis_ratio, poisson, options, {}};
  const bool stepped = is_stepped(options);
  Index coarsest = options.estimate && options.along > 1 ? 2 : 1;
  while (stepped && coarsest > 1 && options.along / coarsest > 32) coarsest *= 2;
  for (; coarsest >= 1; coarsest /= 2)
    parts_->levels.emplace_back(axis_ratio, poisson, options, coarsest, stepped);
}
EllipseRolling::~EllipseRolling() = default;
EllipseRolling::EllipseRolling(EllipseRolling&&) noexcept = default;

CreepForces EllipseRolling::solve(const RollingCase& c) const {
  const Creepage reduced = reduced_creepage(c);
  const double length = std::sqrt(c.a * c.b), force = c.friction * c.load;
  if (std::abs(c.a / c.b - parts_->ratio) > 1e-9 * parts_->ratio)
    throw InputError{"the axis ratio of the case is not that of the contact it is solved on"};
  if (c.poisson != parts_->poisson)
    throw InputError{"Poisson's ratio of the case is not that of the contact it is solved on"};
  if (c.friction == 0) return without_friction();
  const Level* before = nullptr;
  Resultants coarse;
  StickSlipPair found;
  for (const Level& level : parts_->levels) {
    const auto solved = [&](const StickSlipPair* start) {
      return solve_pair(level.influence, level.grid, reduced, parts_->options, start);
    };
    if (before && found.second.converged) {
      coarse = resultants(before->grid.mesh, found.second.p);
      const StickSlipPair start = carried(found, before->grid, 1, level.grid);
      found = solved(&start);
      if (!found.second.converged) found = solved(nullptr);
    } else {
      before = nullptr;
      found = solved(nullptr);
    }
    if (&level != &parts_->levels.back()) before = &level;
  }
  const RollingGrid& grid = parts_->levels.back().grid;
  CreepForces out = in_units(grid, found.second, force, length);
  const RollingOptions& o = parts_->options;
  const bool halved = o.remedy && o.along >= 16 && o.along % 2 == 0 && o.rows % 2 == 0;
  if (before) extrapolate(out, grid, coarse, halved, force, length);
  return out;
}

CreepForces solve_rolling(const RollingCase& c, const RollingOptions& options) {
  check(c);
  if (c.friction == 0) return without_friction();
  return EllipseRolling(c.a / c.b, c.poisson, options).solve(c);
}

}  // namespace railbook::rolling
