// The descriptor of a track record: a zero-phase filter whose gain is the severity. Output 1 is the limit.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "num/four_step_fft.hpp"
#include "quality/descriptor.hpp"

namespace railbook::quality {

struct FilterDesign {
  double spacing = 0;  // of the record, m
  double shortest =
      0;  // m: the gain falls to 0 from 1.25 times this wavelength to it; 0: no such limit
  double reach = 0;  // m to either side; 0: twenty times the longest resonant wavelength
};

// The weights of the samples at distance 0, 1 .. half.size() - 1 to either side, 1/m.
struct FilterTaps {
  double spacing = 0;
  std::vector<double> half;
  double gain_error = 0;  // largest |gain - severity|/severity from `shortest` to the reach
  double worst_at = 0;    // the wavelength of that, m
};

// The gain wanted: the severity of the envelope, less what is shorter than `shortest`.
double filter_gain(const Envelope& envelope, double shortest, double phi);

// The impulse response at distances 0, 1 .. samples/2, times the spacing (1/m): the inverse transform of the gain on
// `samples` wavenumbers up to 1/(2 spacing).
std::vector<double> impulse_response(const Envelope& envelope, double spacing, double shortest,
                                     std::size_t samples);

// The impulse response tapered to zero over the outer half of its reach, and shifted so that a level track gives 0.
// Throws InputError when spacing is not positive, when `shortest` is below two spacings (and not 0), and when the reach
// exceeds 10^6 samples or has fewer than 8.
FilterTaps design_filter(const Envelope& envelope, const FilterDesign& design);

// How far (m) from an end or a gap its continuation may change the descriptor of a wave at the limit by more than `share`:
// continued about its last sample, a wave has the wrong phase beyond it. Waves from four samples to the resonance.
double end_effect(const FilterTaps& taps, const Envelope& envelope, double share = 0.03);

// The record is one period of an endless track: the gain is exact at the record's own wavenumbers.
std::vector<double> filter_periodic(const Envelope& envelope, double spacing,
                                    std::span<const double> record);

// Sample by sample, len(half) multiplications each; a record without gaps. Beyond its ends the track is continued point-symmetrically,
// and level where that ends, too.
std::vector<double> filter_direct(const FilterTaps& taps, std::span<const double> record);

// The same by transforms of overlapping blocks (overlap-save), two at a time, streamed. Memory: some seventy reaches.
class FilterStream {
 public:
  // Takes the descriptor in pieces, one value a sample in the order of the samples.
  using Sink = std::function<void(std::span<const double>)>;
  FilterStream(const FilterTaps& taps, Sink sink);

  // NaN is a gap: the pieces of track to either side are filtered by themselves, the gap is NaN in the output.
  void push(std::span<const double> record);
  void finish();

 private:
  void push_piece(std::span<const double> piece);
  void begin_piece();
  void append(double value);
  void transform(std::size_t outputs);
  void end_piece();

  Sink sink_;
  std::size_t reach_;
  std::size_t outputs_ = 0;  // of one transform
  num::FourStepFft fft_;
  std::vector<double> gain_;   // of the taps, over the size of the transform, in its order
  std::vector<double> first_;  // of a piece, until there is enough to continue it to the left
  std::vector<double> block_;  // the samples of two transforms
  std::size_t filled_ = 0;
  bool open_ = false;  // the piece has begun to fill the block
};

std::vector<double> filter(const FilterTaps& taps, std::span<const double> record);

}  // namespace railbook::quality
