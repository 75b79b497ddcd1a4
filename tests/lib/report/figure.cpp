// The data and the pictures of an item.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <functional>
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
