// Which points a slope goes through, and the frame of a panel.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "../support/temporary_folder.hpp"
#include "bench/evidence.hpp"
#include "bench/work_precision.hpp"
#include "report/item.hpp"

using namespace railbook;

namespace {

report::WorkPrecision point(double work, double error, double uncertainty = 0) {
  report::WorkPrecision p;
  p.quantity = "F", p.method = "a", p.setting = "s";
  p.work = work, p.error = error, p.reference_uncertainty = uncertainty, p.converged = true;
  return p;
}
double slope(std::vector<report::WorkPrecision> points) {
  return bench::observed_slope(points, "F", "a");
}

}  // namespace

TEST_CASE("unit: a slope goes through the points that the reference can judge") {
  CHECK(slope({point(1, 1), point(2, 0.25), point(4, 1.0 / 16)}) == Approx(-2));
  CHECK(std::isnan(slope({point(2, 1)})));
  CHECK(std::isnan(slope({point(2, 1), point(2, 0.5)})));  // straight up
  CHECK(std::isnan(slope({point(1, 1), point(1, 1)})));
  // Left out: an exact value, one below a hundred times the reference, a failure, and one without work.
  auto failed = point(8, 1);
  failed.converged = false;
  CHECK(slope({point(1, 1), point(2, 0.5), point(4, 0), point(8, 1e-3, 1.1e-5), failed,
               point(0, 1)}) == Approx(-1));
  CHECK(slope({point(1, 1), point(2, 0.5), point(4, 0.25, 0.0025)}) == Approx(-1));
  auto other = point(4, 9);
  other.method = "b";
  CHECK(slope({point(1, 1), point(2, 0.5), other}) == Approx(-1));
  CHECK_THROWS_AS(bench::observed_slope({point(1, 1)}, "G", "a"), std::logic_error);
  other.method = "b, c";
  CHECK_THROWS_AS(slope({other}), std::logic_error);
}

TEST_CASE("unit: an error is relative to the size of a reference of either sign") {
  const auto run = [](double value) {
    return bench::Method{"a", {{"1", [value] { return bench::Outcome{{value}, 1, true, ""}; }}}};
  };
  for (const double reference : {4.0, -4.0})
    for (const double share : {0.5, 1.5, 1.0})
      CHECK(bench::measure("c", {{"F", reference, 0}}, {run(share * reference)}, false)[0].error ==
            Approx(std::abs(share - 1)));
  CHECK(std::isnan(bench::measure("c", {{"F", 1, 0}}, {run(INFINITY)}, false)[0].error));
  CHECK_THROWS_AS(bench::measure("c", {{"F", 1, 0}, {"G", 1, 0}}, {run(1)}, false),
                  std::logic_error);
  const auto untimed = bench::measure("c", {{"F", 1, 0}}, {run(2)}, false)[0];
  CHECK(untimed.seconds_median == 0);
  CHECK(untimed.samples == 0);
}

TEST_CASE("unit: the expected slope is drawn a quarter below the points, over the middle of them") {
  const TemporaryFolder at("frame");
  report::RunSettings settings;
  settings.results = settings.figures = at.path;
  settings.draw = false;
  report::Item item{"cost", "figure", "Cost", settings};
  bench::Method a{"a", {}};
  a.expects(-2);
  const std::vector<report::WorkPrecision> points{point(1, 1), point(10, 0.1), point(100, 0.01)};
  bench::show(item, points, "F", {a}, {1e-8, 1e-2, 1e-9, 1e-3});
  item.added("a test");
  report::ChapterRecord record;
  item.finish(record);
  const std::string frame = at.read("cost-frame.csv");
  std::istringstream lines{frame};
  std::string line, what;
  std::vector<double> x;
  while (std::getline(lines, line)) {
    std::istringstream cells{line};
    std::string cell;
    std::getline(cells, what, ',');
    if (what == "error") CHECK(line.starts_with("error,1e-08,0.01,"));
    if (what != "slope") continue;
    for (int k = 0; k < 4 && std::getline(cells, cell, ','); ++k) x.push_back(std::stod(cell));
  }
  REQUIRE(x.size() == 4);
  // The middle of the points is (10, 0.1); the line ends 0.3 of their range to either side.
  const double half = std::pow(100, 0.3);
  CHECK(x[0] == Approx(10 / half));
  CHECK(x[2] == Approx(10 * half));
  CHECK(x[1] == Approx(0.025 * half * half));
  CHECK(x[3] == Approx(0.025 / half / half));
}

TEST_CASE("unit: the median margin of stated errors over true ones") {
  const TemporaryFolder at("margin");
  report::RunSettings settings;
  settings.results = settings.figures = at.path;
  settings.draw = false;
  report::Item item{"stated", "figure", "Stated", settings};
  bench::estimates_against_truth(item, {{"a", 2e-3, 1e-3}, {"b", 5e-3, 1e-3}, {"c", 8e-3, 1e-3}},
                                 0.9);
  item.added("a test");
  report::ChapterRecord record;
  item.finish(record);
  bool found = false;
  for (const auto& value : record.values) {
    if (value.id.find("median-margin") == std::string::npos) continue;
    found = true;
    CHECK(value.text == "5");
  }
  CHECK(found);
}
