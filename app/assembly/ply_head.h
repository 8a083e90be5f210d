#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/assembly/mesh_text.h"

/// @file
/// The head of a PLY file: which elements follow, and which numbers each has.

namespace assembly {

enum class PlyNumber { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Size of a number in a binary file [bytes].
int size_of(PlyNumber type);

/// A number of an element, or a list of numbers after their count.
struct PlyProperty {
  std::string name;
  PlyNumber type = PlyNumber::float32;
  std::optional<PlyNumber> count;  ///< Type of a list's count; none for a single number.
};

/// Elements of one kind.
struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { ascii, binary_little_endian, binary_big_endian };

struct PlyHead {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
};

/// Reads the head; `text` is then at its last line. @throws InputError with the line of the fault
PlyHead read_ply_head(MeshText& text);

}  // namespace assembly
