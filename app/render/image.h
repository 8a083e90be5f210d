#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace render {

/// No usable graphics, a shader that does not compile, a picture that cannot be written; the
/// message says what to do.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Red, green, blue, 0 … 255, as displayed (sRGB).
struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb&) const = default;
};

/// Eight-bit RGB pixels, rows from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< width·height·3

  const std::uint8_t* pixel(int x, int y) const { return &rgb[offset(x, y)]; }
  std::uint8_t* pixel(int x, int y) { return &rgb[offset(x, y)]; }
  Rgb at(int x, int y) const { return {pixel(x, y)[0], pixel(x, y)[1], pixel(x, y)[2]}; }
  bool operator==(const Image&) const = default;

 private:
  std::size_t offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x));
  }
};

/// A blank image.
Image filled_image(int width, int height, Rgb color);

/// Mixes `color` into a pixel with the given weight, 0 … 1; a pixel outside the image is left.
void blend(Image& image, int x, int y, Rgb color, double weight);

/// Mixes a rectangle with rounded corners into an image. Edges are antialiased; lengths in pixels.
struct Panel {
  double left = 0, top = 0, width = 0, height = 0;
  double corner = 0;  ///< Radius.
};
void fill(Image& image, const Panel& panel, Rgb color, double weight = 1);

/// Copies `source` into `image`, its upper left corner at (left, top); it must fit.
void paste(Image& image, const Image& source, int left, int top);

/// The image at another size, resampled with a Lanczos window of two lobes, widened when the image
/// shrinks so that nothing aliases.
Image resized(const Image& image, int width, int height);

}  // namespace render
