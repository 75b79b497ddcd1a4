// An OpenGL context without a window.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace railbook::scene {

// Makes a context of `width` by `height` samples current for its lifetime. Throws
// std::runtime_error when the system gives none. OSMesa (context_osmesa.cpp) or EGL's surfaceless
// platform (context_egl.cpp): the build takes what it finds.
class Context {
 public:
  Context(int width, int height);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // What has been drawn, 4 bytes a sample (red, green, blue, alpha), row by row from the bottom
  // left corner.
  std::vector<std::uint8_t> pixels();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace railbook::scene
