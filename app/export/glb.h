#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace app {

/// A binary glTF 2.0 file while it is put together: a JSON document and the numbers that its
/// accessors name. https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
class Glb {
 public:
  /// The use of an accessor, which its buffer view declares.
  enum class Use { vertices, animation };

  Glb();

  nlohmann::ordered_json document;

  // Adding throws std::length_error beyond 4 GiB, which the format cannot hold.

  /// Adds an accessor. @return its index
  /// @param elements   An element per column: 1 (SCALAR), 3 (VEC3) or 4 (VEC4) rows.
  std::size_t add(const Eigen::MatrixXf& elements, Use use);
  /// Adds the accessor of the corners of triangles, three per column. @return its index
  std::size_t add(const Eigen::Matrix3Xi& triangles);

  /// Appends an object to a list of the document. @return its index in the list
  std::size_t append(const char* list, nlohmann::ordered_json object);

  /// The bytes of the file. @throws std::length_error beyond 4 GiB
  std::string bytes() const;

 private:
  std::size_t add_view(const void* data, std::size_t bytes, int target);

  std::string binary_;
};

}  // namespace app
