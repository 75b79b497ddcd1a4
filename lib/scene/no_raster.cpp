// Where the build has found no off-screen OpenGL.
#include <system_error>

#include <railbook/scene/detail/raster.hpp>

namespace railbook::scene {

Image rasterise(const std::vector<Corners>&, const Eigen::Vector3f&, const Size&) {
  throw std::system_error(std::make_error_code(std::errc::function_not_supported),
                          "the scene is not drawn, for want of OSMesa or EGL in this build");
}

}  // namespace railbook::scene
