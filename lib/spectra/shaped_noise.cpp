#include <railbook/spectra/shaped_noise.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

// Half the number of taps. A bend at wavenumber `detail` is rounded over a band of 1/(taps
// spacing), which costs 0.4/(taps spacing detail) of the density there (Hann taper): 0.3 % with
// this length.
std::size_t half_length(double spacing, double detail) {
  const double half = 70.0 / (spacing * detail);
  return std::bit_ceil(static_cast<std::size_t>(std::clamp(half, 512.0, 65536.0)));
}

}  // namespace

ShapedNoise::ShapedNoise(const NoiseShape& shape, const num::RandomSource& source)
    : source_(source), spacing_(units::require_positive("spacing", shape.spacing, "m")) {
  const double nyquist = 0.5 / spacing_;
  units::require_positive("low cut", shape.low_cut, "cycle/m");
  units::require_between("low cut", shape.low_cut, 0.0, 0.1 * nyquist, "cycle/m");
  units::require_between("low cut times spacing", shape.low_cut * spacing_, 1e-8, 0.05, "cycle");
  units::require_positive("detail", shape.detail, "cycle/m");
  leak_ = std::exp(-2.0 * units::pi * shape.low_cut * spacing_);
  design(shape);

  // Six lengths of the leaky sum's memory leave exp(-12) of the missing past in the variance.
  std::vector<double> past(4096);
  for (double left = std::ceil(6.0 / (1.0 - leak_)); left > 0; left -= 4096)
    add({past.data(), static_cast<std::size_t>(std::min(left, 4096.0))});
}

void ShapedNoise::design(const NoiseShape& shape) {
  const std::size_t half = half_length(spacing_, shape.detail);
  const std::size_t n = 8 * half;
  fft_ = std::make_unique<num::RealFft>(n);
  const auto spectrum = fft_->spectrum();
  const auto bins = static_cast<double>(n);
  // Amplitude of the slope, times the white noise's own 1/sqrt(2 spacing). At phi = 0 it is read at
  // half a bin, where phi^2 S has its limit.
  for (std::size_t k = 0; k < spectrum.size(); ++k) {
    const double phi = std::max(0.5, static_cast<double>(k)) / (bins * spacing_);
    const double wanted = shape.density(phi);
    units::require_non_negative("wanted density", wanted, "m^2/(cycle/m)");
    const double per_slope =
        k == 0 ? 2.0 * units::pi * phi * spacing_ : 2.0 * std::sin(units::pi * phi * spacing_);
    spectrum[k] = std::sqrt(wanted / (2.0 * spacing_)) * per_slope / bins;
  }
  fft_->inverse();
  const auto impulse = fft_->real();
  taps_.resize(2 * half - 1);
  for (std::size_t j = 0; j < taps_.size(); ++j) {
    const std::size_t lag = j + 1 > half ? j + 1 - half : half - 1 - j;
    const double c =
        std::cos(0.5 * units::pi * static_cast<double>(lag) / static_cast<double>(half));
    taps_[j] = impulse[lag] * c * c;  // Hann taper
  }

  std::fill(fft_->real().begin(), fft_->real().end(), 0.0);
  fft_->real()[0] = taps_[half - 1];
  for (std::size_t lag = 1; lag < half; ++lag)
    fft_->real()[lag] = fft_->real()[n - lag] = taps_[half - 1 + lag];
  fft_->forward();
  response_.resize(spectrum.size());
  for (std::size_t k = 0; k < spectrum.size(); ++k) response_[k] = spectrum[k].real() / bins;

  white_.resize(n);
  const std::size_t overlap = 2 * half - 2;
  for (std::size_t i = n - overlap; i < n; ++i) white_[i] = source_.normal(counter_++);
  ready_.resize(n - overlap);
  used_ = ready_.size();
}

void ShapedNoise::next_block() {
  const std::size_t n = white_.size();
  const std::size_t overlap = n - ready_.size();
  std::copy(white_.end() - static_cast<std::ptrdiff_t>(overlap), white_.end(), white_.begin());
  for (std::size_t i = overlap; i < n; ++i) white_[i] = source_.normal(counter_++);
  std::copy(white_.begin(), white_.end(), fft_->real().begin());
  fft_->forward();
  const auto spectrum = fft_->spectrum();
  for (std::size_t k = 0; k < spectrum.size(); ++k) spectrum[k] *= response_[k];
  fft_->inverse();
  // The filter reaches overlap/2 to either side: only the middle is free of the circular wrap.
  const auto filtered = fft_->real().subspan(overlap / 2, ready_.size());
  for (std::size_t i = 0; i < ready_.size(); ++i) ready_[i] = sum_ = leak_ * sum_ + filtered[i];
  used_ = 0;
}

void ShapedNoise::add(std::span<double> z) {
  for (std::size_t done = 0; done < z.size();) {
    if (used_ == ready_.size()) next_block();
    const std::size_t count = std::min(z.size() - done, ready_.size() - used_);
    for (std::size_t i = 0; i < count; ++i) z[done + i] += ready_[used_ + i];
    done += count;
    used_ += count;
  }
}

double ShapedNoise::density(double phi) const {
  units::require_positive("wavenumber", phi, "cycle/m");
  units::require_between("wavenumber", phi, 0.0, 0.5 / spacing_, "cycle/m");
  const double turn = 2.0 * units::pi * phi * spacing_;
  const std::size_t middle = taps_.size() / 2;
  double gain = taps_[middle];
  for (std::size_t lag = 1; lag <= middle; ++lag)
    gain += 2.0 * taps_[middle + lag] * std::cos(turn * static_cast<double>(lag));
  const double s = std::sin(0.5 * turn);
  const double lost = 1.0 - leak_;
  return 2.0 * spacing_ * gain * gain / (lost * lost + 4.0 * leak_ * s * s);
}

}  // namespace railbook::spectra
