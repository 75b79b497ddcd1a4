// How often a call is timed, and what is made of the times.
#include <railbook/bench/timing.hpp>

#include <catch2/catch.hpp>
#include <string>

#include <railbook/num/stopwatch.hpp>

using namespace railbook;

namespace {

// Samples of a call whose first one took `first` seconds, and how often it was called.
std::pair<int, int> plan(double first, double budget) {
  int calls = 0;
  const auto timing = bench::time_interleaved({[&] { ++calls; }}, {first}, budget);
  return {timing.front().samples, calls};
}

}  // namespace

TEST_CASE("unit: a sample is a batch of a millisecond, and there are up to 21 in the budget") {
  CHECK(plan(3e-4, 0.011) == std::pair{9, 36});  // 4 calls are 1.2 ms, 9 samples 10.8
  CHECK(plan(1.25e-4, 0.0209) == std::pair{20, 160});
  CHECK(plan(1.25e-4, 0.0221) == std::pair{21, 168});
  CHECK(plan(2e-3, 100) == std::pair{21, 21});
  CHECK(plan(1, 0.5) == std::pair{1, 1});         // one at least
  CHECK(plan(0, 1e-4) == std::pair{1, 1000000});  // quicker than the clock's step
}

TEST_CASE("unit: calls are timed in rounds, and one that failed is not called again") {
  std::string order;
  const auto timings = bench::time_interleaved({[&] { order += "a"; }, {}, [&] { order += "b"; }},
                                               {0.5, 7, 0.25}, 1);
  CHECK(order ==
        "abab"
        "bb");
  CHECK(timings[0].samples == 2);
  CHECK(timings[2].samples == 4);
  const bench::Timing& failed = timings[1];
  for (const double seconds : {failed.min, failed.q1, failed.median, failed.q3})
    CHECK(seconds == 7);
  CHECK(failed.samples == 1);
}

TEST_CASE("unit: a duration has three digits, in the unit that suits them") {
  const std::pair<double, const char*> said[] = {
      {0, "0 ns"},           {1.234e-9, "1.23 ns"}, {9.9949e-7, "999 ns"}, {9.9951e-7, "1 us"},
      {9.9949e-4, "999 us"}, {9.9951e-4, "1 ms"},   {0.99949, "999 ms"},   {1, "1 s"},
      {0.99951, "1 s"},      {35e-6, "35 us"},      {1.2e-3, "1.2 ms"},    {61.25, "61.2 s"}};
  for (const auto& [seconds, text] : said) CHECK(bench::duration(seconds) == text);
}

TEST_CASE("unit: a time is that of one call") {
  volatile double sink = 0;
  const num::Stopwatch all;
  const auto timing = bench::time_interleaved({[&] { sink = sink + 1; }}, {3e-7}, 0.0052).front();
  CHECK(timing.samples == 5);
  CHECK(timing.min > 0);
  CHECK(timing.min * 5 * 3334 <= all.seconds());  // five samples of 3334 calls
  CHECK(bench::time_call([&] { sink = sink + 1; }, 1e-3).samples >= 1);
}
