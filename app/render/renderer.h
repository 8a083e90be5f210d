#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "hydro/mesh.h"
#include "hydro/sea.h"
#include "hydro/spatial.h"

/// @file
/// Pictures of bodies in the sea, drawn without a window.

namespace render {

/// No usable graphics, or a shader that does not compile; the message says what to do.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Eight-bit RGB pixels, rows from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< width·height·3
};

struct Camera {
  Eigen::Vector3d from = {6, -8, 3};  ///< In W [m].
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double field_of_view = 0.6108652381980153;  ///< Vertical [rad].
};

/// The ends of the colour scale [Pa].
struct PressureScale {
  double min = 0;
  double max = 1;
};

/// A body as it is drawn: constant over a sequence.
struct BodyLook {
  hydro::TriMesh mesh_B;
  Eigen::Vector3d color = {0.8, 0.6, 0.2};  ///< Of the dry surface, RGB 0 … 1.
  double pressure_drag = 0;                 ///< C_p of the dynamic part of the pressure shown.
};

/// What is drawn, but for the bodies' states and the time: constant over a sequence.
struct Picture {
  int width = 960;
  int height = 720;
  Camera camera;
  PressureScale pressure;
  std::vector<BodyLook> bodies;
  std::optional<hydro::Sea> sea;           ///< None: a dry scene.
  std::optional<hydro::TriMesh> ground_W;  ///< Sea floor or shore.
  std::optional<double> ground_z;          ///< A flat sea floor, drawn to the horizon.
};

/// Draws a sequence of pictures. Owns the graphics context.
class Renderer {
 public:
  /// @throws Error if there is no graphics, naming the packages to install.
  Renderer(Picture picture, const std::filesystem::path& shader_folder);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// The device drawn on, as the graphics library names it.
  const std::string& device() const;

  /// One picture, with the time and the labelled pressure scale on it.
  /// @param states   In the order of `Picture::bodies`.
  Image draw(const std::vector<hydro::BodyState>& states, double time);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace render
