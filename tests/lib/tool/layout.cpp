// How a summary is laid out for people, and what kind a cell of a row is.
#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>

#include <railbook/tool/summary.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;

namespace {

std::string printed(const tool::Summary& summary) {
  const TemporaryFolder at("printed");
  std::fflush(stdout);
  const int kept = dup(1), file = open((at.path / "out").c_str(), O_WRONLY | O_CREAT, 0600);
  dup2(file, 1);
  summary.print();
  std::fflush(stdout);
  dup2(kept, 1);
  close(kept);
  close(file);
  return at.read("out");
}

}  // namespace

TEST_CASE("unit: a summary's values stand in a column, units and notes behind them") {
  tool::Summary s("an answer");
  s.add("a_N", "force", 2.5, "N", "about");
  s.add("b_m", "length of all", 0.123456789, "m");
  s.add("v", "speed", tool::Estimate{144.5387, 0.0213}, "ft/s", "of the grid");
  s.add_error("e", "error", 0.03570888, "");
  s.add_to_json("v_error", 0.0213, "ft/s");
  s.add("c", "n", "text\x1b");
  s.warn("coarse", "two cells");
  CHECK(printed(s) ==
        "an answer\n"
        "  WARNING: two cells\n"
        "  force          2.5 N   (about)\n"
        "  length of all  0.1235 m\n"
        "  speed          144.54 +- 0.02 ft/s   (of the grid)\n"
        "  error          0.036\n"
        "  n              text\\x1b\n");
}
