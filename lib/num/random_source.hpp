// Random numbers by position: value k of a stream is a pure function of (seed, stream, k).
//
// No state, so a record comes out the same whatever the block size; and only +, *, /, sqrt and log,
// so the same with every standard library (std::normal_distribution is not).
#pragma once

#include <cstdint>

namespace railbook::num {

// The standard normal quantile: Phi(normal_quantile(p)) = p, 0 < p < 1; relative accuracy 2e-15
// (Wichura 1988, algorithm AS 241, PPND16). Outside (0, 1) the result is NaN or infinite.
double normal_quantile(double p);

// An independent sequence of numbers for each (seed, stream): SplitMix64 entered at a place
// (Steele, Lea and Flood 2014). Not for cryptography.
class RandomSource {
 public:
  RandomSource(std::uint64_t seed, std::uint64_t stream);
  double uniform(std::uint64_t k) const;  // (j + 1/2)/2^52: never 0 or 1; exact
  double normal(std::uint64_t k) const { return normal_quantile(uniform(k)); }

 private:
  std::uint64_t start_;
};

}  // namespace railbook::num
