#include <catch2/catch.hpp>

#include <railbook/plot/plot.hpp>

#include "support/set_variable.hpp"
#include "support/temporary_folder.hpp"

using namespace railbook;

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
