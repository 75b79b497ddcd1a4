// The freight car as a family of oscillators, against its speed or against one of its data.
//
//   const Family family = by_speed(car, table);
#pragma once

#include <optional>

#include <railbook/cycles/continuation.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/vehicle/creep_limit.hpp>

namespace railbook::vehicle {

// The car against speed [m/s], watching its wheelsets; with friction between wheel and rail if a
// limit is given.
cycles::Family by_speed(const FreightCar& car, const wheelset::ConstraintFunctions& table,
                        const std::optional<CreepLimit>& creep = {});
// The car at a speed against one of its data (a positive one). Equivalent dampers follow the
// frictions; dampers given otherwise stay.
cycles::Family by_datum(const FreightCar& car, double CarParameters::*datum,
                        const wheelset::ConstraintFunctions& table, double speed,
                        const std::optional<CreepLimit>& creep = {});

}  // namespace railbook::vehicle
