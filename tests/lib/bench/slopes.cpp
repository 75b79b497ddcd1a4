// Which points a slope goes through, and the frame of a panel.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/bench/work_precision.hpp>
#include <railbook/report/item.hpp>

#include "support/no_fp_fault.hpp"
#include "support/temporary_folder.hpp"

using namespace railbook;

namespace {

report::WorkPrecision point(double work, double error, double uncertainty = 0) {
  report::WorkPrecision p;
  p.quantity = "F", p.method = "a", p.setting = "s";
  p.work = work, p.error = error, p.reference_uncertainty = uncertainty, p.converged = true;
  return p;
}
double slope(const std::vector<report::WorkPrecision>& points) {
  return bench::observed_slope(points, "F", "a");
}

}  // namespace

TEST_CASE("unit: a slope goes through the points that the reference can judge") {
  const NoFpFault no_fault;
  CHECK(slope({point(1, 1), point(2, 0.25), point(4, 1.0 / 16)}) == Approx(-2));
  CHECK(std::isnan(slope({point(2, 1)})));
  CHECK(std::isnan(slope({point(2, 1), point(2, 0.5)})));  // straight up
  CHECK(std::isnan(slope({point(1, 1), point(1, 1)})));
  // Left out: an exact value, one below a hundred times the reference, a failure, and one without
  // work.
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

TEST_CASE("unit: a panel has each point, at what its reference knows, and what failed at the top") {
  const TemporaryFolder at("panel");
  report::RunSettings settings;
  settings.results = settings.figures = at.path;
  settings.draw = false;
  std::vector<report::WorkPrecision> points{
      point(1, 0.5, 1e-3), point(2, 0.1, 1e-3),  point(3, 0.09, 1e-3), point(4, 5e-4, 1e-3),
      point(5, 0),         point(6, units::nan), point(7, 0.5)};
  points[6].converged = false;
  for (auto& p : points) p.setting = std::to_string(static_cast<int>(p.work));
  auto other = point(8, 0.25);
  other.quantity = "G";
  points.push_back(other);
  const auto panel = [&](const char* quantity) {
    report::Item item{"cost", "figure", "Cost", settings};
    bench::show(item, points, quantity, {{"a", {}}}, {0, 0, 1e-3, 10}).not_compared("a test");
    item.added("a test");
    report::ChapterRecord record;
    item.finish(record);
    CHECK(record.items[0].script == "work_precision.gp");
    return record.work_precision.size();
  };
  const std::string
      header = "method,setting,error,seconds_q1_s,seconds_median_s,seconds_q3_s,work,state\n",
      notes =
          "# holds to relative 0.9, absolute 1e-15 in error: error control takes other steps "
          "where a last digit differs\n"
          "# holds to relative 0.05, absolute 0 in work: error control takes other steps "
          "where a last digit differs\n# not compared: a test\n";
  CHECK(panel("G") == 1);
  CHECK(at.read("cost.csv") == header + "a,s,0.25,0,0,0,8,known\n" + notes);
  CHECK(panel("F") == 7);
  CHECK(at.read("cost.csv") ==
        header +
            "a,1,0.5,0,0,0,1,known\na,2,0.1,0,0,0,2,known\na,3,0.09,0,0,0,3,vague\n"
            "a,4,0.001,0,0,0,4,vague\na,5,1e-16,0,0,0,5,vague\na,6,1,0,0,0,6,failed\n"
            "a,7,1,0,0,0,7,failed\n" +
            notes);
  // No order is expected of the method: no line. The reference is that of the first point.
  CHECK(
      at.read("cost-frame.csv") ==
      "what,x1,y1,x2,y2,text\nerror,0,0,0,0,\nseconds,0.001,10,0,0,\nreference,0.001,0.1,0,0,\n"
      "# holds to relative 0.9, absolute 1e-12 in *: errors near rounding move the lines; work may "
      "differ by a step\n");
  // Across are the times where one point has any, and the slope is over them.
  points = {point(1, 1), point(2, 0.5), point(4, 0.25)};
  for (auto& p : points) p.seconds_q1 = p.seconds_median = p.seconds_q3 = p.work * p.work;
  report::Item item{"cost", "figure", "Cost", settings};
  bench::Method a{"a", {}};
  bench::show(item, points, "F", {a.expects(-1), {"none", {}, -1}});
  item.added("a test");
  report::ChapterRecord record;
  item.finish(record);
  const std::string frame = at.read("cost-frame.csv");
  CHECK_THAT(frame, Catch::Contains("expected −1; found −0.5\"\n"));
  CHECK_THAT(frame, Catch::Contains("error,0,0,0,0,\nseconds,0,0,0,0,\n"));
  CHECK(frame.find("slope", frame.find("slope") + 1) == std::string::npos);
  CHECK_THAT(frame, Catch::Contains("# holds to relative 0, absolute inf in x1: times of"));
  CHECK_THAT(at.read("cost.csv"), Catch::Contains("a,s,0.5,4,4,4,2,known\n") &&
                                      Catch::Contains("absolute inf in seconds_q3_s: times of"));
}
