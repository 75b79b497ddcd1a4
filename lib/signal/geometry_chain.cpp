#include "signal/geometry_chain.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "units/input_error.hpp"

namespace railbook::signal {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Running sums of `length` in place: x[i] <- x[i] + ... + x[i + length - 1] for the first `count` places.
void box(double* x, std::size_t count, std::size_t length) {
  double sum = 0;
  for (std::size_t j = 0; j < length; ++j) sum += x[j];
  for (std::size_t i = 0; i < count; ++i) {
    const double leaving = x[i];
    x[i] = sum;
    sum += x[i + length] - leaving;
  }
}

// Two of them in one loop, so that the processor adds to both sums at once; `between` holds the first. Both sums start
// from nothing: the place i is right from the second `length` on, and goes where nobody reads any more.
void two_boxes(double* x, double* between, std::size_t size, std::size_t length) {
  double first = 0, second = 0;
  for (std::size_t i = 0; i < length; ++i) {
    first += x[i];
    between[i] = first;
    second += first;
  }
  const std::size_t late = 2 * (length - 1);
  for (std::size_t i = length; i < late; ++i) {
    first += x[i] - x[i - length];
    between[i] = first;
    second += first - between[i - length];
  }
  for (std::size_t i = late; i < size; ++i) {
    first += x[i] - x[i - length];
    between[i] = first;
    second += first - between[i - length];
    x[i - late] = second;
  }
}

}  // namespace

GeometryChain::GeometryChain(const GeometryChainOptions& options, Sink sink)
    : options_(options), sink_(std::move(sink)) {
  units::require_between("half chord in samples", options.half_chord, 1, 1e4);
  units::require_positive("limit", options.limit, "m");
  units::require_between("block", static_cast<double>(options.block), 1, 1e8);
  curve_reach_ = signal::reach(options.high_pass) - 1;
  reach_ = curve_reach_ + static_cast<std::size_t>(options.half_chord);
  in_.reserve(options.block + 2 * reach_);
  curve_.resize(in_.capacity() + 2);
  scratch_.resize(curve_.size() + 1);
  between_.resize(curve_.size());
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
    // Magnitudes compare as integers; NaN is larger than any number, and asks no floating-point comparison.
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
  const std::vector<double> unknown(reach_, none);
  push(unknown);
  masked_ = masked;
  if (in_.size() > 2 * reach_) compute();
}

std::size_t GeometryChain::memory() const {
  return sizeof(double) * (in_.capacity() + curve_.capacity() + scratch_.capacity() +
                           between_.capacity() + chord_.capacity()) +
         sizeof(std::size_t) * holes_.capacity();
}

// The profile whose short chords these are, but for a straight line: curve_[i] is z_{i-1}. No rounding of one block
// gets into the next, and the high-pass does not see the line.
void GeometryChain::integrate() {
  double z = 0, slope = 0;
  curve_[0] = curve_[1] = 0;
  for (std::size_t i = 0; i < in_.size(); ++i) {
    slope -= 2 * in_[i];
    z += slope;
    curve_[i + 2] = z;
  }
}

void GeometryChain::compute() {
  const std::size_t n = in_.size() - 2 * reach_;
  const auto N = static_cast<std::size_t>(options_.half_chord);
  const auto M = static_cast<std::size_t>(options_.high_pass.length);
  const auto passes = static_cast<std::size_t>(options_.high_pass.passes);
  const double scale = 1 / std::pow(options_.high_pass.length, options_.high_pass.passes);
  integrate();
  std::size_t size = in_.size() + 2;
  for (int stage = 0; stage < options_.high_pass.stages; ++stage) {
    std::copy_n(curve_.begin(), size, scratch_.begin());
    const std::size_t centre = passes * (M / 2);
    for (std::size_t pass = 0; pass + 1 < passes; pass += 2) {
      two_boxes(scratch_.data(), between_.data(), size, M);
      size -= 2 * (M - 1);
    }
    if (passes % 2 == 1) {
      scratch_[size] = 0;
      size -= M - 1;
      box(scratch_.data(), size, M);
    }
    for (std::size_t i = 0; i < size; ++i) curve_[i] = curve_[i + centre] - scale * scratch_[i];
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
      for (std::size_t i = std::max(settled, first); i < end; ++i) out[i] = none;
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
                         2 * static_cast<double>(chain.reach()) + 1, units::no_limit);
  chain.push(x);
  chain.finish();
  return result;
}

}  // namespace railbook::signal
