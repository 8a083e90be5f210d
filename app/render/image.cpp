#include "app/render/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace render {
namespace {

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

/// Lanczos kernel of two lobes, zero for |x| >= 2.
double lanczos(double x) {
  constexpr double kLobes = 2;
  if (std::abs(x) < 1e-9) return 1;
  if (std::abs(x) >= kLobes) return 0;
  const double s = M_PI * x;
  return kLobes * std::sin(s) * std::sin(s / kLobes) / (s * s);
}

/// Source samples of one target sample and their weights, which sum to one.
struct Taps {
  int first = 0;
  std::vector<double> weights;
};

std::vector<Taps> make_taps(int source_size, int target_size) {
  const double ratio = static_cast<double>(source_size) / target_size;
  const double stretch = std::max(ratio, 1.0);
  std::vector<Taps> taps(static_cast<std::size_t>(target_size));
  for (int i = 0; i < target_size; ++i) {
    const double center = (i + 0.5) * ratio - 0.5;
    Taps& t = taps[static_cast<std::size_t>(i)];
    t.first = std::max(0, static_cast<int>(std::ceil(center - 2 * stretch)));
    const int last = std::min(source_size - 1, static_cast<int>(std::floor(center + 2 * stretch)));
    double sum = 0;
    for (int j = t.first; j <= last; ++j) {
      t.weights.push_back(lanczos((j - center) / stretch));
      sum += t.weights.back();
    }
    for (double& w : t.weights) w /= sum;
  }
  return taps;
}

/// Distance of a point from a rounded rectangle, negative inside [px].
double distance_to(const Panel& p, double x, double y) {
  const double dx = std::abs(x - p.left - p.width / 2) - p.width / 2 + p.corner;
  const double dy = std::abs(y - p.top - p.height / 2) - p.height / 2 + p.corner;
  return std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) + std::min(std::max(dx, dy), 0.0) -
         p.corner;
}

}  // namespace

Image filled_image(int width, int height, Rgb color) {
  Image image{.width = width, .height = height, .rgb = {}};
  image.rgb.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  for (int i = 0; i < width * height; ++i)
    image.rgb.insert(image.rgb.end(), {color.r, color.g, color.b});
  return image;
}

void require_pixels(double width, double height, double most) {
  if (width * height > most)
    throw Error(fmt::format("has {:.0f} × {:.0f} pixels, more than {:g} million", width, height,
                            most / 1e6));
}

Image halved(const Image& image) {
  Image half = filled_image((image.width + 1) / 2, (image.height + 1) / 2, {});
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const int right = std::min(2 * x + 1, image.width - 1);
      const int below = std::min(2 * y + 1, image.height - 1);
      const std::uint8_t* const four[] = {image.pixel(2 * x, 2 * y), image.pixel(right, 2 * y),
                                          image.pixel(2 * x, below), image.pixel(right, below)};
      for (int c = 0; c < 3; ++c)
        half.pixel(x, y)[c] =
            static_cast<std::uint8_t>((four[0][c] + four[1][c] + four[2][c] + four[3][c] + 2) / 4);
    }
  return half;
}

void blend(Image& image, int x, int y, Rgb color, double weight) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::uint8_t* p = image.pixel(x, y);
  p[0] = to_byte(p[0] + weight * (color.r - p[0]));
  p[1] = to_byte(p[1] + weight * (color.g - p[1]));
  p[2] = to_byte(p[2] + weight * (color.b - p[2]));
}

void fill(Image& image, const Panel& panel, Rgb color, double weight) {
  const int right = static_cast<int>(std::ceil(panel.left + panel.width));
  const int bottom = static_cast<int>(std::ceil(panel.top + panel.height));
  for (int y = static_cast<int>(std::floor(panel.top)); y < bottom; ++y)
    for (int x = static_cast<int>(std::floor(panel.left)); x < right; ++x) {
      const double cover = std::clamp(0.5 - distance_to(panel, x + 0.5, y + 0.5), 0.0, 1.0);
      if (cover > 0) blend(image, x, y, color, weight * cover);
    }
}

void paste(Image& image, const Image& source, int left, int top) {
  assert(left >= 0 && left + source.width <= image.width);
  assert(top >= 0 && top + source.height <= image.height);
  for (int y = 0; y < source.height; ++y)
    std::copy_n(source.pixel(0, y), 3 * source.width, image.pixel(left, top + y));
}

Image resized(const Image& image, int width, int height) {
  const std::vector<Taps> across = make_taps(image.width, width);
  const std::vector<Taps> down = make_taps(image.height, height);
  const auto row_size = static_cast<std::size_t>(width) * 3;
  std::vector<double> rows(row_size * static_cast<std::size_t>(image.height), 0.0);
  for (int y = 0; y < image.height; ++y)
    for (std::size_t i = 0; i < row_size; ++i) {
      const Taps& t = across[i / 3];
      const std::uint8_t* p = image.pixel(t.first, y) + i % 3;
      double& sum = rows[static_cast<std::size_t>(y) * row_size + i];
      for (std::size_t j = 0; j < t.weights.size(); ++j) sum += t.weights[j] * p[3 * j];
    }
  Image result = filled_image(width, height, {});
  for (int y = 0; y < height; ++y)
    for (std::size_t i = 0; i < row_size; ++i) {
      const Taps& t = down[static_cast<std::size_t>(y)];
      double sum = 0;
      for (std::size_t j = 0; j < t.weights.size(); ++j)
        sum += t.weights[j] * rows[(static_cast<std::size_t>(t.first) + j) * row_size + i];
      result.pixel(0, y)[i] = to_byte(sum);
    }
  return result;
}

}  // namespace render
