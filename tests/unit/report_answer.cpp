#include "report/answer.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "../support/temporary_folder.hpp"
#include "report/chapter.hpp"

using namespace railbook;

namespace {

int reproduce(const TemporaryFolder& at, const report::ItemFunction& item) {
  std::vector<std::string> words{"sample", "reproduce", "--out", at.path.string()};
  std::vector<char*> argv;
  for (auto& w : words) argv.push_back(w.data());
  return report::run(static_cast<int>(argv.size()), argv.data(),
                     {"00-sample", "sample", "A sample", "Nobody, 1975", at.path},
                     {{report::table("t", "T", item)}}, {});
}

}  // namespace

TEST_CASE("unit: an answer leaves its panels, and its points to four digits") {
  const TemporaryFolder at("answer");
  CHECK(reproduce(at, [](report::Item& item) {
          item.added("ours");
          report::Answer answer{item,
                                {"speed_mph"},
                                {{"force", "time, ms", "force, kN", 0, 20, 0, 400},
                                 {.name = "peaks", .kind = "says"}}};
          answer.at({40});
          answer.point("force", "computed", 1.23456, -98765.4);
          answer.says("peaks", "P1, kN", 0.0);
          answer.says("peaks", "stable", "yes");
        }) == 0);
  CHECK(at.read("results/00-sample/t-panels.csv")
            .find("force,lines,\"time, ms\",\"force, kN\",0,20,0,400,lin") != std::string::npos);
  CHECK(at.read("results/00-sample/t-answer.csv")
            .starts_with("speed_mph,panel,curve,x,y\n40,force,computed,1.235,-98770\n"
                         "40,peaks,\"P1, kN\",0,0\n40,peaks,stable,yes,0\n"));
}

TEST_CASE("unit: an answer without sliders, or with a point before its values, is a mistake") {
  const TemporaryFolder at("answer");
  CHECK(reproduce(at, [](report::Item& item) {
          item.added("ours");
          CHECK_THROWS_AS(report::Answer(item, {}, {}), std::logic_error);
          report::Answer answer{item, {"x_m", "y_m"}, {}};
          CHECK_THROWS_AS(answer.point("a", "b", 1, 2), std::logic_error);
          CHECK_THROWS_AS(answer.at({1}), std::logic_error);
        }) == 0);
}
