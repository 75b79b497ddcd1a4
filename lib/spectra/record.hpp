// A track record on its way from a file into an estimate: even spacing checked, gaps marked or bridged.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace railbook::spectra {

struct RecordOptions {
  std::optional<double> spacing = {};  // m; without it, from the positions
  std::size_t bridge =
      0;  // gaps of up to so many samples are bridged by a straight line; longer ones are NaN
};

// Takes samples one by one, with their positions or without, and hands an evenly spaced record on to `sink` in
// pieces. A position must come a whole number of spacings after the last (to a quarter of one, for rounded
// positions); more than one leaves a gap. The memory is some thousand samples.
class RecordStream {
 public:
  // Throws InputError when a given spacing is not positive.
  RecordStream(const RecordOptions& options, std::function<void(std::span<const double>)> sink);

  // The next sample; NaN if it is missing. Either all samples have a position or none. Throws InputError
  // naming the sample when positions do not ascend, or not evenly, or jump by more than 10^7 spacings, and when
  // a value is beyond 10^6 m.
  void add(double value);
  void add(double position, double value);

  // Hands on what is left. Throws InputError when the spacing is unknown (no positions and none given),
  // when the positions' own differs by over 0.5 % from the one given, when no sample is finite, or when all finite
  // ones are equal.
  void finish();

  double spacing() const { return spacing_; }       // m; the positions' own where there are any
  std::size_t samples() const { return samples_; }  // handed on
  std::size_t missing() const { return missing_; }  // of them NaN
  std::size_t bridged() const { return bridged_; }
  std::size_t still() const { return still_; }  // longest run of equal values: a stuck sensor?
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

 private:
  struct Sample {
    double position, value;
  };
  void settle_spacing();
  void place(const Sample& sample);
  void take(double value);
  void put(double value);

  RecordOptions options_;
  std::function<void(std::span<const double>)> sink_;
  double spacing_ = 0;
  std::vector<Sample> first_;  // until the spacing is known
  std::vector<double> ready_;  // to be handed on
  std::size_t taken_ = 0;      // samples added
  std::size_t gap_ = 0;        // missing samples since the last finite one
  std::size_t steps_ = 0;      // spacings from the first position to the last
  bool settled_ = false, positions_ = false;
  double first_position_ = 0, last_position_ = 0, last_value_ = 0;
  bool any_ = false;  // a finite sample has come
  std::size_t samples_ = 0, missing_ = 0, bridged_ = 0;
  std::size_t same_ = 0, still_ = 0;  // run of equal values now, and the longest
  double lowest_ = 0, highest_ = 0;
};

}  // namespace railbook::spectra
