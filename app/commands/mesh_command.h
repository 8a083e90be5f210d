#pragma once

#include <filesystem>

#include "app/scene/shape.h"

namespace app {

struct MeshCommand {
  std::filesystem::path file;
  bool repair = false;
  scene::Mending mending;     ///< Only with `repair`.
  std::filesystem::path out;  ///< The mesh is written there, in metres with z up; empty: nowhere.
  scene::MeshFormats formats = scene::MeshFormats::common;
  scene::MeshFrame frame;
};

/// Says what a mesh file is, mends it if asked to and writes it. @return the exit code
/// @throws InputError if the file cannot be read, or if mending does not make a solid of it;
/// nothing
///     is written then
int mesh_command(const MeshCommand& command);

}  // namespace app
