/***
The 62-ft chord with the high-pass, from short offsets. The input is synthetic track, rounded to whole units of $2^{-34}$ m, so that the exact answer is known in integers: the reference has
no error but one rounding. The error is the largest difference over the RMS of the answer. All methods get the same array and return another; making weights and plans is counted.

* **weights**: all 661, vectorised.
* **transforms**: of overlapping blocks of 8192, what a signal library takes for a filter of this length.
* **sums**: two running sums of 31 samples and four of 151, one after the other, started anew every 4096 samples.
* **stream**: the class of the library, which gives the space curve besides, and masks what is missing.

{{cost-length}}

{{length-answer}} The direct weights take {{weights-over-sums}} the operations of the sums and are vectorised. Every method is accurate enough for any track, so cost is what decides, and what the stream can do besides.

**How long may a filter run?** Sums that are never started anew keep every rounding. The same samples over and over, with the exact answer known, for a filter in floating point that never restarts:

{{cost-drift}}

{{drift-answer}} The input is in whole units, so a double adds it without error until a sum
passes $2^{53}$ of them; where the integrators do, their curve leaves that of the sums. In 64-bit integers there is no error at any length ({{outcome:cost-drift/integers}}). This is why the library starts its sums anew, and why nothing in it integrates along the track.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "bench/timing.hpp"
#include "bench/work_precision.hpp"
#include "sections.hpp"
#include "study/composite.hpp"

namespace railbook::filters_chapter {
namespace {

double rms(const std::vector<double>& x) {
  double square = 0;
  for (const double v : x) square += v * v;
  return std::sqrt(square / static_cast<double>(x.size()));
}

// One record, and what the filter must make of it.
struct Sample {
  std::vector<double> x, exact;
};

bench::Method method(const char* name, double operations, const std::map<int, Sample>& samples,
                     const Composite& filter) {
  std::vector<int> lengths;
  for (const auto& [n, sample] : samples) lengths.push_back(n);
  return bench::sweep(name, lengths,
                      [&samples, operations, filter](int n) -> bench::Outcome {
                        const Sample& s = samples.at(n);
                        const auto chord = filter(s.x);
                        double worst = 0;
                        for (std::size_t i = 0; i < chord.size(); ++i)
                          worst = std::max(worst, std::abs(chord[i] - s.exact.at(i)));
                        // One plus the error, against a reference of one.
                        return {{1 + worst / rms(s.exact)}, operations * n, true, ""};
                      })
      .counts("operations");
}

// Operations a sample, one addition or multiplication each.
constexpr double weights_cost = 2.0 * composite_window, sums_cost = 14;
const double transforms_cost = 2 * 2.5 * 13 * 8192 / (8192 - 660.0);

void cost_length(report::Item& item) {
  std::map<int, Sample> samples;
  for (const int n : {1000, 10'000, 100'000, 1'000'000}) {
    if (n > 100'000 && !item.full()) continue;
    const auto units = composite_input(static_cast<std::size_t>(n));
    samples[n] = {in_metres(units), exact_composite(units)};
  }
  const auto points = bench::measure("cost-length", {{"chord", 1, 0}},
                                     {method("weights", weights_cost, samples, by_weights),
                                      method("transforms", transforms_cost, samples, by_transforms),
                                      method("sums", sums_cost, samples, by_sums),
                                      method("stream", 2 * sums_cost, samples, by_stream)},
                                     item.timings(), item.full() ? 0.5 : 0.05);
  auto& data = item.data({"samples", "method", "operations", "ns", "q1_ns", "q3_ns", "error"});
  data.not_compared("times, and rounding");
  std::string said;
  for (const report::WorkPrecision& p : points) {
    const double n = std::stod(p.setting), ns = 1e9 / n;
    data.add(n, p.method, p.work / n, ns * p.seconds_median, ns * p.seconds_q1, ns * p.seconds_q3,
             p.error);
    if (std::stoi(p.setting) != samples.rbegin()->first) continue;
    said += fmt::format("{}{} {:.1f}", said.empty() ? "" : ", ", p.method, ns * p.seconds_median);
  }
  item.add(points);
  item.value("length-answer",
             item.timings() ? fmt::format("At {:.0e} samples a sample takes, in nanoseconds: {}.",
                                          static_cast<double>(samples.rbegin()->first), said)
                            : "(Not timed.)");
  item.value("weights-over-sums", weights_cost / sums_cost, "times", "{:.0f}");
  item.expect_checks(1);
  double worst = 0;
  for (const auto& p : points) worst = std::max(worst, p.error);
  item.at_most("as-double", "largest error of any method over the RMS", "", worst, 3e-12,
               "six running sums of at most 4096 roundings each");
  item.added("not in the paper");
}

void cost_drift(report::Item& item) {
  const auto period = composite_input(32768);
  const double scale = rms(exact_composite(period));
  std::vector<std::size_t> counts;
  for (std::size_t n = 100'000; n <= (item.full() ? 1'000'000'000u : 10'000'000u); n *= 10)
    counts.insert(counts.end(), {n, 3 * n});
  auto& data = item.data({"samples", "method", "error"});
  data.holds_to("error", 0.5, 0, "drift of rounding errors");
  std::string said;
  const auto run = [&](const char* name, const std::vector<double>& errors) {
    for (std::size_t i = 0; i < counts.size(); ++i)
      data.add(static_cast<double>(counts[i]), name, errors[i] / scale);
    data.gap();
    const auto lost =
        std::find_if(errors.begin(), errors.end(), [&](double e) { return !(e < 1e-3 * scale); });
    said += said.empty() ? "A thousandth of the RMS is lost " : ", ";
    said += lost == errors.end()
                ? fmt::format("by {} not within {:.0e} samples", name,
                              static_cast<double>(counts.back()))
                : fmt::format(
                      "by {} within {:.0e}", name,
                      static_cast<double>(counts[static_cast<std::size_t>(lost - errors.begin())]));
  };
  run("sums in single precision", drift<float>(Endless::sums, period, counts));
  run("sums in double precision", drift<double>(Endless::sums, period, counts));
  run("integrators in single precision", drift<float>(Endless::integrators, period, counts));
  run("integrators in double precision", drift<double>(Endless::integrators, period, counts));
  item.value("drift-answer", said + ".");
  const auto integers = drift<std::uint64_t>(Endless::integrators, period, counts);
  item.expect_checks(1);
  item.at_most("integers", "error of integrators in 64-bit integers, m", "m",
               *std::max_element(integers.begin(), integers.end()), 1e-18,
               "wrapping integers are exact: nothing but the last rounding to metres");
  item.added("not in the paper");
}

}  // namespace

/*** {{include: composite.cpp}} */
const report::Section cost{
    report::figure("cost-length", "Time a sample and error against the length of the record",
                   cost_length),
    report::figure("cost-drift", "Error of filters that never start anew", cost_drift)};

}  // namespace railbook::filters_chapter
