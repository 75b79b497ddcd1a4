#include <railbook/tool/out_folder.hpp>

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include <railbook/tool/session.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

TEST_CASE("unit: a folder of results comes whole, and without a name nothing is written") {
  const TemporaryFolder at("out");
  tool::OutFolder out({at.path / "mine"}, {"a.csv", "a.png"});
  REQUIRE(out);
  const auto script =
      at.write("a.gp", "load \"style.gp\"\nset output ARG2\nplot ARG1 using 1:2, ARG3 using 1:2\n");
  out.add("a.csv", "x,y\n1,1\n2,3\n");
  out.scratch("none.csv", "x,y\n");  // a curve without a point is left out
  out.figure(script, {"a.csv", "none.csv"}, "a.png");
  CHECK_FALSE(std::filesystem::exists(at.path / "mine" / "a.csv"));
  out.commit();
  CHECK(at.files_in(at.path / "mine") == 2);
  CHECK(TemporaryFolder::size(at.path / "mine" / "a.png") > 3000);
  tool::OutFolder plain({at.path / "plain", true}, {"a.csv", "a.png"});  // without figures
  plain.add("a.csv", "x,y\n");
  plain.figure(at.path / "none.gp", {"a.csv"}, "a.png");
  plain.commit();
  CHECK(at.files_in(at.path / "plain") == 1);
  tool::OutFolder nothing({}, {"a.csv"});
  CHECK_FALSE(nothing);
  CHECK_NOTHROW(nothing.commit());
}

TEST_CASE("input: a folder of results refuses first, and leaves nothing") {
  const TemporaryFolder at("out-refused");
  const auto refused = [&](const std::filesystem::path& folder) -> std::string {
    try {
      tool::OutFolder out({folder}, {"a.csv", "b.csv"});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(refused(""), Contains("out is empty"));
  CHECK_THAT(refused("-"), Contains("standard output"));
  CHECK_THAT(refused(at.write("file", "")), Contains("Not a directory"));
  CHECK_THAT(refused(at.path / "file" / "below"), Contains("Not a directory"));
  std::filesystem::create_directories(at.path / "made" / "b.csv");
  CHECK_THAT(refused(at.path / "made"), Contains("b.csv") && Contains("it is a folder"));
  CHECK(at.files_in(at.path / "made") == 1);
  std::filesystem::create_directory_symlink(at.path / "made", at.path / "link");
  CHECK_THAT(refused(at.path / "link"), Contains("symbolic link"));
  { tool::OutFolder out({at.path / "p" / "q"}, {"a.csv"}); }
  CHECK_FALSE(std::filesystem::exists(at.path / "p"));
}

TEST_CASE("input: a figure that fails takes the other files with it") {
  const TemporaryFolder at("out-figure");
  const auto script = at.write("a.gp", "set output ARG2\nplot nonsense(\n");
  {
    tool::OutFolder out({at.path / "mine"}, {"a.csv", "a.png"});
    out.add("a.csv", "x,y\n1,1\n");
    CHECK_THROWS_AS(out.figure(script, {"a.csv"}, "a.png"), files::OutsideError);
    CHECK_THROWS_AS(out.add("other.csv", ""), std::logic_error);
    CHECK_THROWS_AS(out.add("a.csv", ""), std::logic_error);
  }
  CHECK_FALSE(std::filesystem::exists(at.path / "mine"));
}

TEST_CASE("input: the first figure alone goes where --figure says, and nothing else") {
  const TemporaryFolder at("out-alone");
  const auto script = at.write("a.gp", "load \"style.gp\"\nset output ARG2\nplot ARG1 using 1:2\n");
  const auto refused = [](const tool::Destination& to) -> std::string {
    try {
      tool::OutFolder out(to, {"a.csv"});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(refused({at.path / "x", false, at.path / "a.png"}) ==
        "figure is given with out; allowed: one of them");
  CHECK(refused({{}, true, at.path / "a.png"}) ==
        "figure is given with no-figures; allowed: one of them");
  tool::session() = {};
  tool::session().json = true;
  CHECK(refused({{}, false, "-"}) ==
        "figure is - with json; allowed: one answer on standard output");
  CHECK(refused({{}, false, at.path / "a.png"}).empty());
  CHECK_FALSE(tool::session().taken);
  tool::session() = {};
  CHECK(refused({{}, false, "-"}).empty());
  CHECK(tool::session().taken);
  tool::session() = {};
  {
    tool::OutFolder out({{}, false, at.path / "one.png"}, {"a.csv", "b.csv", "a.png", "b.png"});
    CHECK(out);
    out.add("a.csv", "x,y\n1,1\n2,3\n");
    out.add("b.csv", "x,y\n1,1\n2,3\n3,0\n");
    CHECK_THROWS_WITH(out.commit(), "figure is given, but there is nothing to draw");
    out.figure(script, {"a.csv"}, "a.png");
    out.figure(at.path / "none.gp", {"b.csv"}, "b.png");  // is not asked for
    out.commit();
  }
  CHECK(at.files_in(at.path) == 2);  // the script and the picture
  CHECK(TemporaryFolder::size(at.path / "one.png") > 3000);
  CHECK(refused({"-"}) ==
        "out is \"-\", standard output; allowed: the name of a folder (./- for one called -)");
  CHECK(refused({""}) == "out is empty; allowed: the name of a folder");
}

TEST_CASE("input: a folder of results takes each file that was announced, once") {
  const TemporaryFolder at("out-once");
  tool::OutFolder out({at.path / "mine"}, {"a.csv", "b.csv"});
  out.stream("a.csv").write("1\n");
  CHECK_THROWS_WITH(out.stream("a.csv"), "file a.csv was not announced, or is there already");
  CHECK_THROWS_WITH(out.add("c.csv", ""), "file c.csv was not announced, or is there already");
  out.add("b.csv", "2\n");
  out.commit();
  CHECK(at.read("mine/a.csv") == "1\n");
  CHECK(at.read("mine/b.csv") == "2\n");
}
