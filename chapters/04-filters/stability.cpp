/***
## Stability

What a car does to its filters: it stops, it reverses, its encoder counts twice, a plug comes loose. Each row puts one of these into a filter and
compares with the exact answer. *Holds*: right to rounding, or to the figure in the row. *Refused*: NaN or an error message, and
right again as soon as the window is clear. *Degraded*: wrong by the amount given, as theory says. *Fails*: wrong without a word; such
rows are ways of writing the filter that this chapter does not take.

{{stability}}

A filter that keeps no memory beyond two samples has little to go wrong: after a stop of an hour it is right at the second sample. What remains at
the lower end is rounding, amplified by $1/\kappa$ in $C$ and $1/\kappa^2$ in $G$, and so is the step of the converter: that, not the
arithmetic, forbids a very low corner.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "configuration.hpp"
#include "filters/chord_filter.hpp"
#include "filters/complementary.hpp"
#include "filters/geometry_chain.hpp"
#include "filters/hybrid_filter.hpp"
#include "items.hpp"
#include "num/quadrature.hpp"
#include "spectra/random_source.hpp"
#include "units/input_error.hpp"

namespace railbook::filters_chapter {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double corner = acceleration_corner;

// Both analog filters on the ramp x = t, with a transient from `begin` on that the digital ones have to take out.
double analog_ramp(double t, double begin, int order) {
  return t - order / corner +
         (0.5 + (order == 2 ? 3 * (t - begin) : 0)) * std::exp(-corner * (t - begin));
}

// Error of the last C (order 1) or G (order 2) over the last interval, on the ramp sampled at these times.
double ramp_error(const std::vector<double>& times, int order) {
  filters::FirstOrderHybrid c{corner};
  filters::SecondOrderHybrid g{{corner, 1}};
  double u = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double T = k == 0 ? 1 : times[k] - times[k - 1],
                 y = analog_ramp(times[k], times[0], order);
    u = order == 1 ? c.push(y, T) : g.push(y, T).mean;
  }
  const double t0 = times[times.size() - 3], t1 = times[times.size() - 2], t2 = times.back();
  if (order == 1)
    return std::abs(u - (t2 - (t2 - t1) * filters::centroid_delay(corner * (t2 - t1)))) / (t2 - t1);
  const auto weight = [&](double t) {
    const double e = std::exp(-corner * (t2 - t));
    return t > t1 ? (t2 - t) * e : e * (t2 - t1) / (t1 - t0) * (t - t0);
  };
  double mean = 0, area = 0;
  for (const auto& [a, b] : {std::pair{t0, t1}, {t1, t2}}) {
    const double from = std::max(a, b - 60 / corner);  // before that the weight is nothing
    mean += num::integrate([&](double t) { return weight(t) * (t - t1); }, from, b, 1e-13).value;
    area += num::integrate(weight, from, b, 1e-13).value;
  }
  return std::abs(u - t1 - mean / area) / (t2 - t0);
}

void intervals(report::Item& item) {
  struct Case {
    const char *id, *what, *stress;
    double before, after;
  };
  const double foot_80 = sample_distance / (80 * units::mph);
  const std::vector<Case> cases{
      {"steady", "80 mph", "none", foot_80, foot_80},
      {"fast", "T → 0", "T = 1 µs, 680 000 mph", 1e-6, 1e-6},
      {"jump", "speed changes", "T 1000 times longer than the one before", 1e-3, 1},
      {"drop", "speed changes", "T 1000 times shorter", 1, 1e-3},
      {"stop", "T → ∞", "an hour between two samples", 0.1, 3600},
      {"start", "T → ∞", "an hour, then 0.1 s", 3600, 0.1}};
  for (const Case& c : cases)
    for (const int order : {1, 2}) {
      const double e = ramp_error({-c.before - c.after, -c.after, 0}, order);
      // Rounding of the samples, amplified by the last interval's share of the filter's memory.
      const double rounding = 1e3 * std::numeric_limits<double>::epsilon() /
                              std::pow(std::min(1.0, corner * c.after), order + 1);
      item.stability(fmt::format("{}-{}", c.id, order),
                     fmt::format("{}: {}", order == 1 ? "C" : "G", c.what), c.stress,
                     fmt::format("mean of a ramp off by {:.0e} of the interval", e), e,
                     e < 1e-9       ? "holds"
                     : e < rounding ? "degraded"
                                    : "fails");
    }
}

// Outputs of a filter on a sine with something done to sample 20; NaN count, and error against the undisturbed run
// where both are numbers.
struct Disturbed {
  int missing = 0;
  double error = 0;
};
template <class Push>
Disturbed disturbed(const Push& make, const std::function<void(double&, double&)>& harm,
                    bool extra) {
  auto clean = make(), bad = make();
  Disturbed result;
  for (int k = 0; k < 60; ++k) {
    double y = std::sin(0.2 * k), T = 0.03;
    if (k == 20 && extra) (void)bad(5.0, 0.0);  // a pulse that should not be
    if (k == 20) harm(y, T);
    const double a = clean(std::sin(0.2 * k), 0.03), b = bad(y, T);
    if (std::isnan(a)) continue;
    if (std::isnan(b))
      ++result.missing;
    else
      result.error = std::max(result.error, std::abs(a - b));
  }
  return result;
}

void faults(report::Item& item) {
  const auto make_c = [] {
    return [c = filters::FirstOrderHybrid{corner}](double y, double T) mutable {
      return c.push(y, T);
    };
  };
  const auto make_g = [] {
    return [g = filters::SecondOrderHybrid{{corner, 1}}](double y, double T) mutable {
      return g.push(y, T).mean;
    };
  };
  struct Case {
    const char *id, *what;
    std::function<void(double&, double&)> harm;
    bool extra;
  };
  const std::vector<Case> cases{
      {"nan", "a sample is NaN", [](double& y, double&) { y = none; }, false},
      {"backwards", "T negative: the clock wrapped", [](double&, double& T) { T = -1; }, false},
      {"unknown", "T is NaN", [](double&, double& T) { T = none; }, false},
      {"twice", "T = 0: the encoder counts twice", [](double&, double&) {}, true}};
  for (const Case& c : cases) {
    const Disturbed first = disturbed(make_c, c.harm, c.extra),
                    second = disturbed(make_g, c.harm, c.extra);
    const double error = std::max(first.error, second.error);
    item.stability(c.id, c.what, "in the middle of a sine",
                   fmt::format("{} outputs of C and {} of G are NaN, all others as without",
                               first.missing, second.missing),
                   error, error < 1e-12 ? c.extra ? "holds" : "refused" : "fails");
  }
  filters::SecondOrderHybrid butterworth{{corner, std::sqrt(0.5)}};
  double u = 0;
  for (const double T : {0.03, 0.03, 2.0}) u = butterworth.push(1, T).mean;
  item.stability("complex", "G with complex poles",
                 "T = 2 s after 0.03 s: longer than the poles swing half",
                 std::isnan(u) ? "NaN" : "a number", none, std::isnan(u) ? "refused" : "fails");
}

/*** The stream and what it replaces: */
std::vector<double> noise(std::size_t n) {
  const spectra::RandomSource random{4, 1};
  std::vector<double> x(n);
  for (std::size_t k = 0; k < n; ++k) x[k] = 1e-4 * random.normal(k);
  return x;
}

struct Difference {
  std::size_t missing = 0;
  double largest = 0;
};
Difference compare(const std::vector<double>& a, const std::vector<double>& b) {
  Difference d;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i])) continue;
    if (std::isnan(b[i]))
      ++d.missing;
    else
      d.largest = std::max(d.largest, std::abs(a[i] - b[i]));
  }
  return d;
}

void streams(report::Item& item) {
  const auto x = noise(20000);
  const auto clean = filters::geometry(x).chord;
  const auto row = [&](const char* id, const char* what, const char* stress, double value,
                       std::size_t count) {
    auto harmed = x;
    for (std::size_t k = 0; k < count; ++k) harmed[9000 + 3 * k] = value;
    const Difference d = compare(clean, filters::geometry(harmed).chord);
    item.stability(id, what, stress,
                   fmt::format("{} offsets NaN, others off by {:.0e} m", d.missing, d.largest),
                   d.largest,
                   d.largest < 1e-12 && d.missing == 661 + 3 * (count - 1) ? "refused" : "fails");
  };
  row("stream-nan", "stream: NaN", "one sample", none, 1);
  row("stream-nans", "stream: NaN", "100 samples, every third", none, 100);
  row("stream-infinite", "stream: infinity", "one sample", units::no_limit, 1);
  row("stream-spike", "stream: 10³⁰⁰ m", "one sample", 1e300, 1);
  auto biased = x;
  for (double& m : biased) m += 8.8e-3;  // 1 mg at 0.5 mph
  const Difference bias = compare(clean, filters::geometry(biased).chord);
  item.stability("stream-bias", "stream: constant short offset", "8.8 mm, as of 1 mg at 0.5 mph",
                 fmt::format("62-ft chord off by {:.0e} m", bias.largest), bias.largest,
                 bias.largest < 1e-9 ? "holds" : "fails");
  try {
    (void)filters::geometry(std::span{x}.first(660));
    item.stability("stream-short", "stream: short record", "660 samples", "an answer", none,
                   "fails");
  } catch (const InputError& refusal) {
    item.stability("stream-short", "stream: short record", "660 samples", refusal.what(), none,
                   "refused");
  }
  auto spiked = x;
  spiked[500] = 1e10;
  const auto sums = [](const std::vector<double>& v) {
    return filters::running_sum<double>(v, 31, 0);
  };
  const auto a = sums(x), b = sums(spiked);
  item.stability(
      "sum-spike", "running sum never restarted, not masked", "one sample of 10¹⁰ m",
      fmt::format("off by {:.0e} m for the rest of the record", std::abs(a.back() - b.back())),
      std::abs(a.back() - b.back()), std::abs(a.back() - b.back()) > 1e-12 ? "fails" : "holds");
}

void others(report::Item& item) {
  const double kappa = gyro_corner * sample_distance / (5 * units::mph);
  const double apart = 2 * (0.5 - filters::centroid_delay(kappa)) * sample_distance;
  item.stability("reversal", "C: the other direction, shifted by half a sample", "5 mph",
                 fmt::format("{:.0f} mm apart", apart / units::millimetre), apart / sample_distance,
                 "degraded");
  const filters::DecayPair pade = filters::decay(1e3, filters::Decay::pade11),
                           reciprocal = filters::decay(1e3, filters::Decay::reciprocal);
  item.stability(
      "stop-pade", "C with Padé (1,1)", "κ = 1000: nearly at a stop",
      fmt::format("a = {:.3f} instead of 0: half the sample before is still in it", pade.a),
      std::abs(pade.a), "fails");
  item.stability("stop-reciprocal", "C with 1/(1 + κ)", "κ = 1000",
                 fmt::format("a = {:.3f} instead of 0", reciprocal.a), reciprocal.a, "degraded");
  const double tau = filters::time_constant(roll_corner);
  filters::ComplementaryFilter filter{tau, 2};
  filter.push(0, 0, 0.01);
  const double after = filter.push(0.05, 1.0, 3600);
  item.stability("roll-stop", "roll filter", "an hour at a stop, gyro run away by 1 rad",
                 fmt::format("off the inclinometer by {:.0e} rad", std::abs(after - 0.05)),
                 std::abs(after - 0.05), std::abs(after - 0.05) < 1e-12 ? "holds" : "fails");
}

void stability(report::Item& item) {
  intervals(item);
  faults(item);
  streams(item);
  others(item);
  item.reconstructed("not in the paper");
  car_stability(item);
}

}  // namespace

void add_stability(report::Chapter& chapter) {
  chapter.table("stability", "Stops, reversals, faults of encoder and sensors", stability);
}

}  // namespace railbook::filters_chapter
