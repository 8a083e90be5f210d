#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

/// @file
/// Pages that the build bundles, and their filling with data.

namespace app {

inline constexpr const char* kRunPage = "page.html";
inline constexpr const char* kComparisonPage = "comparison.html";
inline constexpr const char* kRunsPage = "runs.html";

/// Returns a page without data. @throws InputError if the build has made none.
std::string empty_page(const std::string& name);

/// Writes a page with the data filled in. @return its file and size as text for the user.
std::string write_page(const std::filesystem::path& file, std::string page,
                       const nlohmann::ordered_json& data);

}  // namespace app
