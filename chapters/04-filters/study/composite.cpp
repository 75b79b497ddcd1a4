/*** The same filter in several ways; the number type is a parameter where it matters: */
#include "study/composite.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "filters/chord_filter.hpp"
#include "filters/geometry_chain.hpp"
#include "spectra/synthetic_track.hpp"
#include "units/constants.hpp"

namespace railbook::filters_chapter {
namespace {

using Word = std::uint64_t;
constexpr std::size_t reach = 330, window = 2 * reach + 1;
constexpr int N = 31, M = 151, passes = 4;
const double M_power = std::pow(M, passes);

}  // namespace

std::vector<std::int64_t> composite_input(std::size_t n) {
  spectra::SyntheticTrack track;
  track.seed = 62;
  track.A = 5e-7;
  track.phi_c = 0.13;
  track.dip = 5.5e-3;
  const auto offsets = spectra::mid_chord_offsets(spectra::synthesize(track, n + 2), 1, 2).offset;
  std::vector<std::int64_t> units(n);
  for (std::size_t i = 0; i < n; ++i) units[i] = std::llround(offsets[i] / composite_unit);
  return units;
}

std::vector<double> in_metres(const std::vector<std::int64_t>& units) {
  std::vector<double> x(units.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(units[i]) * composite_unit;
  return x;
}

// Numerators of the weights over 2 M^p: the space curve's, and its chord.
std::vector<Word> composite_integers() {
  const auto curve = filters::space_curve_integers({M, passes, 1});
  std::vector<Word> taps(window);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const auto c = static_cast<Word>(curve[i]);
    taps[i + N] += 2 * c;
    taps[i] -= c;
    taps[i + N + N] -= c;
  }
  return taps;
}

std::vector<double> exact_composite(const std::vector<std::int64_t>& x) {
  const auto taps = composite_integers();
  std::vector<Word> sums(x.size() - window + 1);
  for (std::size_t j = 0; j < window; ++j)
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += taps[j] * static_cast<Word>(x[i + j]);
  std::vector<double> out(sums.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] =
        static_cast<double>(static_cast<std::int64_t>(sums[i])) * composite_unit / (2 * M_power);
  return out;
}

// The 661 weights.
std::vector<double> composite_taps() {
  const auto integers = composite_integers();
  std::vector<double> taps(window);
  for (std::size_t j = 0; j < window; ++j)
    taps[j] = static_cast<double>(static_cast<std::int64_t>(integers[j])) / (2 * M_power);
  return taps;
}

// A block of outputs stays in the cache while all weights pass over it; the inner loop is vectorised.
std::vector<double> fir_composite(const std::vector<double>& x) {
  constexpr std::size_t block = 1024;
  const auto taps = composite_taps();
  std::vector<double> out(x.size() - taps.size() + 1);
  std::array<double, block> sums{};
  for (std::size_t begin = 0; begin < out.size(); begin += block) {
    const std::size_t count = std::min(block, out.size() - begin);
    const double* from = x.data() + begin;
    std::fill_n(sums.begin(), count, 0.0);
    for (std::size_t j = 0; j + 1 < taps.size(); j += 2)
      for (std::size_t i = 0; i < count; ++i)
        sums[i] += taps[j] * from[i + j] + taps[j + 1] * from[i + j + 1];
    for (std::size_t i = 0; i < count; ++i)  // their number is odd
      sums[i] += taps.back() * from[i + taps.size() - 1];
    std::copy_n(sums.begin(), count, out.begin() + static_cast<std::ptrdiff_t>(begin));
  }
  return out;
}

// Chord first, high-pass then: every running sum has a single pole.
template <class Number>
std::vector<double> sums_composite(std::span<const Number> x, std::size_t restart) {
  const auto once = filters::running_sum<Number>(x, N, restart);
  const auto chord = filters::running_sum<Number>(once, N, restart);
  std::vector<Number> mean = chord;
  for (int pass = 0; pass < passes; ++pass) mean = filters::running_sum<Number>(mean, M, restart);
  const auto scale = static_cast<Number>(M_power);
  constexpr auto centre = static_cast<std::size_t>(passes) * (M / 2);
  std::vector<double> out(mean.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = static_cast<double>(chord[i + centre] - mean[i] / scale);
  }
  return out;
}
template std::vector<double> sums_composite(std::span<const double>, std::size_t);
template std::vector<double> sums_composite(std::span<const float>, std::size_t);

// The profile by two integrators, then high-pass and chord.
template <class Number>
std::vector<double> recursive_composite(const std::vector<Number>& x) {
  std::vector<Number> z(x.size() + 2);
  Number slope{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    slope -= x[i] + x[i];
    z[i + 2] = z[i + 1] + slope;
  }
  std::vector<Number> curve = z;
  for (int pass = 0; pass < passes; ++pass) curve = filters::running_sum<Number>(curve, M, 0);
  const auto scale = static_cast<Number>(M_power);
  constexpr auto centre = static_cast<std::size_t>(passes) * (M / 2);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    curve[i] = z[i + centre] - curve[i] / scale;
  }
  std::vector<double> out(curve.size() - 2 * N);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = static_cast<double>(curve[i + N] + curve[i + N] - curve[i] - curve[i + N + N]) / 2;
  return out;
}
template std::vector<double> recursive_composite(const std::vector<float>&);

std::vector<double> stream_composite(const std::vector<double>& x, std::size_t block) {
  std::vector<double> out;
  out.reserve(x.size());
  filters::GeometryChain chain{{.block = block}, [&](auto, std::span<const double> chord) {
                                 out.insert(out.end(), chord.begin(), chord.end());
                               }};
  chain.push(x);
  chain.finish();
  return {out.begin() + reach, out.end() - reach};
}

}  // namespace railbook::filters_chapter
