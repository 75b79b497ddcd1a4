// Standard deviations and extremes of stretches of track, and indices made of them.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace railbook::quality {

// A stretch from a multiple of the length of a section on.
struct Section {
  double from = 0;  // m
  std::size_t samples = 0, missing = 0;
  double mean = 0, squares = 0;          // squares: sum of squared differences from the mean
  double lowest = 0, highest = 0;        // m
  double lowest_at = 0, highest_at = 0;  // m
  // Of the present samples, by n; nothing where there are fewer than two.
  std::optional<double> deviation() const;
  double largest() const;  // magnitude, m
};

// Cuts a channel that comes in pieces. NaN: missing.
class Sections {
 public:
  // `length` > 0, m; `place`: position of a sample, m.
  Sections(double length, std::function<double(std::size_t)> place);
  void push(std::span<const double> piece);
  const std::vector<Section>& all() const { return all_; }

 private:
  double length_;
  std::function<double(std::size_t)> place_;
  std::vector<Section> all_;
  std::size_t at_ = 0;
};

// Twist: the change of cross level over a base (m), between the sample and the one a base behind
// it, over the base (so that m/m); the base is taken in whole samples. NaN until a base is full,
// and where an end is missing.
class Twist {
 public:
  Twist(double base, double spacing);
  double base() const { return base_; }  // m, in whole samples
  double push(double crosslevel);

 private:
  std::vector<double> past_;
  std::size_t at_ = 0;
  double base_;
};

// Warp: the difference of cross level from the sample within a length (m) behind that differs most,
// with its sign: positive where it has grown. NaN where the sample is missing; missing ones behind
// it do not count.
class Warp {
 public:
  Warp(double length, double spacing);
  double push(double crosslevel);

 private:
  std::size_t window_, at_ = 0;
  std::deque<std::pair<std::size_t, double>> low_,
      high_;  // samples and values, ascending and descending
};

// The square root of the weighted mean square of standard deviations: sqrt(sum w s^2), as EN
// 13848-6 forms its combined standard deviation of alignment, gauge, cross level and longitudinal
// level (the means of both rails), with all weights 1 where a network sets none.
double combined_deviation(std::span<const double> deviations, std::span<const double> weights = {});

// China's track quality index: the sum of seven standard deviations (m) over 200 m, of the profile
// and the alignment of both rails, gauge, cross level and twist.
double track_quality_index(std::span<const double, 7> deviations);

}  // namespace railbook::quality
