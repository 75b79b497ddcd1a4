#include <railbook/bench/timing.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/num/stopwatch.hpp>
#include <railbook/report/timing_lock.hpp>

namespace railbook::bench {
namespace {

struct Plan {
  int calls, samples;  // calls a sample
};

Plan plan_for(double first, double budget) {
  const double each = std::max(first, 1e-9);
  const int calls = static_cast<int>(std::ceil(1e-3 / each));
  return {calls, static_cast<int>(std::clamp(budget / (each * calls), 1.0, 21.0))};
}

double sample(const std::function<void()>& call, int calls) {
  return seconds_of([&] {
           for (int i = 0; i < calls; ++i) call();
         }) /
         calls;
}

}  // namespace

Timing summary(std::vector<double> times) {
  std::ranges::sort(times);
  const auto at = [&](double share) {
    return times[static_cast<std::size_t>(
        std::lround(share * static_cast<double>(times.size() - 1)))];
  };
  return {times.front(), at(0.25), at(0.5), at(0.75), static_cast<int>(times.size())};
}

double seconds_of(const std::function<void()>& call) {
  const num::Stopwatch watch;
  call();
  return watch.seconds();
}

Timing time_call(const std::function<void()>& call, double budget) {
  return time_interleaved({call}, {seconds_of(call)}, budget).front();
}

std::vector<Timing> time_interleaved(const std::vector<std::function<void()>>& calls,
                                     const std::vector<double>& first, double budget) {
  std::vector<Plan> plans;
  std::vector<std::vector<double>> times(calls.size());
  int rounds = 0;
  const report::TimingLock alone;
  for (std::size_t i = 0; i < calls.size(); ++i) {
    plans.push_back(plan_for(first[i], budget));
    if (!calls[i]) plans[i].samples = 0, times[i] = {first[i]};
    rounds = std::max(rounds, plans[i].samples);
  }
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < calls.size(); ++i)
      if (round < plans[i].samples) times[i].push_back(sample(calls[i], plans[i].calls));
  std::vector<Timing> out;
  out.reserve(times.size());
  for (std::vector<double>& t : times) out.push_back(summary(std::move(t)));
  return out;
}

std::string duration(double seconds) {
  if (seconds < 0.9995e-6) return fmt::format("{:.3g} ns", 1e9 * seconds);
  if (seconds < 0.9995e-3) return fmt::format("{:.3g} us", 1e6 * seconds);
  if (seconds < 0.9995) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return fmt::format("{:.3g} s", seconds);
}

}  // namespace railbook::bench
