#include <catch2/catch.hpp>

#include <railbook/plot/plot.hpp>
#include <railbook/scene/image.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;

TEST_CASE("unit: scene.gp lays a picture down pixel for pixel, and a label where the CSV says") {
  const TemporaryFolder at("overlay");
  scene::Image image{{400, 300}, {}};
  for (int row = 0; row < 300; ++row) {
    for (int column = 0; column < 400; ++column) {
      for (const int value : {column / 2, row / 2, (column / 40 + row / 40) % 2 * 200}) {
        image.rgb.push_back(static_cast<std::uint8_t>(value));
      }
    }
  }
  scene::write_png(image, at.path / "raw.png");
  const auto labels = at.write("labels.csv", "x_px,y_px,label\n150,30,x\n");
  const auto script = at.write("fig.gp", R"(load "style.gp"
set output ARG2
W = 200; H = 150
load "scene.gp"
plot ARG1 @picture, ARG3 using "x_px":"y_px":"label" with labels
)");
  plot::render(script, {at.path / "raw.png", labels}, at.path / "fig.png");
  const scene::Image drawn = scene::read_png(at.path / "fig.png");
  REQUIRE(drawn.size == image.size);
  int changed = 0;  // the picture has twice the pixels of W and H
  for (int row = 2; row < 298; ++row) {
    for (int column = 2; column < 398; ++column) {
      if (drawn.at(column, row) == image.at(column, row)) continue;
      ++changed;
      CAPTURE(column, row);
      REQUIRE(std::abs(column - 300) < 24);
      REQUIRE(std::abs(row - 60) < 24);
    }
  }
  CHECK(changed > 40);
}
