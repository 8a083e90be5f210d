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

struct Camera {
  std::string name;  ///< Set for each of `cameras`.
  // Place of the camera and of its target at time 0 [m]. One that is missing is chosen such that
  // all bodies are seen (app/pictures/cameras.h).
  std::optional<Eigen::Vector3d> from;
  std::optional<Eigen::Vector3d> to;
  double field_of_view = 0.6108652381980153;  ///< Vertical [rad], 35 degrees.
  std::string follow;                         ///< Name of the body to follow; empty: none.
  double orbit = 0;                           ///< Rate of turn about `to` [rad/s].
  std::string
      on;  ///< Name of the body in whose mesh frame `from` and `to` are, both given; empty: W.
};

/// True if a camera can have this name, which is part of the names of files.
bool is_camera_name(const std::string& name);

/// Elements to draw besides the bodies, the water and the ground.
struct Show {
  bool forces = false;
  bool centres = false;
  bool waterline = false;
  bool wireframe = false;
  bool joints = false;
  bool trail = false;
};

/// The colour scales, by the names of their keys (app/render/color_scale.h).
enum class Colors { turbo, viridis, cividis, coolwarm, gray, thesis };

/// True if the middle of a scale stands out, which is then at zero unless both ends are given.
inline bool diverges(Colors colors) { return colors == Colors::coolwarm; }

/// Part of the gauge pressure on a wetted surface that the colours show.
enum class ShownPressure { total, hydrostatic, dynamic };

/// An end of the colour scale.
struct ScaleEnd {
  enum class Found {
    given,    ///< It is `pressure`.
    scene,    ///< It is found from the scene: `auto`.
    pictures  ///< It is found from the pictures: `drawn`.
  };
  Found found = Found::scene;
  double pressure = 0;  ///< [Pa]
};

struct Render {
  std::array<int, 2> size = {960, 720};  ///< [px]
  double every = 0.3;                    ///< [s]
  Camera camera;
  std::vector<Camera> cameras;       ///< These replace `camera` unless empty.
  std::optional<int> sheet_columns;  ///< None: chosen to fit.
  bool overlay = true;               ///< False: no text, scale or legend stands on the pictures.
  bool grid = true;                  ///< False: water and ground have no lines.
  bool pressure_shown = true;        ///< False: bodies have their own colours under water, too.
  ScaleEnd pressure_min = {ScaleEnd::Found::given, 0};
  ScaleEnd pressure_max;
  Colors colors = Colors::turbo;
  ShownPressure shows = ShownPressure::total;
  Show show;
};

}  // namespace scene
