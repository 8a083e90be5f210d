#pragma once

#include <filesystem>

namespace assembly {

/// Compares the counts in the head of a PLY file with the size of the file: assimp allocates memory
/// for these counts and fills the missing faces of a truncated file with earlier ones. An element
/// takes one line in a text file. In a binary file it takes the size of its properties, where a
/// face lists at least three vertices.
/// @throws InputError if the file is too short. assimp reports a head that is not valid.
void require_whole_ply(const std::filesystem::path& file);

}  // namespace assembly
