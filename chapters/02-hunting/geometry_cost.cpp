/***
### Of the geometry

The contact angle of the left CN wheel, {{cost-x}} off centre, by three routes: the arcs themselves; a grid of places
on the wheel, as the paper's generation of programs and many since did it (least height on the grid, then the vertex
of the parabola through three places, with bisection and secants for the roll); and points measured on the same
profiles, splined and turned into arcs. The reference solves the closing of the two gaps for the four arcs in contact
in closed form, with the long double type.

{{geometry-time}}

{{work-precision: geometry-time}}

The exact search takes {{exact-time}} a displacement and its error is rounding. The grid needs {{grid-points}} places
to come within {{grid-error}} of the angle, and {{grid-time}} for it; it can also miss a second contact that lies
between two places. Points without noise do nearly as well as the arcs, here in the middle of an arc (where the
curvature jumps, their error falls with the square of the spacing); with the noise of a gauge they are another matter,
see {{gauge-noise}}.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "bench/work_precision.hpp"
#include "geometry.hpp"
#include "items.hpp"
#include "num/roots.hpp"
#include "units/constants.hpp"
#include "wheelrail/measured_curve.hpp"

using namespace railbook;
using namespace railbook::hunting_chapter;
using namespace railbook::wheelrail;
using units::inch;

namespace {

constexpr double at_x = 0.1 * inch;

const Piece& piece_at(const Curve& curve, double u) {
  for (const Piece& p : curve.pieces())
    if (u <= p.end.u) return p;
  return curve.pieces().back();
}

// The contact angle of the left wheel where arc meets arc on both sides: the least gap of two arcs is that of
// their centres, and the roll that closes both comes from secants.
double closed_form_angle(const WheelsetOnTrack& pair, double x) {
  using Long = long double;
  const auto seen = pair.contact(x);
  struct Arcs {
    Piece wheel, rail;
    Long sine, gap;
  };
  const auto arcs = [&](const SideContact& at) {
    return Arcs{piece_at(pair.wheel(), at.on_wheel.u), piece_at(pair.rail(), at.on_rail.u), 0, 0};
  };
  Arcs left = arcs(seen.left), right = arcs(seen.right);
  const auto solve = [](Arcs& a, Long shift, Long phi) {
    const Long s = std::sin(phi), c = std::cos(phi);
    const Long u = a.wheel.centre.u * c + a.wheel.centre.z * s - shift,
               z = a.wheel.centre.z * c - a.wheel.centre.u * s;
    const Long radius = Long(a.wheel.radius) - a.rail.radius, across = a.rail.centre.u - u;
    a.sine = across / radius;
    a.gap = z - a.rail.centre.z + std::sqrt(radius * radius - across * across);
  };
  const auto open = [&](Long phi) {
    solve(left, x, phi);
    solve(right, -x, -phi);
    return left.gap - right.gap;
  };
  Long before = 0, phi = 1e-3L, f_before = open(before), f = open(phi);
  for (int i = 0; i < 30 && f != f_before; ++i) {
    const Long next = phi - f * (phi - before) / (f - f_before);
    before = phi;
    f_before = f;
    phi = next;
    f = open(phi);
  }
  return double(std::asin(left.sine) - phi);
}

// The same by comparing heights at `n` places of the wheel.
class Grid {
 public:
  Grid(const WheelsetOnTrack& pair, int n) : pair_(pair) {
    const double from = pair.wheel().start().u, to = pair.wheel().end().u;
    for (int i = 1; i < n; ++i) {
      const double u = from + (to - from) * i / n;
      places_.push_back({u, pair.wheel().height(u)});
    }
  }

  bench::Outcome angle(double x) {
    heights_ = 0;
    const auto open = [&](double phi) { return least(x, phi).gap - least(-x, -phi).gap; };
    const auto roll = num::find_root(open, -5e-3, 5e-3, 1e-13);
    const double angle = pair_.wheel().angle(least(x, roll.x).u);
    return {.values = {angle}, .work = double(heights_), .reason = ""};
  }

 private:
  struct Least {
    double gap, u;
  };
  Least least(double x, double phi) {
    const double s = std::sin(phi), c = std::cos(phi);
    std::vector<double> gaps(places_.size(), 1);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Point& p = places_[i];
      const double across = p.u * c + p.z * s - x;
      if (across > pair_.rail().start().u && across < pair_.rail().end().u)
        gaps[i] = p.z * c - p.u * s - pair_.rail().height(across);
    }
    heights_ += long(places_.size());
    const auto k = std::size_t(std::ranges::min_element(gaps) - gaps.begin());
    if (k == 0 || k + 1 == gaps.size()) return {gaps[k], places_[k].u};
    const double step = places_[1].u - places_[0].u, down = gaps[k] - gaps[k - 1],
                 up = gaps[k + 1] - gaps[k];
    if (!(up - down > 0)) return {gaps[k], places_[k].u};
    const double t = -0.5 * (up + down) / (up - down);
    return {gaps[k] + 0.25 * t * (up + down), places_[k].u + t * step};
  }

  const WheelsetOnTrack& pair_;
  std::vector<Point> places_;
  long heights_ = 0;
};

// Points `step` apart along the profile, up to where it is too steep for a gauge.
std::vector<Point> gauge_points(const Curve& curve, double step) {
  std::vector<Point> points;
  for (double u = curve.start().u; u < curve.end().u && curve.angle(u) < 1.3;) {
    points.push_back({u, curve.height(u)});
    u += step * std::cos(curve.angle(u));
  }
  return points;
}

bench::Outcome exact(const WheelsetOnTrack& pair) {
  const auto at = pair.contact(at_x);
  const double pieces = double(pair.wheel().pieces().size() + pair.rail().pieces().size());
  return {.values = {at.left.delta},
          .work = pieces * at.evaluations,
          .converged = at.converged,
          .reason = ""};
}

void cost_geometry(report::Item& item) {
  const WheelsetOnTrack& pair = cn_pair();
  const bench::Method drawn{"arcs exactly", {{"as drawn", [&] { return exact(pair); }}}};
  bench::Method grid{"grid and parabola", {}}, measured{"measured points", {}};
  for (const int n : {250, 1000, 4000, 16000, 64000}) {
    const auto search = std::make_shared<Grid>(pair, n);
    grid.settings.push_back(
        {fmt::format("{} places", n), [search] { return search->angle(at_x); }});
  }
  for (const double step : {4e-3, 2e-3, 1e-3, 0.5e-3, 0.25e-3, 0.125e-3}) {
    const auto points =
        std::make_shared<WheelsetOnTrack>(measured_curve(gauge_points(pair.wheel(), step), 0).curve,
                                          measured_curve(gauge_points(pair.rail(), step), 0).curve);
    measured.settings.push_back(
        {fmt::format("{:g} mm apart", step * 1e3), [points] { return exact(*points); }});
  }
  const auto points =
      bench::measure("geometry-time", {{"contact angle", closed_form_angle(pair, at_x), 1e-15}},
                     {drawn, grid, measured}, item.timings(), 0.05);
  bench::show(item, points, "contact angle");
  item.value("cost-x", at_x / inch, "in", "{:.1f}");
  const auto microseconds = [](double seconds) { return 1e6 * seconds; };
  for (const auto& p : points) {
    if (p.method == drawn.name)
      item.value("exact-time", microseconds(p.seconds_min), "µs", "{:.1f}");
    if (p.method == grid.name && p.setting == "64000 places") {
      item.value("grid-points", 64000, "", "{:.0f}");
      item.value("grid-error", p.error, "", "{:.0e}");
      item.value("grid-time", microseconds(p.seconds_min) / 1e3, "ms", "{:.1f}");
    }
  }
  item.reconstructed("not in the paper: our own study of methods");
}

}  // namespace

void hunting_chapter::add_geometry_cost(report::Chapter& chapter) {
  chapter.figure("geometry-time", "Error against cost: where the wheel touches", cost_geometry);
}
