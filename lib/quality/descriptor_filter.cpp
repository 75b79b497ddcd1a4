#include <railbook/quality/descriptor_filter.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>

#include <railbook/num/fft.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::quality {
namespace {

// The longest wavelength at which the envelope bends.
double longest(const Descriptor& d) {
  double wave = 0;
  if (d.stroke) wave = d.speed / d.stroke->suspension.frequency;
  if (d.force) wave = std::max(wave, d.speed / suspension(d.force->car).frequency);
  return wave;
}

void judge(filters::FilterTaps& taps, const Envelope& envelope, double shortest) {
  num::RealFft fft{16 * std::bit_ceil(taps.half.size())};  // 16 points and more a ripple
  const auto got = filters::symmetric_gains(taps.half, fft);
  const double step = 1 / (static_cast<double>(fft.size()) * taps.spacing);
  const double lowest = 1 / (static_cast<double>(taps.half.size()) * taps.spacing);
  for (std::size_t k = 1; k < got.size(); ++k) {
    const double phi = static_cast<double>(k) * step;
    if (phi < lowest || (shortest > 0 && phi * shortest > 0.8)) continue;
    const double wanted = envelope(phi);
    const double error = wanted > 0 ? std::abs(got[k] / wanted - 1) : 0;
    if (error <= taps.gain_error) continue;
    taps.gain_error = error;
    taps.worst_at = 1 / phi;
  }
}

}  // namespace

double filter_gain(const Envelope& envelope, double shortest, double phi) {
  const double u = phi * shortest;
  if (u <= 0.8) return envelope(phi);
  if (u >= 1) return 0;
  const double c = std::cos(0.5 * units::pi * (u - 0.8) / 0.2);
  return c * c * envelope(phi);
}

std::vector<double> impulse_response(const Envelope& envelope, double spacing, double shortest,
                                     std::size_t samples) {
  units::require_positive("spacing", spacing, "m");
  num::RealFft fft{samples};
  const auto n = static_cast<double>(samples);
  for (std::size_t k = 0; k < fft.spectrum().size(); ++k)
    fft.spectrum()[k] = filter_gain(envelope, shortest, static_cast<double>(k) / (n * spacing)) / n;
  fft.inverse();
  return {fft.real().begin(), fft.real().begin() + static_cast<std::ptrdiff_t>(samples / 2 + 1)};
}

filters::FilterTaps design_filter(const Envelope& envelope, const FilterDesign& design) {
  units::require_positive("spacing", design.spacing, "m");
  if (design.shortest != 0)
    units::require_between("shortest wavelength", design.shortest, 2 * design.spacing,
                           units::infinity, "m");
  const double reach = design.reach > 0 ? design.reach : 20 * longest(envelope.descriptor());
  const double samples = units::require_between("reach of the filter over the spacing",
                                                reach / design.spacing, 8, 1e6);
  const auto taps = static_cast<std::size_t>(samples);
  const auto h =
      impulse_response(envelope, design.spacing, design.shortest, 16 * std::bit_ceil(taps));
  filters::FilterTaps result{design.spacing, std::vector<double>(taps + 1)};
  double sum = 0, weight = 0;
  std::vector<double> taper(taps + 1);
  for (std::size_t j = 0; j <= taps; ++j) {
    const double u = static_cast<double>(j) / static_cast<double>(taps + 1);
    const double c = u <= 0.5 ? 1 : std::cos(units::pi * (u - 0.5));
    taper[j] = c * c;
    result.half[j] = taper[j] * h[j];
    sum += (j == 0 ? 1 : 2) * result.half[j];
    weight += (j == 0 ? 1 : 2) * taper[j];
  }
  for (std::size_t j = 0; j <= taps; ++j) result.half[j] -= taper[j] * sum / weight;
  judge(result, envelope, design.shortest);
  return result;
}

double end_effect(const filters::FilterTaps& taps, const Envelope& envelope, double share) {
  const double top = longest(envelope.descriptor());
  constexpr int waves = 24;
  std::size_t reach = 0;
  for (int i = 0; i < waves; ++i) {
    const double wave = top * std::pow(4 * taps.spacing / top, i / (waves - 1.0));
    const double turn = 2 * units::pi * taps.spacing / wave;
    const double twice = 2 * allowed_amplitude(envelope(1 / wave));
    std::complex<double> beyond = 0;  // of the weights at this distance and more
    for (std::size_t j = taps.half.size(); j-- > reach;) {
      beyond += taps.half[j] * std::polar(1.0, turn * static_cast<double>(j));
      if (twice * std::abs(beyond) > share) reach = j + 1;
    }
  }
  return static_cast<double>(reach) * taps.spacing;
}

std::vector<double> filter_periodic(const Envelope& envelope, double spacing,
                                    std::span<const double> record) {
  units::require_positive("spacing", spacing, "m");
  units::require_between("samples", static_cast<double>(record.size()), 2, 1e9);
  num::RealFft fft{record.size()};
  std::copy(record.begin(), record.end(), fft.real().begin());
  fft.forward();
  const auto n = static_cast<double>(record.size());
  for (std::size_t k = 0; k < fft.spectrum().size(); ++k)
    fft.spectrum()[k] *= envelope(static_cast<double>(k) / (n * spacing)) / n;
  fft.inverse();
  return {fft.real().begin(), fft.real().end()};
}

}  // namespace railbook::quality
