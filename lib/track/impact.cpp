#include <railbook/track/impact.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include <railbook/num/dopri5.hpp>
#include <railbook/num/eigenvalues.hpp>
#include <railbook/num/radau5.hpp>
#include <railbook/track/impact_system.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {

void require_valid(const ImpactModel& model) {
  units::require_positive("wheel mass", model.wheel_mass, "kg");
  units::require_positive("static load", model.static_load, "N");
  units::require_positive("Hertz constant", model.hertz_constant, "N/m^1.5");
  require_valid(model.track);
}

double static_approach(const ImpactModel& model) {
  const double root = std::cbrt(model.static_load / model.hertz_constant);
  return root * root;
}

double contact_stiffness(const ImpactModel& model) {
  return 1.5 * model.static_load / static_approach(model);
}

Eigen::Vector3d natural_frequencies(const ImpactModel& model) {
  require_valid(model);
  const double kh = contact_stiffness(model);
  const RailOnBed& t = model.track;
  Eigen::Matrix3d stiffness;
  stiffness << kh, -kh, 0, -kh, kh + t.rail_stiffness, -t.rail_stiffness, 0, -t.rail_stiffness,
      t.rail_stiffness + t.bed_stiffness;
  const Eigen::Vector3d scale =
      Eigen::Vector3d{model.wheel_mass, t.rail_mass, t.bed_mass}.cwiseSqrt().cwiseInverse();
  const Eigen::Matrix3d scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
  return num::symmetric_eigenvalues(scaled).cwiseMax(0.0).cwiseSqrt() / (2.0 * units::pi);
}

std::string_view to_string(ImpactStatus status) {
  switch (status) {
    case ImpactStatus::complete:
      return "complete";
    case ImpactStatus::step_limit:
      return "step limit reached";
    case ImpactStatus::step_underflow:
      return "step size fell to rounding";
  }
  return "unknown";
}

double default_start(const Surface& surface) {
  if (const auto* rail = std::get_if<RectifiedSine>(&surface)) return -0.25 * rail->length;
  return std::get<SampledProfile>(surface).first();
}

namespace {

const num::DenseStep<6>& step_at(const ImpactHistory& history, double t) {
  const double rounding = 1e-12 * (history.end() - history.begin());
  units::require_between("time in the history", t, history.begin() - rounding,
                         history.end() + rounding, "s");
  t = std::min(t, history.end());
  const auto above = std::partition_point(history.steps.begin(), history.steps.end(),
                                          [t](const auto& s) { return s.end < t; });
  return *above;
}

// A zero of `f` between low and high, where its signs differ, to the last bits: bisection is quick
// enough for the few events of a passage.
template <class F>
double zero_between(F&& f, double low, double high) {
  const bool sign = f(high) > 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0) == sign ? high : low) = middle;
  }
  return high;
}

// The two integrators as the Runner drives them.
struct Explicit : num::Dopri5<6> {
  using Dopri5::Dopri5;
};
struct Implicit : num::Radau5<6> {
  using Radau5::Radau5;
  template <class System>
  void restart(const System&, double t, const ImpactState& y) {
    Radau5::restart(t, y);
  }
  template <class System>
  [[nodiscard]] bool step(const System& system, double end) {
    const auto jacobian = [&](double t, const ImpactState& y, ImpactJacobian& jac) {
      system.jacobian(t, y, jac, nullptr);
    };
    return Radau5::step(system, jacobian, end);
  }
};

// Runs the passage piece by piece of one surface.
template <class S, class Solver>
class Runner {
 public:
  Runner(ImpactHistory& history, const S& surface, const ImpactOptions& options)
      : history_(history),
        options_(options),
        system_{history.model, surface, history.speed, static_approach(history.model)},
        solver_{tolerances(), 0.05 / (2.0 * units::pi * natural_frequencies(history.model)[2])} {}

  void run() {
    const double speed = history_.speed;
    const double begin = options_.start / speed, end = options_.end_time;
    std::vector<double> stops = breakpoints(history_.surface, options_.start, speed * end);
    const bool cusps = has_cusps(history_.surface) && options_.restart_at_cusps;
    if (has_cusps(history_.surface) && !options_.restart_at_cusps) {
      stops.clear();
      system_.follow = true;
    }
    for (double& x : stops) x /= speed;
    stops.push_back(end);
    system_.piece = system_.surface.piece(system_.follow ? options_.start
                                                         : 0.5 * speed * (begin + stops.front()));
    const SurfacePoint at = system_.surface.at(options_.start, system_.piece);
    ImpactState y = ImpactState::Zero();
    y[0] = at.z;
    y[1] = speed * at.slope;
    solver_.restart(system_, begin, y);
    for (std::size_t i = 0; i < stops.size(); ++i) {
      if (i > 0) {
        system_.piece = system_.surface.piece(0.5 * speed * (stops[i - 1] + stops[i]));
        if (cusps) solver_.restart(system_, solver_.t(), ImpactState(solver_.y()));
      }
      if (!advance(stops[i])) break;
    }
    if (system_.flying) history_.losses.back().to = solver_.t();
    history_.evaluations = solver_.evaluations();
    history_.rejections = solver_.rejections();
  }

 private:
  // Errors count against the static approach and the speed that goes with it at the contact
  // frequency.
  ImpactState tolerances() const {
    const ImpactModel& m = history_.model;
    const double x = options_.tolerance * static_approach(m);
    const double v = x * 2.0 * units::pi * natural_frequencies(m)[2];
    ImpactState tolerance;
    tolerance << x, v, x, v, x, v;
    return tolerance;
  }

  bool advance(double stop) {
    while (solver_.t() < stop) {
      if (static_cast<long>(history_.steps.size()) >= options_.most_steps) {
        history_.status = ImpactStatus::step_limit;
        return false;
      }
      if (!solver_.step(system_, stop)) {
        history_.status = ImpactStatus::step_underflow;
        return false;
      }
      history_.steps.push_back(solver_.dense());
      if (options_.locate_losses) locate_event();
    }
    return true;
  }

  // Ends the last step where contact is lost or regained within it, and begins anew there.
  void locate_event() {
    num::DenseStep<6>& step = history_.steps.back();
    const auto state = [&](double t) { return system_.contact(t, step.at(t)); };
    // Positive when the contact state assumed during the step is wrong at t.
    const double sign = system_.flying ? 1.0 : -1.0;
    const auto wrong = [&](double t) { return sign * state(t).approach; };
    double to = step.end;
    if (!(wrong(to) > 0)) {
      // Both ends right: a brief touch or lift lies inside only if x turns there.
      const double from = step.begin;
      if (!(sign * state(from).rate > 0 && sign * state(to).rate < 0)) return;
      to = zero_between([&](double t) { return -sign * state(t).rate; }, from, to);
      if (!(wrong(to) > 0)) return;
    }
    const double t = zero_between(wrong, step.begin, to);
    step.end = t;
    system_.flying = !system_.flying;
    if (system_.flying)
      history_.losses.push_back({t, t});
    else
      history_.losses.back().to = t;
    solver_.restart(system_, t, ImpactState(step.at(t)));
  }

  ImpactHistory& history_;
  const ImpactOptions& options_;
  ImpactSystem<S> system_;
  Solver solver_;
};

}  // namespace

void require_valid(const ImpactOptions& options, const Surface& surface, double speed) {
  units::require_positive("speed", speed, "m/s");
  units::require_between("tolerance", options.tolerance, 1e-14, 1e-2);
  units::require_positive("end time", options.end_time, "s");
  units::require_between("start distance", options.start, -1e6, speed * options.end_time, "m");
  units::require_between("step limit", static_cast<double>(options.most_steps), 1, 1e9);
  if (const auto* profile = std::get_if<SampledProfile>(&surface)) {
    units::require_between("start distance on the profile", options.start, profile->first(),
                           profile->last(), "m");
    units::require_between("distance at the end of the run (speed times duration)",
                           speed * options.end_time, profile->first(), profile->last(), "m");
  }
}

ImpactState ImpactHistory::state(double t) const {
  return step_at(*this, t).at(t);
}

double ImpactHistory::force(double t) const {
  const ImpactState y = state(t);
  const double x = static_approach(model) + y[0] - y[2] - surface_at(surface, speed * t).z;
  for (const ContactLoss& loss : losses)
    if (t > loss.from && t < loss.to) return 0.0;
  return x <= 0 ? 0.0 : model.hertz_constant * x * std::sqrt(x);
}

ImpactHistory simulate(const ImpactModel& model, const Surface& surface, double speed,
                       const ImpactOptions& options) {
  require_valid(model);
  require_valid(surface);
  require_valid(options, surface, speed);
  ImpactHistory history;
  history.model = model;
  history.surface = surface;
  history.speed = speed;
  history.steps.reserve(4096);
  std::visit(
      [&](const auto& s) {
        using S = std::decay_t<decltype(s)>;
        if (options.implicit)
          Runner<S, Implicit>{history, s, options}.run();
        else
          Runner<S, Explicit>{history, s, options}.run();
      },
      history.surface);
  return history;
}

}  // namespace railbook::track
