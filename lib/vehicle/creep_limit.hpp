// Creep forces that friction limits: an option of the car, whose own are Kalker's linear ones.
//
//   Family family = by_speed(car, table);
//   limit_creep(family.oscillator, car, table, {.friction = 0.3});
//
// What is added is the limited force less the linear one, so that small motions are the linear
// car's. As everywhere in this car both wheels of a set have the same creepages (longitudinal with
// opposite signs) and the static load: the constant spin of the two contact angles, which in the
// linear car cancels between them, is left out.
#pragma once

#include <array>
#include <functional>

#include <railbook/cycles/harmonic_cycle.hpp>
#include <railbook/vehicle/car_on_track.hpp>

namespace railbook::vehicle {

// Longitudinal and lateral creep force of a wheel as shares of mu N, from the linear forces f33
// xi_z, f11 xi_x and f12 xi_theta as shares of mu N (`linear`); and the derivative, row by row (6
// numbers), unless null. Continuous with it.
using CreepCurve = std::function<void(const double* linear, double* share, double* slope)>;

struct CreepLimit {
  double friction = 0.3;  // mu > 0
  CreepCurve
      curve{};  // empty: Shen, Hedrick and Elkins (1983), the cubic in the linear force's direction
};

// Adds a coupling for each wheelset. The moment of spin is reduced as the force is. Throws
// InputError unless friction > 0.
void limit_creep(cycles::Oscillator& oscillator, const FreightCar& car,
                 const wheelset::ConstraintFunctions& table, const CreepLimit& limit);

// How hard a cycle uses wheels and rails: the largest of both wheels of each set over a period, at
// `samples` instants.
//   lateral_over_vertical: L/V = (tan d - f)/(1 + f tan d), d the contact plane's angle to the
//   track and f the lateral creep force
//     towards the outside over the normal force N, both at the same instant. At f = mu it is
//     Nadal's limit of the flange's angle.
//   creep: force of longitudinal and lateral creepage over mu N, 0 to 1; 1 slides altogether.
// For a car whose creep friction limits. As everywhere in it N is the static load: what inertia and
// roll move from wheel to wheel is left out of V, and where the table is a running mean over two
// points of contact, so is d.
struct CycleForces {
  std::array<double, wheelsets> lateral_over_vertical{}, creep{};
};
CycleForces cycle_forces(const FreightCar& car, const wheelset::ConstraintFunctions& table,
                         const CreepLimit& limit, const cycles::Cycle& cycle, int samples = 256);

}  // namespace railbook::vehicle
