#include <railbook/rolling/detail/cell_displacements.hpp>

#include <cmath>

namespace railbook::rolling {
namespace {

// asinh(v/u) for u, v > 0 and r^2 = u^2 + v^2.
double inverse_sinh(double v, double u, double r) {
  if (v > 0.25 * u) return std::log((v + r) / u);
  return std::log1p((v + v * v / (r + u)) / u);
}

// Corner functions: mixed second derivatives (1-nu)/r + nu x^2/r^3, nu x y/r^3, (1-nu)/r + nu
// y^2/r^3.
Influence2 corner(double x, double y, double poisson) {
  const double u = std::abs(x), v = std::abs(y), r = std::sqrt(u * u + v * v);
  const double gx = u > 0 && v > 0 ? std::copysign(x, x * y) * inverse_sinh(v, u, r) : 0;
  const double gy = u > 0 && v > 0 ? std::copysign(y, x * y) * inverse_sinh(u, v, r) : 0;
  return {(1 - poisson) * gx + gy, -poisson * r, gx + (1 - poisson) * gy};
}

}  // namespace

void row_displacements(double x, double y, double dx, double dy, double poisson,
                       std::vector<Influence2>& u) {
  Influence2 below_left{}, above_left{};
  for (std::size_t k = 0; k <= u.size(); ++k) {
    const double edge = (static_cast<double>(k) - 0.5) * dx - x;
    const Influence2 below = corner(edge, -dy / 2 - y, poisson),
                     above = corner(edge, dy / 2 - y, poisson);
    if (k > 0) {
      Influence2& p = u[k - 1];
      p.xx = (above.xx - above_left.xx) - (below.xx - below_left.xx);
      p.xy = (above.xy - above_left.xy) - (below.xy - below_left.xy);
      p.yy = (above.yy - above_left.yy) - (below.yy - below_left.yy);
    }
    below_left = below, above_left = above;
  }
}

}  // namespace railbook::rolling
