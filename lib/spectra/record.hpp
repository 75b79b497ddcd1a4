// A track record on its way from a file into an estimate: placed, judged, gaps marked or bridged.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "spectra/places.hpp"
#include "spectra/screen.hpp"

namespace railbook::spectra {

struct RecordOptions {
  std::optional<double> spacing = {};  // m; without it, from the positions
  // Gaps of up to so many samples, or of up to this length, are bridged by a straight line; longer ones are NaN.
  std::size_t bridge = 0;
  double bridge_length = 0;  // m
};

// Something that an answer stands under: "stuck", "7000 samples in a row are equal ...".
struct Doubt {
  std::string key, text;
};

// Takes samples, with their positions or without, and hands an evenly spaced record on to `sink` in
// pieces. Positions ascend or descend. One must come a whole number of spacings after the last (to a quarter of one); more than
// one leaves a gap. Where the recorder rounds positions to more than a twentieth of a spacing (to .1 m, to whole metres; not to nearly a spacing, which looks like samples lost), they
// are met by the even grid through those before them. Faulty samples (see Screen) are gaps, too, and are told by doubts(). The memory is some
// thousand samples, and a few words for each faulty stretch and each change of spacing.
class RecordStream {
 public:
  // Throws InputError when a given spacing is not positive.
  RecordStream(const RecordOptions& options, std::function<void(std::span<const double>)> sink);
  RecordStream(const RecordStream&) = delete;
  RecordStream& operator=(const RecordStream&) = delete;

  // The next samples; NaN where one is missing. Either all samples have a position or none. Throws InputError
  // naming the sample when positions turn back, or are not even, or when gaps come to more than 10^6 spacings and twenty
  // times the samples there are, and when a value is beyond 10^6 m.
  void add(std::span<const double> values);
  void add(std::span<const double> positions, std::span<const double> values);  // as many
  void add(double value) { add({&value, 1}); }
  void add(double position, double value) { add({&position, 1}, {&value, 1}); }

  // Hands on what is left. Throws InputError when the spacing is unknown (no positions and none given),
  // when the positions' own differs by over 0.5 % from the one given or changes by over 2 % on the way, when no
  // sample is finite, or when all finite ones are equal.
  void finish();

  double spacing() const { return spacing_; }       // m; the positions' own where there are any
  std::size_t samples() const { return samples_; }  // handed on
  std::size_t missing() const { return missing_; }  // of them NaN: not there, or taken out
  std::size_t faulty() const { return faulty_; }    // taken out, see faults()
  std::size_t bridged() const { return bridged_; }  // not there or taken out, and bridged
  const std::vector<FaultyStretch>& faults() const { return screen_.faults(); }
  const PlaceMap& places() const { return places_; }

  // The roughness A (m^2 cycle/m) of a profile S = A/phi^2 that leaves a chord of 20 m as much: whether the unit can be
  // right. 0 where fewer than 100 offsets are known.
  double roughness() const;

  // After finish(): what was found, each kind once; spacing that changes by over 0.3 %; a roughness no track has.
  std::vector<Doubt> doubts() const;

 private:
  struct Sample {
    double position, value;
  };
  void settle_spacing();
  void fit_grid();
  std::size_t go_on(std::span<const double> positions);
  void place(const Sample& sample);
  void take(std::span<const double> values);
  void join(std::span<const double> values);
  void close_gap(double value);
  void put(double value) { put({&value, 1}); }
  void put(std::span<const double> values);
  void compare(std::span<const double> values);

  RecordOptions options_;
  std::function<void(std::span<const double>)> sink_;
  Screen screen_;
  PlaceMap places_;
  double spacing_ = 0;
  std::vector<Sample> first_;  // until the spacing is known
  std::vector<double> ready_;  // to be handed on
  std::size_t taken_ = 0;      // samples added
  std::size_t placed_ = 0;     // of them, not waiting for the spacing
  std::size_t steps_ = 0;      // spacings from the first position to the last
  bool settled_ = false, positions_ = false;
  double first_position_ = 0, last_position_ = 0;  // as all inside, in the direction of travel
  double direction_ = 1;                           // -1: positions descend
  double rounding_ = 0,
         grid_ = 0;  // of positions, m, where it matters; the place of the last sample
  bool any_ = false, varies_ = false;  // finite samples; they differ
  double first_value_ = 0;

  std::size_t gap_ = 0;  // missing or faulty samples since the last good one
  bool begun_ = false;   // a good sample has come
  bool cut_ = false;     // the level steps in the gap
  std::size_t joined_ = 0, fault_ = 0;
  double last_value_ = 0;  // the last good one
  std::size_t samples_ = 0, missing_ = 0, bridged_ = 0, faulty_ = 0;
  std::vector<double> past_;  // 20 m of samples, in turn
  std::size_t oldest_ = 0;    // of them
  double moved_ = 0;          // sum of squared offsets of their middle
  std::size_t moves_ = 0;
};

}  // namespace railbook::spectra
