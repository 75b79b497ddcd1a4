// The accuracy that lib/track states of moving loads, lumped tracks and passages over joints, on
// seeded inputs over its range: against residues, Taylor's series and closed forms in 80 bits, and
// another integrator.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/num/quadrature.hpp>
#include <railbook/track/impact_methods.hpp>
#include <railbook/track/impact_peaks.hpp>
#include <railbook/track/lumped.hpp>
#include <railbook/track/moving_load.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::track;
using namespace railbook::tests;

namespace {

const num::GaussRule rule = num::gauss_legendre(4, 0, 1);

using Complex = std::complex<Long>;

// p^4 + 4 theta^2 p^2 - 8 zeta theta p + 4 and its roots (Durand and Kerner's iteration).
struct Quartic {
  Long theta, zeta;
  Complex root[4];
  Quartic(double t, double z) : theta(t), zeta(z) {
    const Long bound = 2 * theta + std::cbrt(8 * zeta * theta) + 2;
    for (int i = 0; i < 4; ++i) root[i] = std::polar(bound, 0.4L + long_pi / 2 * i);
    for (int sweep = 0; sweep < 400; ++sweep) {
      Long change = 0;
      for (int i = 0; i < 4; ++i) {
        Complex others = 1;
        for (int j = 0; j < 4; ++j)
          if (j != i) others *= root[i] - root[j];
        const Complex by = at(root[i]) / others;
        if (!std::isfinite(by.real()) || !std::isfinite(by.imag())) continue;
        root[i] -= by;
        change = std::max(change, std::abs(by) / std::abs(root[i]));
      }
      if (change < 1e-18L) break;
    }
    std::sort(root, root + 4, [](Complex a, Complex b) { return a.real() < b.real(); });
  }
  Complex at(Complex p) const {
    return ((p * p + 4 * theta * theta) * p - 8 * zeta * theta) * p + Long{4};
  }
  // 8 times the residues of p^n exp(p s)/Q at the two roots of a side: s > 0 ahead. Around both at
  // once where they are close.
  Complex sum(Long s, int n) const {
    const int first = s >= 0 ? 0 : 2;
    const Long sign = s >= 0 ? 8 : -8;
    const Complex a = root[first], b = root[first + 1], middle = (a + b) / Long{2};
    Complex y = 0;
    if (std::abs(a - b) < 0.1L * std::abs(middle)) {
      constexpr int points = 64;
      for (int k = 0; k < points; ++k) {
        const Complex step = std::polar(0.45L * std::abs(middle), 2 * long_pi * k / points);
        const Complex p = middle + step;
        y += step / Long{points} * std::pow(p, n) * std::exp(p * s) / at(p);
      }
    } else {
      for (const Complex p : {a, b})
        y += std::pow(p, n) * std::exp(p * s) /
             ((Long{4} * p * p + 8 * theta * theta) * p - 8 * zeta * theta);
    }
    return sign * y;
  }
};

// Rail and velocity of a unit load's passage by Taylor's series in 80 bits, time in units of the
// modulation's.
std::array<Long, 6> taylor_passage(const LumpedTrack& track, Long rate, Long t,
                                   const std::array<Long, 4>& scale) {
  const auto n = static_cast<std::size_t>(track.input.size());
  std::array<std::array<Long, 6>, 6> A{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      A[i][j] = Long{track.rates(Eigen::Index(i), Eigen::Index(j))} * scale[j] / (scale[i] * rate);
    A[i][n] = A[i][n + 1] = track.input(Eigen::Index(i)) / (scale[i] * rate);
  }
  A[n][n] = A[n][n + 1] = A[n + 1][n + 1] = -1, A[n + 1][n] = 1;
  // Overhead: (lambda - A) x = (1 + i) b at lambda = 1 + i, by elimination.
  std::array<std::array<Complex, 5>, 4> m{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = -A[i][j];
    m[i][i] += Complex{1, 1}, m[i][n] = Complex{1, 1} * A[i][n];
  }
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t best = c;
    for (std::size_t r = c; r < n; ++r)
      if (std::abs(m[r][c]) > std::abs(m[best][c])) best = r;
    std::swap(m[c], m[best]);
    for (std::size_t r = 0; r < n; ++r)
      if (r != c) {
        const Complex f = m[r][c] / m[c][c];
        for (std::size_t j = c; j <= n; ++j) m[r][j] -= f * m[c][j];
      }
  }
  std::array<Long, 6> x{};
  const Long before = std::min(t * rate, Long{0});
  for (std::size_t i = 0; i < n; ++i)
    x[i] = (m[i][n] / m[i][i] * std::exp(Complex{1, 1} * before)).real();
  x[n] = 1;
  Long norm = 0;
  for (const auto& row : A) {
    Long sum = 0;
    for (Long a : row) sum += std::abs(a);
    norm = std::max(norm, sum);
  }
  const Long end = std::max(t * rate, Long{0});
  const int steps = 1 + static_cast<int>(norm * end / 3);
  for (int k = 0; k < steps && end > 0; ++k) {
    std::array<Long, 6> term = x, next = x;
    for (int order = 1; order < 34; ++order) {
      std::array<Long, 6> image{};
      for (std::size_t i = 0; i < n + 2; ++i)
        for (std::size_t j = 0; j < n + 2; ++j) image[i] += A[i][j] * term[j];
      for (std::size_t i = 0; i < n + 2; ++i) {
        term[i] = image[i] * end / steps / order;
        next[i] += term[i];
      }
    }
    x = next;
  }
  for (std::size_t i = 0; i < n; ++i) x[i] *= scale[i];
  return x;
}

RailOnBed random_bed(RandomStream& draw) {
  RailOnBed bed{draw.decades(10, 1000), draw.decades(1e6, 1e9), 0,
                draw.decades(100, 1e4), draw.decades(1e6, 1e9), 0};
  bed.rail_damping = draw(0, 2) * std::sqrt(bed.rail_stiffness * bed.rail_mass);
  bed.bed_damping = draw(0, 2) * std::sqrt(bed.bed_stiffness * bed.bed_mass);
  return bed;
}

}  // namespace

TEST_CASE("claim: the moving load's shape") {
  Claim shape_claim("track::moving_load"), extremes("track::MovingLoadShape"),
      undamped("track::undamped_amplification");
  RandomStream draw(31);
  for (int k = 0; k < 1000; ++k) {
    double theta = k % 2 == 0 ? draw.decades(1e-6, 1e6) : draw(0.5, 1.5),
           zeta = k % 4 < 2 ? draw.decades(1e-9, 1e9) : draw.decades(1e-3, 10);
    if (k % 3 == 0) {  // roots that nearly meet, behind the load
      theta = draw.decades(0.1, 10);
      double low = 1e-6, high = 1e6;
      const auto gap = [&](double z) {
        const MovingLoadSide b = moving_load(theta, z).behind;
        return b.stiffness - 0.25 * b.damping * b.damping;
      };
      for (int i = 0; i < 60; ++i)
        (gap(std::sqrt(low * high)) > 0 ? low : high) = std::sqrt(low * high);
      zeta = low * (1 + draw.decades(1e-16, 1e-2) * (draw(0, 1) < 0.5 ? 1 : -1));
    }
    const MovingLoadShape shape = moving_load(theta, zeta);
    const Quartic exact(theta, zeta);
    for (const int side : {1, -1}) {
      const Complex a = exact.root[side > 0 ? 0 : 2], b = exact.root[side > 0 ? 1 : 3];
      const Long slow = std::min(std::abs(a.real()), std::abs(b.real())),
                 large = std::max(std::abs(a), std::abs(b));
      const Long s = side * (draw(0, 1) < 0.5 ? draw(0, 6) / slow : draw(0, 6) / large);
      const double place = static_cast<double>(s);
      const auto& part = side > 0 ? shape.ahead : shape.behind;
      const Long scale =
          std::max(Long{part.y0}, std::abs(Long{part.slope0}) / std::sqrt(part.stiffness)) *
          (1 + large * std::abs(s));
      shape_claim.error(static_cast<double>(
          std::abs(shape.deflection(place) - exact.sum(place, 0).real()) / scale));
      shape_claim.error(static_cast<double>(
          std::abs(shape.slope(place) - exact.sum(place, 1).real()) / (scale * large)));
      shape_claim.error(static_cast<double>(
          std::abs(shape.curvature(place) - exact.sum(place, 2).real()) / (scale * large * large)));
      const auto most = shape.maximum(), least = shape.minimum();
      const double unit = most.y;
      for (int i = 0; i < 40; ++i) {
        const double at = static_cast<double>(side * draw(0, 8) / slow);
        const double y = shape.deflection(at);
        extremes.error(std::max(y - most.y, least.y - y) / unit);
      }
      extremes.error(std::abs(shape.deflection(most.s) - most.y) / unit);
      extremes.error(std::abs(shape.deflection(least.s) - least.y) / unit);
    }
    const double below = k % 2 == 0 ? draw(0, 1) : 1 - draw.decades(1e-15, 1);
    undamped.relative(undamped_amplification(below),
                      1 / std::sqrt((1 - Long{below}) * (1 + Long{below})));
  }
}

TEST_CASE("claim: lumped tracks and their passages") {
  Claim one("track::single_mass"), two("track::two_layer"), passage("track::Passage"),
      side("track::trackside"), peak("track::trackside_peak");
  RandomStream draw(33);
  for (int k = 0; k < 1000; ++k) {
    const RailOnBed bed = random_bed(draw);
    const LumpedTrack layers = two_layer(bed);
    const double K = bed.rail_stiffness, M = bed.rail_mass, C = bed.rail_damping;
    const LumpedTrack mass = single_mass(K, C, M);
    // Rows of (s - A) x = b with the motion of the equations themselves.
    const Complex s{0, std::sqrt(Long{K} / M) * draw.decades(1e-3, 1e3)};
    const auto residual = [&](const LumpedTrack& track, const std::vector<Complex>& y) {
      Long worst = 0;
      for (Eigen::Index i = 0; i < track.input.size(); ++i) {
        Complex sum = s * y[static_cast<std::size_t>(i)] - Long{track.input(i)};
        Long size = std::abs(s * y[static_cast<std::size_t>(i)]) + std::abs(Long{track.input(i)});
        for (Eigen::Index j = 0; j < track.input.size(); ++j) {
          const Complex part = Long{track.rates(i, j)} * y[static_cast<std::size_t>(j)];
          sum -= part, size += std::abs(part);
        }
        worst = std::max(worst, std::abs(sum) / size);
      }
      return static_cast<double>(worst);
    };
    const Complex y = Long{1} / (Long{K} + Long{C} * s + Long{M} * s * s);
    one.error(residual(mass, {y, s * y}));
    const Complex pad = Long{K} + Long{C} * s, ground = Long{bed.bed_stiffness} +
                                                        Long{bed.bed_damping} * s +
                                                        Long{bed.bed_mass} * s * s;
    const Complex rail = Long{1} / (Long{M} * s * s + pad * ground / (pad + ground)),
                  below = rail * pad / (pad + ground);
    two.error(residual(layers, {rail, s * rail, below, s * below}));

    // What passes at the rate of the rail's own motion, or far from it.
    const bool both = k % 2 == 0;
    const Long own = std::sqrt(Long{K} / M);
    const double beta = draw(0.5, 2),
                 speed = static_cast<double>(own * draw.decades(0.03, 3)) / beta;
    const Long rate = Long{beta} * speed;
    const double t = static_cast<double>(draw(-2, 6) / rate);
    const LumpedTrack& track = both ? layers : mass;
    const std::array<Long, 4> scale{1, own, 1, own};
    const auto exact = taylor_passage(track, rate, t, scale);
    const auto found = Passage{track, beta, speed}.state(t);
    const auto overhead = taylor_passage(track, rate, 0, scale);
    const Long size = std::abs(overhead[0]);
    passage.error(
        static_cast<double>(std::abs(found[0] - exact[0]) / size / (1 + own * std::abs(t))));
    passage.error(static_cast<double>(std::abs(found[1] - exact[1]) / (size * own) /
                                      (1 + own * std::abs(t))));

    const WheelLoad wheels[] = {{draw(-2, 2), draw(-1e5, 1e5)}, {draw(-2, 2), draw(-1e5, 1e5)}};
    const double step = static_cast<double>(draw(0.01, 1) / rate);
    const auto series = trackside(track, beta, speed, wheels, t, step, 2);
    Long sum = 0, load = 0;
    for (const WheelLoad& w : wheels) {
      sum += w.force * taylor_passage(track, rate, t + Long{step} - Long{w.x} / speed, scale)[0];
      load += std::abs(w.force);
    }
    side.error(static_cast<double>(std::abs(series[1] - sum) / (load * size) /
                                   (1 + own * (std::abs(Long{t}) + step + 2 / speed))));
  }
  for (int k = 0; k < 40; ++k) {
    const double theta = draw.decades(0.05, 30), mu = draw.decades(0.1, 10),
                 zeta = k % 4 == 0 ? 0 : draw.decades(1e-3, 30);
    const TracksidePeak top = trackside_peak(theta, mu, zeta);
    const double root = theta * std::sqrt(mu);
    const Passage same{single_mass(1, 2 * zeta * root, root * root), 1, 1};
    peak.error(std::abs(same.state(top.tau)[0] / top.y - 1));
    for (int i = 0; i < 30; ++i) peak.error(same.state(draw(-3, 10 + 20 * root))[0] / top.y - 1);
  }
}

TEST_CASE("claim: passages over joints") {
  Claim approach("track::static_approach"), spring("track::contact_stiffness"),
      own("track::natural_frequencies"), force("track::simulate"), other("track::forces_at"),
      dip("track::dip_formula"), extremes("track::force_extremes"), most("track::largest_force"),
      least("track::smallest_force"), mean("track::running_mean"), peaks("track::impact_peaks"),
      audit("track::energy_audit");
  RandomStream draw(34);
  for (int k = 0; k < 1000; ++k) {
    const ImpactModel model{draw.decades(100, 3000), draw.decades(1e3, 1e6),
                            draw.decades(1e9, 1e12), random_bed(draw)};
    const RailOnBed& t = model.track;
    const Long P = model.static_load, x0 = std::pow(P / model.hertz_constant, Long{2} / 3),
               kh = 1.5L * P / x0;
    approach.relative(static_approach(model), x0);
    spring.relative(contact_stiffness(model), kh);
    // det(K - lambda M) over det(M) as a cubic; Newton's method from what was found.
    const Long a = kh / model.wheel_mass, b = kh / t.rail_mass,
               c = t.rail_stiffness / Long{t.rail_mass}, d = t.rail_stiffness / Long{t.bed_mass},
               e = t.bed_stiffness / Long{t.bed_mass};
    const auto found = natural_frequencies(model);
    const auto pivots =
        [&](Long l) {  // number of eigenvalues below l, by the pivots of Sturm's sequence
          const Long p = a - l, q = b + c - l - a * b / p, r = d + e - l - c * d / q;
          return (p < 0) + (q < 0) + (r < 0);
        };
    const Long top = 2 * (a + b + c + d + e);
    for (int i = 0; i < 3; ++i) {
      Long low = 0, high = top;
      for (int j = 0; j < 70; ++j) (pivots((low + high) / 2) > i ? high : low) = (low + high) / 2;
      const Long omega = 2 * long_pi * Long{found[i]};
      own.error(static_cast<double>(std::abs(omega * omega - low) / top));
    }
    const DipFormula formula{draw(10, 1000), draw(10, 1000), draw.decades(1e6, 1e9),
                             draw.decades(1e3, 1e6)};
    const double alpha = draw.decades(1e-4, 0.1), speed = draw.decades(1, 100);
    const auto forces = dip_formula(model, formula, alpha, speed);
    const Long mu = model.wheel_mass, mt = formula.track_mass, me = formula.rail_mass;
    dip.relative(forces.p1, P + 2 * Long{alpha} * speed * std::sqrt(kh * me * mu / (mu + me)));
    const Long tilt = 2 * Long{alpha} * speed * mu * std::sqrt(formula.track_stiffness / (mu + mt));
    const Long loss =
        formula.track_damping * long_pi / (4 * std::sqrt(formula.track_stiffness * (mu + mt)));
    dip.error(static_cast<double>(std::abs(forces.p2 - (P + tilt * (1 - loss))) /
                                  (P + tilt * (1 + loss))));

    const RectifiedSine rail{draw.decades(1e-4, 1e-2), draw(8, 20)};
    ImpactOptions options{.tolerance = 1e-8, .start = -draw(0.02, 0.2), .end_time = 0.012};
    const double v = draw(5, 60);
    const ImpactHistory history = simulate(model, rail, v, options);
    REQUIRE(history.status == ImpactStatus::complete);
    std::vector<double> times;
    for (int i = 0; i < 5; ++i)
      times.push_back(draw(i < 4 ? options.start / v : 0.002, options.end_time));
    std::sort(times.begin(), times.end());
    const double P0 = model.static_load;
    if (k % 4 == 0 && history.losses.empty()) {  // what the other integrators do not locate
      const auto seen = forces_at(model, rail, v, options, ImpactMethod::bsimp, times),
                 implicit = forces_at(model, rail, v, options, ImpactMethod::radau5, times);
      ImpactOptions tight = options;
      tight.tolerance = 1e-11;
      const auto truth = forces_at(model, rail, v, tight, ImpactMethod::rk8pd, times);
      REQUIRE((seen.complete && implicit.complete && truth.complete));
      for (std::size_t i = 0; i < times.size(); ++i) {
        const double size = std::max(truth.force[i], P0);
        force.error(std::abs(history.force(times[i]) - truth.force[i]) / size);
        other.error(std::abs(seen.force[i] - truth.force[i]) / size);
        other.error(std::abs(implicit.force[i] - truth.force[i]) / size);
      }
    }
    const double from = times[0], to = times[4];
    const auto high = largest_force(history, from, to), low = smallest_force(history, from, to);
    const auto turns = force_extremes(history, from, to);
    for (int i = 0; i < 20; ++i) {
      const double F = history.force(draw(from, to));
      most.error((F - high.force) / P0);
      least.error((low.force - F) / P0);
    }
    most.error(std::abs(history.force(high.time) - high.force) / P0);
    least.error(std::abs(history.force(low.time) - low.force) / P0);
    for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
      if (turns[i].maximum == turns[i + 1].maximum) continue;  // apart between them
      // Nothing between two neighbours lies outside of them.
      const double F = history.force(draw(turns[i].time, turns[i + 1].time)),
                   other_end = turns[i + 1].force;
      extremes.error(std::max(F - std::max(turns[i].force, other_end),
                              std::min(turns[i].force, other_end) - F) /
                     P0);
    }
    const double window = draw.decades(1e-4, 0.4 * (to - from)),
                 middle = draw(from + 0.5 * window, to - 0.5 * window);
    Long impulse = 0;
    for (const auto& step : history.steps) {
      const double a0 = std::max(step.begin, middle - 0.5 * window),
                   b0 = std::min(step.end, middle + 0.5 * window);
      if (b0 <= a0) continue;
      for (Eigen::Index i = 0; i < rule.x.size(); ++i)
        impulse += rule.w[i] * (b0 - a0) * history.force(a0 + rule.x[i] * (b0 - a0));
    }
    mean.error(
        static_cast<double>(std::abs(running_mean(history, middle, window) - impulse / window)) /
        std::max(P0, high.force));
    audit.error(energy_audit(history).defect());
    const auto found_peaks =
        impact_peaks(history, {.second_before = 2.5e-3, .late_after = 4e-3, .mean_window = 4e-3});
    for (int i = 0; i < 10; ++i) {
      peaks.error((history.force(draw(0, 2.5e-3)) - found_peaks.second.force) / P0);
      peaks.error((history.force(draw(4e-3, 0.012)) - found_peaks.late.force) / P0);
      peaks.error((found_peaks.least.force - history.force(draw(0, 0.012))) / P0);
      peaks.error((running_mean(history, draw(2e-3, 0.01), 4e-3) - found_peaks.mean.force) / P0);
    }
  }
}
