// Hybrid filters: an analog low-pass ahead of the converter, and the digital filter behind it that
// takes the memory of the low-pass out again, so that what is left depends on the last one or two
// sample intervals only.
//
// The paper (Inertial and Inductive Measurement Techniques for Track Geometry, ASME 1981) names
// them B(s) with C(z) and F(s) with G(z) and prints no formula; these follow from the convolution
// integral and hold for any speed history.
//
//   FirstOrderHybrid c{corner};                  // rad/s, of the analog filter
//   const double rate = c.push(voltage, T);      // mean of the input over the last interval T (s)
#pragma once

#include <complex>
#include <limits>

namespace railbook::filters {

// How exp(-kappa) is computed: exactly, or as the processors of the time would have.
enum class Decay {
  exact,
  linear,
  reciprocal,
  pade11,
  pade22
};  // 1 - k, 1/(1 + k), Pade (1,1), (2,2)

// a = exp(-kappa) and 1 - a without cancellation, to 1e-15; kappa >= 0, infinity included.
struct DecayPair {
  double a = 1;
  double rest = 0;  // 1 - a
};
DecayPair decay(double kappa, Decay how = Decay::exact);

// True for an interval between samples that can be one: 0.1 ns < T. Zero, negative or NaN is an
// encoder fault.
bool possible_interval(double T);

// The digital filter C. NaN comes out where an output would rest on what is not known: for the
// first sample (whose T does not matter); for one with T = 0, a second pulse at the same place,
// which is passed over; for one with a negative or NaN T, which is a first sample again; and for a
// NaN sample and the one after it. T = infinity (a stop) is allowed: the filter passes the sample.
class FirstOrderHybrid {
 public:
  // `corner` > 0, rad/s; throws InputError otherwise.
  explicit FirstOrderHybrid(double corner, Decay how = Decay::exact);

  // `y`: output of the analog filter now; `T`: seconds since the previous sample. Returns the mean
  // of the analog filter's input over the interval, with the weight exp(corner (t - now)); NaN
  // where there is none.
  double push(double y, double T);
  void restart() { known_ = false; }

 private:
  double corner_, last_ = 0;
  Decay how_;
  // The last interval and its gain a/(1 - a).
  double interval_ = std::numeric_limits<double>::quiet_NaN(), gain_ = 0;
  bool known_ = false;
};

// F(s) = omega^2/(s^2 + 2 damping omega s + omega^2); damping 1 is the real double pole.
struct SecondOrderLowPass {
  double omega = 0;  // rad/s
  double damping = 1;
};

struct SecondOrderOptions {
  Decay how = Decay::exact;  // others for the double pole only
  bool local = false;  // use the last interval for both: what a filter without memory of T would do
};

// Two intervals of a signal: about sample k - 1 when sample k has just come.
struct TwoIntervals {
  double mean = 0;  // weighted mean of the analog filter's input over both; NaN where there is none
  double T_before = 0;  // s
  double T_after = 0;   // s
};

// The digital filter G, for any two poles with negative real part and any T. Faults as in
// FirstOrderHybrid; it needs two samples to start. With complex poles an interval beyond half a
// period of the damped oscillation, next to another of a different length, cannot be undone: NaN.
class SecondOrderHybrid {
 public:
  // Throws InputError unless omega > 0, damping > 0 (and damping = 1 unless exact).
  explicit SecondOrderHybrid(const SecondOrderLowPass& filter,
                             const SecondOrderOptions& options = {});

  // What filters of the same poles and options share at two intervals.
  struct Weights {
    double before = -1, after = -1;  // s
    double alpha = 0, beta = 0, area = 1;
  };
  Weights weights(double before, double after) const;

  // `ready` is taken where it is of the two intervals, or else computed; the result is the same.
  TwoIntervals push(double y, double T, const Weights* ready = nullptr);
  void restart() { known_ = 0; }

 private:
  SecondOrderLowPass filter_;
  SecondOrderOptions options_;
  double last_ = 0, before_ = 0, T_ = 0;
  int known_ = 0;
};

// The short mid-chord offset z_k - (z_{k-1} + z_{k+1})/2 from the mean acceleration over both
// intervals: exact in the limit of a low corner. `step` is z_k - z_{k-1}, which a change of speed
// multiplies by T_after/T_before - 1; it counts only where the speed changes, and a signal that
// already is V^2 z'' does not need it. NaN when the mean is, or when an interval is infinite. To
// rounding of its terms.
double short_chord(const TwoIntervals& acceleration, double step = 0);

// Frequency responses at constant speed. theta = 2 pi phi d: radians a sample (phi cycle/m, d m
// between samples). Relative accuracy 2e-15 of the first order and, over 1 + |F|, 4e-15 of F; 1e-12
// of the second is what its test can tell.
std::complex<double> first_order_analog(double kappa, double theta);  // B; kappa = corner T
std::complex<double> first_order_digital(double kappa, double theta,
                                         Decay how = Decay::exact);                             // C
std::complex<double> second_order_analog(const SecondOrderLowPass& f, double T, double theta);  // F
// G with its delay of one sample left in: FG has the phase of a kernel centred one sample ago.
std::complex<double> second_order_digital(const SecondOrderLowPass& f, double T, double theta);
// Their limit for kappa -> 0, in magnitude, |BC| -> sinc and |FG| -> sinc^2; to rounding.
double sinc_limit(double theta);

// The centroid of the kernel of BC lies this share of T before the sample: 1/kappa - a/(1-a),
// between 0 (fast corner) and 1/2 (slow corner); relative accuracy 1e-13.
double centroid_delay(double kappa);

}  // namespace railbook::filters
