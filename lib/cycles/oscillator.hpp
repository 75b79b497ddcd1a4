// Systems of up to nine coordinates that are linear but for a few scalars:
//
//   M q'' + (C_0 + u C_1) q' + K q = sum_c G_c f_c(s_c),   s_c = row_c q  or  row_c q',   u = 1/V
//
// with piecewise linear f_c; and, where forces are smooth or depend on several scalars at once,
// couplings beside them.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <limits>
#include <vector>

#include <railbook/cycles/piecewise_linear.hpp>

namespace railbook::cycles {

using Complex = std::complex<double>;
inline constexpr int most_coordinates = 9;
using Vector9 = Eigen::Matrix<double, most_coordinates, 1>;
using Matrix9 = Eigen::Matrix<double, most_coordinates, most_coordinates>;

struct Channel {
  Eigen::VectorXd row;  // n
  bool of_rate = false;
  Eigen::MatrixXd force;  // G: n x outputs of the law
  PiecewiseLinear law;
  double limit = std::numeric_limits<double>::infinity();  // |s| beyond it: derailed, law unknown
};

// G f(s) of several scalars s = of_motion q + (of_rate + u of_rate_by_speed) q', each k x n. `law`
// fills f (m) and its derivative (m x k, row by row; not asked for when null). It must have a
// derivative, and continuous, wherever the motion goes.
struct Coupling {
  Eigen::MatrixXd of_motion, of_rate, of_rate_by_speed;
  Eigen::MatrixXd force;  // G: n x m
  std::function<void(const double* s, double* f, double* slope)> law;

  Eigen::Index inputs() const { return of_motion.rows(); }
  Eigen::Index outputs() const { return force.cols(); }
};

struct Oscillator {
  Eigen::MatrixXd mass, damping, damping_by_speed, stiffness;  // n x n: M, C_0, C_1, K
  double inverse_speed = 0;                                    // u [s/m]
  std::vector<Channel> channels;
  std::vector<Coupling> couplings{};

  Eigen::Index coordinates() const { return mass.rows(); }
};

// The same oscillator at another speed [m/s] > 0. Throws InputError for a bad speed.
Oscillator at_speed(Oscillator oscillator, double speed);

// Where an oscillator without motion has no force left: n. Zero for laws that vanish at rest, else
// found from zero by Newton's method. To 1e-12. Throws InputError when it finds none.
Eigen::VectorXd rest(const Oscillator& oscillator);

// What integrators need, padded to nine coordinates and premultiplied by M^-1.
using State = Eigen::Matrix<double, 18, 1>;         // q, q'
using StateMatrix = Eigen::Matrix<double, 18, 18>;  // of small perturbations
using Acceleration = Eigen::Matrix<double, 9, 18>;  // q'' = J (q, q')
struct CompiledChannel {
  Vector9 row;
  bool of_rate = false;
  PiecewiseLinear law;
  double limit = 0;
  Eigen::Matrix<double, 9, Eigen::Dynamic> constant,
      slope;  // q'' = constant + slope s, a column a piece
};
struct CompiledCoupling {
  Eigen::MatrixXd rows, response;  // s = rows (q, q'), q'' = response f(s)
  std::function<void(const double* s, double* f, double* slope)> law;
};
struct Compiled {
  Acceleration linear;
  std::vector<CompiledChannel> channels;
  std::vector<CompiledCoupling> couplings;

  double scalar(const CompiledChannel& c, const State& y) const {
    return c.of_rate ? c.row.dot(y.tail<9>()) : c.row.dot(y.head<9>());
  }
  // y' = (q', q''); the outermost pieces go on beyond the tables.
  void rate(const State& y, State& dy) const;
  // d(rate)/dy. At a knot, that of the piece above it.
  void jacobian(const State& y, StateMatrix& J) const;
};
// Throws InputError for more than nine coordinates, matrices or rows that do not fit, or a mass
// matrix that is not positive definite.
Compiled compile(const Oscillator& oscillator);

// A state of fewer coordinates (2n: q, q') padded to 18, and back.
State padded(const Eigen::VectorXd& y);
Eigen::VectorXd unpadded(const State& y, Eigen::Index coordinates);

}  // namespace railbook::cycles
