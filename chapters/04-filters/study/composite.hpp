// The composite filter, short offsets to high-passed 62-ft chord, written in several ways. All give the n - 660
// outputs that have their whole window, in metres.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace railbook::filters_chapter {

inline constexpr double composite_unit = 0x1p-34;  // m
inline constexpr std::size_t composite_window = 661;

// Short offsets of synthetic track in whole units, and in metres.
std::vector<std::int64_t> composite_input(std::size_t n);
std::vector<double> in_metres(const std::vector<std::int64_t>& units);

// The exact result, by integer weights, rounded once at the end.
std::vector<double> exact_composite(const std::vector<std::int64_t>& units);

using Composite = std::function<std::vector<double>(const std::vector<double>&)>;
std::vector<double> by_weights(const std::vector<double>& x);     // 661 of them, directly
std::vector<double> by_transforms(const std::vector<double>& x);  // of overlapping blocks
std::vector<double> by_sums(const std::vector<double>& x);        // cascaded, started anew
std::vector<double> by_stream(const std::vector<double>& x);      // the class of the library

// How the filter may run on for ever: six running sums, or two integrators ahead of them.
enum class Endless { sums, integrators };

// The largest error, m, among the samples from one count to the next of `counts` (ascending), of a filter in `Number` that
// never starts anew, fed with `period` over and over.
template <class Number>
std::vector<double> drift(Endless way, const std::vector<std::int64_t>& period,
                          const std::vector<std::size_t>& counts);

}  // namespace railbook::filters_chapter
