#include <railbook/bench/work_precision.hpp>

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <railbook/report/item.hpp>

using namespace railbook;

namespace {

// The midpoint rule for exp on [0, 1]: second order.
bench::Outcome midpoint(int n) {
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += std::exp((i + 0.5) / n) / n;
  return {{sum}, static_cast<double>(n), true, ""};
}

const std::vector<bench::Reference> exact{{"integral", std::exp(1.0) - 1, 1e-16}};

}  // namespace

TEST_CASE("unit: errors, order and failures are kept") {
  bench::Method rule{"midpoint", {}};
  for (int n : {4, 8, 16, 32})
    rule.settings.push_back({std::to_string(n), [n] { return midpoint(n); }});
  const bench::Method broken{
      "broken",
      {{"a",
        [] {
          return bench::Outcome{{}, 3, false, "ran out of steps"};
        }},
       {"b", []() -> bench::Outcome { throw std::runtime_error{"singular"}; }}}};
  const auto points = bench::measure("cost", exact, {rule, broken}, true, 0.01);
  REQUIRE(points.size() == 6);
  CHECK(bench::observed_slope(points, "integral", "midpoint") == Approx(-2).margin(0.02));
  CHECK(points[0].seconds_min > 0);
  CHECK(points[0].seconds_min <= points[0].seconds_q1);
  CHECK(points[0].seconds_q1 <= points[0].seconds_median);
  CHECK(points[0].seconds_median <= points[0].seconds_q3);
  CHECK(points[0].samples > 1);
  CHECK_FALSE(points[4].converged);
  CHECK(points[4].reason == "ran out of steps");
  CHECK(points[5].reason == "singular");
  CHECK(std::isnan(points[5].error));
}

TEST_CASE("unit: the figure is drawn, with and without times") {
  const auto folder =
      std::filesystem::temp_directory_path() / ("railbook-bench-" + std::to_string(::getpid()));
  bench::Method rule{"midpoint", {}};
  for (int n : {4, 8, 16})
    rule.settings.push_back({std::to_string(n), [n] { return midpoint(n); }});
  bench::Method twice{"midpoint 2n", {}};
  for (int n : {4, 8, 16})
    twice.settings.push_back({std::to_string(n), [n] { return midpoint(2 * n); }});
  for (const bool timings : {true, false}) {
    report::RunSettings settings;
    settings.results = settings.figures = folder;
    report::Item item{timings ? "timed" : "untimed", "figure", "Cost", settings};
    rule.expects(-2).counts("evaluations");
    const bench::Method broken{"broken", {{"a", [] {
                                             return bench::Outcome{{}, 3, false, "ran out"};
                                           }}}};
    const std::vector<bench::Method> methods{rule, twice, broken};
    bench::show(item, bench::measure("cost", exact, methods, timings, 0.01), "integral", methods,
                {1e-8, 1e-2, 1e-9, 1e-2});
    item.added("a test");
    report::ChapterRecord record;
    item.finish(record);
    CHECK(record.items[0].input == "added");
    CHECK(record.work_precision.size() == 7);
    CHECK(record.work_precision[0].work_unit == "evaluations");
    CHECK(std::filesystem::file_size(folder / record.items[0].png) > 5000);
  }
  if (std::getenv("KEEP") == nullptr) std::filesystem::remove_all(folder);
}

TEST_CASE("unit: the answer names the cheapest method that stays below the error") {
  const auto point = [](const char* method, const char* setting, double error, double seconds) {
    report::WorkPrecision p;
    p.quantity = "F";
    p.method = method;
    p.setting = setting;
    p.error = error;
    p.reference_uncertainty = 1e-9;
    p.seconds_median = seconds;
    return p;
  };
  // The lucky first setting of a does not count, since the next one is worse again.
  const std::vector<report::WorkPrecision> points{
      point("a", "1", 1e-5, 1e-6), point("a", "2", 1e-2, 2e-6), point("a", "3", 5e-4, 3e-3),
      point("b", "1", 9e-4, 2.5e-3), point("b", "2", 1e-12, 4e-2)};
  CHECK(bench::answer(points, "F", {1e-3, 1e-6, 1e-8}) ==
        "For an error of 0.1 % use b with 1 (2.5 ms); of 10⁻⁶ or 10⁻⁸ use b with 2 (40 "
        "ms).");
  CHECK(bench::cheapest(points, "F", 1e-20).method.empty());
  CHECK(bench::answer({point("a", "1", 1e-5, 0)}, "F", {1e-3}) ==
        "For an error of 0.1 % (not timed).");
  CHECK(bench::answer({point("a", "", 1e-5, 1)}, "F", {1e-4}) ==
        "For an error of 10⁻⁴ use a (1 s).");
  CHECK(bench::answer({point("a", "1", 1, 1)}, "F", {0.05}) ==
        "For an error of 5 % none of the settings tried.");
  CHECK(bench::answer({point("a", "1", 1, 1)}, "F", {2e-5}) ==
        "For an error of 2·10⁻⁵ none of the settings tried.");
  // An error is known to the reference's uncertainty; of equally quick ones the first is named.
  CHECK(bench::cheapest({point("a", "1", 1e-8, 1)}, "F", 1.11e-8).method == "a");
  CHECK(bench::cheapest({point("a", "1", 1e-8, 1)}, "F", 1.09e-8).method.empty());
  CHECK(bench::cheapest({point("a", "1", 1e-5, 2), point("b", "1", 1e-5, 2)}, "F", 1e-3).method ==
        "a");
  // Of the settings from which on the method keeps the error the one that takes least, before the
  // next method and at the end.
  const auto best = bench::cheapest(
      {point("a", "1", 1e-5, 1), point("a", "2", 1e-5, 4), point("b", "1", 1, 1e-3)}, "F", 1e-3);
  CHECK(best.method + best.setting == "a1");
  CHECK(best.seconds == 1);
  // A later one that takes less is both better and cheaper.
  CHECK(bench::cheapest({point("a", "1", 1e-4, 2), point("a", "2", 1e-5, 1)}, "F", 1e-3).setting ==
        "2");
  auto failed = point("a", "2", 1e-6, 9);
  failed.converged = false;
  CHECK(bench::cheapest({point("a", "1", 1e-5, 1), failed}, "F", 1e-3).method.empty());
}
