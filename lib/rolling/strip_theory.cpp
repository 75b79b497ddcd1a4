#include <railbook/rolling/strip_theory.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/rolling/detail/ellipse_cells.hpp>
#include <railbook/rolling/detail/linear_force.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
namespace {

using units::pi;

// Integral of sqrt(d^2 - x^2) from `low` to `high`, both cut to [-d, d].
double half_disc(double d, double low, double high) {
  const auto primitive = [d](double x) {
    const double u = std::clamp(x / d, -1.0, 1.0);
    return d * d / 2 * (u * std::sqrt((1 - u) * (1 + u)) + std::asin(u));
  };
  return primitive(high) - primitive(low);
}

// In each strip Carter's tractions: the bound, less the same shape over the stick length 2 (l - q).
Tractions tractions(const RollingCase& c, const LinearForce& f, double q,
                    const StripOptions& options) {
  const EllipseCells cells(options.along, options.strips);
  CellTractions keep(true, cells, c);
  for (const EllipseCells::Strip& strip : cells.strips()) {
    const double l = strip.growth, d = l - q, h = 2 * l / options.along;
    for (int i = 0; i < options.along; ++i) {
      const double high = l - i * h, low = high - h;
      double p = strip.elliptic * cells.elliptic(i);
      const double bound = p;
      if (d > 0) p -= 1.5 / pi * half_disc(d, low - q, high - q) / h;
      keep.add(strip, (high + low) / 2, p * f.x, p * f.y, bound, d > 0 && (high + low) / 2 > q - d);
    }
  }
  return keep.take();
}

}  // namespace

CreepForces strip_theory(const RollingCase& c, const KalkerCoefficients& k,
                         const StripOptions& options) {
  const LinearForce f = linear_force(c, k);
  if (c.creepage.spin != 0)
    throw InputError(
        "spin creepage: the strip theory here is for creepage without spin; use fastsim or full");
  const double limit = c.friction * c.load;
  CreepForces r;
  r.converged = true;
  // The stick area's way back from the leading edge, in a; none is left from 1 on.
  const double q = std::min(1.0, 4 / (3 * pi) * f.reduced);
  const double t = std::asin(q), edge = std::cos(t);  // strips beyond the edge slide
  const double half = std::sin(t / 2);
  const double slid = 4 * half * half * half * half * (2 + edge) / 3;  // of l^2
  const double l1 = ((pi / 2 - t) + q * edge) / 2, l2 = edge - edge * edge * edge / 3;
  const double force = 1.5 * (2 * q * l1 - q * q * edge + slid);
  r.fx = limit * force * f.x;
  r.fy = limit * force * f.y;
  r.mz = -limit * c.a * 1.5 * q * (l2 - 2 * q * l1 + q * q * edge) * f.y;
  r.stick_share = 4 / pi * (l1 - q * edge);
  if (options.keep_tractions) r.tractions = tractions(c, f, q, options);
  return r;
}

}  // namespace railbook::rolling
