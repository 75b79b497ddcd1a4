// One run of the record, and what is made of it; shared by the sources of this folder.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::geometry_car {

using Column = std::vector<double>;

// In the order of time; T[0] means nothing.
struct Run {
  std::vector<std::size_t> rows;  // of the record
  int direction = 1;              // of the marks
  Column T;
  std::array<Column, channels> values;

  std::size_t size() const { return T.size(); }
  const Column& operator[](Channel c) const { return values[static_cast<std::size_t>(c)]; }
};

// Rows that follow each other foot by foot in one direction; `rejected` counts those whose time
// cannot be.
std::vector<Run> runs_of(const Record& record, const Processing& processing, std::size_t& rejected);
// The runs worked through one by one, however short; and what throws InputError where the longest
// is too short for a chord.
Measurement reconstruct_runs(const Record& record, const Processing& processing,
                             std::vector<Run> runs);
void require_length(std::size_t longest_run, const Processing& processing);
void load(Run& run, const Record& record);
void require(const Record& record, const Processing& processing);

// Means over each interval, by B and C: rate[k] from sample k - 1 to k.
Column rates(const Run& run, Channel gyro, const Processing& processing);

// The analog filter F once more, on a rate that is constant over each interval. From its two states
// come the filtered rate, its derivative, and what the filter holds back of the rate's integral.
class Matched {
 public:
  explicit Matched(double corner) : w_(2 * units::pi * corner) {}
  void push(double rate, double T);
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
Column short_chords(const Column& z);
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

}  // namespace railbook::geometry_car
