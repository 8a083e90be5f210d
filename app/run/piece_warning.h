#pragma once

#include <optional>
#include <string>

#include "engine/base/spec.h"

namespace app {

/// Returns a warning that names the first body whose faces would need more than
/// hydro::kMostPiecesOfAFace pieces for its wave_tolerance; none if there is no such body.
std::optional<std::string> piece_warning(const engine::SimulationSpec& spec);

}  // namespace app
