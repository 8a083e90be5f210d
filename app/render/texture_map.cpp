#include "app/render/texture_map.h"

#include <algorithm>
#include <cmath>

#include "app/render/srgb.h"

namespace render {
namespace {

/// Largest number of points along a side of a triangle over which the mean of an image is taken:
/// with 32 it has 1024 points, so that 100,000 triangles take less than a second.
constexpr int kMostAlongSide = 32;

/// Returns the pixel of a coordinate in an image that repeats.
int repeated(double coordinate, int size) {
  return std::clamp(static_cast<int>((coordinate - std::floor(coordinate)) * size), 0, size - 1);
}

Eigen::Vector3f texel_at(const Image& image, const Eigen::Vector2d& place) {
  const int x = repeated(place.x(), image.width);
  const int y = image.height - 1 - repeated(place.y(), image.height);
  const std::uint8_t* rgb = image.pixel(x, y);
  return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
}

/// Returns the length of a triangle's longest side [px of the image].
double longest_side(const Image& image, const Eigen::Matrix<double, 2, 3>& corners) {
  const Eigen::Vector2d size(image.width, image.height);
  double longest = 0;
  for (int i = 0; i < 3; ++i)
    longest =
        std::max(longest, (corners.col((i + 1) % 3) - corners.col(i)).cwiseProduct(size).norm());
  return longest;
}

}  // namespace

Eigen::Vector3f tinted(const Eigen::Vector3f& texel, const Eigen::Vector3f& tint, bool of_light) {
  if (!of_light) return texel.cwiseProduct(tint);
  return texel.binaryExpr(tint, [](float a, float b) {
    return displayed(static_cast<float>(light_of(a) * light_of(b)));
  });
}

TexelMeans::TexelMeans(const Image& image) : image_(image) {
  for (const Image* last = &image; std::max(last->width, last->height) > 1; last = &halved_.back())
    halved_.push_back(halved(*last));
}

Eigen::Vector3f TexelMeans::over(const CornerCoordinates& corners) const {
  const Eigen::Matrix<double, 2, 3> exact = corners.cast<double>();
  const Image* image = &image_;
  for (auto next = halved_.begin();
       next != halved_.end() && longest_side(*image, exact) > kMostAlongSide; ++next)
    image = &*next;
  const double side = std::ceil(longest_side(*image, exact));
  const int parts = static_cast<int>(std::clamp(side, 1.0, double{kMostAlongSide}));
  // The middles of parts² equal triangles, those upright and those between them.
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (int i = 0; i < parts; ++i)
    for (int j = 0; i + j < parts; ++j)
      for (const double third : {1.0, 2.0}) {
        if (third == 2 && i + j == parts - 1) continue;
        const double a = (i + third / 3) / parts, b = (j + third / 3) / parts;
        sum += texel_at(*image, exact * Eigen::Vector3d(1 - a - b, a, b));
      }
  return sum / (255.0F * static_cast<float>(parts * parts));
}

}  // namespace render
