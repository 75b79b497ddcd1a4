#include "bench/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "num/stopwatch.hpp"
#include "plot/plot.hpp"

namespace railbook::bench {
namespace {

Outcome guarded(const Setting& setting, std::size_t quantities) {
  Outcome outcome;
  try {
    outcome = setting.run();
  } catch (const std::exception& error) {
    outcome.converged = false;
    outcome.reason = error.what();
  }
  if (outcome.converged && outcome.values.size() != quantities)
    throw std::logic_error{"work-precision: a method returned another number of values"};
  return outcome;
}

double relative_error(double value, double reference) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::quiet_NaN();
  return std::abs(value - reference) / std::abs(reference);
}

}  // namespace

Timing time_call(const std::function<void()>& call, double budget) {
  const auto batch = [&](int calls) {
    const num::Stopwatch watch;
    for (int i = 0; i < calls; ++i) call();
    return watch.seconds() / calls;
  };
  const double first = std::max(batch(1), 1e-9);  // the warm-up
  const int calls = static_cast<int>(std::clamp(std::ceil(1e-3 / first), 1.0, 1e6));
  const double cost = first * calls;
  const int samples = static_cast<int>(std::clamp(budget / cost, 1.0, 21.0));
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(samples));
  for (int i = 0; i < samples; ++i) times.push_back(batch(calls));
  std::sort(times.begin(), times.end());
  const double median = times[times.size() / 2];
  return {times.front(), median, (median - times.front()) / times.front()};
}

std::vector<report::WorkPrecision> measure(const std::string& id,
                                           const std::vector<Reference>& references,
                                           const std::vector<Method>& methods, bool timings,
                                           double budget) {
  std::vector<report::WorkPrecision> points;
  for (const Method& method : methods) {
    for (const Setting& setting : method.settings) {
      const Outcome outcome = guarded(setting, references.size());
      Timing timing;
      if (timings && outcome.converged) timing = time_call([&] { (void)setting.run(); }, budget);
      for (std::size_t q = 0; q < references.size(); ++q) {
        report::WorkPrecision point;
        point.id = id;
        point.quantity = references[q].quantity;
        point.method = method.name;
        point.setting = setting.label;
        point.error = outcome.converged ? relative_error(outcome.values[q], references[q].value)
                                        : std::numeric_limits<double>::quiet_NaN();
        point.reference_uncertainty = references[q].uncertainty;
        point.seconds_min = timing.min;
        point.seconds_median = timing.median;
        point.noise = timing.noise;
        point.work = outcome.work;
        point.converged = outcome.converged;
        point.reason = outcome.reason;
        points.push_back(std::move(point));
      }
    }
  }
  return points;
}

report::Data& show(report::Item& item, const std::vector<report::WorkPrecision>& points,
                   const std::string& quantity) {
  std::vector<report::WorkPrecision> chosen;
  report::Data& data = item.data({"method", "setting", "error", "reference_uncertainty",
                                  "seconds_min_s", "seconds_median_s", "work"});
  for (const report::WorkPrecision& p : points) {
    if (p.quantity != quantity) continue;
    if (p.method.find(',') != std::string::npos)
      throw std::logic_error{"work-precision: gnuplot cuts \"" + p.method + "\" at the comma"};
    chosen.push_back(p);
    // An error below what the reference knows is drawn there.
    const double floor = std::max(p.reference_uncertainty, 1e-16);
    if (p.converged && std::isfinite(p.error))
      data.add(p.method, p.setting, std::max(p.error, floor), p.reference_uncertainty,
               p.seconds_min, p.seconds_median, p.work);
  }
  const char* const why = "error control takes other steps where a last digit differs";
  data.holds_to("error", 0.9, 1e-15, why).holds_to("reference_uncertainty", 0.9, 0, why);
  data.holds_to("work", 0.05, 0, why);
  if (chosen.empty())
    throw std::logic_error{"work-precision: no points of quantity \"" + quantity + "\""};
  item.add(std::move(chosen));
  item.script(plot::shared("lib/bench") / "work_precision.gp");
  return data;
}

std::string label(int size) {
  return std::to_string(size);
}
std::string label(double setting) {
  return fmt::format("{:g}", setting);
}

std::vector<report::WorkPrecision> figure(report::Item& item, const Reference& reference,
                                          const std::vector<Method>& methods, double budget) {
  auto points = measure(item.id(), {reference}, methods, item.timings(), budget);
  show(item, points, reference.quantity);
  return points;
}

double observed_slope(const std::vector<report::WorkPrecision>& points, const std::string& quantity,
                      const std::string& method) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const report::WorkPrecision& p : points) {
    if (p.quantity != quantity || p.method != method || !p.converged) continue;
    if (!(p.error > 0 && p.work > 0)) continue;
    const double x = std::log(p.work);
    const double y = std::log(p.error);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double spread = n * sxx - sx * sx;
  if (n < 2 || !(spread > 0)) return std::numeric_limits<double>::quiet_NaN();
  return (n * sxy - sx * sy) / spread;
}

}  // namespace railbook::bench
