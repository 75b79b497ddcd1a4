#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "../support/temporary_folder.hpp"
#include "tool/out_folder.hpp"
#include "units/input_error.hpp"

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
