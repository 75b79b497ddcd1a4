// Random numbers that are the same on every machine: std::uniform_real_distribution is not.
#pragma once

#include <cmath>
#include <random>

namespace railbook::tests {

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  // Evenly in the logarithm; low > 0.
  double decades(double low, double high) {
    return std::exp((*this)(std::log(low), std::log(high)));
  }

 private:
  std::mt19937 random_;
};

}  // namespace railbook::tests
