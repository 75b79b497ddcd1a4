// Seeded white noise of unit variance.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

inline std::vector<double> white_noise(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 generator{seed};
  std::normal_distribution<double> normal;
  std::vector<double> x(n);
  for (double& value : x) value = normal(generator);
  return x;
}
