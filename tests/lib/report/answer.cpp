#include <railbook/report/answer.hpp>

#include <catch2/catch.hpp>

#include "support/sample_chapter.hpp"

using namespace railbook;

TEST_CASE("unit: an answer leaves its panels, and its points to four digits") {
  const Sample s;
  REQUIRE(s.reproduce(one([](report::Item& item) {
    item.added("ours");
    report::Answer answer{item,
                          {"speed_mph"},
                          {{"force", "time, ms", "force, kN", 0, 20, 0, 400},
                           {.name = "peaks", .scale = "log", .kind = "says"}}};
    answer.at({40});
    answer.point("force", "computed", 1.23456, -98765.4);
    answer.point("force", "computed", 0.00999951, units::nan);
    answer.says("peaks", "P1, kN", 0.0);
    answer.says("peaks", "stable", "yes");
  })) == 0);
  CHECK(s.at.read("results/00-sample/t-panels.csv") ==
        "panel,kind,x_label,y_label,x_from,x_to,y_from,y_to,scale\n"
        "force,lines,\"time, ms\",\"force, kN\",0,20,0,400,lin\npeaks,says,,,0,1,0,1,log\n");
  CHECK(s.at.read("results/00-sample/t-answer.csv") ==
        "speed_mph,panel,curve,x,y\n40,force,computed,1.235,-98770\n40,force,computed,0.01,nan\n"
        "40,peaks,\"P1, kN\",0,0\n40,peaks,stable,yes,0\n"
        "# holds to relative 0.002, absolute 1e-09 in x: kept to four digits\n"
        "# holds to relative 0.002, absolute 1e-09 in y: kept to four digits\n");
}

TEST_CASE(
    "unit: an answer of no slider or of three, or with a point before its values, is a mistake") {
  const Sample s;
  REQUIRE(s.reproduce(one([](report::Item& item) {
    item.added("ours");
    for (const std::vector<std::string>& sliders : {std::vector<std::string>{}, {"a", "b", "c"}})
      CHECK_THROWS_AS(report::Answer(item, sliders, {}), std::logic_error);
    report::Answer answer{item, {"x_m", "y_m"}, {}};
    CHECK_THROWS_AS(answer.point("a", "b", 1, 2), std::logic_error);
    CHECK_THROWS_AS(answer.at({1}), std::logic_error);
    answer.at({3, 4});
    answer.point("a", "b", 1, 2);
  })) == 0);
  CHECK_THAT(s.at.read("results/00-sample/t-answer.csv"),
             Catch::StartsWith("x_m,y_m,panel,curve,x,y\n3,4,a,b,1,2\n"));
}
