/***
{{fold}}
*/
#include <algorithm>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "large_motions.hpp"

namespace railbook::quality_chapter {

using quality::Motion;
using quality::StoppedBody;
using quality::Wave;

namespace {

constexpr int highest_order = 8;

double own_rate(const StoppedBody& body) {
  return 2 * units::pi * body.suspension.frequency;
}

// Whether a motion that begins with the wave stays between the stops from now on: the forced stroke
// and what is left of the free one together do not reach them.
bool stays_between(const StoppedBody& body, const Wave& wave, const Motion& m) {
  const auto [frequency, damping] = body.suspension;
  const Motion forced = quality::balanced_motion(body, wave, 0);
  const double x = m.x - forced.x, v = m.v - forced.v + damping * own_rate(body) * x;
  const double free = std::hypot(x, v / (own_rate(body) * std::sqrt(1 - damping * damping)));
  return wave.amplitude * stroke_gain(body.suspension, wave.frequency) + free < body.gap;
}

// Newton's method from a guess; order 0 when it finds no stable motion that reaches the limit.
LargeMotion settled_on(const StoppedBody& body, double limit, const Wave& wave, const Motion& guess,
                       int order) {
  const auto p = quality::periodic_motion(body, wave, guess, order);
  if (!p.converged || p.growth >= 1 || p.largest < limit) return {};
  for (int part = 1; part < order; ++part)  // a motion of a lower order that divides this one
    if (order % part == 0) {
      const auto end = quality::run(body, {{wave}, 0}, p.start, part / wave.frequency).end;
      if (std::abs(end.x - p.start.x) < 1e-6 * limit) return {};
    }
  return {order, wave, p.start, p.largest};
}

}  // namespace

// Each start runs in blocks of ten waves until it is forgotten or 30 s have passed; the free motion
// of the paper's vehicle has then decayed by a factor of e^-19.
std::vector<LargeMotion> find_large_motions(const StoppedBody& body, double limit, const Wave& wave,
                                            int side) {
  const double over = limit - body.gap;
  const double fastest =
      own_rate(body) * std::sqrt(limit * limit + body.kappa * over * over);  // of the free motion
  constexpr int block = 10;                                                  // waves
  const int blocks = static_cast<int>(std::max(3.0, 3 * wave.frequency));    // at least 30 s
  std::vector<LargeMotion> found;
  for (int i = 0; i < side * side; ++i) {
    const auto even = [&](int k) { return 2.0 * k / (side - 1) - 1; };
    Motion now{0, limit * even(i / side), fastest * even(i % side)};
    double largest = 0;
    bool small = false;
    for (int k = 0; k < blocks && !small; ++k) {
      const auto r = quality::run(body, {{wave}, 0}, now, block / wave.frequency);
      now = {0, r.end.x, r.end.v};
      largest = r.largest;
      small = !r.complete || stays_between(body, wave, now);
    }
    const bool known = std::any_of(found.begin(), found.end(), [&](const LargeMotion& f) {
      return f.order == 0 || std::abs(f.largest - largest) < 1e-3 * limit;
    });
    if (small || largest < limit || known) continue;
    LargeMotion m{0, wave, now, largest};
    for (int order = 1; order <= highest_order && m.order == 0; ++order)
      if (const auto p = settled_on(body, limit, wave, now, order);
          p.order != 0 && std::abs(p.start.x - now.x) < 0.05 * limit)
        m = p;
    found.push_back(m);
  }
  return found;
}

LargeMotion least_amplitude(const StoppedBody& body, double limit, LargeMotion motion) {
  for (double step = 0.02; step > 1e-4;) {
    Wave lower = motion.wave;
    lower.amplitude *= 1 - step;
    const auto next = settled_on(body, limit, lower, motion.start, motion.order);
    if (next.order != 0 && std::abs(next.largest / motion.largest - 1) < 0.1)
      motion = next;
    else
      step /= 2;
  }
  return motion;
}

std::vector<LargeMotion> least_amplitudes(const StoppedBody& body, double limit,
                                          const LargeMotion& motion, const Range& range) {
  const LargeMotion first = least_amplitude(body, limit, motion);
  std::vector<LargeMotion> result{first};
  const auto neighbour = [&](const LargeMotion& at, int direction) -> LargeMotion {
    // Where the motion just exists, Newton's method is unsure: begin a little above.
    for (const double above : {1.0, 1.005, 1.02}) {
      Wave wave = at.wave;
      wave.amplitude *= above;
      const auto from = settled_on(body, limit, wave, at.start, at.order);
      for (const double step : {0.005, 0.001}) {
        if (from.order == 0) break;
        wave.frequency = (1 + direction * step) * at.wave.frequency;
        const auto next = settled_on(body, limit, wave, from.start, at.order);
        if (next.order != 0) return least_amplitude(body, limit, next);
      }
    }
    return {};
  };
  for (const int direction : {-1, 1})
    for (LargeMotion at = neighbour(first, direction);
         at.order != 0 && at.wave.amplitude <= range.amplitude && at.wave.frequency >= range.low &&
         at.wave.frequency <= range.high;
         at = neighbour(at, direction))
      result.push_back(at);
  std::sort(result.begin(), result.end(), [](const LargeMotion& a, const LargeMotion& b) {
    return a.wave.frequency < b.wave.frequency;
  });
  return result;
}

std::vector<LargeMotion> lowest_motions(const StoppedBody& body, double limit,
                                        const Search& search) {
  std::vector<LargeMotion> found;
  double least = units::infinity;
  const auto add_lowest = [&](const Wave& wave) {
    LargeMotion lowest;
    for (const LargeMotion& m : find_large_motions(body, limit, wave, search.side)) {
      const LargeMotion at = m.order == 0 ? m : least_amplitude(body, limit, m);
      if (lowest.largest == 0 || at.wave.amplitude < lowest.wave.amplitude) lowest = at;
    }
    if (lowest.largest == 0) return false;
    found.push_back(lowest);
    least = std::min(least, lowest.wave.amplitude);
    return true;
  };
  for (double f = search.low; f < search.high; f *= search.ratio) {
    if (std::isinf(least)) {  // up from the least that a body without stops would need
      double amplitude = limit / stroke_gain(body.suspension, f);
      while (amplitude < 1000 * limit && !add_lowest({amplitude, f, 0})) amplitude *= 1.1;
    }
    if (std::isinf(least)) continue;
    for (const double fraction : search.fractions)
      while (add_lowest({fraction * least, f, 0})) continue;
  }
  // The lowest of each order once more, in fine steps of frequency.
  for (int order = 1; order <= highest_order; ++order) {
    LargeMotion lowest;
    for (const LargeMotion& m : found)
      if (m.order == order && (lowest.order == 0 || m.wave.amplitude < lowest.wave.amplitude))
        lowest = m;
    if (lowest.order == 0) continue;
    const double f = lowest.wave.frequency;
    for (const LargeMotion& m : least_amplitudes(
             body, limit, lowest, {0.8 * f, search.ratio * f, 2 * lowest.wave.amplitude}))
      found.push_back(m);
  }
  std::sort(found.begin(), found.end(), [](const LargeMotion& a, const LargeMotion& b) {
    return a.wave.frequency < b.wave.frequency;
  });
  std::vector<LargeMotion> result;
  for (const LargeMotion& m : found)
    if (result.empty() || m.wave.amplitude < result.back().wave.amplitude) result.push_back(m);
  return result;
}

EnergyBalance energy_balance(const StoppedBody& body, double swing, int order) {
  // A quarter of the free motion: from the turning point to the stop, and from there to the middle.
  const double soft = own_rate(body), hard = soft * std::sqrt(1 + body.kappa);
  const double centre = body.kappa * body.gap / (1 + body.kappa);
  const double on = std::acos((body.gap - centre) / (swing - centre)) / hard;
  const double rate = (swing - centre) * hard * std::sin(hard * on);  // when the stop is left
  const double between = std::atan2(body.gap * soft, rate) / soft;
  const double period = 4 * (on + between), w = order * 2 * units::pi / period;
  constexpr int parts = 1000;
  double square = 0, wave_part = 0;  // means of v^2 and of v sin(w t)
  for (int i = 0; i < parts; ++i) {
    const double t = (i + 0.5) / parts * period / 4, rest = on + between - t;
    const double v = t < on ? (swing - centre) * hard * std::sin(hard * t)
                            : std::hypot(body.gap * soft, rate) * std::cos(soft * rest);
    square += v * v / parts;
    wave_part += v * std::sin(w * t) / parts;
  }
  return {w / (2 * units::pi),
          2 * body.suspension.damping * soft * square / (w * w * std::abs(wave_part))};
}

}  // namespace railbook::quality_chapter
