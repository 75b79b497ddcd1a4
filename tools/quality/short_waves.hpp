// Whether a record lacks the waves that a filter to D1 takes off.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <railbook/quality/measure.hpp>

namespace railbook::quality_tool {

// The standard deviation in D2 over that in D1, from their mean squares, where it is so small that
// the record seems filtered to D1 already: below a quarter. A third of a quarter is what the two
// filters leave between them, and of a line alone nothing is left, so 0.03 is the least.
std::optional<double> short_waves_alone(double d1, double d2);

// The same of a record that streams by, from means over about a metre.
class ShortWaves {
 public:
  void push(std::span<const double> piece, double spacing);  // NaN: a gap
  void finish();
  std::optional<double> alone() const;

 private:
  struct Band {
    std::unique_ptr<quality::MeasureStream> stream;
    double sum = 0, count = 0;
  };
  void begin(double spacing);

  std::size_t per_mean_ = 0, in_mean_ = 0;
  double mean_ = 0;
  Band d1_, d2_;
};

}  // namespace railbook::quality_tool
