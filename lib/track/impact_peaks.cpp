#include <railbook/track/impact_peaks.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/track/impact_system.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {

namespace {

// Contact state on one step's own piece of the surface: one-sided at its ends, as the integrator
// saw it.
class StepView {
 public:
  StepView(const ImpactHistory& history, const num::DenseStep<6>& step)
      : history_(history), step_(step), rest_(static_approach(history.model)) {
    const double low = history.speed * step.begin, high = history.speed * step.end;
    std::visit(
        [&](const auto& s) {
          piece_ = s.piece(0.5 * (low + high));
          const double inside =
              1e-6 * (high - low);  // a history run without restarts has steps across cusps
          follow_ = s.piece(low + inside) != s.piece(high - inside);
        },
        history.surface);
  }
  ContactState contact(double t) const {
    return std::visit(
        [&](const auto& s) {
          return ImpactSystem<std::decay_t<decltype(s)>>{
              history_.model, s, history_.speed, rest_, piece_, false, follow_}
              .contact(t, step_.at(t));
        },
        history_.surface);
  }
  double force(double t) const {
    const double x = contact(t).approach;
    return x <= 0 ? 0.0 : history_.model.hertz_constant * x * std::sqrt(x);
  }
  SurfacePoint surface(double t) const {
    return std::visit(
        [&](const auto& s) {
          const double x = history_.speed * t;
          return s.at(x, follow_ ? s.piece(x) : piece_);
        },
        history_.surface);
  }

 private:
  const ImpactHistory& history_;
  const num::DenseStep<6>& step_;
  double rest_;
  long piece_ = 0;
  bool follow_ = false;
};

ForceExtremum best_force(const ImpactHistory& history, double from, double to, double sign) {
  ForceExtremum best{from, history.force(from), sign > 0};
  const auto consider = [&](const ForceExtremum& e) {
    if (sign * e.force > sign * best.force) best = {e.time, e.force, sign > 0};
  };
  consider({to, history.force(to), true});
  for (const ForceExtremum& e : force_extremes(history, from, to)) consider(e);
  for (const ContactLoss& loss : history.losses)
    if (loss.to >= from && loss.from <= to) consider({std::max(loss.from, from), 0.0, false});
  return best;
}

double energy(const ImpactModel& m, const StepView& view, const num::DenseStep<6>& step, double t) {
  const ImpactState y = step.at(t);
  const double x = std::max(0.0, view.contact(t).approach);
  const double lean = y[2] - y[4];
  return 0.5 * (m.wheel_mass * y[1] * y[1] + m.track.rail_mass * y[3] * y[3] +
                m.track.bed_mass * y[5] * y[5] + m.track.rail_stiffness * lean * lean +
                m.track.bed_stiffness * y[4] * y[4]) +
         m.static_load * (y[2] - y[0]) + 0.4 * m.hertz_constant * x * x * std::sqrt(x);
}

}  // namespace

std::vector<ForceExtremum> force_extremes(const ImpactHistory& history, double from, double to) {
  std::vector<ForceExtremum> found;
  double before = 0;  // the last nonzero rate seen, across steps
  for (const auto& step : history.steps) {
    if (step.end < from || step.begin > to || !(step.end > step.begin)) continue;
    const StepView view{history, step};
    const double a = std::max(from, step.begin), b = std::min(to, step.end);
    constexpr int parts = 4;
    double t0 = a;
    for (int i = 0; i <= parts; ++i) {
      const double t = i == parts ? b : a + (b - a) * i / parts;
      const ContactState at = view.contact(t);
      const double rate = at.rate;
      if (before * rate < 0) {
        double low = t0, high = t;  // i = 0: the sign changes on the cusp itself
        for (int k = 0; k < 60 && i > 0; ++k) {
          const double middle = 0.5 * (low + high);
          (view.contact(middle).rate * rate > 0 ? high : low) = middle;
        }
        const double force = view.force(high);
        if (force > 0) found.push_back({high, force, before > 0});
      }
      if (rate != 0) before = rate;
      t0 = t;
    }
  }
  return found;
}

ForceExtremum largest_force(const ImpactHistory& history, double from, double to) {
  return best_force(history, from, to, 1.0);
}
ForceExtremum smallest_force(const ImpactHistory& history, double from, double to) {
  return best_force(history, from, to, -1.0);
}

double running_mean(const ImpactHistory& history, double t, double window) {
  const double change = history.state(t + 0.5 * window)[1] - history.state(t - 0.5 * window)[1];
  return history.model.static_load - history.model.wheel_mass * change / window;
}

namespace {

// The mean is stationary where the force enters the window as fast as it leaves it.
ForceExtremum largest_mean(const ImpactHistory& history, double from, double to, double window) {
  const double half = 0.5 * window;
  const int count = 1 + static_cast<int>(100 * (to - from) / window);
  const double step = (to - from) / count;
  ForceExtremum best{from + half, -1e300, true};
  for (int i = 0; i <= count; ++i) {
    const double t = std::clamp(from + step * i, from + half, to - half);
    const double mean = running_mean(history, t, window);
    if (mean > best.force) best = {t, mean, true};
  }
  double low = std::max(best.time - step, from + half),
         high = std::min(best.time + step, to - half);
  const auto gain = [&](double t) { return history.force(t + half) - history.force(t - half); };
  if (gain(low) > 0 && gain(high) < 0) {
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (gain(middle) > 0 ? low : high) = middle;
    }
    best = {low, running_mean(history, low, window), true};
  }
  return best;
}

}  // namespace

ImpactPeaks impact_peaks(const ImpactHistory& history, const PeakWindows& windows) {
  const double end = history.end();
  ImpactPeaks peaks;
  peaks.mean_window =
      windows.mean_window > 0 ? windows.mean_window : 1.0 / natural_frequencies(history.model)[1];
  const double needed =
      std::max({windows.second_before, windows.late_after, 1.01 * peaks.mean_window});
  units::require_between("end of the history", end, needed, units::infinity, "s");
  const double joint = std::max(0.0, history.begin());
  for (const ForceExtremum& e : force_extremes(history, joint, end))
    if (e.maximum && e.time > 0 && !peaks.has_first) {
      peaks.first = e;
      peaks.has_first = true;
    }
  peaks.second = largest_force(history, joint, windows.second_before);
  peaks.late = largest_force(history, windows.late_after, end);
  peaks.least = smallest_force(history, joint, end);
  peaks.mean = largest_mean(history, joint, end, peaks.mean_window);
  for (const ContactLoss& loss : history.losses)
    peaks.lost_for += std::max(0.0, loss.to - std::max(loss.from, joint));
  return peaks;
}

double EnergyAudit::defect() const {
  return std::abs(change - surface + dissipated) / scale;
}

EnergyAudit energy_audit(const ImpactHistory& history) {
  const num::GaussRule rule = num::gauss_legendre(5, 0.0, 1.0);
  const ImpactModel& m = history.model;
  EnergyAudit audit;
  for (const auto& step : history.steps) {
    const StepView view{history, step};
    const double length = step.end - step.begin;
    for (int i = 0; i < rule.x.size(); ++i) {
      const double t = step.begin + rule.x[i] * length;
      const ImpactState y = step.at(t);
      const double pad = y[3] - y[5];
      const double weight = rule.w[i] * length;
      audit.surface -= weight * view.force(t) * history.speed * view.surface(t).slope;
      audit.dissipated +=
          weight * (m.track.rail_damping * pad * pad + m.track.bed_damping * y[5] * y[5]);
      audit.scale = std::max(audit.scale,
                             0.5 * (m.wheel_mass * y[1] * y[1] + m.track.rail_mass * y[3] * y[3] +
                                    m.track.bed_mass * y[5] * y[5]));
    }
  }
  const auto& first = history.steps.front();
  const auto& last = history.steps.back();
  audit.change = energy(m, StepView{history, last}, last, last.end) -
                 energy(m, StepView{history, first}, first, first.begin);
  return audit;
}

DipForces dip_formula(const ImpactModel& model, const DipFormula& track, double half_angle,
                      double speed) {
  const double me = track.rail_mass, mt = track.track_mass, mu = model.wheel_mass;
  const double drop = 2.0 * half_angle * speed;
  const double p1 = drop * std::sqrt(contact_stiffness(model) * me / (1.0 + me / mu));
  const double loss =
      track.track_damping * units::pi / (4.0 * std::sqrt(track.track_stiffness * (mu + mt)));
  const double p2 =
      drop * std::sqrt(mu / (mu + mt)) * (1.0 - loss) * std::sqrt(track.track_stiffness * mu);
  return {model.static_load + p1, model.static_load + p2};
}

}  // namespace railbook::track
