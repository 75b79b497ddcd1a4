// The accuracy that lib/quality states of motions with bump stops and of spreading histograms: by
// an integrator that knows nothing of the stops' switches, by quadrature and by what must be kept.
#include <cmath>

#include <railbook/num/dopri5.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/quality/bump_stops.hpp>
#include <railbook/quality/spreading.hpp>
#include <railbook/quality/steady_motion.hpp>
#include <railbook/units/constants.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::quality;
using namespace railbook::tests;

namespace {

constexpr double pi = units::pi;

// x and v at the end, through the kinks of the stops at the integrator's own steps.
Eigen::Vector2d integrated(const StoppedBody& body, const Track& track, const Motion& start,
                           double end) {
  const double w = 2 * pi * body.suspension.frequency;
  const auto rhs = [&](double t, const Eigen::Vector2d& s, Eigen::Vector2d& d) {
    double acceleration = 0;
    for (const Wave& wave : track.waves) {
      const double rate = 2 * pi * wave.frequency;
      acceleration -= wave.amplitude * rate * rate * std::sin(rate * t + wave.phase);
    }
    const double over = std::max(std::abs(s[0]) - body.gap, 0.0);
    d[0] = s[1];
    d[1] = -2 * body.suspension.damping * w * s[1] -
           w * w * (s[0] + body.kappa * std::copysign(over, s[0])) - acceleration;
  };
  num::Dopri5<2> ode{Eigen::Vector2d{1e-13, 1e-12}, 1e-3};
  ode.restart(rhs, start.t, {start.x, start.v});
  while (ode.t() < end) REQUIRE(ode.step(rhs, end));
  return ode.y();
}

}  // namespace

TEST_CASE("claim: motions with bump stops") {
  Claim runs("quality::run", 100), periodic("quality::periodic_motion", 60),
      rest("quality::at_rest");
  RandomStream draw(91);
  for (int k = 0; k < 100; ++k) {
    const double f = draw.decades(0.3, 3), gap = draw.decades(1e-3, 0.1);
    const StoppedBody body{{f, draw.decades(0.03, 2)}, gap, draw.decades(0.1, 300)};
    const Wave wave{gap * draw.decades(0.1, 3), f * draw.decades(0.2, 3), draw(0, 2 * pi)};
    const Track track{{wave, {0.2 * wave.amplitude, 1.7 * wave.frequency, 1}}, 0};
    const Motion start{0, gap * draw(-1.5, 1.5), gap * f * draw(-6, 6)};
    const Run found = run(body, track, start, 2 / f);
    const Eigen::Vector2d there = integrated(body, track, start, 2 / f);
    const double rate = 2 * pi * f * std::sqrt(1 + body.kappa), size = gap + found.largest;
    runs.error(found.complete ? std::max(std::abs(found.end.x - there[0]),
                                         std::abs(found.end.v - there[1]) / rate) /
                                    size
                              : std::nan(""));

    const PeriodicMotion steady =
        periodic_motion(body, wave, balanced_motion(body, wave, draw(0, 2) * gap));
    if (!steady.converged) continue;
    const Eigen::Vector2d back = integrated(body, {{wave}, 0}, steady.start, 1 / wave.frequency);
    periodic.error(
        std::max(std::abs(back[0] - steady.start.x), std::abs(back[1] - steady.start.v) / rate) /
        (steady.largest * (1 + steady.growth)));
  }
  for (int k = 0; k < 1000; ++k) {
    const Track track{{{draw.decades(1e-4, 0.1), draw.decades(0.1, 10), draw(0, 7)}},
                      k % 2 ? draw.decades(0.1, 100) : 0};
    const Motion at = at_rest(track);
    rest.error(at.x == 0 && at.v + (track.ramp > 0 ? wheel_rate(track, 0) : 0) == 0 ? 0 : 1);
  }
}

TEST_CASE("claim: the first harmonic of stops") {
  Claim mean("quality::mean_stiffness"), balanced("quality::balanced_motion");
  RandomStream draw(92);
  for (int k = 0; k < 1000; ++k) {
    const double gap = draw.decades(1e-4, 0.1), a = gap * draw.decades(1e-2, 100);
    const StoppedBody body{
        {draw.decades(0.2, 5), draw.decades(1e-3, 2)}, gap, draw.decades(1e-2, 1e4)};
    // Of the stops' force on a sin u, from where they meet on: kappa (a sin u - gap) sin u, four
    // quarters of the turn over pi a.
    Long stops = 0;
    if (a > gap) {
      const Long from = std::asin(Long{gap} / a), to = long_pi / 2;
      const auto whole = [&](Long u) {
        return a * (u / 2 - std::sin(2 * u) / 4) + gap * std::cos(u);
      };
      stops = body.kappa * 4 * (whole(to) - whole(from)) / (long_pi * a);
    }
    const Long stiffness = 1 + stops;
    mean.relative(mean_stiffness(body, a), stiffness);

    const Wave wave{gap, body.suspension.frequency * draw.decades(0.1, 10), draw(0, 6)};
    const Motion at = balanced_motion(body, wave, a);
    const Long w = 2 * long_pi * body.suspension.frequency, turn = 2 * long_pi * wave.frequency;
    const std::complex<Long> impedance{w * w * stiffness - turn * turn,
                                       2 * body.suspension.damping * w * turn};
    const std::complex<Long> exact =
        std::polar(wave.amplitude * turn * turn, Long{wave.phase}) / impedance;
    balanced.error(static_cast<double>(std::abs(exact - std::complex<Long>(at.v / turn, at.x)) /
                                       std::abs(exact)));
  }
}

TEST_CASE("claim: spreading keeps the area") {
  Claim kept("quality::spread");
  RandomStream draw(93);
  for (int k = 0; k < 1000; ++k) {
    Histogram p{0, draw.decades(0.01, 1), {}};
    for (int i = 0; i < 30; ++i) p.height.push_back(i % 29 ? draw.decades(1e-3, 1) : 0);
    const double before = area(p), step = draw.decades(1e-4, 1) * p.width * p.width;
    const Spread s = spread({draw.decades(0.1, 1), k % 4}, p, 1, 1 + step, 4);
    kept.relative(s.converged ? area(s.profile) : std::nan(""), before);
  }
}
