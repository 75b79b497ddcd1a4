// The composite filter, short offsets to high-passed 62-ft chord, written in several ways. All give the n - 660
// outputs that have their whole window, in metres.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace railbook::filters_chapter {

inline constexpr double composite_unit = 0x1p-34;  // m

// Short offsets of synthetic track in whole units, and in metres.
std::vector<std::int64_t> composite_input(std::size_t n);
std::vector<double> in_metres(const std::vector<std::int64_t>& units);

// The exact result, by integer weights, rounded once at the end.
std::vector<double> exact_composite(const std::vector<std::int64_t>& units);

// Weights over a record, directly.
std::vector<double> fir_composite(const std::vector<double>& x);
template <class Number>
std::vector<double> sums_composite(std::span<const Number> x, std::size_t restart);
template <class Number>
std::vector<double> recursive_composite(const std::vector<Number>& x);
std::vector<double> stream_composite(const std::vector<double>& x, std::size_t block);

template <class Number>
std::vector<double> sums_composite(const std::vector<Number>& x, std::size_t restart) {
  return sums_composite(std::span<const Number>{x}, restart);
}

}  // namespace railbook::filters_chapter
