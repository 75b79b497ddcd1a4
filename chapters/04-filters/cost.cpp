/***
## Error against run time

The 62-ft chord with the high-pass, from short offsets, on a record of {{cost-samples}} samples: synthetic track, rounded to whole units of $2^{-34}$ m
so that the exact answer is known in integers. The error is the largest difference over the RMS of the answer.

* **FIR**: all {{cost-taps}} weights, vectorised.
* **FFT**: blocks in the frequency domain (overlap-save), for several block lengths.
* **running sums**: two of 31 samples and four of 151, one after the other, started anew after so many samples, or never.
* **recursive**: two integrators that run through the whole record and four running sums, none ever restarted.
* **stream**: the class below, which gives the space curve besides, for several blocks.

{{cost-time}}

{{work-precision}}

In double precision everything is accurate enough; what differs is the cost, and the FIR takes {{cost-fir-over-stream}} the operations of
the stream. The FFT takes several times the operations of running sums, but does them so well that on whole arrays it is about as
fast; what it cannot do is stay exact on integers, where sums have no error at all (and so do not appear in the figure). Single
precision is good for running sums, as it is for FIR; recursively it fails within this record.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/work_precision.hpp"
#include "composite.hpp"
#include "items.hpp"

namespace railbook::filters {
namespace {

// One plus the error, against a reference of one.
bench::Outcome outcome(const std::vector<double>& chord, const std::vector<double>& exact,
                       double work) {
  double worst = 0, square = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    worst = std::max(worst, std::abs(chord.at(i) - exact[i]));
    square += exact[i] * exact[i];
  }
  const double rms = std::sqrt(square / static_cast<double>(exact.size()));
  return {.values = {1 + worst / rms}, .work = work, .converged = true, .reason = ""};
}

void cost(report::Item& item) {
  const std::size_t n = item.full() ? 1'000'000 : 100'000;
  const std::vector<std::int64_t> units = composite_input(n);
  const std::vector<double> x = in_metres(units);
  const std::vector<float> x_float(x.begin(), x.end());
  const std::vector<std::uint64_t> words(units.begin(), units.end());
  const std::vector<double> exact = exact_composite(units);
  const auto samples = static_cast<double>(n);
  const auto setting = [&](std::string label, double operations,
                           std::function<std::vector<double>()> run) {
    return bench::Setting{std::move(label),
                          [&exact, run = std::move(run), work = operations * samples] {
                            return outcome(run(), exact, work);
                          }};
  };
  const double fir = 2 * 661, sums = 12, recursive = 12;
  std::vector<bench::Method> methods{
      {"FIR double", {setting("661 weights", fir, [&] { return fir_composite<double>(x); })}},
      {"FIR float", {setting("661 weights", fir, [&] { return fir_composite<float>(x_float); })}},
      {"FFT", {}},
      {"running sums double", {}},
      {"running sums float", {}},
      {"running sums int64",
       {setting("never", sums, [&] { return sums_composite<std::uint64_t>(words, 0); })}},
      {"recursive double",
       {setting("never", recursive, [&] { return recursive_composite<double>(x); })}},
      {"recursive float",
       {setting("never", recursive, [&] { return recursive_composite<float>(x_float); })}},
      {"recursive int64",
       {setting("never", recursive, [&] { return recursive_composite<std::uint64_t>(words); })}},
      {"stream", {}}};
  for (const std::size_t size : {2048, 8192, 32768}) {
    const auto m = static_cast<double>(size);
    methods[2].settings.push_back(setting(fmt::format("blocks of {}", size),
                                          5 * m * std::log2(m) / (m - 660),
                                          [&x, size] { return fft_composite(x, size); }));
  }
  for (const std::size_t restart : {256, 4096, 0}) {
    const std::string label = restart == 0 ? "never" : fmt::format("every {}", restart);
    const double again = restart == 0 ? 0 : 666 / static_cast<double>(restart);
    methods[3].settings.push_back(
        setting(label, sums + again, [&x, restart] { return sums_composite<double>(x, restart); }));
    methods[4].settings.push_back(setting(label, sums + again, [&x_float, restart] {
      return sums_composite<float>(x_float, restart);
    }));
  }
  for (const std::size_t block : {512, 4096, 32768})
    methods[9].settings.push_back(setting(fmt::format("blocks of {}", block),
                                          14 * (1 + 1320 / static_cast<double>(block)),
                                          [&x, block] { return stream_composite(x, block); }));
  const auto points =
      bench::measure("cost", {{"chord", 1, 0}}, methods, item.timings(), item.full() ? 0.5 : 0.05);
  bench::show(item, points, "chord");
  item.value("cost-samples", samples, "", "{:.0e}");
  item.value("cost-taps", 661, "", "{:.0f}");
  item.value("cost-fir-over-stream", fir / (14 * (1 + 1320.0 / 4096)), "times", "{:.0f}");
  item.reconstructed("not in the paper");
}

}  // namespace

/***
{{include: composite.cpp}}
*/
void add_cost(report::Chapter& chapter) {
  chapter.figure("cost-time", "Error of the composite filter against run time and operations",
                 cost);
}

}  // namespace railbook::filters
