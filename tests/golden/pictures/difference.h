#pragma once

#include "app/render/image.h"

/// @file
/// How much a picture differs from the one that is kept.

namespace golden {

/// Another rasteriser, or another version of the same, rounds shades otherwise and covers an edge's
/// samples otherwise: a channel may differ by that many of 255, and that share of pixels by more.
inline constexpr int kSlight = 5;
inline constexpr double kMostMarked = 1e-3;

struct Difference {
  int largest = 0;    ///< Of a channel, of 255.
  double mean = 0;    ///< Over all channels.
  double marked = 0;  ///< Share of the pixels with a channel that differs by more than kSlight.

  bool within_tolerance() const { return marked <= kMostMarked; }
};

/// @throws std::invalid_argument if they are not of one size.
Difference difference(const render::Image& kept, const render::Image& drawn);

/// White where two pictures of one size are the same; the pixels that differ by more than kSlight
/// in red, others the darker the more they differ.
render::Image difference_image(const render::Image& kept, const render::Image& drawn);

}  // namespace golden
