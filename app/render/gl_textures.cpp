#include "app/render/gl_textures.h"

#include <algorithm>
#include <vector>

namespace render {
namespace {

/// Returns the rows of an image from the bottom, in which order OpenGL takes them.
std::vector<std::uint8_t> upward_rows(const Image& image) {
  const std::size_t row = std::size_t{3} * static_cast<std::size_t>(image.width);
  std::vector<std::uint8_t> rgb(image.rgb.size());
  for (int y = 0; y < image.height; ++y)
    std::copy_n(image.pixel(0, image.height - 1 - y), row,
                rgb.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y)));
  return rgb;
}

}  // namespace

GlTextures::~GlTextures() {
  for (const auto& [image, name] : names_) gl_->DeleteTextures(1, &name);
}

GLuint GlTextures::of(const Image& image) {
  GLuint& name = names_[&image];
  if (name != 0) return name;
  gl_->GenTextures(1, &name);
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(GL_TEXTURE_2D, name);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                  upward_rows(image).data());
  gl_->GenerateMipmap(GL_TEXTURE_2D);
  for (const GLenum key : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_->TexParameteri(GL_TEXTURE_2D, key, GL_REPEAT);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return name;
}

}  // namespace render
