/*** ## From the short chord to any chord

Filtered as above, the acceleration becomes a *short* mid-chord offset: the height of a rail above the middle of a chord of two
samples, $m_k=z_k-\frac12(z_{k-1}+z_{k+1})$. The law wants a chord of {{chord-samples}} samples. A chord of $2N$ samples reads $1-\cos N\theta$ of a
sine of $\theta$ radians a sample, and

$$\frac{1-\cos N\theta}{1-\cos\theta}=\left(\frac{\sin N\theta/2}{\sin\theta/2}\right)^2$$

is a polynomial: the response of $N$ equal weights, twice. So the long offset is the sum of the short ones around it with the integer weights
$N-|j|$, exactly: {{chord-taps}} weights for the 62-ft chord, or two running sums one after the other, at a cost that does not
depend on $N$. Nothing is approximated and nothing filtered away. The gain at DC is $N^2$ ({{chord-dc}}), and white noise on the short
offsets comes out {{chord-noise}} times larger, a factor $\sqrt{N(2N^2+1)/3}$.

{{chords}}

The table drives a sampled sine through the filters: its short offsets, and the running sums. The gains of a 62-ft chord agree with the
formula to the last digits. That it does not see waves of 31 ft and 15.5 ft, and sees one of 62 ft twice, is the chord's own nature and no
fault of the filter.
*/
#include "filters/chord_filter.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "items.hpp"
#include "spectra/random_source.hpp"
#include "units/constants.hpp"

namespace railbook::filters_chapter {
namespace {

// The gain of the 62-ft chord on a sine of `wavelength` samples, by way of short offsets and running sums.
double driven_gain(double wavelength, int half) {
  const double theta = 2 * units::pi / wavelength;
  std::vector<double> z(static_cast<std::size_t>(2 * half + 1));
  for (std::size_t k = 0; k < z.size(); ++k)
    z[k] = std::cos(theta * (static_cast<double>(k) - half));
  const auto offsets = spectra::mid_chord_offsets(z, 1, 2).offset;
  return filters::to_chord_running(offsets, half).offset.at(0);  // at the crest, where z is 1
}

// Standard deviation of the long offsets of white noise of unit variance.
double noise_gain(int half, std::size_t samples) {
  const spectra::RandomSource random{62, 1};
  std::vector<double> noise(samples);
  for (std::size_t k = 0; k < samples; ++k) noise[k] = random.normal(k);
  double square = 0;
  const auto offsets = filters::to_chord_running(noise, half).offset;
  for (const double m : offsets) square += m * m;
  return std::sqrt(square / static_cast<double>(offsets.size()));
}

void chords(report::Item& item) {
  const auto gains = item.printed("chord-gains.csv");
  const auto constants = item.printed("chord-constants.csv");
  item.expect_checks(static_cast<int>(2 * gains.rows.size() + constants.rows.size()) + 1);
  item.columns({"wavelength, ft", "1-ft half chord", "62-ft chord, formula", "driven by a sine"});
  const double half_exact = 0.5 * 62 * units::foot / (1 * units::foot);
  const int half = static_cast<int>(std::lround(half_exact));
  for (const auto& cells : gains.rows) {
    const std::string& key = cells.at(0);
    const double wavelength = report::printed_number(key);
    const double theta = 2 * units::pi / wavelength;
    const double short_gain = spectra::chord_gain(2, 1 / wavelength);
    const double formula = short_gain * filters::short_to_long_gain(half, theta);
    const double driven = driven_gain(wavelength, half);
    item.row(gains, key).check("gain", formula, derived(gains.at(key, "gain")));
    item.check("driven-" + key, "the same, driven", "", gains.at(key, "gain"), driven,
               derived(gains.at(key, "gain")));
    item.add_row({key, fmt::format("{:.5f}", short_gain), fmt::format("{:.5f}", formula),
                  fmt::format("{:.5f}", driven)});
  }
  double sum = 0;
  const auto taps = filters::chord_taps(half);
  for (const auto tap : taps) sum += static_cast<double>(tap);
  item.row(constants, "half-chord")
      .check("value", half_exact, derived(constants.at("half-chord", "value")));
  item.row(constants, "taps")
      .check("value", static_cast<double>(taps.size()), derived(constants.at("taps", "value")));
  item.row(constants, "sum").check("value", sum, derived(constants.at("sum", "value")));
  item.row(constants, "noise")
      .check("value", filters::chord_noise_gain(half), derived(constants.at("noise", "value")));
  item.agree("noise-driven", "noise gain, white noise through running sums", "",
             noise_gain(half, item.full() ? 8'000'000 : 1'000'000), filters::chord_noise_gain(half),
             0.02, "the formula; the record is a sample");
  item.value("chord-samples", 2 * half_exact, "", "{:.0f}");
  item.value("chord-taps", static_cast<double>(taps.size()), "", "{:.0f}");
  item.value("chord-dc", sum, "", "{:.0f}");
  item.value("chord-noise", filters::chord_noise_gain(half), "", "{:.2f}");
}

}  // namespace

void add_chords(report::Chapter& chapter) {
  chapter.table("chords", "Gain of the 62-ft chord made of short ones", chords);
}

}  // namespace railbook::filters_chapter
