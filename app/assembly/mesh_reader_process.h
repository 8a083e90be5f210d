#pragma once

#include <filesystem>

#include "app/assembly/mesh_parser.h"
#include "app/base/forked_call.h"

namespace assembly {

/// Reads a mesh file as parse_mesh does, in a process of its own (app/base/forked_call.h).
///
/// assimp 5.2 can be made to crash, to run on and to fill the memory by damaged files of most
/// formats. A crash of the process becomes a fault of the file. It may compute for 2 s and another
/// second per 4 MB of the file, and use 4 GiB and another 64 bytes per byte of the file, but no
/// more than the machine has free.
/// @throws InputError as parse_mesh, and if the file ends the process or exceeds its limits
MeshFile read_mesh_file(const std::filesystem::path& file, scene::MeshFormats formats);

/// The limits of a process that reads a mesh file.
app::CallLimits mesh_limits(const std::filesystem::path& file);

}  // namespace assembly
