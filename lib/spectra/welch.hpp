// Welch's estimate of a power spectral density, streamed: memory of some ten segments, however long
// the record.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/spectra/window.hpp>

namespace railbook::spectra {

enum class Detrend { none, constant, linear };

struct WelchOptions {
  std::size_t segment = 4096;  // samples; even
  std::size_t parts = 2;  // a new segment starts every segment/parts samples: 2 is 50 % overlap
  Window window = Window::hann;
  Detrend detrend = Detrend::linear;  // of each segment, by least squares
};

// A one-sided density at the frequencies k df, k = 0 .. segment/2, per cycle of whatever the sample
// spacing is in (1/m for a track record), with what is needed to judge its scatter.
struct Spectrum {
  double df = 0;               // bin spacing, 1/(segment spacing)
  Eigen::VectorXd density;     // segment/2 + 1 values
  std::size_t segments = 0;    // averaged
  std::size_t unused = 0;      // samples in no segment: in runs too short for one, and at the end
  double averages = 0;         // K: 2K degrees of freedom of one bin, overlap accounted for
  double noise_bandwidth = 0;  // equivalent width of a line, 1.5 df for Hann
  double band_variance = 0;    // relative variance of a mean over m >> 1 bins is band_variance / m
  double frequency(Eigen::Index k) const { return df * static_cast<double>(k); }
};

// The same record read with another spacing: densities grow with it, frequencies shrink. `from`
// must have been made with spacing 1; spacing > 0, else InputError.
Spectrum respaced(const Spectrum& from, double spacing);

// Accumulates the spectrum of samples `spacing` apart that come in any number of pieces. The state
// is some ten segments of doubles; push() keeps nothing more but a word a gap. A sample that is not
// finite marks a gap: segments begin anew after it, and what is left before it, where the run holds
// a segment at all, is read by a last one that ends there: it counts as much as its share of new
// samples in a step, and its larger overlap goes into `averages` and `band_variance`. Sums are
// float64. Relative rounding error of a bin about 1e-15 sqrt(log2 n) of the largest power in a
// segment.
class Welch {
 public:
  // Throws InputError unless spacing > 0, segment is even, >= 16 and divisible by parts >= 1.
  explicit Welch(double spacing, const WelchOptions& options = {});

  void push(std::span<const double> samples);

  // The average so far. Throws InputError when no whole segment without a gap has been pushed.
  Spectrum spectrum() const;

  std::size_t samples() const { return samples_; }          // pushed so far
  std::size_t gap_samples() const { return gap_samples_; }  // of them not finite
  std::size_t segments() const { return segments_; }        // averaged so far
  std::size_t used_samples() const { return samples_ - gap_samples_ - unused(); }  // in them
  std::size_t ahead() const { return filled_ - averaged_; }  // at the end so far, for the next

 private:
  struct Block {        // sums of one hop of samples, shared by the segments that overlap there
    double sum = 0;     // of x
    double moment = 0;  // of (i - centre of block) x
  };
  std::size_t unused() const { return unused_ + ahead(); }
  std::size_t restart(std::span<const double> piece);
  void finish_block();
  void finish_segment();
  void add_last_segment();
  struct Segment {  // of which the line start + slope i is taken off
    const double* x;
    double start, slope;
  };
  Segment add_segment(const double* x, double sum, double moment, double weight);
  static void weigh(const double* window, const Segment& one, const Segment& other,
                    std::span<std::complex<double>> z);
  void transform(const Segment& one, const Segment& other, double weight, num::ComplexFft& fft,
                 std::vector<double>& power) const;

  double spacing_;
  WelchOptions options_;
  std::size_t hop_;
  std::vector<double> window_, buffer_;  // buffer_: the step before the segment, it, and some more
  std::size_t begin_;                    // of the segment that is being filled
  std::vector<double> power_;            // in the order of the transform
  std::vector<Block> blocks_;            // the finished ones of the segment in the buffer
  std::map<std::size_t, double> pairs_;  // products of weights of segments so far apart, samples
  std::vector<bool> used_;               // the last segments of this run, latest first
  std::optional<Segment>
      waiting_;  // at the begin of the buffer, for another to be transformed with
  double weight_ = 0, weights_squared_ = 0;
  num::ComplexFft fft_;
  std::size_t filled_ = 0, samples_ = 0, gap_samples_ = 0, segments_ = 0;
  std::size_t averaged_ = 0;  // samples of the buffer that are in an averaged segment
  std::size_t unused_ = 0;    // samples before gaps that are in none
};

// The spectrum of a whole record in one call; errors as Welch.
Spectrum welch(std::span<const double> samples, double spacing, const WelchOptions& options = {});

// A spectrum averaged over logarithmic bands, `per_octave` to an octave, from `low` to `high`. A
// band that holds no bin is left out. The density is the plain mean of the bins; `relative_error`
// holds to a tenth for a stationary Gaussian record. Throws InputError unless per_octave > 0 and 0
// < low <= high < infinity.
struct BandSpectrum {
  Eigen::VectorXd frequency;  // geometric mean of the bins of each band
  Eigen::VectorXd density;
  Eigen::VectorXi bins;            // averaged in each band
  Eigen::VectorXd relative_error;  // one standard error of the density over the density
};
BandSpectrum band_average(const Spectrum& spectrum, double per_octave, double low, double high);

}  // namespace railbook::spectra
