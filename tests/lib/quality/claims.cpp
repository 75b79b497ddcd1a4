// The accuracy that lib/quality states, on seeded inputs over its range, in 80-bit arithmetic.
#include <cmath>
#include <complex>

#include <railbook/quality/quality_index.hpp>
#include <railbook/quality/vehicle.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::tests;

TEST_CASE("claim: gains of the one-wheel vehicle") {
  Claim stroke("quality::stroke_gain"), peak("quality::stroke_peak"), force("quality::force_gain");
  RandomStream draw(6);
  for (int k = 0; k < 2000; ++k) {
    const quality::Suspension s{draw.decades(0.2, 5), draw.decades(1e-3, 1)};
    const double f = s.frequency * draw.decades(1e-6, 1e6);
    const Long e = Long{f} / s.frequency, e2 = e * e, rho = s.damping;
    stroke.relative(quality::stroke_gain(s, f),
                    e2 / std::sqrt((1 - e2) * (1 - e2) + 4 * rho * rho * e2));
    const double damping = draw.decades(1e-4, 0.7);
    const Long d2 = Long{damping} * damping;
    const auto found = quality::stroke_peak(damping);
    peak.relative(found.ratio, 1 / std::sqrt(1 - 2 * d2));
    peak.relative(found.gain, 1 / std::sqrt(4 * d2 * (1 - d2)));
    const quality::Car car = quality::make_car(draw(100, 2000), draw(2000, 20000), s);
    const double hertz = draw.decades(1e-3, 1e3);
    const std::complex<Long> i{0, 2 * long_pi * hertz};
    const Long m = car.wheel, M = car.body, spring = car.stiffness, b = car.damping;
    force.relative(std::abs(quality::force_gain(car, hertz)),
                   std::abs(i * i * (M * m * i * i + (M + m) * (b * i + spring)) /
                            (M * i * i + b * i + spring)));
  }
}

TEST_CASE("claim: the share of a normal histogram above a threshold") {
  Claim share("quality::share_above");
  RandomStream draw(7);
  for (int k = 0; k < 2000; ++k) {
    const double n = draw(-8, 8);
    share.relative(quality::share_above(0, 1, n), std::erfc(n / std::sqrt(Long{2})) / 2);
  }
}
