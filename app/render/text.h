#pragma once

#include <memory>
#include <string>

#include "app/render/image.h"

namespace render {

/// How a line of text stands to the point it is put at.
enum class Align { left, center, right };

/// Colours of what is written on pictures, and of its ground.
inline constexpr Rgb kInk = {25, 32, 40};
inline constexpr Rgb kPaper = {255, 255, 255};

/// Of a picture with text [px]: in a smaller one letters would run together.
inline constexpr int kLeastExtent = 120;

/// A typeface at one size.
class Font {
 public:
  /// DejaVu Sans, or what the system has in its place. @param size   Of an em [px].
  /// @throws Error if there is no font, naming the package to install.
  explicit Font(int size);
  ~Font();
  Font(Font&&) noexcept;
  Font& operator=(Font&&) noexcept;

  /// Width of a line of ASCII text [px].
  double width(const std::string& line) const;

  /// Height of a capital letter or digit [px].
  double cap_height() const;

  /// Writes a line of ASCII text; (x, y) is its left end, middle or right end on the baseline.
  void write(Image& image, const std::string& line, double x, double y, Align align = Align::left,
             Rgb color = kInk) const;

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

}  // namespace render
