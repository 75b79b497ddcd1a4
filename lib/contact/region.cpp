#include <railbook/contact/region.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <railbook/num/dense_lu.hpp>
#include <railbook/num/product.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::contact {
namespace {

using Eigen::Index;

// Cells with pressure that are connected, by an edge or a corner, have one number, 0 for the patch
// that carries most; cells without pressure have none (-1).
struct Labels {
  std::vector<int> of;
  int count = 0;

  Labels(const Grid& grid, const Eigen::VectorXd& p) : of(static_cast<std::size_t>(p.size()), -1) {
    std::vector<Index> waiting;
    std::vector<double> force;
    for (Index n = 0; n < p.size(); ++n) {
      if (!(p[n] > 0) || (*this)[n] >= 0) continue;
      at(n) = count;
      force.push_back(0);
      for (waiting.push_back(n); !waiting.empty();) {
        const Index cell = waiting.back(), i = cell % grid.nx, j = cell / grid.nx;
        waiting.pop_back();
        force.back() += p[cell];
        for (Index v = std::max<Index>(j - 1, 0); v <= std::min(j + 1, grid.ny - 1); ++v)
          for (Index u = std::max<Index>(i - 1, 0); u <= std::min(i + 1, grid.nx - 1); ++u) {
            const Index next = v * grid.nx + u;
            if (!(p[next] > 0) || (*this)[next] >= 0) continue;
            at(next) = count;
            waiting.push_back(next);
          }
      }
      ++count;
    }
    std::vector<int> order(force.size()), rank(force.size());
    std::iota(order.begin(), order.end(), 0);
    const auto of_patch = [&](int k) { return force[static_cast<std::size_t>(k)]; };
    std::ranges::stable_sort(order, std::greater{}, of_patch);
    for (int k = 0; k < count; ++k)
      rank[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])] = k;
    for (int& label : of)
      if (label >= 0) label = rank[static_cast<std::size_t>(label)];
  }
  int operator[](Index n) const { return of[static_cast<std::size_t>(n)]; }
  int& at(Index n) { return of[static_cast<std::size_t>(n)]; }
};

// One row or column of cells, seen from one of its two sides: value k is the k-th cell from that
// side. Only the pressures of one patch count.
struct Line {
  const Eigen::VectorXd& p;
  const Eigen::VectorXd& f;
  const Labels& labels;
  int patch;
  Index start, stride, count;

  double pressure(Index k) const {
    const Index n = start + k * stride;
    return labels[n] == patch ? p[n] : 0;
  }
  bool no_body(Index k) const { return k >= 0 && std::isinf(f[start + k * stride]); }
  Line reversed() const {
    return {p, f, labels, patch, start + (count - 1) * stride, -stride, count};
  }
};

// Whether the second is larger than the first. Cells that mirror each other have the same pressure
// but for rounding, which does not decide.
bool rises(double first, double second) {
  return second > first * (1 + 1e-5);
}

// Distance in cells from the first cell edge of the line to where p^2, continued outward from cell
// k, the outermost of a run of cells with pressure, reaches zero. Cell k itself, which the edge
// cuts, is only used if it must be.
double end_at(const Line& line, Index k) {
  const double edge = static_cast<double>(k);
  if (line.no_body(k - 1)) return edge;
  auto square = [&](Index n) { return n < line.count ? line.pressure(n) * line.pressure(n) : 0.0; };
  double t = -0.5;  // of the outermost cell, inward from its centre to the zero of p^2
  const double s1 = square(k + 1), s2 = square(k + 2), s3 = square(k + 3);
  if (s1 > 0 && rises(s1, s2) && rises(s2, s3)) {
    // Newton's parabola through the three next cells, at a distance u outward of the first of them.
    const double slope = s2 - s1, bend = s3 - 2 * s2 + s1;
    const double linear = slope - 0.5 * bend;
    const double discriminant = linear * linear - 2 * bend * s1;
    const double u = discriminant >= 0 ? 2 * s1 / (linear + std::sqrt(discriminant)) : s1 / slope;
    t = 1 - u;
  } else if (rises(square(k), s1)) {
    t = -square(k) / (s1 - square(k));
  }
  // A region that runs off the grid ends with it: never below 0, which would read as no pressure at
  // all.
  return std::max(0.0, edge + 0.5 + std::clamp(t, -1.0, 0.5));
}

// The end of the line's first run of cells with pressure; negative when it has none.
double end_of(const Line& line) {
  for (Index k = 0; k < line.count; ++k)
    if (line.pressure(k) > 0) return end_at(line, k);
  return -1;
}

// Whether the pressure of a run, from its outermost cell k inward, starts at more than 0.3 of
// `p_max` and falls from there: at a smooth end p^2 grows like the distance, and the third cell has
// at least 1.5 times the p^2 of the second.
bool starts_steeply(const Line& line, Index k, double p_max) {
  const double first = line.pressure(k), second = line.pressure(k + 1);
  return second > 0.3 * p_max && (rises(second, first) || rises(line.pressure(k + 2), second));
}

// What the ends of the runs of 8 cells or more have in common.
struct Edges {
  bool steep = false;    // one of them ends steeply
  double intensity = 0;  // sum of K over Hertz's, see PressurePatch
  int count = 0;

  // The end at cell k, inward, of a run of `cells` with a mean pressure: Hertz's p^2 = (4/pi
  // mean)^2 4 s/cells at s cells.
  void add(const Line& line, Index k, Index cells, double mean, double p_max) {
    steep |= starts_steeply(line, k, p_max);
    const auto square = [&](Index n) { return line.pressure(n) * line.pressure(n); };
    // The outermost cell is cut by the edge; where p^2 falls inward the rise was before.
    const double rise = std::max({square(k + 2) - square(k + 1), square(k + 1) - square(k), 0.0});
    intensity += units::pi / (8 * mean) * std::sqrt(rise * static_cast<double>(cells));
    ++count;
  }
};

// Length in cells of all runs of the line together: what lies between them is not contact.
double length_of(const Line& line, double p_max, Edges& edges) {
  const Line back = line.reversed();
  double length = 0;
  for (Index k = 0; k < line.count; ++k) {
    if (!(line.pressure(k) > 0)) continue;
    const Index first = k;
    double sum = line.pressure(k);
    while (k + 1 < line.count && line.pressure(k + 1) > 0) sum += line.pressure(++k);
    const Index last = line.count - 1 - k;  // of the run, from behind
    length += static_cast<double>(line.count) - end_at(back, last) - end_at(line, first);
    const Index cells = k - first + 1;
    if (cells < 8) continue;
    const double mean = sum / static_cast<double>(cells);
    edges.add(line, first, cells, mean, p_max);
    edges.add(back, last, cells, mean, p_max);
  }
  return length;
}

// The least of the ends of neighbouring lines, by a parabola through the ends near it: the parabola
// averages the noise of single ends, which depends on how each line meets the grid.
double extreme(const std::vector<double>& ends) {
  Index best = -1, with_pressure = 0;
  for (std::size_t j = 0; j < ends.size(); ++j) {
    if (ends[j] < 0) continue;
    ++with_pressure;
    if (best < 0 || rises(ends[j], ends[static_cast<std::size_t>(best)]))
      best = static_cast<Index>(j);
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
  const Eigen::MatrixXd across = powers.transpose();
  const Eigen::VectorXd c = num::solved(num::product(across, powers), across * values);
  const double noise = (powers * c - values).cwiseAbs().maxCoeff();
  if (!(c[2] > 0) || noise > 1) return least;  // a corner or a gap, not a smooth end
  return c[0] - c[1] * c[1] / (4 * c[2]);
}

// The vertex of the parabolas in p^2 through the peak cell and its two neighbours in x and in y.
void refine_peak(const Grid& grid, const Eigen::VectorXd& p, Index peak, PressurePatch& patch) {
  const Index i = peak % grid.nx, j = peak / grid.nx;
  auto shift = [&](Index stride, bool inside, double& gain) {
    if (!inside || !(p[peak - stride] > 0) || !(p[peak + stride] > 0)) return 0.0;
    const double before = p[peak - stride] * p[peak - stride], here = p[peak] * p[peak];
    const double after = p[peak + stride] * p[peak + stride];
    const double bend = before - 2 * here + after;
    if (!(bend < 0)) return 0.0;
    const double t = 0.5 * (before - after) / bend;
    gain += -0.125 * (before - after) * (before - after) / bend;
    return t;
  };
  const auto drop = [&](bool inside, Index stride) {
    patch.peak_drop = std::max(patch.peak_drop, inside ? 1 - p[peak + stride] / p[peak] : 1);
  };
  drop(i > 0, -1), drop(i + 1 < grid.nx, 1);
  drop(j > 0, -grid.nx), drop(j + 1 < grid.ny, grid.nx);
  double gain = 0;
  patch.x_p_max = grid.x(i) + grid.dx * shift(1, i > 0 && i + 1 < grid.nx, gain);
  patch.y_p_max = grid.y(j) + grid.dy * shift(grid.nx, j > 0 && j + 1 < grid.ny, gain);
  patch.p_max = std::sqrt(p[peak] * p[peak] + gain);
}

bool next_to_no_body(const Grid& grid, const Eigen::VectorXd& f, Index n) {
  const Index i = n % grid.nx, j = n / grid.nx;
  return (i > 0 && std::isinf(f[n - 1])) || (i + 1 < grid.nx && std::isinf(f[n + 1])) ||
         (j > 0 && std::isinf(f[n - grid.nx])) || (j + 1 < grid.ny && std::isinf(f[n + grid.nx]));
}

// The cells that a patch lies in, first and last of each axis.
struct Extent {
  double i = 0, j = 0, ii = 0, jj = 0,
         ij = 0;  // moments of pressure about the first cell of the grid, in cells
  Index i0 = std::numeric_limits<Index>::max(), i1 = -1;
  Index j0 = std::numeric_limits<Index>::max(), j1 = -1;
  Index peak = -1;

  void add(Index column, Index row, double p) {
    const double u = static_cast<double>(column), v = static_cast<double>(row);
    i += p * u, j += p * v, ii += p * u * u, jj += p * v * v, ij += p * u * v;
    i0 = std::min(i0, column), i1 = std::max(i1, column);
    j0 = std::min(j0, row), j1 = std::max(j1, row);
  }
  // The lesser principal deviation of `total` pressure, a cell's own 1/12 included, as the axis of
  // Hertz's ellipse, whose deviation is its semi-axis over root 5.
  double across(double total) const {
    const double u = i / total, v = j / total;
    const double xx = ii / total - u * u, yy = jj / total - v * v, xy = ij / total - u * v;
    const double least = 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy);
    return 2 * std::sqrt(5 * (std::max(least, 0.0) + 1.0 / 12));
  }
};

// Peak, area and ends of one patch from the lines through it; `steep` becomes true when one of them
// ends steeply.
void measure(const Grid& grid, const Eigen::VectorXd& p, const Eigen::VectorXd& f,
             const Labels& labels, int number, const Extent& extent, PressurePatch& patch,
             bool& steep) {
  refine_peak(grid, p, extent.peak, patch);
  Edges edges;
  const auto rows = static_cast<std::size_t>(grid.ny), columns = static_cast<std::size_t>(grid.nx);
  std::vector<double> left(rows, -1), right = left, below(columns, -1), above = below;
  for (Index j = extent.j0; j <= extent.j1; ++j) {
    const Line row{p, f, labels, number, j * grid.nx, 1, grid.nx};
    left[static_cast<std::size_t>(j)] = end_of(row);
    right[static_cast<std::size_t>(j)] = end_of(row.reversed());
    patch.area += grid.dx * grid.dy * length_of(row, patch.p_max, edges);
  }
  for (Index i = extent.i0; i <= extent.i1; ++i) {
    const Line column{p, f, labels, number, i, grid.nx, grid.ny};
    below[static_cast<std::size_t>(i)] = end_of(column);
    above[static_cast<std::size_t>(i)] = end_of(column.reversed());
    length_of(column, patch.p_max, edges);
  }
  steep |= edges.steep;
  if (edges.count > 0) patch.edge_intensity = edges.intensity / edges.count;
  patch.ends = {grid.x0 + grid.dx * extreme(left),
                grid.x0 + grid.dx * (static_cast<double>(grid.nx) - extreme(right)),
                grid.y0 + grid.dy * extreme(below),
                grid.y0 + grid.dy * (static_cast<double>(grid.ny) - extreme(above))};
}

}  // namespace

Region describe(const Grid& grid, const Eigen::VectorXd& p, const Eigen::VectorXd& f) {
  const Labels labels(grid, p);
  const double cell = grid.dx * grid.dy;
  Region region;
  region.patches.resize(static_cast<std::size_t>(labels.count));
  std::vector<Extent> extents(region.patches.size());
  for (Index n = 0; n < grid.cells(); ++n) {
    if (labels[n] < 0) continue;
    const Index i = n % grid.nx, j = n / grid.nx;
    region.moment_x -= grid.y(j) * p[n];
    region.moment_y += grid.x(i) * p[n];
    region.meets_body_edge |= next_to_no_body(grid, f, n);
    region.touches_x_min |= i == 0, region.touches_x_max |= i == grid.nx - 1;
    region.touches_y_min |= j == 0, region.touches_y_max |= j == grid.ny - 1;
    region.force += p[n];
    ++region.cells;
    PressurePatch& patch = region.patches[static_cast<std::size_t>(labels[n])];
    Extent& extent = extents[static_cast<std::size_t>(labels[n])];
    patch.force += p[n] * cell;
    ++patch.cells;
    extent.add(i, j, p[n]);
    if (extent.peak < 0 || rises(p[extent.peak], p[n])) extent.peak = n;
  }
  if (region.cells == 0) return region;
  region.force *= cell, region.moment_x *= cell, region.moment_y *= cell;
  constexpr double inf = std::numeric_limits<double>::infinity();
  region.ends = {inf, -inf, inf, -inf};
  for (std::size_t k = 0; k < extents.size(); ++k) {
    PressurePatch& patch = region.patches[k];
    measure(grid, p, f, labels, static_cast<int>(k), extents[k], patch, region.ends_steeply);
    patch.cells_across = extents[k].across(patch.force / cell);
    region.area += patch.area;
    region.ends = {std::min(region.ends.x_min, patch.ends.x_min),
                   std::max(region.ends.x_max, patch.ends.x_max),
                   std::min(region.ends.y_min, patch.ends.y_min),
                   std::max(region.ends.y_max, patch.ends.y_max)};
    if (patch.p_max <= region.p_max) continue;
    region.p_max = patch.p_max;
    region.x_p_max = patch.x_p_max, region.y_p_max = patch.y_p_max;
  }
  return region;
}

Outline outline(const Grid& grid, const Eigen::VectorXd& p, const Eigen::VectorXd& f) {
  const Labels labels(grid, p);
  std::vector<double> x, low, high;
  Outline result;
  for (int patch = 0; patch < labels.count; ++patch) {
    for (Index i = 0; i < grid.nx; ++i) {
      const Line column{p, f, labels, patch, i, grid.nx, grid.ny};
      const double below = end_of(column);
      if (below < 0) continue;
      result.patch.push_back(patch);
      x.push_back(grid.x(i));
      low.push_back(grid.y0 + grid.dy * below);
      high.push_back(grid.y0 +
                     grid.dy * (static_cast<double>(grid.ny) - end_of(column.reversed())));
    }
  }
  const auto vector = [](const std::vector<double>& v) -> Eigen::VectorXd {
    return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Index>(v.size()));
  };
  result.x = vector(x), result.low = vector(low), result.high = vector(high);
  return result;
}

}  // namespace railbook::contact
