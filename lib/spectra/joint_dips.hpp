// Dips at rail joints whose depth varies from joint to joint (Figure 5 of the paper), and their
// spectrum.
//
// Joint j is at x = j l and has the dip B_j = B (1 + m g_j), with g_j a stationary Gaussian
// sequence of unit variance and correlation rho between neighbours. The profile is -B_j (1 -
// |sin(pi x / l)|) within half a rail of the joint: crests stay at zero and the profile is smooth
// there. With m = 0 it is the rectified sine.
#pragma once

#include <cstdint>
#include <span>

#include <railbook/num/random_source.hpp>

namespace railbook::spectra {

// The shape of one dip of depth 1: 1 - |sin(pi u)| for |u| <= 1/2, u in rail lengths from the
// joint; else 0. To rounding.
double dip_shape(double u);

// Its Fourier transform, the integral of dip_shape(u) cos(2 pi nu u) du, with nu in cycles per rail
// length: 1 - 2/pi at nu = 0, 2/(3 pi) at nu = 1. Even in nu. Relative accuracy 1e-12.
double dip_transform(double nu);

struct JointDips {
  double rail_length = 0;  // m
  double dip = 0;          // B, physical, m
  double scatter =
      0;  // m >= 0: standard deviation of B_j as a share of B. From about 0.4 on, some B_j < 0
  double correlation =
      0;  // rho of neighbouring joints, -1 < rho < 1; 0 is Figure 5(a), near 1 is 5(b)
};

// The continuous part of the one-sided density (m^2/(cycle/m)) at phi > 0 (cycle/m):
//   2 m^2 B^2 l |D(phi l)|^2 (1 - rho^2)/(1 - 2 rho cos(2 pi phi l) + rho^2),  D = dip_transform.
// The lines of the mean dip B come on top. Relative accuracy that of dip_transform, -0.9999 <= rho
// <= 0.9999. Throws InputError on values out of the ranges above.
double joint_scatter_psd(const JointDips& joints, double phi);

// The profile of the joints, sample after sample; to rounding of the dip and the rails gone by.
class JointSequence {
 public:
  // Throws InputError on values out of the ranges of JointDips, or rails shorter than two samples.
  JointSequence(const JointDips& joints, double spacing, const num::RandomSource& source);

  // Adds the next z.size() samples to z; the sequence does not depend on how it is cut into calls.
  void add(std::span<double> z);

 private:
  void next_joint();

  JointDips joints_;
  double spacing_;
  num::RandomSource source_;
  std::uint64_t sample_ = 0;
  std::uint64_t joint_ = 0;
  double deviation_ = 0;  // g_j
  double depth_ = 0;      // B_j
};

}  // namespace railbook::spectra
