#include <algorithm>
#include <cmath>
#include <utility>

#include "num/dense_lu.hpp"
#include "rolling/rolling_contact.hpp"
#include "rolling/rolling_parts.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::rolling {
namespace {

using Eigen::Index;

// Integral of sqrt(1 - s^2) from -1 to s.
double half_disc(double s) {
  s = std::clamp(s, -1.0, 1.0);
  return 0.5 * (s * std::sqrt((1 - s) * (1 + s)) + std::asin(s)) + units::pi / 4;
}

}  // namespace

namespace {

// Puts the cells of row j on its half length; `share` of the load is spread along it like sqrt(1 - s^2).
void place_row(RollingGrid& grid, Index j, double half_length, double share, bool remedy) {
  RollingMesh& mesh = grid.mesh;
  const double offset = remedy ? edge_offset() : 0, first = remedy ? 0.25 + offset : 0.5;
  mesh.dx[j] = 2 * half_length / (static_cast<double>(mesh.along) + 2 * offset);
  mesh.x0[j] = -half_length + first * mesh.dx[j];
  const double h = mesh.dx[j] / (2 * half_length);
  for (Index i = 0; i < mesh.along; ++i) {
    const double s = mesh.x(j, i) / half_length;
    const double from = i > 0 ? half_disc(s - h) : 0;
    const double to = i + 1 < mesh.along ? half_disc(s + h) : units::pi / 2;
    grid.bound[j * mesh.along + i] =
        share * (to - from) / (units::pi / 2) / (mesh.dx[j] * mesh.dy[j]);
  }
}

RollingGrid empty_grid(Index along, Index rows) {
  RollingGrid grid;
  grid.mesh.along = along;
  for (Eigen::VectorXd* v : {&grid.mesh.y, &grid.mesh.dy, &grid.mesh.x0, &grid.mesh.dx})
    v->resize(rows);
  grid.bound.resize(along * rows);
  return grid;
}

}  // namespace

RollingGrid ellipse_grid(double axis_ratio, Index along, Index rows, bool remedy) {
  const double a = std::sqrt(axis_ratio), b = 1 / a;
  RollingGrid grid = empty_grid(along, rows);
  const double height = 2 / static_cast<double>(rows);
  for (Index j = 0; j < rows; ++j) {
    const double low = -1 + height * static_cast<double>(j), high = low + height;
    // The mean of the squared half length: every row keeps its exact share of the load.
    const double strip = height - (high * high * high - low * low * low) / 3;
    grid.mesh.y[j] = b * (low + high) / 2;
    grid.mesh.dy[j] = b * height;
    place_row(grid, j, a * std::sqrt(strip / height), 0.75 * strip, remedy);
  }
  return grid;
}

RollingGrid strip_grid(Index along, double width, bool remedy) {
  RollingGrid grid = empty_grid(along, 1);
  grid.mesh.y[0] = 0;
  grid.mesh.dy[0] = width;
  place_row(grid, 0, 1, width, remedy);
  return grid;
}

Eigen::VectorXd rigid_slip(const RollingMesh& mesh, const Creepage& c) {
  const Index n = mesh.cells();
  Eigen::VectorXd w(2 * n);
  for (Index j = 0; j < mesh.rows(); ++j)
    for (Index i = 0; i < mesh.along; ++i) {
      const Index k = j * mesh.along + i;
      w[k] = c.longitudinal - c.spin * mesh.y[j];
      w[k + n] = c.lateral + c.spin * (mesh.x(j, i) + mesh.dx[j] / 2);
    }
  return w;
}

namespace {

// Adds to the rigid slip `w` what turns the slip of each sliding cell of `first` into the mean with that of the cell
// behind it: the part across the traction, since only that part turns it. A cell that has just begun to slide has no
// direction of its own yet, so that the turn fades with its slip; without that the forces would jump with every cell
// that changes state.
void turn_sliding(const RollingGrid& grid, const StickSlip& first, Eigen::VectorXd& w) {
  const Index n = grid.mesh.cells();
  const Eigen::VectorXd& s = first.slip;
  for (Index k = 1; k < n; ++k) {
    if (k % grid.mesh.along == 0 || !first.slides[static_cast<std::size_t>(k)]) continue;
    const double x = -first.p[k + n] / grid.bound[k], y = first.p[k] / grid.bound[k];
    const double turn = (x * (s[k - 1] - s[k]) + y * (s[k + n - 1] - s[k + n])) / 2;
    const double own = std::hypot(s[k], s[k + n]), size = std::hypot(own, 2 * turn);
    if (size == 0) continue;
    const double part = (own / size) * (own / size) * turn;
    w[k] += part * x;
    w[k + n] += part * y;
  }
}

}  // namespace

StickSlip solve_on(const TangentialInfluence& influence, const RollingGrid& grid,
                   const Creepage& reduced, const RollingOptions& options, const StickSlip* start) {
  Eigen::VectorXd w = rigid_slip(grid.mesh, reduced);
  StickSlip first = solve_stick_slip(influence, grid.mesh, grid.bound, w, options.solver, start);
  if (!first.converged || !options.remedy) return first;
  turn_sliding(grid, first, w);
  StickSlip second = solve_stick_slip(influence, grid.mesh, grid.bound, w, options.solver, &first);
  second.newton += first.newton;
  second.products += first.products;
  return second;
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

void extrapolate(CreepForces& fine, const RollingGrid& grid, const Resultants& coarse, bool halved,
                 double force, double length) {
  // Second order: a grid of twice the cell size is off by four times as much.
  const double part = halved ? 1.0 / 3 : 0;
  const double dx = fine.fx / force - coarse.fx, dy = fine.fy / force - coarse.fy;
  const double dm = fine.mz / (force * length) - coarse.mz;
  fine.fx += part * dx * force;
  fine.fy += part * dy * force;
  fine.mz += part * dm * force * length;
  // Any one difference may vanish by chance, all three together hardly; a moment over the root mean square of the
  // distance from the origin is a force.
  const double arm = mean_arm(grid);
  fine.error = (halved ? 0.8 : 1.25) * std::hypot(dx, dy, dm / arm);
  fine.mz_error = arm * fine.error;
  const double beyond = std::hypot(fine.fx, fine.fy) / force;
  if (beyond > 1) fine.fx /= beyond, fine.fy /= beyond;
}

CreepForces without_friction() {
  CreepForces out;
  out.error = out.mz_error = 0;
  out.stick_share = 0;
  out.converged = true;
  out.reason = "no friction: no tangential forces";
  return out;
}

namespace {

StickSlip refined(const StickSlip& coarse, const RollingGrid& from, const RollingGrid& to) {
  StickSlip start;
  const Index n = to.mesh.cells(), m = from.mesh.cells();
  start.p.resize(2 * n);
  start.slides.resize(static_cast<std::size_t>(n));
  for (Index j = 0; j < to.mesh.rows(); ++j)
    for (Index i = 0; i < to.mesh.along; ++i) {
      const Index k = j * to.mesh.along + i;
      const Index row = (2 * j + 1) * from.mesh.rows() / (2 * to.mesh.rows());
      const Index old = row * from.mesh.along + (2 * i + 1) * from.mesh.along / (2 * to.mesh.along);
      const double ratio = to.bound[k] / from.bound[old];
      start.p[k] = ratio * coarse.p[old];
      start.p[k + n] = ratio * coarse.p[old + m];
      start.slides[static_cast<std::size_t>(k)] = coarse.slides[static_cast<std::size_t>(old)];
    }
  return start;
}

struct Level {
  RollingGrid grid;
  TangentialInfluence influence;
  Level(double ratio, double poisson, Index along, Index rows, bool remedy)
      : grid(ellipse_grid(ratio, along, rows, remedy)), influence(grid.mesh, poisson, true) {}
  StickSlip solve(const Creepage& c, const RollingOptions& options, const StickSlip* start) const {
    return solve_on(influence, grid, c, options, start);
  }
};

}  // namespace

struct EllipseRolling::Parts {
  double ratio = 0, poisson = 0;
  RollingOptions options;
  std::unique_ptr<Level> coarse, fine;
};

EllipseRolling::EllipseRolling(double axis_ratio, double poisson, const RollingOptions& options)
    : parts_(std::make_unique<Parts>()) {
  units::require_positive("axis ratio a/b", axis_ratio);
  units::require_between("Poisson's ratio", poisson, 0, 0.5);
  units::require_between("cells along rolling", static_cast<double>(options.along), 1, 4096);
  units::require_between("rows across", static_cast<double>(options.rows), 1, 4096);
  units::require_between("cells in all", static_cast<double>(options.along * options.rows), 1,
                         8192);
  *parts_ = {axis_ratio, poisson, options, nullptr, nullptr};
  parts_->fine =
      std::make_unique<Level>(axis_ratio, poisson, options.along, options.rows, options.remedy);
  if (options.estimate && options.along > 1)
    parts_->coarse = std::make_unique<Level>(axis_ratio, poisson, (options.along + 1) / 2,
                                             (options.rows + 1) / 2, options.remedy);
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
  StickSlip coarse;
  if (parts_->coarse) coarse = parts_->coarse->solve(reduced, parts_->options, nullptr);
  const bool started = parts_->coarse && coarse.converged;
  const StickSlip start =
      started ? refined(coarse, parts_->coarse->grid, parts_->fine->grid) : StickSlip{};
  StickSlip fine = parts_->fine->solve(reduced, parts_->options, started ? &start : nullptr);
  if (started && !fine.converged) fine = parts_->fine->solve(reduced, parts_->options, nullptr);
  CreepForces out = in_units(parts_->fine->grid, fine, force, length);
  const bool halved = parts_->options.remedy && parts_->options.along >= 16 &&
                      parts_->options.along % 2 == 0 && parts_->options.rows % 2 == 0;
  if (started)
    extrapolate(out, parts_->fine->grid, resultants(parts_->coarse->grid.mesh, coarse.p), halved,
                force, length);
  return out;
}

CreepForces solve_rolling(const RollingCase& c, const RollingOptions& options) {
  check(c);
  if (c.friction == 0) return without_friction();
  return EllipseRolling(c.a / c.b, c.poisson, options).solve(c);
}

}  // namespace railbook::rolling
