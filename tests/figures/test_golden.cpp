#include <catch2/catch.hpp>

#include "../support/temporary_folder.hpp"
#include "golden.hpp"
#include "scene/image.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

// Two folders of pictures of 100 by 100 pixels; `off` of them, from the left top, are `by` levels darker.
struct Folders {
  Folders() : at("figures") {
    std::filesystem::create_directories(drawn);
    std::filesystem::create_directories(golden);
  }
  static void put(const std::filesystem::path& file, std::size_t off = 0, int by = 0,
                  int width = 100) {
    scene::Image image{{width, 100}, {}};
    image.rgb.assign(300 * static_cast<std::size_t>(width), 200);
    for (std::size_t i = 0; i < off; ++i) image.rgb[3 * i] = static_cast<std::uint8_t>(200 - by);
    scene::write_png(image, file);
  }
  figures::Report compare(const std::vector<std::string>& excluded = {}) const {
    return figures::compare(drawn, golden, excluded);
  }
  TemporaryFolder at;
  std::filesystem::path drawn = at.path / "drawn";
  std::filesystem::path golden = at.path / "01-contact";
};

}  // namespace

TEST_CASE("figures: equal sets pass, and say what they compared") {
  const Folders f;
  for (const char* name : {"fig-01.png", "fig-02.png"}) {
    Folders::put(f.drawn / name);
    Folders::put(f.golden / name);
  }
  CHECK(f.compare().faults.empty());
  CHECK(f.compare().compared.size() == 2);
}

TEST_CASE("figures: the limit is 0.1 % of the pixels by more than 3 levels") {
  const Folders f;
  Folders::put(f.golden / "a.png");
  Folders::put(f.drawn / "a.png", 10000, 3);
  CHECK(f.compare().faults.empty());
  Folders::put(f.drawn / "a.png", 10, 4);
  CHECK(f.compare().faults.empty());
  Folders::put(f.drawn / "a.png", 11, 4);
  REQUIRE(f.compare().faults.size() == 1);
  CHECK_THAT(f.compare().faults[0], Contains("a.png: 0.1100 %") && Contains("4 levels"));
}

TEST_CASE("figures: one that is missing on either side is named") {
  const Folders f;
  Folders::put(f.golden / "gone.png");
  Folders::put(f.drawn / "new.png");
  REQUIRE(f.compare().faults.size() == 2);
  CHECK_THAT(f.compare().faults[0], Contains("gone.png") && Contains("not drawn"));
  CHECK_THAT(f.compare().faults[1], Contains("new.png") && Contains("no golden"));
}

TEST_CASE("figures: another size, an empty file and empty folders are faults") {
  const Folders f;
  REQUIRE(f.compare().faults.size() == 1);
  CHECK_THAT(f.compare().faults[0], Contains("no figures"));
  Folders::put(f.golden / "a.png");
  Folders::put(f.drawn / "a.png", 0, 0, 101);
  Folders::put(f.golden / "b.png");
  f.at.write("drawn/b.png", "");
  REQUIRE(f.compare().faults.size() == 2);
  CHECK_THAT(f.compare().faults[0], Contains("a.png") && Contains("101 by 100"));
  CHECK_THAT(f.compare().faults[1], Contains("b.png"));
}

TEST_CASE("figures: measured run times and listed figures are left out") {
  const Folders f;
  Folders::put(f.golden / "a.png");
  Folders::put(f.drawn / "a.png");
  Folders::put(f.drawn / "cost-time.png");
  Folders::put(f.drawn / "noisy.png");
  const auto list = f.at.write("list.txt", "# reasons\n\n01-contact/noisy.png   # why\n");
  CHECK(f.compare(figures::read_list(list)).faults.empty());
  CHECK(f.compare().faults.size() == 1);
  CHECK(f.compare({"02-hunting/noisy.png"}).faults.size() == 1);
  CHECK(figures::read_list(f.at.path / "none.txt").empty());
}
