// OpenGL without a display: EGL's surfaceless platform (EGL_MESA_platform_surfaceless), drawing into a framebuffer
// object.
#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <chrono>
#include <condition_variable>

#include "host/window/surface.hpp"

namespace nicol::window {
namespace {

constexpr const char* packages = "libegl-mesa0 and libgl1-mesa-dri (Debian's names)";

[[noreturn]] void give_up(const std::string& call) {
  throw WindowError("cannot draw without a display: " + call + " failed; it needs Mesa's EGL: " + packages);
}

// epoxy ends the program where a library or a function it wants is missing: so these are looked for first.
void find_libraries() {
  for (const char* name : {"libEGL.so.1", "libGL.so.1"})
    if (!dlopen(name, RTLD_LAZY | RTLD_GLOBAL))
      throw WindowError(std::string("cannot draw without a display: ") + name +
                        " is missing; install libegl1, libgl1 and libgl1-mesa-dri (Debian's names)");
}

class EglSurface : public OffscreenSurface {
 public:
  EglSurface(int width, int height, double scale) : scale_(scale) {
    find_libraries();
    open_context();
    glGenFramebuffers(1, &framebuffer_);
    glGenTextures(1, &colour_);
    make_room(width, height);
  }

  ~EglSurface() override {
    make_current();
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &colour_);
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroySurface(display_, pbuffer_);
    eglDestroyContext(display_, context_);
  }

  void make_current() override { eglMakeCurrent(display_, pbuffer_, pbuffer_, context_); }
  unsigned framebuffer() const override { return framebuffer_; }
  void framebuffer_size(int& width, int& height) const override {
    width = width_;
    height = height_;
  }
  double content_scale() const override { return scale_; }
  void swap() override { glFinish(); }
  void poll() override {}
  void set_clipboard(const std::string& text) override { clipboard_ = text; }
  std::string clipboard() const override { return clipboard_; }
  void set_cursor(Cursor cursor) override { cursor_ = cursor; }
  Cursor cursor() const override { return cursor_; }
  bool should_close() const override { return false; }

  void wake() override {
    {
      const std::lock_guard lock(mutex_);
      woken_ = true;
    }
    condition_.notify_one();
  }

  void wait(std::optional<double> timeout_seconds) override {
    std::unique_lock lock(mutex_);
    const auto ready = [&] { return woken_; };
    if (timeout_seconds) condition_.wait_for(lock, std::chrono::duration<double>(*timeout_seconds), ready);
    else condition_.wait(lock, ready);
    woken_ = false;
  }

  void resize(int width, int height) override {
    make_current();
    make_room(width, height);
    Event event;
    event.kind = Event::Kind::resize;
    push(event);
  }

 private:
  void open_context() {
    for (const char* extension : {"EGL_EXT_platform_base", "EGL_MESA_platform_surfaceless"})
      if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, extension)) give_up(std::string("looking for ") + extension);
    display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY) give_up("eglGetPlatformDisplayEXT(surfaceless)");
    if (!eglInitialize(display_, nullptr, nullptr)) give_up("eglInitialize");
    if (!eglBindAPI(EGL_OPENGL_API)) give_up("eglBindAPI(OpenGL)");
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display_, wanted, &config, 1, &count) || count < 1) give_up("eglChooseConfig");
    const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    pbuffer_ = eglCreatePbufferSurface(display_, config, size);
    if (pbuffer_ == EGL_NO_SURFACE) give_up("eglCreatePbufferSurface");
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT) give_up("eglCreateContext(OpenGL 3.3)");
    if (!eglMakeCurrent(display_, pbuffer_, pbuffer_, context_)) give_up("eglMakeCurrent");
  }

  void make_room(int width, int height) {
    width_ = width;
    height_ = height;
    glBindTexture(GL_TEXTURE_2D, colour_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) give_up("glCheckFramebufferStatus");
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLSurface pbuffer_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
  GLuint framebuffer_ = 0, colour_ = 0;
  int width_ = 0, height_ = 0;
  double scale_;
  std::string clipboard_;
  Cursor cursor_ = Cursor::arrow;
  std::mutex mutex_;
  std::condition_variable condition_;
  bool woken_ = false;
};

}  // namespace

std::unique_ptr<OffscreenSurface> open_offscreen(int width, int height, double content_scale) {
  return std::make_unique<EglSurface>(width, height, content_scale);
}

}  // namespace nicol::window
