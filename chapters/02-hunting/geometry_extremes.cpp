/***
How much a gauge's noise spoils the geometry, on points 0.5 mm apart of CN profile A on the new rail, splined through
all points or smoothed:

{{gauge-noise}}

Through all points even a tenth of a micrometre makes the contact hop from ripple to ripple; the conicity, an average,
minds much less. Smoothing by three times the noise removes the hops, but from some 10 µm on it begins to flatten the
profile itself.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "geometry.hpp"
#include "items.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"
#include "wheelrail/conicity.hpp"
#include "wheelrail/measured_curve.hpp"
#include "wheelrail/tabulate.hpp"

using namespace railbook;
using namespace railbook::hunting_chapter;
using namespace railbook::wheelrail;
using units::inch;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

const char* holds(double error, double allowed) {
  return error <= allowed ? "holds" : "fails";
}

// A wheel with one hollow arc on a rail with one crown, both level in the middle of the head.
WheelsetOnTrack hollow_on_crown(double hollow, double crown) {
  const auto centred = [](const Curve& curve) {
    const Point top = curve.point_at_angle(0.02);
    return moved(curve, -0.75 - top.u, -top.z);
  };
  const Curve wheel = centred(chain({0, 0}, -0.05, {arc(hollow, 0.15), arc(0.02, 1.2)}));
  const Curve rail =
      centred(chain({0, 0}, -0.3, {arc(0.05, -0.06), arc(crown, 0.1), arc(0.01, 1.4)}));
  return with_radius(wheel, rail, 0.46);
}

double slope_by_closed_form(double hollow, double crown) {
  const double t = std::tan(0.02), c = std::cos(0.02), k = t / (0.75 - 0.46 * t);
  return (1 + (0.46 + crown * c) * k) / ((hollow - crown) * c);
}

void conforming(report::Item& item, const char* id, double excess) {
  const double crown = 0.3, hollow = crown * (1 + excess);
  const WheelsetOnTrack pair = hollow_on_crown(hollow, crown);
  const double h = 1e-3 * (hollow - crown);  // the contact runs 1/1000 of a radius
  const double slope = pair.contact(h).left.delta - pair.contact(-h).left.delta;
  const double error = std::abs(slope / (2 * h) / slope_by_closed_form(hollow, crown) - 1);
  item.stability(id, fmt::format("hollow's radius {:.7g} of the crown's", 1 + excess),
                 "relative curvature goes to zero: the contact runs over the head",
                 fmt::format("slope of the contact angle {:.4g} rad/mm", 1e-3 * slope / (2 * h)),
                 error, holds(error, 1e-3));
}

void two_points(report::Item& item) {
  const auto jump = contact_jumps(new_wheel_pair(), 0, 0.75 * inch, 1e-4).front();
  double worst = 0;
  for (const double dx : {-1e-13, 0.0, 1e-13}) {
    const auto at = new_wheel_pair().contact(jump.x + dx);
    worst = std::max(
        worst, at.converged ? std::abs(at.height - new_wheel_pair().contact(jump.x).height) : 1.0);
  }
  item.stability("two-point", "new wheel at its jump, and 1e-13 m to either side",
                 "two places are equally near: Newton's slope jumps",
                 fmt::format("closes on one or the other; x = {:.9f} in", jump.x / inch), worst,
                 holds(worst, 1e-13));
}

void sharper_wheel(report::Item& item) {
  const WheelsetOnTrack pair = hollow_on_crown(0.25, 0.3);
  const auto jumps = contact_jumps(pair, -2e-3, 2e-3, 1e-4);
  item.stability(
      "sharper-wheel", "hollow rounder than the crown",
      "a smooth contact in the hollow is impossible",
      fmt::format("touches at the hollow's edges; {} jumps within 2 mm, largest {:.3f} rad",
                  jumps.size(),
                  jumps.empty() ? 0.0 : std::abs(jumps[0].after.delta - jumps[0].before.delta)),
      none, jumps.empty() ? "fails" : "degraded");
}

void level_lines(report::Item& item) {
  const Curve wheel = moved(chain({0, 0}, 0, {line(0.08), arc(0.02, 1.2)}), -0.8, 0);
  const Curve rail =
      moved(chain({0, 0}, -0.4, {arc(0.05, 0), line(0.03), arc(0.01, 1.4)}), -0.785, 0);
  const WheelsetOnTrack pair = with_radius(wheel, rail, 0.46);
  double worst = 0;
  for (const double x : {-3e-3, 0.0, 3e-3})
    worst = std::max(worst, std::abs(pair.contact(x).left.radius - 0.46));
  item.stability(
      "level", "cylinder on a flat rail", "a whole line touches: the place is not unique",
      "one of its ends is reported; radius and roll are right", worst, holds(worst, 1e-14));
}

void beyond(report::Item& item) {
  const auto off = cn_pair().contact(0.5);
  item.stability("derailed", "x = 0.5 m", "wheel and rail do not overlap any more",
                 off.converged ? "a contact" : "not converged, no number", none,
                 off.converged ? "fails" : "refused");
  std::string said = "no refusal";
  try {
    (void)tabulate(cn_pair(), {29.76 * inch, 4 * inch, 0.01 * inch, 0});
  } catch (const InputError& error) {
    said = error.what();
  }
  item.stability("too-far", "a table up to 4 in", "the flange's tip ends", said, none,
                 said == "no refusal" ? "fails" : "refused");
}

// Noise of a gauge, the same in every run: a low-discrepancy sequence, uniform, of the rms given.
std::vector<Point> noisy(const Curve& curve, double rms) {
  std::vector<Point> points;
  double phase = 0.5;
  for (double u = curve.start().u; u < curve.end().u; u += 0.5e-3 * std::cos(curve.angle(u))) {
    phase = std::fmod(phase + 0.6180339887498949, 1.0);
    points.push_back({u, curve.height(u) + std::sqrt(12.0) * rms * (phase - 0.5)});
  }
  return points;
}

struct Found {
  double conicity;
  std::size_t jumps;
};

// Equivalent conicity at 3 mm, and two-point contacts, from noisy points.
Found from_noisy_points(double rms, double smoothing) {
  const WheelsetOnTrack pair(measured_curve(noisy(cn_pair().wheel(), rms), smoothing).curve,
                             measured_curve(noisy(cn_pair().rail(), rms), smoothing).curve);
  const auto table = tabulate(pair, {29.76 * inch, 0.4 * inch, 0.0025 * inch, 0});
  return {conicity(table, 3e-3).kinematic,
          contact_jumps(pair, -0.4 * inch, 0.4 * inch, 1e-4).size()};
}

void gauge_noise(report::Item& item) {
  const double drawn = conicity(cn_table(), 3e-3).kinematic;
  item.columns({"noise, rms", "conicity at 3 mm, through all points", "two-point contacts",
                "smoothed by the noise", "two-point contacts", "by three times the noise",
                "two-point contacts"});
  item.add_row({"drawn", fmt::format("{:.4f}", drawn), "0", "", "", "", ""});
  for (const double rms : {0.1e-6, 1e-6, 3e-6, 10e-6, 30e-6}) {
    const Found raw = from_noisy_points(rms, 0), smooth = from_noisy_points(rms, rms),
                smoother = from_noisy_points(rms, 3 * rms);
    item.add_row({fmt::format("{:g} µm", rms * 1e6), fmt::format("{:.4f}", raw.conicity),
                  fmt::format("{}", raw.jumps), fmt::format("{:.4f}", smooth.conicity),
                  fmt::format("{}", smooth.jumps), fmt::format("{:.4f}", smoother.conicity),
                  fmt::format("{}", smoother.jumps)});
    if (rms != 10e-6) continue;
    const auto row = [&](const char* id, const char* what, const Found& found, bool wanted) {
      const double error = std::abs(found.conicity / drawn - 1);
      item.stability(id, what, "contact sees curvature: noise over the square of the spacing",
                     fmt::format("{} two-point contacts where there are none", found.jumps), error,
                     wanted ? holds(error, 0.05) : "degraded");
    };
    row("noise", "10 µm of noise on points 0.5 mm apart", raw, false);
    row("noise-smoothed", "the same, smoothed by three times as much", smoother, true);
  }
}

void geometry_extremes(report::Item& item) {
  item.explained("our own study: the paper does not say how its profiles were smoothed");
  two_points(item);
  conforming(item, "conforming", 1e-2);
  conforming(item, "very-conforming", 1e-6);
  sharper_wheel(item);
  level_lines(item);
  beyond(item);
  gauge_noise(item);
}

}  // namespace

void hunting_chapter::add_geometry_extremes(report::Chapter& chapter) {
  chapter.table("gauge-noise", "Conicity from noisy points", geometry_extremes);
}
