// Uneven samples on an even grid.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace railbook::records {

// Puts samples at uneven places, ascending or descending, on whole multiples of a spacing, by a
// straight line between the two samples beside each. Steps of over three times the usual one, and
// of the spacing, are gaps: nothing is put in them. Rows at the place of the one before, or without
// a place, are left out; where places turn back, a new line begins. Memory: some hundred rows.
class Resampler {
 public:
  // Throws InputError when the spacing (m) is not positive.
  Resampler(double spacing, std::size_t columns);

  // The next row: its place and a height of each column, NaN where it is missing. Throws InputError
  // when the spacing is over 1.5 times the samples' own: short waves would come out as long ones.
  void push(double position, std::span<const double> heights);
  void finish();

  // What has come out since clear().
  const std::vector<double>& positions() const { return positions_; }
  const std::vector<double>& heights(std::size_t column) const { return heights_[column]; }
  void clear();

  double spacing() const { return spacing_; }  // m
  // The root mean square (m) of what the straight lines are off, judged by leaving out each sample
  // in turn: a thirtieth of the mean square of what it then is off by. Good to some per cent where
  // waves are longer than ten samples; noise of the samples counts as well.
  double error(std::size_t column) const;
  std::size_t repeated() const { return repeated_; }  // rows at the place of the one before
  std::size_t turned() const { return turned_; }

 private:
  struct Row {
    double position = 0;
    std::vector<double> heights;
  };
  void settle();
  void take(const Row& row);

  double spacing_, step_ = 0, direction_ = 0;
  bool settled_ = false;
  std::vector<Row> first_;                // until the usual step is known
  Row before_, last_;                     // the two rows before
  std::size_t known_ = 0;                 // of them, without a gap between
  std::vector<double> squares_, counts_;  // of what samples left out are off
  std::size_t repeated_ = 0, turned_ = 0;
  std::vector<double> positions_;
  std::vector<std::vector<double>> heights_;
};

}  // namespace railbook::records
