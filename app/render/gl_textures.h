#pragma once

#include <map>

#include "app/render/gl_functions.h"
#include "app/render/image.h"

namespace render {

/// Images on the graphics device, each once. Its context must be current in all functions and when
/// it is destroyed.
class GlTextures {
 public:
  explicit GlTextures(const GlFunctions& gl) : gl_(&gl) {}
  ~GlTextures();
  GlTextures(const GlTextures&) = delete;
  GlTextures& operator=(const GlTextures&) = delete;

  /// Returns the name of an image's texture, which repeats and has its first row at the bottom. The
  /// image must outlive this.
  GLuint of(const Image& image);

 private:
  const GlFunctions* gl_;
  std::map<const Image*, GLuint> names_;
};

}  // namespace render
