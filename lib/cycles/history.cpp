#include <railbook/cycles/history.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/cycles/detail/pieces.hpp>
#include <railbook/num/dopri5.hpp>
#include <railbook/num/radau5.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::cycles {

namespace {

struct Curve : PieceScalar {
  // The zero of f, which changes sign between a and b: Illinois' regula falsi.
  template <class F>
  static double zero(F&& f, double a, double b) {
    double fa = f(a), fb = f(b);
    for (int i = 0; i < 100 && std::abs(b - a) > 1e-15 * std::abs(b) && fb != fa; ++i) {
      const double t = (a * fb - b * fa) / (fb - fa), ft = f(t);
      if (ft == 0) return t;
      if ((ft > 0) != (fb > 0)) {
        a = b;
        fa = fb;
      } else {
        fa *= 0.5;
      }
      b = t;
      fb = ft;
    }
    return b;
  }
};

class Watch {
 public:
  Watch(const HistoryOptions& options, Eigen::Index n, double duration, History& history)
      : history_(history), step_(options.sample_step) {
    for (const Eigen::VectorXd& row : options.watch) {
      if (row.size() != n)
        throw InputError("watched row of " + std::to_string(row.size()) +
                         " entries; allowed: " + std::to_string(n));
      Vector9 wide = Vector9::Zero();
      wide.head(n) = row;
      rows_.push_back(wide);
    }
    history_.turns.resize(rows_.size());
    history_.rises.resize(rows_.size());
    if (step_ > 0) {
      const double count = units::require_between("samples", duration / step_, 0, 1e8);
      history_.samples.resize(Eigen::Index(rows_.size()), Eigen::Index(count) + 1);
    }
  }

  const std::vector<Vector9>& rows() const { return rows_; }

  // The samples up to, not including, the end of the step: they count once.
  void see(double begin, double h, const std::vector<Curve>& curves) {
    for (std::size_t r = 0; r < curves.size(); ++r) {
      const Curve& x = curves[r];
      if (sides_.size() <= r) sides_.push_back({x.slope(0) > 0, x.at(0) >= 0});
      // A step may end on a zero: what counts is the side on which the one before it ended.
      const bool up = x.slope(h) > 0;
      double turn = h;
      if (up != sides_[r].up) {
        turn =
            (x.slope(0) > 0) == up ? 0 : Curve::zero([&x](double u) { return x.slope(u); }, 0, h);
        history_.turns[r].push_back({begin + turn, x.at(turn)});
        look_for_rise(begin, x, 0, turn, r);
      }
      look_for_rise(begin, x, up != sides_[r].up ? turn : 0, h, r);
      sides_[r].up = up;
    }
    if (step_ <= 0) return;
    while (double(history_.sample_times.size()) * step_ < begin + h &&
           Eigen::Index(history_.sample_times.size()) < history_.samples.cols()) {
      const double t = double(history_.sample_times.size()) * step_;
      for (std::size_t r = 0; r < curves.size(); ++r)
        history_.samples(Eigen::Index(r), Eigen::Index(history_.sample_times.size())) =
            curves[r].at(t - begin);
      history_.sample_times.push_back(t);
    }
  }
  // Between two times within a step, without a turn between them.
  void look_for_rise(double begin, const Curve& x, double from, double to, std::size_t r) {
    const bool above = x.at(to) >= 0;
    if (above && !sides_[r].above)
      history_.rises[r].push_back(
          begin +
          (x.at(from) >= 0 ? from : Curve::zero([&x](double u) { return x.at(u); }, from, to)));
    sides_[r].above = above;
  }
  void finish() {
    history_.samples.conservativeResize(Eigen::NoChange,
                                        Eigen::Index(history_.sample_times.size()));
  }

 private:
  History& history_;
  double step_;
  std::vector<Vector9> rows_;
  struct Side {
    bool up, above;
  };
  std::vector<Side> sides_;  // of each row, at the end of the last step
};

void run_pieces(const Compiled& system, const State& y0, double duration,
                const HistoryOptions& options, Watch& watch, History& history) {
  PieceIntegrator integrator{system, options.scale, std::min(options.tolerance, 1e-12)};
  integrator.start(0, y0);
  std::vector<Curve> curves(watch.rows().size());
  while (integrator.t() < duration && integrator.steps() < options.most_steps) {
    const bool on = integrator.step(duration);
    const PieceStep& step = integrator.last();
    for (std::size_t r = 0; r < curves.size(); ++r) {
      curves[r].order = step.order;
      for (int j = 0; j <= step.order; ++j)
        curves[r].s[std::size_t(j)] = watch.rows()[r].dot(step.terms[std::size_t(j)].head<9>());
    }
    if (step.length > 0) watch.see(step.begin, step.length, curves);
    if (!on) {
      history.end = History::End::left_table;
      history.channel = integrator.channel_at_limit();
      break;
    }
  }
  if (integrator.steps() >= options.most_steps) history.end = History::End::stalled;
  history.t = integrator.t();
  history.y = integrator.y();
  history.steps = integrator.steps();
  history.evaluations = integrator.steps();
}

// The polynomial of fifth degree with value, slope and curvature of both ends.
Curve hermite(double h, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double rise = b[0] - a[0] - h * a[1] - 0.5 * h * h * a[2];
  const double slope = h * (b[1] - a[1] - h * a[2]), bend = h * h * (b[2] - a[2]);
  Curve c;
  c.order = 5;
  c.s[0] = a[0];
  c.s[1] = a[1];
  c.s[2] = 0.5 * a[2];
  c.s[3] = (10 * rise - 4 * slope + 0.5 * bend) / (h * h * h);
  c.s[4] = (-15 * rise + 7 * slope - bend) / (h * h * h * h);
  c.s[5] = (6 * rise - 3 * slope + 0.5 * bend) / (h * h * h * h * h);
  return c;
}

Eigen::Vector3d row_state(const Vector9& row, const State& y, const State& dy) {
  return {row.dot(y.head<9>()), row.dot(y.tail<9>()), row.dot(dy.tail<9>())};
}

// The first time within the step at which a channel passes its limit; beyond the step when none
// does.
double limit_time(const Compiled& system, double h, const State& y, const State& dy,
                  const State& y1, const State& dy1, int& channel) {
  double first = 2 * h;
  for (std::size_t c = 0; c < system.channels.size(); ++c) {
    const CompiledChannel& ch = system.channels[c];
    if (!(std::abs(system.scalar(ch, y1)) > ch.limit)) continue;
    const double sign = system.scalar(ch, y1) > 0 ? 1 : -1;
    double t = h;
    if (!ch.of_rate) {
      const Curve x = hermite(h, row_state(ch.row, y, dy), row_state(ch.row, y1, dy1));
      t = Curve::zero([&](double u) { return sign * x.at(u) - ch.limit; }, 0, h);
    }
    if (t < first) {
      first = t;
      channel = int(c);
    }
  }
  return first;
}

// Drives a stepper whose steps may contain kinks. `advance` makes one step, true if it could.
template <class Stepper, class Advance>
void run_steps(const Compiled& system, Stepper& stepper, Advance&& advance, double duration,
               const HistoryOptions& options, Watch& watch, History& history) {
  State before = stepper.y(), rate_before, rate;
  system.rate(before, rate_before);
  std::vector<Curve> curves(watch.rows().size());
  while (stepper.t() < duration) {
    const double begin = stepper.t();
    if (++history.steps > options.most_steps || !advance()) {
      history.end = History::End::stalled;
      break;
    }
    system.rate(stepper.y(), rate);
    double h = stepper.t() - begin;
    for (std::size_t r = 0; r < curves.size(); ++r)
      curves[r] = hermite(h, row_state(watch.rows()[r], before, rate_before),
                          row_state(watch.rows()[r], stepper.y(), rate));
    const double left =
        limit_time(system, h, before, rate_before, stepper.y(), rate, history.channel);
    watch.see(begin, std::min(h, left), curves);
    history.t = begin + std::min(h, left);
    if (left <= h) {
      history.end = History::End::left_table;
      break;
    }
    before = stepper.y();
    rate_before = rate;
  }
  history.y = stepper.y();
  history.evaluations = stepper.evaluations();
}

}  // namespace

State HistoryOptions::default_scale() {
  State scale;
  scale << Vector9::Constant(0.01), Vector9::Constant(0.1);
  return scale;
}

History integrate(const Oscillator& oscillator, const Eigen::VectorXd& y0, double duration,
                  const HistoryOptions& options) {
  units::require_positive("duration", duration, "s");
  units::require_positive("tolerance", options.tolerance);
  const Compiled system = compile(oscillator);
  const State begin = padded(y0);
  if (y0.size() != 2 * oscillator.coordinates() || !begin.allFinite())
    throw InputError("first state: not finite, or not of twice the coordinates");
  for (const CompiledChannel& c : system.channels)
    units::require_between("first displacement of a channel", system.scalar(c, begin), -c.limit,
                           c.limit);
  History history;
  Watch watch{options, oscillator.coordinates(), duration, history};
  const auto rate = [&system](double, const State& y, State& dy) { system.rate(y, dy); };
  const State tolerance = options.tolerance * options.scale;
  if (options.integrator == Integrator::pieces) {
    run_pieces(system, begin, duration, options, watch, history);
  } else if (options.integrator == Integrator::dopri5) {
    num::Dopri5<18> stepper{tolerance, 1e-4};
    stepper.restart(rate, 0, begin);
    run_steps(
        system, stepper, [&] { return stepper.step(rate, duration); }, duration, options, watch,
        history);
  } else {
    num::Radau5<18> stepper{tolerance, 1e-4};
    stepper.restart(0, begin);
    const auto jacobian = [&system](double, const State& y, StateMatrix& J) {
      system.jacobian(y, J);
    };
    run_steps(
        system, stepper, [&] { return stepper.step(rate, jacobian, duration); }, duration, options,
        watch, history);
  }
  watch.finish();
  history.y = unpadded(State(history.y), oscillator.coordinates());
  return history;
}

Swing swing(const History& history, std::size_t row, int periods) {
  const auto& turns = history.turns.at(row);
  const auto& rises = history.rises.at(row);
  Swing result;
  const auto count = std::size_t(periods);
  if (rises.size() < count + 1) return result;
  const double from = rises[rises.size() - 1 - count], to = rises.back();
  result.omega = 2 * units::pi * periods / (to - from);
  double low = 1e300, high = 0, sum = 0;
  for (std::size_t p = 0; p < count; ++p) {
    const double begin = rises[rises.size() - 1 - count + p], end = rises[rises.size() - count + p];
    double top = -1e300, bottom = 1e300;
    for (const Turn& turn : turns)
      if (turn.t >= begin && turn.t < end) {
        top = std::max(top, turn.x);
        bottom = std::min(bottom, turn.x);
      }
    if (!(top > bottom)) return result;
    const double half = 0.5 * (top - bottom);
    sum += half;
    low = std::min(low, half);
    high = std::max(high, half);
  }
  result.amplitude = sum / periods;
  result.spread = high - low;
  result.found = true;
  return result;
}

}  // namespace railbook::cycles
