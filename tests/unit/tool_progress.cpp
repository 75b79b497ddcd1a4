#include "tool/progress.hpp"

#include <catch2/catch.hpp>

using namespace railbook;

TEST_CASE("Progress says what is left at the pace so far") {
  CHECK(tool::progress_line("points", 12, 40, 30) == "points: 12 of 40, about 70 s to go");
  CHECK(tool::progress_line("nodes", 1, 121, 2) == "nodes: 1 of 121, about 4 min to go");
  CHECK(tool::progress_line("nodes", 1, 10001, 2) == "nodes: 1 of 10001, about 6 h to go");
  CHECK(tool::progress_line("points", 50, 40, 30) == "points: 50 of 50, about 0 s to go");
  CHECK(tool::progress_line("points", 0, 40, 30) == "points: 0 of 40, about 0 s to go");
  CHECK(tool::progress_line("points", 10, 20, 99.4) == "points: 10 of 20, about 99 s to go");
  CHECK(tool::progress_line("points", 10, 20, 100.4) == "points: 10 of 20, about 2 min to go");
  CHECK(tool::progress_line("points", 10, 20, 5990) == "points: 10 of 20, about 100 min to go");
  CHECK(tool::progress_line("points", 10, 20, 6010) == "points: 10 of 20, about 2 h to go");
}

TEST_CASE("Progress is silent for two seconds, and where the rest is short") {
  for (const double enough : {1.0, 10.0}) {
    CHECK_FALSE(tool::worth_saying(1, 1000, 1.9, enough));
    CHECK(tool::worth_saying(1, 1000, 2.1, enough));
    // 4 s a step: what is left takes a little less, or more, than enough.
    CHECK_FALSE(tool::worth_saying(10, 10 + 0.24 * enough, 40, enough));
    CHECK(tool::worth_saying(10, 10 + 0.26 * enough, 40, enough));
  }
}
