// Geometry of contact against closed forms and a brute-force search.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/units/constants.hpp>
#include <railbook/wheelset/paper_pairs.hpp>
#include <railbook/wheelset/tabulate.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;
using units::inch;

namespace {

struct Pair {
  const char* name;
  const WheelsetOnTrack& pair;
  double angle, wheel_radius, rail_radius;  // at the centred contact
};

std::vector<Pair> pairs() {
  return {{"new", new_wheel_pair(), 0.05, INFINITY, 6 * inch},
          {"CN", cn_pair(), 0.045, 14.3 * inch, 10 * inch},
          {"Heumann", heumann_pair(), 0.125, 8.9 * inch, 6 * inch}};
}

// The least gap by comparing heights at very many places, in the axle's own frame of the rolled
// wheelset.
double scanned_gap(const WheelsetOnTrack& pair, double x, double phi) {
  const double s = std::sin(phi), c = std::cos(phi);
  const Curve& wheel = pair.wheel();
  const auto gap_at = [&](double u) {
    const double z = wheel.height(u), across = u * c + z * s - x;
    if (across <= pair.rail().start().u || across >= pair.rail().end().u) return 1.0;
    return z * c - u * s - pair.rail().height(across);
  };
  const int n = 4000;
  const double from = wheel.start().u, step = (wheel.end().u - from) / n;
  double best = 1, at = 0;
  for (int i = 1; i < n; ++i)
    if (const double gap = gap_at(from + i * step); gap < best) best = gap, at = from + i * step;
  double low = at - step, high = at + step;
  for (int i = 0; i < 80; ++i) {  // golden section
    const double d = 0.381966 * (high - low), left = gap_at(low + d), right = gap_at(high - d);
    if (left < right)
      high -= d;
    else
      low += d;
    best = std::min({best, left, right});
  }
  return best;
}

}  // namespace

TEST_CASE("At the centre the three pairs have the slopes of the closed forms") {
  const double a = paper_track.half_spacing, r0 = paper_track.radius, h = 1e-7;
  for (const Pair& p : pairs()) {
    INFO(p.name);
    const auto at = p.pair.contact(0);
    REQUIRE(at.converged);
    CHECK(at.roll == Approx(0).margin(1e-15));
    CHECK(at.left.radius == Approx(r0).epsilon(1e-14));
    CHECK(at.left.delta == Approx(p.angle).epsilon(1e-13));
    CHECK(at.left.on_wheel.u == Approx(at.left.on_rail.u).epsilon(1e-14));
    const double y0 = -at.left.on_rail.u;
    const double roll = std::tan(p.angle) / (y0 - r0 * std::tan(p.angle));  // per displacement
    const auto moved_to = p.pair.contact(h);
    CHECK(moved_to.roll / h == Approx(roll).epsilon(1e-6));
    const double D = 0.5 * (moved_to.left.delta - moved_to.right.delta) / h;
    const double R = 0.5 * (moved_to.left.radius - moved_to.right.radius) / a / h;
    if (std::isfinite(p.wheel_radius)) {
      CHECK(R == Approx(std::sin(p.angle) * p.wheel_radius * D / a).epsilon(1e-6));
    } else {
      CHECK(D == Approx(0).margin(1e-8));
    }
  }
}

TEST_CASE("Left and right change places with the sign of the displacement") {
  for (const Pair& p : pairs())
    for (const double x : {0.1, 0.29, 0.407, 0.46, 0.6, 0.75}) {
      const auto one = p.pair.contact(x * inch), other = p.pair.contact(-x * inch);
      CHECK(one.roll == Approx(-other.roll).margin(1e-15));
      CHECK(one.left.radius == Approx(other.right.radius).epsilon(1e-14));
      CHECK(one.left.delta == Approx(other.right.delta).epsilon(1e-12));
      CHECK(one.height == Approx(other.height).epsilon(1e-15));
    }
}

TEST_CASE("Both gaps are closed, and no place of the profiles is closer") {
  for (const Pair& p : pairs())
    for (int k = 0; k <= 30; ++k) {
      const double x = 0.025 * k * inch;
      INFO(p.name << " at " << x / inch << " in");
      const auto at = p.pair.contact(x);
      REQUIRE(at.converged);
      CHECK(scanned_gap(p.pair, x, at.roll) == Approx(-at.height).margin(2e-14));
      CHECK(scanned_gap(p.pair, -x, -at.roll) == Approx(-at.height).margin(2e-14));
    }
}

// The profiles are chains of arcs chosen to what the paper's text says of the lost ones: chapter 02
// rests on this.
TEST_CASE("The paper's pairs have what its text says of them") {
  const ConstraintFunctions &fresh = new_wheel_table(), &cn = cn_table(),
                            &heumann = heumann_table();
  // The largest departure of R and Phi from their tangents at 0, as a part of the tangent's value
  // at the end.
  const auto bend = [](const ConstraintFunctions& table, double end) {
    double worst = 0;
    for (const OddTable* f : {&table.R, &table.Phi})
      for (double x = 0; x < end; x += f->step())
        worst = std::max(worst, std::abs(((*f)(x)-f->slope(0) * x) / (f->slope(0) * end)));
    return worst;
  };
  CHECK(bend(fresh, 0.39 * inch) < 1e-5);    // "nearly linear until" the flange
  CHECK(bend(cn, 0.32 * inch) < 0.1);        // "nearly linear until flange contact"
  CHECK(bend(heumann, 0.1 * inch) < 0.001);  // "approximately linear for small ... displacements"
  // "much steeper than those of either", "several times larger"
  CHECK(heumann.R.slope(0) > 1.4 * cn.R.slope(0));
  CHECK(heumann.D.slope(0) > 1.4 * cn.D.slope(0));
  CHECK(heumann.R.slope(0) > 2 * fresh.R.slope(0));
  CHECK(heumann.Phi.slope(0) > 2 * fresh.Phi.slope(0));
  // "closely approximates single-point contact"
  const auto largest_jump = [](const WheelsetOnTrack& pair) {
    double largest = 0;
    for (const auto& jump : contact_jumps(pair, 0, 0.75 * inch, 1e-4))
      largest = std::max(largest, std::abs(jump.after.delta - jump.before.delta));
    return largest;
  };
  CHECK(largest_jump(heumann_pair()) < 0.1 * largest_jump(new_wheel_pair()));
}
