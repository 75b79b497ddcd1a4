// Heights from accelerations along the track: integrated twice, in a band of wavelengths.
#pragma once

#include <span>
#include <vector>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/filters/wavelength_band.hpp>

namespace railbook::filters {

// What is integrated: samples of the second derivative, or its means over the two intervals about a
// sample with triangular weights, as SecondOrderHybrid gives them: then it is exact.
enum class Curvature { samples, means };

// The filter from the second derivative along the track (1/m) to heights (m), run forward and
// backward: -1/(2 pi phi)^2 times the gain of the band with four poles an edge twice, to 1e-3 of it
// in the band. A bias, and one that drifts evenly, leave nothing. Throws InputError as
// symmetric_taps, and when a wave of the band has fewer than four samples.
FilterTaps double_integral_taps(const Band& band, double spacing,
                                Curvature curvature = Curvature::samples);

// Samples dropped at each end and gap: four times band_decay(), 51 m in D1, 236 m in D2, 664 m in
// D3.
std::size_t double_integral_margin(const Band& band, double spacing);

// Heights (m) in the band of something that is carried along the track: acceleration a (m/s^2)
// upwards and speed v (m/s) at samples a spacing (m) apart; NaN: missing. With a changing speed
// a = v^2 z'' + v v' z'; the slope z' is found with a/v^2 alone, and taken off. Of a wave that
// leaves the square of c = longest/(2 pi) |v'/v| inside the band, and c/4 at its edges. A bias of
// the accelerometer, and an even drift of it, are taken off each stretch without a gap. NaN in the
// margin beside ends and gaps, and in twice that where the speed changes. In the first longest
// wavelength beyond the margin, what they hide is an error of up to 2 % of the rms (seen on
// simulated track with waves up to 1 km: 1.3 %), and farther on it falls by e in each band_decay().
// Throws InputError as the taps, when the spans differ, and for a speed that is not positive.
std::vector<double> integrate_twice(std::span<const double> acceleration,
                                    std::span<const double> speed, const Band& band, double spacing,
                                    Curvature curvature = Curvature::samples);

}  // namespace railbook::filters
