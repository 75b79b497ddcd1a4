#include <railbook/contact/grid.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::contact {

Eigen::VectorXd sample(const Gap& gap, const Grid& grid) {
  Eigen::VectorXd f(grid.cells());
  for (Eigen::Index j = 0; j < grid.ny; ++j)
    for (Eigen::Index i = 0; i < grid.nx; ++i) {
      const double value = gap(grid.x(i), grid.y(j));
      if (std::isnan(value) || value == -units::infinity)
        throw InputError("gap at x = " + std::to_string(grid.x(i)) +
                         " m, y = " + std::to_string(grid.y(j)) + " m is " + std::to_string(value) +
                         "; it must be a number or +infinity (no body there)");
      f[j * grid.nx + i] = value;
    }
  return f;
}

namespace {

// The squares of the pressures with a frame of one cell. Beside the contact, where the pressure
// ends like the root of the distance and its square like the distance itself, the square goes on
// linearly from the last two cells, to values below zero.
class SquaredPressure {
 public:
  SquaredPressure(const Grid& grid, const Eigen::VectorXd& p)
      : nx_(grid.nx), ny_(grid.ny), squares_((nx_ + 2) * (ny_ + 2)) {
    const auto square = [&](Eigen::Index i, Eigen::Index j) {
      if (i < 0 || j < 0 || i >= nx_ || j >= ny_) return 0.0;
      return p[j * nx_ + i] * p[j * nx_ + i];
    };
    for (Eigen::Index j = -1; j <= ny_; ++j)
      for (Eigen::Index i = -1; i <= nx_; ++i) {
        double& here = squares_[(j + 1) * (nx_ + 2) + i + 1] = square(i, j);
        if (here > 0) continue;
        double sum = 0;
        int sides = 0;
        for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          const double beside = square(i + di, j + dj), next = square(i + 2 * di, j + 2 * dj);
          if (!(beside > 0) || !(next > 0)) continue;
          sum += std::min(2 * beside - next, 0.0);
          ++sides;
        }
        if (sides > 0) here = sum / sides;
      }
  }
  double operator()(Eigen::Index i, Eigen::Index j) const {
    if (i < -1 || j < -1 || i > nx_ || j > ny_) return 0;
    return squares_[(j + 1) * (nx_ + 2) + i + 1];
  }

 private:
  Eigen::Index nx_, ny_;
  Eigen::VectorXd squares_;
};

}  // namespace

Eigen::VectorXd transfer(const Grid& from, const Eigen::VectorXd& p, const Grid& to) {
  const SquaredPressure square(from, p);
  Eigen::VectorXd result(to.cells());
  for (Eigen::Index j = 0; j < to.ny; ++j) {
    const double v = (to.y(j) - from.y0) / from.dy - 0.5;
    const auto b = static_cast<Eigen::Index>(std::floor(v));
    const double t = v - std::floor(v);
    for (Eigen::Index i = 0; i < to.nx; ++i) {
      const double u = (to.x(i) - from.x0) / from.dx - 0.5;
      const auto a = static_cast<Eigen::Index>(std::floor(u));
      const double s = u - std::floor(u);
      const double value = (1 - t) * ((1 - s) * square(a, b) + s * square(a + 1, b)) +
                           t * ((1 - s) * square(a, b + 1) + s * square(a + 1, b + 1));
      result[j * to.nx + i] = std::sqrt(std::max(value, 0.0));
    }
  }
  return result;
}

namespace {

struct Place {
  double x = 0, y = 0, gap = units::infinity;
};

double value_at(const Gap& gap, double x, double y) {
  const double f = gap(x, y);
  if (std::isnan(f)) throw InputError("the gap is NaN near the origin; it must be a number");
  return f;
}

// The lowest of `count` places on a circle, or `best` when none is lower.
Place lowest_on_circle(const Gap& gap, const Place& centre, double radius, int count, Place best) {
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * units::pi * k / count;
    const double x = centre.x + radius * std::cos(angle), y = centre.y + radius * std::sin(angle);
    const double f = value_at(gap, x, y);
    if (f < best.gap) best = {x, y, f};
  }
  return best;
}

constexpr double farthest = 1e3;  // [m] from the origin

// A place where the gap is less than the approach: the origin, or downhill from the lowest on
// circles round it.
Place place_in_contact(const Gap& gap, double approach) {
  const Place origin{0, 0, value_at(gap, 0, 0)};
  Place best = origin;
  double step = 1e-9;
  for (double radius = 1e-9; radius < farthest && !(best.gap < approach); radius *= 1.25) {
    const Place next = lowest_on_circle(gap, origin, radius, 32, best);
    if (next.gap < best.gap) best = next, step = 0.25 * radius;
  }
  const double least_step = 1e-9 * step;
  for (int k = 0; k < 10000 && !(best.gap < approach) && step > least_step; ++k) {
    const Place next = lowest_on_circle(gap, best, step, 12, best);
    step *= next.gap < best.gap ? 1.5 : 0.5;
    best = next;
  }
  if (best.gap < approach) return best;
  throw InputError(
      fmt::format("the gap is nowhere found below the approach of {:.6g} m: it is {:.6g} m at the "
                  "origin and {:.6g} m at x = "
                  "{:.6g} m, y = {:.6g} m; the origin must be where the bodies first touch",
                  approach, origin.gap, best.gap, best.x, best.y));
}

// Whether the gap is less than the approach somewhere on one side of a box round a place: at 129
// points, or by golden sections beside the lowest of them, for a slender contact that crosses the
// side between two. side: 0 x_min, 1 x_max, 2 y_min, 3 y_max.
bool crosses_side(const Gap& gap, double approach, const Place& c,
                  const std::array<double, 4>& reach, std::size_t side) {
  constexpr double golden = 0.6180339887498949;
  const bool on_x = side < 2;
  const double at = side % 2 == 0 ? -reach[side] : reach[side];
  const auto value = [&](double t) {
    const double along =
        on_x ? -reach[2] + t * (reach[2] + reach[3]) : -reach[0] + t * (reach[0] + reach[1]);
    return on_x ? value_at(gap, c.x + at, c.y + along) : value_at(gap, c.x + along, c.y + at);
  };
  double least = units::infinity, lowest = 0;
  for (int k = 0; k <= 128; ++k)
    if (const double f = value(k / 128.0); f < least) least = f, lowest = k / 128.0;
  double low = std::max(0.0, lowest - 1 / 128.0), high = std::min(1.0, lowest + 1 / 128.0);
  for (int k = 0; k < 30 && !(least < approach); ++k) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    const double f_left = value(left), f_right = value(right);
    least = std::min({least, f_left, f_right});
    (f_left <= f_right ? high : low) = f_left <= f_right ? right : left;
  }
  return least < approach;
}

}  // namespace

Box interpenetration_box(const Gap& gap, double approach) {
  constexpr double growth = 1.2;
  const Place centre = place_in_contact(gap, approach);
  std::array<double, 4> reach;
  reach.fill(std::max(1e-15, 1e-12 * std::hypot(centre.x, centre.y)));
  bool moved = true;
  while (moved) {
    moved = false;
    for (std::size_t side = 0; side < 4; ++side)
      while (crosses_side(gap, approach, centre, reach, side)) {
        reach[side] *= growth;
        moved = true;
        if (reach[side] > farthest)
          throw InputError("the bodies do not separate: the gap stays below the approach for 1 km");
      }
  }
  return {centre.x - reach[0], centre.x + reach[1], centre.y - reach[2], centre.y + reach[3]};
}

}  // namespace railbook::contact
