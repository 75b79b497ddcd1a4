#include <railbook/scene/image.hpp>

#include <catch2/catch.hpp>

#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using namespace railbook::scene;

namespace {

Image gradient(int width, int height) {
  Image image{{width, height}, {}};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      for (const int value : {3 * column, 5 * row, column + row}) {
        image.rgb.push_back(static_cast<std::uint8_t>(value % 256));
      }
    }
  }
  return image;
}

}  // namespace

TEST_CASE("unit: a picture comes back from its PNG byte for byte, and nothing else is left") {
  const TemporaryFolder at("round trip");
  const Image image = gradient(37, 23);
  const auto file = at.path / "new folder" / "a.png";
  write_png(image, file);
  write_png(image, file);  // over the old one
  const Image back = read_png(file);
  CHECK(back.size == image.size);
  CHECK(back.rgb == image.rgb);
  CHECK(TemporaryFolder::files_in(file.parent_path()) == 1);
  CHECK(back.at(36, 22) == std::array<std::uint8_t, 3>{108, 110, 58});
}

TEST_CASE("unit: the difference counts pixels further off than the levels allowed") {
  const Image image = gradient(100, 50);
  CHECK(compare(image, image).share == 0.0);
  CHECK(compare(image, image).largest == 0);
  Image other = image;
  other.rgb[0] = 3;  // the first pixel, red, from 0: at the limit
  CHECK(compare(image, other).share == 0.0);
  CHECK(compare(image, other).largest == 3);
  other.rgb[1] = 4;  // its green: over it, but still one pixel
  other.rgb[2] = 200;
  CHECK(compare(image, other).share == Approx(1.0 / 5000.0));
  CHECK(compare(other, image).largest == 200);
  CHECK(compare(image, other, 200).share == 0.0);
  CHECK_THROWS_AS(compare(image, gradient(50, 100)), InputError);
}
