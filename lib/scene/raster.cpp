#include <railbook/scene/detail/raster.hpp>

#include <GL/gl.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include <railbook/num/fp_flags.hpp>
#include <railbook/scene/detail/context.hpp>

namespace railbook::scene {
namespace {

constexpr int samples = 4;  // across, and down, each pixel

void draw(const Corners& part) {
  if (part.places.empty()) return;
  glVertexPointer(4, GL_FLOAT, 0, part.places.data());
  glColorPointer(3, GL_FLOAT, 0, part.colours.data());
  const bool lines = part.line_width > 0.0F;
  if (lines) glLineWidth(part.line_width * static_cast<float>(samples));
  glDrawArrays(lines ? GL_LINES : GL_TRIANGLES, 0, static_cast<GLsizei>(part.places.size()));
}

// Surfaces are pushed back by as much as they fall away under half of the widest line, so that
// lines drawn on them show in full.
void push_surfaces_back(const std::vector<Corners>& parts) {
  float widest = 0.0F;
  for (const Corners& part : parts) widest = std::max(widest, part.line_width);
  if (widest <= 0.0F) return;
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(0.5F * widest * static_cast<float>(samples) + 1.0F, 4.0F);
}

// Averages blocks of samples; OpenGL's rows run upwards, the image's downwards.
Image averaged(const std::vector<std::uint8_t>& buffer, const Size& size) {
  Image image{size, {}};
  image.rgb.reserve(3 * static_cast<std::size_t>(size.width) *
                    static_cast<std::size_t>(size.height));
  const auto stride = 4 * static_cast<std::size_t>(size.width * samples);
  for (int row = size.height - 1; row >= 0; --row) {
    for (int column = 0; column < size.width; ++column) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        int sum = samples * samples / 2;
        for (int j = 0; j < samples; ++j) {
          const auto first = static_cast<std::size_t>(row * samples + j) * stride +
                             4 * static_cast<std::size_t>(column * samples) + channel;
          for (std::size_t i = 0; i < samples; ++i) sum += buffer[first + 4 * i];
        }
        image.rgb.push_back(static_cast<std::uint8_t>(sum / (samples * samples)));
      }
    }
  }
  return image;
}

}  // namespace

Image rasterise(const std::vector<Corners>& parts, const Eigen::Vector3f& background,
                const Size& size) {
  const num::FpFlagsAside aside;
  const int width = size.width * samples;
  const int height = size.height * samples;
  Context context(width, height);
  glViewport(0, 0, width, height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_DITHER);
  push_surfaces_back(parts);
  glClearColor(background.x(), background.y(), background.z(), 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  for (const Corners& part : parts) draw(part);
  const std::vector<std::uint8_t> buffer = context.pixels();
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
    throw std::runtime_error("OpenGL error " + std::to_string(error));
  return averaged(buffer, size);
}

}  // namespace railbook::scene
