// The condensed equations of harmonic balance and their derivatives; for harmonic_balance.cpp and floquet.cpp.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "dynamics/harmonic_balance.hpp"
#include "num/fft.hpp"

namespace railbook::dynamics {

// Slopes of the laws at rest times one half, for channels of displacement: put into the stiffness, so that it is regular
// without being singular where the linear car itself is critical.
struct Reference {
  std::vector<Eigen::VectorXd> slope;  // a channel: outputs of its law
  Eigen::MatrixXd stiffness;
};
Reference reference(const Oscillator& oscillator);

// M p^2 + (C_0 + u C_1) p + K at exp(p t), and the channels' G side by side, n x all outputs.
Eigen::MatrixXcd dynamic_stiffness(const Oscillator& oscillator, const Eigen::MatrixXd& stiffness,
                                   std::complex<double> p);
Eigen::MatrixXd all_forces(const Oscillator& oscillator);
// A row a channel, times p for those of a rate.
Eigen::MatrixXcd all_rows(const Oscillator& oscillator, std::complex<double> p);

// Coefficients P_n, n = 0 ... samples/2, of the slopes (less the reference) along a cycle: P(t) = sum_n P_n exp(i n w t), P_-n
// conjugate. One vector an output, in the order of channels and their outputs.
std::vector<std::vector<std::complex<double>>> slope_spectra(const Oscillator& oscillator,
                                                             const Reference& ref,
                                                             const Cycle& cycle, int samples);

// Samples of each scalar over a period: channels x samples.
Eigen::MatrixXd sampled_scalars(const Cycle& cycle, num::RealFft& fft);
int sample_count(const Cycle& cycle, int wanted);

}  // namespace railbook::dynamics
