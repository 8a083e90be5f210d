#include "app/assembly/ply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "app/assembly/byte_order.h"
#include "app/assembly/ply_head.h"
#include "app/assembly/polygon_mesh.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

/// The numbers of a file of text.
class TextValues {
 public:
  static constexpr PlaceKind kPlaces = PlaceKind::line;
  explicit TextValues(const MeshText& text) : text_(text) {}

  /// Moves on to the next element. @return false at the end of the file
  bool next() { return text_.next_line(); }
  double value(PlyNumber) { return text_.number(); }
  std::size_t rest() const { return text_.rest().size(); }
  std::uint64_t place() const { return static_cast<std::uint64_t>(text_.line()); }
  /// Least bytes of a number: a digit and a blank or the end of the line, which the last one lacks.
  static int least(PlyNumber) { return 2; }

 private:
  MeshText text_;
};

/// The numbers of a binary file.
class BinaryValues {
 public:
  static constexpr PlaceKind kPlaces = PlaceKind::byte;
  BinaryValues(const fs::path& file, std::string_view bytes, std::size_t first, std::endian order)
      : file_(file), bytes_(bytes), at_(first), order_(order) {}

  bool next() const { return rest() > 0; }
  double value(PlyNumber type) {
    if (rest() < static_cast<std::size_t>(size_of(type)))
      fault_at_byte(file_, at_, "the file is cut short: it ends within an element");
    const double value = stored(type);
    at_ += static_cast<std::size_t>(size_of(type));
    return value;
  }
  std::size_t rest() const { return bytes_.size() - at_; }
  std::uint64_t place() const { return at_; }
  static int least(PlyNumber type) { return size_of(type); }

 private:
  double stored(PlyNumber type) const {
    switch (type) {
      case PlyNumber::int8:
        return value_at<std::int8_t>(bytes_, at_, order_);
      case PlyNumber::uint8:
        return value_at<std::uint8_t>(bytes_, at_, order_);
      case PlyNumber::int16:
        return value_at<std::int16_t>(bytes_, at_, order_);
      case PlyNumber::uint16:
        return value_at<std::uint16_t>(bytes_, at_, order_);
      case PlyNumber::int32:
        return value_at<std::int32_t>(bytes_, at_, order_);
      case PlyNumber::uint32:
        return value_at<std::uint32_t>(bytes_, at_, order_);
      case PlyNumber::float32:
        return value_at<float>(bytes_, at_, order_);
      case PlyNumber::float64:
        break;
    }
    return value_at<double>(bytes_, at_, order_);
  }

  const fs::path& file_;
  std::string_view bytes_;
  std::size_t at_;
  std::endian order_;
};

/// Use of a property.
enum class Use { none, x, y, z, corners };

Use use_of(const PlyElement& element, const PlyProperty& property) {
  const bool list = property.count.has_value();
  if (element.name == "vertex" && !list) {
    if (property.name == "x") return Use::x;
    if (property.name == "y") return Use::y;
    if (property.name == "z") return Use::z;
  }
  const bool faces = element.name == "face" || element.name == "tristrips";
  const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
  return faces && list && corners ? Use::corners : Use::none;
}

/// Reads the elements after the head.
template <class Values>
class Body {
 public:
  Body(const fs::path& file, Values values) : values_(values), mesh_(file, Values::kPlaces, 0) {}

  hydro::TriMesh read(const PlyHead& head) {
    for (const PlyElement& element : head.elements) {
      if (element.properties.empty()) continue;
      require_room(element);
      require_uses(element);
      for (std::int64_t i = 0; i < element.count; ++i) {
        if (!values_.next())
          fault(fmt::format("the file is cut short: it ends before {} {} of {}", element.name,
                            i + 1, element.count));
        read_one(element);
      }
    }
    return mesh_.triangles();
  }

 private:
  [[noreturn]] void fault(const std::string& message) const {
    mesh_.fault(values_.place(), message);
  }

  /// Refuses a count for which the file is too short.
  void require_room(const PlyElement& element) const {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties)
      least += static_cast<std::size_t>(Values::least(property.count.value_or(property.type)));
    if (static_cast<std::size_t>(element.count) > (values_.rest() + 1) / least)
      fault(
          fmt::format("the file is cut short: its head announces {} elements '{}', but only {} "
                      "bytes follow",
                      element.count, element.name, values_.rest()));
  }

  void require_uses(const PlyElement& element) {
    uses_.clear();
    for (const PlyProperty& property : element.properties)
      uses_.push_back(use_of(element, property));
    const auto has = [&](Use use) { return std::ranges::count(uses_, use) == 1; };
    if (element.name == "vertex" && !(has(Use::x) && has(Use::y) && has(Use::z)))
      fault("the vertices have no properties x, y and z, or have one twice");
    if (element.name == "face" && !has(Use::corners))
      fault("the faces have no list vertex_indices, or have it twice");
  }

  void read_one(const PlyElement& element) {
    const std::uint64_t place = values_.place();
    Eigen::Vector3d vertex = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.count) {
        read_list(property, uses_[i] == Use::corners);
        continue;
      }
      const double value = values_.value(property.type);
      if (uses_[i] != Use::none) vertex[static_cast<int>(uses_[i]) - 1] = value;
    }
    if (element.name == "vertex") mesh_.add_vertex(vertex, place);
    if (element.name == "face") mesh_.add_polygon(corners_, place);
    if (element.name == "tristrips") add_strips(place);
  }

  std::int64_t whole(double value) const {
    constexpr double kMost = 4294967295;  // the greatest number of the types for whole numbers
    if (!(std::abs(value) <= kMost) || value != std::trunc(value))
      fault(fmt::format("found {:g}, expected a whole number", value));
    return static_cast<std::int64_t>(value);
  }

  void read_list(const PlyProperty& property, bool keep) {
    const std::int64_t count = whole(values_.value(*property.count));
    if (count < 0) fault(fmt::format("a list has {} numbers, expected 0 or more", count));
    if (keep) corners_.clear();
    for (std::int64_t i = 0; i < count; ++i) {
      const double value = values_.value(property.type);
      if (keep) corners_.push_back(whole(value));
    }
  }

  /// Every other triangle of a strip has its corners in the opposite order.
  void add_strips(std::uint64_t place) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (corners_[i] == -1) first = i + 1;
      if (i < first + 2) continue;
      const bool odd = (i - first) % 2 != 0;
      mesh_.add_polygon(
          std::array{corners_[i - 2], corners_[odd ? i : i - 1], corners_[odd ? i - 1 : i]}, place);
    }
  }

  Values values_;
  PolygonMesh mesh_;
  std::vector<Use> uses_;
  std::vector<std::int64_t> corners_;
};

/// True if the coordinates of a binary file are floats.
bool stores_floats(const PlyHead& head) {
  for (const PlyElement& element : head.elements)
    for (const PlyProperty& property : element.properties) {
      const Use use = use_of(element, property);
      if (use != Use::none && use != Use::corners && property.type == PlyNumber::float32)
        return true;
    }
  return false;
}

}  // namespace

MeshFile read_ply(const fs::path& file, std::string_view bytes) {
  MeshText text(file, bytes);
  const PlyHead head = read_ply_head(text);
  if (head.encoding == PlyEncoding::ascii)
    return {.mesh = Body(file, TextValues(text)).read(head),
            .frame = {},
            .rounding = Rounding::as_written};
  const std::endian order =
      head.encoding == PlyEncoding::binary_little_endian ? std::endian::little : std::endian::big;
  const BinaryValues values(file, bytes, bytes.size() - text.rest().size(), order);
  return {.mesh = Body(file, values).read(head),
          .frame = {},
          .rounding = stores_floats(head) ? Rounding::of_floats : Rounding::as_written};
}

}  // namespace assembly
