// A stationary Gaussian process with a prescribed power spectral density, streamed in samples.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/num/random_source.hpp>

namespace railbook::spectra {

// How the process is made: white noise -> symmetric FIR by FFT -> leaky integrator.
//
// Profiles rise like 1/phi^2 towards long waves, which a finite FIR cannot follow. So the FIR makes
// the slope, whose spectrum is flat there, and a leaky sum makes the profile from it. The price is
// a cut: below `low_cut` the density levels off, S = S_wanted / (1 + (low_cut/phi)^2).
struct NoiseShape {
  std::function<double(double)> density;  // wanted S(phi), one-sided, phi in (0, 1/(2 spacing)];
                                          // phi^2 S must be bounded and continuous
  double spacing = 0;                     // m
  double low_cut = 0;                     // cycle/m, > 0
  double detail = 0;  // cycle/m: the wavenumber of the sharpest bend of the density
};

// Samples of the process from x = 0 on, already stationary there. The samples have the wanted
// density up to the Nyquist wavenumber and none is folded in from above it.
class ShapedNoise {
 public:
  // Throws InputError on a spacing, cut or detail that is not positive, or a cut at or above
  // Nyquist, or below 10^-8 cycles a sample (the past of the sum is computed: 10^9 samples).
  ShapedNoise(const NoiseShape& shape, const num::RandomSource& source);

  // Adds the next z.size() samples (m) to z; the sequence does not depend on how it is cut into
  // calls.
  void add(std::span<double> z);

  // The density this generator has, by its own coefficients (no statistics): for 0 < phi <=
  // Nyquist. It is the wanted one, cut, to 0.5 % where the cut is below 1e-4 of a cycle a sample;
  // else low by the share 2 pi low_cut spacing next to the Nyquist wavenumber.
  double density(double phi) const;

 private:
  void design(const NoiseShape& shape);
  void next_block();

  num::RandomSource source_;
  double spacing_;
  double leak_;                   // factor of the leaky sum per sample
  std::vector<double> taps_;      // of the FIR, odd number, symmetric
  std::vector<double> response_;  // of the FIR at the points of fft_
  std::unique_ptr<num::RealFft> fft_;
  std::vector<double> white_;  // input window of the present block
  std::vector<double> ready_;  // output of the present block
  std::size_t used_ = 0;       // of ready_
  std::uint64_t counter_ = 0;  // white samples drawn
  double sum_ = 0;             // state of the leaky sum
};

}  // namespace railbook::spectra
