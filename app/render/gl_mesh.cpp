#include "app/render/gl_mesh.h"

#include <cassert>
#include <cstdint>
#include <utility>

namespace render {

GlMesh::GlMesh(const GlFunctions& gl, const Eigen::Ref<const Eigen::MatrixXi>& elements)
    : gl_(&gl),
      kind_(elements.rows() == 2 ? GL_LINES : GL_TRIANGLES),
      index_count_(static_cast<GLsizei>(elements.size())) {
  assert(elements.outerStride() == elements.rows());
  gl.GenVertexArrays(1, &array_);
  gl.BindVertexArray(array_);
  gl.GenBuffers(1, &indices_);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                static_cast<GLsizeiptr>(elements.size()) * static_cast<GLsizeiptr>(sizeof(int)),
                elements.data(), GL_STATIC_DRAW);
}

GlMesh::~GlMesh() {
  if (!gl_) return;
  gl_->DeleteVertexArrays(1, &array_);
  gl_->DeleteBuffers(1, &indices_);
  gl_->DeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());  // Zeros are ignored.
}

void GlMesh::swap(GlMesh& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(array_, other.array_);
  std::swap(kind_, other.kind_);
  std::swap(index_count_, other.index_count_);
  std::swap(indices_, other.indices_);
  std::swap(buffers_, other.buffers_);
}

void GlMesh::set(GLuint location, const Eigen::Ref<const Eigen::MatrixXf>& values) {
  assert(values.outerStride() == values.rows());
  GLuint& buffer = buffers_.at(location);
  gl_->BindVertexArray(array_);
  if (!buffer) gl_->GenBuffers(1, &buffer);
  gl_->BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl_->BufferData(GL_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(values.size()) * static_cast<GLsizeiptr>(sizeof(float)),
                  values.data(), GL_DYNAMIC_DRAW);
  gl_->VertexAttribPointer(location, static_cast<GLint>(values.rows()), GL_FLOAT, GL_FALSE, 0,
                           nullptr);
  gl_->EnableVertexAttribArray(location);
}

void GlMesh::draw(Eigen::Index first, Eigen::Index count) const {
  const Eigen::Index corners = kind_ == GL_LINES ? 2 : 3;
  const auto offset = static_cast<std::uintptr_t>(first * corners) * sizeof(int);
  gl_->BindVertexArray(array_);
  gl_->DrawElements(kind_, static_cast<GLsizei>(count * corners), GL_UNSIGNED_INT,
                    reinterpret_cast<const void*>(offset));
}

}  // namespace render
