#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/render/color_scale.h"
#include "app/render/image.h"
#include "app/render/view.h"
#include "hydro/loads/coefficients.h"
#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"
#include "hydro/spatial.h"

/// @file
/// Pictures of bodies in the sea, drawn without a window.
///
/// Above the water a body has its own colour; below it the gauge pressure on its surface on a
/// colour scale: p = ρ g h + ½ ρ C_p v_n |v_n|, or one of the two terms, with the depth h, and v_n
/// the speed against the water along the outward normal. The normal is the one the body is shaded
/// with: smooth over edges of less than 40 degrees, so that the picture shows the pressure on the
/// shape that the mesh stands for. The depth is linear over each triangle, and the two kinds of
/// colour meet where it is zero.
///
/// No graphics library is loaded before the first Renderer is made.

namespace render {

/// A body as it is drawn: constant over a sequence.
struct BodyAppearance {
  hydro::TriMesh mesh_B;
  Eigen::Vector3d color = {0.8, 0.6, 0.2};  ///< Of the dry surface, RGB 0 … 1.
  hydro::Coefficients coefficients;         ///< For the dynamic part of the pressure shown.
};

/// What is drawn, but for the bodies' states, the time and other cameras: constant over a sequence.
struct SceneDescription {
  int width = 960;
  int height = 720;
  Camera camera;
  PressureScale pressure;
  std::vector<BodyAppearance> bodies;
  std::optional<hydro::Sea> sea;           ///< None: a dry scene.
  std::optional<hydro::TriMesh> ground_W;  ///< Sea floor or shore.
  std::optional<double> ground_z;          ///< A flat sea floor, drawn to the horizon.
  bool water_visible = true;               ///< False: pressures without the water before them.
  bool bold_waterline = false;
  bool wireframe = false;  ///< With the edges of the bodies' meshes.
};

/// Draws a sequence of pictures. Owns the graphics context; one thread at a time.
class Renderer {
 public:
  /// @throws Error if there is no graphics, naming the packages to install, or if a shader is
  ///         missing or wrong, naming the file and line.
  Renderer(SceneDescription picture, const std::filesystem::path& shader_folder);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// The device drawn on, as the graphics library names it.
  const std::string& device() const;

  /// Of the next picture.
  const View& view() const;

  /// Distance of the lines on water and ground [m]; 0 if there is neither.
  double grid() const;

  /// Looks from a place from the next picture on; the first is `SceneDescription::camera`. The same
  /// as before costs nothing.
  void look(const Camera& camera);

  /// Makes pictures of a size from the next on [px]; the same costs nothing.
  /// @throws Error if they cannot be
  void resize(int width, int height);

  /// Shows pressures on another scale from the next picture on.
  void show_pressures(const PressureScale& scale);

  /// One picture, without text: `add_overlay` (overlay.h) puts time and pressure scale on it, and
  /// `ContactSheet` (sheet.h) wants it bare.
  /// @param states   In the order of `SceneDescription::bodies`.
  Image draw(const std::vector<hydro::BodyState>& states, double time);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace render
