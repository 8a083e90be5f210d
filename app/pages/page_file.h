#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

/// @file
/// The pages that the build bundles, and how data get into them.

namespace app {

inline constexpr const char* kRunPage = "page.html";
inline constexpr const char* kComparisonPage = "comparison.html";

/// A page without data. @throws InputError if the build has made none.
std::string empty_page(const std::string& name);

/// Writes an empty page with the data in their place. @return its file and size, to be said.
std::string write_page(const std::filesystem::path& file, std::string page,
                       const nlohmann::ordered_json& data);

}  // namespace app
