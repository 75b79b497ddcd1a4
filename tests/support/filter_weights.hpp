// The filters of the geometry chain as weights, convolved directly: what the running sums are held
// against.
#pragma once

#include <cmath>
#include <cstdlib>
#include <vector>

#include <railbook/filters/high_pass.hpp>

// N - |j|: from short offsets to those of the chord of 2N samples.
inline std::vector<double> chord_taps(int half) {
  std::vector<double> taps;
  for (int j = 1 - half; j < half; ++j) taps.push_back(half - std::abs(j));
  return taps;
}

inline std::vector<double> convolve(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}

inline std::vector<double> high_pass_taps(const railbook::filters::HighPass& f) {
  const std::vector<double> box(static_cast<std::size_t>(f.length), 1.0);
  std::vector<double> taps{-1.0};  // integers below 2^53: exact
  for (int pass = 0; pass < f.passes; ++pass) taps = convolve(taps, box);
  for (double& w : taps) w /= std::pow(f.length, f.passes);
  taps[taps.size() / 2] += 1;
  return f.stages == 1 ? taps : convolve(taps, taps);
}

inline std::vector<double> space_curve_taps(const railbook::filters::HighPass& f) {
  std::vector<double> taps;
  for (const auto w : railbook::filters::space_curve_integers(f))
    taps.push_back(static_cast<double>(w) / std::pow(f.length, f.passes));
  return f.stages == 1 ? taps : convolve(taps, high_pass_taps({f.length, f.passes, 1}));
}
