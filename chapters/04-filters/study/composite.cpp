/*** The same filter in several ways; the number type is a parameter where it matters: */
#include "study/composite.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "filters/chord_filter.hpp"
#include "filters/geometry_chain.hpp"
#include "num/fft.hpp"
#include "spectra/synthetic_track.hpp"

namespace railbook::filters_chapter {
namespace {

using Word = std::uint64_t;
constexpr std::size_t reach = composite_window / 2;
constexpr int N = 31, M = 151, passes = 4;
constexpr auto centre = static_cast<std::size_t>(passes) * (M / 2);
const double M_power = std::pow(M, passes);

// Numerators of the weights over 2 M^p: the space curve's, and its chord.
std::vector<Word> integers() {
  const auto curve = filters::space_curve_integers({M, passes, 1});
  std::vector<Word> taps(composite_window);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const auto c = static_cast<Word>(curve[i]);
    taps[i + N] += 2 * c;
    taps[i] -= c;
    taps[i + N + N] -= c;
  }
  return taps;
}

std::vector<double> weights() {
  std::vector<double> taps;
  for (const Word w : integers())
    taps.push_back(static_cast<double>(static_cast<std::int64_t>(w)) / (2 * M_power));
  return taps;
}

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

std::vector<double> exact_composite(const std::vector<std::int64_t>& x) {
  const auto taps = integers();
  std::vector<Word> sums(x.size() - composite_window + 1);
  for (std::size_t j = 0; j < composite_window; ++j)
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += taps[j] * static_cast<Word>(x[i + j]);
  std::vector<double> out(sums.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] =
        static_cast<double>(static_cast<std::int64_t>(sums[i])) * composite_unit / (2 * M_power);
  return out;
}

// A block of outputs stays in the cache while all weights pass over it; the inner loop is vectorised.
std::vector<double> by_weights(const std::vector<double>& x) {
  constexpr std::size_t block = 1024;
  const auto taps = weights();
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

std::vector<double> by_transforms(const std::vector<double>& x) {
  num::RealFft fft{8192};
  const auto taps = weights();
  const auto real = fft.real();
  std::copy(taps.begin(), taps.end(), real.begin());  // symmetric: no need to reverse them
  fft.forward();
  std::vector<std::complex<double>> gain(fft.spectrum().begin(), fft.spectrum().end());
  for (auto& g : gain) g /= static_cast<double>(fft.size());
  std::vector<double> out(x.size() - taps.size() + 1);
  const std::size_t block = fft.size() - taps.size() + 1;
  for (std::size_t begin = 0; begin < out.size(); begin += block) {
    const std::size_t given = std::min(fft.size(), x.size() - begin);
    std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(begin), given, real.begin());
    std::fill(real.begin() + static_cast<std::ptrdiff_t>(given), real.end(), 0.0);
    fft.forward();
    for (std::size_t k = 0; k < gain.size(); ++k) fft.spectrum()[k] *= gain[k];
    fft.inverse();
    std::copy_n(real.begin() + static_cast<std::ptrdiff_t>(taps.size() - 1),
                std::min(block, out.size() - begin),
                out.begin() + static_cast<std::ptrdiff_t>(begin));
  }
  return out;
}

// Chord first, high-pass then: every running sum has a single pole.
std::vector<double> by_sums(const std::vector<double>& x) {
  const auto once = filters::running_sum<double>(x, N);
  const auto chord = filters::running_sum<double>(once, N);
  std::vector<double> mean = chord;
  for (int pass = 0; pass < passes; ++pass) mean = filters::running_sum<double>(mean, M);
  std::vector<double> out(mean.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = chord[i + centre] - mean[i] / M_power;
  return out;
}

std::vector<double> by_stream(const std::vector<double>& x) {
  const auto chord = filters::geometry(x).chord;
  return {chord.begin() + reach, chord.end() - reach};
}

namespace {

// What went in `length` pushes ago, and the sum since.
template <class Number>
struct Window {
  std::vector<Number> ring;
  std::size_t at = 0;
  Number sum{};
  explicit Window(std::size_t length) : ring(length) {}
  Number push(Number x) {
    const Number old = ring[at];
    sum += x - old;
    ring[at] = x;
    at = at + 1 == ring.size() ? 0 : at + 1;
    return old;
  }
};

template <class Number>
double metres(Number value, double over) {  // the numerator, of either kind
  if constexpr (std::is_integral_v<Number>)
    return static_cast<double>(static_cast<std::int64_t>(value)) * composite_unit / over;
  else
    return static_cast<double>(value) * composite_unit / over;
}

// The numerator over 2 M^p of the newest output.
template <class Number>
class EndlessFilter {
 public:
  explicit EndlessFilter(Endless way) : way_(way) {}
  Number push(Number x) {
    constexpr auto scale = static_cast<Number>(M) * M * M * M;
    Number chord;  // twice the 62-ft one
    if (way_ == Endless::sums) {
      first_.push(x);
      second_.push(first_.sum);
      chord = second_.sum + second_.sum;
    } else {
      slope_ -= x + x;
      height_ += slope_;
      const Number middle = half_.push(height_), end = other_half_.push(middle);
      chord = middle + middle - height_ - end;
    }
    Number sum = chord;
    for (Window<Number>& mean : means_) {
      mean.push(sum);
      sum = mean.sum;
    }
    return centre_.push(chord) * scale - sum;
  }

 private:
  Endless way_;
  Number slope_{}, height_{};
  Window<Number> first_{N}, second_{N}, half_{N}, other_half_{N}, centre_{centre};
  std::array<Window<Number>, passes> means_{Window<Number>{M}, Window<Number>{M}, Window<Number>{M},
                                            Window<Number>{M}};
};

}  // namespace

template <class Number>
std::vector<double> drift(Endless way, const std::vector<std::int64_t>& period,
                          const std::vector<std::size_t>& counts) {
  auto twice = period;  // the answer repeats as the input does
  twice.insert(twice.end(), period.begin(), period.end());
  const auto exact = exact_composite(twice);
  EndlessFilter<Number> filter{way};
  std::vector<double> errors;
  std::size_t at = 0;
  for (const std::size_t count : counts) {
    double largest = 0;
    for (; at < count; ++at) {
      const Number out = filter.push(static_cast<Number>(period[at % period.size()]));
      if (at < 2 * period.size()) continue;  // the window fills
      const double right = exact[(at + 1 - composite_window) % period.size()];
      largest = std::max(largest, std::abs(metres(out, 2 * M_power) - right));
    }
    errors.push_back(largest);
  }
  return errors;
}
template std::vector<double> drift<float>(Endless, const std::vector<std::int64_t>&,
                                          const std::vector<std::size_t>&);
template std::vector<double> drift<double>(Endless, const std::vector<std::int64_t>&,
                                           const std::vector<std::size_t>&);
template std::vector<double> drift<Word>(Endless, const std::vector<std::int64_t>&,
                                         const std::vector<std::size_t>&);

}  // namespace railbook::filters_chapter
