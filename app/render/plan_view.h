#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "app/render/gl_mesh.h"
#include "app/render/gl_program.h"
#include "app/render/view.h"

namespace render {

/// Shadows and foam of bodies on water and ground, as a texture of one square of the level plane
/// through the eye, onto which all is cast along the main light. Water and ground look it up at the
/// place where their own ray meets the plane, which costs one texel a pixel whatever the number of
/// bodies.
///
/// Shadows: each texel tells how much of the light the highest body takes, and how high that is, so
/// that nothing above it is shaded. Foam: each texel tells how much of the water's surface the
/// bodies take that float in it, and that times how much they churn the water. Both are soft at
/// their edges by a fixed number of texels, so that what is left beside a body lies about its
/// waterline.
///
/// The context must be current in all functions and when the object is destroyed.
class PlanView {
 public:
  static constexpr int kSize = 256;   ///< Texels along a side.
  static constexpr int kUnit = 1;     ///< Unit of the texture that shaders read.
  static constexpr int kMargin = 12;  ///< Texels along each border that have room for the blur.

  PlanView(const GlFunctions& gl, const std::filesystem::path& shaders);
  ~PlanView();
  PlanView(const PlanView&) = delete;
  PlanView& operator=(const PlanView&) = delete;

  /// Empties the texture and draws shadows into it from now on.
  void begin_shadows() const;
  /// Draws the shadows of bodies on the texture, with the uniforms of shaders/body.vert. Its view
  /// must be set.
  const GlProgram& shadows() const { return shadows_; }
  /// Draws foam from now on.
  void begin_foam() const;
  /// Draws the foam about a body, with its place and attributes as of shaders/body.vert, and
  /// `u_churn`. Its view must be set.
  const GlProgram& foam() const { return foam_; }
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
  GlProgram shadows_, foam_, blur_;
  Target sharp_, half_;  ///< After the second blur the first one has the result.
};

/// Part of the scene that a plan view covers.
struct PlanPart {
  Eigen::Vector3d square = Eigen::Vector3d::UnitZ();  ///< u_plan_part of shaders/common.glsl.
  double low = 0, range = 1;                          ///< Heights of bodies in E [m].
};

/// A ball that holds a body.
struct Ball {
  Eigen::Vector3d middle_E;
  double radius;  ///< [m]
};

/// Returns the part of the scene that holds the bodies near the point looked at and their shadows.
PlanPart plan_part(const View& view, const std::vector<Ball>& bodies);

}  // namespace render
