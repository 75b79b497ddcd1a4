// The accuracy that lib/quality states of limits, severities, histograms and their spreading, on
// seeded inputs over its range: in 80-bit arithmetic and by scans.
#include <cmath>

#include <railbook/quality/bump_stops.hpp>
#include <railbook/quality/descriptor.hpp>
#include <railbook/quality/quality_index.hpp>
#include <railbook/quality/spreading.hpp>
#include <railbook/quality/vehicle.hpp>
#include <railbook/units/constants.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::quality;
using namespace railbook::tests;

namespace {

double off(Long found, Long exact, Long scale) {
  return static_cast<double>(std::abs(found - exact) / scale);
}

}  // namespace

TEST_CASE("claim: cars, limits and severities") {
  Claim sprung("quality::suspension"), made("quality::make_car"),
      level("quality::stroke_limit_of_level"), weight("quality::static_force"),
      margin("quality::force_margin"), at("quality::severity_at"), most("quality::severity"),
      top("quality::severity_peak"), allowed("quality::allowed_amplitude"),
      flat("quality::flat_until"), both("quality::Envelope"), peak("quality::force_peak");
  RandomStream draw(61);
  for (int k = 0; k < 1000; ++k) {
    const Suspension s{draw.decades(0.2, 10), draw.decades(1e-3, 1)};
    const double m = draw.decades(10, 3000), M = draw.decades(300, 3e4);
    const Car car = make_car(m, M, s);
    const Long rate = 2 * long_pi * s.frequency;
    made.relative(car.stiffness, M * rate * rate);
    made.relative(car.damping, 2 * s.damping * rate * M);
    const Suspension back = suspension(car);
    sprung.relative(back.frequency, std::sqrt(Long{car.stiffness} / car.body) / (2 * long_pi));
    sprung.relative(back.damping, car.damping / (2 * std::sqrt(Long{car.stiffness} * car.body)));
    const Long gravity = units::standard_gravity, static_exact = (Long{m} + M) * gravity;
    weight.relative(static_force(car), static_exact);
    const double z = draw.decades(1e-4, 0.1);
    const Long d = s.damping;
    const StrokeLimit stroke = stroke_limit_of_level(s, z);
    level.relative(stroke.stroke,
                   z * (2 * d * d < 1 ? 1 / (2 * d * std::sqrt((1 - d) * (1 + d))) : Long{1}));
    const ForceLimit force{car, static_force(car) * (1 + draw.decades(1e-6, 3))};
    margin.error(off(force_margin(force), force.force - static_exact, force.force));
    const double v = draw.decades(0.1, 100), phi = s.frequency / v * draw.decades(1e-3, 1e3);
    at.relative(severity_at(stroke, v, phi), Long{stroke_gain(s, v * phi)} / stroke.stroke);
    at.relative(severity_at(force, v, phi),
                std::abs(force_gain(car, v * phi)) / Long{force_margin(force)});
    const Envelope envelope({stroke, force, v});
    both.relative(envelope(phi), std::max(severity(stroke, v, phi), severity(force, v, phi)));
    const double highest = severity(stroke, v, phi), heaviest = severity(force, v, phi);
    const auto stroke_top = severity_peak(stroke);
    const auto force_top = severity_peak(force);
    const ForcePeak found = force_peak(car);
    for (int i = 0; i < 10; ++i) {
      const double slower = v * draw(0, 1);
      most.error(severity_at(stroke, slower, phi) / highest - 1);
      most.error(severity_at(force, slower, phi) / heaviest - 1);
      top.error(severity_at(stroke, v, s.frequency / v * draw.decades(1e-2, 1e2)) /
                    stroke_top.severity -
                1);
      // A local maximum: higher than what is near.
      const double near = draw(0.98, 1.02);
      if (found.found) {
        const double f = back.frequency * found.ratio;
        peak.error(std::abs(force_gain(car, f * near)) / std::abs(force_gain(car, f)) - 1);
        top.error(std::abs(force_gain(car, f)) / force_margin(force) / force_top.severity - 1);
      }
    }
    const double severe = draw.decades(1e-6, 1e6);
    allowed.relative(allowed_amplitude(severe), 1 / Long{severe});
    flat.error(2 * d * d >= 1
                   ? flat_until(stroke, v)
                   : off(flat_until(stroke, v), v / Long{s.frequency} * std::sqrt(1 - 2 * d * d),
                         v / s.frequency));
  }
}

TEST_CASE("claim: tracks in time, risks and spreading histograms") {
  Claim high("quality::height"), fast("quality::wheel_rate"), fails("quality::failure_probability"),
      diffused("quality::diffused_deviation"), areas("quality::area"), means("quality::mean"),
      deviations("quality::deviation"), front("quality::blob_front"),
      height_of("quality::blob_height");
  RandomStream draw(62);
  for (int k = 0; k < 1000; ++k) {
    Track track;
    track.ramp = k % 2 == 0 ? 0 : draw(0.1, 2);
    Long z = 0, rate = 0, size = 0, speed = 0;
    const double t = draw(0, 3);
    for (int i = 0; i < 3; ++i) {
      const Wave w{draw(-0.1, 0.1), draw.decades(0.01, 30), draw(-3, 3)};
      track.waves.push_back(w);
      const Long turn = 2 * long_pi * w.frequency, angle = turn * t + w.phase;
      const Long up = track.ramp > 0 && t < track.ramp ? t / Long{track.ramp} : 1,
                 grow = up < 1 ? 1 / Long{track.ramp} : 0;
      z += up * w.amplitude * std::sin(angle);
      rate += w.amplitude * (up * turn * std::cos(angle) + grow * std::sin(angle));
      size += std::abs(Long{w.amplitude}) * (1 + std::abs(angle));
      speed += std::abs(Long{w.amplitude}) * (1 + std::abs(angle)) * (turn + grow);
    }
    high.error(off(height(track, t), z, size));
    fast.error(off(wheel_rate(track, t), rate, speed));
    const double mean_is = draw(-5, 5), deviation_is = draw.decades(1e-3, 3), median = draw(-5, 5),
                 wide = draw.decades(1e-2, 3);
    const Long n = (Long{median} - mean_is) / std::hypot(Long{deviation_is}, Long{wide});
    const Long share = std::erfc(n / std::sqrt(Long{2})) / 2;
    if (n < 30)
      fails.error(off(failure_probability(mean_is, deviation_is, median, wide), share,
                      share * (1 + n * n)));
    else
      fails.error(0);
    const double D = draw.decades(1e-12, 1e3), years = draw.decades(1e-3, 1e3);
    diffused.relative(diffused_deviation(deviation_is, D, years),
                      std::sqrt(Long{deviation_is} * deviation_is + 2 * Long{D} * years));
    Histogram p{draw(-10, 10), draw.decades(1e-3, 1), {}};
    Long area_is = 0, first = 0, second = 0;
    for (int i = 0; i < 20; ++i) {
      p.height.push_back(draw(0, 1));
      area_is += Long{p.width} * p.height.back(),
          first += Long{p.width} * p.height.back() * (p.left + Long{p.width} * i);
    }
    for (int i = 0; i < 20; ++i)
      second += p.width * p.height[static_cast<std::size_t>(i)] *
                std::pow(p.left + Long{p.width} * i - first / area_is, Long{2});
    areas.relative(area(p), area_is);
    const Long reach = std::abs(Long{p.left}) + 20 * p.width;
    means.error(off(mean(p), first / area_is, reach));
    deviations.error(off(deviation(p), std::sqrt(second / area_is), reach));
    // The area of the blob, by the substitution x = front sin(a), with the closed form of Euler's
    // beta function.
    const double at = draw.decades(1e-6, 1e6);
    const Long half = blob_front(at), middle = blob_height(0, at);
    const Long beta = std::sqrt(long_pi) * std::tgamma(Long{4} / 3) / std::tgamma(Long{11} / 6);
    front.error(off(half * middle * beta, 1, 1));
    const Long place = draw(-1, 1);
    height_of.error(off(blob_height(static_cast<double>(place * half), at),
                        middle * std::cbrt((1 - place) * (1 + place)),
                        middle * (1 + 1 / std::pow(1 - place * place, Long{2} / 3))));
  }
}
