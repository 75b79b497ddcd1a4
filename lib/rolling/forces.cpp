#include <algorithm>
#include <cmath>

#include <railbook/rolling/contact.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

struct Search {
  const EllipseRolling& contact;
  RollingCase c;
  std::optional<double> fx, fy;
  double bound;
  CreepForces forces;

  // What the forces lack over mu N; a component that is not prescribed lacks nothing.
  Vector2d missing(const Vector2d& reduced) {
    Creepage r = reduced_creepage(c);
    if (fx) r.longitudinal = reduced[0];
    if (fy) r.lateral = reduced[1];
    c = with_reduced_creepage(c, r);
    forces = contact.solve(c);
    return {fx ? (*fx - forces.fx) / bound : 0, fy ? (*fy - forces.fy) / bound : 0};
  }

  Matrix2d slope(const Vector2d& at, const Vector2d& missing_there) {
    Matrix2d k = Matrix2d::Identity();
    for (int j = 0; j < 2; ++j) {
      if (!(j == 0 ? fx : fy)) continue;
      Vector2d moved = at;
      const double step = 1e-5 * std::max(0.01, std::abs(at[j]));
      moved[j] += step;
      k.col(j) = (missing_there - missing(moved)) / step;
    }
    return k;
  }
};

Vector2d solved(const Matrix2d& k, const Vector2d& r) {
  const double d = k(0, 0) * k(1, 1) - k(0, 1) * k(1, 0);
  if (d == 0) return Vector2d::Zero();
  return {(k(1, 1) * r[0] - k(0, 1) * r[1]) / d, (k(0, 0) * r[1] - k(1, 0) * r[0]) / d};
}

}  // namespace

RollingForForces solve_for_forces(const EllipseRolling& contact, const RollingCase& c,
                                  std::optional<double> fx, std::optional<double> fy) {
  check(c);
  units::require_finite("prescribed longitudinal force", fx.value_or(0), "N");
  units::require_finite("prescribed lateral force", fy.value_or(0), "N");
  Search search{contact, c, fx, fy, c.friction * c.load, {}};
  const double wanted = std::hypot(fx.value_or(0), fy.value_or(0));
  if (wanted >= search.bound) {
    search.forces.reason = "the prescribed forces are not below mu N: no steady rolling";
    return {c, search.forces};
  }
  Vector2d at{reduced_creepage(c).longitudinal, reduced_creepage(c).lateral};
  if (fx) at[0] = 0;
  if (fy) at[1] = 0;
  Vector2d r = search.missing(at);
  constexpr double enough = 1e-8;
  for (int step = 0; step < 40 && r.norm() > enough; ++step) {
    const Vector2d change = solved(search.slope(at, r), r);
    double part = 1;
    Vector2d next = r;
    for (; part > 1e-4; part /= 2) {
      next = search.missing(at + part * change);
      if (next.norm() < (1 - 0.1 * part) * r.norm()) break;
    }
    if (part <= 1e-4) break;
    at += part * change;
    r = next;
  }
  r = search.missing(at);
  if (search.forces.converged && r.norm() > enough) {
    search.forces.converged = false;
    search.forces.reason = "the prescribed forces were not reached";
  }
  return {search.c, search.forces};
}

}  // namespace railbook::rolling
