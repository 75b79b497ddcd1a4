#include <railbook/tool/detail/toml.hpp>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;
using Texts = std::vector<std::string>;

TEST_CASE("input: a TOML file of options is read with its lines") {
  const TemporaryFolder scratch("toml");
  scratch.write("a.toml",
                "\xEF\xBB\xBF# a comment\r\nload = \"80kN\" # more\r\n mu=0.3\ncells-x = 127\n\n"
                "[body-1] # the rail\nprofile = 'C:\\rail #1, new.csv'\nx.y = true\n"
                "[a.b]\nwheels = [ \"0in\", # first\n\n  '66in',\n 72in ]\nname = \"it's mine\"\n"
                "none = \"\"");
  const auto all = tool::read_toml(scratch.path / "a.toml");
  const std::pair<std::string, Texts> expected[] = {
      {"load", {"80kN"}},          {"mu", {"0.3"}},
      {"cells-x", {"127"}},        {"body-1-profile", {"C:\\rail #1, new.csv"}},
      {"body-1-x-y", {"true"}},    {"a-b-wheels", {"0in", "66in", "72in"}},
      {"a-b-name", {"it's mine"}}, {"a-b-none", {""}}};
  const std::size_t lines[] = {2, 3, 4, 7, 8, 10, 14, 15};
  REQUIRE(all.size() == std::size(lines));
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i].name == expected[i].first);
    CHECK(all[i].inputs == expected[i].second);
    CHECK(all[i].line == lines[i]);
  }
}

TEST_CASE("input: a TOML file that is none is refused with file and line") {
  const TemporaryFolder scratch("toml");
  const std::pair<const char*, const char*> bad[] = {
      {"column = \"profile", "is no value"},
      {"column = profile\"", "is no value"},
      {"column = 'profile", "is no value"},
      {"column 'a'", "lacks \"= VALUE\""},
      {"column", "lacks \"= VALUE\""},
      {"= 3", "lacks a key"},
      {"a = # none", "lacks \"= VALUE\""},
      {"a = \"x\" y", "more than one value"},
      {"a = 80 kN", "more than one value"},
      {"a = [1, 2", "an array that is not closed"},
      {"a = [1 2\nb = 3", "an array that is not closed"},
      {"a = [[1]]", "is no value"},
      {"a = {b = 1}", "is no value"},
      {"a = \"\"\"x\"\"\"", "is no value"},
      {"[[a]]", "is no [table]"},
      {"[a", "is no [table]"},
      {"[a] b = 1", "is no [table]"},
      {"a = 1\na = 2", "\"a\" is given again; the first is in line 2"},
      {"[t]\na = 1\n[s]\n[t]\na = 2", "\"t-a\" is given again; the first is in line 3"},
      {"a = \"\\x\"", "an escape"},
      {"a = '\"x y\"'", "quotes within quotes"},
      {"a = \"\x1b[2J", "\\x1b"}};
  for (const auto& [text, why] : bad) {
    scratch.write("b.toml", std::string{"\n"} + text + "\n");
    INFO(text);
    CHECK_THROWS_WITH(tool::read_toml(scratch.path / "b.toml"),
                      Contains("b.toml\", line ") && Contains(why));
  }
  scratch.write("zero.toml", std::string("a = 1\nb = \0 2", 13));
  CHECK_THROWS_WITH(tool::read_toml(scratch.path / "zero.toml"),
                    Contains("line 2: ") && Contains("a zero byte"));
  CHECK_THROWS_WITH(tool::read_toml(scratch.path), Contains("Is a directory"));
  CHECK_THROWS_WITH(tool::read_toml(scratch.path / "c.toml"), Contains("No such file"));
}
