// Random numbers one after the other, the same on every machine and with every standard library.
#pragma once

#include <cmath>
#include <cstdint>

#include <railbook/num/random_source.hpp>

namespace railbook::num {

// The numbers of one stream of a seed, in order; a case k of a sweep takes stream k and so does not
// depend on what came before.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed, std::uint64_t stream = 0) : source_(seed, stream) {}
  // Evenly between low and high.
  double operator()(double low, double high) {
    return low + (high - low) * source_.uniform(count_++);
  }
  // Evenly in the logarithm; low > 0.
  double decades(double low, double high) {
    return std::exp((*this)(std::log(low), std::log(high)));
  }
  // Normal about zero.
  double normal(double deviation) { return deviation * source_.normal(count_++); }

 private:
  RandomSource source_;
  std::uint64_t count_ = 0;
};

}  // namespace railbook::num
