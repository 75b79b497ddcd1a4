#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <railbook/rolling/parts.hpp>
#include <railbook/rolling/unlike_materials.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
using Eigen::Index;

void check_given(const contact::Grid& grid, const Eigen::VectorXd& pressure, const RollingCase& c) {
  RollingCase checked = c;
  checked.a = checked.b = checked.load = 1;
  check(checked);
  if (pressure.size() != grid.nx * grid.ny || grid.nx < 1 || grid.ny < 1)
    throw InputError{"the pressure does not have one value for every cell of its grid"};
  if (!(pressure.array() >= 0).all() || !(pressure.array() < not_known).all())
    throw InputError{"pressures must be finite and not negative"};
}

Creepage Given::reduced(const RollingCase& c) const {
  const double slip = c.friction * load / (c.shear_modulus * length * length);
  return {c.creepage.longitudinal / slip, c.creepage.lateral / slip,
          c.creepage.spin * length / slip};
}

Given placed(const contact::Grid& cells, const Eigen::VectorXd& pressure, bool remedy) {
  Given g;
  const double area = cells.dx * cells.dy * static_cast<double>((pressure.array() > 0).count());
  g.load = pressure.sum() * cells.dx * cells.dy;
  units::require_positive("load (the sum of the pressures)", g.load, "N");
  g.length = std::sqrt(area / units::pi);
  const double shift = remedy ? 0.25 + edge_offset() : 0;
  RollingMesh& mesh = g.grid.mesh;
  mesh.along = cells.nx;
  mesh.dx = Eigen::VectorXd::Constant(cells.ny, cells.dx / g.length);
  mesh.dy = Eigen::VectorXd::Constant(cells.ny, cells.dy / g.length);
  mesh.x0 = Eigen::VectorXd::Constant(cells.ny, (cells.x0 + (0.5 - shift) * cells.dx) / g.length);
  mesh.y.resize(cells.ny);
  g.grid.bound.resize(cells.nx * cells.ny);
  const double scale = g.length * g.length / g.load;
  for (Index j = 0; j < cells.ny; ++j) {
    mesh.y[j] = (cells.y0 + (static_cast<double>(j) + 0.5) * cells.dy) / g.length;
    const auto p = pressure.segment(j * cells.nx, cells.nx);
    for (Index i = 0; i < cells.nx; ++i) {
      const double behind = i > 0 ? p[i - 1] : 0;
      const bool leading = i + 1 == cells.nx || p[i + 1] == 0;
      g.grid.bound[j * cells.nx + i] =
          p[i] > 0 ? scale * (shift * behind + (leading ? 1 : 1 - shift) * p[i]) : 0;
    }
  }
  return g;
}

namespace {

// Two by two cells made one; an odd one out at the end is joined by an empty one.
void halve(contact::Grid& cells, Eigen::VectorXd& p) {
  const contact::Grid fine = cells;
  cells.nx = (fine.nx + 1) / 2, cells.ny = (fine.ny + 1) / 2;
  cells.dx *= 2, cells.dy *= 2;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(cells.nx * cells.ny);
  for (Index j = 0; j < fine.ny; ++j)
    for (Index i = 0; i < fine.nx; ++i) sum[(j / 2) * cells.nx + i / 2] += p[j * fine.nx + i] / 4;
  p = sum;
}

}  // namespace

struct RollingSeries::Parts {
  std::shared_ptr<const TangentialInfluence> influence;
  std::shared_ptr<SlidingRows> sliding;
  double poisson = 0;
  Given given;  // of the last solution
  StickSlipPair found;

  const StickSlip& solve(Given g, const RollingCase& c, RollingOptions options,
                         double dissimilarity);
};

// The influence on strains depends on the shape of the cells, not on their size.
const StickSlip& RollingSeries::Parts::solve(Given g, const RollingCase& c, RollingOptions options,
                                             double dissimilarity) {
  const RollingMesh &mesh = g.grid.mesh, &last = given.grid.mesh;
  const bool again = influence && poisson == c.poisson && mesh.along == last.along &&
                     mesh.rows() == last.rows() &&
                     std::abs(mesh.dx[0] * last.dy[0] / (mesh.dy[0] * last.dx[0]) - 1) < 1e-13;
  if (!again) {
    influence = std::make_shared<TangentialInfluence>(mesh, c.poisson, false);
    sliding = std::make_shared<SlidingRows>();
  }
  options.solver.kept = sliding.get();
  poisson = c.poisson;
  Eigen::VectorXd driven;
  if (dissimilarity != 0) driven = driven_slip(mesh, g.grid.bound / c.friction, dissimilarity);
  const auto solved = [&](const StickSlipPair* start) {
    return solve_pair(*influence, g.grid, g.reduced(c), options, start,
                      dissimilarity != 0 ? &driven : nullptr);
  };
  if (found.second.converged) {
    const StickSlipPair start = carried(found, given.grid, given.length / g.length, g.grid);
    found = solved(&start);
  }
  if (!found.second.converged) found = solved(nullptr);
  given = std::move(g);
  return found.second;
}

RollingSeries::RollingSeries() : parts_(std::make_unique<Parts>()) {}
RollingSeries::~RollingSeries() = default;
RollingSeries::RollingSeries(const RollingSeries& s) : parts_(std::make_unique<Parts>(*s.parts_)) {}
RollingSeries& RollingSeries::operator=(RollingSeries&&) noexcept = default;

CreepForces RollingSeries::solve(const contact::Grid& grid, const Eigen::VectorXd& pressure,
                                 const RollingCase& c, const RollingOptions& options,
                                 double dissimilarity) {
  check_given(grid, pressure, c);
  units::require_between("dissimilarity K", dissimilarity, -0.5, 0.5);
  const Given fine = placed(grid, pressure, options.remedy);
  if (c.friction == 0) return without_friction();
  const double force = c.friction * fine.load;
  const bool estimated = options.estimate && grid.nx >= 4;
  Given coarse;
  Resultants r;
  if (estimated) {
    contact::Grid half = grid;
    Eigen::VectorXd p = pressure;
    halve(half, p);
    coarse = placed(half, p, options.remedy);
    const StickSlip& rough = parts_->solve(coarse, c, options, dissimilarity);
    r = resultants(coarse.grid.mesh, rough.p);
    r.mz *= coarse.length / fine.length;
  }
  const bool known = estimated && parts_->found.second.converged;
  CreepForces out =
      in_units(fine.grid, parts_->solve(fine, c, options, dissimilarity), force, fine.length);
  if (known) estimate(out, fine.grid, r, force, fine.length);
  return out;
}

CreepForces solve_rolling_unlike(const contact::Grid& grid, const Eigen::VectorXd& pressure,
                                 const RollingCase& c, const RollingOptions& options,
                                 double dissimilarity) {
  return RollingSeries{}.solve(grid, pressure, c, options, dissimilarity);
}

CreepForces solve_rolling(const contact::Grid& grid, const Eigen::VectorXd& pressure,
                          const RollingCase& c, const RollingOptions& options) {
  return solve_rolling_unlike(grid, pressure, c, options, 0);
}

}  // namespace railbook::rolling
