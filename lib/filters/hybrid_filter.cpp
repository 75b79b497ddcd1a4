#include <railbook/filters/hybrid_filter.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::filters {
namespace {

using Complex = std::complex<double>;

// q(T), the solution of q'' + 2 s q' + p q = 0 with q(0) = 0, q'(0) = 1, its companion exp(-sT) cos
// (or cosh), and area(T) = p times the integral of q from 0 to T.
struct Mode {
  double q = 0;
  double area = 0;
};

// For small T the area cancels, as the output does that is divided by it.
Mode mode_at(double s, double p, double T) {
  const double split = p - s * s;
  if (split == 0) {  // the double pole
    const double e = std::exp(-s * T);
    return {e * T, 1 - e * (1 + s * T)};
  }
  const double w = std::sqrt(std::abs(split));
  if (split < 0 && w * T > 1) {
    const double slow = std::exp(-(s - w) * T), fast = std::exp(-(s + w) * T);
    const double q = (slow - fast) / (2 * w);
    return {q, 1 - (slow + fast) / 2 - s * q};
  }
  const double e = std::exp(-s * T), turn = w * T;
  const double sine = turn == 0 ? T : (split > 0 ? std::sin(turn) : std::sinh(turn)) / w;
  const double cosine = split > 0 ? std::cos(turn) : std::cosh(turn);
  return {e * sine, 1 - e * (cosine + s * sine)};
}

// y_{k+1} - alpha y_k + beta y_{k-1} takes both modes out; `area` is the weight of a constant in
// it.
struct Annihilator {
  double alpha = 0, beta = 0, area = 1;
};

// The rate of the mode that lasts longest.
double slow_rate(const SecondOrderLowPass& f) {
  const double z = f.damping;
  return z > 1 ? f.omega / (z + std::sqrt(z * z - 1)) : z * f.omega;
}

constexpr double forgotten = 300;  // exp(-300) is nothing, and its square still a number

// With complex poles, T below half a period: q > 0, and the weight has one sign.
Annihilator annihilator(const SecondOrderLowPass& f, double before, double after) {
  const double slow = slow_rate(f);
  if (slow * after > forgotten) return {0, 0, 1};
  if (slow * before > forgotten) {
    if (f.damping < 1) return {units::nan, units::nan, units::nan};
    const double split = 2 * f.omega * std::sqrt(f.damping * f.damping - 1);
    const double r = std::isinf(before) ? 0
                     : split == 0
                         ? after / before
                         : std::expm1(-split * (before + after)) / std::expm1(-split * before) - 1;
    const double e = std::exp(-slow * after);
    return {e * (1 + r), 0, -std::expm1(-slow * after) - e * r};
  }
  const double s = f.damping * f.omega, p = f.omega * f.omega;
  const double longer = std::max(before, after);
  if ((p - s * s) * longer * longer >= units::pi * units::pi)
    return {units::nan, units::nan, units::nan};
  const Mode first = mode_at(s, p, before), second = mode_at(s, p, after);
  const double alpha = mode_at(s, p, before + after).q / first.q;
  const double e = std::exp(-s * before);
  const double beta = e * e * second.q / first.q;
  if (s * before > 20) return {alpha, beta, 1 - alpha + beta};
  // Two positive terms, so without cancellation; back in time the mode grows, hence -s.
  return {alpha, beta, second.area + beta * mode_at(-s, p, before).area};
}

// One speed: the same without the condition.
Annihilator constant_speed(const SecondOrderLowPass& f, double T) {
  const double s = f.damping * f.omega, p = f.omega * f.omega;
  if (s * T + p * T * T < 1) return annihilator(f, T, T);
  if (slow_rate(f) * T > forgotten) return {0, 0, 1};
  const double beta = std::exp(-2 * s * T);
  const Complex w = std::sqrt(Complex{s * s - p});
  const double alpha = (std::exp(-(s - w) * T) + std::exp(-(s + w) * T)).real();
  return {alpha, beta, 1 - alpha + beta};
}

Annihilator approximate(double omega, double before, double after, Decay how) {
  const double first = decay(omega * before, how).a, second = decay(omega * after, how).a;
  const double r = std::isinf(before) ? 0 : after / before;
  if (!std::isfinite(first) || !std::isfinite(second) || !std::isfinite(r))
    return {units::nan, units::nan, units::nan};
  const double alpha = second * (1 + r), beta = first * second * r;
  if (!(std::abs(alpha) < 1e300 && std::abs(beta) < 1e300))
    return {units::nan, units::nan, units::nan};
  return {alpha, beta, 1 - alpha + beta};
}

// a/(1 - a), NaN where there is none. Beyond 700 a is nothing beside 1, and its inverse still a
// number.
double gain(double kappa, Decay how) {
  if (how == Decay::exact && kappa > 0) return 1 / std::expm1(std::min(kappa, 700.0));
  const DecayPair d = decay(kappa, how);
  return d.rest != 0 && std::isfinite(d.rest) ? d.a / d.rest : units::nan;
}

double centred(double kappa) {  // 1/kappa - a/(1-a) - 1/2 for small kappa, by its Bernoulli series
  const double k2 = kappa * kappa;
  return -kappa / 12 * (1 - k2 / 60 * (1 - k2 / 42 * (1 - k2 / 40 * (1 - k2 * 10 / 396))));
}

}  // namespace

DecayPair decay(double kappa, Decay how) {
  const double k = kappa;
  if (how == Decay::exact) return {std::exp(-k), -std::expm1(-k)};
  if (how == Decay::linear) return {1 - k, k};
  if (how == Decay::reciprocal) return {1 / (1 + k), std::isinf(k) ? 1 : k / (1 + k)};
  if (k > 1e100) return how == Decay::pade11 ? DecayPair{-1, 2} : DecayPair{1, 0};
  if (how == Decay::pade11) return {(2 - k) / (2 + k), 2 * k / (2 + k)};
  const double d = 12 + k * (6 + k);
  return {(12 - k * (6 - k)) / d, 12 * k / d};
}

bool possible_interval(double T) {
  return std::isgreater(T, 1e-10);
}

FirstOrderHybrid::FirstOrderHybrid(double corner, Decay how)
    : corner_(units::require_positive("corner of the filter", corner, "rad/s")), how_(how) {}

// u_k = (y_k - a y_{k-1})/(1 - a), written in the difference of the samples: a constant passes
// unchanged whatever the rounding.
double FirstOrderHybrid::push(double y, double T) {
  if (T == 0 && known_) return units::nan;    // a second pulse at the same place
  if (!possible_interval(T)) known_ = false;  // as if it were the first sample
  double u = units::nan;
  if (known_ && std::isfinite(y)) {
    if (T != interval_) {  // the speed has changed
      interval_ = T;
      gain_ = gain(corner_ * T, how_);  // a/(1 - a), a = exp(-corner T)
    }
    if (std::isfinite(gain_)) u = y + gain_ * (y - last_);
  }
  known_ = std::isfinite(y);
  last_ = y;
  return u;
}

SecondOrderHybrid::SecondOrderHybrid(const SecondOrderLowPass& filter,
                                     const SecondOrderOptions& options)
    : filter_(filter), options_(options) {
  units::require_positive("corner of the filter", filter.omega, "rad/s");
  units::require_positive("damping of the filter", filter.damping);
  if (options.how != Decay::exact && filter.damping != 1)
    throw InputError{"damping is not 1: an approximate decay is for the double pole only"};
}

SecondOrderHybrid::Weights SecondOrderHybrid::weights(double before, double T) const {
  if (options_.local) before = T;
  const Annihilator g = options_.how != Decay::exact
                            ? approximate(filter_.omega, before, T, options_.how)
                        : before == T ? constant_speed(filter_, T)
                                      : annihilator(filter_, before, T);
  return {before, T, g.alpha, g.beta, g.area};
}

TwoIntervals SecondOrderHybrid::push(double y, double T, const Weights* ready) {
  if (!possible_interval(T)) {
    if (T == 0 && known_ > 0) return {units::nan, units::nan, units::nan};
    known_ = 0;
  }
  TwoIntervals out{units::nan, T_, T};
  if (!std::isfinite(y)) {
    known_ = 0;
    return out;
  }
  if (known_ == 2) {
    const double before = options_.local ? T : T_;
    const bool fits = ready != nullptr && ready->before == before && ready->after == T;
    const Weights g = fits ? *ready : weights(before, T);
    // A constant passes unchanged whatever the rounding: written in differences.
    if (g.area != 0 && std::isfinite(g.area))
      out.mean = y + (g.alpha * (y - last_) - g.beta * (y - before_)) / g.area;
  } else {
    ++known_;
  }
  before_ = last_;
  last_ = y;
  T_ = T;
  return out;
}

double short_chord(const TwoIntervals& a, double step) {
  if (!std::isfinite(a.mean) || std::isinf(a.T_before) || std::isinf(a.T_after)) return units::nan;
  return -0.5 * (0.5 * a.T_after * (a.T_before + a.T_after) * a.mean +
                 (a.T_after / a.T_before - 1) * step);
}

Complex first_order_analog(double kappa, double theta) {
  return kappa / Complex{kappa, theta};
}

namespace {

// 1 - exp(-i theta).
Complex one_less(double theta) {
  return {2 * std::pow(std::sin(theta / 2), 2), std::sin(theta)};
}

// (1 - e z)/(1 - e), e = exp(-k): the filter that takes out one mode; a sum in which nothing
// cancels.
Complex mode_taken_out(Complex k, double theta) {
  if (k.real() > forgotten) return 1;
  const double size = std::exp(-k.real());
  const Complex rest{-std::expm1(-k.real()) + 2 * size * std::pow(std::sin(k.imag() / 2), 2),
                     size * std::sin(k.imag())};
  return 1.0 + std::polar(size, -k.imag()) / rest * one_less(theta);
}

}  // namespace

Complex first_order_digital(double kappa, double theta, Decay how) {
  const DecayPair d = decay(kappa, how);
  return 1.0 + d.a / d.rest * one_less(theta);
}

Complex second_order_analog(const SecondOrderLowPass& f, double T, double theta) {
  const double k = f.omega * T;
  return k * k / Complex{(k - theta) * (k + theta), 2 * f.damping * k * theta};
}

Complex second_order_digital(const SecondOrderLowPass& f, double T, double theta) {
  if (f.damping >= 1) {
    const double slow = slow_rate(f), fast = f.omega * f.omega / slow;
    return mode_taken_out(slow * T, theta) * mode_taken_out(fast * T, theta);
  }
  const Complex k = f.omega * T * Complex{f.damping, std::sqrt((1 - f.damping) * (1 + f.damping))};
  return mode_taken_out(k, theta) * mode_taken_out(std::conj(k), theta);
}

double sinc_limit(double theta) {
  return theta == 0 ? 1 : std::sin(theta / 2) / (theta / 2);
}

double centroid_delay(double kappa) {
  if (kappa < 0.3) return 0.5 + centred(kappa);
  const DecayPair d = decay(kappa);
  return 1 / kappa - d.a / d.rest;
}

}  // namespace railbook::filters
