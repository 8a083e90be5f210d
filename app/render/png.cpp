#include "app/render/png.h"

#include <fmt/format.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace render {
namespace {

/// libpng's description of an image, released by the destructor.
class SimplifiedImage {
 public:
  SimplifiedImage() { image_.version = PNG_IMAGE_VERSION; }
  ~SimplifiedImage() { png_image_free(&image_); }
  SimplifiedImage(const SimplifiedImage&) = delete;
  SimplifiedImage& operator=(const SimplifiedImage&) = delete;
  png_image* operator->() { return &image_; }
  png_image* get() { return &image_; }

 private:
  png_image image_{};
};

}  // namespace

void write_png(const Image& image, const std::filesystem::path& file) {
  SimplifiedImage png;
  png->width = static_cast<png_uint_32>(image.width);
  png->height = static_cast<png_uint_32>(image.height);
  png->format = PNG_FORMAT_RGB;
  // The fast setting takes a tenth of the time and a quarter more bytes.
  png->flags = PNG_IMAGE_FLAG_FAST;
  const std::string part = fmt::format("{}.part-{}", file.string(), ::getpid());
  std::string fault;
  if (!png_image_write_to_file(png.get(), part.c_str(), 0, image.rgb.data(), 0, nullptr))
    fault = png->message;
  else if (std::rename(part.c_str(), file.c_str()) != 0)
    fault = std::strerror(errno);
  if (fault.empty()) return;
  std::remove(part.c_str());
  throw Error(fmt::format("{}: cannot write the picture: {}", file.string(), fault));
}

Image read_png(const std::filesystem::path& file) {
  SimplifiedImage png;
  if (!png_image_begin_read_from_file(png.get(), file.c_str()))
    throw Error(fmt::format("{}: cannot read the picture: {}", file.string(), png->message));
  png->format = PNG_FORMAT_RGB;
  Image image =
      filled_image(static_cast<int>(png->width), static_cast<int>(png->height), {255, 255, 255});
  const png_color white = {255, 255, 255};
  if (!png_image_finish_read(png.get(), &white, image.rgb.data(), 0, nullptr))
    throw Error(fmt::format("{}: cannot read the picture: {}", file.string(), png->message));
  return image;
}

Image decode_png(std::string_view bytes, double most_pixels) {
  SimplifiedImage png;
  if (!png_image_begin_read_from_memory(png.get(), bytes.data(), bytes.size()))
    throw Error(fmt::format("not a sound PNG: {}", png->message));
  require_pixels(png->width, png->height, most_pixels);
  Image image = {static_cast<int>(png->width), static_cast<int>(png->height), {}};
  // libpng would blend transparent pixels with a colour.
  const bool alpha = (png->format & PNG_FORMAT_FLAG_ALPHA) != 0;
  png->format = alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  image.rgb.resize(PNG_IMAGE_SIZE(*png.get()));
  if (!png_image_finish_read(png.get(), nullptr, image.rgb.data(), 0, nullptr))
    throw Error(fmt::format("not a sound PNG: {}", png->message));
  if (!alpha) return image;
  const std::size_t pixels = image.rgb.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i) std::copy_n(&image.rgb[4 * i], 3, &image.rgb[3 * i]);
  image.rgb.resize(3 * pixels);
  return image;
}

}  // namespace render
