#pragma once

#include <string>

#include "app/render/gl_functions.h"

namespace render {

/// An OpenGL 3.3 core context without window or surface.
///
/// Devices are tried in this order: graphics processors, software rasterisers, Mesa's surfaceless
/// platform, the default display; the first that yields a context is used. With
/// LIBGL_ALWAYS_SOFTWARE=1 in the environment graphics processors are not tried.
class EglContext {
 public:
  /// Makes the new context current. @throws Error with the reason of every device that failed and
  /// the packages to install.
  EglContext();
  /// Destroys the context and all objects in it.
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  /// Makes the context current in this thread. @throws Error
  void make_current() const;

  const GlFunctions& gl() const { return gl_; }
  /// Renderer and version, as the graphics library names them.
  const std::string& device() const { return device_; }

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
  GlFunctions gl_;
  std::string device_;
};

}  // namespace render
