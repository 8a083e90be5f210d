#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/render/body_appearance.h"
#include "app/render/color_scale.h"
#include "app/render/image.h"
#include "app/render/interior_look.h"
#include "app/render/rigging.h"
#include "app/render/view.h"
#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"
#include "hydro/spatial.h"
#include "hydro/water/simulated_water.h"

/// @file
/// Pictures of bodies in the sea, drawn without a window.
///
/// Above the water a body has its own colour. Below it a colour scale shows the gauge pressure on
/// its surface, in the very colours of the scale whatever light, water or air there is: the
/// pressure is drawn last, over the water. It is p = ρ g h + ½ ρ C_p v_n |v_n|, or one of the two
/// terms; h is the head of the undisturbed water, which is the depth but under linear waves, and
/// v_n the speed along the outward normal relative to the water at the place. This is the shading
/// normal, smooth over edges of less than 40 degrees, so that the picture shows the pressure on the
/// shape that the mesh approximates. Depth, head and the water's velocity are linear over each
/// triangle, and the two kinds of colour meet where the depth is zero.
///
/// No graphics library is loaded before the first Renderer is made.

namespace render {

/// Settings of a sequence; the bodies' states and the time are given for each picture.
struct SceneDescription {
  int width = 960;
  int height = 720;
  Camera camera;
  PressureScale pressure;
  std::vector<BodyAppearance> bodies;
  std::optional<hydro::Sea> sea;           ///< None: a dry scene.
  std::optional<hydro::TriMesh> ground_W;  ///< Sea floor or shore.
  std::optional<double> ground_z;          ///< A flat sea floor, drawn to the horizon.
  double ripple = 0;                       ///< Cell of the bodies' waves [m]; 0: there are none.
  bool water_visible = true;               ///< False: pressures are shown, but no water.
  bool grid_visible = true;                ///< False: water and ground have no lines.
  bool pressure_visible = true;  ///< False: bodies have their own colours under water, too.
  bool bold_waterline = false;
  bool wireframe = false;  ///< True: edges of the bodies' meshes are drawn.
};

/// Draws a sequence of pictures. It owns the graphics context and is used by one thread at a time.
class Renderer {
 public:
  /// @throws Error if there is no graphics, naming the packages to install, or if a shader is
  ///         missing or wrong, naming the file and line.
  Renderer(SceneDescription picture, const std::filesystem::path& shader_folder);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Graphics device, as the graphics library names it.
  const std::string& device() const;

  /// View of the next picture.
  const View& view() const;

  /// Spacing of the grid lines on water and ground [m]; 0 if there are none.
  double grid() const;

  /// Sets the camera of the following pictures, at first `SceneDescription::camera`. An unchanged
  /// camera costs nothing.
  void look(const Camera& camera);

  /// Sets the size of the following pictures [px]. An unchanged size costs nothing.
  /// @throws Error if the device cannot draw this size
  void resize(int width, int height);

  /// Sets the pressure scale of the following pictures.
  void show_pressures(const PressureScale& scale);

  /// Draws a picture without text. `add_overlay` (overlay.h) adds time and pressure scale;
  /// `ContactSheet` (sheet.h) takes the picture without them.
  /// @param states      States in the order of `SceneDescription::bodies`.
  /// @param interiors   The water in their hollows, in the same order; empty: they are dry.
  /// @param rigging     Lines and parts beside the bodies.
  /// @param ripples     The bodies' waves, which are drawn upon those of the sea; null: none.
  Image draw(const std::vector<hydro::BodyState>& states, double time,
             const Interiors& interiors = {}, const Rigging& rigging = {},
             const hydro::SurfacePatch* ripples = nullptr);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace render
