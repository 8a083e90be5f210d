#pragma once

#include <memory>
#include <string>

#include "app/render/image.h"

namespace render {

/// Alignment of a line of text with its point.
enum class Align { left, center, right };

/// Colours of text on pictures and of its background.
inline constexpr Rgb kInk = {25, 32, 40};
inline constexpr Rgb kPaper = {255, 255, 255};

inline constexpr double kPaperWeight = 0.78;  ///< Opacity of the background.

/// Returns the text size for a picture [px]: 18 at 720 lines, legible when it is printed a column
/// wide. The size is 0 if width or height is below 120 pixels, where letters would run together.
int text_size_on(const Image& image);

/// A typeface at one size.
class Font {
 public:
  /// Loads DejaVu Sans or the system's substitute for it. @param size   Em size [px].
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
