// Self-excited oscillators whose limit cycle is known to 80 bits: q'' + k q + f(q') = 0 with f of
// three straight pieces, -inner q' between -left and right, rising by `outer` beyond. Each piece is
// a damped spring, solved in closed form; the cycle is the fixed point of the return to q' = right,
// and Liouville's formula has its multiplier.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace railbook::tests {

struct ExactCycle {
  using Long = long double;
  Long k, inner, outer, left, right;
  struct Point {
    Long q, v;
  };
  struct Stretch {
    Long begin, length, damping, centre;
    Point from;
  };
  std::vector<Stretch>
      stretches{};  // from q' = right upwards: above, down, below, up; or above and back
  Long period = 0, multiplier = 0, low = 0, high = 0;

  ExactCycle(Long k_, Long inner_, Long outer_, Long left_, Long right_)
      : k(k_), inner(inner_), outer(outer_), left(left_), right(right_) {
    // Secants on the return map, from a start that spirals in.
    Long x = -3 * (left + right) * (1 / std::sqrt(k) + outer / k), gap = turned(x) - x;
    Long y = x + gap, next_gap = turned(y) - y;
    for (int n = 0; n < 200 && std::abs(gap) > 1e-18L * std::abs(x); ++n) {
      // Plain turns at first: the map may bend.
      const Long next =
          n < 8 || next_gap == gap ? y + next_gap : y - next_gap * (y - x) / (next_gap - gap);
      x = y, gap = next_gap, y = next;
      next_gap = turned(y) - y;
    }
    (void)turned(y);
    const Stretch& last = stretches.back();
    period = last.begin + last.length;
    Long damping = 0;
    for (const Stretch& s : stretches) damping += s.damping * s.length;
    multiplier = std::exp(-damping);
    high = extreme(stretches[1], 0, one_sided() ? turn(stretches[1]) : stretches[1].length);
    low = one_sided() ? extreme(stretches[1], turn(stretches[1]), stretches[1].length)
                      : extreme(stretches[3], 0, stretches[3].length);
  }

  Point at(Long t) const {
    t -= period * std::floor(t / period);
    std::size_t n = 0;
    while (n + 1 < stretches.size() && t > stretches[n + 1].begin) ++n;
    return flown(stretches[n], t - stretches[n].begin);
  }
  Long amplitude() const { return (high - low) / 2; }
  // It swings beyond `right` only.
  bool one_sided() const { return stretches.size() == 2; }

 private:
  Point flown(const Stretch& s, Long t) const {
    const Long h = s.damping / 2, d = h * h - k, x = s.from.q - s.centre, v = s.from.v;
    const Long w = std::sqrt(std::abs(d)), a = w * t;
    // Damped less, as much as, or more than critically: one function.
    const Long c = d < 0 ? std::cos(a) : std::cosh(a);
    const Long sine =
        a < 1e-5L ? t * (1 + d * t * t / 6) : (d < 0 ? std::sin(a) : std::sinh(a)) / w;
    const Long fade = std::exp(-h * t);
    return {s.centre + fade * (x * c + (v + h * x) * sine),
            fade * (v * c - (k * x + h * v) * sine)};
  }
  Long acceleration(const Stretch& s, const Point& p) const {
    return -k * (p.q - s.centre) - s.damping * p.v;
  }
  // The first time at which q'' = 0: q' obeys the same equation as q.
  Long turn(const Stretch& s) const {
    const Long h = s.damping / 2, d = h * h - k, w = std::sqrt(std::abs(d));
    const Long a = acceleration(s, s.from), slope = a / (k * s.from.v + h * a);
    if (d >= 0) {
      if (!(slope >= 0 && slope * w < 1)) return -1;
      return w * slope < 1e-6L ? slope : std::atanh(slope * w) / w;
    }
    const Long angle = std::atan(slope * w);
    return (angle < 0 ? angle + std::acos(Long{-1}) : angle) / w;
  }
  // Between two times with the level between them, by bisection and Newton.
  Long reach(const Stretch& s, Long from, Long to, Long level) const {
    const bool rising = flown(s, to).v > level;
    Long t = (from + to) / 2;
    for (int n = 0; n < 200; ++n) {
      const Point p = flown(s, t);
      ((p.v > level) == rising ? to : from) = t;
      Long next = t - (p.v - level) / acceleration(s, p);
      if (!(next >= from && next <= to)) next = (from + to) / 2;
      if (std::abs(next - t) <= 1e-19L * to) return next;
      t = next;
    }
    return t;
  }
  // The end of a stretch at `level`, which it crosses after its turn or, where there is none, on
  // its way.
  Long end(const Stretch& s, Long level, bool after_turn) const {
    const Long d = s.damping * s.damping / 4 - k,
               from = after_turn ? std::max(turn(s), Long{0}) : 0;
    Long to = from + 1 / (std::sqrt(k) + std::abs(s.damping));
    if (d < 0) to = after_turn ? from + std::acos(Long{-1}) / std::sqrt(-d) : turn(s);
    const bool above = flown(s, from + (to - from) / 1000).v > level;
    for (int n = 0; n < 200 && d >= 0 && (flown(s, to).v > level) == above; ++n) to *= 1.5L;
    return reach(s, from, to, level);
  }
  // Once round from (q, right).
  Long turned(Long q) {
    stretches.clear();
    Point p{q, right};
    Long t = 0;
    const Long shift = (inner + outer) / k;
    for (int n = 0; n < 4; ++n) {
      Stretch s{t, 0, n % 2 == 0 ? outer : -inner,
                n == 0   ? shift * right
                : n == 2 ? -shift * left
                         : 0,
                p};
      const Long top = n == 1 ? turn(s) : -1;
      const bool back = top > 0 && flown(s, top).v > -left;  // it does not get to the other side
      const Long level = n == 0 || n == 3 || back ? right : -left;
      s.length = end(s, level, n % 2 == 0 || back);
      p = {flown(s, s.length).q, level};
      t += s.length;
      stretches.push_back(s);
      if (back) break;
    }
    return p.q;
  }
  // Where q' = 0 between two times.
  Long extreme(const Stretch& s, Long from, Long to) const {
    return flown(s, reach(s, from, to, 0)).q;
  }
};

}  // namespace railbook::tests
