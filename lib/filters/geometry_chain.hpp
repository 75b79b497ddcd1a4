// The composite filter as a stream: short chord offsets in, space curve and long chord out, at a
// cost that depends neither on the length of the chord nor on that of the high-pass, in memory that
// does not depend on the length of the record.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <railbook/filters/high_pass.hpp>

namespace railbook::filters {

struct GeometryChainOptions {
  int half_chord = 31;  // samples; 62 ft at a sample a foot
  HighPass high_pass = {};
  double limit = 1;          // m; a short offset beyond it is no track, and is masked like a NaN
  std::size_t block = 4096;  // outputs computed at once, with sums that start anew
};

// Takes short mid-chord offsets (m) in any pieces, hands out one space curve and one long chord (m)
// for each, in order. A value is NaN where its window is not complete (reach() samples on either
// side for the chord) or holds a NaN, an infinity or an offset beyond the limit; everywhere else
// such samples leave no trace.
class GeometryChain {
 public:
  using Pair = double __attribute__((vector_size(16)));  // for the implementation

  // One output of each a sample; both spans are as long, and valid during the call.
  using Sink =
      std::function<void(std::span<const double> space_curve, std::span<const double> chord)>;

  // Throws InputError on a bad high-pass, half_chord outside 1 ... 10^4, a limit that is not
  // positive or a block of 0.
  GeometryChain(const GeometryChainOptions& options, Sink sink);

  void push(std::span<const double> short_offsets);
  // Hands out what is left: the last reach() outputs of a record are NaN for want of a window.
  void finish();

  std::size_t reach() const { return reach_; }  // 330 with the defaults: a record needs 661 samples
  std::size_t memory() const;                   // bytes
  std::size_t masked() const { return masked_; }  // samples that were not used

 private:
  void compute();
  void mask();

  GeometryChainOptions options_;
  Sink sink_;
  std::size_t curve_reach_, reach_;
  std::vector<double> in_;               // short offsets, masked ones as 0
  std::vector<double> curve_, scratch_;  // what becomes the space curve
  std::vector<Pair> rows_;               // sums on the way to it
  std::vector<double> chord_;
  std::vector<std::size_t> holes_;  // places in in_ of masked samples, ascending
  std::size_t masked_ = 0;
};

// Both outputs of a whole record, as long as the record; rounding 1e-11 of what the weights add up.
struct Geometry {
  std::vector<double> space_curve, chord;  // m
};
// Throws InputError when the record is shorter than the window, 2 reach + 1 samples.
Geometry geometry(std::span<const double> short_offsets, const GeometryChainOptions& options = {});

}  // namespace railbook::filters
