#pragma once

#include <string_view>

#include "app/render/image.h"

namespace render {

/// Decodes the bytes of a JPEG file, in grey or colour, as RGB.
/// @param most_pixels   Larger images are refused before they take memory.
/// @throws Error if it is no sound JPEG, ends early, has four colours or is too large
Image decode_jpeg(std::string_view bytes, double most_pixels);

}  // namespace render
