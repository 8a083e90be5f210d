#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace app {

/// Returns what the page of a comparison replays: `{"a": …, "b": …}`, each what a replay draws
/// (report/page_data.h) relative to one origin, of B the bodies and their poses only; or
/// `{"note": …}` if a path is no folder of a run, or a scene or mesh of it cannot be found.
nlohmann::ordered_json comparison_replay(const std::filesystem::path& a,
                                         const std::filesystem::path& b);

}  // namespace app
