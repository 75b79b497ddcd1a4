#include <railbook/spectra/welch.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include <railbook/num/pairs.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

// With the sign bit where x is NaN or infinite. On the bits, so that it neither traps nor branches:
// an exponent of all ones overflows into the sign bit when one is added to it.
std::uint64_t not_finite(double x) {
  constexpr std::uint64_t exponent = 0x7ff0000000000000ULL, one = 0x0010000000000000ULL;
  return (std::bit_cast<std::uint64_t>(x) & exponent) + one;
}
bool is_gap(double x) {
  return not_finite(x) >> 63U != 0;
}

bool has_gap(std::span<const double> x) {
  std::uint64_t any = 0;
  for (const double value : x) any |= not_finite(value);
  return any >> 63U != 0;
}

void add_power(std::span<const std::complex<double>> z, double weight, double* power) {
  for (std::size_t i = 0; i < z.size(); ++i)
    power[i] += weight * (z[i].real() * z[i].real() + z[i].imag() * z[i].imag());
}

struct Sums {
  double sum = 0, moment = 0;
};

// Sum of x and of (i - centre) x, in eight strands: a single one would wait for each addition to
// finish.
Sums strand_sums(std::span<const double> x) {
  constexpr std::size_t strands = 8;
  const double centre = 0.5 * (static_cast<double>(x.size()) - 1.0);
  std::array<double, strands> sum{}, moment{};
  double middle = 3.5 - centre;  // of the eight
  std::size_t i = 0;
  for (; i + strands <= x.size(); i += strands) {
    for (std::size_t j = 0; j < strands; ++j) {
      sum[j] += x[i + j];
      moment[j] += middle * x[i + j];
    }
    middle += static_cast<double>(strands);
  }
  Sums total;
  for (; i < x.size(); ++i) {
    total.sum += x[i];
    total.moment += (static_cast<double>(i) - centre) * x[i];
  }
  for (std::size_t j = 0; j < strands; ++j) {
    total.sum += sum[j];
    total.moment += moment[j] + (static_cast<double>(j) - 3.5) * sum[j];
  }
  return total;
}

WelchOptions checked(const WelchOptions& o) {
  if (o.segment < 16 || o.segment % 2 != 0)
    throw InputError{"segment of " + std::to_string(o.segment) +
                     " samples; allowed: even numbers from 16"};
  if (o.parts < 1 || o.segment % o.parts != 0)
    throw InputError{"segment of " + std::to_string(o.segment) + " samples in " +
                     std::to_string(o.parts) + " parts; allowed: parts that divide the segment"};
  return o;
}

// sum w^p(i) w^p(i + shift) over sum w^2p, p = 1 or 2: how much two segments `shift` apart have in
// common.
double overlap_share(const std::vector<double>& w, std::size_t shift, int power) {
  const auto weight = [&](std::size_t i) { return power == 1 ? w[i] : w[i] * w[i]; };
  double common = 0, whole = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    whole += weight(i) * weight(i);
    if (i + shift < w.size()) common += weight(i) * weight(i + shift);
  }
  return common / whole;
}

}  // namespace

Welch::Welch(double spacing, const WelchOptions& options)
    : spacing_(units::require_positive("sample spacing", spacing, "m")),
      options_(checked(options)),
      hop_(options_.segment / options_.parts),
      buffer_(hop_ + 4 * options_.segment),
      begin_(hop_),
      power_(options_.segment),
      used_(options_.parts, false),
      fft_(options_.segment) {
  const auto w = window_weights(options_.window, static_cast<Eigen::Index>(options_.segment));
  window_.assign(w.begin(), w.end());
  blocks_.reserve(options_.parts);
}

void Welch::push(std::span<const double> samples) {
  samples_ += samples.size();
  while (!samples.empty()) {
    const std::size_t block_end = (blocks_.size() + 1) * hop_;
    const auto piece = samples.first(std::min(block_end - filled_, samples.size()));
    if (has_gap(piece)) {
      samples = samples.subspan(restart(piece));
      continue;
    }
    std::copy(piece.begin(), piece.end(),
              buffer_.begin() + static_cast<std::ptrdiff_t>(begin_ + filled_));
    filled_ += piece.size();
    samples = samples.subspan(piece.size());
    if (filled_ == block_end) finish_block();
    if (blocks_.size() == options_.parts) finish_segment();
  }
}

// A gap: the next segment begins after it. Returns how many samples of `piece` are done with.
std::size_t Welch::restart(std::span<const double> piece) {
  std::size_t gap = 0;
  while (!is_gap(piece[gap])) ++gap;
  std::size_t end = gap;
  while (end < piece.size() && is_gap(piece[end])) ++end;
  gap_samples_ += end - gap;
  std::copy_n(piece.begin(), gap, buffer_.begin() + static_cast<std::ptrdiff_t>(begin_ + filled_));
  filled_ += gap;
  if (used_[0] && filled_ > averaged_)
    add_last_segment();
  else
    unused_ += filled_ - averaged_;
  if (waiting_) transform(*waiting_, *waiting_, 0.5, fft_, power_);
  waiting_.reset();
  filled_ = averaged_ = 0;
  begin_ = hop_;
  blocks_.clear();
  std::fill(used_.begin(), used_.end(), false);
  return end;
}

// The last samples of a run, which the steps do not meet.
void Welch::add_last_segment() {
  const double* x = buffer_.data() + begin_ + filled_ - options_.segment;
  Sums sums;
  if (options_.detrend != Detrend::none) sums = strand_sums({x, options_.segment});
  const std::size_t fresh = filled_ - averaged_;
  const double weight = static_cast<double>(fresh) / static_cast<double>(hop_);
  const Segment last = add_segment(x, sums.sum, sums.moment, weight);
  transform(last, last, 0.5 * weight, fft_, power_);
  for (std::size_t j = 0; j < used_.size(); ++j)
    if (used_[j]) pairs_[fresh + j * hop_] += weight;
}

void Welch::finish_block() {
  Block done;
  if (options_.detrend != Detrend::none) {
    const Sums sums = strand_sums({buffer_.data() + begin_ + filled_ - hop_, hop_});
    done.sum = sums.sum;
    done.moment = sums.moment;
  }
  blocks_.push_back(done);
}

// The straight line comes from the sums of the blocks, so each sample is summed once however many
// segments it is in, and taking the line off costs no pass of its own: it is done while the window
// is applied.
void Welch::finish_segment() {
  const double centre = 0.5 * (static_cast<double>(options_.segment) - 1.0);
  const auto hop = static_cast<double>(hop_);
  double sum = 0, moment = 0, block_centre = 0.5 * (hop - 1.0);
  for (const Block& block : blocks_) {
    sum += block.sum;
    moment += block.moment + (block_centre - centre) * block.sum;
    block_centre += hop;
  }
  const Segment segment = add_segment(buffer_.data() + begin_, sum, moment, 1);
  if (waiting_) {
    transform(*waiting_, segment, 1, fft_, power_);
    waiting_.reset();
  } else {
    waiting_ = segment;
  }
  for (std::size_t j = 1; j < options_.parts; ++j)
    if (used_[j - 1]) pairs_[j * hop_] += 1;
  for (std::size_t j = used_.size(); j-- > 1;) used_[j] = used_[j - 1];
  used_[0] = true;
  blocks_.erase(blocks_.begin());
  averaged_ = filled_ -= hop_;
  begin_ += hop_;
  if (begin_ + options_.segment <= buffer_.size()) return;
  std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_ - hop_), hop_ + filled_,
              buffer_.begin());
  begin_ = hop_;
  if (waiting_) waiting_->x = buffer_.data();
}

Welch::Segment Welch::add_segment(const double* x, double sum, double moment, double weight) {
  const auto n = static_cast<double>(options_.segment);
  const double slope =
      options_.detrend == Detrend::linear ? 12.0 * moment / (n * (n * n - 1.0)) : 0.0;
  ++segments_;
  weight_ += weight;
  weights_squared_ += weight * weight;
  return {x, sum / n - slope * 0.5 * (n - 1.0), slope};
}

void Welch::weigh(const double* window, const Segment& one, const Segment& other,
                  std::span<std::complex<double>> z) {
  const num::Pair start{one.start, other.start}, slope{one.slope, other.slope};
  num::Pair place{};
  for (std::size_t i = 0; i < z.size(); ++i, place += 1) {
    const num::Pair x{one.x[i], other.x[i]}, y = window[i] * (x - (start + slope * place));
    z[i] = {y[0], y[1]};
  }
}

// Two segments, of `weight` each, as the real and the imaginary part of one transform: |Z_k|^2 +
// |Z_(n-k)|^2 is twice the sum of their powers.
void Welch::transform(const Segment& one, const Segment& other, double weight, num::ComplexFft& fft,
                      std::vector<double>& power) const {
  weigh(window_.data(), one, other, fft.values());
  fft.forward();
  add_power(fft.values(), weight, power.data());
}

Spectrum Welch::spectrum() const {
  if (segments_ == 0)
    throw InputError{"the record has " + std::to_string(samples_) + " samples, " +
                     std::to_string(gap_samples_) + " of them missing; a spectrum needs " +
                     std::to_string(options_.segment) + " in a row without a gap"};
  const auto n = static_cast<double>(options_.segment);
  double sum_1 = 0, sum_2 = 0, sum_4 = 0;
  for (const double w : window_) {
    sum_1 += w;
    sum_2 += w * w;
    sum_4 += w * w * w * w;
  }
  Spectrum result;
  result.df = 1.0 / (n * spacing_);
  result.segments = segments_;
  result.unused = unused();
  result.noise_bandwidth = n * sum_2 / (sum_1 * sum_1) * result.df;
  double share_of_bins = weights_squared_ / weight_, share_of_bands = share_of_bins;
  for (const auto& [shift, products] : pairs_) {
    const double pairs = 2.0 * products / weight_;
    const double common = overlap_share(window_, shift, 1);
    share_of_bins += pairs * common * common;
    share_of_bands += pairs * overlap_share(window_, shift, 2);
  }
  result.averages = weight_ / share_of_bins;
  result.band_variance = n * sum_4 / (sum_2 * sum_2) * share_of_bands / weight_;
  std::vector<double> power = power_;
  if (waiting_) {
    num::ComplexFft alone(options_.segment);
    transform(*waiting_, *waiting_, 0.5, alone, power);
  }
  result.density.setZero(static_cast<Eigen::Index>(options_.segment / 2 + 1));
  const double scale = spacing_ / (sum_2 * weight_);
  for (std::size_t k = 0; k < options_.segment; ++k)  // a bin and its mirror image
    result.density[static_cast<Eigen::Index>(std::min(k, options_.segment - k))] +=
        scale * power[k];
  return result;
}

Spectrum respaced(const Spectrum& from, double spacing) {
  units::require_positive("sample spacing", spacing, "m");
  Spectrum result = from;
  result.df /= spacing;
  result.noise_bandwidth /= spacing;
  result.density *= spacing;
  return result;
}

Spectrum welch(std::span<const double> samples, double spacing, const WelchOptions& options) {
  Welch estimate{spacing, options};
  estimate.push(samples);
  return estimate.spectrum();
}

BandSpectrum band_average(const Spectrum& spectrum, double per_octave, double low, double high) {
  units::require_positive("bands per octave", per_octave);
  units::require_positive("lower frequency", low, "cycle/m");
  units::require_between("upper frequency", high, low, units::infinity, "cycle/m");
  std::vector<double> frequency, density, error;
  std::vector<int> bins;
  double log_sum = 0, sum = 0;
  int count = 0, band = -1;
  const auto close = [&] {
    if (count == 0) return;
    frequency.push_back(std::exp(log_sum / count));
    density.push_back(sum / count);
    bins.push_back(count);
    error.push_back(std::sqrt(std::min(1.0 / spectrum.averages, spectrum.band_variance / count)));
    log_sum = sum = count = 0;
  };
  for (Eigen::Index k = 1; k < spectrum.density.size(); ++k) {
    const double f = spectrum.frequency(k);
    if (f < low || f > high) continue;
    const int here = static_cast<int>(std::floor(per_octave * std::log2(f / low)));
    if (here != band) close();
    band = here;
    log_sum += std::log(f);
    sum += spectrum.density[k];
    ++count;
  }
  close();
  const auto as_vector = [](const std::vector<double>& v) {
    return Eigen::VectorXd{
        Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()))};
  };
  return {as_vector(frequency), as_vector(density),
          Eigen::Map<const Eigen::VectorXi>(bins.data(), static_cast<Eigen::Index>(bins.size())),
          as_vector(error)};
}

}  // namespace railbook::spectra
