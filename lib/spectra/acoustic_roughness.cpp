#include <railbook/spectra/acoustic_roughness.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

constexpr std::array preferred{1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0};

// Of the band around 10^k/10 cycles a metre.
double nominal_wavelength(int k) {
  const int mantissa = ((-k % 10) + 10) % 10;
  const int exponent = (-k - mantissa) / 10;
  const double value = preferred[static_cast<std::size_t>(mantissa)];
  return exponent < 0 ? value / std::pow(10, -exponent) : value * std::pow(10, exponent);
}

constexpr double spike_curvature = -10;  // 1/m
constexpr double foot_slope = 5e-3;
constexpr double spike_length = 3;  // m: a peak of width w is one where it is over w^2 over this

// A spike at a sample, up to its feet; empty where there is none.
struct Spike {
  std::size_t from = 0, to = 0;
};

Spike spike_at(std::span<const double> z, std::size_t i, double spacing) {
  const double bend = (z[i - 1] - 2 * z[i] + z[i + 1]) / (spacing * spacing);
  if (!(bend < spike_curvature) || !(z[i] >= z[i - 1] && z[i] >= z[i + 1])) return {};
  const auto slope = [&](std::size_t k) { return std::abs(z[k + 1] - z[k - 1]) / (2 * spacing); };
  Spike spike{i - 1, i + 1};
  while (spike.from > 0 && slope(spike.from) >= foot_slope) --spike.from;
  while (spike.to + 1 < z.size() && slope(spike.to) >= foot_slope) ++spike.to;
  const double width = static_cast<double>(spike.to - spike.from) * spacing;
  const double part =
      static_cast<double>(i - spike.from) / static_cast<double>(spike.to - spike.from);
  const double height = z[i] - z[spike.from] - part * (z[spike.to] - z[spike.from]);
  return height > width * width / spike_length ? spike : Spike{};  // false for NaN
}

}  // namespace

double ThirdOctave::level() const {
  return 10 * std::log10(mean_square / (units::micrometre * units::micrometre));
}

double ThirdOctave::level_error() const {
  return 10 / std::log(10.0) * relative_error;
}

std::vector<ThirdOctave> third_octaves(const Spectrum& spectrum) {
  std::vector<ThirdOctave> bands;
  const double segment = 1 / spectrum.df;
  const auto highest = spectrum.density.size() - 1;
  const double spacing = segment / static_cast<double>(2 * highest);
  const double half = std::pow(10, 0.05);
  for (int k = static_cast<int>(std::floor(-10 * std::log10(segment))); k < 100; ++k) {
    ThirdOctave band{.wavelength = nominal_wavelength(k)};
    // To rounding: 1 m and 0.25 m, 1 mm and 3.15 mm.
    if (band.wavelength > 0.25 * segment * (1 + 1e-6)) continue;
    if (band.wavelength < 3 * spacing * (1 - 1e-6)) break;
    band.low = std::pow(10, k / 10.0) / half;
    band.high = std::pow(10, k / 10.0) * half;
    double bins = 0;
    const auto begin = static_cast<Eigen::Index>(band.low / spectrum.df);
    for (Eigen::Index i = begin; i <= highest; ++i) {
      const double from = std::max(band.low, (static_cast<double>(i) - 0.5) * spectrum.df);
      const double to = std::min(band.high, (static_cast<double>(i) + 0.5) * spectrum.df);
      if (from >= band.high) break;
      if (to <= from) continue;
      band.mean_square += spectrum.density[i] * (to - from);
      bins += (to - from) / spectrum.df;
    }
    // A mean of few bins has at least the degrees of freedom of one.
    band.relative_error =
        std::sqrt(std::min(spectrum.band_variance / bins, 1 / std::max(1.0, spectrum.averages)));
    bands.push_back(band);
  }
  return bands;
}

double roughness_limit(double wavelength) {
  constexpr std::array levels{17.1,  17.1,  17.1,  17.1,  17.1,  17.1,  17.1,  17.1, 15.0,
                              13.0,  11.0,  9.0,   7.0,   4.9,   2.9,   0.9,   -1.1, -3.2,
                              -5.0,  -5.6,  -6.2,  -6.8,  -7.4,  -8.0,  -8.6,  -9.2, -9.8,
                              -10.4, -11.0, -11.6, -12.2, -12.8, -13.4, -14.0, -14.0};
  const double k = std::round(10 * std::log10(2 / wavelength));
  return k < 0 || k >= static_cast<double>(levels.size()) ? units::nan
                                                          : levels[static_cast<std::size_t>(k)];
}

std::size_t remove_spikes(std::span<double> heights, double spacing) {
  units::require_positive("spacing", spacing, "m");
  std::size_t replaced = 0, before = 0;
  do {
    before = replaced;
    for (std::size_t i = 1; i + 1 < heights.size(); ++i) {
      const Spike spike = spike_at(heights, i, spacing);
      if (spike.to == 0) continue;
      const double first = heights[spike.from];
      const double step = (heights[spike.to] - first) / static_cast<double>(spike.to - spike.from);
      for (std::size_t k = spike.from + 1; k < spike.to; ++k)
        heights[k] = first + step * static_cast<double>(k - spike.from);
      replaced += spike.to - spike.from - 1;
    }
  } while (replaced > before);
  return replaced;
}

std::vector<double> under_wheel(std::span<const double> heights, double spacing, double radius) {
  units::require_positive("spacing", spacing, "m");
  units::require_positive("radius of the wheel", radius, "m");
  std::vector<double> raised{heights.begin(), heights.end()};
  double low = units::infinity, high = -units::infinity;
  for (const double z : heights)
    if (std::isfinite(z)) {
      low = std::min(low, z);
      high = std::max(high, z);
    }
  // Beyond that, the wheel is above all of the record.
  const double range = std::clamp(high - low, 0.0, radius);
  const auto reach = static_cast<std::size_t>(std::sqrt(range * (2 * radius - range)) / spacing);
  std::vector<double> rise(reach + 1);
  for (std::size_t k = 1; k <= reach; ++k) {
    const double s = static_cast<double>(k) * spacing;
    rise[k] = s * s / (radius + std::sqrt(radius * radius - s * s));
  }
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!std::isfinite(heights[i])) continue;
    for (std::size_t k = 1; k <= reach; ++k) {
      if (i >= k) raised[i] = std::fmax(raised[i], heights[i - k] - rise[k]);
      if (i + k < heights.size()) raised[i] = std::fmax(raised[i], heights[i + k] - rise[k]);
    }
  }
  return raised;
}

}  // namespace railbook::spectra
