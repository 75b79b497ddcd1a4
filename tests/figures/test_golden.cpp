#include <catch2/catch.hpp>

#include <railbook/scene/image.hpp>

#include "../support/temporary_folder.hpp"
#include "golden.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

// A run with one figure "a" of data a.csv, and its golden; pictures of 100 by 100 pixels.
struct Folders {
  Folders() : at("figures") {
    for (const char* name : {"out/results/01-x", "out/figures/01-x", "01-x"})
      std::filesystem::create_directories(at.path / name);
    at.write("out/results/01-x.json",
             R"({"title": "X", "items": [{"id": "t", "title": "T", "csv": ["t.csv"]},
                 {"id": "a", "title": "A", "png": "a.png", "csv": ["a.csv"]}]})");
    picture(drawn);
    picture(golden);
    data("1,2\n3,4\n", "1,2\n3,4\n");
  }
  // `off` of the pixels, from the left top, are `by` levels darker; the others are of two greys.
  static void picture(const std::filesystem::path& file, std::size_t off = 0, int by = 0,
                      int width = 100, int contrast = 50) {
    scene::Image image{{width, 100}, {}};
    image.rgb.assign(300 * static_cast<std::size_t>(width), 200);
    image.rgb.back() = static_cast<std::uint8_t>(200 - contrast);
    for (std::size_t i = 0; i < off; ++i) image.rgb[3 * i] = static_cast<std::uint8_t>(200 - by);
    scene::write_png(image, file);
  }
  void data(const std::string& now, const std::string& committed) const {
    at.write("out/results/01-x/a.csv", "x_m,y_N\n" + now);
    at.write("01-x/a.csv", "x_m,y_N\n" + committed);
  }
  figures::Report compare(bool pixels = true) const {
    return figures::compare(figures::read_run(at.path / "out", "01-x"), at.path / "01-x", pixels);
  }
  std::size_t faults(const std::string& now, const std::string& committed) const {
    data(now, committed);
    return compare().faults.size();
  }
  TemporaryFolder at;
  std::filesystem::path drawn = at.path / "out/figures/01-x/a.png";
  std::filesystem::path golden = at.path / "01-x/a.png";
};

}  // namespace

TEST_CASE("figures: equal sets pass, and say what they compared") {
  const Folders f;
  CHECK(f.compare().faults.empty());
  CHECK(f.compare().compared.size() == 2);
}

TEST_CASE("figures: data may be off by 1e-6 of a value or 1e-9 of the column's largest") {
  const Folders f;
  CHECK(f.faults("1,2\n3,4\n", "1,2\n3.0000029,4\n") == 0);
  CHECK(f.faults("1,2\n3,4\n", "1,2\n3.0000031,4\n") == 1);
  CHECK(f.faults("1,0\n3,1e3\n", "1,9e-7\n3,1e3\n") == 0);
  CHECK(f.faults("1,0\n3,1e3\n", "1,2e-6\n3,1e3\n") == 1);
  CHECK_THAT(f.compare().faults[0], Contains("a.csv: row 1, y_N: 0, the golden has 2e-6 (1 cells"));
}

TEST_CASE("figures: NaN is NaN, text is text, and rows are counted") {
  const Folders f;
  CHECK(f.faults("nan,stick\n", "nan,stick\n") == 0);
  CHECK(f.faults("nan,stick\n", "1,stick\n") == 1);
  CHECK(f.faults("inf,stick\n", "inf,slip\n") == 1);
  CHECK(f.faults("inf,1\n", "1,1\n") == 1);
  CHECK(f.faults("1,2\n3,4\n", "1,2\n") == 1);
  CHECK(f.faults("1,2\n\n3,4\n", "1,2\n3,4\n") == 0);
}

TEST_CASE("figures: a column holds to what it states, and only it") {
  const Folders f;
  const std::string note = "# holds to relative 0.01, absolute 0.5 in y_N: cancellation: a lot\n";
  CHECK(f.faults("1,200\n" + note, "1,202\n") == 0);
  CHECK(f.faults("1,200\n" + note, "1,203\n") == 1);
  CHECK(f.faults("1,0.1\n" + note, "1,0.6\n") == 0);
  CHECK(f.faults("1.1,2\n" + note, "1,2\n") == 1);
  CHECK(f.faults("1,200\n", "1,202\n" + note) == 1);  // what a golden says of itself does not count
  CHECK(f.faults("1,2\n# holds to relative 1, absolute 0 in z_N: x\n", "1,2\n") == 1);
  CHECK(f.faults("1,2\n# holds to relative 1, absolute 0 in *: x\n", "1.5,1\n") == 0);
  const std::string any = "# holds to relative 0, absolute inf in y_N: times\n";
  CHECK(f.faults("1,2e-5\n" + any, "1,0\n") == 0);
  CHECK(f.faults("1,slow\n" + any, "1,0\n") == 0);
  CHECK(f.faults("1.1,2\n" + any, "1,0\n") == 1);
}

TEST_CASE("figures: the limit of pixels is 0.1 % by more than 3 levels, where they count") {
  const Folders f;
  Folders::picture(f.drawn, 10000, 3);
  CHECK(f.compare().faults.empty());
  Folders::picture(f.drawn, 10, 4);
  CHECK(f.compare().faults.empty());
  Folders::picture(f.drawn, 11, 4);
  REQUIRE(f.compare().faults.size() == 1);
  CHECK_THAT(f.compare().faults[0], Contains("a.png: 0.1100 %") && Contains("4 levels"));
  CHECK(f.compare(false).faults.empty());
}

TEST_CASE("figures: elsewhere a picture must be whole, of its size and not empty") {
  const Folders f;
  Folders::picture(f.drawn, 0, 0, 101);
  REQUIRE(f.compare(false).faults.size() == 1);
  CHECK_THAT(f.compare(false).faults[0], Contains("101 by 100"));
  Folders::picture(f.drawn, 0, 0, 100, 0);
  REQUIRE(f.compare(false).faults.size() == 1);
  CHECK_THAT(f.compare(false).faults[0], Contains("empty"));
  f.at.write("out/figures/01-x/a.png", "");
  CHECK(f.compare(false).faults.size() == 1);
}

TEST_CASE("figures: what is missing on either side is named") {
  const Folders f;
  std::filesystem::rename(f.at.path / "01-x/a.csv", f.at.path / "01-x/b.csv");
  REQUIRE(f.compare().faults.size() == 2);
  CHECK_THAT(f.compare().faults[0], Contains("a.csv") && Contains("no golden"));
  CHECK_THAT(f.compare().faults[1], Contains("b.csv") && Contains("not drawn"));
  f.at.write("out/results/01-x.json", R"({"title": "X", "items": []})");
  CHECK_THAT(f.compare().faults[0], Contains("no figures"));
  f.at.write("out/results/01-x.json", R"({"title": "X", "ite)");
  CHECK_THROWS_WITH(f.compare(), Contains("no record of a whole run"));
}

TEST_CASE("figures: of a run without pictures the data are compared") {
  const Folders f;
  const auto faults = [&] {
    return figures::compare_data(f.at.path / "out/results/01-x", f.at.path / "01-x").faults;
  };
  std::filesystem::remove(f.drawn);
  CHECK(faults().empty());
  f.data("1,2\n3,5\n", "1,2\n3,4\n");
  CHECK(faults().size() == 1);
  std::filesystem::remove(f.at.path / "out/results/01-x/a.csv");
  CHECK(faults().size() == 1);
  std::filesystem::remove(f.at.path / "01-x/a.csv");
  CHECK_THAT(faults().at(0), Contains("no data"));
}

TEST_CASE("figures: data that no two runs share, and their picture, have no golden") {
  const Folders f;
  f.at.write("out/results/01-x/a.csv", "x_m,y_N\n1,2\n# not compared: times\n");
  CHECK(f.compare().faults.size() == 2);  // the committed ones should go
  figures::accept(figures::read_run(f.at.path / "out", "01-x"), f.at.path / "01-x");
  CHECK(TemporaryFolder::files_in(f.at.path / "01-x") == 1);
  CHECK(f.compare().faults.empty());
}

TEST_CASE("figures: data that may differ by more than shows do not fix the pixels") {
  const Folders f;
  Folders::picture(f.drawn, 11, 4);
  CHECK(f.faults("1,2\n# holds to relative 1e-3, absolute 0 in y_N: noise\n", "1,2\n") == 1);
  CHECK(f.faults("1,2\n# holds to relative 0, absolute 1e-3 in y_N: noise\n", "1,2\n") == 1);
  CHECK(f.faults("1,2\n# holds to relative 2e-3, absolute 0 in y_N: noise\n", "1,2\n") == 0);
  CHECK(f.faults("1,2\n# holds to relative 0, absolute 3e-3 in y_N: noise\n", "1,2\n") == 0);
}

TEST_CASE("figures: a scene that this build does not draw keeps its golden") {
  const Folders f;
  std::filesystem::remove(f.drawn);
  CHECK(f.compare().faults.size() == 1);
  f.at.write(
      "out/results/01-x.json",
      R"({"title": "X", "items": [{"id": "a", "title": "A", "png": "", "csv": ["a.csv"], "not_drawn": "why"}]})");
  CHECK(f.compare().faults.empty());
  CHECK(f.faults("1,3\n", "1,2\n") == 1);
}

TEST_CASE("figures: accepting changes what differs, and nothing else") {
  const Folders f;
  const auto accept = [&] {
    return figures::accept(figures::read_run(f.at.path / "out", "01-x"), f.at.path / "01-x")
        .compared.size();
  };
  CHECK(f.faults("1,2.0000000001\n3,0.333333333333\n", "1,2\n3,0.3333333\n") == 0);
  CHECK(accept() == 0);
  CHECK(f.at.read("01-x/a.csv") == "x_m,y_N\n1,2\n3,0.3333333\n");
  CHECK(f.faults("1,5\n3,0.333333333333\n", "1,2\n3,0.3333333\n") == 1);
  f.at.write("01-x/gone.png", "");
  CHECK(accept() == 2);
  CHECK(f.compare().faults.empty());
  CHECK(f.at.read("01-x/a.csv") == "x_m,y_N\n1,5\n3,0.33333333\n");
  CHECK_THAT(f.at.read("01-x/README.md"), Contains("\n![a: A](a.png)\n"));
}

TEST_CASE("figures: long data keep every n-th row, and the count of all") {
  const Folders f;
  std::string rows;
  for (int i = 0; i < 9000; ++i) rows += std::to_string(i) + ",12.5\n";
  f.data(rows, "1,2\n");
  const std::string golden = figures::golden_text(f.at.path / "out/results/01-x/a.csv");
  CHECK(golden.size() < figures::kept_bytes);
  CHECK_THAT(golden,
             Contains("\n6,12.5\n# every 3 of 9000 rows\n") || Contains("\n3,12.5\n6,12.5\n"));
  f.at.write("01-x/a.csv", golden);
  CHECK(f.compare().faults.empty());
  f.data(rows + "9000,12.5\n", "");
  f.at.write("01-x/a.csv", golden);
  CHECK(f.compare().faults.size() == 1);
}
