// Regression of the two-slope spectrum on log-log paper.
#pragma once

#include <Eigen/Core>

namespace railbook::spectra {

// Points (ln phi, ln S) to fit, in ascending order of phi, each with a weight proportional to
// 1/variance.
struct LogPoints {
  Eigen::ArrayXd log_phi;
  Eigen::ArrayXd
      log_density;  // free of bias: the mean of the logarithm is the logarithm of the mean
  Eigen::ArrayXd weight;
};

enum class CornerState { fitted, none, at_low_bound, at_high_bound };

// ln S = ln(exp(ln A - 2 ln phi + min(0, 2 (ln phi_c - ln phi))) + noise).
struct LogFit {
  double log_A = 0;
  double log_corner = 0;  // ln phi_c; +infinity without a corner
  double noise = 0;
  CornerState corner = CornerState::none;
  double squares = 0;  // weighted sum of squared residuals
  Eigen::Matrix3d inverse_normal =
      Eigen::Matrix3d::Zero();  // of (ln A, ln phi_c, ln noise); times the
                                // variance at weight 1 it is the covariance
  Eigen::Index points = 0;      // fitted to
  int iterations = 0;
  bool converged = true;

  double log_density(double log_phi) const;
  // The derivatives of log_density by ln A, ln phi_c and ln noise; 0 for what was not fitted.
  Eigen::Vector3d gradient(double log_phi) const;
};

// One slope of -2: the weighted mean, to rounding. Throws InputError with fewer than 2 points.
LogFit fit_one_slope(const LogPoints& points);

// Slopes -2 and -4 with the corner in [low, high] (cycle/m): the exact global minimum. For a corner
// between two given neighbouring points the problem is two weighted means, so going through all
// gaps costs O(n). A corner on a bound (or within 3 % of it) is reported as such, and then only one
// of A and A phi_c^2 means anything. Throws InputError with fewer than 8 points, or without points
// on both sides of the allowed range.
LogFit fit_two_slopes(const LogPoints& points, double low, double high);

// Adds a white floor to `start` (its own noise, if any, is where to begin) by damped Gauss-Newton
// steps in (ln A, ln phi_c, ln noise): a minimum near `start`, which must lie within a factor of
// two or so of it. The corner's passing over points makes others, some percent higher; from a start
// without a floor where there is one it may settle at one ten times as high. `converged` is false
// when the steps did not settle, or the floor fell below 1e-6 of the smallest point (there is
// none).
[[nodiscard]] LogFit fit_with_noise(const LogPoints& points, const LogFit& start, double low,
                                    double high);

}  // namespace railbook::spectra
