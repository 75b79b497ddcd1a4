/***
### Which way of making the long chord should I take?

The task is the 62-ft chord with the high-pass, from short offsets. The input is synthetic track,
rounded to whole units of $2^{-34}$ m, so that the exact answer can be computed in integers: the
reference has no error but one rounding at the end. It uses the same weights as the first two
methods and shares nothing with the others. The error is the largest difference divided by the RMS
of the exact answer. All methods get the same array and return a new one. The time includes what a
method prepares: its weights, and the tables of a transform.

* **weights**: each output is a sum of all 661 weighted samples; the processor adds several at once
  (vectorised).
* **transforms**: Fourier transforms of overlapping blocks of 8192 samples, as signal libraries do
  it for a filter of this length.
* **sums**: two running sums of 31 samples and four of 151, one after the other, started anew every
  4096 samples.
* **stream**: the class `GeometryChain` of this project's library. It sums as above in blocks of
  4096, gives the space curve first (the path of the rail without its long waves) and makes the
  chord of it, which costs digits, and leaves out what is missing.

{{cost-length}}

{{length-answer}} A busy machine makes such times uncertain, as their quartiles show; differences
below a factor of three mean little. The number of operations a sample is the same on any machine:
{{operations-answer}}. The worst error found is {{rounding-found}}
({{outcome:cost-length/as-double}}), far below what a sensor resolves, so that accuracy does not
decide. Between **sums** and **stream** the times do not decide either. Take the **stream** where
samples are missing or the space curve is wanted too, and otherwise either.

{{work-precision: cost-length}}

### How long may a running sum run?

Sums that are never started anew keep every rounding. Here the same samples come over and over, with
the exact answer known, through a filter that never restarts. It is made either of six running sums
alone, or with two *integrators* ahead of them, which add up all samples since the start, as a plain
double integration of an acceleration does:

{{cost-drift}}

{{drift-answer}} The input is in whole units, so that a double adds it without error until a sum
passes $2^{53}$ of them; where the integrators do, their curve leaves that of the sums. In 64-bit
integers there is no error at any length {{outcome:cost-drift/integers}}. So do not integrate along
the track in single precision. In double precision the sums are good for any record tried, the
integrators stay exact only while their sums are below $2^{53}$ units; input that is not in whole units rounds
from the first sample, and was not tried. A filter that is to run for ever should start its sums
anew, as the library's do.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <railbook/bench/work_precision.hpp>
#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/geometry_chain.hpp>
#include <railbook/num/fft.hpp>
#include <railbook/spectra/synthetic_track.hpp>

#include "experiment.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {
namespace {

using Word = std::uint64_t;
constexpr double whole = 0x1p-34;  // m, of the input
constexpr int N = 31, M = 151, passes = 4;
constexpr std::size_t window = 661, reach = window / 2, centre = std::size_t{passes} * (M / 2);
const double M_power = std::pow(M, passes);

// Short offsets of synthetic track in whole units.
std::vector<std::int64_t> input(std::size_t n) {
  const spectra::SyntheticTrack track{.seed = 62, .A = 5e-7, .phi_c = 0.13, .dip = 5.5e-3};
  const auto offsets = spectra::mid_chord_offsets(spectra::synthesize(track, n + 2), 1, 2).offset;
  std::vector<std::int64_t> units(n);
  for (std::size_t i = 0; i < n; ++i) units[i] = std::llround(offsets[i] / whole);
  return units;
}

// Numerators of the weights over 2 M^p: the space curve's, and its chord.
std::vector<Word> integers() {
  const auto curve = filters::space_curve_integers({M, passes, 1});
  std::vector<Word> taps(window);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const auto c = static_cast<Word>(curve[i]);
    taps[i + N] += 2 * c;
    taps[i] -= c;
    taps[i + N + N] -= c;
  }
  return taps;
}

// A numerator, of either kind, in metres.
template <class Number>
double metres(Number value) {
  if constexpr (std::is_integral_v<Number>)
    return static_cast<double>(static_cast<std::int64_t>(value)) * whole / (2 * M_power);
  else
    return static_cast<double>(value) * whole / (2 * M_power);
}

// The n - 660 outputs that have their whole window, m: exact in integers that wrap, rounded once at
// the end.
std::vector<double> exact_composite(const std::vector<std::int64_t>& x) {
  const auto taps = integers();
  std::vector<Word> sums(x.size() - window + 1);
  for (std::size_t j = 0; j < window; ++j)
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += taps[j] * static_cast<Word>(x[i + j]);
  std::vector<double> out(sums.size());
  std::ranges::transform(sums, out.begin(), metres<Word>);
  return out;
}

using Values = std::vector<double>;

Values weights() {
  Values taps;
  for (const Word w : integers()) taps.push_back(metres(w) / whole);
  return taps;
}

// A block of outputs stays in the cache while all weights pass over it; the inner loop is
// vectorised.
Values by_weights(const Values& x) {
  const auto taps = weights();
  Values out(x.size() - window + 1);
  for (std::size_t begin = 0; begin < out.size(); begin += 1024) {
    const std::size_t end = std::min(begin + 1024, out.size());
    for (std::size_t j = 0; j < window; ++j)
      for (std::size_t i = begin; i < end; ++i) out[i] += taps[j] * x[i + j];
  }
  return out;
}

Values by_transforms(const Values& x) {
  num::RealFft fft{8192};
  const auto taps = weights();
  const auto real = fft.real();
  std::copy(taps.begin(), taps.end(), real.begin());  // symmetric: no need to reverse them
  fft.forward();
  std::vector<std::complex<double>> gain(fft.spectrum().begin(), fft.spectrum().end());
  for (auto& g : gain) g /= static_cast<double>(fft.size());
  Values out(x.size() - window + 1);
  const std::size_t step = fft.size() - window + 1;
  for (std::size_t begin = 0; begin < out.size(); begin += step) {
    const auto part = std::span{x}.subspan(begin).first(std::min(fft.size(), x.size() - begin));
    std::ranges::fill(std::ranges::copy(part, real.begin()).out, real.end(), 0.0);
    fft.forward();
    for (std::size_t k = 0; k < gain.size(); ++k) fft.spectrum()[k] *= gain[k];
    fft.inverse();
    for (std::size_t i = begin; i < std::min(begin + step, out.size()); ++i)
      out[i] = real[i - begin + window - 1];
  }
  return out;
}

// Chord first, high-pass then: every running sum has a single pole.
Values by_sums(const Values& x) {
  const auto chord = filters::running_sum<double>(filters::running_sum<double>(x, N), N);
  Values mean = chord;
  for (int pass = 0; pass < passes; ++pass) mean = filters::running_sum<double>(mean, M);
  Values out(mean.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = chord[i + centre] - mean[i] / M_power;
  return out;
}

Values by_stream(const Values& x) {
  const auto chord = filters::geometry(x).chord;
  return {chord.begin() + reach, chord.end() - reach};
}

// 30000000 -> "30 000 000", with thin spaces.
std::string thousands(std::size_t n) {
  std::string digits = std::to_string(n), out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += "\u2009";
    out += digits[i];
  }
  return out;
}

// One record, and what the filter must make of it.
struct Sample {
  Values x, exact;
};

bench::Method method(const char* name, double operations, const std::map<int, Sample>& samples,
                     Values (*filter)(const Values&)) {
  std::vector<int> lengths;
  lengths.reserve(samples.size());
  for (const auto& [n, sample] : samples) lengths.push_back(n);
  return bench::sweep(name, lengths,
                      [&samples, operations, filter](int n) -> bench::Outcome {
                        const Sample& s = samples.at(n);
                        const auto chord = filter(s.x);
                        double worst = 0;
                        for (std::size_t i = 0; i < chord.size(); ++i)
                          worst = std::max(worst, std::abs(chord[i] - s.exact.at(i)));
                        // One plus the error, against a reference of one.
                        return {{1 + worst / rms(s.exact)}, std::round(operations * n), true, ""};
                      })
      .labelled("{} samples")
      .counts("operations");
}

// Operations a sample, one addition or multiplication each.
constexpr double weights_cost = 2.0 * window, sums_cost = 14;
const double transforms_cost = 2 * 2.5 * 13 * 8192 / (8192 - 660.0);

void cost_length(report::Item& item) {
  std::map<int, Sample> samples;
  for (const int n : {1000, 10'000, 100'000, 1'000'000}) {
    if (n > 100'000 && !item.full()) continue;
    const auto units = input(static_cast<std::size_t>(n));
    samples[n].exact = exact_composite(units);
    for (const auto u : units) samples[n].x.push_back(static_cast<double>(u) * whole);
  }
  const auto points = bench::measure("cost-length", {{"chord", 1, 0}},
                                     {method("weights", weights_cost, samples, by_weights),
                                      method("transforms", transforms_cost, samples, by_transforms),
                                      method("sums", sums_cost, samples, by_sums),
                                      method("stream", 2 * sums_cost, samples, by_stream)},
                                     item.timings(), item.full() ? 0.5 : 0.05);
  auto& data = item.data({"samples", "method", "operations", "ns", "q1_ns", "q3_ns", "error"});
  data.not_compared("times, and rounding");
  const int longest = samples.rbegin()->first;
  std::string times;
  double worst = 0;
  for (const report::WorkPrecision& p : points) {
    const double n = std::stod(p.setting), ns = 1e9 / n;
    data.add(n, p.method, p.work / n, ns * p.seconds_median, ns * p.seconds_q1, ns * p.seconds_q3,
             p.error);
    worst = std::max(worst, p.error);
    if (std::stoi(p.setting) != longest) continue;
    times += fmt::format("{}{} {:.1f}", times.empty() ? "" : ", ", p.method, ns * p.seconds_median);
  }
  item.add(points);
  item.value("length-answer",
             item.timings()
                 ? fmt::format("In a record of {} samples each takes, in nanoseconds a sample: {}.",
                               thousands(static_cast<std::size_t>(longest)), times)
                 : "(They were not timed.)");
  item.value("operations-answer",
             fmt::format("sums {:.0f}, stream {:.0f}, transforms {:.0f}, weights {:.0f}", sums_cost,
                         2 * sums_cost, transforms_cost, weights_cost));
  item.expect_checks(1);
  item.at_most("as-double", "largest error of any method over the RMS", "", worst, 1e-9,
               "a billionth of the RMS, which no sensor resolves");
  item.value("rounding-found", report::below(worst));
  item.added("not in the paper");
}

// A sum over the last `length` samples.
template <class Number>
struct Window {
  std::vector<Number> ring;
  std::size_t at = 0;
  Number sum{}, old{};  // what went in `length` samples ago
  explicit Window(std::size_t length) : ring(length) {}
  Number push(Number x) {
    old = std::exchange(ring[at], x);
    if (++at == ring.size()) at = 0;
    return sum += x - old;
  }
};

// How the filter may run on for ever: six running sums, or two integrators ahead of them.
enum class Endless { sums, integrators };

// The numerator over 2 M^p of the newest output.
template <class Number>
struct EndlessFilter {
  Endless way;
  Number slope{}, height{};
  Window<Number> first{N}, second{N}, delay{centre};
  std::array<Window<Number>, passes> means{Window<Number>{M}, Window<Number>{M}, Window<Number>{M},
                                           Window<Number>{M}};

  Number push(Number x) {
    Number chord;  // twice the 62-ft one
    if (way == Endless::sums) {
      chord = 2 * second.push(first.push(x));
    } else {
      height += slope -= 2 * x;
      first.push(height), second.push(first.old);
      chord = 2 * first.old - height - second.old;
    }
    Number sum = chord;
    for (Window<Number>& mean : means) sum = mean.push(sum);
    delay.push(chord);
    return delay.old * static_cast<Number>(M) * M * M * M - sum;
  }
};

// The largest error, m, among the samples from one count to the next of `counts` (ascending), fed
// with `period` over and over.
template <class Number>
Values drift(Endless way, const std::vector<std::int64_t>& period,
             const std::vector<std::size_t>& counts) {
  auto twice = period;  // the answer repeats as the input does
  twice.insert(twice.end(), period.begin(), period.end());
  const auto exact = exact_composite(twice);
  EndlessFilter<Number> filter{.way = way};
  Values errors;
  std::size_t at = 0, in = 0;
  for (const std::size_t count : counts) {
    double largest = 0;
    for (; at < count; ++at, in = in + 1 == period.size() ? 0 : in + 1) {
      const Number out = filter.push(static_cast<Number>(period[in]));
      if (at < 2 * period.size()) continue;  // the window fills
      const double right =
          exact[in + 1 >= window ? in + 1 - window : in + 1 - window + period.size()];
      largest = std::max(largest, std::abs(metres(out) - right));
    }
    errors.push_back(largest);
  }
  return errors;
}

void cost_drift(report::Item& item) {
  const auto period = input(32768);
  const double scale = rms(exact_composite(period));
  std::vector<std::size_t> counts;
  const std::size_t most = item.full() ? 1'000'000'000 : 30'000'000;
  for (std::size_t n = 100'000; n <= most; n *= 10)
    for (const std::size_t count : {n, 3 * n})
      if (count <= most) counts.push_back(count);
  auto& data = item.data({"samples", "method", "error"});
  data.holds_to("error", 0.5, 0, "drift of rounding errors");
  std::string kept_by, lost_by;
  const auto run = [&](const char* name, const Values& errors) {
    for (std::size_t i = 0; i < counts.size(); ++i)
      data.add(static_cast<double>(counts[i]), name, errors[i] / scale);
    data.gap();
    const auto lost = std::ranges::find_if(errors, [&](double e) { return !(e < 1e-3 * scale); });
    const bool kept = lost == errors.end();
    const auto at = kept ? counts.size() - 1 : static_cast<std::size_t>(lost - errors.begin());
    (kept ? kept_by : lost_by) +=
        fmt::format("{}{}{}", (kept ? kept_by : lost_by).empty() ? "" : ", ", name,
                    kept ? "" : fmt::format(" (within {} samples)", thousands(counts[at])));
  };
  run("sums in single precision", drift<float>(Endless::sums, period, counts));
  run("sums in double precision", drift<double>(Endless::sums, period, counts));
  run("integrators in single precision", drift<float>(Endless::integrators, period, counts));
  run("integrators in double precision", drift<double>(Endless::integrators, period, counts));
  item.value("drift-answer",
             fmt::format("An error of a thousandth of the RMS is reached by {}. It is not reached "
                         "within {} samples by {}.",
                         lost_by, thousands(counts.back()), kept_by));
  const auto integers = drift<Word>(Endless::integrators, period, counts);
  item.expect_checks(1);
  item.at_most("integers", "error of integrators in 64-bit integers", "m",
               std::ranges::max(integers), 1e-18,
               "wrapping integers are exact: nothing but the last rounding to metres");
  item.added("not in the paper");
}

}  // namespace

const report::Section cost{report::figure("cost-length", cost_length),
                           report::figure("cost-drift", cost_drift)};

}  // namespace railbook::filters_chapter
