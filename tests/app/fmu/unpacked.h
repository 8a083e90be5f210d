#pragma once

#include <filesystem>

namespace support {

/// Writes the files of an archive below a folder. @throws std::runtime_error for a bad archive
void unpack(const std::filesystem::path& archive, const std::filesystem::path& folder);

}  // namespace support
