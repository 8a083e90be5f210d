#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// @file
/// Files that a file of a scene needs beside it.

namespace fmu {

/// A file that another one needs.
struct Companion {
  std::filesystem::path source;
  std::string name;  ///< Relative to the folder of the other one.
};

/// Returns the companions of a file that are there: the buffers of a mesh in glTF, the files of
/// WAMIT and Nemoh that make up a database. Paints of meshes, which pictures alone use, are none.
std::vector<Companion> companions_of(const std::filesystem::path& file);

}  // namespace fmu
