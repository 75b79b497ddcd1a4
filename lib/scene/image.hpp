// Pictures in memory, as PNG files, and side by side.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace railbook::scene {

// Pixels across and down.
struct Size {
  int width = 0;
  int height = 0;
  bool operator==(const Size&) const = default;
};

// Three bytes a pixel (red, green, blue as stored in a PNG), row by row from the top left corner.
struct Image {
  Size size;
  std::vector<std::uint8_t> rgb;

  // The pixel in `column` from the left and `row` from the top; both must be inside.
  std::array<std::uint8_t, 3> at(int column, int row) const {
    const auto first = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
                            static_cast<std::size_t>(column));
    return {rgb[first], rgb[first + 1], rgb[first + 2]};
  }
};

// The bytes of an 8-bit RGB PNG, and the same in a file (files::write). Throws InputError for an
// image that is empty or whose bytes do not match its size, std::runtime_error when libpng refuses.
std::string png_of(const Image& image);
void write_png(const Image& image, const std::filesystem::path& file);

// Reads any PNG as 8-bit RGB; transparency is laid on white.
// Throws InputError naming the file when it is missing or not a complete PNG.
Image read_png(const std::filesystem::path& file);

// How far two pictures of one size are apart.
struct Difference {
  double share = 0.0;  // of the pixels with a channel further off than the `levels` asked for
  int largest = 0;     // largest distance in any channel, 0 to 255
};

// Compares pixel by pixel; `levels` is the distance in a channel that still passes.
// Throws InputError when the sizes differ.
Difference compare(const Image& a, const Image& b, int levels = 3);

}  // namespace railbook::scene
