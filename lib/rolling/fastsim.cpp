#include <railbook/rolling/fastsim.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/rolling/detail/ellipse_cells.hpp>
#include <railbook/rolling/detail/linear_force.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
namespace {

using units::pi;

// Shares of mu N: the force, and the moment (over a) of a force across.
struct Shares {
  double force = 0;
  double moment = 0;
  double stick = 1;
};

// Parabolic bound. w: the length over a in which a traction at the rate of the leading edge would
// reach the bound's slope; a strip of half length l sticks over 2 l - w. With l = cos of the
// strip's angle all integrals over the strips are powers of cosines, from the angle at which
// sticking ends, sin t = w/2.
Shares parabolic(double w) {
  if (w >= 2) return {1, 0, 0};
  const double t = std::asin(w / 2), s = std::sin(t), k = std::cos(t);
  const double l1 = ((pi / 2 - t) + s * k) / 2;                                // of l
  const double l2 = k - k * k * k / 3;                                         // of l^2
  const double slid = 3 * t / 8 - std::sin(2 * t) / 4 + std::sin(4 * t) / 32;  // of l^3, full slip
  const double l3 = 3 * pi / 16 - slid;
  return {4 / pi * (2 * w * l2 - w * w * l1 + w * w * w / 6 * k + 4.0 / 3 * slid),
          -w / (3 * pi) * (8 * l3 - 12 * l2 * w + 6 * l1 * w * w - w * w * w * k),
          2 / pi * (2 * l1 - w * k)};
}

// Elliptic bound: every strip is like every other. e: slope of the traction over the bound's scale.
Shares elliptic(double e) {
  if (e > 1e100) return {1, 0, 0};
  const double q = 1 / (1 + e * e);  // the share of each strip that sticks
  const double scale = 3 / (2 * pi);
  const double moment = e * (2 * q * q - 8 * q * q * q / 3) - std::pow(4 * q * (1 - q), 1.5) / 3;
  return {2 / pi * (std::atan(e) + e * q), scale * 3 * pi / 8 * moment, q};
}

struct Pair {
  double x = 0, y = 0;
  double size() const { return std::hypot(x, y); }
};

// A traction that slides keeps the size of the bound and turns towards the slip, the faster the
// larger `pull`, the growth of a free traction over the bound. The slip itself turns from `before`
// to `now`. Exact for a slip that does not turn, and for small angles between the two.
Pair turned(const Pair& p, const Pair& before, const Pair& now, double pull, double bound) {
  const double from = std::atan2(before.y, before.x), to = std::atan2(now.y, now.x);
  const double turn = std::remainder(to - from, 2 * pi);
  const double behind = std::remainder(std::atan2(p.y, p.x) - from, 2 * pi);
  const double left = std::exp(-pull), lag = pull > 1e-8 ? -std::expm1(-pull) / pull : 1;
  const double start =
      (behind - turn / 2) / 2;  // half of the turn before the pull, the rest after it
  const double angle =
      to + 2 * std::atan2(std::sin(start) * left, std::cos(start)) - turn * (lag - left / 2);
  return {bound * std::cos(angle), bound * std::sin(angle)};
}

CreepForces no_friction(const LinearForce& f, const RollingCase& c) {
  CreepForces r;
  r.converged = true;
  r.stick_share = f.size == 0 && c.creepage.spin == 0 ? 1 : 0;
  return r;
}

}  // namespace

CreepForces fastsim_without_spin(const RollingCase& c, const KalkerCoefficients& k, Bound bound) {
  const LinearForce f = linear_force(c, k);
  if (c.creepage.spin != 0)
    throw InputError("spin creepage: FASTSIM's closed form is for creepage without spin");
  const double limit = c.friction * c.load;
  if (limit == 0) return no_friction(f, c);
  const Shares shares =
      bound == Bound::parabolic ? parabolic(3 * pi / 16 * f.reduced) : elliptic(pi / 4 * f.reduced);
  CreepForces r;
  r.fx = limit * shares.force * f.x;
  r.fy = limit * shares.force * f.y;
  r.mz = limit * c.a * shares.moment * f.y;
  r.stick_share = shares.stick;
  r.converged = true;
  return r;
}

CreepForces fastsim_grid(const RollingCase& c, const KalkerCoefficients& k,
                         const FastsimOptions& options) {
  const LinearForce f = linear_force(c, k);
  const EllipseCells cells(options.along, options.strips);
  const double limit = c.friction * c.load;
  if (limit == 0) return no_friction(f, c);
  // Tractions in mu N/(a b), x in a, y in b; slips are the growth of the traction per unit of x.
  const double scale = std::min(f.scale / limit, 1e100);
  const double wx = 0.375 * k.c11 * c.creepage.longitudinal * scale;
  const double wy = 0.375 * k.c22 * c.creepage.lateral * scale;
  const double ws = 4 / pi * k.c23 * std::sqrt(c.a) * std::sqrt(c.b) * c.creepage.spin * scale;
  CreepForces r;
  CellTractions keep(options.keep_tractions, cells, c);
  double fx = 0, fy = 0, mz = 0, stuck = 0;
  for (const EllipseCells::Strip& strip : cells.strips()) {
    const double h = 2 * strip.growth / options.along;
    const auto slip = [&](double x) { return Pair{wx - ws * (c.b / c.a) * strip.y, wy + ws * x}; };
    Pair p, sum;
    double sum_my = 0, last_bound = 0;
    bool slides = false;
    for (int i = 0; i < options.along; ++i) {
      const double x = strip.growth - (i + 0.5) * h;
      const double bound = options.bound == Bound::parabolic ? strip.parabolic * cells.parabolic(i)
                                                             : strip.elliptic * cells.elliptic(i);
      // From the middle of the last cell to that of this one; in the first from the edge, to half
      // way.
      const double step = i == 0 ? h / 2 : h;
      const Pair w = slip(i == 0 ? x + h / 4 : x + h / 2);
      const Pair grown{p.x + w.x * step, p.y + w.y * step};
      const double size = grown.size();
      const bool slid = slides;
      slides = size > bound;
      if (!slides)
        p = grown;
      else if (slid)
        p = turned(p, slip(x + step), slip(x), w.size() * step / ((bound + last_bound) / 2), bound);
      else
        p = {grown.x * (bound / size), grown.y * (bound / size)};
      last_bound = bound;
      stuck += slides ? 0 : strip.weight;
      sum.x += p.x, sum.y += p.y, sum_my += p.y * x;
      keep.add(strip, x, p.x, p.y, bound, !slides);
    }
    fx += strip.weight * sum.x;
    fy += strip.weight * sum.y;
    mz += strip.weight * (sum_my * c.a - strip.y * sum.x * c.b);
  }
  r.fx = limit * fx, r.fy = limit * fy, r.mz = limit * mz;
  r.stick_share = stuck / pi;
  r.converged = true;
  r.tractions = keep.take();
  return r;
}

CreepForces fastsim(const RollingCase& c, const KalkerCoefficients& k,
                    const FastsimOptions& options) {
  if (c.creepage.spin == 0 && !options.keep_tractions)
    return fastsim_without_spin(c, k, options.bound);
  return fastsim_grid(c, k, options);
}

}  // namespace railbook::rolling
