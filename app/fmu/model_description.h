#pragma once

#include <string>

#include "app/fmu/interface.h"
#include "app/scene/scene.h"

/// @file
/// modelDescription.xml, by which an importer knows a unit.

namespace fmu {

/// Returns the name of a unit's library: that of the scene's file, with underscores for what an
/// identifier of C may not have.
std::string model_identifier(const scene::Scene& scene);

/// Returns the text of modelDescription.xml.
/// @param scene   The scene that the user exports.
/// @param token   The token of the resources (packed_scene.h).
std::string model_description(const scene::Scene& scene, const Interface& interface,
                              const std::string& token);

}  // namespace fmu
