#include "app/pictures/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>

#include "app/base/byte_records.h"
#include "app/base/quoting.h"
#include "app/render/jpeg.h"
#include "app/render/png.h"
#include "app/scene/diagnostics.h"
#include "app/scene/isolated_reader.h"

namespace app {
namespace {

namespace fs = std::filesystem;

/// Bytes of a name that warnings have: glTF may name an image by megabytes of its content.
constexpr std::size_t kLongestName = 100;

std::string bytes_of(const assembly::TextureSource& source) {
  if (source.file.empty()) return source.bytes;
  std::ifstream stream(source.file, std::ios::binary);
  if (!stream) throw render::Error("cannot be opened");
  return {std::istreambuf_iterator<char>(stream), {}};
}

render::Image decoded(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return render::decode_png(bytes, kMostTexturePixels);
  if (bytes.starts_with("\xFF\xD8\xFF")) return render::decode_jpeg(bytes, kMostTexturePixels);
  throw render::Error("neither PNG nor JPEG");
}

/// Decodes a texture, in a process of its own. @throws InputError
render::Image decoded(const assembly::TextureSource& source) {
  render::Image image;
  try {
    image = decoded(bytes_of(source));
  } catch (const render::Error& error) {
    throw scene::InputError(source.name, error.what());
  }
  while (std::max(image.width, image.height) > kLongestTextureSide) image = render::halved(image);
  return image;
}

void put_image(const render::Image& image, const CallOutput& output) {
  put_record(output, std::span(&image.width, 1));
  put_record(output, std::span(&image.height, 1));
  put_record(output, std::span(image.rgb));
}

std::shared_ptr<const render::Image> read_texture(const assembly::TextureSource& source,
                                                  const fs::path& mesh_file) {
  constexpr int kSeconds = 10;
  constexpr double kBytesPerSecond = 1e6;
  const fs::path file = source.file.empty() ? mesh_file : source.file;
  const std::string bytes = scene::read_isolated(
      file, "the reader of pictures",
      [&](const CallOutput& output) { put_image(decoded(source), output); },
      scene::limits_by_size(file, kSeconds, kBytesPerSecond));
  ByteRecords records(bytes);
  render::Image image;
  image.width = records.values<int>().at(0);
  image.height = records.values<int>().at(0);
  image.rgb = records.values<std::uint8_t>();
  return std::make_shared<const render::Image>(std::move(image));
}

}  // namespace

ReadTextures read_textures(const std::vector<assembly::TextureSource>& sources,
                           const fs::path& mesh_file) {
  ReadTextures read;
  for (const assembly::TextureSource& source : sources) {
    std::string fault;
    read.images.emplace_back();
    if (source.file.empty() && source.bytes.empty())
      fault = "there is no such file in its folder or below";
    else
      try {
        read.images.back() = read_texture(source, mesh_file);
      } catch (const scene::InputError& error) {
        fault = error.faults().front().message;
      }
    if (!fault.empty())
      read.warnings.push_back(shown(
          fmt::format("the texture {} of {}: {}; the base colours are shown in its place",
                      source.name.substr(0, kLongestName), mesh_file.filename().string(), fault)));
  }
  return read;
}

}  // namespace app
