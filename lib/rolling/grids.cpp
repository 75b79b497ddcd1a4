#include <algorithm>
#include <cmath>

#include <railbook/rolling/parts.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::rolling {
namespace {

using Eigen::Index;

// Integral of sqrt(1 - s^2) from -1 to s.
double half_disc(double s) {
  s = std::clamp(s, -1.0, 1.0);
  return 0.5 * (s * std::sqrt((1 - s) * (1 + s)) + std::asin(s)) + units::pi / 4;
}

// What cell i of row j, from the `first` on, bears of a load that is spread over the half length
// like sqrt(1 - s^2): the first and the last cell also what lies beyond them.
double share_of_cell(const RollingMesh& mesh, Index j, Index i, Index first, double half_length) {
  const double s = mesh.x(j, i) / half_length, h = mesh.dx[j] / (2 * half_length);
  const double from = i > first ? half_disc(s - h) : 0;
  const double to = i + 1 < mesh.along ? half_disc(s + h) : units::pi / 2;
  return std::max(0.0, to - from) / (units::pi / 2);
}

// Puts the cells of row j on its half length; `share` of the load is spread along it.
void place_row(RollingGrid& grid, Index j, double half_length, double share, bool remedy) {
  RollingMesh& mesh = grid.mesh;
  const double offset = remedy ? edge_offset() : 0, first = remedy ? 0.25 + offset : 0.5;
  mesh.dx[j] = 2 * half_length / (static_cast<double>(mesh.along) + 2 * offset);
  mesh.x0[j] = -half_length + first * mesh.dx[j];
  for (Index i = 0; i < mesh.along; ++i)
    grid.bound[j * mesh.along + i] =
        share * share_of_cell(mesh, j, i, 0, half_length) / (mesh.dx[j] * mesh.dy[j]);
}

// The same with the cells of a longer row: the leading end is where it belongs, the trailing one
// nearest to it.
void place_stepped_row(RollingGrid& grid, Index j, double half_length, double share, double dx,
                       bool remedy) {
  RollingMesh& mesh = grid.mesh;
  const double ahead = remedy ? 0.75 + edge_offset() : 0.5, behind = remedy ? ahead - 0.5 : 0.5;
  const Index last = mesh.along - 1;
  mesh.dx[j] = dx;
  mesh.x0[j] = half_length - (ahead + static_cast<double>(last)) * dx;
  const double cells = (2 * half_length / dx - ahead - behind) + 1;
  const Index first = last + 1 - std::clamp<Index>(std::lround(cells), 1, mesh.along);
  for (Index i = first; i <= last; ++i)
    grid.bound[j * mesh.along + i] =
        share * share_of_cell(mesh, j, i, first, half_length) / (dx * mesh.dy[j]);
}

}  // namespace

RollingGrid ellipse_grid(double axis_ratio, Index along, Index rows, bool remedy, bool stepped) {
  const double a = std::sqrt(axis_ratio), b = 1 / a;
  RollingGrid grid;
  grid.mesh.along = along;
  for (Eigen::VectorXd* v : {&grid.mesh.y, &grid.mesh.dy, &grid.mesh.x0, &grid.mesh.dx})
    v->resize(rows);
  grid.bound.setZero(along * rows);
  const double height = 2 / static_cast<double>(rows);
  const double dx = 2 * a / (static_cast<double>(along) + (remedy ? 2 * edge_offset() : 0));
  for (Index j = 0; j < rows; ++j) {
    const double low = -1 + height * static_cast<double>(j), high = low + height;
    // The mean of the squared half length: every row keeps its exact share of the load.
    const double strip = height - (high * high * high - low * low * low) / 3;
    const double half_length = a * std::sqrt(strip / height);
    grid.mesh.y[j] = b * (low + high) / 2;
    grid.mesh.dy[j] = b * height;
    if (stepped)
      place_stepped_row(grid, j, half_length, 0.75 * strip, dx, remedy);
    else
      place_row(grid, j, half_length, 0.75 * strip, remedy);
  }
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

}  // namespace railbook::rolling
