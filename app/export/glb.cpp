#include "app/export/glb.h"

#include <cstdint>
#include <limits>
#include <stdexcept>

namespace app {
namespace {

using Json = nlohmann::ordered_json;

// Numbers that the format has for types and uses.
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963, kNoTarget = 0;
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2;                   // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;  // "JSON", "BIN\0"

constexpr std::size_t kMostBytes = std::numeric_limits<std::uint32_t>::max();
const char* const kTooLarge = "would be larger than 4 GiB, which glTF cannot hold";

const char* type_of(Eigen::Index rows) {
  return rows == 1 ? "SCALAR" : rows == 3 ? "VEC3" : "VEC4";
}

Json list_of(const Eigen::VectorXf& numbers) {
  Json list = Json::array();
  for (const float number : numbers) list.push_back(number);
  return list;
}

void append_word(std::string& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(word >> shift & 0xFF);  // little-endian
}

void append_chunk(std::string& bytes, std::uint32_t kind, const std::string& content) {
  append_word(bytes, static_cast<std::uint32_t>(content.size()));
  append_word(bytes, kind);
  bytes += content;
}

}  // namespace

Glb::Glb() {
  document["asset"] = {{"version", "2.0"}, {"generator", "plimsoll " PLIMSOLL_VERSION}};
}

std::size_t Glb::append(const char* list, Json object) {
  Json& objects = document[list];
  objects.push_back(std::move(object));
  return objects.size() - 1;
}

std::size_t Glb::add_view(const void* data, std::size_t bytes, int target) {
  Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes}};
  if (target != kNoTarget) view["target"] = target;
  if (binary_.size() + bytes > kMostBytes) throw std::length_error(kTooLarge);
  binary_.append(static_cast<const char*>(data), bytes);
  return append("bufferViews", std::move(view));
}

std::size_t Glb::add(const Eigen::MatrixXf& elements, Use use) {
  const auto bytes = static_cast<std::size_t>(elements.size()) * sizeof(float);
  const std::size_t view =
      add_view(elements.data(), bytes, use == Use::vertices ? kArrayBuffer : kNoTarget);
  return append("accessors", {{"bufferView", view},
                              {"componentType", kFloat},
                              {"count", elements.cols()},
                              {"type", type_of(elements.rows())},
                              {"min", list_of(elements.rowwise().minCoeff())},
                              {"max", list_of(elements.rowwise().maxCoeff())}});
}

std::size_t Glb::add(const Eigen::Matrix3Xi& triangles) {
  const Eigen::Matrix<std::uint32_t, 3, Eigen::Dynamic> corners = triangles.cast<std::uint32_t>();
  const auto bytes = static_cast<std::size_t>(corners.size()) * sizeof(std::uint32_t);
  const std::size_t view = add_view(corners.data(), bytes, kElementArrayBuffer);
  return append("accessors", {{"bufferView", view},
                              {"componentType", kUnsignedInt},
                              {"count", corners.size()},
                              {"type", "SCALAR"}});
}

std::string Glb::bytes() const {
  Json whole = document;
  if (!binary_.empty()) whole["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
  std::string json = whole.dump(-1, ' ', false, Json::error_handler_t::replace);
  json.append((4 - json.size() % 4) % 4, ' ');
  constexpr std::size_t kHeads = 12 + 8 + 8;
  const std::size_t size = kHeads + json.size() + binary_.size();
  if (size > kMostBytes) throw std::length_error(kTooLarge);
  std::string file;
  file.reserve(size);
  append_word(file, kMagic);
  append_word(file, kVersion);
  append_word(file, static_cast<std::uint32_t>(size));
  append_chunk(file, kJsonChunk, json);
  append_chunk(file, kBinaryChunk, binary_);
  return file;
}

}  // namespace app
