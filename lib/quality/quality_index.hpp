// From a descriptor channel to numbers a planner can use: histogram, moments, exceedances, risk.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace railbook::quality {

// A half-wave of the descriptor, from one zero to the next, whose peak passes the threshold.
struct Exceedance {
  double at = 0;          // m from the first sample
  double peak = 0;        // signed
  double wavelength = 0;  // twice the distance of the zeros, m
  double length = 0;      // m above the threshold
  bool cut = false;       // the half-wave runs into an end or a gap: wavelength is a lower bound
  double clear = 0;       // m from the peak to the nearest end or gap
};

// Statistics of the magnitude |p| of the descriptor; NaN where no sample is present.
struct QualityIndex {
  std::size_t samples = 0, missing = 0;
  double mean = 0, deviation = 0;  // of |p|
  double rms = 0, largest = 0;
  std::size_t above = 0;    // samples with |p| above the threshold T_2
  double margin = 0;        // n of T_2 = mean + n deviation; infinite for a deviation of 0
  double above_per_km = 0;  // samples above, per km of the present ones
  double exceedances_per_km = 0;
};

// The sums behind an index.
struct IndexSums {
  std::size_t samples = 0, missing = 0, above = 0, exceedances = 0;
  double magnitude = 0, square = 0, largest = 0;
  void add(double p, double threshold);  // NaN: missing
  QualityIndex index(double spacing, double threshold) const;
};

struct IndexOptions {
  double spacing = 0;    // m, > 0
  double threshold = 1;  // T_2, > 0
  // The position of a sample, m; without it the record begins at 0 and is even.
  std::function<double(std::size_t)> place = {};
  double segment = std::numeric_limits<double>::infinity();  // m, at least a spacing
  double margin = 0;  // m from an end or a gap, within which the descriptor is unsure
};

// The stretch of track from `from` on, `segment` long; an exceedance belongs to the segment of its
// peak.
struct Segment {
  double from = 0;  // m, a multiple of the length of a segment
  IndexSums sums;
};

// Takes the descriptor in pieces of any length; memory: the histogram, the segments and the
// exceedances.
class IndexBuilder {
 public:
  // Histogram: bins of width 0.02 of |p| up to 4, the last also for all above. Throws InputError on
  // options out of range.
  explicit IndexBuilder(const IndexOptions& options);
  void push(std::span<const double> descriptor);  // NaN: missing
  void finish();                                  // ends the last half-wave

  QualityIndex index() const;
  // Share of the present samples within `margin` of an end or a gap; 0 without any.
  double unsure() const;
  const std::vector<Segment>& segments() const { return segments_; }
  const std::vector<Exceedance>& exceedances() const { return exceedances_; }
  const std::vector<std::size_t>& histogram() const { return histogram_; }
  static constexpr double bin = 0.02;

 private:
  void count(double p);
  void end_half_wave(double zero, bool cut);
  void end_piece(std::size_t end);  // the sample after its last
  double segment_of(std::size_t sample) const;

  IndexOptions options_;
  IndexSums sums_;
  std::vector<std::size_t> histogram_;
  std::vector<Segment> segments_;
  std::vector<Exceedance> exceedances_;
  std::size_t piece_begin_ = 0, piece_exceedances_ = 0;  // sample and exceedance it begins with
  double unsure_ = 0;                                    // samples
  double last_ = 0;                                      // descriptor of the last sample
  bool open_ = false;                                    // a half-wave is under way
  double begin_ = 0;                                     // its zero, in samples
  bool begin_cut_ = false;
  double peak_ = 0;
  std::size_t peak_at_ = 0, over_ = 0;
};

// Share of a normal histogram N(mean, deviation) above a threshold; deviation > 0.
double share_above(double mean, double deviation, double threshold);

// The probability of failure of a value drawn from N(mean, deviation) when a value p fails with
// probability Phi((p - median)/spread): Phi((mean - median)/sqrt(deviation^2 + spread^2)).
double failure_probability(double mean, double deviation, double median, double spread);

// Standard deviation of a histogram that spreads by diffusion, sqrt(s_0^2 + 2 D t).
double diffused_deviation(double initial, double diffusivity, double time);

}  // namespace railbook::quality
