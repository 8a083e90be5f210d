#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/render/renderer.h"

namespace pictures {

/// Where the project's shaders are.
std::filesystem::path shader_folder();

/// A closed ring about the z axis, faces outward: `around` × `across` × 2 triangles.
hydro::TriMesh make_torus(double radius, double tube_radius, int around, int across);

/// A picture with what moves in it.
struct Scene {
  std::string name;
  render::SceneDescription picture;
  std::vector<hydro::BodyState> states;
  double time = 0;
};

/// The pressure scale that belongs on a picture: none for a dry scene.
std::optional<render::PressureScale> scale_of(const Scene& scene);

/// A picture of a scene, by a renderer of its own.
render::Image draw(const Scene& scene);

/// A pressure that is read from a scale.
struct Reading {
  double pressure = 0;  ///< [Pa]
  double apart = 0;     ///< How far the colour is from the scale's [of 255].
};

/// Reads the colour of a pixel as a person does who holds it against the bar: at the nearest of the
/// scale's colours.
Reading read_color(const render::PressureScale& scale, render::Rgb color);

/// A ball of radius 1 m, its middle at height `z` over still water, seen level from 10 m away along
/// +y, 320 × 240 pixels; the water itself is left out. Its pressure scale goes from 0 to 10 kPa.
Scene ball_seen_level(double z);

/// One of everything that a picture can hold.
std::vector<Scene> gallery();

}  // namespace pictures
