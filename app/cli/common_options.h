#pragma once

#include <string>
#include <vector>

#include "app/scene/shape.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// @file
/// Options that several commands have.

namespace app {

/// Adds `--set`. @param sets   Its arguments.
CLI::Option* add_sets(CLI::App* command, std::vector<std::string>& sets,
                      const char* what =
                          "Replace or add a key of the scene, e.g. "
                          "bodies[0].density=700");

/// Adds `--up`, `--unit` and `--scale`, the words of a scene's `mesh`.
void add_mesh_frame(CLI::App* command, scene::MeshFrame& frame);

/// Adds `--any-format`.
CLI::Option* add_any_format(CLI::App* command, scene::MeshFormats& formats);

}  // namespace app
