#pragma once

/// @file
/// Names of the files in the resources of a unit.

namespace fmu {

/// The scene, without includes, variables and repeated entries.
inline constexpr const char* kSceneFile = "scene.yaml";
/// The folder of meshes and tables that the scene names.
inline constexpr const char* kSceneFiles = "files";
/// The folder of solutions of added mass and radiation (assembly/added_mass_store.h).
inline constexpr const char* kSolutions = "solutions";
/// The token that an importer has to give, which modelDescription.xml has too.
inline constexpr const char* kTokenFile = "token.txt";

}  // namespace fmu
