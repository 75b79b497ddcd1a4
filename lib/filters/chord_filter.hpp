// From the short mid-chord offset, z_k - (z_{k-1} + z_{k+1})/2, to the offset of a chord of 2N samples: exact, since
// (1 - cos N t)/(1 - cos t) is a polynomial in cos t, the square of the sum of N shifts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "spectra/chord.hpp"

namespace railbook::filters {

// The 2N - 1 integer weights N - |j|. Their sum, the gain at DC, is N^2. 1 <= N <= 10^6, else InputError.
std::vector<std::int64_t> chord_taps(int half_chord);

// sqrt(N (2 N^2 + 1)/3): standard deviation of the long offset over that of white noise on the short one.
double chord_noise_gain(int half_chord);

// Gain of the filter at theta radians a sample: (sin(N theta/2)/sin(theta/2))^2, N^2 at multiples of 2 pi.
double short_to_long_gain(int half_chord, double theta);

// sin(M theta/2)/(M sin(theta/2)): the gain of a mean over M samples. M >= 1.
double mean_gain(int M, double theta);

// Offsets of the chord of 2N samples from the short ones, by the weights: N - 1 samples are lost at each end. A NaN
// gives NaN within N - 1 samples of it. Throws InputError on a record of fewer than 2N - 1 samples.
spectra::ChordOffsets to_chord(std::span<const double> short_offsets, int half_chord);

// out[i] = x[i] + ... + x[i + length - 1], by a running sum that starts anew every `restart` outputs (0: never).
// Cascade two for a chord; never both in one recursion. Numbers wrap in unsigned integers, and the result is exact if
// it fits. Throws InputError unless 1 <= length <= x.size().
template <class Number>
std::vector<Number> running_sum(std::span<const Number> x, int length, std::size_t restart = 4096);

// As to_chord, by two cascaded running sums: the work does not depend on N. NaN are masked: the same outputs are NaN.
spectra::ChordOffsets to_chord_running(std::span<const double> short_offsets, int half_chord);

}  // namespace railbook::filters
