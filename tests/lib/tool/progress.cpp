#include <railbook/tool/progress.hpp>

#include <catch2/catch.hpp>
#include <string>

#include "support/captured.hpp"

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
    CHECK_FALSE(tool::should_report(1, 1000, 1.9, enough));
    CHECK(tool::should_report(1, 1000, 2.1, enough));
    // 4 s a step: what is left takes a little less, or more, than enough.
    CHECK_FALSE(tool::should_report(10, 10 + 0.24 * enough, 40, enough));
    CHECK(tool::should_report(10, 10 + 0.26 * enough, 40, enough));
  }
}

TEST_CASE("Progress is silent for runs of up to two seconds") {
  CHECK_FALSE(tool::should_report(1, 1000, 2, 10));
  CHECK_FALSE(tool::should_report(10, 20, 10, 10));
}

TEST_CASE("Progress is one line in a file, and on a terminal a line that keeps up and goes") {
  for (const bool terminal : {false, true}) {
    double now = 100;
    const Captured said = captured([&] {
      tool::Progress progress("points", 100, terminal, [&now] { return now; });
      for (int k = 0; k < 99; ++k) {
        now += k < 20 ? 0.21 : 0.45;  // slower then
        progress.step();
      }
      progress.end();
      progress.end();
      return 0;
    });
    CHECK(said.out.empty());
    if (!terminal) {  // at 2.1 s, ten steps, 90 * 0.21 s to go
      CHECK(said.err == "points: 10 of 100, about 19 s to go\n");
      continue;
    }
    // Again when more than half a second has passed: each third step of 0.21 s, each second of 0.45
    // s.
    const std::string begin =
        "\rpoints: 10 of 100, about 19 s to go\x1b[K"
        "\rpoints: 13 of 100, about 18 s to go\x1b[K"
        "\rpoints: 16 of 100, about 18 s to go\x1b[K"
        "\rpoints: 19 of 100, about 17 s to go\x1b[K"
        "\rpoints: 21 of 100, about 17 s to go\x1b[K"
        "\rpoints: 23 of 100, about";
    CHECK(said.err.substr(0, begin.size()) == begin);
    CHECK(said.err.ends_with("\rpoints: 99 of 100, about 0 s to go\x1b[K\r\x1b[K"));
  }
  // What ends soon is not worth a line, nor taken away.
  double now = 0;
  const Captured quick = captured([&] {
    tool::Progress progress("points", 4, true, [&now] { return now; });
    for (int k = 0; k < 4; ++k) now += 0.9, progress.step();
    return 0;
  });
  CHECK(quick.err.empty());
}
