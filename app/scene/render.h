#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// @file
/// The block `render` of a scene: its cameras and what the pictures show.

namespace scene {

/// Largest number of characters in a camera's name.
inline constexpr std::size_t kLongestCameraName = 64;

/// A camera of the pictures.
struct Camera {
  std::string name;  ///< Set for each of `cameras`.
  /// Place of the camera at time 0 [m]; none: all bodies are seen (app/pictures/cameras.h).
  std::optional<Eigen::Vector3d> from;
  /// The point that it looks at, likewise.
  std::optional<Eigen::Vector3d> to;
  double field_of_view = 0.6108652381980153;  ///< Vertical [rad], 35 degrees.
  std::string follow;                         ///< Name of the body to follow; empty: none.
  double orbit = 0;                           ///< Rate of turn about `to` [rad/s].
  /// Name of the body in whose mesh frame `from` and `to` are, both given; empty: W.
  std::string on;
};

/// True if a camera can have this name, which is part of the names of files.
bool is_camera_name(const std::string& name);

/// Elements to draw besides the bodies, the water and the ground.
struct Show {
  bool forces = false;     ///< Arrows of weight, buoyancy, drag and lift.
  bool centres = false;    ///< Centres of mass and of buoyancy.
  bool waterline = false;  ///< A bold line.
  bool wireframe = false;  ///< Edges of the meshes.
  bool joints = false;     ///< Pins, balls and bars of joints.
  bool trail = false;      ///< Path of the centre of mass so far.
};

/// The colour scales, by the names of their keys (app/render/color_scale.h).
enum class Colors { turbo, viridis, cividis, coolwarm, gray, thesis };

/// True if the middle of a scale stands out, which is then at zero unless both ends are given.
inline bool diverges(Colors colors) { return colors == Colors::coolwarm; }

/// Part of the gauge pressure on a wetted surface that the colours show.
enum class ShownPressure { total, hydrostatic, dynamic };

/// An end of the colour scale.
struct ScaleEnd {
  /// Where the value comes from.
  enum class Found {
    given,    ///< It is `pressure`.
    scene,    ///< It is found from the scene: `auto`.
    pictures  ///< It is found from the pictures: `drawn`.
  };
  Found found = Found::scene;  ///< Where the value comes from.
  double pressure = 0;         ///< [Pa]
};

/// The block `render`.
struct Render {
  std::array<int, 2> size = {960, 720};  ///< [px]
  double every = 0.3;                    ///< [s]
  Camera camera;                         ///< The only camera, unless there are `cameras`.
  std::vector<Camera> cameras;           ///< These replace `camera` unless empty.
  std::optional<int> sheet_columns;      ///< None: chosen to fit.
  bool overlay = true;         ///< False: no text, scale or legend stands on the pictures.
  bool grid = true;            ///< False: water and ground have no lines.
  bool pressure_shown = true;  ///< False: bodies have their own colours under water, too.
  ScaleEnd pressure_min = {ScaleEnd::Found::given, 0};  ///< Lower end of the scale.
  ScaleEnd pressure_max;                                ///< Upper end of the scale.
  Colors colors = Colors::turbo;                        ///< Colour scale of the pressure.
  ShownPressure shows = ShownPressure::total;           ///< Pressure that is shown.
  Show show;                                            ///< Elements besides bodies and water.
};

}  // namespace scene
