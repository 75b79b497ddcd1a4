// The freight car on its rails as an oscillator.
//
//   const Oscillator car = car_on_track(assemble({}, Suspension::dampers), table, 150 *
//   units::foot);
#pragma once

#include <railbook/cycles/oscillator.hpp>
#include <railbook/vehicle/freight_car.hpp>
#include <railbook/wheelset/constraint_functions.hpp>

namespace railbook::vehicle {

// The car on a pair of profiles at a speed [m/s] > 0: channels 0 ... 3 are the wheelsets'
// displacements [m], with the end of the table as limit, and, if the car has friction, 4 ... 10 the
// rates of its joints. Throws InputError for a bad speed or empty table.
cycles::Oscillator car_on_track(const FreightCar& car, const wheelset::ConstraintFunctions& table,
                                double speed);

}  // namespace railbook::vehicle
