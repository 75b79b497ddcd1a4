#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include <railbook/tool/program.hpp>
#include <railbook/units/constants.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;

namespace {

int run_tool(const tool::Tool& tool, std::vector<std::string> words) {
  if (!words.empty() && words[0] == tool.name) words.insert(words.begin(), "sample");
  words.insert(words.begin(), "railbook");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  return tool::run(
      static_cast<int>(arguments.size()), arguments.data(),
      {.name = "railbook", .about = "a test", .version = "1", .libraries = {}, .help = ""},
      {{"sample", "help", {tool}}});
}

}  // namespace

TEST_CASE("input: a tool takes quantities with units, from the line or a TOML file") {
  const TemporaryFolder scratch("options");
  double spacing = 0.5, depth = 1;
  long cells = 9;
  std::string rail = "132RE";
  const tool::Tool solve{"solve", "help", [&](tool::OptionParser& o) {
                           o.quantity("--tie-spacing", spacing, units::length, "spacing",
                                      tool::positive);
                           o.quantity("--depth", depth, units::length, "depth", tool::non_negative);
                           o.count("--cells", cells, "cells", 1, 4096);
                           o.choice("--rail", rail, {"115RE", "132RE"}, "rail");
                           return [] {};
                         }};
  const auto run = [&](const std::vector<std::string>& words) { return run_tool(solve, words); };
  CHECK(run({"solve", "--tie-spacing", "20in", "--cells", "15"}) == 0);
  CHECK(spacing == Approx(0.508));
  CHECK(cells == 15);
  CHECK(run({"solve", "--depth", "0mm"}) == 0);
  CHECK(depth == 0);
  CHECK(run({"solve", "--depth=-1e-9mm"}) == 2);
  scratch.write("case.toml", "tie-spacing = \"24in\"\nrail = \"115RE\"\n");
  CHECK(run({"solve", "--config", (scratch.path / "case.toml").string()}) == 0);
  CHECK(spacing == Approx(0.6096));
  CHECK(rail == "115RE");
  scratch.write("bad.toml", "tie-spacings = \"24in\"\n");
  CHECK(run({"solve", (scratch.path / "case.toml").string()}) == 0);
  CHECK(run({"solve", "--config=" + (scratch.path / "case.toml").string()}) == 0);
  CHECK(run({"solve", "--config", (scratch.path / "bad.toml").string()}) == 2);
  CHECK(run({"solve", "--config", "/nowhere.toml"}) == 2);
  CHECK(run({"solve", "--tie-spacing", "20"}) == 2);
  CHECK(run({"solve", "--tie-spacing", "20kg"}) == 2);
  CHECK(run({"solve", "--tie-spacing=-1in"}) == 2);
  CHECK(run({"solve", "--tie-spacing", "0in"}) == 2);
  CHECK(run({"solve", "--cells", "0"}) == 2);
  CHECK(run({"solve", "--cells", "2.5"}) == 2);
  CHECK(run({"solve", "--rail", "9"}) == 2);
  CHECK(run({"solve", "--unknown"}) == 2);
  CHECK(run({}) == 2);
  CHECK(run({"--help"}) == 0);
}
