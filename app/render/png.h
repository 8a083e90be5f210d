#pragma once

#include <filesystem>

#include "app/render/image.h"

namespace render {

/// Writes an image as an eight-bit RGB PNG file, replacing an existing one.
/// @throws Error if the file cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);

/// Reads a PNG file of any colour type as RGB; transparent pixels are blended with white.
/// @throws Error if the file cannot be read or is no PNG.
Image read_png(const std::filesystem::path& file);

}  // namespace render
