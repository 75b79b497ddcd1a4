#include <railbook/contact/detail/missed.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <railbook/units/constants.hpp>

namespace railbook::contact {
namespace {

using Eigen::Index;

// Loads that stand for the pressures of blocks of cells, at their centres of pressure: rods where
// blocks are long in one direction, otherwise points.
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

  // Displacement times pi E* [N/m], or what of it was added up when it passed `enough`.
  double at(const Point& place, double enough) const {
    const double half = std::max(half_x, half_y);
    double sum = 0;
    for (std::size_t k = 0; k < x.size() && sum <= enough; ++k) {
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

// The loads by sixteenths of the grid: what each sinks a place is at least what it would from its
// farthest corner.
struct CoarseLoads {
  std::array<Box, 16> box;
  std::array<double, 16> force{};
  double least;

  CoarseLoads(const Grid& grid, const Loads& loads) : least(loads.least) {
    const double width = static_cast<double>(grid.nx) * grid.dx,
                 height = static_cast<double>(grid.ny) * grid.dy;
    for (std::size_t n = 0; n < 16; ++n) {
      const std::size_t row = n / 4;
      const double i = static_cast<double>(n % 4), j = static_cast<double>(row);
      box[n] = {
          grid.x0 + i * width / 4 - loads.half_x, grid.x0 + (i + 1) * width / 4 + loads.half_x,
          grid.y0 + j * height / 4 - loads.half_y, grid.y0 + (j + 1) * height / 4 + loads.half_y};
    }
    const auto quarter = [](double t) {
      return static_cast<std::size_t>(std::clamp(4 * t, 0.0, 3.0));
    };
    for (std::size_t k = 0; k < loads.x.size(); ++k)
      force[4 * quarter((loads.y[k] - grid.y0) / height) +
            quarter((loads.x[k] - grid.x0) / width)] += loads.force[k];
  }

  double at_least(const Point& place) const {
    double sum = 0;
    for (std::size_t n = 0; n < 16; ++n) {
      const double along = std::max(place.x - box[n].x_min, box[n].x_max - place.x),
                   beside = std::max(place.y - box[n].y_min, box[n].y_max - place.y);
      sum += force[n] / (std::hypot(along, beside) + least);
    }
    return sum;
  }
};

}  // namespace

std::vector<Point> missed_places(const Gap& gap, double approach, double effective_modulus,
                                 const Grid& grid, const Eigen::VectorXd& p, const Box& box,
                                 double share) {
  const Loads blocks(grid, p, 24), cells(grid, p, 4096);
  const CoarseLoads sixteenths(grid, blocks);  // most places need no more
  const double k = 1 / (units::pi * effective_modulus);
  const double x_end = grid.x0 + static_cast<double>(grid.nx) * grid.dx;
  const double y_end = grid.y0 + static_cast<double>(grid.ny) * grid.dy;
  std::vector<Point> places;
  const auto look = [&](double x, double y) {
    if (x > grid.x0 && x < x_end && y > grid.y0 && y < y_end) return;
    const double overlap = approach - gap(x, y);
    const double enough = 0.5 * share * approach;
    if (!(overlap > share * approach) || overlap - k * sixteenths.at_least({x, y}) < enough ||
        overlap - k * blocks.at({x, y}, (overlap - enough) / k) < enough)
      return;
    const double most = (overlap - share * approach) / k;
    if (cells.at({x, y}, most) < most) places.push_back({x, y});
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
