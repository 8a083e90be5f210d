#pragma once

#include <filesystem>

namespace assembly {

/// Compares the counts in the head of a PLY file with the size of the file: assimp allocates memory
/// for these counts and fills the missing faces of a truncated file with earlier ones. An element
/// takes one line in a text file. In a binary file it takes the size of its properties, where a
/// face lists at least three vertices.
/// @throws InputError if the file is too short, or if its head has no end, for which assimp may
/// seek
///     for ever. assimp reports a head that is not valid otherwise.
void require_whole_ply(const std::filesystem::path& file);

/// Compares the numbers of vertices and faces that an OFF file announces with its size: each
/// element takes a line. assimp allocates memory for these numbers before it reaches the end of the
/// file.
/// @throws InputError if the file is too short
void require_whole_off(const std::filesystem::path& file);

}  // namespace assembly
