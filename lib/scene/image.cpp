#include "scene/image.hpp"

#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

#include "units/input_error.hpp"

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

void write_png(const Image& image, const std::filesystem::path& file) {
  if (image.size.width < 1 || image.size.height < 1 || image.rgb.size() != bytes_of(image.size)) {
    throw InputError("image for " + file.string() + ": " + std::to_string(image.rgb.size()) +
                     " bytes do not make " + text_of(image.size) + " pixels of 3");
  }
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  const std::filesystem::path unfinished =
      file.parent_path() /
      (".unfinished-" + std::to_string(getpid()) + "-" + file.filename().string());
  Control control;
  control.png.width = static_cast<png_uint_32>(image.size.width);
  control.png.height = static_cast<png_uint_32>(image.size.height);
  control.png.format = PNG_FORMAT_RGB;
  std::error_code error;
  if (png_image_write_to_file(&control.png, unfinished.c_str(), 0, image.rgb.data(), 0, nullptr)) {
    std::filesystem::rename(unfinished, file, error);
    if (!error) return;
  }
  const std::string why = error ? error.message() : control.png.message;
  std::filesystem::remove(unfinished, error);
  throw std::runtime_error("cannot write " + file.string() + ": " + why);
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
