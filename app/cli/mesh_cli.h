#pragma once

#include "app/commands/mesh_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace app {

/// Adds the command `mesh`.
void add_mesh(CLI::App& program, MeshCommand& command);

}  // namespace app
