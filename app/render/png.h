#pragma once

#include <filesystem>
#include <string_view>

#include "app/render/image.h"

namespace render {

/// Writes an image as an eight-bit RGB PNG file, replacing an existing one.
/// @throws Error if the file cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);

/// Reads a PNG file of any colour type as RGB; transparent pixels are blended with white.
/// @throws Error if the file cannot be read or is no PNG.
Image read_png(const std::filesystem::path& file);

/// Decodes the bytes of a PNG file of any colour type as RGB, without its transparency.
/// @param most_pixels   Larger images are refused before they take memory.
/// @throws Error if it is no sound PNG or too large
Image decode_png(std::string_view bytes, double most_pixels);

}  // namespace render
