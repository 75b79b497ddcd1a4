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

TEST_CASE(
    "input: strings of a TOML file hold what their escapes name, to the last character of "
    "Unicode") {
  const TemporaryFolder scratch("toml");
  const std::pair<const char*, std::string> values[] = {
      {"\"\"", ""},
      {"''", ""},
      {"\"\" # none", ""},
      {"'a\\n'", "a\\n"},
      {R"("\b\t\n\f\r\"\\")", "\b\t\n\f\r\"\\"},
      {R"("\u007f\u0080")", "\x7f\xC2\x80"},
      {R"("\u07FF\u0800")", "\xDF\xBF\xE0\xA0\x80"},
      {R"("\ud7ff\uE000")", "\xED\x9F\xBF\xEE\x80\x80"},
      {R"("\uffff\U00010000")", "\xEF\xBF\xBF\xF0\x90\x80\x80"},
      {R"("\U0010FFFF")", "\xF4\x8F\xBF\xBF"},
      {R"("\u0001")", "\x01"},
      {"3 \t # three", "3"},
      {"\t1e-7m^2*cycle/m", "1e-7m^2*cycle/m"}};
  for (const auto& [text, value] : values) {
    scratch.write("v.toml", std::string{"a = "} + text);
    INFO(text);
    const auto all = tool::read_toml(scratch.path / "v.toml");
    REQUIRE(all.size() == 1);
    CHECK(all[0].inputs == Texts{value});
  }
}

TEST_CASE("input: what is wrong with a TOML file is said in so many words") {
  const TemporaryFolder scratch("toml");
  const auto refused = [&](const std::string& text) {
    const std::string file = scratch.write("w.toml", text).string();
    const std::string begin = "file \"" + file + "\", line ";
    try {
      (void)tool::read_toml(file);
    } catch (const InputError& error) {
      CHECK(std::string{error.what()}.starts_with(begin));
      return std::string{error.what()}.substr(begin.size());
    }
    return std::string{};
  };
  for (const char* none : {R"(\u0000)", R"(\uD800)", R"(\udfff)", R"(\U00110000)"})
    CHECK(refused("a = \"" + std::string{none} + "\"") == "1: an escape \\u names no character");
  for (const char* cut : {R"(\u00g0)", R"(\u00)", R"(\U0001F68)"})
    CHECK(refused("\n\na = \"" + std::string{cut} + "\"") ==
          R"(3: an escape \u lacks its 4 hexadecimal digits, or \U its 8)");
  CHECK(refused("a = \"\\") == R"(1: an unknown escape after \; allowed: \b \t \n \f \r \" )"
                               R"(\\ \uXXXX \UXXXXXXXX)");
  CHECK(refused("a = 1\nb\n") == "2: \"the end of the line\" where \"=\" is due");
  CHECK(refused("a b = 1") == "1: \"b = 1\" where \"=\" is due");
  CHECK(refused("a. = 1") == "1: a key is missing before \"=\"");
  CHECK(refused("[a.]") == "1: a key is missing before \"]\"");
  CHECK(refused("a = [1,\n\n 2") == "3: an array is not closed");
  CHECK(refused("a = [1,, 2]") == "1: a value is missing");
  CHECK(refused("a = [[1]]") == "1: an array in an array");
  CHECK(refused("a = [1] 2") == "1: \"2\" where the line should end");
  CHECK(refused("a = [1 # x\n 2]") == "2: an array lacks a comma or its ]");
  CHECK(refused("a = 1\n[t]\nb = 2\n[t]\nb = 3") ==
        "5: \"t-b\" is given again; the first is in line 3");
  CHECK(refused(std::string("a = 1\nb = \0 2", 13)) == "2: holds a zero byte: not a text file");
  CHECK(refused("a = '''x'''") ==
        "1: a string over several lines; allowed: one in single quotes or \"...\"");
  CHECK(refused("a = 1\n\xEF\xBB\xBF") == "2: a key is missing before \"=\"");
}

TEST_CASE("input: keys of a TOML file are bare, quoted or dotted, and arrays go over lines") {
  const TemporaryFolder scratch("toml");
  scratch.write("k.toml",
                "A-z_09 = 1\n[t.\"u v\"]\n'x'.y = 2\n[s] # a table\nz=[ ]\n"
                "w=[1,\"2\"\n,# c\n3 4,\n]# end\n");
  const auto all = tool::read_toml(scratch.path / "k.toml");
  REQUIRE(all.size() == 4);
  const std::pair<std::string, Texts> expected[] = {
      {"A-z_09", {"1"}}, {"t-u v-x-y", {"2"}}, {"s-z", {}}, {"s-w", {"1", "2", "3 4"}}};
  const std::size_t lines[] = {1, 3, 5, 6};
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i].name == expected[i].first);
    CHECK(all[i].inputs == expected[i].second);
    CHECK(all[i].line == lines[i]);
  }
}
