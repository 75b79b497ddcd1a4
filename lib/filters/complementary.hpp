// Roll from two sensors: an inclinometer, right in the long run, and a gyro, right in the short.
#pragma once

#include <complex>
#include <vector>

namespace railbook::filters {

// theta = L^n [inclinometer] + (1 - L^n) [integral of the gyro], L = 1/(1 + s tau): a cascade of n
// first-order steps theta_j <- a (theta_j + increment) + (1 - a) theta_{j-1}, theta_0 the
// inclinometer, a = exp(-T/tau). The weights of the two paths add up to one for every T; T ->
// infinity leaves the inclinometer.
class ComplementaryFilter {
 public:
  // `tau` > 0, s; 1 <= poles <= 8; throws InputError otherwise.
  explicit ComplementaryFilter(double tau, int poles = 1);

  // `inclination` now (rad); `increment`: change of the angle by the gyro since the last sample
  // (rad); `T` since then (s). Starts on the inclinometer. NaN comes out for a sample with NaN, or
  // with T <= 0 or NaN; after a NaN or a negative T the filter starts anew on the inclinometer, T =
  // 0 (a second pulse) is passed over.
  double push(double inclination, double increment, double T);
  void restart() { known_ = false; }

 private:
  double tau_;
  std::vector<double> theta_;
  bool known_ = false;
};

// tau (s) of a corner (Hz): 1/(2 pi f), to rounding; throws InputError unless f > 0. The paper's
// corner is two octaves below the lateral mode of the car, 1.25 Hz.
double time_constant(double corner);

// Gain of the inclinometer's path, L^n, in continuous time at f Hz; the gyro's is one minus it.
// Relative accuracy 5e-15.
std::complex<double> low_pass_gain(double tau, int poles, double f);
// The same of the filter above for a step T > 0, as accurate for steps of 1e-9 tau too: ((1 - a)/(1
// - a exp(-2 pi i f T)))^n.
std::complex<double> low_pass_gain(double tau, int poles, double f, double T);

// The steady error (rad) of a gyro bias (rad/s): n a T/(1 - a) times it, n tau for small T.
// Relative accuracy 2e-15.
double gyro_bias_error(double bias, double tau, int poles, double T);

}  // namespace railbook::filters
