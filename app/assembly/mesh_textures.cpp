#include "app/assembly/mesh_textures.h"

#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace assembly {
namespace {

namespace fs = std::filesystem;

/// Returns a path with slashes and without blanks at its ends, as programs for Windows do not
/// always write it.
std::string plain_path(std::string path) {
  std::ranges::replace(path, '\\', '/');
  const std::size_t first = path.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return path.substr(first, path.find_last_not_of(" \t\r") + 1 - first);
}

/// Returns the text of an address with its escapes resolved (RFC 3986, 2.1).
std::string without_escapes(const std::string& address) {
  std::string text;
  for (std::size_t i = 0; i < address.size(); ++i) {
    unsigned char code = 0;
    const char* const digits = address.data() + i + 1;
    const bool escape = address[i] == '%' && i + 2 < address.size() &&
                        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    text.push_back(escape ? static_cast<char>(code) : address[i]);
    if (escape) i += 2;
  }
  return text;
}

}  // namespace

fs::path TextureCollector::found(const std::string& name) const {
  for (const std::string& text : {name, without_escapes(name)}) {
    const fs::path path(text);
    for (const fs::path& file : {folder_ / path, folder_ / path.filename()})
      if (path.has_filename() && access_.Exists(file.c_str())) return file;
  }
  return {};
}

TextureSource TextureCollector::source_of(const std::string& path) const {
  const aiTexture* const embedded = scene_.GetEmbeddedTexture(path.c_str());
  if (embedded == nullptr) return {.name = plain_path(path), .file = found(plain_path(path))};
  const auto number = std::find(scene_.mTextures, scene_.mTextures + scene_.mNumTextures, embedded);
  TextureSource source{.name = fmt::format("number {} in it", number - scene_.mTextures + 1)};
  // With a height assimp has decoded it, which it does for none of the formats with colours.
  if (embedded->mHeight == 0)
    source.bytes.assign(reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth);
  return source;
}

MaterialTexture TextureCollector::texture_of(const aiMaterial& material) {
  aiString path;
  MaterialTexture texture;
  if (material.GetTexture(aiTextureType_DIFFUSE, 0, &path, nullptr, &texture.channel) != AI_SUCCESS)
    return {};
  const auto [known, is_new] = numbers_.emplace(path.C_Str(), static_cast<int>(sources_.size()));
  if (is_new) sources_.push_back(source_of(path.C_Str()));
  texture.number = known->second;
  return texture;
}

}  // namespace assembly
