#include <railbook/rolling/history.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/contact/grid.hpp>
#include <railbook/rolling/transient.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double most_steps = 1e5;
constexpr double least_error = 1e-6;  // of mu N: how well a force is met

double scale_of(const RollingCase& c, double load) {
  return std::cbrt(load / c.load);
}

// Cells over the contact under the largest load, with an empty column behind it.
contact::Grid grid_of(const RollingCase& c, double largest, Index along) {
  const double a = c.a * scale_of(c, largest), b = c.b * scale_of(c, largest);
  const double dx = 2 * a / static_cast<double>(along);
  const Index across = std::max<Index>(along / 2, 4);
  return {-a - dx, -b, dx, 2 * b / static_cast<double>(across), along + 1, across};
}

// The mean of Hertz's pressure over each cell: exact along rows at points of Gauss across them, and
// the load is met.
VectorXd hertz_cells(const contact::Grid& g, const RollingCase& c, double load) {
  const double a = c.a * scale_of(c, load), b = c.b * scale_of(c, load);
  // The integral of sqrt(h^2 - x^2) from 0 to x.
  const auto integral = [](double x, double h) {
    x = std::clamp(x, -h, h);
    return 0.5 * (x * std::sqrt(std::max(0.0, h * h - x * x)) + h * h * std::asin(x / h));
  };
  VectorXd p = VectorXd::Zero(g.nx * g.ny);
  constexpr int points = 8;
  for (Index j = 0; j < g.ny; ++j)
    for (int k = 0; k < points; ++k) {
      const double y = (g.y0 + (static_cast<double>(j) + (k + 0.5) / points) * g.dy) / b;
      if (y * y >= 1) continue;
      const double h = a * std::sqrt(1 - y * y);
      for (Index i = 1; i < g.nx; ++i) {
        const double x = g.x0 + static_cast<double>(i) * g.dx;
        p[j * g.nx + i] += integral(x + g.dx, h) - integral(x, h);
      }
    }
  return p * (load / (p.sum() * g.dx * g.dy));
}

HistoryRow between(const HistoryRow& from, const HistoryRow& to, double share) {
  const auto mean = [share](double x, double y) { return x + share * (y - x); };
  HistoryRow out;
  out.distance = mean(from.distance, to.distance);
  out.load = mean(from.load, to.load);
  out.creepage = {mean(from.creepage.longitudinal, to.creepage.longitudinal),
                  mean(from.creepage.lateral, to.creepage.lateral),
                  mean(from.creepage.spin, to.creepage.spin)};
  if (to.fx) out.fx = mean(from.fx.value_or(*to.fx), *to.fx);
  return out;
}

class Path {
 public:
  Path(const RollingCase& c, const std::vector<HistoryRow>& rows, const HistoryOptions& options,
       Index along, double largest)
      : case_(c),
        grid_(grid_of(c, largest, along)),
        contact_(grid_, hertz_cells(grid_, c, rows.front().load), c, options.dissimilarity),
        load_(rows.front().load) {
    shift(0, rows.front());
    double rolled = 0;  // cells
    for (std::size_t k = 1; k < rows.size() && good(); ++k) {
      const HistoryRow &from = rows[k - 1], &to = rows[k];
      if (to.distance == from.distance) {
        shift(static_cast<Index>(k), to);
        continue;
      }
      // The cells whose ends lie between the rows.
      const double start = from.distance - rows.front().distance;
      const double last = std::round((to.distance - rows.front().distance) / grid_.dx);
      for (; rolled < last && good(); ++rolled) {
        const double at = (rolled + 1) * grid_.dx;
        const double share = std::clamp((at - start) / (to.distance - from.distance), 0.0, 1.0);
        HistoryRow now = between(from, to, share);
        now.distance = rows.front().distance + at;
        roll(static_cast<Index>(k), now);
      }
    }
  }
  std::vector<HistoryStep> steps;

 private:
  bool good() const { return steps.empty() || steps.back().forces.converged; }
  void press(double load) {
    if (load == load_) return;
    contact_.press(hertz_cells(grid_, case_, load));
    load_ = load;
  }
  void shift(Index row, const HistoryRow& to) {
    press(to.load);
    HistoryStep s = start(row, to);
    s.shift_x = to.shift_x, s.shift_y = to.shift_y;
    if (to.fx) {
      const auto done = contact_.shift_for(*to.fx);
      s.forces = done.forces, s.shift_x = done.motion, s.shift_y = 0;
    } else {
      s.forces = contact_.shift(to.shift_x, to.shift_y);
    }
    keep(std::move(s));
  }
  void roll(Index row, const HistoryRow& to) {
    press(to.load);
    HistoryStep s = start(row, to);
    s.rolled = true;
    s.creepage = to.creepage;
    if (to.fx) {
      const auto done = contact_.roll_for(*to.fx, to.creepage.lateral, to.creepage.spin);
      s.forces = done.forces, s.creepage.longitudinal = done.motion;
    } else {
      s.forces = contact_.roll(to.creepage);
    }
    keep(std::move(s));
  }
  static HistoryStep start(Index row, const HistoryRow& to) {
    HistoryStep s;
    s.row = row, s.distance = to.distance, s.load = to.load;
    return s;
  }
  void keep(HistoryStep s) {
    s.forces.tractions = {};
    steps.push_back(std::move(s));
  }

  const RollingCase& case_;
  contact::Grid grid_;
  Transient contact_;
  double load_;
};

// A value less its error of first order in the cells, and what this changes.
double extrapolate(double& value, double coarse) {
  const double change = value - coarse;
  value += change;
  return std::abs(change);
}

// The fine path and one on cells of twice the size to cells of no size: at a row without rolling
// from the step there, on the way from the straight line between the coarse steps on either side.
// Half the change is the error.
void extrapolate(std::vector<HistoryStep>& fine, const std::vector<HistoryStep>& coarse,
                 const RollingCase& c, const std::vector<HistoryRow>& rows) {
  std::size_t at = 0;  // the first coarse step that is not before the fine one
  for (HistoryStep& s : fine) {
    const auto before = [&](const HistoryStep& o) {
      return o.row < s.row ||
             (o.row == s.row && o.distance < s.distance - 1e-9 * std::abs(s.distance));
    };
    while (at + 1 < coarse.size() && before(coarse[at])) ++at;
    const HistoryStep& next = coarse[at];
    const HistoryStep& last = at > 0 && s.rolled ? coarse[at - 1] : next;
    const double length = next.distance - last.distance;
    const double share =
        length > 0 ? std::clamp((s.distance - last.distance) / length, 0.0, 1.0) : 1;
    const auto mean = [&](double from, double to) { return from + share * (to - from); };
    CreepForces& f = s.forces;
    const double bound = c.friction * s.load, reach = std::sqrt(c.a * c.b) * scale_of(c, s.load);
    const double x = extrapolate(f.fx, mean(last.forces.fx, next.forces.fx));
    const double y = extrapolate(f.fy, mean(last.forces.fy, next.forces.fy));
    const double z = extrapolate(f.mz, mean(last.forces.mz, next.forces.mz));
    f.error = std::hypot(x, y) / (2 * bound) + least_error;
    f.mz_error = z / (2 * bound * reach) + least_error;
    if (const double size = std::hypot(f.fx, f.fy); size > bound)
      f.fx *= bound / size, f.fy *= bound / size;
    for (double* force : {&f.fx, &f.fy})
      if (std::abs(*force) < least_error * bound) *force = 0;
    if (std::abs(f.mz) < least_error * bound * reach) f.mz = 0;
    if (!rows[static_cast<std::size_t>(s.row)].fx) continue;
    if (!s.rolled) {
      s.motion_error = extrapolate(s.shift_x, next.shift_x) / 2;
    } else {  // the step before the first one rolled has no creepage
      const double from = (last.rolled ? last : next).creepage.longitudinal;
      s.motion_error =
          extrapolate(s.creepage.longitudinal, mean(from, next.creepage.longitudinal)) / 2;
    }
  }
}

void check_rows(const RollingCase& c, const std::vector<HistoryRow>& rows) {
  if (rows.empty()) throw InputError{"the history has no row"};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const HistoryRow& r = rows[k];
    const auto named = [k](const char* what) { return fmt::format("{} of row {}", what, k + 1); };
    RollingCase at = c;
    at.creepage = r.creepage;
    try {
      check(at);
    } catch (const InputError& e) {
      throw InputError{fmt::format("row {}: {}", k + 1, e.what())};
    }
    units::require_finite(named("distance"), r.distance, "m");
    if (k > 0 && r.distance < rows[k - 1].distance)
      throw InputError{fmt::format(
          "{} is {:.6g} m; allowed: not below the row before it, {:.6g} m: the contact rolls "
          "forward",
          named("distance"), r.distance, rows[k - 1].distance)};
    units::require_positive(named("load"), r.load, "N");
    units::require_finite(named("shift along"), r.shift_x, "m");
    units::require_finite(named("shift across"), r.shift_y, "m");
    const double bound = 0.999 * c.friction * r.load;
    if (r.fx) units::require_between(named("force along"), *r.fx, -bound, bound, "N");
  }
}

}  // namespace

std::vector<HistoryStep> roll_history(const RollingCase& c, const std::vector<HistoryRow>& rows,
                                      const HistoryOptions& options) {
  check(c);
  units::require_positive("friction", c.friction, "");
  check_rows(c, rows);
  if (options.along < 4 || options.along % 2 != 0)
    throw InputError{
        fmt::format("cells along is {}; allowed: an even number from 4", options.along)};
  double largest = 0;
  for (const HistoryRow& r : rows) largest = std::max(largest, r.load);
  const double dx = grid_of(c, largest, options.along).dx;
  const double steps =
      static_cast<double>(rows.size()) + (rows.back().distance - rows.front().distance) / dx;
  if (!(steps <= most_steps))
    throw InputError{fmt::format(
        "the history takes {:.3g} steps of a cell, {:.3g} m; allowed: up to {:g}; give fewer cells "
        "or a shorter way",
        steps, dx, most_steps)};
  Path fine(c, rows, options, options.along, largest);
  if (!options.extrapolate || !fine.steps.back().forces.converged) return std::move(fine.steps);
  const Path coarse(c, rows, options, options.along / 2, largest);
  if (coarse.steps.back().forces.converged) extrapolate(fine.steps, coarse.steps, c, rows);
  return std::move(fine.steps);
}

}  // namespace railbook::rolling
