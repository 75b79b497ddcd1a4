#include <railbook/filters/fir_filter.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>

namespace railbook::filters {
namespace {

// How many samples stand before the first gap.
std::size_t whole(std::span<const double> z) {
  constexpr std::size_t stretch = 256;
  std::size_t i = 0;
  for (; i + stretch <= z.size(); i += stretch) {
    bool gap = false;
    for (const double v : z.subspan(i, stretch)) gap |= std::isnan(v);
    if (gap) break;
  }
  while (i < z.size() && !std::isnan(z[i])) ++i;
  return i;
}

// Sample i of a piece, also before its begin and after its end: point-symmetric, then level.
double continued(std::span<const double> z, std::ptrdiff_t i) {
  const auto last = static_cast<std::ptrdiff_t>(z.size()) - 1;
  if (i < 0) return 2 * z.front() - z[static_cast<std::size_t>(std::min(-i, last))];
  if (i > last)
    return 2 * z.back() - z[static_cast<std::size_t>(std::max(2 * last - i, std::ptrdiff_t{0}))];
  return z[static_cast<std::size_t>(i)];
}

}  // namespace

std::vector<double> symmetric_gains(std::span<const double> half, num::RealFft& fft) {
  const std::size_t n = fft.size();
  const auto x = fft.real();
  std::fill(x.begin(), x.end(), 0.0);
  x[0] = half[0];
  for (std::size_t j = 1; j < half.size(); ++j) x[j] = x[n - j] = half[j];
  fft.forward();
  std::vector<double> result(n / 2 + 1);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = fft.spectrum()[k].real();
  return result;
}

std::vector<double> filter_direct(const FilterTaps& taps, std::span<const double> record) {
  const auto n = static_cast<std::ptrdiff_t>(record.size());
  const auto reach = static_cast<std::ptrdiff_t>(taps.half.size()) - 1;
  std::vector<double> z(static_cast<std::size_t>(n + 2 * reach)), out(record.size(), 0.0);
  for (std::ptrdiff_t i = 0; i < n + 2 * reach; ++i)
    z[static_cast<std::size_t>(i)] = continued(record, i - reach);
  constexpr std::ptrdiff_t block = 1024;  // stays in the first cache, and its loop is vectorised
  for (std::ptrdiff_t from = 0; from < n; from += block) {
    const std::ptrdiff_t count = std::min(block, n - from);
    double* const y = out.data() + from;
    const double* const centre = z.data() + reach + from;
    for (std::ptrdiff_t i = 0; i < count; ++i) y[i] = taps.half[0] * centre[i];
    for (std::ptrdiff_t j = 1; j <= reach; ++j) {
      const double h = taps.half[static_cast<std::size_t>(j)];
      const double *left = centre - j, *right = centre + j;
      for (std::ptrdiff_t i = 0; i < count; ++i) y[i] += h * (left[i] + right[i]);
    }
  }
  return out;
}

FilterStream::FilterStream(const FilterTaps& taps, Sink sink)
    : sink_(std::move(sink)), reach_(taps.half.size() - 1), fft_(std::bit_ceil(6 * reach_)) {
  const std::size_t size = fft_.values().size();
  num::RealFft of_taps(size);
  const std::vector<double> gain = symmetric_gains(taps.half, of_taps);
  for (std::size_t k = 0; k < size; ++k)
    gain_.push_back(gain[std::min(k, size - k)] / static_cast<double>(size));
  outputs_ = size - 2 * reach_;
  block_.resize(2 * outputs_ + 2 * reach_);
}

void FilterStream::push(std::span<const double> record) {
  while (!record.empty()) {
    const auto piece =
        record.first(std::min<std::size_t>(record.size(), 2048));  // stays in the cache
    const std::size_t known = whole(piece);
    push_piece(piece.first(known));
    record = record.subspan(known);
    if (known == piece.size()) continue;
    end_piece();
    const auto next = std::ranges::find_if_not(record, [](double z) { return std::isnan(z); });
    const auto missing = static_cast<std::size_t>(next - record.begin());
    sink_(record.first(missing));
    record = record.subspan(missing);
  }
}

void FilterStream::push_piece(std::span<const double> piece) {
  for (std::size_t i = 0; i < piece.size();) {
    if (!open_) {
      first_.push_back(piece[i++]);
      if (first_.size() > reach_) begin_piece();
      continue;
    }
    const std::size_t count = std::min(piece.size() - i, block_.size() - filled_);
    std::copy_n(piece.data() + i, count, block_.data() + filled_);
    filled_ += count;
    i += count;
    if (filled_ == block_.size()) transform(2 * outputs_);
  }
}

void FilterStream::begin_piece() {
  open_ = true;
  for (std::size_t i = reach_; i > 0; --i)
    append(continued(first_, -static_cast<std::ptrdiff_t>(i)));
  for (const double z : first_) append(z);
  first_.clear();
}

void FilterStream::append(double value) {
  block_[filled_++] = value;
  if (filled_ == block_.size()) transform(2 * outputs_);
}

// Filters both halves of the block, one as the real and the other as the imaginary part, hands on
// the values of `outputs` samples from the first with a whole reach to its left, and keeps the last
// two reaches.
void FilterStream::transform(std::size_t outputs) {
  std::fill(block_.begin() + static_cast<std::ptrdiff_t>(filled_), block_.end(), 0.0);
  auto z = fft_.values();
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = {block_[i], block_[i + outputs_]};
  fft_.forward();
  z = fft_.values();
  for (std::size_t k = 0; k < z.size(); ++k) z[k] *= gain_[k];
  fft_.inverse();
  z = fft_.values();
  for (std::size_t i = 0; i < outputs_; ++i) {
    block_[i] = z[reach_ + i].real();
    block_[i + outputs_] = z[reach_ + i].imag();
  }
  sink_(std::span<const double>(block_).first(outputs));
  std::copy(block_.end() - static_cast<std::ptrdiff_t>(2 * reach_), block_.end(), block_.begin());
  filled_ = 2 * reach_;
}

void FilterStream::end_piece() {
  if (!open_ && first_.empty()) return;
  std::vector<double> known = first_;  // the piece, or its last part, longer than the reach
  if (open_)
    known.assign(block_.begin(), block_.begin() + static_cast<std::ptrdiff_t>(filled_));
  else
    begin_piece();
  for (std::size_t i = 0; i < reach_; ++i)
    append(continued(known, static_cast<std::ptrdiff_t>(known.size() + i)));
  if (filled_ > 2 * reach_) transform(filled_ - 2 * reach_);
  filled_ = 0;
  open_ = false;
}

void FilterStream::finish() {
  end_piece();
}

std::vector<double> filter(const FilterTaps& taps, std::span<const double> record) {
  std::vector<double> out;
  out.reserve(record.size());
  FilterStream stream{taps, [&](std::span<const double> piece) {
                        out.insert(out.end(), piece.begin(), piece.end());
                      }};
  stream.push(record);
  stream.finish();
  return out;
}

}  // namespace railbook::filters
