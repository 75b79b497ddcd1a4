/***
What was written for the comparison: the four roots, the two rules of fixed steps, and the peaks from what a wheel did.
*/
#include "study/methods.hpp"

#include <Eigen/LU>
#include <cmath>
#include <complex>

#include "num/eigenvalues.hpp"
#include "track/impact_peaks.hpp"
#include "track/impact_system.hpp"

namespace railbook::track_chapter {

using namespace track;

double deflection_by_roots(double theta, double zeta) {
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion.diagonal(-1).setOnes();
  companion.col(3) << -4, 8 * zeta * theta, -4 * theta * theta, 0;
  std::complex<double> sum = 0;
  for (const std::complex<double>& p : num::eigenvalues(companion))
    if (p.real() < 0) sum += 8.0 / (4.0 * p * p * p + 8 * theta * theta * p - 8 * zeta * theta);
  return sum.real();
}

namespace {

using System = ImpactSystem<RectifiedSine>;

ImpactState rates(const System& system, double t, const ImpactState& y) {
  ImpactState dy;
  system(t, y, dy);
  return dy;
}

void runge_kutta(const System& system, double t, double h, ImpactState& y, FixedSteps& run) {
  const ImpactState a = rates(system, t, y), b = rates(system, t + h / 2, y + h / 2 * a),
                    c = rates(system, t + h / 2, y + h / 2 * b),
                    d = rates(system, t + h, y + h * c);
  y += h / 6 * (a + 2 * b + 2 * c + d);
  run.evaluations += 4;
}

// Average acceleration is the trapezoidal rule for positions and velocities.
void newmark(const System& system, double t, double h, ImpactState& y, FixedSteps& run) {
  const ImpactState explicit_part = y + h / 2 * rates(system, t, y), begin = y;
  ImpactJacobian jacobian;
  double change = 1;
  for (int i = 0; i < 8 && change > 1e-10; ++i) {
    system.jacobian(t + h, y, jacobian, nullptr);
    const ImpactJacobian newton = ImpactJacobian::Identity() - h / 2 * jacobian;
    const ImpactState step =
        newton.partialPivLu().solve(explicit_part + h / 2 * rates(system, t + h, y) - y);
    y += step;
    change = step.norm() / (y.norm() + begin.norm());
    ++run.evaluations;
  }
  ++run.evaluations;
  if (!(change <= 1e-10)) run.complete = false;
}

}  // namespace

FixedSteps fixed_steps(const ImpactModel& model, const RectifiedSine& rail, double speed,
                       double start, double step, Rule rule, std::span<const double> times) {
  System system{model, rail, speed, static_approach(model)};
  const SurfacePoint at = rail.at(start, rail.piece(start));
  ImpactState y = ImpactState::Zero();
  y[0] = at.z;
  y[1] = speed * at.slope;
  FixedSteps run;
  const auto go = [&](double from, double to) {
    system.piece = rail.piece(0.5 * speed * (from + to));
    const int n = std::max(1, static_cast<int>(std::ceil((to - from) / step - 1e-9)));
    const double h = (to - from) / n;
    for (int i = 0; i < n && run.complete; ++i) {
      (rule == Rule::newmark ? newmark : runge_kutta)(system, from + i * h, h, y, run);
      run.complete = run.complete && y.cwiseAbs().maxCoeff() < 1e3;
    }
  };
  go(start / speed, 0);
  double now = 0;
  for (const double t : times) {
    go(now, t);
    run.state.push_back(y);
    now = t;
  }
  return run;
}

std::vector<double> peak_times(const ImpactHistory& reference) {
  const ImpactPeaks p = impact_peaks(reference);
  return {p.first.time, p.mean.time - 0.5 * p.mean_window, p.mean.time + 0.5 * p.mean_window};
}

TwoPeaks two_peaks(const ImpactModel& model, const RectifiedSine& rail, double speed,
                   std::span<const double> times, std::span<const ImpactState> states) {
  System system{model, rail, speed, static_approach(model)};
  system.piece = rail.piece(1e-9);
  const double impulse = model.wheel_mass * (states[2][1] - states[1][1]);
  return {system.force(times[0], states[0]), model.static_load - impulse / (times[2] - times[1])};
}

}  // namespace railbook::track_chapter
