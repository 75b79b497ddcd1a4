#include <railbook/scene/image.hpp>

#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <railbook/files/out_file.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::scene {
namespace {

std::size_t bytes_of(const Size& size) {
  return 3 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

std::string text_of(const Size& size) {
  return std::to_string(size.width) + " by " + std::to_string(size.height);
}

// libpng's simplified interface; its control structure must be freed on every path.
struct Control {
  Control() { png.version = PNG_IMAGE_VERSION; }
  ~Control() { png_image_free(&png); }
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;
  png_image png{};
};

}  // namespace

std::string png_of(const Image& image) {
  if (image.size.width < 1 || image.size.height < 1 || image.rgb.size() != bytes_of(image.size)) {
    throw InputError("image: " + std::to_string(image.rgb.size()) + " bytes do not make " +
                     text_of(image.size) + " pixels of 3");
  }
  Control control;
  control.png.width = static_cast<png_uint_32>(image.size.width);
  control.png.height = static_cast<png_uint_32>(image.size.height);
  control.png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(control.png);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&control.png, bytes.data(), &size, 0, image.rgb.data(), 0,
                                 nullptr))
    throw std::runtime_error(std::string("image: no PNG of it: ") + control.png.message);
  bytes.resize(size);
  return bytes;
}

void write_png(const Image& image, const std::filesystem::path& file) {
  files::write(file, png_of(image));
}

Image read_png(const std::filesystem::path& file) {
  Control control;
  const auto refuse = [&] {
    throw InputError("PNG file " + file.string() + ": " + control.png.message);
  };
  if (!png_image_begin_read_from_file(&control.png, file.c_str())) refuse();
  control.png.format = PNG_FORMAT_RGB;
  Image image;
  image.size = {static_cast<int>(control.png.width), static_cast<int>(control.png.height)};
  image.rgb.resize(bytes_of(image.size));
  const png_color white{255, 255, 255};
  if (!png_image_finish_read(&control.png, &white, image.rgb.data(), 0, nullptr)) refuse();
  return image;
}

Difference compare(const Image& a, const Image& b, int levels) {
  if (a.size != b.size) {
    throw InputError("images to compare: " + text_of(a.size) + " pixels against " +
                     text_of(b.size));
  }
  std::size_t off = 0;
  Difference result;
  for (std::size_t i = 0; i + 2 < a.rgb.size(); i += 3) {
    int distance = 0;
    for (std::size_t c = i; c < i + 3; ++c)
      distance = std::max(distance, std::abs(a.rgb[c] - b.rgb[c]));
    if (distance > levels) ++off;
    result.largest = std::max(result.largest, distance);
  }
  result.share = static_cast<double>(off) / (static_cast<double>(a.rgb.size()) / 3.0);
  return result;
}

}  // namespace railbook::scene
