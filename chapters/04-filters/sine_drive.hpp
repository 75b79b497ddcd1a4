// Filters driven by sines: the other way to a frequency response.
#pragma once

#include <complex>

#include "filters/hybrid_filter.hpp"

namespace railbook::filters_chapter {

// Gains at one speed, with the phase at the sample: analog alone, digital alone, both.
struct Gains {
  std::complex<double> analog, digital, hybrid;
};

// A sine of theta radians a sample, T seconds long, goes into the analog filter as a differential equation that is
// integrated numerically (Dormand-Prince, local error 1e-12) until it swings steadily; what comes out is
// sampled and goes into the digital filter. The hybrid gain is taken with the filter newly started in the middle.
Gains drive_first_order(double corner, double T, double theta);
Gains drive_second_order(const filters::SecondOrderLowPass& filter, double T, double theta);

// The same by formula.
Gains first_order_gains(double corner, double T, double theta);
Gains second_order_gains(const filters::SecondOrderLowPass& filter, double T, double theta);

}  // namespace railbook::filters_chapter
