#include <railbook/rolling/transient.hpp>

#include <cmath>
#include <functional>
#include <utility>

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
  double motion = 0;     // that the last step was solved for
  double dissimilarity;  // K
  VectorXd pressed;      // the bound during the last step
  contact::Grid cells;

  Parts(const contact::Grid& grid, const VectorXd& pressure, const RollingCase& what, double k)
      : c(what),
        given(placed(grid, pressure, false)),
        influence(given.grid.mesh, what.poisson, given.grid.mesh.cells() <= 400,
                  Response::displacement),
        dissimilarity(k),
        pressed(given.grid.bound),
        cells(grid) {
    now.p = VectorXd::Zero(2 * given.grid.mesh.cells());
    now.slides.assign(static_cast<std::size_t>(given.grid.mesh.cells()), false);
  }
  double force() const { return c.friction * given.load; }  // the unit, of the first pressure
  double bound() const {                                    // mu N of now
    return force() * given.grid.bound.sum() * given.grid.mesh.dx[0] * given.grid.mesh.dy[0];
  }

  // Values of cells as these see them after rolling on by one: the contact moves towards +x, what
  // was at x + dx is at x.
  VectorXd passed_back(const VectorXd& values) const {
    const Index n = given.grid.mesh.along;
    VectorXd out = VectorXd::Zero(values.size());
    for (Index row = 0; row < values.size() / n; ++row)
      out.segment(row * n, n - 1) = values.segment(row * n + 1, n - 1);
    return out;
  }
  // Slip of the step: rigid slip, less the displacement of now, plus that of before, with the
  // tractions and the bound of before where the cells are now.
  StickSlip step(VectorXd rigid, const VectorXd& before, const VectorXd& pressed_before) const {
    VectorXd old;
    influence.apply(before, old);
    rigid += old;
    if (dissimilarity != 0)
      rigid += driven_slip(given.grid.mesh, (given.grid.bound - pressed_before) / c.friction,
                           dissimilarity, Response::displacement);
    return solve_stick_slip(influence, given.grid.mesh, given.grid.bound, rigid,
                            {.tolerance = 1e-9}, &now);
  }
  StickSlip shifted(double x, double y) const {
    const Index n = given.grid.mesh.cells();
    const double unit = force() / (c.shear_modulus * given.length);
    VectorXd rigid(2 * n);
    rigid << VectorXd::Constant(n, x / unit), VectorXd::Constant(n, y / unit);
    return step(std::move(rigid), now.p, pressed);
  }
  StickSlip rolled(const Creepage& creepage) const {
    RollingCase moving = c;
    moving.creepage = creepage;
    const RollingMesh& mesh = given.grid.mesh;
    return step(mesh.dx[0] * rigid_slip(mesh, given.reduced(moving)), passed_back(now.p),
                passed_back(pressed));
  }
  CreepForces keep(StickSlip found) {
    CreepForces forces = in_units(given.grid, found, force(), given.length);
    if (found.converged) now = std::move(found), pressed = given.grid.bound;
    return forces;
  }

  // The motion at which a step has the force, by brackets from the last motion and then false
  // position.
  Step for_force(double fx, double scale, const std::function<StickSlip(double)>& solve) {
    units::require_between("force along over the friction's bound", fx / bound(), -0.999, 0.999);
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

namespace {

void check_first_column(const contact::Grid& grid, const VectorXd& pressure) {
  for (Index j = 0; j < grid.ny; ++j)
    if (pressure[j * grid.nx] > 0)
      throw InputError{
          "the first column of the grid has pressure; allowed: an empty one, into which the "
          "contact's tractions roll"};
}

}  // namespace

Transient::Transient(const contact::Grid& grid, const VectorXd& pressure, const RollingCase& c,
                     double dissimilarity) {
  check_given(grid, pressure, c);
  units::require_positive("friction", c.friction, "");
  units::require_between("dissimilarity K", dissimilarity, -0.5, 0.5);
  check_first_column(grid, pressure);
  parts_ = std::make_unique<Parts>(grid, pressure, c, dissimilarity);
}
Transient::~Transient() = default;

void Transient::press(const VectorXd& pressure) {
  check_given(parts_->cells, pressure, parts_->c);
  check_first_column(parts_->cells, pressure);
  const Given& first = parts_->given;
  parts_->given.grid.bound = pressure * (first.length * first.length / first.load);
}
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
Transient::Step Transient::roll_for(double fx, double lateral, double spin) {
  const double unit =
      parts_->force() / (parts_->c.shear_modulus * parts_->given.length * parts_->given.length);
  return parts_->for_force(fx, 0.05 * unit, [&](double xi) {
    return parts_->rolled({xi, lateral, spin});
  });
}

}  // namespace railbook::rolling
