// The data and the pictures of an item.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <system_error>

#include "support/sample_chapter.hpp"
#include "support/set_variable.hpp"

using namespace railbook;

namespace {

// In place of gnuplot: a PNG and an SVG of so many bytes.
std::string stand_in(const TemporaryFolder& at, int png, int svg) {
  const auto file = at.write(
      "gnuplot", "#!/bin/sh\nfor a; do case $a in\nout.png) printf '\\211PNG\\r\\n\\032\\n%0" +
                     std::to_string(png - 16) +
                     "dIEND\\256\\102\\140\\202' 0 > $a;;\nout.svg) printf '<svg >\\n%0" +
                     std::to_string(svg) + "d\\n</svg>\\n' 0 > $a;;\nesac; done\n");
  chmod(file.c_str(), 0700);
  return file.string();
}

}  // namespace

TEST_CASE(
    "unit: data are rows under a header, with what is reported of their accuracy at the end") {
  report::Data data("d.csv", {"x_m", "a,b"});
  data.holds_to("x_m", 1e-3, 1e-9, "cancellation").not_compared("times");
  data.add(0.1, "one");
  data.add(2.0, std::string{"two, three"});
  data.gap();
  data.add(1.0 / 3, "four");
  CHECK(data.file() == "d.csv");
  CHECK(data.text() ==
        "x_m,\"a,b\"\n0.1,one\n2,\"two, three\"\n\n0.33333333,four\n"
        "# holds to relative 0.001, absolute 1e-09 in x_m: cancellation\n# not compared: times\n");
  CHECK_THROWS_WITH(data.add(1.0), "d.csv: 1 cells for 2 columns");
  CHECK_THROWS_WITH(data.not_compared(""), "d.csv: not compared, without a reason");
  CHECK_THROWS_WITH(data.holds_to("x_m", 1, 1, ""), "d.csv: an accuracy without a reason");
}

TEST_CASE("unit: a figure that is drawn by the chapter itself stands among the figures") {
  const Sample s;
  const auto drawn = [](const std::function<void(const std::filesystem::path&)>& image) {
    return report::Section{report::figure("fig-1", "F", [=](report::Item& item) {
      item.sketch();
      item.image(image);
    })};
  };
  REQUIRE(s.reproduce(drawn([](const auto& png) { std::ofstream{png} << "drawn"; })) == 0);
  CHECK(s.at.read("figures/00-sample/fig-1.png") == "drawn");
  CHECK(s.record()["items"][0]["png"] == "fig-1.png");
  CHECK(s.record()["items"][0]["script"].dump() == R"("")");
  CHECK_FALSE(s.record()["items"][0].contains("not_drawn"));

  const auto throws = [&](std::errc code) {
    return drawn([=](const auto&) { throw std::system_error{std::make_error_code(code), "GL"}; });
  };
  CHECK(s.reproduce(throws(std::errc::function_not_supported)) == 0);
  CHECK(s.record()["items"][0]["png"].dump() == R"("")");
  CHECK(s.record()["items"][0]["not_drawn"] == "GL: Function not implemented");
  CHECK(s.reproduce(throws(std::errc::io_error)) == 1);
  CHECK(s.record()["items"][0]["failure"] == "GL: Input/output error");
  CHECK(s.record()["items"][0]["png"].dump() == R"("")");
}

TEST_CASE("unit: beside its picture a figure has the same as SVG where that is the smaller file") {
  const SetVariable gnuplot("RAILBOOK_GNUPLOT");
  const report::Section paper{report::figure("fig-1", "F", [](report::Item& item) {
    item.sketch();
    item.data({"x"}).add(1.0);
    item.data("more", {"y"}).add(2.0);
  })};
  const Sample s;
  s.at.write("fig-1.gp", "");
  const auto figures = s.at.path / "figures/00-sample";
  const auto bytes = [&](const char* name) {
    return std::filesystem::exists(figures / name) ? std::filesystem::file_size(figures / name) : 0;
  };
  gnuplot.to(stand_in(s.at, 1000, 100).c_str());
  REQUIRE(s.reproduce(paper) == 0);
  const auto around = bytes("fig-1.svg") - 100;  // of the SVG, what is not its content
  CHECK(bytes("fig-1.png") == 1000);
  CHECK(s.record()["items"][0]["csv"].dump() == R"(["fig-1.csv","fig-1-more.csv"])");
  CHECK(s.record()["items"][0]["script"] == "fig-1.gp");
  for (const int more : {0, 1}) {
    gnuplot.to(stand_in(s.at, 1000, static_cast<int>(1000 - around) + more).c_str());
    REQUIRE(s.reproduce(paper) == 0);
    CHECK(bytes("fig-1.svg") == (more == 0 ? 1000 : 0));
  }
  CHECK(s.at.read("results/00-sample.files") ==
        "figures/00-sample/fig-1.png\nresults/00-sample/checks.csv\n"
        "results/00-sample/fig-1-more.csv\nresults/00-sample/fig-1.csv\n");
  REQUIRE(s.reproduce(paper, {"--no-figures"}) == 0);
  CHECK(bytes("fig-1.png") == 0);
  CHECK(s.record()["items"][0]["png"].dump() == R"("")");
  CHECK(s.record()["items"][0]["script"] == "fig-1.gp");
  CHECK(s.at.read("results/00-sample/fig-1-more.csv") == "y\n2\n");
}

TEST_CASE("unit: a row of printed values says what it is about, with what its table says") {
  const Sample s;
  s.at.write("data/full.csv", "key,what,unit,printed,hertz\np0,peak,psi,39,40\nm,,kg,1,2\n");
  s.at.write("data/bare.csv", "key,printed,other\nx,3,4\n");
  REQUIRE(s.reproduce(one([](report::Item& item) {
    item.expect_checks(5);
    const auto full = item.printed("full.csv"), bare = item.printed("bare.csv");
    item.row(full, "p0").print("printed", 39);
    item.row(full, "p0").print("hertz", 40);
    item.row(full, "m").print("hertz", 2);
    item.row(bare, "x").print("printed", 3);
    item.row(bare, "x").publication("other", 4.01, report::relative(0.01, "digits"), "B. 1970");
    item.value("n", units::nan, "psi", "{:.0f}");
    item.value("x", 2.0 / 3, "", "{:.3f}");
    item.value("y", 2.0 / 3, "kg");
    item.value("w", "word");
  })) == 0);
  const auto r = s.record();
  const char* expected[][3] = {{"t/p0-printed", "peak", "psi"},
                               {"t/p0-hertz", "peak, hertz", "psi"},
                               {"t/m-hertz", "m, hertz", "kg"},
                               {"t/x-printed", "x", ""},
                               {"t/x-other", "x, other", ""}};
  for (std::size_t k = 0; k < 5; ++k) {
    CHECK(r["checks"][k]["id"] == expected[k][0]);
    CHECK(r["checks"][k]["what"] == expected[k][1]);
    CHECK(r["checks"][k]["unit"] == expected[k][2]);
  }
  CHECK(r["checks"][4]["by"] == "B. 1970");
  const char* texts[] = {"NaN psi", "0.667", "0.666667 kg", "word"};
  for (std::size_t k = 0; k < 4; ++k) CHECK(r["values"][k]["text"] == texts[k]);
}

TEST_CASE("unit: an item that fails says how many of what") {
  const auto why = [](const report::ItemFunction& f) {
    const Sample s;
    CHECK(s.reproduce(one(f)) == 1);
    return s.record()["items"][0]["failure"].get<std::string>();
  };
  CHECK(why([](auto& i) { i.expect_checks(3), i.claim("a", "a", true); }) ==
        "1 checks made, 3 announced");
  CHECK(why([](auto& i) { i.claim("a", "a", true), i.sketch(); }) == "1 checks made, 0 announced");
  CHECK(why([](auto& i) {
          i.expect_checks(2), i.claim("a", "a", true), i.claim("b", "b", false);
        }) == "1 of 2 checks failed");
  CHECK(why([](auto&) {}) == "no check, and not declared rebuilt, added, a sketch or lost");
  CHECK(why([](auto& i) { i.lost(""); }) == "t: lost without a reason");
  CHECK(why([](auto& i) {
          i.stability({"s", "w", "x"}, [] { return report::Found{}; });
        }) == "stability case s has no bound of its error");
}

TEST_CASE("unit: a stability case records its result, or the reason for none") {
  report::Item item{"s", "table", "S", {}};
  const auto found = [&](const std::function<report::Found()>& run) {
    item.stability({.id = "s", .what = "w", .stress = "x", .allowed = 1}, run);
  };
  found([] { return report::Found{"a number", 0.5}; });
  found([]() -> report::Found { throw InputError{"no width"}; });
  found([]() -> report::Found { throw report::NoAnswer{"no end"}; });
  found([]() -> report::Found { throw std::runtime_error{"no memory"}; });
  report::ChapterRecord record;
  item.finish(record);
  const char* expected[] = {"holds: a number", "refused: no width", "refused: no end",
                            "fails: no memory"};
  for (std::size_t k = 0; k < 4; ++k) {
    const report::Stability& s = record.stability[k];
    CHECK(s.found + ": " + s.result == expected[k]);
    CHECK(std::isnan(s.error) == (k > 0));
    CHECK(s.pass == (k == 0));
  }
}

TEST_CASE("unit: the error of a text or of a claim is none or one") {
  report::Item item{"t", "table", "T", {}};
  item.print_text("a", "class", "5", "5");
  item.print_text("b", "class", "5", "6");
  item.claim("c", "it holds", true);
  item.claim("d", "it holds", false);
  report::ChapterRecord record;
  item.finish(record);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(record.checks[k].error == static_cast<double>(k % 2));
    CHECK(record.checks[k].pass == (k % 2 == 0));
    CHECK(record.checks[k].kind == "exact");
  }
}
