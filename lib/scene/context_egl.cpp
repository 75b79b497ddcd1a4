#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <stdexcept>
#include <string>

#include <railbook/scene/detail/context.hpp>

namespace railbook::scene {

struct Context::State {
  int width = 0, height = 0;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  GLuint frame = 0;
  std::array<GLuint, 2> parts{};  // colour, depth
  ~State() {
    if (frame != 0) {
      glDeleteFramebuffers(1, &frame);
      glDeleteRenderbuffers(2, parts.data());
    }
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
  }
};

namespace {

void require(bool good, const char* what) {
  if (!good)
    throw std::runtime_error("EGL: " + std::string(what) + " (error " +
                             std::to_string(eglGetError()) + ")");
}

}  // namespace

Context::Context(int width, int height) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.width = width;
  s.height = height;
  s.display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  require(s.display != EGL_NO_DISPLAY && eglInitialize(s.display, nullptr, nullptr) == EGL_TRUE,
          "no display without a surface");
  require(eglBindAPI(EGL_OPENGL_API) == EGL_TRUE, "no OpenGL");
  constexpr std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                         EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  require(eglChooseConfig(s.display, wanted.data(), &config, 1, &found) == EGL_TRUE && found > 0,
          "no configuration");
  s.context = eglCreateContext(s.display, config, EGL_NO_CONTEXT, nullptr);
  require(s.context != EGL_NO_CONTEXT, "cannot make a context");
  require(eglMakeCurrent(s.display, EGL_NO_SURFACE, EGL_NO_SURFACE, s.context) == EGL_TRUE,
          "cannot use the context");
  glGenFramebuffers(1, &s.frame);
  glBindFramebuffer(GL_FRAMEBUFFER, s.frame);
  glGenRenderbuffers(2, s.parts.data());
  const std::array<GLenum, 2> formats{GL_RGBA8, GL_DEPTH_COMPONENT24};
  const std::array<GLenum, 2> places{GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (std::size_t i = 0; i < 2; ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, s.parts[i]);
    glRenderbufferStorage(GL_RENDERBUFFER, formats[i], width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, s.parts[i]);
  }
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("EGL: cannot draw " + std::to_string(width) + " by " +
                             std::to_string(height) + " samples");
}

Context::~Context() = default;

std::vector<std::uint8_t> Context::pixels() {
  std::vector<std::uint8_t> buffer(4 * static_cast<std::size_t>(state_->width) *
                                   static_cast<std::size_t>(state_->height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, state_->width, state_->height, GL_RGBA, GL_UNSIGNED_BYTE, buffer.data());
  return buffer;
}

}  // namespace railbook::scene
