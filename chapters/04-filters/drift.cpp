/*** ## Sums that do not drift

Two running sums of 31 make the 62-ft chord out of short ones, at four additions a sample. How they are written decides whether they
last. As one recursion, $y_k=2y_{k-1}-y_{k-2}+\dots$, the filter has a double pole at one, and so has its rounding: each error
is integrated twice, and grows with the power {{drift-power}} of the distance. As two sums one after the other, each with one pole, the error is a random
walk. Started anew every few thousand samples, it does not grow at all; and in 64-bit integers there is none, since sums that wrap are exact as long as the
result fits.

The input is white noise, rounded to $2^{-50}$ so that the integers get the same numbers and know the exact answer. The signal
has an RMS of {{drift-rms}}; a year of the paper's fleet, 70 000 miles, is {{drift-year}} samples a channel.

{{drift}}

In single precision the recursion has lost all its digits within {{drift-float-distance}} miles of track. In double precision its error is
{{drift-double}} after {{drift-longest}} samples, and {{drift-ratio}} times that of the two sums; there is no reason to take it. An integrator is useful all the same: the stream below integrates twice, but within a block of
{{drift-block}} samples, and the next block knows nothing of it.
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "filters/chord_filter.hpp"
#include "filters/geometry_chain.hpp"
#include "items.hpp"
#include "spectra/random_source.hpp"
#include "units/constants.hpp"

namespace railbook::filters_chapter {
namespace {

constexpr std::size_t N = 31;
using Word = std::uint64_t;

// The last 64 samples, by their number; what came before the record is 0.
template <class Number>
struct Ring {
  std::array<Number, 64> x{};
  Number& operator[](std::size_t k) { return x[k % 64]; }
};

// Sum of N, in one addition and one subtraction; starts anew every `restart` samples.
template <class Number>
struct RunningSum {
  Ring<Number> past;
  Number sum{};
  std::size_t restart = 0;
  Number push(std::size_t k, Number x) {
    const Number leaving = past[k - N];
    past[k] = x;
    if (restart != 0 && k % restart == 0) {
      sum = Number{};
      for (std::size_t j = 0; j < N; ++j) sum += past[k - j];
    } else {
      sum += x - leaving;
    }
    return sum;
  }
};

template <class Number>
struct Cascade {
  RunningSum<Number> first, second;
  explicit Cascade(std::size_t restart) { first.restart = second.restart = restart; }
  Number push(std::size_t k, Number x) { return second.push(k, first.push(k, x)); }
};

// The same filter with its double pole in one place: the slope and the value are both carried on for ever.
template <class Number>
struct DoublePole {
  Ring<Number> past;
  Number slope{}, value{};
  Number push(std::size_t k, Number x) {
    slope += x - (past[k - N] + past[k - N]) + past[k - 2 * N];
    past[k] = x;
    return value += slope;
  }
};

constexpr double unit = 0x1p50;

// All of them side by side on one record; errors are the largest of the last 1000 samples before a milestone.
struct Race {
  DoublePole<float> pole_float;
  DoublePole<double> pole_double;
  DoublePole<Word> pole_integer;
  Cascade<float> sums_float{0}, restarted_float{4096};
  Cascade<double> sums_double{0}, restarted_double{4096};
  Cascade<Word> exact{0};
  std::array<double, 7> worst{};
  double square = 0;

  void push(std::size_t k, double x, bool count) {
    const auto q = static_cast<std::int64_t>(x);
    const double y =
        static_cast<double>(static_cast<std::int64_t>(exact.push(k, static_cast<Word>(q)))) / unit;
    const double v = x / unit;
    const auto f = static_cast<float>(v);
    const Word integer = pole_integer.push(k, static_cast<Word>(q));
    const std::array<double, 7> got{pole_float.push(k, f),
                                    pole_double.push(k, v),
                                    static_cast<double>(static_cast<std::int64_t>(integer)) / unit,
                                    sums_float.push(k, f),
                                    restarted_float.push(k, f),
                                    sums_double.push(k, v),
                                    restarted_double.push(k, v)};
    square += y * y;
    if (!count) return;
    for (std::size_t i = 0; i < got.size(); ++i)
      worst[i] = std::max(worst[i], std::abs(got[i] - y));
  }
};

// What was found after the longest run, and how the error of the recursion in float grew to it.
struct Outcome {
  double start = 0, samples = 0, rms = 0;
  std::array<double, 7> first{}, last{};  // in the order of Race::worst
  double power() const { return std::log(last[0] / first[0]) / std::log(samples / start); }
};

void check(report::Item& item, const Outcome& o) {
  item.expect_checks(5);
  item.check("exact", "recursion in int64, largest error", "", "1e-300", o.last[2],
             report::at_most("integers are exact"));
  item.check("power", "growth of the recursion in float", "", "1.5", o.power(),
             report::absolute(0.5, "a twice integrated random walk, one realisation"));
  item.check("sums", "two sums in double after the longest run, over the RMS", "", "1e-11",
             o.last[5] / o.rms, report::at_most("a random walk of roundings"));
  item.check("restarted", "restarted sums in double, over the RMS", "", "1e-14", o.last[6] / o.rms,
             report::at_most("at most 4096 roundings each, two sums"));
  item.agree("rms", "RMS of the output", "", o.rms, filters::chord_noise_gain(N), 0.02,
             "the noise gain; the record is a sample");
  const std::array<const char*, 7> names{"double pole in float",         "double pole in double",
                                         "double pole in int64",         "two sums in float",
                                         "two sums in float, restarted", "two sums in double",
                                         "two sums in double, restarted"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double e = o.last[i] / o.rms;
    item.stability(fmt::format("drift-{}", i), names[i], fmt::format("{:.0e} samples", o.samples),
                   fmt::format("off by {:.0e} on an RMS of {:.0f}", o.last[i], o.rms), e,
                   e > 1      ? "fails"
                   : e > 1e-9 ? "degraded"
                              : "holds");
  }
}

void say(report::Item& item, const Outcome& o) {
  item.value("drift-power", o.power(), "", "{:.1f}");
  item.value("drift-rms", o.rms, "", "{:.0f}");
  item.value("drift-year", 70000 * units::mile / units::foot, "", "{:.3g}");
  // Where the error reaches the signal, by the power 3/2.
  const double reached = o.start * std::pow(o.rms / o.first[0], 1 / 1.5);
  item.value("drift-float-distance", reached * units::foot / units::mile, "", "{:.0f}");
  item.value("drift-double", o.last[1], "", "{:.0e}");
  item.value("drift-longest", o.samples, "", "{:.0e}");
  item.value("drift-ratio", o.last[1] / o.last[5], "", "{:.0e}");
  item.value("drift-block", static_cast<double>(filters::GeometryChainOptions{}.block), "",
             "{:.0f}");
}

void drift(report::Item& item) {
  std::vector<std::size_t> milestones{100'000, 1'000'000, 10'000'000};
  if (item.full()) milestones.push_back(100'000'000);
  item.columns({"samples", "recursion float", "recursion double", "recursion int64",
                "two sums float", "restarted float", "two sums double", "restarted double"});
  const spectra::RandomSource random{1981, 1};
  Race race;
  Outcome outcome;
  std::size_t k = 64;  // numbers from 64 on, so that a ring can look back
  for (const std::size_t milestone : milestones) {
    race.worst = {};
    for (; k < milestone + 64; ++k)
      race.push(k, std::nearbyint(unit * random.normal(k)), k >= milestone + 64 - 1000);
    std::vector<std::string> row{fmt::format("{:.0e}", static_cast<double>(milestone))};
    for (const double e : race.worst) row.push_back(e == 0 ? "0" : fmt::format("{:.1e}", e));
    item.add_row(row);
    if (milestone == milestones.front()) outcome.first = race.worst;
  }
  outcome.start = static_cast<double>(milestones.front());
  outcome.samples = static_cast<double>(milestones.back());
  outcome.rms = std::sqrt(race.square / outcome.samples);
  outcome.last = race.worst;
  check(item, outcome);
  say(item, outcome);
  item.reconstructed("an experiment of ours, not in the paper");
}

}  // namespace

void add_drift(report::Chapter& chapter) {
  chapter.table("drift",
                "Largest error of the 62-ft chord after so many samples, signal of unit noise",
                drift);
}

}  // namespace railbook::filters_chapter
