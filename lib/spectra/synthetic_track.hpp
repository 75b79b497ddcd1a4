// Synthetic track: a profile record with everything the paper says a surface profile contains, and
// what spoils real records. All known in advance, so an estimator can be judged by it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <railbook/spectra/joint_dips.hpp>
#include <railbook/spectra/shaped_noise.hpp>
#include <railbook/spectra/track_spectrum.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::spectra {

struct SyntheticTrack {
  double spacing = units::foot;  // m
  std::uint64_t seed = 1;        // same seed, same record, bit for bit

  // Stationary random part: S = A/phi^2 up to phi_c, A phi_c^2/phi^4 above, levelling off below
  // low_cut.
  double A = 0;              // m^2 cycle/m
  double phi_c = no_corner;  // cycle/m
  double low_cut = 1e-4;     // cycle/m: 10 km waves; -1 % in S at 0.001, -0.04 % at 0.005 cycle/m

  // Joints. `dip` is the physical dip B; half of a B in LineConvention::printed.
  double rail_length = 39 * units::foot;  // m
  double dip = 0;                         // m
  double dip_scatter = 0;                 // see JointDips
  double dip_correlation = 0;

  // Ballast memory of former rails of length memory_length, with a joint at x = 0 (Figure 6).
  double memory_length = 33 * units::foot;  // m
  double memory_dip =
      0;  // linear: adds the fundamental left by rails of this dip, -4B/(3 pi) cos, m
  double memory_modulation =
      0;  // nonlinear: dips times 1 + m cos(2 pi eps x), eps = |1/old - 1/new|

  // What a survey adds. Trends: a straight grade and one long vertical wave.
  double grade = 0;           // m/m
  double wave_amplitude = 0;  // m
  double wave_length = 20e3;  // m
  double sensor_noise = 0;    // standard deviation of white noise, m; density 2 sigma^2 spacing
  double gap_share = 0;       // share of samples lost (NaN), in gaps of gap_samples; 0 <= share < 1
  std::uint64_t gap_samples = 20;
};

// Streams the record. Speed: above 10^7 samples/s on one core of an ordinary computer.
class TrackGenerator {
 public:
  // Throws InputError naming the field of `track` that is out of range.
  explicit TrackGenerator(const SyntheticTrack& track);

  // The next z.size() heights (m), NaN in gaps; the record does not depend on how it is cut into
  // calls.
  void fill(std::span<double> z);

  // The density of the random part as generated (ShapedNoise::density), m^2/(cycle/m); 0 if A = 0.
  double random_density(double phi) const;

 private:
  void add_smooth(std::span<double> z) const;
  void add_noise_and_gaps(std::span<double> z) const;

  SyntheticTrack track_;
  std::optional<ShapedNoise> random_;
  std::optional<JointSequence> joints_;
  num::RandomSource noise_source_;
  num::RandomSource gap_source_;
  std::uint64_t sample_ = 0;
};

// The first `samples` heights of the record. Throws InputError as TrackGenerator does.
std::vector<double> synthesize(const SyntheticTrack& track, std::size_t samples);

}  // namespace railbook::spectra
