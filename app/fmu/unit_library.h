#pragma once

#include <filesystem>

/// @file
/// The library that every unit contains.

namespace fmu {

/// The folder of libraries for this machine in a unit: `x86_64-linux`.
inline constexpr const char* kPlatform = PLIMSOLL_UNIT_PLATFORM;

/// Returns the library: that in the folder `fmu` beside a program in its build folder, or in
/// lib/plimsoll beside an installed one.
/// @throws std::runtime_error with the places where it is missing
std::filesystem::path unit_library();

}  // namespace fmu
