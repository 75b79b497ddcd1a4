// Tapers for spectral estimates.
#pragma once

#include <Eigen/Core>
#include <string_view>

namespace railbook::spectra {

enum class Window { boxcar, hann, hamming, blackman_harris, dpss };

// The window as n weights, periodic form (w_0 belongs to a period of n samples) except dpss, which
// is the first discrete prolate spheroidal sequence of time-bandwidth product 4, peak 1, correct to
// about 1e-9; the others to rounding. n >= 8, else InputError. Blackman-Harris is the 4-term, 92 dB
// one (Harris 1978).
Eigen::VectorXd window_weights(Window window, Eigen::Index n);

// From "hann" and so on, as the options of a program spell it; else InputError lists the allowed
// names.
Window parse_window(std::string_view name);

}  // namespace railbook::spectra
