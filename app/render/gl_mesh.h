#pragma once

#include <Eigen/Core>
#include <array>

#include "app/render/gl_functions.h"

namespace render {

/// Indexed triangles or lines on the graphics device. Its context must be current when the mesh is
/// destroyed.
class GlMesh {
 public:
  /// @param elements   Vertex indices of triangles (3×T) or lines (2×L), in drawing order.
  GlMesh(const GlFunctions& gl, const Eigen::Ref<const Eigen::MatrixXi>& elements);
  ~GlMesh();
  GlMesh(GlMesh&& other) noexcept { swap(other); }
  GlMesh& operator=(GlMesh&& other) noexcept {
    swap(other);
    return *this;
  }

  /// Sets vertex attribute `location` from one column per vertex with 1 to 4 rows. The values may
  /// change between pictures, the number of columns may not.
  void set(GLuint location, const Eigen::Ref<const Eigen::MatrixXf>& values);

  void draw() const { draw(0, index_count_ / (kind_ == GL_LINES ? 2 : 3)); }
  /// Draws `count` elements, triangles or lines, from `first` on.
  void draw(Eigen::Index first, Eigen::Index count) const;

 private:
  void swap(GlMesh& other) noexcept;

  const GlFunctions* gl_ = nullptr;
  GLuint array_ = 0;
  GLenum kind_ = 0;
  GLsizei index_count_ = 0;
  GLuint indices_ = 0;
  std::array<GLuint, 7> buffers_ = {};
};

}  // namespace render
