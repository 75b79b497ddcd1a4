#include <railbook/wheel_contact/stress.hpp>

#include <cmath>
#include <utility>

#include <railbook/units/input_error.hpp>

namespace railbook::wheel_contact {

using Eigen::Index;
using Eigen::VectorXd;

PatchStress stresses(const PatchResult& patch, const WheelInput& input) {
  if (patch.pressure.size() == 0)
    throw InputError{
        "stresses below the surface are those of the full theory's tractions; this patch has none"};
  PatchStress out;
  out.grid = patch.grid;
  VectorXd p = patch.pressure, x = VectorXd::Zero(p.size()), y = x;
  const rolling::Tractions& t = patch.forces.tractions;
  if (patch.friction > 0) {
    // The traction cells lie a part of a cell behind those of the pressure, and so do the pressures
    // here.
    const contact::Grid& g = patch.grid;
    const auto column = [&](Index k) { return std::lround((t.x[k] - g.x(0)) / g.dx); };
    out.grid.x0 += t.x[0] - g.x(column(0));
    p.setZero();
    for (Index k = 0; k < t.x.size(); ++k) {
      const Index cell = std::lround((t.y[k] - g.y(0)) / g.dy) * g.nx + column(k);
      p[cell] = t.bound[k] / patch.friction, x[cell] = t.px[k], y[cell] = t.py[k];
    }
  }
  if (input.rail.poisson == input.wheel.poisson) {
    auto both = contact::largest_stresses(out.grid, input.rail.poisson, p, x, y);
    out.rail = std::move(both[0]), out.wheel = std::move(both[1]);
    return out;
  }
  out.rail = contact::largest_stress(out.grid, input.rail.poisson, p, x, y);
  out.wheel = contact::largest_stress(out.grid, input.wheel.poisson, p, -x, -y);
  return out;
}

}  // namespace railbook::wheel_contact
