#include <railbook/filters/geometry_chain.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::filters {
namespace {

// Two numbers that the processor handles as one: two halves of a block at once.
using Pair = GeometryChain::Pair;

// x - (sum of M, P times over)/M^P, for `out.size()` outputs o of the samples o ... o + P (M - 1),
// in one loop: 2 P + 2 additions a sample, no matter how long the sums are. With `integrate`, x is
// not `in` but the profile whose short chords `in` is: x_0 = x_1 = 0, and -2 in[i] is the second
// difference. The straight line left free is nothing to the high-pass. All sums start anew here, so
// no rounding of one block gets into the next.
template <int P, bool integrate>
void high_pass(const double* in, std::span<double> out, std::vector<Pair>& rows, std::size_t M) {
  const std::size_t half = (out.size() + 1) / 2, other = out.size() - half;
  const std::size_t early = integrate ? 2 : 0;  // x runs ahead of `in`
  const std::size_t late = P * (M - 1) - early, centre = P * (M / 2), stride = half + late + M;
  const double scale = 1 / std::pow(M, P);
  rows.resize(std::max(rows.size(), P * stride));
  std::array<Pair*, P> row;
  for (std::size_t p = 0; p < P; ++p) {
    std::fill_n(rows.data() + p * stride, M, Pair{});
    row[p] = rows.data() + p * stride + M;
  }
  std::array<Pair, P> sum{};
  Pair slope{}, z{};
  const auto step = [&](std::size_t i) {
    Pair x{in[i], in[i + other]};
    if constexpr (integrate) {
      slope -= x + x;
      x = z += slope;
    }
    for (std::size_t p = 0; p < P; ++p) {
      const Pair leaving = *(row[p] + i - M);
      row[p][i] = x;
      x = sum[p] += x - leaving;
    }
    return x;
  };
  for (std::size_t i = 0; i < late; ++i) step(i);
  for (std::size_t o = 0; o < half; ++o) {
    const Pair sums = step(o + late), y = *(row[0] + o + centre - early) - scale * sums;
    out[o] = y[0];
    out[o + other] = y[1];
  }
}

template <bool integrate>
void high_pass(int passes, const double* in, std::span<double> out, std::vector<Pair>& rows,
               std::size_t M) {
  switch (passes) {
    case 1:
      return high_pass<1, integrate>(in, out, rows, M);
    case 2:
      return high_pass<2, integrate>(in, out, rows, M);
    case 3:
      return high_pass<3, integrate>(in, out, rows, M);
    case 4:
      return high_pass<4, integrate>(in, out, rows, M);
    case 5:
      return high_pass<5, integrate>(in, out, rows, M);
    case 6:
      return high_pass<6, integrate>(in, out, rows, M);
    case 7:
      return high_pass<7, integrate>(in, out, rows, M);
    default:
      return high_pass<8, integrate>(in, out, rows, M);
  }
}

}  // namespace

GeometryChain::GeometryChain(const GeometryChainOptions& options, Sink sink)
    : options_(options), sink_(std::move(sink)) {
  units::require_between("half chord in samples", options.half_chord, 1, 1e4);
  units::require_positive("limit", options.limit, "m");
  units::require_between("block", static_cast<double>(options.block), 1, 1e8);
  curve_reach_ = filters::reach(options.high_pass) - 1;
  reach_ = curve_reach_ + static_cast<std::size_t>(options.half_chord);
  in_.reserve(options.block + 2 * reach_);
  chord_.resize(options.block);
  // What was before the record is not known.
  in_.resize(reach_);
  for (std::size_t i = 0; i < reach_; ++i) holes_.push_back(i);
}

void GeometryChain::push(std::span<const double> x) {
  const auto limit = std::bit_cast<std::uint64_t>(options_.limit);
  while (!x.empty()) {
    const std::size_t room = options_.block + 2 * reach_ - in_.size();
    const auto part = x.first(std::min(room, x.size()));
    const std::size_t begin = in_.size();
    in_.insert(in_.end(), part.begin(), part.end());
    // Magnitudes compare as integers; NaN is larger than any number, and asks no floating-point
    // comparison.
    bool clean = true;
    for (const double v : part) clean &= std::bit_cast<std::uint64_t>(std::abs(v)) <= limit;
    if (!clean) {
      for (std::size_t i = begin; i < in_.size(); ++i) {
        if (std::bit_cast<std::uint64_t>(std::abs(in_[i])) <= limit) continue;
        in_[i] = 0;
        holes_.push_back(i);
        ++masked_;
      }
    }
    if (part.size() == room) compute();
    x = x.subspan(part.size());
  }
}

void GeometryChain::finish() {
  const std::size_t masked = masked_;
  const std::vector<double> unknown(reach_, units::nan);
  push(unknown);
  masked_ = masked;
  if (in_.size() > 2 * reach_) compute();
}

std::size_t GeometryChain::memory() const {
  return sizeof(double) *
             (in_.capacity() + curve_.capacity() + scratch_.capacity() + chord_.capacity()) +
         sizeof(Pair) * rows_.capacity() + sizeof(std::size_t) * holes_.capacity();
}

void GeometryChain::compute() {
  const std::size_t n = in_.size() - 2 * reach_;
  const auto N = static_cast<std::size_t>(options_.half_chord);
  const auto M = static_cast<std::size_t>(options_.high_pass.length);
  const HighPass& hp = options_.high_pass;
  const std::size_t ends = static_cast<std::size_t>(hp.passes) * (M - 1);
  curve_.resize(in_.size() + 2 - ends);
  high_pass<true>(hp.passes, in_.data(), curve_, rows_, M);
  if (hp.stages == 2) {
    scratch_.resize(curve_.size() - ends);
    high_pass<false>(hp.passes, curve_.data(), scratch_, rows_, M);
    std::swap(curve_, scratch_);
  }
  for (std::size_t i = 0; i < n; ++i)
    chord_[i] = curve_[i + N] - 0.5 * (curve_[i] + curve_[i + 2 * N]);
  mask();
  sink_(std::span<const double>{curve_}.subspan(N, n), std::span<const double>{chord_}.first(n));
  in_.erase(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(n));
  const auto kept = std::lower_bound(holes_.begin(), holes_.end(), n);
  holes_.erase(holes_.begin(), kept);
  for (std::size_t& hole : holes_) hole -= n;
}

// A hole at q spoils the outputs whose centre i + reach_ is within a window's reach of it.
void GeometryChain::mask() {
  const std::size_t n = in_.size() - 2 * reach_;
  const auto spoil = [&](double* out, std::size_t window) {
    std::size_t settled = 0;
    for (const std::size_t q : holes_) {
      const std::size_t first = q > reach_ + window ? q - reach_ - window : 0;
      if (q + window < reach_) continue;
      const std::size_t end = std::min(n, q + window - reach_ + 1);
      for (std::size_t i = std::max(settled, first); i < end; ++i) out[i] = units::nan;
      settled = std::max(settled, end);
    }
  };
  spoil(curve_.data() + options_.half_chord, curve_reach_);
  spoil(chord_.data(), reach_);
}

Geometry geometry(std::span<const double> x, const GeometryChainOptions& options) {
  Geometry result;
  GeometryChain chain{options, [&](std::span<const double> curve, std::span<const double> chord) {
                        result.space_curve.insert(result.space_curve.end(), curve.begin(),
                                                  curve.end());
                        result.chord.insert(result.chord.end(), chord.begin(), chord.end());
                      }};
  units::require_between("samples of the record", static_cast<double>(x.size()),
                         2 * static_cast<double>(chain.reach()) + 1, units::infinity);
  result.space_curve.reserve(x.size());
  result.chord.reserve(x.size());
  chain.push(x);
  chain.finish();
  return result;
}

}  // namespace railbook::filters
