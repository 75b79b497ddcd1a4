// What is judged of a channel of track geometry: the channel itself, a band of its waves, its
// offsets from a chord, its twist; and that less its running mean.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include <railbook/filters/chord_stream.hpp>
#include <railbook/filters/inner_filter.hpp>
#include <railbook/filters/wavelength_band.hpp>
#include <railbook/quality/sections.hpp>

namespace railbook::quality {

struct Measure {
  enum class Kind { channel, band, chord, uniformity, twist, change };
  enum class Mean { none, taken, subtracted };
  Kind kind = Kind::channel;
  filters::Band band = {};    // of a band
  filters::Chord chord = {};  // of offsets
  double length = 0;          // m, the base of a twist, the reach of a change
  Mean mean = Mean::none;     // the running mean over mean_length, or what is left without it
  double mean_length = 0;     // m

  // Alike but for a hundredth in each length, so that 18.9 m is a chord of 62 ft.
  bool is_like(const Measure& other) const;
};

// A chord by its length, "62ft", or by the parts before and behind its offset, "3m+7m". Throws
// InputError that names `quantity` when a part is no positive length.
filters::Chord parse_chord(std::string_view quantity, std::string_view text);

// A measure in words: nothing (the channel as it is), a band, "chord 62ft", "chord 3m+7m",
// "uniformity 62ft" (its offset less the mean of nine, a quarter of the chord apart), "twist 3m" or
// "change 62ft" (see Warp). Throws InputError.
Measure parse_measure(std::string_view text);

// A channel on its way to a measure: one value a sample, in their order, as Twist, Warp,
// filters::ChordStream and filters::InnerFilter give them; a mean over 2 n + 1 samples, n the
// nearest to half its length, NaN within n of an end or a gap. `passes` are those of band_taps.
// Throws InputError where the samples cannot carry the measure.
class MeasureStream {
 public:
  using Sink = std::function<void(std::span<const double>)>;
  MeasureStream(const Measure& measure, int passes, double spacing, Sink sink);
  MeasureStream(const MeasureStream&) = delete;  // its filters refer to each other

  void push(std::span<const double> channel);  // NaN: a gap
  void finish();

  // How many samples from a sample the measure there depends on.
  std::size_t reach() const { return reach_; }

 private:
  Sink averaged(const Measure& measure, double spacing, Sink sink);
  void keep(const filters::FilterTaps& taps, std::size_t margin, Sink sink);

  std::size_t reach_ = 0;
  std::deque<filters::InnerFilter> filters_;  // of the mean, then of the measure
  std::unique_ptr<filters::ChordStream> chord_;
  Sink first_;  // what a piece of the channel goes to
};

}  // namespace railbook::quality
