#pragma once

#include <filesystem>

namespace app {

/// True if an open file or folder still has this name: it has been neither removed nor replaced nor
/// moved. @param descriptor   Descriptor of the open file.
bool has_name(int descriptor, const std::filesystem::path& name);

}  // namespace app
