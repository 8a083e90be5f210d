#pragma once

#include <filesystem>
#include <string>

namespace fmu {

/// Returns the bytes of a file. @throws std::runtime_error that names a file which cannot be read
std::string bytes_of(const std::filesystem::path& file);

}  // namespace fmu
