/*** ### As a stream

A year of the paper's fleet is {{stream-year}} samples a channel, so records are not held in memory. The stream takes short offsets in pieces of any size and
gives the space curve and the 62-ft chord, high-passed, one of each a sample. A block of {{stream-block}} samples and the {{stream-history}} around it is integrated twice (the
straight line that is free in it is invisible to the high-pass), then summed four times, all in one loop and two halves of the block at
once, so that the processor never waits for a sum; every block starts anew, so that no rounding gets from one to the next. A missing sample counts as zero and its window, {{stream-window}} samples,
is marked NaN in the chord; before and after it the results are those of an undisturbed record.

{{streaming}}

The baseline is the plain high-pass of {{stream-taps}} weights, one output per input, vectorised and blocked for the cache, which is half of the
job. {{stream-verdict}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "composite.hpp"
#include "filters/geometry_chain.hpp"
#include "items.hpp"
#include "num/stopwatch.hpp"
#include "units/constants.hpp"

namespace railbook::filters_chapter {
namespace {

struct Streamed {
  double seconds = 0;
  std::size_t samples = 0, memory = 0;
  double last = 0;  // a chord offset from the end of the record
};

// A record of n samples, the same piece of track over and over.
Streamed stream(const std::vector<double>& piece, std::size_t n) {
  Streamed result;
  filters::GeometryChain chain{{}, [&](std::span<const double>, std::span<const double> chord) {
                                 result.samples += chord.size();
                                 for (std::size_t i = chord.size(); i-- > 0;)
                                   if (!std::isnan(chord[i])) {
                                     result.last = chord[i];
                                     break;
                                   }
                               }};
  const num::Stopwatch watch;
  for (std::size_t done = 0; done < n; done += piece.size())
    chain.push(std::span{piece}.first(std::min(piece.size(), n - done)));
  chain.finish();
  result.seconds = watch.seconds();
  result.memory = chain.memory();
  return result;
}

// Output samples a second of the baseline.
double baseline_rate(const std::vector<double>& x, const std::vector<double>& taps) {
  double best = 1e300;
  std::size_t outputs = 0;
  for (int i = 0; i < 3; ++i) {
    const num::Stopwatch watch;
    outputs = fir(x, taps).size();
    best = std::min(best, watch.seconds());
  }
  return static_cast<double>(outputs) / best;
}

void say(report::Item& item) {
  const filters::GeometryChain chain{{}, [](auto, auto) {}};
  item.value("stream-year", 70000 * units::mile / units::foot, "", "{:.3g}");
  item.value("stream-block", static_cast<double>(filters::GeometryChainOptions{}.block), "",
             "{:.0f}");
  item.value("stream-history", static_cast<double>(2 * chain.reach()), "", "{:.0f}");
  item.value("stream-history-half", static_cast<double>(chain.reach()), "", "{:.0f}");
  item.value("stream-window", static_cast<double>(2 * chain.reach() + 1), "", "{:.0f}");
  item.value("stream-taps", static_cast<double>(filters::high_pass_taps({}).size()), "", "{:.0f}");
}

void streaming(report::Item& item) {
  const std::vector<double> piece = in_metres(composite_input(65536));
  const auto taps = filters::high_pass_taps({});
  std::vector<std::size_t> lengths{100'000, 1'000'000};
  if (item.timings() || item.full()) lengths.insert(lengths.end(), {10'000'000, 100'000'000});
  item.expect_checks(static_cast<int>(2 * lengths.size()));
  item.columns({"samples", "million samples a second", "times the FIR baseline", "memory, kB"});
  const double baseline = item.timings() ? baseline_rate(piece, taps) : 0;
  const auto timed = [&](double value) {
    return item.timings() ? fmt::format("{:.1f}", value) : std::string{"-"};
  };
  if (item.timings()) item.add_row({"601-tap FIR", timed(baseline / 1e6), timed(1), "-"});
  const std::vector<double> weights = composite_taps();
  double rate = 0;
  for (const std::size_t n : lengths) {
    const std::string label = fmt::format("{:.0e}", static_cast<double>(n));
    const Streamed run = stream(piece, n);
    // The last chord offset again, by its weights.
    double direct = 0;
    for (std::size_t j = 0; j < weights.size(); ++j)
      direct += weights[j] * piece[(n - weights.size() + j) % piece.size()];
    item.agree("last-" + label, "last offset of " + label + " samples", "m", run.last, direct, 1e-7,
               "the 661 weights; the offset may be small against the RMS");
    item.check("memory-" + label, "memory of the stream, " + label + " samples", "kB", "512",
               static_cast<double>(run.memory) / 1e3,
               report::at_most("does not depend on the length"));
    rate = static_cast<double>(run.samples) / run.seconds;
    item.add_row({label, timed(rate / 1e6), timed(item.timings() ? rate / baseline : 0),
                  fmt::format("{:.0f}", static_cast<double>(run.memory) / 1e3)});
  }
  std::string verdict = "Rates were not measured in this run.";
  if (item.timings())
    verdict = fmt::format(
        "In this run the stream made {:.0f} million samples a second, {:.0f} times "
        "the rate of the baseline.",
        rate / 1e6, rate / baseline);
  item.value("stream-verdict", verdict);
  say(item);
  item.reconstructed("a benchmark of ours, not in the paper");
}

}  // namespace

void add_streaming(report::Chapter& chapter) {
  chapter.table("streaming", "Rate and memory of the stream", streaming);
}

}  // namespace railbook::filters_chapter
