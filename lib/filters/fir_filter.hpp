// Symmetric filters of finite length on a sampled record: without phase, by transforms of
// overlapping blocks.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <railbook/num/fft.hpp>

namespace railbook::filters {

// The weights of the samples at distance 0, 1 .. half.size() - 1 to either side, 1/m.
struct FilterTaps {
  double spacing = 0;
  std::vector<double> half;
  double gain_error = 0;  // largest relative error of the gain in the band that the design states
  double worst_at = 0;    // the wavelength of that, m
};

// Gains of a symmetric filter at k/(n spacing), k = 0 .. n/2, n the size of `fft`, which is used
// up.
std::vector<double> symmetric_gains(std::span<const double> half, num::RealFft& fft);

// Sample by sample, len(half) multiplications each; a record without gaps. Beyond its ends the
// track is continued point-symmetrically, and level where that ends, too.
std::vector<double> filter_direct(const FilterTaps& taps, std::span<const double> record);

// The same by transforms of overlapping blocks (overlap-save), two at a time, streamed. Memory:
// some seventy reaches.
class FilterStream {
 public:
  // Takes the descriptor in pieces, one value a sample in the order of the samples.
  using Sink = std::function<void(std::span<const double>)>;
  FilterStream(const FilterTaps& taps, Sink sink);

  // NaN is a gap: the pieces of track to either side are filtered by themselves, the gap is NaN in
  // the output.
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
  num::ComplexFft fft_;
  std::vector<double> gain_;   // of the taps, over the size of the transform, in its order
  std::vector<double> first_;  // of a piece, until there is enough to continue it to the left
  std::vector<double> block_;  // the samples of two transforms
  std::size_t filled_ = 0;
  bool open_ = false;  // the piece has begun to fill the block
};

std::vector<double> filter(const FilterTaps& taps, std::span<const double> record);

}  // namespace railbook::filters
