// What gnuplot is given and what is made of what it says, seen through a program that stands in for
// it.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include <railbook/plot/plot.hpp>

#include "support/apart.hpp"
#include "support/set_variable.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

// In place of gnuplot for its life: writes its arguments, its environment and the scripts beside
// itself, says `words` on stderr, leaves `picture` (printf's text) as its output and does `then`.
struct StandIn {
  explicit StandIn(const std::string& words = "", const std::string& picture = whole_png,
                   const std::string& then = "exit 0")
      : at("stand-in") {
    const std::string here = at.path.string();
    const auto fake =
        at.write("gnuplot", "#!/bin/sh\necho \"$@\" > '" + here + "/arguments'\nenv > '" + here +
                                "/environment'\ncp script.gp style.gp '" + here + "'\nprintf '" +
                                words + "' >&2\nfor a in \"$@\"; do case $a in out.*) printf '" +
                                picture + "' > $a;; esac; done\n" + then + "\n");
    std::filesystem::permissions(fake, std::filesystem::perms(0700));
    program.to(fake.c_str());
    data = at.write("data.csv", "x\n1\n");
    second = at.write("second.png", "picture");
  }
  std::string script(const std::string& text) {
    (void)plot::draw(at.write("fig.gp", text), {data});
    return at.read("script.gp");
  }
  static constexpr const char* whole_png = "\\211PNG\\r\\n\\032\\n....IEND\\256\\102\\140\\202";
  SetVariable program{"RAILBOOK_GNUPLOT"};
  TemporaryFolder at;
  std::filesystem::path data, second;
};

}  // namespace

TEST_CASE(
    "unit: gnuplot sees neutral names, its output after the first file, and no settings of the "
    "user") {
  StandIn gnuplot;
  const SetVariable lib("GNUPLOT_LIB"), numeric("LC_NUMERIC"), language("LANGUAGE"),
      kept("RAILBOOK_TEST_KEPT");
  lib.to("mine"), numeric.to("de_DE"), language.to("de"), kept.to("kept");
  const auto script = gnuplot.at.write("fig.gp", "plot ARG1\n");
  (void)plot::draw(script, {gnuplot.data, gnuplot.second, gnuplot.data});
  CHECK(gnuplot.at.read("arguments") == "-d -c script.gp d1.csv out.png d2.png d3.csv\n");
  const std::string seen = gnuplot.at.read("environment");
  CHECK_THAT(seen, !Contains("GNUPLOT_LIB=") && !Contains("LC_NUMERIC") && !Contains("LANGUAGE"));
  CHECK_THAT(
      seen, Contains("LC_ALL=C.UTF-8") && Contains("RAILBOOK_TEST_KEPT=kept") && Contains("PATH="));
  CHECK_NOTHROW(plot::draw(script, std::vector(8, gnuplot.data)));
}

TEST_CASE("unit: a script's sizes are doubled, be they expressions, and nothing else of it") {
  StandIn gnuplot;
  CHECK(gnuplot.script("a = 1\nset terminal pngcairo size 900,400\nplot x\n") ==
        "a = 1\nset terminal pngcairo size 2*(900),2*(400) fontscale 2 linewidth 2 pointscale "
        "2\nplot x\n");
  CHECK(gnuplot.script("set terminal pngcairo size max(9, 8),(4 + (1, 2)) font \"X,15\"\n") ==
        "set terminal pngcairo size 2*(max(9, 8)),2*((4 + (1, 2))) font \"X,15\" fontscale 2 "
        "linewidth 2 "
        "pointscale 2\n");
  CHECK(gnuplot.script("set terminal pngcairo\n") == "set terminal pngcairo\n");
  CHECK_THROWS_WITH(gnuplot.script("set terminal pngcairo size 900\n"),
                    Contains("no width and height"));
  CHECK_THAT(gnuplot.at.read("style.gp"), Contains("size 2*(1000),2*(560)"));
}

TEST_CASE("unit: empty groups of an SVG go, and the font is reported once") {
  StandIn gnuplot("",
                  "<svg width=\"9\">\\n<g fill=\"a\">\\n</g>\\n<g fill=\"b\">\\n<text "
                  "font-family=\"DejaVu Sans\" "
                  "size=\"3\">t</text>\\n<g c>\\n</g>\\n</g>\\n<g d>\\n<g e>\\n</g>\\n</svg>\\n");
  const auto script = gnuplot.at.write("fig.gp", "set terminal pngcairo size 900,400\n");
  CHECK(plot::draw_svg(script, {gnuplot.data}) ==
        "<svg font-family=\"DejaVu Sans, Verdana, sans-serif\" width=\"9\">\n<g fill=\"b\">\n<text "
        "size=\"3\">t</text>\n</g>\n<g d>\n</svg>\n");
  CHECK(gnuplot.at.read("script.gp") ==
        "set terminal svg size 900,400 font \"DejaVu Sans,14\" background rgb \"white\"\n");
  CHECK(gnuplot.at.read("arguments") == "-d -c script.gp d1.csv out.svg\n");
  StandIn half("", "<svg width=\"9\">\\n<g d>\\n");
  CHECK_THROWS_WITH(plot::draw_svg(script, {half.data}), Contains("no complete SVG"));
}

TEST_CASE(
    "unit: what gnuplot says is quoted, but for the font library's remarks and what may be "
    "missing") {
  const TemporaryFolder at("said");
  const auto script = at.write("fig.gp", "");
  const auto said = [&](const std::string& words,
                        plot::EmptyCurve missing = plot::EmptyCurve::error,
                        const std::string& then = "exit 0") {
    StandIn gnuplot(words, StandIn::whole_png, then);
    try {
      (void)plot::draw(script, {gnuplot.data}, missing);
    } catch (const plot::PlotError& error) {
      const std::string text = error.what();
      return text.substr(text.find(": ") + 2);
    }
    return std::string{};
  };
  CHECK(said("").empty());
  CHECK(said("\\n  \\t\\nFontconfig error: no cache\\n").empty());
  CHECK(said("one\\n\\ntwo") == "gnuplot complained\n  one\n  two");
  for (const char* gone :
       {"Warning: empty x range\\n", "line 3: Skipping data file with no valid points\\n"}) {
    CHECK(said(gone, plot::EmptyCurve::skip).empty());
    CHECK_THAT(said(gone), Contains("gnuplot complained"));
    CHECK_THAT(said(std::string(gone) + "more", plot::EmptyCurve::skip),
               Contains("\n  more") && !Contains("Warning"));
  }
  CHECK(said("", plot::EmptyCurve::error, "exit 3") == "gnuplot failed (exit status 3)");
  CHECK(said("bad", plot::EmptyCurve::error, "kill -9 $$") == "gnuplot failed (signal 9)\n  bad");
  // More than a pipe holds, and all of it.
  const std::string long_words = said("", plot::EmptyCurve::error, "seq 1 30000 >&2; exit 0");
  CHECK_THAT(long_words, Catch::EndsWith("\n  29999\n  30000"));
  StandIn cut("", "\\211PNG\\r\\n\\032\\n....IEN");
  CHECK_THROWS_WITH(plot::draw(script, {cut.data}), Contains("no complete PNG"));
}

TEST_CASE("unit: gnuplot ends with all it started, and leaves no file open") {
  const auto open_files = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
  };
  const auto before = open_files();
  {
    // Ends itself, while another goes on with its messages open.
    StandIn gnuplot("", StandIn::whole_png, "sleep 600 &\necho $! > \"$HOME/child\"\nexit 0");
    const SetVariable home("HOME");
    home.to(gnuplot.at.path.c_str());
    (void)plot::draw(gnuplot.at.write("fig.gp", ""), {gnuplot.data});
    CHECK(ends(std::stoi(gnuplot.at.read("child"))));
  }
  {
    // Says nothing more and goes on: its end is waited for.
    StandIn gnuplot("", StandIn::whole_png, "exec 2>&-\nsleep 0.2\nexit 5");
    CHECK_THROWS_WITH(plot::draw(gnuplot.at.write("fig.gp", ""), {gnuplot.data}),
                      Contains("exit status 5"));
  }
  {
    // One that has left its group is not waited for, though it could say more.
    StandIn gnuplot("", StandIn::whole_png,
                    "setsid sh -c 'echo $$ > \"$HOME/child\"; exec sleep 600' &\n"
                    "while ! [ -s \"$HOME/child\" ]; do :; done; exit 0");
    const SetVariable home("HOME");
    home.to(gnuplot.at.path.c_str());
    CHECK_NOTHROW(plot::draw(gnuplot.at.write("fig.gp", ""), {gnuplot.data}));
    const pid_t child = std::stoi(gnuplot.at.read("child"));
    REQUIRE(child > 1);
    CHECK_FALSE(has_ended(child));
    kill(child, SIGKILL);
  }
  CHECK(open_files() == before);
}

TEST_CASE("input: a time for gnuplot that is none is the usual one, a minute") {
  StandIn gnuplot;
  const SetVariable seconds("RAILBOOK_GNUPLOT_SECONDS");
  for (const int some : {1, 2, 60, 86399, 86400}) {
    seconds.to(std::to_string(some).c_str());
    CHECK(plot::time_limit() == std::chrono::seconds(some));
  }
  for (const char* none : {"0", "-5", "soon", "", "86401", "9223372036854775807"}) {
    seconds.to(none);
    CHECK(plot::time_limit() == std::chrono::minutes(1));
    CHECK_NOTHROW(plot::draw(gnuplot.at.write("fig.gp", ""), {gnuplot.data}));
  }
}

TEST_CASE("unit: what gnuplot said last is read after its end") {
  // It stops the program, says more than one reading holds, ends, and has the program go on.
  const auto [status, said] = apart(1, [] {
    StandIn gnuplot("", StandIn::whole_png,
                    "kill -STOP $PPID\nseq 1 3000 >&2\n(sleep 0.05; kill -CONT $PPID) &\nexit 0");
    try {
      (void)plot::draw(gnuplot.at.write("fig.gp", ""), {gnuplot.data});
    } catch (const plot::PlotError& error) {
      std::puts(error.what());
    }
    return std::fflush(stdout);
  });
  CHECK(status == 0);
  CHECK_THAT(said,
             Contains("gnuplot complained\n  1\n  2\n") && Catch::EndsWith("\n  2999\n  3000\n"));
}
