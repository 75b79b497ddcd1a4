#include "contact/missed.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "units/constants.hpp"

namespace railbook::contact {
namespace {

using Eigen::Index;

// Loads that stand for the pressures of blocks of cells, at their centres of pressure: rods where blocks are long in one
// direction, otherwise points.
struct Loads {
  std::vector<double> x, y, force;
  double half_x = 0, half_y = 0;  // of a rod; one of them, or none, is not 0
  double least = 0;               // a load is as wide as its block: no place is nearer to it

  Loads(const Grid& grid, const Eigen::VectorXd& p, Index most_across) {
    const Index wide = std::max<Index>(1, grid.nx / most_across),
                high = std::max<Index>(1, grid.ny / most_across);
    const double width = static_cast<double>(wide) * grid.dx,
                 height = static_cast<double>(high) * grid.dy;
    least = std::min(width, height) / 4;
    if (width > 2 * height) half_x = width / 2;
    if (height > 2 * width) half_y = height / 2;
    for (Index j0 = 0; j0 < grid.ny; j0 += high)
      for (Index i0 = 0; i0 < grid.nx; i0 += wide) {
        double sum = 0, sum_x = 0, sum_y = 0;
        for (Index j = j0; j < std::min(j0 + high, grid.ny); ++j)
          for (Index i = i0; i < std::min(i0 + wide, grid.nx); ++i) {
            const double cell = p[j * grid.nx + i];
            sum += cell, sum_x += cell * grid.x(i), sum_y += cell * grid.y(j);
          }
        if (!(sum > 0)) continue;
        x.push_back(sum_x / sum), y.push_back(sum_y / sum);
        force.push_back(sum * grid.dx * grid.dy);
      }
  }

  // Displacement times pi E* [N/m].
  double at(const Point& place) const {
    const double half = std::max(half_x, half_y);
    double sum = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      double along = std::abs(place.x - x[k]), beside = std::abs(place.y - y[k]);
      if (half_y > 0) std::swap(along, beside);
      beside = std::max(beside, least);
      const double r2 = along * along + beside * beside;
      // Beyond four half lengths a rod is a point to half a per cent.
      if (half == 0 || r2 > 16 * half * half)
        sum += force[k] / std::sqrt(r2);
      else
        sum += force[k] / (2 * half) *
               std::log((along + half + std::hypot(along + half, beside)) /
                        (along - half + std::hypot(along - half, beside)));
    }
    return sum;
  }
};

}  // namespace

std::vector<Point> missed_places(const Gap& gap, double approach, double effective_modulus,
                                 const Grid& grid, const Eigen::VectorXd& p, const Box& box,
                                 double share) {
  const Loads blocks(grid, p, 24), cells(grid, p, 4096);
  const double k = 1 / (units::pi * effective_modulus);
  const double x_end = grid.x0 + static_cast<double>(grid.nx) * grid.dx;
  const double y_end = grid.y0 + static_cast<double>(grid.ny) * grid.dy;
  std::vector<Point> places;
  const auto look = [&](double x, double y) {
    if (x > grid.x0 && x < x_end && y > grid.y0 && y < y_end) return;
    const double overlap = approach - gap(x, y);
    if (!(overlap > share * approach) || overlap - k * blocks.at({x, y}) < 0.5 * share * approach)
      return;
    if (overlap - k * cells.at({x, y}) > share * approach) places.push_back({x, y});
  };
  constexpr int across = 96, along = 1024;
  const auto between = [](double low, double high, int i, int n) {
    return low + (high - low) * i / n;
  };
  for (int j = 0; j <= across; ++j)
    for (int i = 0; i <= across; ++i)
      look(between(box.x_min, box.x_max, i, across), between(box.y_min, box.y_max, j, across));
  for (int i = 0; i <= along; ++i) {
    if (box.y_min < 0 && box.y_max > 0) look(between(box.x_min, box.x_max, i, along), 0);
    if (box.x_min < 0 && box.x_max > 0) look(0, between(box.y_min, box.y_max, i, along));
  }
  return places;
}

}  // namespace railbook::contact
