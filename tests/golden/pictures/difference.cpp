#include "tests/golden/pictures/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace golden {
namespace {

using render::Image;
using render::Rgb;

/// Calls `visit(x, y, largest, sum)` with the largest and the summed difference of the channels of
/// every pixel.
template <class Visit>
void for_each_pixel(const Image& a, const Image& b, Visit&& visit) {
  if (a.width != b.width || a.height != b.height)
    throw std::invalid_argument(
        fmt::format("the picture kept is of {} x {} pixels, that drawn of {} x {}", a.width,
                    a.height, b.width, b.height));
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      int largest = 0, sum = 0;
      for (int c = 0; c < 3; ++c) {
        const int apart = std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]);
        largest = std::max(largest, apart);
        sum += apart;
      }
      visit(x, y, largest, sum);
    }
}

}  // namespace

Difference difference(const Image& kept, const Image& drawn) {
  Difference result;
  long marked = 0, total = 0;
  for_each_pixel(kept, drawn, [&](int, int, int largest, int sum) {
    result.largest = std::max(result.largest, largest);
    marked += largest > kSlight;
    total += sum;
  });
  const double pixels = std::max(1.0, static_cast<double>(kept.width) * kept.height);
  result.mean = static_cast<double>(total) / (3 * pixels);
  result.marked = static_cast<double>(marked) / pixels;
  return result;
}

Image difference_image(const Image& kept, const Image& drawn) {
  constexpr Rgb kWhite = {255, 255, 255}, kRed = {200, 0, 0};
  Image image = render::filled_image(kept.width, kept.height, kWhite);
  for_each_pixel(kept, drawn, [&](int x, int y, int largest, int) {
    if (largest > kSlight)
      render::blend(image, x, y, kRed, 1);
    else
      render::blend(image, x, y, {0, 0, 0}, 0.1 * largest);
  });
  return image;
}

}  // namespace golden
