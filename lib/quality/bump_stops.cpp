#include <railbook/quality/bump_stops.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include <railbook/num/quadrature.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::quality {
namespace {

using Complex = std::complex<double>;

double rate_of(double frequency) {
  return 2 * units::pi * frequency;
}

// The homogeneous solution over a time t: exp(-decay t) times these.
struct Free {
  double decay, stiffness;

  struct At {
    double e, c, s;
  };
  At at(double t) const {
    const double square = stiffness - decay * decay, root = std::sqrt(std::abs(square));
    const double e = std::exp(-decay * t);
    if (root * t < 1e-8) return {e, 1, t};
    if (square > 0) return {e, std::cos(root * t), std::sin(root * t) / root};
    return {e, std::cosh(root * t), std::sinh(root * t) / root};
  }
  Eigen::Matrix2d tangent(const At& a) const {
    Eigen::Matrix2d m;
    m << a.e * (a.c + decay * a.s), a.e * a.s, -a.e * stiffness * a.s, a.e * (a.c - decay * a.s);
    return m;
  }
};

// The forced solution on one branch of the stops: Im sum (p + q t) exp(i w t) and an offset.
struct Forced {
  struct Part {
    Complex p, q, a, b;  // solution, and forcing (a + b t) exp(i w t)
    double rate;
  };
  std::vector<Part> parts;
  double offset = 0;

  struct At {
    double x, v, force;
  };
  At at(double t) const {
    At sum{offset, 0, 0};
    for (const Part& part : parts) {
      const Complex turn{std::cos(part.rate * t), std::sin(part.rate * t)};
      const Complex x = (part.p + part.q * t) * turn;
      sum.x += x.imag();
      sum.v += (part.q * turn).imag() + part.rate * x.real();
      sum.force += ((part.a + part.b * t) * turn).imag();
    }
    return sum;
  }
};

class Runner {
 public:
  Runner(const StoppedBody& body, const Track& track, const Motion& start,
         const RunOptions& options)
      : body_(body), track_(track), options_(options), now_(start) {
    const double rate = rate_of(body.suspension.frequency);
    stiffness_ = rate * rate;
    damping_ = 2 * body.suspension.damping * rate;
    fastest_ = 0;
    for (const Wave& wave : track.waves) fastest_ = std::max(fastest_, wave.frequency);
    if (options.audit) rule_ = num::gauss_legendre(8, 0, 1);
    stop_ = std::abs(now_.x) > body.gap ? (now_.x > 0 ? 1 : -1) : 0;
    result_.energy.gained = -held();
    result_.energy.scale = held();
  }

  Run to(double end) {
    if (track_.ramp > now_.t && track_.ramp < end) {
      leg(track_.ramp);
      const double before = held();
      for (const Wave& w : track_.waves)
        now_.v +=
            w.amplitude / track_.ramp * std::sin(rate_of(w.frequency) * track_.ramp + w.phase);
      result_.energy.input += held() - before;  // the kink of the track at the ramp's end
    }
    leg(end);
    result_.end = now_;
    if (!result_.complete) result_.largest = std::numeric_limits<double>::quiet_NaN();
    result_.energy.gained += held();
    if (watched_ > 0) result_.mean_square /= watched_;
    return result_;
  }

 private:
  double held() const {
    const double over = stop_ == 0 ? 0 : std::abs(now_.x) - body_.gap;
    return 0.5 * (now_.v * now_.v + stiffness_ * (now_.x * now_.x + body_.kappa * over * over));
  }

  // Forced and free solution on the present branch.
  void branch() {
    const double k = stop_ == 0 ? stiffness_ : (1 + body_.kappa) * stiffness_;
    free_ = {0.5 * damping_, k};
    forced_.offset = stop_ == 0 ? 0 : stop_ * body_.kappa * stiffness_ * body_.gap / k;
    forced_.parts.clear();
    const bool ramping = now_.t < track_.ramp;
    for (const Wave& wave : track_.waves) {
      const double w = rate_of(wave.frequency);
      const Complex size = std::polar(wave.amplitude, wave.phase);
      const Complex a = ramping ? Complex{0, -2 * w / track_.ramp} * size : w * w * size;
      const Complex b = ramping ? w * w / track_.ramp * size : 0;
      const Complex denominator{k - w * w, damping_ * w};
      const Complex q = b / denominator;
      forced_.parts.push_back({(a - q * Complex{damping_, 2 * w}) / denominator, q, a, b, w});
    }
    step_ = 1 / (24 * std::max(fastest_, std::sqrt(k) / (2 * units::pi)));
    full_ = free_.at(step_);
  }

  // The state `t` after the beginning of the step.
  Motion after(double t, const Free::At& f) const {
    const Forced::At p = forced_.at(now_.t + t);
    const double c = now_.x - at_begin_.x, s = now_.v - at_begin_.v + free_.decay * c;
    const double square = free_.stiffness - free_.decay * free_.decay;
    return {now_.t + t, p.x + f.e * (c * f.c + s * f.s),
            p.v + f.e * ((s - free_.decay * c) * f.c - (free_.decay * s + square * c) * f.s)};
  }
  Motion after(double t) const { return after(t, free_.at(t)); }

  // Not negative while the branch lasts; rounding at a touch is no end.
  double margin(const Motion& m) const {
    return (stop_ == 0 ? body_.gap - std::abs(m.x) : stop_ * m.x - body_.gap) + 4e-15 * body_.gap;
  }

  void leg(double end) {
    branch();
    for (int still = 0; now_.t < end && result_.complete;) {
      at_begin_ = forced_.at(now_.t);
      const bool full = now_.t + step_ < end;
      const double length = full ? step_ : end - now_.t;
      Motion next = full ? after(length, full_) : after(length);
      if (!full) next.t = end;
      // A touch that rounding cannot place: on by a little, for at the stop the force is the same
      // on both branches.
      if (still > 2 && still % 2 == 1) {
        const double t = 1e-5 * length;
        keep(t, after(t), free_.at(t));
        ++still;
        continue;
      }
      // Switches that follow each other within rounding are no progress: they would never end.
      const double before = now_.t;
      still = advance(length, next, full) && now_.t - before > 1e-9 * length ? 0 : still + 1;
      if (still > 20) result_.complete = false;
      ++result_.pieces;
    }
  }

  // One step, or the part of it up to the first switch. False when no time has passed.
  bool advance(double length, const Motion& next, bool full) {
    if (!std::isfinite(next.x)) {
      result_.complete = false;
      return true;
    }
    double turn = 0;
    Motion middle = next;
    if (now_.v * next.v < 0) {
      const auto root = num::find_root([&](double t) { return after(t).v; }, 0, length, 1e-14);
      turn = root.x;
      middle = after(turn);
      if (margin(middle) < 0) return change(0, turn);
      look(middle);
    }
    if (margin(next) < 0) return change(turn, length);
    keep(length, next, full ? full_ : free_.at(length));
    return true;
  }

  // The branch ends between two times of the step; x is monotone there, and may come from the other
  // stop.
  bool change(double from, double to) {
    const int reached = stop_ != 0 ? stop_ : after(to).x > 0 ? 1 : -1;
    const auto before = [&](double t) {
      const double rest = body_.gap - reached * after(t).x;
      return stop_ == 0 ? rest : -rest;
    };
    double t = from;
    if (before(from) > 0) {
      const auto root = num::find_root(before, from, to, 1e-15);
      result_.complete &= root.converged || root.width < 1e-12 * to;  // rounding may end it there
      t = root.x;
    }
    if (t > 0) keep(t, after(t), free_.at(t));
    now_.x = reached * body_.gap;
    stop_ = stop_ == 0 ? reached : 0;
    result_.switches.push_back({now_.t, stop_});
    branch();
    return t > 0;
  }

  void look(const Motion& m) {
    if (m.t < options_.watch_from || std::abs(m.x) <= result_.largest) return;
    result_.largest = std::abs(m.x);
    result_.largest_at = m.t;
  }

  void keep(double length, const Motion& next, const Free::At& f) {
    for (Eigen::Index i = 0; i < rule_.x.size(); ++i) {  // none without an audit
      const Motion m = after(length * rule_.x[i]);
      const double weight = length * rule_.w[i];
      result_.energy.input += weight * m.v * forced_.at(m.t).force;
      result_.energy.lost += weight * damping_ * m.v * m.v;
      if (now_.t >= options_.watch_from) result_.mean_square += weight * m.x * m.x;
    }
    if (now_.t >= options_.watch_from) watched_ += length;
    result_.tangent = free_.tangent(f) * result_.tangent;
    look(now_);
    now_ = next;
    look(now_);
    result_.energy.scale = std::max(result_.energy.scale, held());
  }

  StoppedBody body_;
  Track track_;
  RunOptions options_;
  Motion now_;
  double stiffness_ = 0, damping_ = 0, fastest_ = 0, step_ = 0, watched_ = 0;
  int stop_ = 0;
  Free free_{};
  Free::At full_{};
  Forced forced_;
  Forced::At at_begin_{};
  num::GaussRule rule_;
  Run result_;
};

}  // namespace

void require(const StoppedBody& body) {
  units::require_positive("natural frequency of the body", body.suspension.frequency, "Hz");
  units::require_positive("damping of the body", body.suspension.damping);
  if (!(body.gap > 0)) units::require_positive("gap of the stops", body.gap, "m");
  units::require_between("stiffness of the stops over the spring's", body.kappa, 0, 1e12);
}

double height(const Track& track, double t) {
  double z = 0;
  for (const Wave& w : track.waves) z += w.amplitude * std::sin(rate_of(w.frequency) * t + w.phase);
  return t < track.ramp ? z * t / track.ramp : z;
}

double wheel_rate(const Track& track, double t) {
  double rate = 0;
  for (const Wave& w : track.waves) {
    const double angle = rate_of(w.frequency) * t + w.phase;
    rate += w.amplitude *
            (t < track.ramp
                 ? (std::sin(angle) + rate_of(w.frequency) * t * std::cos(angle)) / track.ramp
                 : rate_of(w.frequency) * std::cos(angle));
  }
  return rate;
}

Motion at_rest(const Track& track) {
  return {0, 0, track.ramp > 0 ? -wheel_rate(track, 0) : 0};
}

double Energy::defect() const {
  const double size = std::max(std::abs(input), scale);
  return size > 0 ? std::abs(input - lost - gained) / size : 0;
}

Run run(const StoppedBody& body, const Track& track, const Motion& start, double end,
        const RunOptions& options) {
  require(body);
  double fastest = body.suspension.frequency * std::sqrt(1 + body.kappa);
  for (const Wave& w : track.waves) {
    units::require_finite("amplitude of a wave", w.amplitude, "m");
    units::require_positive("frequency of a wave", w.frequency, "Hz");
    fastest = std::max(fastest, w.frequency);
  }
  units::require_non_negative("ramp", track.ramp, "s");
  units::require_between("duration times the fastest frequency", (end - start.t) * fastest, 0, 4e6);
  return Runner{body, track, start, options}.to(end);
}

}  // namespace railbook::quality
