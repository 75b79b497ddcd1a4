#include <railbook/track/impact_methods.hpp>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include <railbook/num/fp_flags.hpp>
#include <railbook/num/gsl.hpp>
#include <railbook/track/impact_system.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {

namespace {

// Where a run stops, ascending: at a time asked for, at a joint or knot, or both.
struct Stop {
  double t = 0;
  bool joint = false;
  bool asked = false;
};

std::vector<Stop> stops_of(const Surface& surface, double speed, const ImpactOptions& options,
                           std::span<const double> times) {
  std::vector<Stop> stops;
  for (double x : breakpoints(surface, options.start, speed * times.back()))
    stops.push_back({x / speed, true, false});
  for (double t : times) stops.push_back({t, false, true});
  std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) { return a.t < b.t; });
  return stops;
}

template <class S>
struct Counted {
  ImpactSystem<S> system;
  long evaluations = 0;
};

template <class S>
int gsl_rates(double t, const double* y, double* dy, void* data) {
  auto& counted = *static_cast<Counted<S>*>(data);
  ++counted.evaluations;
  ImpactState rate;
  counted.system(t, Eigen::Map<const ImpactState>(y), rate);
  Eigen::Map<ImpactState>{dy} = rate;
  return GSL_SUCCESS;
}

template <class S>
int gsl_jacobian(double t, const double* y, double* dfdy, double* dfdt, void* data) {
  ImpactJacobian jac;
  ImpactState drift;
  static_cast<Counted<S>*>(data)->system.jacobian(t, Eigen::Map<const ImpactState>(y), jac, &drift);
  Eigen::Map<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>{dfdy} = jac;
  Eigen::Map<ImpactState>{dfdt} = drift;
  return GSL_SUCCESS;
}

template <class S>
ForcesAt by_gsl(const ImpactModel& model, const Surface& whole, const S& surface, double speed,
                const ImpactOptions& options, ImpactMethod method, std::span<const double> times) {
  Counted<S> counted{{model, surface, speed, static_approach(model)}};
  ImpactSystem<S>& system = counted.system;
  const double omega = 2.0 * units::pi * natural_frequencies(model)[2];
  const double x = options.tolerance * system.rest, first_step = 0.05 / omega;
  const ImpactState tolerance{{x, x * omega, x, x * omega, x, x * omega}};
  num::use_gsl_status_codes();
  const gsl_odeiv2_system equations{gsl_rates<S>, gsl_jacobian<S>, 6, &counted};
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver{
      gsl_odeiv2_driver_alloc_scaled_new(
          &equations, method == ImpactMethod::rk8pd ? gsl_odeiv2_step_rk8pd : gsl_odeiv2_step_bsimp,
          first_step, 1.0, 0.0, 1.0, 0.0, tolerance.data()),
      gsl_odeiv2_driver_free};
  gsl_odeiv2_driver_set_nmax(driver.get(), static_cast<unsigned long>(options.most_steps));

  const bool cusps = has_cusps(whole) && options.restart_at_cusps;
  double t = options.start / speed;
  const SurfacePoint at = system.surface.at(options.start, system.surface.piece(options.start));
  ImpactState y = ImpactState::Zero();
  y[0] = at.z;
  y[1] = speed * at.slope;
  ForcesAt result;
  bool after_joint = false;
  for (const Stop& stop : stops_of(whole, speed, options, times)) {
    system.piece = system.surface.piece(0.5 * speed * (t + stop.t));
    if (cusps && after_joint) gsl_odeiv2_driver_reset_hstart(driver.get(), first_step);
    if (stop.t > t) {
      // GSL 2.8 as Debian 13 compiles it divides by a norm of zero and does not use the result.
      const num::FpFlagsAside aside;
      const int status = gsl_odeiv2_driver_apply(driver.get(), &t, stop.t, y.data());
      if (status != GSL_SUCCESS) {
        result.reason = gsl_strerror(status);
        break;
      }
    }
    if (stop.asked) {
      result.state.push_back(y);
      result.force.push_back(system.force(stop.t, y));
    }
    after_joint = stop.joint;
  }
  result.complete = result.force.size() == times.size();
  result.evaluations = counted.evaluations;
  return result;
}

}  // namespace

ForcesAt forces_at(const ImpactModel& model, const Surface& surface, double speed,
                   const ImpactOptions& options, ImpactMethod method,
                   std::span<const double> times) {
  if (times.empty() || !std::is_sorted(times.begin(), times.end()))
    throw InputError("times of the forces: must be given, ascending");
  ImpactOptions until = options;
  until.end_time = times.back();
  if (method == ImpactMethod::dopri5 || method == ImpactMethod::radau5) {
    until.implicit = method == ImpactMethod::radau5;
    const ImpactHistory history = simulate(model, surface, speed, until);
    ForcesAt result;
    result.evaluations = history.evaluations;
    result.complete = history.status == ImpactStatus::complete;
    result.reason = to_string(history.status);
    for (std::size_t i = 0; result.complete && i < times.size(); ++i) {
      result.state.push_back(history.state(times[i]));
      result.force.push_back(history.force(times[i]));
    }
    return result;
  }
  require_valid(model);
  require_valid(surface);
  require_valid(until, surface, speed);
  return std::visit(
      [&](const auto& s) { return by_gsl(model, surface, s, speed, until, method, times); },
      surface);
}

}  // namespace railbook::track
