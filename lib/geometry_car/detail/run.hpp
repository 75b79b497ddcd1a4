// One run of the record, and what is made of it; shared by the sources of this folder.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::geometry_car {

using Column = std::vector<double>;
using View = std::span<const double>;

// In the order of time; T[0] means nothing. Times and values are the record's own, which must stay,
// but for a run that rows are rejected in.
struct Run {
  std::vector<std::size_t> rows;  // of the record
  int direction = 1;              // of the marks
  View T;
  std::array<View, channels> values;
  Column own;  // times and values, where they are not the record's

  Column decay;      // of the analog filter F, over the interval before each row
  Column yaw, roll;  // means of the rates over it, by B and C

  std::size_t size() const { return rows.size(); }
  View operator[](Channel c) const { return values[static_cast<std::size_t>(c)]; }
};

// Rows that follow each other foot by foot in one direction; `rejected` counts those whose time
// cannot be.
std::vector<Run> runs_of(const Record& record, const Processing& processing, std::size_t& rejected);
// The prepared runs worked through one by one, however short; and what throws InputError where the
// longest is too short for a chord.
Measurement reconstruct_runs(const Record& record, const Processing& processing,
                             std::vector<Run> runs);
void require_length(std::size_t longest_run, const Processing& processing);
void load(Run& run, const Record& record);                                   // times and values
void prepare(Run& run, const Record& record, const Processing& processing);  // and the rest
void require(const Record& record, const Processing& processing);

// The analog filter F once more, on a rate that is constant over each interval. From its two states
// come the filtered rate, its derivative, and what the filter holds back of the rate's integral.
class Matched {
 public:
  explicit Matched(double corner) : w_(2 * units::pi * corner) {}
  // Over an interval T, decay = exp(-w T).
  void push(double rate, double T, double decay) {
    second_ = rate + decay * (second_ - rate + w_ * T * (first_ - rate));
    first_ = rate + decay * (first_ - rate);
  }
  void settle(double rate) { first_ = second_ = rate; }
  double rate() const { return second_; }
  double derivative() const { return w_ * (first_ - second_); }
  double held_back() const { return (first_ + second_) / w_; }

 private:
  double w_, first_ = 0, second_ = 0;
};

std::array<Column, parameters> process(const Run& run, const Processing& processing,
                                       const std::vector<long>& marks);

// Shared with the truth. Short chord offsets z_k - (z_{k-1} + z_{k+1})/2, NaN at the ends.
Column short_chords(View z);
// Turn of the chord between the trucks (rad) over each foot, NaN for the first row -> curvature at
// the middle of the car, at the place of its mean; `shift` samples later than the heading's, in the
// order given.
Column mean_curvature(const Column& turn, const Processing& processing, long shift);
// The change of a column over `span` samples, centred.
Column change_over(const Column& column, std::size_t span);
// Long chord and space curve of short offsets, NaN throughout when they are too few.
filters::Geometry long_chord(const Column& short_offsets, const Processing& processing);

std::size_t samples_needed(const Processing& processing);
// Samples to either side that a value depends on (besides the memory of the roll filter).
std::size_t reach_of(Parameter parameter, const Processing& processing);

// Within `reach` of a row that is `bad`, no quality is better than `least`.
template <class Byte>
void spread(std::vector<Quality>& quality, std::size_t reach, Quality least,
            const std::vector<Byte>& rows, Byte bad) {
  static_assert(sizeof(Byte) == 1);
  const Byte *begin = rows.data(), *end = begin + rows.size(), *after = begin;
  for (std::size_t settled = 0; after != end;) {
    const void* found = std::memchr(after, static_cast<int>(bad), std::size_t(end - after));
    if (found == nullptr) return;
    const Byte* first = static_cast<const Byte*>(found);
    after = std::find_if(first, end, [bad](Byte byte) { return byte != bad; });
    const auto from = static_cast<std::size_t>(first - begin),
               to = std::min(rows.size(), static_cast<std::size_t>(after - begin) + reach);
    for (std::size_t k = std::max(settled, from - std::min(from, reach)); k < to; ++k)
      quality[k] = std::max(quality[k], least);
    settled = to;
  }
}

}  // namespace railbook::geometry_car
