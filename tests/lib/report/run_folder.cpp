#include <railbook/report/run_folder.hpp>

#include <catch2/catch.hpp>

#include <railbook/files/out_file.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

const std::string chapter = "01-contact";

// A run that writes one table and one figure, and then its record if it lives that long.
void run(const std::filesystem::path& out, bool anew, const std::string& figure, bool to_the_end) {
  report::RunFolder folder(out, chapter, anew);
  folder.forget_record();
  for (const auto& file : {folder.results() / "checks.csv", folder.figures() / figure}) {
    folder.announce(file);
    files::write(file, figure);
  }
  if (to_the_end) files::write(folder.record(), "{\"chapter\": \"01-contact\", \"items\": []}");
}

}  // namespace

TEST_CASE("input: a run replaces what runs made, and nothing else") {
  const TemporaryFolder at("run");
  run(at.path, true, "fig-01.png", true);
  run(at.path, true, "fig-02.png", true);
  CHECK_FALSE(std::filesystem::exists(at.path / "figures" / chapter / "fig-01.png"));
  run(at.path, false, "fig-03.png", true);  // some items only: the others stay, and stay known
  CHECK(std::filesystem::exists(at.path / "figures" / chapter / "fig-02.png"));
  run(at.path, true, "fig-04.png", true);
  CHECK(at.files_in(at.path / "figures" / chapter) == 1);

  const auto mine = at.path / "figures" / chapter / "holiday.png";
  files::write(mine, "mine");
  CHECK_THROWS_WITH(run(at.path, true, "fig-05.png", true),
                    Contains("holiday.png") && Contains("no earlier run"));
  CHECK(std::filesystem::exists(mine));
  CHECK(std::filesystem::exists(at.path / "figures" / chapter / "fig-04.png"));
  CHECK(std::filesystem::exists(at.path / "results" / (chapter + ".json")));
  CHECK_THROWS_WITH(run(at.path, false, "holiday.png", true), Contains("holiday.png"));
}

TEST_CASE("input: a run that was ended leaves no record, and does not bar the next") {
  const TemporaryFolder at("ended");
  run(at.path, true, "fig-01.png", true);
  run(at.path, true, "fig-02.png", false);
  CHECK_FALSE(std::filesystem::exists(at.path / "results" / (chapter + ".json")));
  run(at.path, true, "fig-03.png", true);
  CHECK(at.files_in(at.path / "figures" / chapter) == 1);
}

TEST_CASE("input: a folder of figures of somebody else stays whole") {
  const TemporaryFolder at("golden");
  files::write(at.path / "figures" / chapter / "fig-01.png", "golden");
  for (const bool anew : {true, false})
    CHECK_THROWS_WITH(run(at.path, anew, "fig-01.png", true), Contains("fig-01.png"));
  CHECK(at.read("figures/" + chapter + "/fig-01.png") == "golden");
  files::write(at.path / "other" / "results" / (chapter + ".json"), "{\"my\": \"notes\"}");
  CHECK_THROWS_WITH(run(at.path / "other", true, "fig-01.png", true), Contains(".json"));
  CHECK_THROWS_AS(run(at.path / "figures" / chapter / "fig-01.png", true, "fig-01.png", true),
                  InputError);
}

TEST_CASE("input: what an earlier edition's record names is replaced") {
  const TemporaryFolder at("record");
  files::write(at.path / "figures" / chapter / "fig-01.png", "old");
  files::write(at.path / "figures" / chapter / "fig-01.svg", "old");
  files::write(at.path / "results" / chapter / "fig-01.csv", "old");
  files::write(at.path / "results" / (chapter + ".json"),
               "{\"chapter\": \"01-contact\", \"items\": [{\"id\": \"fig-01\", \"png\": "
               "\"fig-01.png\", \"csv\": "
               "[\"fig-01.csv\"]}, {\"png\": \"../../../precious\"}]}");
  run(at.path, true, "fig-02.png", true);
  CHECK(at.files_in(at.path / "figures" / chapter) == 1);
  CHECK_FALSE(std::filesystem::exists(at.path / "results" / chapter / "fig-01.csv"));
}

TEST_CASE("input: a damaged record of the chapter does not stop a new run") {
  const TemporaryFolder at("names");
  run(at.path, true, "fig-01.png", true);
  files::write(
      at.path / "results" / (chapter + ".json"),
      R"({"chapter": "01-contact", "items": [7, {"id": 3, "png": null, "csv": [1, null]}, {}]})");
  CHECK_NOTHROW(run(at.path, true, "fig-02.png", true));
  for (const char* text : {"{\"chapter\": 1}", "[]", "{", "{\"chapter\": \"02-hunting\"}"}) {
    files::write(at.path / "results" / (chapter + ".json"), text);
    CHECK_THROWS_WITH(run(at.path, true, "fig-03.png", true), Contains("no earlier run"));
  }
}

TEST_CASE("input: a link in the place of a file that a run made is somebody else's") {
  const TemporaryFolder at("link");
  run(at.path, true, "fig-01.png", true);
  const auto figure = at.path / "figures" / chapter / "fig-01.png";
  std::filesystem::remove(figure);
  std::filesystem::create_symlink(at.write("precious", "mine"), figure);
  CHECK_THROWS_WITH(run(at.path, true, "fig-01.png", true),
                    Contains("fig-01.png\": no earlier run"));
  CHECK(at.read("precious") == "mine");
}

TEST_CASE("input: the list of what runs made is of the last whole run") {
  const TemporaryFolder at("list");
  const auto list = [&] { return at.read("results/" + chapter + ".files"); };
  run(at.path, true, "fig-01.png", true);
  files::write(at.path / "results" / (chapter + ".txt"), "summary");
  run(at.path, false, "fig-02.png", false);
  CHECK_FALSE(std::filesystem::exists(at.path / "results" / (chapter + ".txt")));
  CHECK(list() ==
        "figures/01-contact/fig-01.png\nfigures/01-contact/fig-02.png\nresults/01-contact/"
        "checks.csv\n");
  run(at.path, true, "fig-03.png", true);
  CHECK(list() == "figures/01-contact/fig-03.png\nresults/01-contact/checks.csv\n");
  CHECK_THROWS_WITH(report::RunFolder("", chapter, true),
                    "out is empty; allowed: the name of a folder");
}
