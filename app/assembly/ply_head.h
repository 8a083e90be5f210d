#pragma once

#include <filesystem>

namespace assembly {

/// Compares what the head of a PLY file announces with the size of the file: assimp believes the
/// counts, fills memory accordingly, and fills the faces that a truncated file lacks from earlier
/// ones. An element takes one line in a text file; in a binary one the size of its properties, a
/// list of a face's vertices being three long at least.
/// @throws InputError if the file is too short. A head that makes no sense is left to assimp.
void require_whole_ply(const std::filesystem::path& file);

}  // namespace assembly
