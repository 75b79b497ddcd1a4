/***
The 62-ft chord with the high-pass, from short offsets, on a record of {{cost-samples}} samples: synthetic track, rounded to whole units of $2^{-34}$ m
so that the exact answer is known in integers. The error is the largest difference over the RMS of the answer.

* **FIR**: all 661 weights, vectorised.
* **running sums**: two of 31 samples and four of 151, one after the other, started anew after so many samples, or never.
* **recursive**: two integrators that run through the whole record and four running sums, none ever restarted.
* **stream**: the class of the library, which gives the space curve besides, for several blocks.

{{cost-time}}

In double precision everything is accurate enough; what differs is the cost, and the FIR takes {{cost-fir-over-stream}} the operations of
the stream. Single precision is good for running sums; recursively it fails within this record.
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
#include "sections.hpp"
#include "study/composite.hpp"

namespace railbook::filters_chapter {
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

// One record in every number type, and what the filter must make of it.
struct Record {
  std::vector<double> x;
  std::vector<float> x_float;
  std::vector<double> exact;
};
Record record(std::size_t n) {
  const auto units = composite_input(n);
  const auto x = in_metres(units);
  return {x, {x.begin(), x.end()}, exact_composite(units)};
}

constexpr double fir_operations = 2 * 661, sum_operations = 12;  // a sample
double stream_operations(std::size_t block) {
  return 14 * (1 + 1320 / static_cast<double>(block));
}

std::vector<bench::Method> methods(const Record& r) {
  const auto setting = [&r](std::string label, double operations,
                            std::function<std::vector<double>()> run) {
    const double work = operations * static_cast<double>(r.x.size());
    return bench::Setting{std::move(label), [&r, run = std::move(run), work] {
                            return outcome(run(), r.exact, work);
                          }};
  };
  bench::Method sums{"running sums double", {}}, sums_float{"running sums float", {}},
      stream{"stream", {}};
  for (const std::size_t restart : {256u, 4096u, 0u}) {
    const std::string label = restart == 0 ? "never" : fmt::format("every {}", restart);
    const double work = sum_operations + (restart == 0 ? 0 : 666 / static_cast<double>(restart));
    sums.settings.push_back(
        setting(label, work, [&r, restart] { return sums_composite<double>(r.x, restart); }));
    sums_float.settings.push_back(
        setting(label, work, [&r, restart] { return sums_composite<float>(r.x_float, restart); }));
  }
  for (const std::size_t block : {512u, 4096u, 32768u})
    stream.settings.push_back(setting(fmt::format("blocks of {}", block), stream_operations(block),
                                      [&r, block] { return stream_composite(r.x, block); }));
  const auto only = [&](const char* label, double work, std::function<std::vector<double>()> run) {
    return std::vector<bench::Setting>{setting(label, work, std::move(run))};
  };
  return {{"FIR double", only("661 weights", fir_operations, [&r] { return fir_composite(r.x); })},
          sums,
          sums_float,
          {"recursive float",
           only("never", sum_operations, [&r] { return recursive_composite(r.x_float); })},
          stream};
}

void cost_time(report::Item& item) {
  const Record r = record(item.full() ? 1'000'000 : 100'000);
  const auto points = bench::measure("cost-time", {{"chord", 1, 0}}, methods(r), item.timings(),
                                     item.full() ? 0.5 : 0.05);
  bench::show(item, points, "chord");
  item.value("cost-samples", static_cast<double>(r.x.size()), "", "{:.0e}");
  item.value("cost-fir-over-stream", fir_operations / stream_operations(4096), "times", "{:.0f}");
  item.added("not in the paper");
}

}  // namespace

/*** {{include: composite.cpp}} */
const report::Section cost{report::figure(
    "cost-time", "Error of the composite filter against run time and operations", cost_time)};

}  // namespace railbook::filters_chapter
