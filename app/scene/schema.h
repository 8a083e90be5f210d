#pragma once

#include <string>

namespace scene {

/// The scene format as a JSON Schema (draft 7, which editors know): keys, types, limits, and which
/// keys go together, with a description of every key. What only the values of several keys or the
/// files of a scene show is left to the reader.
std::string json_schema();

/// The tables of keys in scenes/README.md, each between lines that name it:
/// `<!-- keys of water: begin -->` and `<!-- keys of water: end -->`.
std::string key_tables();

}  // namespace scene
