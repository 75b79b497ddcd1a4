#include <GL/gl.h>
#include <GL/osmesa.h>

#include <stdexcept>
#include <string>

#include <railbook/scene/detail/context.hpp>

#ifdef __SANITIZE_ADDRESS__
// Mesa 22.3 itself loses a few dozen bytes a context; ours are still looked for.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa";
}
#endif

namespace railbook::scene {

struct Context::State {
  std::vector<std::uint8_t> buffer;  // the renderer draws into it
  OSMesaContext context = nullptr;
  ~State() {
    if (context != nullptr) OSMesaDestroyContext(context);
  }
};

Context::Context(int width, int height) : state_(std::make_unique<State>()) {
  constexpr int depth_bits = 24;
  state_->buffer.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  state_->context = OSMesaCreateContextExt(OSMESA_RGBA, depth_bits, 0, 0, nullptr);
  if (state_->context == nullptr) throw std::runtime_error("OSMesa: cannot make a context");
  if (!OSMesaMakeCurrent(state_->context, state_->buffer.data(), GL_UNSIGNED_BYTE, width, height))
    throw std::runtime_error("OSMesa: cannot draw " + std::to_string(width) + " by " +
                             std::to_string(height) + " samples");
}

Context::~Context() = default;

std::vector<std::uint8_t> Context::pixels() {
  glFinish();
  return std::move(state_->buffer);
}

}  // namespace railbook::scene
