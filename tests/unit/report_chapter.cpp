#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/chapter.hpp"

using namespace railbook;
namespace fs = std::filesystem;

namespace {

// A folder that is gone when the test ends.
struct Scratch {
  fs::path path = fs::temp_directory_path() / ("railbook-report-" + std::to_string(::getpid()));
  Scratch() { fs::create_directories(path / "data"); }
  ~Scratch() { fs::remove_all(path); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream{path / name} << text;
  }
};

int run(report::Chapter& chapter, std::vector<std::string> words) {
  words.insert(words.begin(), "sample");
  std::vector<char*> argv;
  for (auto& w : words) argv.push_back(w.data());
  return chapter.run(static_cast<int>(argv.size()), argv.data());
}

nlohmann::json record(const fs::path& out) {
  std::ifstream stream{out / "results" / "00-sample.json"};
  return nlohmann::json::parse(stream);
}

struct Sample {
  Scratch scratch;
  report::Chapter chapter{{"00-sample", "sample", "A sample", "Nobody, 1975", scratch.path}};
  std::vector<std::string> reproduce(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"reproduce", "--no-timings", "--out", scratch.path.string()};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

}  // namespace

TEST_CASE("unit: a chapter checks printed rows and leaves a record") {
  Sample s;
  s.scratch.write("data/t.csv",
                  "key,what,unit,printed\np0,peak pressure,psi,39 240\nm,moment,N.m,806.2\n");
  s.chapter.table("table-1", "One", [](report::Item& item) {
    const auto t = item.printed("t.csv");
    item.expect_checks(2);
    item.row(t, "p0").check("printed", 39315.4, report::relative(0.006, "coarse cells"));
    item.row(t, "m").check("printed", 606.2, report::misprint(606.16, 1e-3, "5365 in.lbf"));
    item.value("p0", 39315.4, "psi", "{:.0f}");
  });
  s.chapter.figure("fig-1", "Two", [](report::Item& item) {
    item.data({"x_m", "y"}).add(1.0, "a,b");
    item.sketch();
  });
  REQUIRE(run(s.chapter, s.reproduce({"--no-figures"})) == 0);
  const auto r = record(s.scratch.path);
  CHECK(r["checks"][0]["id"] == "table-1/p0-printed");
  CHECK(r["checks"][0]["status"] == "explained");
  CHECK(r["checks"][0]["what"] == "peak pressure, printed");
  CHECK(r["checks"][1]["status"] == "misprint");
  CHECK(r["items"][0]["verdict"] == "explained");
  CHECK(r["items"][1]["verdict"] == "sketch");
  CHECK(r["values"][0]["text"] == "39315 psi");
  std::ifstream csv{s.scratch.path / "results/00-sample/fig-1.csv"};
  CHECK(std::string{std::istreambuf_iterator<char>{csv}, {}} == "x_m,y\n1,\"a,b\"\n");
}

TEST_CASE("extreme: NaN, an empty loop and a missing count fail the chapter") {
  const auto status = [](const report::Chapter::ItemFunction& f) {
    Sample s;
    s.chapter.table("t", "T", f);
    return run(s.chapter, s.reproduce());
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(status([](report::Item& i) { i.expect_checks(1), i.check("a", "a", "", "1.0", 1.04); }) ==
        0);
  CHECK(status([=](report::Item& i) { i.expect_checks(1), i.check("a", "a", "", "1.0", nan); }) ==
        1);
  CHECK(status([](report::Item& i) { i.expect_checks(1); }) == 1);  // loop over nothing
  CHECK(status([](report::Item& i) { i.check("a", "a", "", "1.0", 1.0); }) ==
        1);                                  // count not announced
  CHECK(status([](report::Item&) {}) == 1);  // says nothing
  CHECK(status([](report::Item&) { throw std::runtime_error{"no"}; }) == 1);
  CHECK(status([](report::Item& i) { i.expect_checks(0), i.reconstructed("inputs are ours"); }) ==
        0);
  CHECK(status([](report::Item& i) {
          i.expect_checks(1), i.check("a", "a", "", "1", 1, report::relative(1, ""));
        }) == 1);
}

TEST_CASE("unit: the bite test passes only when every check fails") {
  Sample s;
  s.chapter.table("t", "T", [](report::Item& item) {
    item.expect_checks(3);
    item.check("a", "a", "", "1.0", 1.04);
    item.check_text("b", "b", "class 5", "class 5");
    item.agree("c", "c", "", 2.0, 2.0 + 1e-13, 1e-12, "another method");
  });
  CHECK(run(s.chapter, s.reproduce()) == 0);
  CHECK(run(s.chapter, s.reproduce({"--bite"})) == 0);
  Sample none;
  none.chapter.table("t", "T", [](report::Item& item) { item.sketch(); });
  CHECK(run(none.chapter, none.reproduce({"--bite"})) == 1);
}

TEST_CASE("unit: --only computes just what is asked for") {
  Sample s;
  bool other = false;
  s.chapter.table("t", "T", [](report::Item& item) { item.sketch(); });
  s.chapter.table("u", "U", [&](report::Item& item) { other = true, item.sketch(); });
  CHECK(run(s.chapter, s.reproduce({"--only", "t"})) == 0);
  CHECK_FALSE(other);
  CHECK(record(s.scratch.path)["only"][0] == "t");
  CHECK(run(s.chapter, s.reproduce({"--only", "v"})) == 2);
}

TEST_CASE("input: a chapter without a command is refused, help is not") {
  Sample s;
  CHECK(run(s.chapter, {}) == 2);
  CHECK(run(s.chapter, {"--help"}) == 0);
}
