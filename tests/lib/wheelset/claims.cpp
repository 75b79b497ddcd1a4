// The accuracy that lib/profiles and lib/wheelset state, on seeded profiles, tables and places over
// their range.
#include <algorithm>
#include <cmath>
#include <vector>

#include <railbook/profiles/measured_curve.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/wheelset/conicity.hpp>
#include <railbook/wheelset/paper_pairs.hpp>
#include <railbook/wheelset/tabulate.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;
using namespace railbook::tests;

namespace {

// A chain of lines and arcs of either kind without corners, from a place and an angle; its joints
// in 80 bits.
struct Chain {
  std::vector<Step> steps;
  std::vector<std::array<Long, 2>> joints;  // after each step
  Point start;
  double angle = 0;
};
Chain random_chain(RandomStream& draw) {
  Chain c{{}, {}, {draw(-1, 1), draw(-1, 1)}, draw(-1, 1)};
  Long u = c.start.u, z = c.start.z;
  double angle = c.angle;
  for (int n = 0; n < 6; ++n) {
    if (draw(0, 1) < 0.3) {
      const double length = draw.decades(1e-4, 0.1);
      c.steps.push_back(line(length));
      u += length * std::cos(Long{angle}), z -= length * std::sin(Long{angle});
    } else {
      const double to = draw(-1.5, 1.5), radius = std::copysign(draw.decades(1e-3, 10), to - angle);
      c.steps.push_back(arc(radius, to));
      const Long middle = (Long{to} + angle) / 2,
                 chord = 2 * Long{radius} * std::sin((Long{to} - angle) / 2);
      u += chord * std::cos(middle), z -= chord * std::sin(middle);
      angle = to;
    }
    c.joints.push_back({u, z});
  }
  return c;
}

// Double-exponential quadrature.
template <class F>
Long integral(const F& f, Long a, Long b) {
  Long sum = 0;
  constexpr int half = 60;
  for (int k = -half; k <= half; ++k) {
    const Long t = k * Long{4.0} / half, s = long_pi / 2 * std::sinh(t),
               e = std::exp(-2 * std::abs(s));
    const Long near = (b - a) * e / (1 + e);  // distance from the nearer end
    if (near == 0) continue;
    const Long weight = long_pi / 2 * std::cosh(t) * 2 * e / ((1 + e) * (1 + e)) * (b - a);
    sum += weight * f(near, t > 0) * Long{4.0} / half;
  }
  return sum;
}

// One of the paper's pairs with the rails apart by a little more or less.
WheelsetOnTrack random_pair(RandomStream& draw) {
  const auto& pair = paper_pairs[static_cast<std::size_t>(draw(0, 2.999))].pair();
  return {pair.wheel(), moved(pair.rail(), draw(-2e-3, 2e-3), 0)};
}

}  // namespace

TEST_CASE("claim: odd tables") {
  Claim claim("wheelset::OddTable");
  RandomStream draw(1);
  for (int k = 0; k < 200; ++k) {
    const double step = draw.decades(1e-6, 1);
    std::vector<double> values{0};
    for (int n = 0; n < 2 + k % 20; ++n) values.push_back(draw(-1, 1));
    const OddTable table(step, values);
    const auto last = static_cast<int>(values.size()) - 2;
    for (int n = 0; n < 6; ++n) {
      // Anywhere, at the knots and beside them, and beyond the end.
      const double knot = step * static_cast<double>(static_cast<int>(draw(0, last + 1.99)));
      const double x = n % 3 == 0   ? draw(0, 2) * table.end()
                       : n % 3 == 1 ? knot
                                    : knot * (1 + draw(-1, 1) * draw.decades(1e-16, 1e-3));
      const Long at = Long{x} / step;
      const int i = std::clamp(static_cast<int>(std::floor(at)), 0, last);
      const auto below = static_cast<std::size_t>(i);
      const Long slope = Long{values[below + 1]} - values[below],
                 exact = values[below] + (at - i) * slope;
      claim.error(static_cast<double>(std::abs(table(x) - exact)) / (1 + x / table.end()));
      claim.error(std::abs(table(-x) + table(x)));
    }
  }
}

TEST_CASE("claim: chains of arcs and lines, moved and turned") {
  Claim ends("profiles::chain"), curve_claim("profiles::Curve"), shift("profiles::moved"),
      turn("profiles::turned");
  RandomStream draw(2);
  for (int k = 0; k < 300; ++k) {
    const Chain c = random_chain(draw);
    const Curve curve = chain(c.start, c.angle, c.steps);
    Long length = 3;
    for (const Step& s : c.steps) length += std::isinf(s.radius) ? s.length : std::abs(s.radius);
    for (std::size_t n = 0; n < c.steps.size(); ++n) {
      const Piece& p = curve.pieces()[n];
      ends.error(static_cast<double>(
          std::hypot(p.end.u - c.joints[n][0], p.end.z - c.joints[n][1]) / length));
    }
    for (int n = 0; n < 5; ++n) {
      const Piece& p = curve.pieces()[static_cast<std::size_t>(n)];
      const double share = draw(0, 1), u = p.start.u + share * (p.end.u - p.start.u);
      if (p.is_line()) {
        curve_claim.error(static_cast<double>(std::abs(
                              curve.height(u) - (p.start.z - (Long{u} - p.start.u) *
                                                                 std::tan(Long{p.angle_start})))) /
                          static_cast<double>(length));
        continue;
      }
      // Where it is steep a rounding of u is more of the height, and still more of the angle.
      const Long du = Long{u} - p.centre.u, root = std::sqrt((p.radius - du) * (p.radius + du)),
                 cosine = root / std::abs(Long{p.radius});
      curve_claim.error(static_cast<double>(
          std::abs(curve.height(u) - (p.centre.z + std::copysign(root, Long{p.radius}))) * cosine /
          length));
      curve_claim.error(
          static_cast<double>(std::abs(curve.angle(u) - std::asin(du / p.radius)) * cosine));
      const double angle = p.angle_start + share * (p.angle_end - p.angle_start);
      const Point at = curve.point_at_angle(angle);
      const double back = curve.angle(std::clamp(at.u, curve.start().u, curve.end().u));
      curve_claim.error(std::abs(back - angle) * std::cos(angle) * std::abs(p.radius) /
                        static_cast<double>(length));
    }
    const double du = draw(-2, 2), dz = draw(-2, 2), by = draw(-0.05, 0.05);
    const Curve aside = moved(curve, du, dz), leaning = turned(curve, by);
    for (std::size_t n = 0; n < 4; ++n) {
      const Piece &p = curve.pieces()[n], &q = aside.pieces()[n], &r = leaning.pieces()[n];
      shift.error(static_cast<double>(
                      std::hypot(q.end.u - (Long{p.end.u} + du), q.end.z - (Long{p.end.z} + dz))) /
                  static_cast<double>(length));
      const Long s = std::sin(Long{by}), cosine = std::cos(Long{by});
      turn.error(static_cast<double>(std::hypot(r.end.u - (cosine * p.end.u + s * p.end.z),
                                                r.end.z - (cosine * p.end.z - s * p.end.u)) /
                                     length));
      turn.error(std::abs(r.angle_end - p.angle_end - by));
    }
  }
}

TEST_CASE("claim: conicity of tables") {
  Claim claim("wheelset::conicity");
  RandomStream draw(3);
  for (int k = 0; k < 350; ++k) {
    // Radii that drive the wheelset back, with kinks, over decades.
    const double step = draw.decades(1e-4, 1e-2);
    std::vector<double> values{0};
    for (int n = 0; n < 6; ++n) values.push_back(values.back() + step * draw.decades(1e-3, 1));
    ConstraintFunctions pair;
    pair.half_spacing = draw(0.5, 1), pair.radius = draw(0.3, 0.6), pair.R = OddTable(step, values);
    // At a knot and next to one too.
    const double amplitude = k % 3 == 0 ? step * (1 + k % 6)
                             : k % 3 == 1
                                 ? step * (1 + k % 5) * (1 + draw(-1, 1) * draw.decades(1e-12, 0.1))
                                 : draw.decades(1e-3, 6) * step;
    const Conicity found = conicity(pair, std::min(amplitude, pair.R.end()));
    const Long A = found.amplitude;
    Long energy = 0, quarter = 0, first = 0, moment = 0;
    for (int n = 5; n >= 0; --n) {
      const Long low = n * Long{step}, high = std::min(A, (n + 1) * Long{step});
      if (!(high > low)) continue;
      const auto at = static_cast<std::size_t>(n);
      const Long slope = (Long{values[at + 1]} - values[at]) / step,
                 top = values[at] + (high - low) * slope;
      const auto R = [&](Long below) { return top - below * slope; };  // `below` the upper end
      quarter += integral(
          [&](Long near, bool upper) {
            const Long below = upper ? near : high - low - near;
            return 1 /
                   std::sqrt(2 / Long{pair.radius} * (energy + below * (top - below * slope / 2)));
          },
          low, high);
      first += integral(
          [&](Long near, bool upper) {
            const Long below = upper ? near : high - low - near, y = high - below;
            return R(below) * y / A / std::sqrt(((A - high) + below) * (A + y));
          },
          low, high);
      moment += integral(
          [&](Long near, bool upper) {
            const Long below = upper ? near : high - low - near;
            return R(below) * (high - below);
          },
          low, high);
      energy += (high - low) * (top + values[at]) / 2;
    }
    const Long number = 2 * long_pi / (4 * quarter), a = pair.half_spacing;
    claim.relative(found.kinematic, number * number * a * pair.radius);
    claim.relative(found.harmonic, 4 * a * first / (long_pi * A));
    claim.relative(found.regression, 3 * a * moment / (A * A * A));
  }
}

TEST_CASE("claim: measured points") {
  Claim noise("profiles::scatter"), curve_claim("profiles::measured_curve");
  RandomStream draw(4);
  for (int k = 0; k < 1000; ++k) {
    const double radius = std::copysign(draw.decades(0.05, 5), draw(-1, 1)),
                 sigma = draw.decades(1e-7, 2e-5);  // up to a tenth of the spacing
    std::vector<Point> points;
    for (int n = 0; n < 200; ++n) {
      const double u = -0.02 + 2e-4 * n;
      points.push_back({u, std::copysign(std::sqrt(radius * radius - u * u), radius) - radius +
                               draw.normal(sigma)});
    }
    noise.error(std::abs(scatter(points) / sigma - 1));
    // A circle through few points: off by less than h^3 over the square of the radius, but at the
    // ends.
    std::vector<Point> few;
    const int count = 20 + k % 40;
    const double h = 0.04 / count;
    for (int n = 0; n <= count; ++n) {
      const double u = -0.02 + h * n;
      few.push_back({u, std::copysign(std::sqrt(radius * radius - u * u), radius) - radius});
    }
    const Curve curve = measured_curve(few, 0).curve;
    double worst = 0;
    for (int n = 0; n < 20; ++n) {
      const double u = draw(-0.01, 0.01);
      worst = std::max(
          worst, std::abs(curve.height(u) -
                          (std::copysign(std::sqrt(radius * radius - u * u), radius) - radius)));
    }
    curve_claim.error(worst / (h * h * h / (radius * radius) + 1e-15));
  }
}

TEST_CASE("claim: where a wheelset touches, jumps and is tabulated") {
  Claim contact("wheelset::WheelsetOnTrack"), wheel("wheelset::placed_wheel"),
      rail("wheelset::placed_rail"), radius("wheelset::with_radius", 100),
      jump("wheelset::contact_jumps", 20), table("wheelset::tabulate", 765);
  RandomStream draw(5);
  long jumps = 0;
  for (int k = 0; k < 100; ++k) {
    const WheelsetOnTrack pair = random_pair(draw);
    for (int n = 0; n < 10; ++n) {
      const double x = draw(-0.015, 0.015);
      const WheelsetContact at = pair.contact(x);
      if (!at.converged || at.left.at_end || at.right.at_end) continue;
      // Each wheel's place of contact, rolled and shifted, is the rail's.
      double off = 0;
      for (const double side : {1.0, -1.0}) {
        const SideContact& c = side > 0 ? at.left : at.right;
        const Long phi = side * at.roll, s = std::sin(phi), cosine = std::cos(phi);
        const Long u = cosine * c.on_wheel.u + s * c.on_wheel.z - side * x,
                   z = cosine * c.on_wheel.z - s * c.on_wheel.u + at.height;
        off = std::max({off, static_cast<double>(std::hypot(u - c.on_rail.u, z - c.on_rail.z)),
                        std::abs(pair.rail().height(c.on_rail.u) - c.on_rail.z),
                        std::abs(pair.wheel().height(c.on_wheel.u) - c.on_wheel.z),
                        std::abs(c.radius + c.on_wheel.z)});
      }
      contact.error(off);
    }
    const double from = draw(0.1, 2);
    for (int n = 0; n < 10; ++n) {
      const double gauge = draw(1, 2), depth = draw.decades(5e-3, 0.014), cant = draw(-0.01, 0.01);
      const auto& drawn = paper_pairs[static_cast<std::size_t>(n % 3)].pair();
      const Curve placed = placed_rail(drawn.rail(), gauge, depth, cant);
      double top = -1;
      for (const Piece& p : placed.pieces()) {
        top = std::max({top, p.start.z, p.end.z});
        if (!p.is_line() && p.radius > 0 && p.angle_start * p.angle_end < 0)
          top = std::max(top, p.centre.z + p.radius);
      }
      rail.error(std::max(std::abs(top), std::abs(placed.height(-gauge / 2) + depth)));
      wheel.error(std::abs(placed_wheel(drawn.wheel(), from).pieces()[1].end.u -
                           (drawn.wheel().pieces()[1].end.u - from)));
    }
    const double wanted = draw(0.2, 0.8);
    const WheelsetOnTrack raised = with_radius(pair.wheel(), pair.rail(), wanted);
    radius.error(std::abs(raised.contact(0).left.radius - wanted));
    if (k % 3 == 0)
      for (const ContactJump& j : contact_jumps(pair, -0.012, 0.018, 1e-4)) {
        const auto below = pair.contact(j.x - 3e-12).left, above = pair.contact(j.x + 3e-12).left;
        jump.error(std::max(std::abs(below.on_wheel.u - j.before.on_wheel.u),
                            std::abs(above.on_wheel.u - j.after.on_wheel.u)));
        ++jumps;
      }
    if (k % 20 != 0) continue;
    TableOptions options{.half_spacing = draw(0.6, 0.8),
                         .end = 0.01,
                         .step = 2e-4,
                         .average = k % 40 == 0 ? 0 : 8e-4};
    const ConstraintFunctions found = tabulate(pair, options);
    const int half = k % 40 == 0 ? 0 : 2;
    for (int n = 0; n <= 50; ++n) {
      Long r = 0, d = 0, phi = 0, weights = 0;
      for (int m = -half; m <= half; ++m) {
        const Long w = half > 0 && std::abs(m) == half ? 0.5L : 1;
        const WheelsetContact at = pair.contact((n + m) * options.step);
        r += w * (Long{at.left.radius} - at.right.radius) / (2 * options.half_spacing),
            d += w * (Long{at.left.delta} - at.right.delta) / 2, phi += w * at.roll, weights += w;
      }
      const double x = n * options.step;
      table.error(static_cast<double>(std::abs(found.R(x) - r / weights)));
      table.error(static_cast<double>(std::abs(found.D(x) - d / weights)));
      table.error(static_cast<double>(std::abs(found.Phi(x) - phi / weights)));
    }
  }
  CHECK(jumps > 20);
}
