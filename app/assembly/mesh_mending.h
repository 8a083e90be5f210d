#pragma once

#include <string>

#include "app/assembly/mesh_frame.h"
#include "app/scene/shape.h"
#include "hydro/mesh/mending/mend.h"

/// @file
/// The mending of meshes (hydro/mesh/mending) in the words of scenes and of the command line.

namespace assembly {

/// True if the author asks for anything.
bool asks_for_mending(const scene::Mending& mending);

hydro::MendOptions mend_options(const scene::Mending& mending);

/// Describes a mesh before and after it was mended.
MendingRecord mending_record(const hydro::TriMesh& before, const hydro::MendedMesh& after);

/// Who reads of a remedy: the author of a scene, who has keys, or one who calls a command.
enum class RemedyWords { keys, options };

/// Returns the options as keys beside `file`, `cap: true, mirror: y`, or as options,
/// `--repair --cap --mirror y`.
/// @param mesh   A width for its cracks is told as an option only if it is not the default.
std::string words_of(const hydro::MendOptions& options, const hydro::TriMesh& mesh,
                     RemedyWords words);

/// Tells which keys or options make a solid of a mesh that is none, and of what volume; if none
/// does, the command that says what is wrong with it.
/// @param file   Named in the command.
std::string remedy_text(const hydro::TriMesh& mesh, const std::filesystem::path& file,
                        RemedyWords words);

}  // namespace assembly
