#pragma once

#include <Eigen/Core>
#include <array>

#include "app/render/gl_functions.h"

namespace render {

/// Indexed triangles or lines on the graphics device. Goes with the context it is made in, which
/// must be current when it goes before.
class GlMesh {
 public:
  /// @param elements   3×T or 2×L, vertex numbers, in the order in which they are drawn.
  GlMesh(const GlFunctions& gl, const Eigen::Ref<const Eigen::MatrixXi>& elements);
  ~GlMesh();
  GlMesh(GlMesh&& other) noexcept { swap(other); }
  GlMesh& operator=(GlMesh&& other) noexcept {
    swap(other);
    return *this;
  }

  /// Sets vertex attribute `location`: a column a vertex, 1 to 4 rows. May be called for each
  /// picture; the number of columns stays the same.
  void set(GLuint location, const Eigen::Ref<const Eigen::MatrixXf>& values);

  void draw() const;

 private:
  void swap(GlMesh& other) noexcept;

  const GlFunctions* gl_ = nullptr;
  GLuint array_ = 0;
  GLenum kind_ = 0;
  GLsizei index_count_ = 0;
  GLuint indices_ = 0;
  std::array<GLuint, 4> buffers_ = {};
};

}  // namespace render
