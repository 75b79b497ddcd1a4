// The freight car's equations of motion (Hull and Cooperrider 1977, Table 1 reconstructed from eqs
// (1)-(6)):
//
//   M q'' + (C_s + C_c / V) q' + (K_s + K_c) q + sum_j row_j f_j(row_j q')
//       = sum_i [g_R R + g_D D + g_Phi Phi](b_i q / a)
//
// over joints j and wheelsets i. R = (r_L - r_R) / 2a, D = (delta_L - delta_R) / 2 and Phi = phi_w
// are the constraint functions of the wheelset's lateral displacement.
//
//   const auto car = vehicle::assemble({}, vehicle::Suspension::dampers);
//   const auto rates = cycles::at_speed(car, 44 * units::metre / units::second);
//   q2 = rates.acceleration(q, v, [&](double x_over_a) { return Constraint{R, D, Phi}; });
#pragma once

#include <Eigen/Core>
#include <array>

#include <railbook/vehicle/car_parameters.hpp>

namespace railbook::vehicle {

// Coordinates: truck lateral [m], yaw and warp [rad], front F and rear R; body lateral, yaw and
// roll. Lateral is positive to the left, yaw turning left, roll left side up: the paper's frame,
// see wheelset/wheelset_contact.hpp.
enum Coordinate { X_TF, X_TR, TH_TF, TH_TR, TH_WF, TH_WR, X_C, TH_C, PHI_C };
inline constexpr int coordinates = 9;
inline constexpr int wheelsets = 4;  // front leading, front trailing, rear leading, rear trailing
inline constexpr int joints = 7;     // the paper's A1 ... A7

using Vector9 = Eigen::Matrix<double, 9, 1>;
using Matrix9 = Eigen::Matrix<double, 9, 9>;

struct Wheelset {
  Vector9 lateral;          // b: x_w = b q
  Vector9 yaw;              // t: psi = t q
  Vector9 g_r, g_d, g_phi;  // generalized force a unit of R, D, Phi [N, N m]
};

// A suspension joint: its relative motion is row q, in parallel a spring and a damper or a dry
// friction.
struct Joint {
  const char* name;
  Vector9 row;
  double spring = 0;    // already in K_s
  double damper = 0;    // already in C_s; zero where friction acts
  double friction = 0;  // level [N or N m]; zero where the damper acts
  double stick = 0;     // friction is friction * saturate(rate / stick)
};

enum class Suspension { dampers, friction };

struct FreightCar {
  CarParameters data;
  Matrix9 mass;                  // M
  Matrix9 suspension_damping;    // C_s
  Matrix9 creep_damping;         // C_c [N, N m ...]: divide by V
  Matrix9 suspension_stiffness;  // K_s
  Matrix9 creep_stiffness;       // K_c, not symmetric
  std::array<Wheelset, wheelsets> wheels;
  std::array<Joint, joints> joint;
  bool has_friction = false;
};

// Throws InputError (require_valid). Dampers: those of equivalent_dampers(), or given ones.
FreightCar assemble(const CarParameters& data, Suspension suspension);
FreightCar assemble(const CarParameters& data, const Dampers& dampers);

// The row vectors alone: wheelset i (0 ... 3).
Vector9 wheelset_lateral(const CarParameters& data, int i);
Vector9 wheelset_yaw(int i);

struct Constraint {
  double r = 0, d = 0, phi = 0;  // R, D, Phi
};

// The equations at one speed, solved for the acceleration: everything is premultiplied by M^-1.
struct CarAtSpeed {
  double speed = 0;       // [m/s]
  double half_gauge = 0;  // a [m]
  Matrix9 damping, stiffness;
  std::array<Vector9, wheelsets> lateral, g_r, g_d, g_phi;
  std::array<Vector9, joints> joint_row, joint_force;  // joint_force = M^-1 row
  std::array<double, joints> friction{}, stick{};
  bool has_friction = false;

  // q'' from q [m, rad] and v = q'; `constraint` maps x_w / a to a Constraint.
  template <class F>
  Vector9 acceleration(const Vector9& q, const Vector9& v, F&& constraint) const {
    Vector9 result = -damping * v - stiffness * q;
    for (std::size_t i = 0; i < wheelsets; ++i) {
      const Constraint c = constraint(lateral[i].dot(q) / half_gauge);
      result += c.r * g_r[i] + c.d * g_d[i] + c.phi * g_phi[i];
    }
    if (has_friction)
      for (std::size_t j = 0; j < joints; ++j) {
        const double rate = joint_row[j].dot(v) / stick[j];
        result -= friction[j] * (rate > 1 ? 1.0 : rate < -1 ? -1.0 : rate) * joint_force[j];
      }
    return result;
  }
};
// Throws InputError unless speed > 0 [m/s] and finite.
CarAtSpeed at_speed(const FreightCar& car, double speed);

}  // namespace railbook::vehicle
