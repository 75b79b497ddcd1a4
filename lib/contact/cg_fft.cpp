#include <railbook/contact/cg_fft.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/contact/detail/extrapolation.hpp>
#include <railbook/contact/detail/grid_fit.hpp>
#include <railbook/contact/detail/missed.hpp>
#include <railbook/num/fft.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double phase_x = 0.9, phase_y = 0.4;  // half a cell apart: the irregular errors cancel
constexpr Index coarsest = 16;
constexpr std::size_t extrapolated = 3;  // grids, the finest ones
constexpr double start = 1e-5;           // the tolerance of the grids that only make a start

void check(double approach, double effective_modulus, const CgFftOptions& options) {
  units::require_finite("approach", approach, "m");
  units::require_positive("effective modulus", effective_modulus, "Pa");
  units::require_between("cells along x", static_cast<double>(options.nx), 4, 1e6);
  units::require_between("cells along y", static_cast<double>(options.ny), 4, 1e6);
  units::require_between("tolerance of the conjugate gradients", options.cg.tolerance, 1e-14, 0.1);
  const double bytes = memory_needed(options.nx, options.ny);
  if (bytes > options.memory_limit)
    throw InputError(fmt::format("a grid of {} x {} cells needs {:.3g} GB, the limit is {:.3g} GB",
                                 options.nx, options.ny, bytes / 1e9, options.memory_limit / 1e9));
}

// Number of cells of each grid of the ladder, coarse to fine: each has 1/sqrt 2 of the next one's
// along each axis. Halves are exact and rounded down, so that no direction of rounding decides.
std::vector<std::pair<Index, Index>> ladder(const CgFftOptions& options) {
  std::vector<std::pair<Index, Index>> sizes;
  double power = 1;  // of a half
  for (bool between = false;; between = !between) {
    const double scale = between ? power / std::sqrt(2.0) : power;
    const auto cells = [scale](Index n) {
      return static_cast<Index>(std::ceil(static_cast<double>(n) * scale - 0.5));
    };
    if (scale < 1 && std::min(cells(options.nx), cells(options.ny)) < coarsest) break;
    sizes.emplace_back(cells(options.nx), cells(options.ny));
    if (between) power /= 2;
  }
  std::ranges::reverse(sizes);
  return sizes;
}

// One grid solved from the start p, which becomes the solution; `contact` gathers work and failure.
CgFftLevel solve_grid(const Grid& grid, const VectorXd& f, double approach,
                      double effective_modulus, BoundedCgOptions options, VectorXd& p,
                      NormalContact& contact) {
  if (grid.cells() < 1 << 15) options.threads = 1;  // starting a thread takes longer than it saves
  Convolution a(grid, effective_modulus, options.threads);
  const BoundedCg cg = solve_bounded_cg(a, f, approach, p, options);
  contact.work += cg.work;
  contact.iterations += cg.iterations;
  if (!cg.converged) {
    contact.converged = false;
    contact.reason = fmt::format(
        "conjugate gradients stopped at a residual of {:.2g} after {} iterations on {} x {} cells",
        cg.residual, cg.iterations, grid.nx, grid.ny);
  }
  return {grid, describe(grid, p, f), cg.iterations, cg.residual};
}

// The start when nothing is known: an even pressure wherever the undeformed bodies overlap.
VectorXd uniform_start(const VectorXd& f, double approach, double effective_modulus) {
  const Index overlapping = (f.array() < approach).count();
  if (overlapping == 0) return VectorXd::Zero(f.size());
  return (f.array() < approach).select(VectorXd::Constant(f.size(), effective_modulus * 1e-3), 0.0);
}

void fill_cells(const Grid& grid, const VectorXd& p, NormalContact& contact) {
  const Index n = (p.array() > 0).count();
  contact.dx = VectorXd::Constant(n, grid.dx);
  contact.dy = VectorXd::Constant(n, grid.dy);
  contact.x.resize(n), contact.y.resize(n), contact.p.resize(n);
  Index k = 0;
  for (Index c = 0; c < grid.cells(); ++c) {
    if (!(p[c] > 0)) continue;
    contact.x[k] = grid.x(c % grid.nx);
    contact.y[k] = grid.y(c / grid.nx);
    contact.p[k++] = p[c];
  }
}

// One number of every level's region, coarse to fine.
template <class Read>
std::vector<double> of_levels(const std::vector<CgFftLevel>& levels, Read read) {
  std::vector<double> values;
  for (const CgFftLevel& level : levels)
    if (level.region.cells > 0) values.push_back(read(level));
  return values;
}

// Cells across the narrowest patch that carries a hundredth of the force or more.
double narrowest(const Region& region) {
  double cells = units::infinity;
  for (const PressurePatch& patch : region.patches)
    if (patch.force > 0.01 * region.force) cells = std::min(cells, patch.cells_across);
  return cells;
}

// The ends of the region and their errors. With the remedy they are extrapolated; the irregular
// part of an end keeps its place at the finest grid's.
void find_ends(const std::vector<CgFftLevel>& levels, const std::vector<double>& h, bool remedy,
               NormalContact& contact) {
  constexpr double order =
      1.25;  // seen: between 1 (the edge parallel to the cells) and 1.5 (averaged along it)
  const CgFftLevel& finest = levels.back();
  // What is left of an end, in cells, depends on how the edge meets the cells of each grid. Of
  // contacts of Hertz of 24 to 127 cells, to 1:10 and turned, tests/lib/contact/ends.cpp asks for
  // 97 in 100 within this.
  const double irregular = 0.05 + 2.5 / narrowest(finest.region);
  const auto end = [&](double Box::*side, double cell, double& error) {
    const double there = finest.region.ends.*side;
    const Extrapolated limit = extrapolate(
        h, of_levels(levels, [&](const auto& l) { return l.region.ends.*side; }), order);
    const double moved = std::clamp(limit.value - there, -0.5 * cell, 0.5 * cell);
    error = std::max(error, irregular * cell + (remedy ? 0.3 : 1) * std::abs(moved));
    return there + (remedy ? moved : 0);
  };
  contact.x_min = end(&Box::x_min, finest.grid.dx, contact.x_end_error);
  contact.x_max = end(&Box::x_max, finest.grid.dx, contact.x_end_error);
  contact.y_min = end(&Box::y_min, finest.grid.dy, contact.y_end_error);
  contact.y_max = end(&Box::y_max, finest.grid.dy, contact.y_end_error);
}

// The irregular part of the error of a force or a peak pressure, as a share of it: it depends on
// how the edge meets the cells and may vanish by chance from the differences of a few grids. An
// edge misplaced by e takes K e^2 off the force per length, to a factor, where p = K
// sqrt(distance): hence in proportion to K. Seen in random contacts of any slenderness and
// direction, rounded punches among them, N cells across: nine tenths within 2.3 N^-2.5 times K over
// Hertz's, all within 6.2; within 12 N^-1.7 where the pressure ends steeply, and K is not seen.
double irregular_error(const Region& region) {
  const bool edge = region.meets_body_edge || region.ends_steeply;
  double error = 0;
  for (const PressurePatch& patch : region.patches) {
    const double cells = std::max(patch.cells_across, 1.0);  // a single row has no second moment
    error += patch.force / region.force *
             (edge ? 12 * std::pow(cells, -1.7)
                   : 2 * std::max(1.0, patch.edge_intensity) * std::pow(cells, -2.5));
  }
  return error;
}

// What a grid cannot say at any accuracy: a patch narrower than its cells can tell, and the peak at
// an edge.
void add_warnings(const Region& region, NormalContact& contact) {
  constexpr double fewest = 5;
  const double cells = narrowest(region);
  if (cells < fewest) {
    contact.force_error = contact.p_max_error = units::infinity;
    contact.x_end_error = contact.y_end_error = units::infinity;
    if (region.patches.size() >
        1) {  // the sums of this grid: such patches scatter from grid to grid
      contact.force = region.force, contact.p_max = region.p_max;
      contact.moment_x = region.moment_x, contact.moment_y = region.moment_y;
    }
    contact.reason = fmt::format(
        "under-resolved: the contact is {:.1f} cells wide at its narrowest, a grid along its axes "
        "or finer "
        "is needed",
        cells);
  } else if (region.meets_body_edge) {
    contact.p_max = region.p_max;
    contact.p_max_error = units::infinity;
    contact.reason = "singular edge: the peak pressure grows without bound as the grid is refined";
  } else if (region.ends_steeply) {
    contact.p_max_error = units::infinity;
    contact.reason =
        "under-resolved edge: the pressure ends within a cell or two, its peak there is not seen";
  }
}

// Fills everything but the cells from the levels; with `remedy`, extrapolated to cells of no size.
void summarise(const std::vector<CgFftLevel>& levels, bool remedy, NormalContact& contact) {
  const Region& finest = levels.back().region;
  const double order = finest.meets_body_edge ? 1 : 2;
  const double width = finest.ends.x_max - finest.ends.x_min;
  const double height = finest.ends.y_max - finest.ends.y_min;
  const std::vector<double> h = of_levels(
      levels, [&](const auto& l) { return std::hypot(l.grid.dx / width, l.grid.dy / height); });
  const auto limit = [&](double Region::*number) {
    return extrapolate(h, of_levels(levels, [&](const auto& l) { return l.region.*number; }),
                       order);
  };
  const Extrapolated force = limit(&Region::force), peak = limit(&Region::p_max);
  contact.x_p_max = finest.x_p_max, contact.y_p_max = finest.y_p_max;
  contact.area = finest.area;
  contact.force = remedy ? force.value : finest.force;
  contact.moment_x = remedy ? limit(&Region::moment_x).value : finest.moment_x;
  contact.moment_y = remedy ? limit(&Region::moment_y).value : finest.moment_y;
  contact.p_max = remedy ? peak.value : finest.p_max;
  // Without the remedy the whole distance to the limit is error.
  const auto error = [&](const Extrapolated& v, double raw) {
    return (remedy ? v.error : std::abs(v.value - raw) + v.error) / std::abs(v.value) +
           irregular_error(finest);
  };
  // A peak that falls much from one cell to the next is rounded off by them.
  double drop = 0;
  for (const PressurePatch& patch : finest.patches)
    if (patch.p_max > 0.5 * finest.p_max) drop = std::max(drop, patch.peak_drop);
  contact.force_error = error(force, finest.force);
  contact.p_max_error = error(peak, finest.p_max) + 4 * drop * drop;
  find_ends(levels, h, remedy && !finest.meets_body_edge, contact);
  add_warnings(finest, contact);
}

// Fills result.contact from the levels and the pressures on the last of them.
void finish(const Grid& grid, const VectorXd& p, const VectorXd& f, bool remedy, CgFft& result) {
  const Region& region = result.levels.back().region;
  if (region.cells == 0) {
    // Bodies that come closer than the approach do touch: between the cells.
    result.contact.force_error = result.contact.p_max_error = units::infinity;
    if (result.contact.converged)
      result.contact.reason =
          "under-resolved: the contact is so narrow that no cell is in it, a grid along "
          "its axes or finer is needed";
    return;
  }
  fill_cells(grid, p, result.contact);
  result.outline = outline(grid, p, f);
  summarise(result.levels, remedy, result.contact);
  if (region.touches_edge()) {
    result.contact.converged = false;
    result.contact.reason = "the contact reaches the edge of the grid";
  }
}

// The box moved out by half its size on the sides that the region touches.
Box grown(const Grid& grid, const Region& region) {
  const double width = static_cast<double>(grid.nx) * grid.dx;
  const double height = static_cast<double>(grid.ny) * grid.dy;
  return {grid.x0 - (region.touches_x_min ? 0.5 * width : 0),
          grid.x0 + width * (region.touches_x_max ? 1.5 : 1),
          grid.y0 - (region.touches_y_min ? 0.5 * height : 0),
          grid.y0 + height * (region.touches_y_max ? 1.5 : 1)};
}

// Where the next grid goes: over a box that holds the contact, or fitted to the region once it is
// known.
struct Placement {
  Box box;
  bool fitted = false;
  bool sharp_x = false, sharp_y = false;  // the region ends with the body: cells end there too

  Grid grid(Index nx, Index ny, const CgFftOptions& options) const {
    const auto axis = [&](double low, double high, Index cells, double phase, auto edge) {
      return fitted ? fit_axis(low, high, cells, phase, edge) : cover_axis(low, high, cells, edge);
    };
    const Axis x = axis(box.x_min, box.x_max, nx, sharp_x ? 1 : phase_x, options.edge_x);
    const Axis y = axis(box.y_min, box.y_max, ny, sharp_y ? 1 : phase_y, options.edge_y);
    return {x.start, y.start, x.step, y.step, x.cells, y.cells};
  }

  // Widens the box to places where contact was missed.
  void hold(const std::vector<Point>& places) {
    for (const Point& place : places) {
      box.x_min = std::min(box.x_min, place.x), box.x_max = std::max(box.x_max, place.x);
      box.y_min = std::min(box.y_min, place.y), box.y_max = std::max(box.y_max, place.y);
    }
  }

  // Takes over the region seen on `grid`; its ends are moved to edges of the body found by
  // bisection.
  void refit(const Gap& gap, const Grid& grid, Region& region) {
    if (region.cells == 0 || std::min(grid.nx, grid.ny) < coarsest) return;
    Box& ends = region.ends;
    const double x = 0.5 * (ends.x_min + ends.x_max), y = 0.5 * (ends.y_min + ends.y_max);
    const auto sharpen = [&](double middle, double& end, double step, auto&& f) {
      double in = middle, out = end + step;
      if (std::isfinite(f(out)) || !std::isfinite(f(in))) return false;
      for (int k = 0; k < 60; ++k)
        (std::isfinite(f(0.5 * (in + out))) ? in : out) = 0.5 * (in + out);
      if (std::abs(in - end) > std::abs(step)) return false;
      end = in;
      return true;
    };
    const auto along_x = [&](double t) { return gap(t, y); };
    const auto along_y = [&](double t) { return gap(x, t); };
    const bool left = sharpen(x, ends.x_min, -grid.dx, along_x);
    const bool right = sharpen(x, ends.x_max, grid.dx, along_x);
    const bool below = sharpen(y, ends.y_min, -grid.dy, along_y);
    const bool above = sharpen(y, ends.y_max, grid.dy, along_y);
    sharp_x = left || right, sharp_y = below || above;
    box = ends;
    fitted = true;
  }
};

// Drops the places that a patch now holds.
void drop_found(const Grid& grid, const Region& region, std::vector<Point>& places) {
  std::erase_if(places, [&](const Point& place) {
    return std::ranges::any_of(region.patches, [&](const PressurePatch& patch) {
      const Box& ends = patch.ends;
      return place.x > ends.x_min - 2 * grid.dx && place.x < ends.x_max + 2 * grid.dx &&
             place.y > ends.y_min - 2 * grid.dy && place.y < ends.y_max + 2 * grid.dy;
    });
  });
}

}  // namespace

double CgFft::transform_pairs() const {
  if (levels.empty()) return 0;
  const auto padded = [](Index cells) {
    return static_cast<double>(num::good_frame_size(static_cast<std::size_t>(2 * cells - 1)));
  };
  const Grid& finest = levels.back().grid;
  return static_cast<double>(contact.work) / (padded(finest.nx) * padded(finest.ny));
}

CgFft solve_cg_fft(const Gap& gap, double approach, double effective_modulus,
                   const CgFftOptions& options) {
  check(approach, effective_modulus, options);
  if (approach <= 0) return {empty_contact(approach), {}, {}};
  CgFft result;
  result.contact.approach = approach;
  result.contact.converged = true;
  const Box whole = options.search ? options.search(approach) : interpenetration_box(gap, approach);
  Placement place{whole};
  Grid last;
  VectorXd p, f;
  std::vector<Point> missed, beside;  // `beside` the grids until the finest one had been solved
  std::vector<std::pair<Index, Index>> sizes = ladder(options);
  for (std::size_t level = 0, again = 0; level < sizes.size(); ++level) {
    const auto [nx, ny] = sizes[level];
    constexpr int most_growths = 40;
    for (int growths = 0;; ++growths) {
      const Grid grid = place.grid(nx, ny, options);
      f = sample(gap, grid);
      p = last.cells() > 0 ? transfer(last, p, grid)
                           : uniform_start(f, approach, effective_modulus);
      BoundedCgOptions cg = options.cg;
      if (level + extrapolated < sizes.size()) cg.tolerance = std::max(cg.tolerance, start);
      result.levels.push_back(
          solve_grid(grid, f, approach, effective_modulus, cg, p, result.contact));
      last = grid;
      const Region& region = result.levels.back().region;
      if (!region.touches_edge() || growths == most_growths) break;
      result.levels.pop_back();
      place = {grown(grid, region)};
    }
    Region& region = result.levels.back().region;
    const bool finest = level + 1 == sizes.size();
    if (level == 0 || finest)
      missed =
          missed_places(gap, approach, effective_modulus, last, p, whole, finest ? 1e-3 : 0.02);
    drop_found(last, region, missed);
    place.refit(gap, last, region);
    place.hold(missed), place.hold(beside);
    if (finest && !missed.empty() && again++ < 2) {
      // Once more, with what lies beside the grid: all the grids that are extrapolated over, or
      // some would have a patch less.
      beside.insert(beside.end(), missed.begin(), missed.end());
      place.hold(beside);
      const std::size_t back = std::min(result.levels.size(), extrapolated);
      result.levels.resize(result.levels.size() - back);
      level -= back;
    }
  }
  finish(last, p, f, options.remedy, result);
  if (!missed.empty()) {
    result.contact.force_error = result.contact.p_max_error = units::infinity;
    result.contact.reason = fmt::format(
        "under-resolved: a further patch near x = {:.6g} m, y = {:.6g} m is narrower than the "
        "cells",
        missed.front().x, missed.front().y);
  }
  return result;
}

}  // namespace railbook::contact
