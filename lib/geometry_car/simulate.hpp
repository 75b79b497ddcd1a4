// The journey: track and motion in, what comes out of the sensors' analog filters at each foot
// mark.
//
// Nothing here knows the digital filters. The equations of motion and of the analog filters are
// integrated together in continuous time: over each grid step the track enters as a straight line,
// for which the Taylor series of the linear system is its exact solution, summed to the last digit.
// The attitude terms of second order (cosines, centrifugal acceleration along the body's vertical)
// are filtered likewise, straight over an eighth of the car's shortest time constant at most: 4e-5
// of a channel's largest, at a crawl.
#pragma once

#include <railbook/geometry_car/car.hpp>
#include <railbook/geometry_car/motion.hpp>
#include <railbook/geometry_car/record.hpp>
#include <railbook/geometry_car/track.hpp>

namespace railbook::geometry_car {

// Rows at every crossing of a foot mark, in the order of time. The track counts as continuing level
// and straight on beyond its ends. Throws InputError when the car would leave the track, the rear
// truck included.
Record drive(const Track& track, const Car& car, const Motion& motion);

}  // namespace railbook::geometry_car
