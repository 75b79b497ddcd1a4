// Offsets of a measuring chord, also of one that is not divided in its middle.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace railbook::filters {

// A chord with its ends `before` and `after` the place where its offset is read, m, in the order of
// the samples. Alike: the mid-chord offset.
struct Chord {
  double before = 0, after = 0;
  double length() const { return before + after; }
};

// The offset z(x) - (after z(x - before) + before z(x + after))/(before + after) of a record that
// comes in pieces; its gain at wavenumber phi is 1 - (after exp(-i 2 pi phi before) + before exp(i
// 2 pi phi after))/(before + after). Ends between samples are read by a cubic, which costs up to
// 3/128 (2 pi phi spacing)^4. NaN where the chord, and two samples beyond its ends, reach over an
// end of the record or a gap.
class ChordStream {
 public:
  // Takes one value a sample, in their order.
  using Sink = std::function<void(std::span<const double>)>;
  // Throws InputError when a part of the chord is shorter than two spacings or longer than 10^6.
  ChordStream(const Chord& chord, double spacing, Sink sink);
  void push(std::span<const double> record);  // NaN: a gap
  void finish();

  // Samples that the farther end reaches from the place of the offset.
  std::size_t reach() const { return before_ > after_ ? before_ : after_; }

 private:
  Sink sink_;
  std::size_t before_, after_;                           // samples it reaches
  std::vector<std::pair<std::size_t, double>> weights_;  // of samples from the first it reaches on
  std::vector<double> window_;                           // the last samples, in turn
  std::size_t samples_ = 0, whole_ = 0;                  // taken; since the last gap
  std::vector<double> offsets_;
};

}  // namespace railbook::filters
