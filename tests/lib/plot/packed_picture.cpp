#include <railbook/plot/packed_picture.hpp>

#include <catch2/catch.hpp>
#include <string>

#include <railbook/scene/image.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using plot::packed_png;

TEST_CASE("unit: a packed picture has the same pixels in fewer bytes, and is packed once") {
  const TemporaryFolder at("packed");
  scene::Image image{{400, 300}, std::vector<std::uint8_t>(3 * 400 * 300)};
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = static_cast<std::uint8_t>(i % 7 == 0 ? i * i / 1000 : i / 3000);
  const std::string png = scene::png_of(image), packed = packed_png(png);
  CHECK(packed.size() < png.size());
  CHECK(scene::read_png(at.write("packed.png", packed)).rgb == image.rgb);
  CHECK(packed_png(packed) == packed);
}

TEST_CASE("unit: what is no whole picture stays as it is") {
  const std::string png = scene::png_of({{2, 2}, std::vector<std::uint8_t>(12)});
  for (const std::string& text :
       {std::string{}, std::string{"\x89PNG\r\n\x1a\n"}, png.substr(0, png.size() - 5),
        png.substr(0, 45), png + "x", std::string(100, '\xff')})
    CHECK(packed_png(text) == text);
}
