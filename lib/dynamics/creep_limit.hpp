// Creep forces that friction limits: an option of the car, whose own are Kalker's linear ones.
//
//   Family family = by_speed(car, table);
//   limit_creep(family.oscillator, car, table, {.friction = 0.3});
//
// What is added is the limited force less the linear one, so that small motions are the linear car's. As everywhere in this car both
// wheels of a set have the same creepages (longitudinal with opposite signs) and the static load: the constant spin of the two
// contact angles, which in the linear car cancels between them, is left out.
#pragma once

#include <array>
#include <functional>

#include "dynamics/oscillator.hpp"

namespace railbook::dynamics {

// Longitudinal and lateral creep force of a wheel as shares of mu N, from the linear forces f33 xi_z, f11 xi_x and f12 xi_theta
// as shares of mu N.
using CreepCurve =
    std::function<std::array<double, 2>(double longitudinal, double lateral, double spin)>;

struct CreepLimit {
  double friction = 0.3;  // mu > 0
  CreepCurve
      curve{};  // empty: Shen, Hedrick and Elkins (1983), the cubic in the linear force's direction
};

// Adds a coupling for each wheelset. The moment of spin is reduced as the force is. Throws InputError unless friction > 0.
void limit_creep(Oscillator& oscillator, const FreightCar& car,
                 const wheelrail::ConstraintFunctions& table, const CreepLimit& limit);

}  // namespace railbook::dynamics
