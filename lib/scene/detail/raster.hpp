// The only door to OpenGL: triangles and lines in clip coordinates become pixels.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <railbook/scene/image.hpp>

namespace railbook::scene {

// Corners in clip coordinates (x, y, z, w) with their colours; every 3 make a triangle, every 2 a
// line.
struct Corners {
  std::vector<Eigen::Vector4f> places;
  std::vector<Eigen::Vector3f> colours;
  float line_width = 0.0F;  // pixels of the result; 0 for triangles
};

// Rasterises with 4 by 4 samples a pixel and averages them. Sizes and numbers have been checked
// before. Throws std::system_error with std::errc::function_not_supported where the build has no
// off-screen OpenGL.
Image rasterise(const std::vector<Corners>& parts, const Eigen::Vector3f& background,
                const Size& size);

}  // namespace railbook::scene
