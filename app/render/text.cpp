#include "app/render/text.h"

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>
#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include FT_FREETYPE_H

namespace render {
namespace {

constexpr const char* kFontAdvice = "install one: apt install fonts-dejavu-core";

/// FreeType counts in 64ths of a pixel.
constexpr double kUnits = 64;

struct PatternDeleter {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};
using Pattern = std::unique_ptr<FcPattern, PatternDeleter>;

struct ConfigDeleter {
  void operator()(FcConfig* config) const { FcConfigDestroy(config); }
};

std::string font_file() {
  const std::unique_ptr<FcConfig, ConfigDeleter> config(FcInitLoadConfigAndFonts());
  const Pattern wanted(FcNameParse(reinterpret_cast<const FcChar8*>("DejaVu Sans:style=Book")));
  if (!config || !wanted) throw Error(fmt::format("fonts cannot be looked up; {}", kFontAdvice));
  FcConfigSubstitute(config.get(), wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern found(FcFontMatch(config.get(), wanted.get(), &result));
  FcChar8* file = nullptr;
  if (!found || FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch)
    throw Error(fmt::format("there is no font for the text in pictures; {}", kFontAdvice));
  return reinterpret_cast<const char*>(file);
}

}  // namespace

struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  ~Face() {
    FT_Done_Face(face);
    FT_Done_FreeType(library);
  }

  /// Loads and renders a letter with its origin `shift` 64ths of a pixel to the right.
  FT_GlyphSlot letter(char c, long shift) const {
    FT_Vector offset = {shift, 0};
    FT_Set_Transform(face, nullptr, &offset);
    FT_Load_Char(face, static_cast<unsigned char>(c), FT_LOAD_RENDER | FT_LOAD_NO_HINTING);
    return face->glyph;
  }
};

int text_size_on(const Image& image) {
  constexpr int kLeastExtent = 120, kSmallest = 11;
  const int extent = std::min(image.width, image.height);
  return extent < kLeastExtent ? 0 : std::max(kSmallest, extent / 40);
}

Font::Font(int size) : face_(std::make_unique<Face>()) {
  static const std::string file = font_file();
  if (FT_Init_FreeType(&face_->library) ||
      FT_New_Face(face_->library, file.c_str(), 0, &face_->face) ||
      FT_Set_Pixel_Sizes(face_->face, 0, static_cast<FT_UInt>(size)))
    throw Error(fmt::format("{}: not a usable font; {}", file, kFontAdvice));
}

Font::~Font() = default;
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;

double Font::width(const std::string& line) const {
  double width = 0;
  for (const char c : line)
    width += static_cast<double>(face_->letter(c, 0)->linearHoriAdvance) / 65536;
  return width;
}

double Font::cap_height() const {
  return static_cast<double>(face_->letter('H', 0)->metrics.height) / kUnits;
}

void Font::write(Image& image, const std::string& line, double x, double y, Align align,
                 Rgb color) const {
  if (align == Align::center) x -= width(line) / 2;
  if (align == Align::right) x -= width(line);
  const int baseline = static_cast<int>(std::lround(y));
  for (const char c : line) {
    const double whole = std::floor(x);
    const FT_GlyphSlot glyph = face_->letter(c, std::lround((x - whole) * kUnits));
    const FT_Bitmap& bitmap = glyph->bitmap;
    for (int row = 0; row < static_cast<int>(bitmap.rows); ++row)
      for (int column = 0; column < static_cast<int>(bitmap.width); ++column)
        blend(image, static_cast<int>(whole) + glyph->bitmap_left + column,
              baseline - glyph->bitmap_top + row, color,
              bitmap.buffer[row * bitmap.pitch + column] / 255.0);
    x += static_cast<double>(glyph->linearHoriAdvance) / 65536;
  }
}

}  // namespace render
