// The data of the nine-degree-of-freedom freight car of Hull and Cooperrider (1977), Table 2.
//
//   vehicle::CarParameters car;                       // the paper's empty 80-ton hopper
//   car.warp_stiffness *= 2;                           // SI inside
//   vehicle::require_valid(car);                      // throws InputError naming what is wrong
#pragma once

#include <span>
#include <string_view>

#include <railbook/units/constants.hpp>
#include <railbook/units/quantity.hpp>

namespace railbook::vehicle {

// All SI. The defaults are Table 2 of the paper; what is not printed there is marked in car_data().
struct CarParameters {
  // Bodies [kg], [kg m^2]
  double body_mass = 1101 * units::slug;
  double bolster_mass = 36.1 * units::slug;
  double sideframe_mass = 24.0 * units::slug;
  double wheelset_mass = 76.6 * units::slug;
  double body_yaw_inertia = 234000 * units::slug * units::foot * units::foot;
  double body_roll_inertia = 13000 * units::slug * units::foot * units::foot;
  double bolster_yaw_inertia = 178.6 * units::slug * units::foot * units::foot;
  double bolster_roll_inertia = 178.6 * units::slug * units::foot * units::foot;
  double sideframe_yaw_inertia = 77.6 * units::slug * units::foot * units::foot;
  double wheelset_yaw_inertia = 448.5 * units::slug * units::foot * units::foot;
  // Springs: lateral and vertical a side frame [N/m], warp a truck [N m/rad]
  double lateral_stiffness = 24000 * units::lbf / units::foot;
  double vertical_stiffness = 265800 * units::lbf / units::foot;
  double warp_stiffness = 3.81e6 * units::foot * units::lbf;
  // Dry friction: lateral and vertical a side frame [N], warp and centre plate a truck [N m]
  double lateral_friction = 5200 * units::lbf;
  double vertical_friction = 3120 * units::lbf;
  double warp_friction = 421 * units::foot * units::lbf;
  double centre_plate_friction = 606 * units::foot * units::lbf;
  // The rate below which regularized friction is viscous [m/s], [rad/s]
  double stick_speed = 0.005 * units::foot;
  double stick_rate = 0.0005;
  // The motion at which equivalent_dampers() linearizes friction [rad/s], [m], [rad]
  double damper_frequency = 20;
  double damper_travel = 0.5 * units::inch;
  double damper_angle = 0.003;
  // Creep coefficients of one wheel: N, N m, N m^2, N
  double f11 = 1.15e6 * units::lbf;
  double f12 = 6750 * units::foot * units::lbf;
  double f22 = 42.1 * units::foot * units::foot * units::lbf;
  double f33 = 1.262e6 * units::lbf;
  // Lengths [m]
  double half_gauge = 2.48 * units::foot;              // a
  double half_sideframe_spacing = 3.25 * units::foot;  // d
  double wheel_radius = 1.375 * units::foot;           // r_0
  double half_wheelbase = 2.833 * units::foot;         // L_T
  double half_truck_distance = 16.9 * units::foot;     // L_C
  double bolster_depth = 2.99 * units::foot;  // h_2, bolster below the body's centre of gravity

  friend bool operator==(const CarParameters&, const CarParameters&) = default;
};

// Viscous dampers in place of the frictions: N s/m a side frame, N m s/rad a truck.
struct Dampers {
  double lateral = 0, vertical = 0, warp = 0, centre_plate = 0;
};
// c = 4 F / (pi omega A), the describing function of friction at one amplitude and one frequency.
// The paper says "constant amplitudes and frequency" and not which; damper_frequency and its like
// are a reconstruction.
Dampers equivalent_dampers(const CarParameters& car);

// Load on one axle [N]: a quarter of the car's weight.
double axle_load(const CarParameters& car);

enum class Origin { printed, restored, reconstructed };

// One datum, for tables, options and checks.
struct CarDatum {
  const char* key;     // "body-mass"
  const char* symbol;  // as in the paper, LaTeX
  const char* name;
  double CarParameters::*member;
  units::Dimension dimension;
  const char* unit;  // the paper's, "slug ft²"
  double unit_si;
  bool positive;  // or only not negative
  Origin origin;
  const char* remark;  // why it is not simply printed
};
std::span<const CarDatum> car_data();

// Throws InputError naming the first datum that is not finite, or not positive (bodies, lengths,
// creep coefficients f11 and f33, linearization and sticking speeds), or negative (all others).
void require_valid(const CarParameters& car);

}  // namespace railbook::vehicle
