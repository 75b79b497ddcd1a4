#include "contact/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "units/input_error.hpp"

namespace railbook::contact {

Eigen::VectorXd sample(const Gap& gap, const Grid& grid) {
  Eigen::VectorXd f(grid.cells());
  for (Eigen::Index j = 0; j < grid.ny; ++j)
    for (Eigen::Index i = 0; i < grid.nx; ++i) {
      const double value = gap(grid.x(i), grid.y(j));
      if (std::isnan(value) || value == -units::no_limit)
        throw InputError("gap at x = " + std::to_string(grid.x(i)) +
                         " m, y = " + std::to_string(grid.y(j)) + " m is " + std::to_string(value) +
                         "; it must be a number or +infinity (no body there)");
      f[j * grid.nx + i] = value;
    }
  return f;
}

Eigen::VectorXd transfer(const Grid& from, const Eigen::VectorXd& p, const Grid& to) {
  auto square = [&](Eigen::Index i, Eigen::Index j) {
    if (i < 0 || j < 0 || i >= from.nx || j >= from.ny) return 0.0;
    const double value = p[j * from.nx + i];
    return value * value;
  };
  Eigen::VectorXd result(to.cells());
  for (Eigen::Index j = 0; j < to.ny; ++j) {
    const double v = (to.y(j) - from.y0) / from.dy - 0.5;
    const auto b = static_cast<Eigen::Index>(std::floor(v));
    const double t = v - std::floor(v);
    for (Eigen::Index i = 0; i < to.nx; ++i) {
      const double u = (to.x(i) - from.x0) / from.dx - 0.5;
      const auto a = static_cast<Eigen::Index>(std::floor(u));
      const double s = u - std::floor(u);
      result[j * to.nx + i] =
          std::sqrt((1 - t) * ((1 - s) * square(a, b) + s * square(a + 1, b)) +
                    t * ((1 - s) * square(a, b + 1) + s * square(a + 1, b + 1)));
    }
  }
  return result;
}

namespace {

// The least gap on one side of a box, at 129 points; side: 0 x_min, 1 x_max, 2 y_min, 3 y_max.
double least_on_side(const Gap& gap, const std::array<double, 4>& reach, std::size_t side) {
  double least = units::no_limit;
  for (int k = 0; k <= 128; ++k) {
    const double t = k / 128.0;
    const bool on_x = side < 2;
    const double along =
        on_x ? -reach[2] + t * (reach[2] + reach[3]) : -reach[0] + t * (reach[0] + reach[1]);
    const double at = side % 2 == 0 ? -reach[side] : reach[side];
    const double f = on_x ? gap(at, along) : gap(along, at);
    if (std::isnan(f)) throw InputError("the gap is NaN near the origin; it must be a number");
    least = std::min(least, f);
  }
  return least;
}

}  // namespace

Box interpenetration_box(const Gap& gap, double approach) {
  constexpr double growth = 1.2, farthest = 1e3;
  std::array<double, 4> reach;
  reach.fill(1e-15);
  bool moved = true;
  while (moved) {
    moved = false;
    for (std::size_t side = 0; side < 4; ++side)
      while (least_on_side(gap, reach, side) < approach) {
        reach[side] *= growth;
        moved = true;
        if (reach[side] > farthest)
          throw InputError("the bodies do not separate: the gap stays below the approach for 1 km");
      }
  }
  return {-reach[0], reach[1], -reach[2], reach[3]};
}

}  // namespace railbook::contact
