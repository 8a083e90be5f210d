#pragma once

#include <string>

/// @file
/// The format of scenes for editors and for its reference.

namespace scene {

/// Returns the scene format as a JSON Schema (draft 7, which editors support): keys with their
/// types, limits and descriptions, and constraints between them. Checks that need the values of
/// several keys, or other files, are left to the reader.
std::string json_schema();

/// Returns the tables of keys in scenes/KEYS.md, each between lines that name it:
/// `<!-- keys of water: begin -->` and `<!-- keys of water: end -->`.
std::string key_tables();

}  // namespace scene
