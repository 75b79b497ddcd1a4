#include "contact/region.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace railbook::contact {
namespace {

using Eigen::Index;

// One row or column of cells, seen from one of its two sides: value k is the k-th cell from that side.
struct Line {
  const Eigen::VectorXd& p;
  const Eigen::VectorXd& f;
  Index start, stride, count;

  double pressure(Index k) const { return p[start + k * stride]; }
  bool no_body(Index k) const { return k >= 0 && std::isinf(f[start + k * stride]); }
};

// Distance in cells from the first cell edge of the line to where p^2, continued outward, reaches zero;
// negative when the line has no pressure. The outermost cell, which the edge cuts, is only used if it must be.
double end_of(const Line& line) {
  Index k = 0;
  while (k < line.count && !(line.pressure(k) > 0)) ++k;
  if (k == line.count) return -1;
  const double edge = static_cast<double>(k);
  if (line.no_body(k - 1)) return edge;
  auto square = [&](Index n) { return n < line.count ? line.pressure(n) * line.pressure(n) : 0.0; };
  double t = 0.5;  // of the outermost cell, inward from its centre to the zero of p^2
  const double s1 = square(k + 1), s2 = square(k + 2), s3 = square(k + 3);
  if (s1 > 0 && s2 > s1 && s3 > s2) {
    // Newton's parabola through the three next cells, at a distance u outward of the first of them.
    const double slope = s2 - s1, bend = s3 - 2 * s2 + s1;
    const double linear = slope - 0.5 * bend;
    const double discriminant = linear * linear - 2 * bend * s1;
    const double u = discriminant >= 0 ? 2 * s1 / (linear + std::sqrt(discriminant)) : s1 / slope;
    t = 1 - u;
  } else if (s1 > square(k)) {
    t = -square(k) / (s1 - square(k));
  } else {
    t = -0.5;
  }
  // A region that runs off the grid ends with it: never below 0, which would read as no pressure at all.
  return std::max(0.0, edge + 0.5 + std::clamp(t, -1.0, 0.5));
}

// The least of the ends of neighbouring lines, by a parabola through the ends near it: the parabola averages
// the noise of single ends, which depends on how each line meets the grid.
double extreme(const std::vector<double>& ends) {
  Index best = -1, with_pressure = 0;
  for (std::size_t j = 0; j < ends.size(); ++j) {
    if (ends[j] < 0) continue;
    ++with_pressure;
    if (best < 0 || ends[j] < ends[static_cast<std::size_t>(best)]) best = static_cast<Index>(j);
  }
  const double least = ends[static_cast<std::size_t>(best)];
  const Index half = with_pressure / 5;
  if (half < 4 || best < half || best + half >= static_cast<Index>(ends.size())) return least;
  Eigen::MatrixXd powers(2 * half + 1, 5);
  Eigen::VectorXd values(2 * half + 1);
  for (Index j = -half; j <= half; ++j) {
    const double t = static_cast<double>(j) / static_cast<double>(half);
    powers.row(j + half) << 1, t, t * t, t * t * t, t * t * t * t;
    values[j + half] = ends[static_cast<std::size_t>(best + j)];
    if (values[j + half] < 0) return least;
  }
  const Eigen::VectorXd c = (powers.transpose() * powers).ldlt().solve(powers.transpose() * values);
  const double noise = (powers * c - values).cwiseAbs().maxCoeff();
  if (!(c[2] > 0) || noise > 1) return least;  // a corner or a gap, not a smooth end
  return c[0] - c[1] * c[1] / (4 * c[2]);
}

// Replaces the peak cell by the vertex of the parabolas in p^2 through it and its two neighbours in x and in y.
void refine_peak(const Grid& grid, const Eigen::VectorXd& p, Index i, Index j, Region& region) {
  auto shift = [&](Index stride, bool inside, double& gain) {
    const Index n = j * grid.nx + i;
    if (!inside || !(p[n - stride] > 0) || !(p[n + stride] > 0)) return 0.0;
    const double before = p[n - stride] * p[n - stride], here = p[n] * p[n];
    const double after = p[n + stride] * p[n + stride];
    const double bend = before - 2 * here + after;
    if (!(bend < 0)) return 0.0;
    const double t = 0.5 * (before - after) / bend;
    gain += -0.125 * (before - after) * (before - after) / bend;
    return t;
  };
  double gain = 0;
  region.x_p_max = grid.x(i) + grid.dx * shift(1, i > 0 && i + 1 < grid.nx, gain);
  region.y_p_max = grid.y(j) + grid.dy * shift(grid.nx, j > 0 && j + 1 < grid.ny, gain);
  region.p_max = std::sqrt(p[j * grid.nx + i] * p[j * grid.nx + i] + gain);
}

bool next_to_no_body(const Grid& grid, const Eigen::VectorXd& f, Index n) {
  const Index i = n % grid.nx, j = n / grid.nx;
  return (i > 0 && std::isinf(f[n - 1])) || (i + 1 < grid.nx && std::isinf(f[n + 1])) ||
         (j > 0 && std::isinf(f[n - grid.nx])) || (j + 1 < grid.ny && std::isinf(f[n + grid.nx]));
}

}  // namespace

Region describe(const Grid& grid, const Eigen::VectorXd& p, const Eigen::VectorXd& f) {
  Region region;
  const Index nx = grid.nx, ny = grid.ny;
  Index peak = 0;
  for (Index n = 0; n < grid.cells(); ++n) {
    if (!(p[n] > 0)) continue;
    ++region.cells;
    region.force += p[n];
    region.moment_x -= grid.y(n / nx) * p[n];
    region.moment_y += grid.x(n % nx) * p[n];
    if (p[n] > p[peak]) peak = n;
    region.meets_body_edge |= next_to_no_body(grid, f, n);
  }
  if (region.cells == 0) return region;
  const double cell = grid.dx * grid.dy;
  region.force *= cell, region.moment_x *= cell, region.moment_y *= cell;
  refine_peak(grid, p, peak % nx, peak / nx, region);

  std::vector<double> left, right, below, above;
  for (Index j = 0; j < ny; ++j) {
    left.push_back(end_of({p, f, j * nx, 1, nx}));
    right.push_back(end_of({p, f, j * nx + nx - 1, -1, nx}));
    if (left.back() >= 0)
      region.area += cell * (static_cast<double>(nx) - left.back() - right.back());
    region.touches_x_min |= p[j * nx] > 0;
    region.touches_x_max |= p[j * nx + nx - 1] > 0;
  }
  for (Index i = 0; i < nx; ++i) {
    below.push_back(end_of({p, f, i, nx, ny}));
    above.push_back(end_of({p, f, (ny - 1) * nx + i, -nx, ny}));
    region.touches_y_min |= p[i] > 0;
    region.touches_y_max |= p[(ny - 1) * nx + i] > 0;
  }
  region.ends = {grid.x0 + grid.dx * extreme(left),
                 grid.x0 + grid.dx * (static_cast<double>(nx) - extreme(right)),
                 grid.y0 + grid.dy * extreme(below),
                 grid.y0 + grid.dy * (static_cast<double>(ny) - extreme(above))};
  return region;
}

Outline outline(const Grid& grid, const Eigen::VectorXd& p, const Eigen::VectorXd& f) {
  std::vector<double> x, low, high;
  for (Index i = 0; i < grid.nx; ++i) {
    const double below = end_of({p, f, i, grid.nx, grid.ny});
    if (below < 0) continue;
    const double above = end_of({p, f, (grid.ny - 1) * grid.nx + i, -grid.nx, grid.ny});
    x.push_back(grid.x(i));
    low.push_back(grid.y0 + grid.dy * below);
    high.push_back(grid.y0 + grid.dy * (static_cast<double>(grid.ny) - above));
  }
  const auto vector = [](const std::vector<double>& v) -> Eigen::VectorXd {
    return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Index>(v.size()));
  };
  return {vector(x), vector(low), vector(high)};
}

}  // namespace railbook::contact
