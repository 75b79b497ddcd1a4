#include <catch2/catch.hpp>
#include <vector>

#include <railbook/plot/plot.hpp>

#include "support/apart.hpp"
#include "support/set_variable.hpp"
#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

TEST_CASE("unit: a script with two data files becomes one PNG and leaves nothing else") {
  const SetVariable program("RAILBOOK_GNUPLOT");
  program.to("");  // names none
  const TemporaryFolder at("two files; $(touch never)");
  const auto script = at.write("fig.gp", R"(load "style.gp"
set output ARG2
set xlabel "distance, in"
plot ARG1 using "x_in":"p_psi" with lines lt 1 title "computed", \
     ARG3 using "x_in":"p_psi" with points ls printed title "printed"
)");
  const auto computed = at.write("a.csv", "x_in,p_psi\n0,1\n1,2\n2,5\n");
  const auto printed = at.write("b.csv", "x_in,p_psi\n0,1.1\n1,2.1\n2,4.9\n");
  const auto png = at.path / "made on the way" / "fig.png";
  plot::render(script, {computed, printed}, png);
  CHECK(at.size(png) > 5000);
  CHECK(at.files_in(png.parent_path()) == 1);
}

TEST_CASE("unit: the same script and data give the same bytes") {
  const TemporaryFolder at("same");
  const auto script = at.write("fig.gp", R"(load "style.gp"
set output ARG2
plot ARG1 using 1:2 with lines, "" using 1:3 with linespoints
)");
  const auto data = at.write("a.csv", "x,y,z\n0,1,2\n1,2,2\n2,5,nan\n");
  plot::render(script, {data}, at.path / "one.png");
  plot::render(script, {data}, at.path / "two.png");
  CHECK(at.read("one.png") == at.read("two.png"));
}

TEST_CASE("unit: the same figure as SVG, whatever the terminal line of the script leaves out") {
  const TemporaryFolder at("svg");
  const auto data = at.write("a.csv", "x,y\n0,1\n1,2\n2,5\n");
  for (const char* terminal : {"", "set terminal pngcairo size 900,400\n",
                               "set terminal pngcairo size 900,400 font \"DejaVu Sans,15\"\n"}) {
    const auto script = at.write("fig.gp", std::string("load \"style.gp\"\n") + terminal +
                                               "set output ARG2\nplot ARG1 using 1:2 with lines\n");
    const std::string svg = plot::draw_svg(script, {data});
    CHECK_THAT(svg, Catch::Matchers::Contains("</svg>") &&
                        Catch::Matchers::Contains("\"DejaVu Sans, Verdana, sans-serif\""));
    CHECK_THAT(svg, Catch::Matchers::Contains(*terminal == 0 ? "width=\"1000\" height=\"560\""
                                                             : "width=\"900\" height=\"400\""));
  }
}

namespace {

// Renders `body` after the usual opening; every failure must leave the old figure and no temporary
// file.
struct Refused {
  explicit Refused(const std::string& body, const std::string& opening = "load \"style.gp\"\n")
      : at("refused") {
    const auto script = at.write("fig-07.gp", opening + body);
    const auto data = at.write("fig-07.csv", "x_in,p_psi\n0,1\n1,2\n2,5\n");
    const auto png = at.write("fig-07.png", "the old figure");
    const auto before = at.files_in(at.path);
    try {
      plot::render(script, {data}, png);
    } catch (const plot::PlotError& e) {
      message = e.what();
    }
    untouched = at.files_in(at.path) == before && at.read("fig-07.png") == "the old figure";
  }
  TemporaryFolder at;
  std::string message;
  bool untouched = false;
};

const std::string output = "set output ARG2\n";

}  // namespace

TEST_CASE("input: a syntax error names the script and quotes gnuplot") {
  const Refused r(output + "plot ARG1 using 1:2 wiht lines\n");
  CHECK_THAT(r.message, Contains("fig-07.gp") && Contains("line 3") && Contains("exit status 1"));
  CHECK(r.untouched);
}

TEST_CASE("input: a column that is not there is an error though gnuplot goes on") {
  const Refused r(output + "plot ARG1 using \"x_in\":\"p_ksi\" with lines, ARG1 using 1:2\n");
  CHECK_THAT(r.message, Contains("fig-07.gp") && Contains("no column with header \"p_ksi\""));
  CHECK(r.untouched);
}

TEST_CASE("input: a file the script misses is an error though gnuplot goes on") {
  const Refused r(output + "plot ARG1 using 1:2, \"nowhere.csv\" using 1:2\n");
  CHECK_THAT(r.message, Contains("nowhere.csv"));
  CHECK(r.untouched);
}

TEST_CASE("input: a script that draws nothing leaves no figure") {
  CHECK_THAT(Refused(output).message, Contains("no complete PNG"));
  CHECK_THAT(Refused("plot ARG1 using 1:2\n").message, Contains("no complete PNG"));
  CHECK(Refused(output).untouched);
}

TEST_CASE("input: another file type, or an empty file, is not a PNG") {
  const Refused svg("set terminal svg\n" + output + "plot ARG1 using 1:2\n");
  CHECK_THAT(svg.message, Contains("no complete PNG"));
  CHECK(svg.untouched);
  const Refused empty("set print ARG2\n");
  CHECK_THAT(empty.message, Contains("no complete PNG"));
  CHECK(empty.untouched);
}

TEST_CASE("input: missing files and file counts are named before gnuplot runs") {
  const TemporaryFolder at("missing");
  const auto script = at.write("fig.gp", "");
  const auto data = at.write("a.csv", "x\n1\n");
  const auto png = at.path / "fig.png";
  CHECK_THROWS_WITH(plot::render(at.path / "no.gp", {data}, png), Contains("no.gp does not exist"));
  CHECK_THROWS_WITH(plot::render(script, {data, at.path / "no.csv"}, png),
                    Contains("fig.gp") && Contains("no.csv does not exist"));
  CHECK_THROWS_WITH(plot::render(script, {}, png), Contains("1 to 8 data files, not 0"));
  CHECK_THROWS_WITH(plot::render(script, std::vector(9, data), png), Contains("not 9"));
}

TEST_CASE("input: no name reaches gnuplot") {
  using Names = std::vector<const char*>;
  for (const Names& names : {Names{"<touch p;echo ", "x';touch p;'", "$HOME", "it's mine", "-rf"},
                             Names{"|touch p;cat ", "line\nbreak", "`touch p`", "Öl"}}) {
    const TemporaryFolder at("hostile");
    const std::string name = names.front();
    std::filesystem::create_directories(at.path / name);
    std::string text = "load \"style.gp\"\nset output ARG2\nplot ARG1 using 1:2";
    std::vector<std::filesystem::path> data;
    for (const char* file : names) {
      data.push_back(at.write(name + "/" + file, "x,y\n1,1\n2,3\n"));
      if (data.size() > 1) text += ", ARG" + std::to_string(data.size() + 1) + " using 1:2";
    }
    const auto script = at.write(name + "/" + name + ".gp", text + "\n");
    const auto png = at.path / name / (name + ".png");
    plot::render(script, data, png);
    CHECK(TemporaryFolder::size(png) > 3000);
    CHECK(at.files_in(at.path / name) == static_cast<long>(names.size()) + 2);
    CHECK_FALSE(std::filesystem::exists("p"));
  }
}

TEST_CASE(
    "input: a gnuplot that hangs is ended with what it started, one that is not there is named") {
  const TemporaryFolder at("hanging");
  const auto script = at.write("fig.gp", "");
  const auto data = at.write("a.csv", "x\n1\n");
  const auto fake = at.write("gnuplot", "#!/bin/sh\necho $$ > \"" + (at.path / "pid").string() +
                                            "\"" + "\nsleep 600 &\nsleep 600\n");
  std::filesystem::permissions(fake, std::filesystem::perms(0700));
  const SetVariable program("RAILBOOK_GNUPLOT"), seconds("RAILBOOK_GNUPLOT_SECONDS");
  program.to(fake.c_str());
  seconds.to("1");
  CHECK_THROWS_WITH(plot::draw(script, {data}), Contains("was ended after 1 s"));
  CHECK(ends(std::stoi(at.read("pid"))));
  const auto missing = at.path / "none";
  program.to(missing.c_str());
  CHECK_THROWS_WITH(plot::draw(script, {data}),
                    Contains("none: No such file") && Contains("is gnuplot installed"));
}
