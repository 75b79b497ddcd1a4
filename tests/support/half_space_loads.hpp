// Grids and tractions of unit size on a half-space.
#pragma once

#include <cmath>

#include <railbook/contact/subsurface.hpp>

namespace railbook::tests {

// n x n cells from -half to half.
inline contact::Grid square_grid(Eigen::Index n, double half) {
  const double cell = 2 * half / static_cast<double>(n);
  return {-half, -half, cell, cell, n, n};
}
// n cells along x, so long across that they are strips.
inline contact::Grid line_grid(Eigen::Index n, double half) {
  return {-half, -5e3, 2 * half / static_cast<double>(n), 1e4, n, 1};
}

template <class F>
Eigen::VectorXd on(const contact::Grid& grid, F&& f) {
  Eigen::VectorXd out(grid.cells());
  for (Eigen::Index k = 0; k < out.size(); ++k)
    out[k] = f(grid.x(k % grid.nx), grid.y(k / grid.nx));
  return out;
}
// Hertz's pressure of radius or half-width 1 and peak 1, with its own sum.
inline Eigen::VectorXd hertz_circle(const contact::Grid& grid) {
  const Eigen::VectorXd p =
      on(grid, [](double x, double y) { return std::sqrt(std::max(0.0, 1 - x * x - y * y)); });
  return p * (2 * 3.14159265358979 / 3) / (p.sum() * grid.dx * grid.dy);
}
inline Eigen::VectorXd hertz_line(const contact::Grid& grid) {
  const Eigen::VectorXd p =
      on(grid, [](double x, double) { return std::sqrt(std::max(0.0, 1 - x * x)); });
  return p * (3.14159265358979 / 2) / (p.sum() * grid.dx);
}

}  // namespace railbook::tests
