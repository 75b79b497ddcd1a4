// The accuracy that lib/track states of ballast, masses, running surface and lumped parts, on
// seeded inputs over its range, in 80-bit arithmetic.
#include <cmath>
#include <vector>

#include <railbook/num/quadrature.hpp>
#include <railbook/track/track_geometry.hpp>
#include <railbook/track/wheel_on_track.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::track;
using namespace railbook::tests;

namespace {

const num::GaussRule rule = num::gauss_legendre(24, 0, 1);

// The compliance of the pyramid, layer by layer: panels over which it widens by a half.
Long pyramid(Long l, Long w, Long h, Long modulus, Long angle) {
  const Long c = 2 * std::tan(angle), narrow = std::min(l, w);
  Long sum = 0, z = 0;
  while (z < h) {
    const Long thick = c > 0 ? std::min(h - z, (narrow + c * z) / (2 * c)) : h - z;
    for (Eigen::Index i = 0; i < rule.x.size(); ++i) {
      const Long at = z + thick * Long{rule.x[i]};
      sum += Long{rule.w[i]} * thick / ((l + c * at) * (w + c * at));
    }
    z = h - z - thick < 1e-18L * h ? h : z + thick;
  }
  return sum / modulus;
}

TieSupport random_support(RandomStream& draw) {
  const double spacing = draw.decades(0.1, 10);
  TieSupport s{.tie_spacing = spacing,
               .loaded_length = draw.decades(0.01, 10),
               .tie_width = spacing * draw(0.01, 1),
               .ballast_depth = draw(0, 1) < 0.1 ? 0 : draw.decades(1e-6, 1e2),
               .ballast_modulus = draw.decades(1e4, 1e12),
               .friction_angle = draw(0, 1) < 0.2 ? 0 : draw.decades(1e-9, 1.48),
               .soil_modulus = draw.decades(1e4, 1e12)};
  if (draw(0, 1) < 0.7) s.tie_stiffness = draw.decades(1e4, 1e12);
  if (draw(0, 1) < 0.7) s.pad_stiffness = draw.decades(1e4, 1e12);
  return s;
}

// Hertz's ellipse of semi-axes 1 and sqrt(1 - m), by Gauss's mean: the ratio of curvatures, and C_H
// over E* and the square root of the larger radius.
struct Ellipse {
  Long ratio, constant;
};
Ellipse ellipse(Long m) {
  const Long m1 = 1 - m;
  Long a = 1, g = std::sqrt(m1), sum = 0.5L, power = 1, square = m;
  for (int n = 0; n < 12; ++n) {
    const Long next = (a + g) / 2, c = square / (4 * next);
    g = std::sqrt(a * g), a = next, square = c * c;
    sum += power * square / m, power *= 2;
  }
  const Long k = long_pi / (2 * a), d = k * sum, flat = std::sqrt(m1) * d;
  return {(k - d) / (m1 * d), 2 * long_pi / 3 * std::sqrt(m1) * std::sqrt(2 * flat) /
                                  std::pow(std::sqrt(m1) * k, 1.5L)};
}

}  // namespace

TEST_CASE("claim: ballast, seat and lumped masses") {
  Claim ballast("track::ballast_compliance"), chain("track::stiffness_chain"),
      overlap("track::overlap_depth"), beta("track::rail_beta"),
      rho("track::ballast_mass_per_length"), seismic("track::seismic_mass_per_length"),
      tie("track::tie_and_ballast_mass"), damper("track::viscous_damping"),
      split("track::rail_on_bed");
  RandomStream draw(21);
  for (int k = 0; k < 1300; ++k) {
    const TieSupport s = random_support(draw);
    const Long l = s.loaded_length, w = s.tie_width, h = s.ballast_depth, angle = s.friction_angle;
    const Long bed_of_ballast = pyramid(l, w, h, s.ballast_modulus, angle);
    ballast.relative(ballast_compliance(s.loaded_length, s.tie_width, s.ballast_depth,
                                        s.ballast_modulus, s.friction_angle),
                     bed_of_ballast);
    const Long spread = 2 * std::tan(angle) * h;
    const Long below = 1 / (s.soil_modulus * (l + spread) * (w + spread));
    const Long upper = 1 / Long{s.pad_stiffness} + 1 / Long{s.tie_stiffness};
    const Long lower = 2 * (bed_of_ballast + below), seat = 1 / (upper + lower);
    const auto found = stiffness_chain(s);
    if (h > 0) chain.relative(found.ballast, 1 / bed_of_ballast);
    chain.relative(found.subgrade, 1 / below);
    chain.relative(found.bed, 2 / lower);
    chain.relative(found.seat, seat);
    chain.relative(found.foundation_modulus, seat / s.tie_spacing);
    if (angle > 0)
      overlap.relative(overlap_depth(s), (Long{s.tie_spacing} - w) / (2 * std::tan(angle)));
    const BallastMass b{draw.decades(1, 1e5), draw.decades(1e-4, 10), draw(1, 2), draw(4, 6)};
    TieSupport steep = s;
    steep.friction_angle = draw.decades(1e-3, 1.48);
    const Long mass = Long{b.density} * w * b.tamped_area * b.cohesion /
                      (Long{b.divisor} * s.tie_spacing * std::tan(Long{steep.friction_angle}));
    rho.relative(ballast_mass_per_length(b, steep), mass);
    const double stiffness = draw.decades(1e3, 1e12), V = draw.decades(1, 1e4);
    seismic.relative(seismic_mass_per_length(stiffness, b.tamped_area, s.tie_spacing, V),
                     0.28L * stiffness * b.tamped_area / (Long{s.tie_spacing} * V * V));
    const double sleeper = draw.decades(1, 1e4), zeta = draw.decades(1e-6, 10);
    tie.relative(tie_and_ballast_mass(sleeper, s.tie_spacing, b.density, V),
                 3 * (sleeper / (2 * Long{s.tie_spacing}) + b.density) / (2 * Long{V}));
    damper.relative(viscous_damping(zeta, stiffness, sleeper),
                    2 * zeta * std::sqrt(Long{stiffness} * sleeper));
    if (upper == 0) continue;
    const RailSection& rail = rail_sections()[static_cast<std::size_t>(k % 4)];
    const Long ei = rail.bending_stiffness(), on_seat = 1 / (upper * s.tie_spacing);
    const auto beta_of = [&](Long modulus) { return std::sqrt(std::sqrt(modulus / ei / 4)); };
    beta.relative(rail_beta(rail.bending_stiffness(), s), beta_of(on_seat));
    const LayerDamping zetas{draw(0, 1), draw(0, 1)};
    const RailOnBed parts = rail_on_bed(rail, steep, b, sleeper, zetas);
    const Long wide = 2 * std::tan(Long{steep.friction_angle}) * h;
    const Long soft = 2 * (pyramid(l, w, h, s.ballast_modulus, steep.friction_angle) +
                           1 / (s.soil_modulus * (l + wide) * (w + wide)));
    const Long K = 1 / ((upper + soft) * s.tie_spacing), all = beta_of(K);
    // 1/K_r - 1/K_1 as the integral of the growth of 1/K_r with the bed's compliance: (3/4) K_1^-1
    // c (1 + c t)^(-1/4) dt.
    const Long K1 = 2 * on_seat / beta_of(on_seat), c = soft / upper;
    Long growth = 0, from = 0;
    for (Long to = std::min(Long{1}, 1 / c); from < 1; from = to, to = std::min(Long{1}, 2 * to))
      for (Eigen::Index i = 0; i < rule.x.size(); ++i)
        growth += Long{rule.w[i]} * (to - from) * 0.75L * c /
                  std::sqrt(std::sqrt(1 + c * (from + (to - from) * Long{rule.x[i]})));
    const Long m_rail = 1.5L * rail.mass_per_length / beta_of(on_seat),
               m_bed = 1.5L * (sleeper / (2 * Long{s.tie_spacing}) + mass) / all,
               k_bed = K1 / growth;
    split.relative(parts.rail_stiffness, K1);
    split.relative(parts.rail_mass, m_rail);
    split.relative(parts.bed_mass, m_bed);
    split.relative(parts.bed_stiffness, k_bed);
    split.relative(parts.rail_damping, 2 * zetas.rail * std::sqrt(K1 * m_rail));
    split.relative(parts.bed_damping, 2 * zetas.bed * std::sqrt(k_bed * m_bed));
  }
}

TEST_CASE("claim: Hertz's constant of a wheel on a rail") {
  Claim claim("track::hertz_constant");
  RandomStream draw(22);
  for (int k = 0; k < 1000; ++k) {
    const double m = k % 2 == 0 ? draw.decades(1e-9, 0.9) : 1 - draw.decades(1e-9, 0.5);
    const Ellipse e = ellipse(m);
    const double radius = draw.decades(1e-3, 1e3);
    const double other = static_cast<double>(radius / e.ratio);
    WheelOnRail pair{radius, other, draw.decades(1e6, 1e13), draw(0, 0.5)};
    if (k % 4 < 2) std::swap(pair.wheel_radius, pair.crown_radius);
    const Long nu = pair.poisson_ratio;
    claim.relative(hertz_constant(pair), e.constant * std::sqrt(Long{radius}) *
                                             pair.youngs_modulus / (2 * (1 - nu * nu)));
  }
}

TEST_CASE("claim: surfaces of the rail") {
  Claim sine("track::RectifiedSine"), at("track::surface_at"),
      harmonic("track::rectified_sine_harmonic"), spline("track::SampledProfile"),
      both("track::half_staggered"), cosine("track::cosine_amplitudes"),
      cross("track::CrossLevelSpectrum"), joins("track::breakpoints");
  RandomStream draw(23);
  for (int k = 0; k < 1000; ++k) {
    const RectifiedSine rail{draw.decades(1e-6, 1), draw.decades(0.1, 100)};
    const double x = rail.length * (draw(-100, 100));
    const Long turn = long_pi * Long{x} / rail.length, n = rail.piece(x);
    const Long local = turn - n * long_pi, arc = long_pi / rail.length;
    const auto error = [&](Long found, Long exact, Long scale) {
      return static_cast<double>(std::abs(found - exact) / scale / (1 + std::abs(x) / rail.length));
    };
    const SurfacePoint found = rail.at(x, static_cast<long>(n));
    sine.error(error(found.z, rail.depth * (1 - std::sin(local)), rail.depth));
    sine.error(error(found.slope, -rail.depth * arc * std::cos(local), rail.depth * arc));
    sine.error(error(rail.total_angle(), 2 * arc * rail.depth, rail.depth * arc));
    at.error(error(surface_at(rail, x).z, rail.depth * (1 - std::abs(std::sin(turn))), rail.depth));
    const BounceRoll shared = half_staggered(rail, x);
    const Long left = 1 - std::abs(std::sin(turn)), right = 1 - std::abs(std::cos(turn));
    both.error(error(shared.bounce, rail.depth * (left + right) / 2, rail.depth));
    both.error(error(shared.roll, rail.depth * (left - right) / 2, rail.depth));
    const int order = static_cast<int>(draw.decades(1, 1e6));
    harmonic.relative(rectified_sine_harmonic(order),
                      4 / (long_pi * (2 * Long{1} * order - 1) * (2 * Long{1} * order + 1)));
    const double high = x + rail.length * draw(0.01, 20);
    const auto places = breakpoints(rail, x, high);
    const Long first = std::floor(turn / long_pi) + 1,
               last = std::ceil(Long{high} / rail.length) - 1;
    joins.error(std::abs(static_cast<double>(Long(places.size()) - (last - first + 1))));
    for (std::size_t i = 0; i < places.size(); ++i)
      joins.error(
          places[i] == static_cast<double>((first + static_cast<Long>(i)) * rail.length) ? 0 : 1);
    CrossLevelSpectrum s{draw.decades(1e-12, 1), draw.decades(1e-4, 1e2), draw.decades(1e-4, 1e2)};
    if (k % 4 == 0) s.high_break = s.low_break * (1 + draw.decades(1e-15, 1e-3));
    const double from = k % 3 == 0 ? 0 : draw.decades(1e-6, 1e4),
                 to = from + draw.decades(1e-9, 1e4);
    const Long a = s.low_break, b = s.high_break;
    const auto density = [&](Long f) {
      return s.roughness * b * b / ((f * f + a * a) * (f * f + b * b));
    };
    cross.relative(s.density(to), density(to));
    // Panels no longer than half of where they begin, or of the lower break.
    Long sum = 0;
    for (Long f = from; f < to;) {
      const Long end = std::min(Long{to}, f + std::max(f, std::min(a, b)) / 2);
      for (Eigen::Index i = 0; i < rule.x.size(); ++i)
        sum += Long{rule.w[i]} * (end - f) * density(f + (end - f) * Long{rule.x[i]});
      f = end;
    }
    cross.relative(s.variance(from, to), sum);
  }
  for (int k = 0; k < 60; ++k) {
    // A natural spline by its moments in 80 bits, eliminated from the other end.
    const std::size_t n = 4 + static_cast<std::size_t>(k % 17);
    std::vector<double> x{draw(-1e3, 1e3)}, z;
    while (x.size() < n) x.push_back(x.back() + draw.decades(1e-4, 10));
    for (std::size_t i = 0; i < n; ++i) z.push_back(draw(-1, 1) * 0.01);
    std::vector<Long> bend(n, 0), lower(n, 0);
    for (std::size_t i = n - 2; i > 0; --i) {
      const Long left = Long{x[i]} - x[i - 1], right = Long{x[i + 1]} - x[i];
      const Long pivot = 2 * (left + right) - right * lower[i + 1];
      lower[i] = left / pivot;
      bend[i] = (6 * ((Long{z[i + 1]} - z[i]) / right - (Long{z[i]} - z[i - 1]) / left) -
                 right * bend[i + 1]) /
                pivot;
    }
    Long most = 0.01L;
    for (std::size_t i = 1; i + 1 < n; ++i) {
      bend[i] -= lower[i] * bend[i - 1];
      most = std::max(most, std::abs(bend[i]) * std::pow(Long{x[i + 1]} - x[i], Long{2}));
    }
    const SampledProfile profile{x, z};
    for (int j = 0; j < 20; ++j) {
      const double place = draw(x.front(), x.back());
      const auto i = static_cast<std::size_t>(profile.piece(place));
      REQUIRE((x[i] <= place && place <= x[i + 1]));
      const Long h = Long{x[i + 1]} - x[i], v = (place - Long{x[i]}) / h, u = 1 - v;
      const Long exact = u * z[i] + v * z[i + 1] +
                         h * h / 6 * ((u * u * u - u) * bend[i] + (v * v * v - v) * bend[i + 1]);
      spline.error(static_cast<double>(std::abs(surface_at(profile, place).z - exact) / most));
    }
    std::vector<double> samples;
    const std::size_t count = 8 + static_cast<std::size_t>(k);
    for (std::size_t i = 0; i < count; ++i) samples.push_back(draw(-1, 1));
    const auto found = cosine_amplitudes(samples, static_cast<int>(count / 2));
    for (std::size_t m = 0; m < found.size(); ++m) {
      Long sum = 0;
      for (std::size_t i = 0; i < count; ++i)
        sum += samples[i] * std::cos(2 * long_pi * static_cast<Long>(m * i % count) / Long(count));
      cosine.error(static_cast<double>(
          std::abs(found[m] - (m == 0 ? 1 : 2) * sum / static_cast<Long>(count))));
    }
  }
}
