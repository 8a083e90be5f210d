#pragma once

#include "app/render/gl_functions.h"
#include "app/render/image.h"

namespace render {

/// Framebuffer with colour and depth, four samples a pixel, and a copy of the depth that shaders
/// can read. Its context must be current when it is destroyed.
class Framebuffer {
 public:
  static constexpr int kSamples = 4;

  /// @throws Error if the device cannot make one of this size.
  Framebuffer(const GlFunctions& gl, int width, int height);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  /// Binds the framebuffer and clears its colour and depth.
  void begin() const;

  /// Copies the depth drawn so far to the texture that `depth_copy` names (a sampler2DMS).
  void copy_depth() const;
  GLuint depth_copy() const { return depth_copy_; }

  /// Restores the depth that was copied.
  void restore_depth() const;

  /// Returns the finished picture with its samples averaged.
  Image read() const;

 private:
  void copy_depth(GLuint from, GLuint to) const;

  const GlFunctions* gl_;
  int width_, height_;
  GLuint canvas_ = 0, copy_ = 0, resolved_ = 0;  // framebuffer objects
  GLuint color_ = 0, resolved_color_ = 0;        // renderbuffers
  GLuint depth_ = 0, depth_copy_ = 0;            // textures
};

}  // namespace render
