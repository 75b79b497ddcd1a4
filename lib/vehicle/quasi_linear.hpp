// The car with every nonlinearity replaced by its describing function: eq. (10) of Hull and
// Cooperrider (1977).
//
//   const vehicle::QuasiLinearCar car{assemble({}, Suspension::dampers), wheelset::cn_table()};
//   const auto r = car.evaluate(q, {0, omega}, speed);     // r.residual = 0: a limit cycle q exp(i
//   omega t)
//
//   Z(lambda, V; A) q = [K_s + K_c - sum_i (g_R N_R + g_D N_D + g_Phi N_Phi)(A_i) b_i
//                        + lambda (C_s + C_c / V + sum_j row_j^T N_j(B_j) row_j) + lambda^2 M] q =
//                        0
//
// with A_i = |b_i q| at the wheelsets and the rates' amplitudes B_j = |lambda row_j q| at the
// joints with friction.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>

#include <railbook/vehicle/describing_function.hpp>
#include <railbook/vehicle/freight_car.hpp>
#include <railbook/wheelset/constraint_functions.hpp>

namespace railbook::vehicle {

using Complex = std::complex<double>;
using Vector9c = Eigen::Matrix<Complex, 9, 1>;
using Matrix9c = Eigen::Matrix<Complex, 9, 9>;

// A motion Re(shape exp(lambda t)) at one speed [m/s]: an eigenmode, or with lambda = i omega a
// limit cycle.
struct Motion {
  Vector9c shape = Vector9c::Zero();
  Complex lambda = 0;
  double speed = 0;
};

// |b_i q|: lateral amplitudes of the four wheelsets [m].
std::array<double, wheelsets> wheelset_amplitudes(const FreightCar& car, const Vector9c& shape);
// Index of the largest.
int largest_wheelset(const FreightCar& car, const Vector9c& shape);

class QuasiLinearCar {
 public:
  // Throws InputError when the geometry's half spacing is not the car's half gauge. Where left and
  // right of the geometry differ, the car is linear about its rest, and has no describing
  // functions: at() throws for amplitudes other than 0.
  QuasiLinearCar(FreightCar car, const wheelset::ConstraintFunctions& geometry);

  const FreightCar& car() const { return car_; }
  // Where the car is at rest: zero when left and right are alike.
  const Vector9& rest() const { return rest_; }

  // The gains for a small motion (A = 0), or for the amplitudes of a motion.
  struct Gains {
    std::array<std::array<Gain, 3>, wheelsets> wheel;  // R, D, Phi against x_w [1/m]
    std::array<Gain, joints> joint;  // friction against the rate; zero for dampers
  };
  Gains small() const;
  Gains at(const Vector9c& shape, double frequency) const;

  // The real matrices of the quasi-linear car; damping contains the part C_c / speed.
  struct Matrices {
    Matrix9 stiffness, damping;
  };
  Matrices matrices(const Gains& gains, double speed) const;
  Matrix9c dynamic_stiffness(const Gains& gains, Complex lambda, double speed) const;

  // Z q and its exact derivatives. The gains depend on |q|, so that the derivative by q is
  // real-linear only: by_shape acts on (Re q, Im q) and gives (Re, Im).
  struct Equations {
    Vector9c residual, by_lambda, by_frequency, by_speed;
    Eigen::Matrix<double, 18, 18> by_shape;
  };
  Equations evaluate(const Motion& motion, const Gains& gains) const;

 private:
  FreightCar car_;
  PiecewiseLinearGain table_;
  Vector9 rest_ = Vector9::Zero();
  bool symmetric_ = true;
  std::array<std::array<Gain, 3>, wheelsets> at_rest_{};  // when not symmetric
};

}  // namespace railbook::vehicle
