#include <railbook/rolling/transient.hpp>

#include <cmath>
#include <functional>

#include <railbook/rolling/parts.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::rolling {

using Eigen::Index;
using Eigen::VectorXd;

struct Transient::Parts {
  RollingCase c;
  Given given;
  TangentialInfluence influence;
  StickSlip now;
  double motion = 0;  // that the last step was solved for

  Parts(const contact::Grid& cells, const VectorXd& pressure, const RollingCase& what)
      : c(what),
        given(placed(cells, pressure, false)),
        influence(given.grid.mesh, what.poisson, given.grid.mesh.cells() <= 400,
                  Response::displacement) {
    now.p = VectorXd::Zero(2 * given.grid.mesh.cells());
    now.slides.assign(static_cast<std::size_t>(given.grid.mesh.cells()), false);
  }
  double force() const { return c.friction * given.load; }

  // The tractions as the cells see them after rolling on by one: the contact moves towards +x, what
  // was at x + dx is at x.
  VectorXd passed_back() const {
    const Index n = given.grid.mesh.along, rows = given.grid.mesh.rows();
    VectorXd out = VectorXd::Zero(now.p.size());
    for (Index row = 0; row < 2 * rows; ++row)
      out.segment(row * n, n - 1) = now.p.segment(row * n + 1, n - 1);
    return out;
  }
  // Slip of the step: rigid slip, less the displacement of now, plus that of before.
  StickSlip step(const VectorXd& rigid, const VectorXd& before) const {
    VectorXd old;
    influence.apply(before, old);
    return solve_stick_slip(influence, given.grid.mesh, given.grid.bound, rigid + old,
                            {.tolerance = 1e-9}, &now);
  }
  StickSlip shifted(double x, double y) const {
    const Index n = given.grid.mesh.cells();
    const double unit = force() / (c.shear_modulus * given.length);
    VectorXd rigid(2 * n);
    rigid << VectorXd::Constant(n, x / unit), VectorXd::Constant(n, y / unit);
    return step(rigid, now.p);
  }
  StickSlip rolled(const Creepage& creepage) const {
    RollingCase moving = c;
    moving.creepage = creepage;
    const RollingMesh& mesh = given.grid.mesh;
    return step(mesh.dx[0] * rigid_slip(mesh, given.reduced(moving)), passed_back());
  }
  CreepForces keep(StickSlip found) {
    CreepForces forces = in_units(given.grid, found, force(), given.length);
    if (found.converged) now = std::move(found);
    return forces;
  }

  // The motion at which a step has the force, by brackets from the last motion and then false
  // position.
  Step for_force(double fx, double scale, const std::function<StickSlip(double)>& solve) {
    units::require_between("force along over the friction's bound", fx / force(), -0.999, 0.999);
    StickSlip found;
    const auto off = [&](double m) {
      found = solve(m);
      return found.converged ? resultants(given.grid.mesh, found.p).fx - fx / force() : units::nan;
    };
    double low = motion, high = motion, f_low = off(low), f_high = f_low;
    for (double reach = scale; f_low > 0 && reach < 1e6 * scale; reach *= 2)
      high = low, f_high = f_low, f_low = off(low = motion - reach);
    for (double reach = scale; f_high < 0 && reach < 1e6 * scale; reach *= 2)
      low = high, f_low = f_high, f_high = off(high = motion + reach);
    double middle = motion, f = f_low;
    for (int k = 0; k < 60 && std::isfinite(f_low) && std::isfinite(f_high); ++k) {
      // Illinois: the value at an end that stays is halved.
      middle = f_high == f_low ? low : low - f_low * (high - low) / (f_high - f_low);
      const double last = f;
      f = off(middle);
      if (!(std::abs(f) > 1e-6)) break;
      if (f > 0) {
        high = middle, f_high = f;
        if (last > 0) f_low /= 2;
      } else {
        low = middle, f_low = f;
        if (last < 0) f_high /= 2;
      }
    }
    if (std::abs(f) <= 1e-6) return {keep(found), motion = middle};
    Step out{in_units(given.grid, found, force(), given.length), middle};
    out.forces.converged = false;
    out.forces.reason = "no motion was found that gives the force";
    return out;
  }
};

Transient::Transient(const contact::Grid& grid, const VectorXd& pressure, const RollingCase& c) {
  check_given(grid, pressure, c);
  units::require_positive("friction", c.friction, "");
  for (Index j = 0; j < grid.ny; ++j)
    if (pressure[j * grid.nx] > 0)
      throw InputError{
          "the first column of the grid has pressure; allowed: an empty one, into which the "
          "contact's tractions roll"};
  parts_ = std::make_unique<Parts>(grid, pressure, c);
}
Transient::~Transient() = default;

CreepForces Transient::shift(double x, double y) {
  return parts_->keep(parts_->shifted(x, y));
}
CreepForces Transient::roll(const Creepage& creepage) {
  return parts_->keep(parts_->rolled(creepage));
}
Transient::Step Transient::shift_for(double fx) {
  parts_->motion = 0;
  const double scale = parts_->force() / (parts_->c.shear_modulus * parts_->given.length);
  return parts_->for_force(fx, 0.2 * scale, [&](double x) { return parts_->shifted(x, 0); });
}
Transient::Step Transient::roll_for(double fx) {
  const double unit =
      parts_->force() / (parts_->c.shear_modulus * parts_->given.length * parts_->given.length);
  return parts_->for_force(fx, 0.05 * unit, [&](double xi) { return parts_->rolled({xi, 0, 0}); });
}

}  // namespace railbook::rolling
