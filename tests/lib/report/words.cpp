// The command line of a chapter: what it runs, what it says, how it ends.
#include <catch2/catch.hpp>

#include <railbook/files/outside.hpp>
#include <railbook/plot/plot.hpp>
#include <railbook/table/csv.hpp>

#include "support/apart.hpp"
#include "support/sample_chapter.hpp"

using namespace railbook;
using namespace Catch::Matchers;

namespace {

report::Section sketch() {
  return one([](report::Item& item) { item.sketch(); });
}

// A run in a process of its own: its exit status and what it says on a stream.
std::pair<int, std::string> said(int stream, const Sample& s, const report::Section& paper,
                                 const Sample::Words& words, const report::Section& study = {}) {
  auto [status, text] = apart(stream, [&] { return s.run(paper, words, study); });
  return {WEXITSTATUS(status), text};
}

}  // namespace

TEST_CASE("unit: a run says all that failed, and sums up in a line") {
  const Sample s;
  s.at.write("data/inventory.csv",
             "place,kind,number,what,treated,symbol,test,reason\n"
             "p. 1,number,Table 2,a,t/a t/z,,,\n"
             "p. 2,claim,,cost,,,,\n"
             "p. 3,equation,(4),law,,law.hpp law,,\n");
  const report::Section paper{
      report::table("t", "T",
                    [](report::Item& i) {
                      i.expect_checks(2);
                      i.print("a", "mass", "kg", "1.0", 1.04);
                      i.print("b", "speed", "m/s", "2.0", 2.5);
                    }),
      report::table("u", "U", [](report::Item& i) {
        i.stability({.id = "s",
                     .what = "line contact",
                     .stress = "x",
                     .expect = report::accurate,
                     .allowed = 1},
                    [] {
                      return report::Found{"far off", 2};
                    });
        i.stability({.id = "r", .what = "none", .stress = "x", .expect = report::refused},
                    []() -> report::Found { throw InputError{"no width"}; });
      })};
  const Sample::Words words{"reproduce", "--no-timings", "--out", s.at.path.string()};
  const auto [status, failures] = said(2, s, paper, words);
  CHECK(status == 1);
  CHECK(failures ==
        "FAILED t: 1 of 2 checks failed\n"
        "FAILED u: 1 of 2 stability cases failed\n"
        "  t/b (speed): print 2.0, computed 2.5 m/s; error 0.5, allowed 0.05 (last_digit)\n"
        "  stability s (line contact): expected holds, found fails: far off; error 2, allowed 1\n"
        "  inventory: p. 1 number Table 2 \"a\": no check or item t/z\n"
        "  inventory: p. 2 claim  \"cost\": neither treated nor left out for a reason\n"
        "  inventory: t/b: a check of the paper that no row names\n");
  const std::string summary =
      "00-sample: 1 confirmed, 1 failed; checks 1/2, stability 1/2; 0.0 s\n";
  CHECK(said(1, s, paper, words).second == summary);
  CHECK(s.at.read("results/00-sample.txt") == summary);
  CHECK(s.record()["stability"][1]["result"] == "no width");
  const auto [good, none] = said(2, s, sketch(), words);
  CHECK(good == 1);  // its inventory names what is not there
  CHECK_THAT(none, StartsWith("  inventory: "));
  CHECK(said(1, s, sketch(),
             {"reproduce", "--no-timings", "--only", "t", "--out", s.at.path.string()}) ==
        std::pair{0, std::string{"00-sample: no checks; checks 0/0, stability 0/0; 0.0 s\n"}});
}

TEST_CASE("unit: --only computes just what is asked for") {
  const Sample s;
  bool other = false;
  const report::Section paper{
      report::table("t", "T", [](report::Item& item) { item.sketch(); }),
      report::table("u", "U", [&](report::Item& item) { other = true, item.sketch(); })};
  CHECK(s.reproduce(paper, {"--only", "t"}) == 0);
  CHECK_FALSE(other);
  CHECK(s.record()["only"].dump() == R"(["t"])");
  CHECK(said(2, s, paper, {"reproduce", "--only", "t,v"}) ==
        std::pair{
            2, std::string{"sample: only is \"v\"; allowed: a name that `sample list` shows\n"}});
}

TEST_CASE("input: a chapter without a command or with a wrong one is refused, help is not") {
  const Sample s;
  CHECK(s.run(sketch(), {}) == 2);
  CHECK(s.run(sketch(), {"--help"}) == 0);
  CHECK(s.run({sketch()[0], sketch()[0]}, {"list"}) == 1);            // an item named twice
  CHECK(s.run({}, {"reproduce", "--out", s.at.path.string()}) == 1);  // nothing to compute
  const auto [status, words] = said(2, s, sketch(), {"reproduce", "--level", "high"});
  CHECK(status == 2);
  CHECK_THAT(words, StartsWith("sample: --level: ") && EndsWith("\nTry `sample --help`.\n"));
  CHECK_THAT(said(1, s, sketch(), {"--version"}).second, StartsWith("sample ") && EndsWith("\n"));
}

TEST_CASE(
    "unit: a figure that gnuplot does not draw fails its item, a disk that fails ends the run") {
  const Sample s;
  int computed = 0;
  const report::Section paper{
      report::figure("f", "F", [](report::Item& item) { item.sketch(), item.data({"x"}); }),
      report::table("t", "T", [&](report::Item& item) { ++computed, item.sketch(); })};
  CHECK(s.reproduce(paper) == 3);  // there is no f.gp
  CHECK(computed == 1);
  CHECK_THAT(s.record()["items"][0]["failure"].get<std::string>(), EndsWith("f.gp does not exist"));
  CHECK(s.record()["items"][0]["png"].dump() == R"("")");
  CHECK(s.record()["items"][1]["failure"].dump() == R"("")");
  CHECK(s.reproduce({paper[1], paper[0]}) == 3);
  CHECK(s.reproduce(
            {report::table("u", "U", [](report::Item&) { throw files::OutsideError{"disk full"}; }),
             paper[1]}) == 3);
  CHECK(computed == 2);
  CHECK_FALSE(std::filesystem::exists(s.at.path / "results" / "00-sample.json"));
}

TEST_CASE("unit: an installed chapter finds its sources among what was installed") {
  Sample s;
  s.info.id = "08-wheel-on-rail";
  s.info.sources = "/nowhere";
  const auto data = plot::shared("chapters/08-wheel-on-rail") / "data";
  report::Section items;
  for (const auto& row : table::read_table(data / "captions.csv").rows)
    items.push_back(report::table(row[0], [&](report::Item& item) {
      item.sketch();
      CHECK(std::filesystem::equivalent(item.sources() / "data", data));
    }));
  CHECK(s.reproduce(items, {"--only", items[0].id}) == 0);
}
