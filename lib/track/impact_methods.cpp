#include <railbook/track/impact_methods.hpp>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include <railbook/num/fp_flags.hpp>
#include <railbook/num/gsl.hpp>
#include <railbook/num/radau5.hpp>
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
  ImpactSystem<S>* system;
  long evaluations = 0;
  long jacobians = 0;
};

template <class S>
int gsl_rates(double t, const double* y, double* dy, void* data) {
  auto& counted = *static_cast<Counted<S>*>(data);
  ++counted.evaluations;
  ImpactState rate;
  (*counted.system)(t, Eigen::Map<const ImpactState>(y), rate);
  Eigen::Map<ImpactState>{dy} = rate;
  return GSL_SUCCESS;
}

template <class S>
int gsl_jacobian(double t, const double* y, double* dfdy, double* dfdt, void* data) {
  auto& counted = *static_cast<Counted<S>*>(data);
  ++counted.jacobians;
  ImpactJacobian jac;
  ImpactState drift;
  counted.system->jacobian(t, Eigen::Map<const ImpactState>(y), jac, &drift);
  Eigen::Map<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>{dfdy} = jac;
  Eigen::Map<ImpactState>{dfdt} = drift;
  return GSL_SUCCESS;
}

const gsl_odeiv2_step_type* gsl_type(ImpactMethod method) {
  switch (method) {
    case ImpactMethod::rk8pd:
      return gsl_odeiv2_step_rk8pd;
    case ImpactMethod::msbdf:
      return gsl_odeiv2_step_msbdf;
    case ImpactMethod::rk4imp:
      return gsl_odeiv2_step_rk4imp;
    default:
      return gsl_odeiv2_step_bsimp;
  }
}

// advance(t, y): brings t, y to the stop's time; false when it cannot. begin(t, y): after a cusp.
struct Stepper {
  std::function<bool(double)> advance;
  std::function<void()> begin_anew;
  std::function<ImpactState()> state;
};

template <class S>
class Comparison {
 public:
  Comparison(const ImpactModel& model, const S& surface, double speed, const ImpactOptions& options)
      : system_{model, surface, speed, static_approach(model)}, options_(options) {
    const double omega = 2.0 * units::pi * natural_frequencies(model)[2];
    const double x = options.tolerance * system_.rest;
    tolerance_ << x, x * omega, x, x * omega, x, x * omega;
    first_step_ = 0.05 / omega;
  }

  ForcesAt run(const Surface& whole, ImpactMethod method, std::span<const double> times) {
    const double speed = system_.speed, begin = options_.start / speed;
    const std::vector<Stop> stops = stops_of(whole, speed, options_, times);
    const bool cusps = has_cusps(whole) && options_.restart_at_cusps;
    ForcesAt result;
    Stepper stepper;
    double from = begin;
    for (const Stop& stop : stops) {
      system_.piece = system_.surface.piece(0.5 * speed * (from + stop.t));
      if (from == begin && !stepper.advance) {
        const SurfacePoint at = system_.surface.at(options_.start, system_.piece);
        ImpactState y = ImpactState::Zero();
        y[0] = at.z;
        y[1] = speed * at.slope;
        stepper = method == ImpactMethod::radau5 ? radau(begin, y) : gsl(method, begin, y);
      } else if (cusps && after_joint_) {
        stepper.begin_anew();
      }
      if (stop.t > from && !stepper.advance(stop.t)) {
        result.reason = reason_;
        break;
      }
      if (stop.asked) {
        result.state.push_back(stepper.state());
        result.force.push_back(system_.force(stop.t, result.state.back()));
      }
      after_joint_ = stop.joint;
      from = stop.t;
    }
    result.complete = result.force.size() == times.size();
    result.evaluations = counted_.evaluations;
    result.jacobians = counted_.jacobians;
    return result;
  }

 private:
  Stepper radau(double t, const ImpactState& y) {
    auto solver = std::make_shared<num::Radau5<6>>(tolerance_, first_step_);
    solver->restart(t, y);
    const auto rates = [this](double at, const ImpactState& now, ImpactState& dy) {
      ++counted_.evaluations;
      system_(at, now, dy);
    };
    const auto jacobian = [this](double at, const ImpactState& now, ImpactJacobian& jac) {
      ++counted_.jacobians;
      system_.jacobian(at, now, jac, nullptr);
    };
    return {[this, solver, rates, jacobian](double end) {
              for (long i = 0; solver->t() < end; ++i) {
                if (i >= options_.most_steps) return stopped("step limit reached");
                if (!solver->step(rates, jacobian, end))
                  return stopped("step size fell to rounding");
              }
              return true;
            },
            [solver] { solver->restart(solver->t(), ImpactState(solver->y())); },
            [solver] { return ImpactState(solver->y()); }};
  }

  Stepper gsl(ImpactMethod method, double t, const ImpactState& y) {
    num::use_gsl_status_codes();
    counted_.system = &system_;
    gsl_system_ = {gsl_rates<S>, gsl_jacobian<S>, 6, &counted_};
    const std::shared_ptr<gsl_odeiv2_driver> driver{
        gsl_odeiv2_driver_alloc_scaled_new(&gsl_system_, gsl_type(method), first_step_, 1.0, 0.0,
                                           1.0, 0.0, tolerance_.data()),
        gsl_odeiv2_driver_free};
    gsl_odeiv2_driver_set_nmax(driver.get(), static_cast<unsigned long>(options_.most_steps));
    const auto now = std::make_shared<std::pair<double, ImpactState>>(t, y);
    return {[this, driver, now](double end) {
              // GSL 2.8 as Debian 13 compiles it divides by a norm of zero and does not use the
              // result.
              const num::FpFlagsAside aside;
              const int status =
                  gsl_odeiv2_driver_apply(driver.get(), &now->first, end, now->second.data());
              return status == GSL_SUCCESS || stopped(gsl_strerror(status));
            },
            [this, driver] { gsl_odeiv2_driver_reset_hstart(driver.get(), first_step_); },
            [now] { return now->second; }};
  }

  bool stopped(std::string why) {
    reason_ = std::move(why);
    return false;
  }

  ImpactSystem<S> system_;
  const ImpactOptions& options_;
  ImpactState tolerance_;
  double first_step_ = 0;
  bool after_joint_ = false;
  std::string reason_;
  Counted<S> counted_{&system_};
  gsl_odeiv2_system gsl_system_{};
};

}  // namespace

ForcesAt forces_at(const ImpactModel& model, const Surface& surface, double speed,
                   const ImpactOptions& options, ImpactMethod method,
                   std::span<const double> times) {
  if (times.empty() || !std::is_sorted(times.begin(), times.end()))
    throw InputError("times of the forces: must be given, ascending");
  ImpactOptions until = options;
  until.end_time = times.back();
  if (method == ImpactMethod::dopri5) {
    const ImpactHistory history = simulate(model, surface, speed, until);
    ForcesAt result{{},
                    {},
                    history.evaluations,
                    0,
                    history.status == ImpactStatus::complete,
                    std::string(to_string(history.status))};
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
      [&](const auto& s) {
        return Comparison{model, s, speed, until}.run(surface, method, times);
      },
      surface);
}

}  // namespace railbook::track
