#include <railbook/filters/wavelength_band.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include <railbook/filters/detail/cubic.hpp>
#include <railbook/num/fft.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/number_text.hpp>
#include <railbook/units/quantity.hpp>

namespace railbook::filters {

Band parse_band(std::string_view quantity, std::string_view text) {
  const auto* const named = std::ranges::find(bands, text, &Band::name);
  if (named != bands.end()) return *named;
  const std::size_t dash = text.find('-', 1);
  Band band;
  if (dash != std::string_view::npos) {
    band.shortest = units::parse_quantity(quantity, text.substr(0, dash), units::length);
    band.longest = units::parse_quantity(quantity, text.substr(dash + 1), units::length);
  }
  if (!(band.shortest > 0 && band.longest >= 1.1 * band.shortest))
    throw InputError{std::string{quantity} + ": \"" + std::string{text} +
                     "\"; allowed: D0, D1, D2, D3, or two wavelengths as in 3m-35m, the longer at "
                     "least 1.1 times as long"};
  return band;
}

double band_gain(const Band& band, int passes, double phi) {
  if (!(phi > 0)) return 0;
  const double low = 1 / band.longest, high = 1 / band.shortest;
  const double x = (phi * phi - low * high) / (phi * (high - low));
  const double squared = 1 / (1 + std::pow(x, 8));
  return passes == 2 ? squared : std::sqrt(squared);
}

// A pole p of the low-pass becomes those with s^2 - width p s + centre^2 = 0; of the four pairs the
// two next to the imaginary axis, at 5/8 pi, decay slowest.
double band_decay(const Band& band) {
  const double low = 2 * units::pi / band.longest, high = 2 * units::pi / band.shortest;
  const std::complex<double> middle = 0.5 * (high - low) * std::polar(1.0, 0.625 * units::pi);
  const std::complex<double> apart = std::sqrt(middle * middle - low * high);
  return 1 / std::min(std::abs((middle + apart).real()), std::abs((middle - apart).real()));
}

FilterTaps symmetric_taps(const Band& band, double spacing,
                          const std::function<double(double phi)>& gain) {
  // The slowest pole of the lower edge decays by e in some 0.42 of its wavelength, longer in a
  // narrow band; twenty such. Tapered weights are eight times as far off in the band and more; well
  // beyond it those that just end are up to three times as far.
  const double narrow = std::max(1.0, 1 / (band.longest / band.shortest - 1));
  const double reach = units::require_between("reach of the band over the spacing",
                                              8 * band.longest * narrow / spacing, 8, 1e6);
  const auto taps = static_cast<std::size_t>(reach);
  num::RealFft fft{16 * std::bit_ceil(taps)};
  const auto n = static_cast<double>(fft.size());
  for (std::size_t k = 0; k < fft.spectrum().size(); ++k)
    fft.spectrum()[k] = gain(static_cast<double>(k) / (n * spacing)) / n;
  fft.inverse();
  FilterTaps result{spacing, {}};
  result.half.assign(fft.real().begin(),
                     fft.real().begin() + static_cast<std::ptrdiff_t>(taps + 1));
  double sum = -result.half[0];
  for (const double weight : result.half) sum += 2 * weight;
  for (double& weight : result.half) weight -= sum / static_cast<double>(2 * taps + 1);
  return result;
}

FilterTaps band_taps(const Band& band, int passes, double spacing) {
  units::require_positive("spacing", spacing, "m");
  if (!(band.shortest >= 2 * spacing))
    throw InputError{"shortest wavelength of the band is " + units::number_text(band.shortest) +
                     " m; allowed: at least " + units::number_text(2 * spacing) +
                     " m, the samples being " + units::number_text(spacing) + " m apart"};
  return symmetric_taps(band, spacing, [&](double phi) { return band_gain(band, passes, phi); });
}

std::size_t band_margin(const Band& band, double spacing) {
  return static_cast<std::size_t>(
      std::ceil(band.longest / units::require_positive("spacing", spacing, "m")));
}

FilterTaps chord_taps(double chord, double spacing) {
  units::require_positive("spacing", spacing, "m");
  const double half =
      units::require_between("chord over twice the spacing", 0.5 * chord / spacing, 2, 1e6);
  const auto at = static_cast<std::size_t>(std::floor(half));
  FilterTaps result{spacing, std::vector<double>(std::max<std::size_t>(at + 3, 9))};
  const auto end = detail::cubic(half - std::floor(half));
  for (std::size_t j = 0; j < end.size(); ++j) result.half[at - 1 + j] -= 0.5 * end[j];
  result.half[0] += 1;
  return result;
}

FilterTaps uniformity_taps(double chord, double spacing) {
  const FilterTaps one = chord_taps(chord, spacing);
  const double quarter = 0.25 * chord / spacing;
  const auto reach = static_cast<std::ptrdiff_t>(one.half.size()) - 1;
  const auto far = static_cast<std::ptrdiff_t>(std::floor(4 * quarter)) + 2;
  FilterTaps result{spacing, std::vector<double>(static_cast<std::size_t>(reach + far + 1))};
  std::copy(one.half.begin(), one.half.end(), result.half.begin());
  for (int m = -4; m <= 4; ++m) {
    const double place = m * quarter, whole = std::floor(place);
    const auto weights = detail::cubic(place - whole);
    for (std::ptrdiff_t i = -reach; i <= reach; ++i)
      for (std::size_t j = 0; j < weights.size(); ++j) {
        const std::ptrdiff_t to =
            i + static_cast<std::ptrdiff_t>(whole) - 1 + static_cast<std::ptrdiff_t>(j);
        if (to >= 0)
          result.half[static_cast<std::size_t>(to)] -=
              weights[j] * one.half[static_cast<std::size_t>(std::abs(i))] / 9;
      }
  }
  return result;
}

}  // namespace railbook::filters
