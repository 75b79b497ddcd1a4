#include <railbook/quality/steady_motion.hpp>

#include <cmath>
#include <complex>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::quality {
namespace {

double determinant(const Eigen::Matrix2d& m) {
  return m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
}

}  // namespace

double mean_stiffness(const StoppedBody& body, double a) {
  if (!(a > body.gap)) return 1;
  const double u = body.gap / a;
  return 1 + body.kappa * (1 - 2 / units::pi * (std::asin(u) + u * std::sqrt((1 - u) * (1 + u))));
}

PeriodicMotion periodic_motion(const StoppedBody& body, const Wave& wave, const Motion& guess,
                               int order) {
  units::require_positive("frequency of a wave", wave.frequency, "Hz");
  units::require_between("order of a motion", order, 1, 1000);
  const Track track{{wave}, 0};
  const double period = order / wave.frequency;
  PeriodicMotion result{.start = {0, guess.x, guess.v}};
  for (; result.iterations < 40; ++result.iterations) {
    const Run once = run(body, track, result.start, period);
    if (!once.complete) return result;
    result.largest = once.largest;
    const double trace = once.tangent.trace(), det = determinant(once.tangent);
    const double square = 0.25 * trace * trace - det;
    result.growth = square > 0 ? 0.5 * std::abs(trace) + std::sqrt(square) : std::sqrt(det);
    const double miss_x = once.end.x - result.start.x, miss_v = once.end.v - result.start.v;
    const double speed = 2 * units::pi * wave.frequency * once.largest;
    result.converged = std::abs(miss_x) < 1e-12 * once.largest && std::abs(miss_v) < 1e-12 * speed;
    if (result.converged) return result;
    const Eigen::Matrix2d j = once.tangent - Eigen::Matrix2d::Identity();
    const double d = determinant(j);
    if (d == 0) return result;
    result.start.x -= (j(1, 1) * miss_x - j(0, 1) * miss_v) / d;
    result.start.v -= (j(0, 0) * miss_v - j(1, 0) * miss_x) / d;
  }
  return result;
}

Motion balanced_motion(const StoppedBody& body, const Wave& wave, double a) {
  require(body);
  const double own = 2 * units::pi * body.suspension.frequency, w = 2 * units::pi * wave.frequency;
  const std::complex<double> denominator{own * own * mean_stiffness(body, a) - w * w,
                                         2 * body.suspension.damping * own * w};
  const std::complex<double> x = std::polar(wave.amplitude * w * w, wave.phase) / denominator;
  return {0, x.imag(), w * x.real()};
}

}  // namespace railbook::quality
