/***
The reference is another of GSL's integrators, the extrapolation method of Bader and Deuflhard, at
its tightest. It uses the same equations of motion as the methods that it judges.
*/
#include <array>
#include <cmath>

#include <railbook/track/impact_system.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "located_peaks.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

// A zero of f near t by the secant method, its first step `step`; NaN where it leads away.
template <class F>
double secant(F&& f, double t, double step) {
  const double limit = 20 * step;
  double a = t, b = t + step, at_a = f(a), at_b = f(b);
  for (int i = 0; i < 6 && at_b != at_a && std::abs(b - a) > 1e-6 * step; ++i) {
    const double next = b - at_b * (b - a) / (at_b - at_a);
    if (!(std::abs(next - t) < limit)) return units::nan;
    a = b, at_a = at_b;
    b = next, at_b = f(b);
  }
  return b;
}

}  // namespace

LocatedPeaks locate_peaks(const ImpactModel& model, const RectifiedSine& rail, double speed,
                          const ImpactOptions& options, ImpactMethod method,
                          const ImpactPeaks& near) {
  ImpactSystem<RectifiedSine> system{model, rail, speed, static_approach(model)};
  system.piece = rail.piece(1e-9);
  LocatedPeaks found;
  found.complete = true;
  const auto at = [&](std::span<const double> times) {
    ForcesAt run = forces_at(model, rail, speed, options, method, times);
    found.complete = found.complete && run.complete;
    run.force.resize(times.size());
    run.state.resize(times.size(), ImpactState::Zero());
    return run;
  };
  const double step = 0.01 / (2 * units::pi * natural_frequencies(model)[2]);
  if (near.has_first) {
    const auto nearing = [&](double t) {
      const std::array times{t};
      return system.contact(t, at(times).state[0]).rate;
    };
    found.p1_time = secant(nearing, near.first.time, step);
    if (std::isnan(found.p1_time)) return {};
    const std::array times{found.p1_time};
    found.p1 = at(times).force[0];
  }
  const double window = near.mean_window, begin = near.mean.time - 0.5 * window;
  const auto slope = [&](double t) {  // of the mean, but for a factor
    const std::array times{t, t + window};
    const ForcesAt run = at(times);
    return run.force[1] - run.force[0];
  };
  found.mean_begin = begin > 1e-9 ? secant(slope, begin, 2e-4 * window) : begin;
  if (std::isnan(found.mean_begin)) found.mean_begin = begin;
  const std::array times{found.mean_begin, found.mean_begin + window};
  const ForcesAt run = at(times);
  found.p2 = model.static_load - model.wheel_mass * (run.state[1][1] - run.state[0][1]) / window;
  return found;
}

}  // namespace railbook::track_chapter
