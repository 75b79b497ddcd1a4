// Where a measure leaves its limit.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace railbook::quality {

// Samples in a row beyond the limit, all on one side.
struct Exception {
  double from = 0, to = 0;     // m, of the first and the last of them
  double largest = 0, at = 0;  // m, with its sign: the farthest beyond
};

// Finds them in a measure that comes in pieces. NaN ends one.
class Exceptions {
 public:
  // `limit` > 0, m, to both sides of zero; `place`: position of a sample, m.
  Exceptions(double limit, std::function<double(std::size_t)> place);
  // Between two limits, m.
  Exceptions(double low, double high, std::function<double(std::size_t)> place)
      : low_(low), high_(high), place_(std::move(place)) {}
  void push(std::span<const double> piece);
  const std::vector<Exception>& all() const { return all_; }
  // The one that an exception leaves.
  double limit(const Exception& e) const { return e.largest > high_ ? high_ : low_; }

 private:
  double low_, high_;
  std::function<double(std::size_t)> place_;
  std::vector<Exception> all_;
  std::size_t at_ = 0;
  int side_ = 0;  // of the one that is open
};

}  // namespace railbook::quality
