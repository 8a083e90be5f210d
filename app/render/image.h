#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace render {

/// Reports that there is no usable graphics, that a shader does not compile or that a picture
/// cannot be written. The message says what to do.
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

/// Returns an image of one colour.
Image filled_image(int width, int height, Rgb color);

/// Refuses an image of more pixels than a limit. @throws Error
void require_pixels(double width, double height, double most);

/// Returns the image at half its size, rounded up, with the means of 2×2 pixels.
Image halved(const Image& image);

/// Mixes `color` into a pixel with the given weight, 0 … 1; pixels outside the image are ignored.
void blend(Image& image, int x, int y, Rgb color, double weight);

/// A rectangle with rounded corners; lengths in pixels.
struct Panel {
  double left = 0, top = 0, width = 0, height = 0;
  double corner = 0;  ///< Radius.
};
/// Mixes a panel with antialiased edges into an image.
void fill(Image& image, const Panel& panel, Rgb color, double weight = 1);

/// Copies `source`, which must fit, into `image` with its upper left corner at (left, top).
void paste(Image& image, const Image& source, int left, int top);

/// Returns the image at another size, resampled with a two-lobe Lanczos window, which is widened
/// for smaller sizes to avoid aliasing.
Image resized(const Image& image, int width, int height);

}  // namespace render
