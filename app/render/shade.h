#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "app/render/gl_mesh.h"
#include "app/render/gl_program.h"
#include "app/render/view.h"

namespace render {

/// The shadows of bodies on water and ground, as a texture of one square of the level plane through
/// the eye, onto which bodies are cast along the main light. Water and ground look their light up
/// at the place where their own ray meets the plane, which costs one texel a pixel whatever the
/// number of bodies. Each texel tells how much of the light the highest body takes, and how high
/// that is, so that nothing above it is shaded. Shadows have edges that are soft by a fixed number
/// of texels.
///
/// The context must be current in all functions and when the object is destroyed.
class Shade {
 public:
  static constexpr int kSize = 256;  ///< Texels along a side.
  static constexpr int kUnit = 1;    ///< Unit of the texture that shaders read.
  static constexpr int kMargin = 8;  ///< Texels along each border that have room for the blur.

  Shade(const GlFunctions& gl, const std::filesystem::path& shaders);
  ~Shade();
  Shade(const Shade&) = delete;
  Shade& operator=(const Shade&) = delete;

  /// Empties the texture and makes it what is drawn on.
  void begin() const;
  /// Draws bodies on the texture, with the uniforms of shaders/body.vert. Its view must be set.
  const GlProgram& program() const { return cast_; }
  /// Blurs what was drawn, and binds the texture to its unit. The next framebuffer must be bound.
  /// @param cover   Three vertices without attributes.
  void finish(const GlMesh& cover) const;

 private:
  /// A texture, and the framebuffer that draws into it.
  struct Target {
    GLuint texture = 0, framebuffer = 0;
  };
  Target make_target() const;
  void blur(const Target& from, const Target& to, const Eigen::Vector3d& axis,
            const GlMesh& cover) const;

  const GlFunctions* gl_;
  GlProgram cast_, blur_;
  Target sharp_, half_;  ///< After the second blur the first one has the result.
};

/// What a texture of shadows covers.
struct ShadedPart {
  Eigen::Vector3d square = Eigen::Vector3d::UnitZ();  ///< u_shaded of shaders/common.glsl.
  double low = 0, range = 1;                          ///< Heights of bodies in E [m].
};

/// A ball that holds a body.
struct Ball {
  Eigen::Vector3d middle_E;
  double radius;  ///< [m]
};

/// Returns the part of the scene that holds the bodies near the point looked at and their shadows.
ShadedPart shaded_part(const View& view, const std::vector<Ball>& bodies);

}  // namespace render
