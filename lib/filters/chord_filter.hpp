// From the short mid-chord offset, z_k - (z_{k-1} + z_{k+1})/2, to the offset of a chord of 2N
// samples: exact, since (1 - cos N t)/(1 - cos t) is a polynomial in cos t, the square of the sum
// of N shifts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <railbook/spectra/chord.hpp>

namespace railbook::filters {

// sin(M theta/2)/(M sin(theta/2)): the gain of a mean over M samples. M >= 1. Relative accuracy
// 2e-15.
double mean_gain(int M, double theta);

// out[i] = x[i] + ... + x[i + length - 1], by a running sum that starts anew every `restart`
// outputs (0: never). Cascade two for a chord; never both in one recursion. Numbers wrap in
// unsigned integers, and the result is exact if it fits. Throws InputError unless 1 <= length <=
// x.size().
template <class Number>
std::vector<Number> running_sum(std::span<const Number> x, int length, std::size_t restart = 4096);

// Offsets of the chord of 2N samples from the short ones, with the integer weights N - |j| as two
// cascaded running sums: the work does not depend on N. N - 1 samples are lost at each end. A NaN
// gives NaN within N - 1 samples of it, and leaves no trace elsewhere. Rounding: 1e-14 of N^2 times
// the largest offset near. Throws InputError unless 1 <= N <= 10^6 and on a record of fewer than 2N
// - 1 samples.
spectra::ChordOffsets to_chord(std::span<const double> short_offsets, int half_chord);

}  // namespace railbook::filters
