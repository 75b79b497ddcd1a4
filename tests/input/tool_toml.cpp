#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "../support/temporary_folder.hpp"
#include "tool/toml.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using Catch::Matchers::Contains;
using Texts = std::vector<std::string>;

TEST_CASE("input: a TOML file of options is read with its lines") {
  const TemporaryFolder scratch("toml");
  scratch.write("a.toml",
                "\xEF\xBB\xBF# a comment\r\nload = \"80kN\" # more\r\n mu=0.3\ncells-x = 127\n\n"
                "[body-1] # the rail\nprofile = 'C:\\rail #1.csv'\n\"young\".x = true\n"
                "[ a . \"b\" ]\nbare = 80 kN # with a unit\n"
                "wheels = [ \"0in\", # first\n\n  '66in',\n 72 in ,\n]\nnone = []\n"
                "odd = \"\\\"q\\\" \\u00e9 \\U0001F682 \\\\\"");
  const auto all = tool::read_toml(scratch.path / "a.toml");
  REQUIRE(all.size() == 9);
  CHECK(all[0].name == "load");
  CHECK(all[0].line == 2);
  CHECK(all[0].inputs == Texts{"80kN"});
  CHECK(all[1].inputs == Texts{"0.3"});
  CHECK(all[2].name == "cells-x");
  CHECK(all[3].name == "body-1-profile");
  CHECK(all[3].inputs == Texts{"C:\\rail #1.csv"});
  CHECK(all[4].name == "body-1-young-x");
  CHECK(all[5].name == "a-b-bare");
  CHECK(all[5].inputs == Texts{"80 kN"});
  CHECK(all[6].inputs == Texts{"0in", "66in", "72 in"});
  CHECK(all[6].line == 11);
  CHECK(all[7].inputs.empty());
  CHECK(all[8].inputs == Texts{"\"q\" \xC3\xA9 \xF0\x9F\x9A\x82 \\"});
}

TEST_CASE("input: a TOML file that is none is refused with file and line") {
  const TemporaryFolder scratch("toml");
  const std::pair<const char*, const char*> bad[] = {
      {"column = \"profile", "the quote of \"profile is not closed"},
      {"column = profile\"", "has a quote that is not opened"},
      {"column 'a'", "where \"=\" is due"},
      {"= 3", "a key is missing"},
      {"a = ", "a value is missing"},
      {"a = # none", "a value is missing"},
      {"a = \"x\" y", "where the line should end"},
      {"a = [1, 2", "an array is not closed"},
      {"a = [1 2\nb = 3", "an array"},
      {"a = [\"1\" \"2\"]", "an array lacks a comma"},
      {"a = {b = 1}", "an inline table"},
      {"a = \"\"\"x\"\"\"", "a string over several lines"},
      {"[[a]]", "an array of tables"},
      {"[a", "where \"]\" is due"},
      {"[a] b = 1", "where the line should end"},
      {"a = 1\na = 2", "\"a\" is given again; the first is in line 2"},
      {"a = \"\\x\"", "an unknown escape"},
      {"a = \"\\u12\"", "hexadecimal"},
      {"a = \"\\ud800\"", "no character"},
      {"a = \"\x1b[2J", "\\x1b"},
      {"$HOME = 1", "a key is missing"}};
  for (const auto& [text, why] : bad) {
    scratch.write("b.toml", std::string{"\n"} + text + "\n");
    INFO(text);
    CHECK_THROWS_WITH(tool::read_toml(scratch.path / "b.toml"),
                      Contains("b.toml\", line ") && Contains(why));
  }
  CHECK_THROWS_WITH(tool::read_toml(scratch.path), Contains("Is a directory"));
  CHECK_THROWS_WITH(tool::read_toml(scratch.path / "c.toml"), Contains("No such file"));
}
