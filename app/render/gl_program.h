#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "app/render/gl_functions.h"

namespace render {

/// A linked vertex and fragment shader. It is destroyed with its context.
class GlProgram {
 public:
  /// Compiles `name.vert` and `name.frag` of a folder, each after the folder's `common.glsl`.
  /// @throws Error if a file cannot be read, or `shaders/name.frag:LINE: …` with the compiler's
  ///     message.
  GlProgram(const GlFunctions& gl, const std::filesystem::path& folder, const std::string& name)
      : GlProgram(gl, folder, name, name) {}

  /// The same of `vertex.vert` and `fragment.frag`.
  GlProgram(const GlFunctions& gl, const std::filesystem::path& folder, const std::string& vertex,
            const std::string& fragment);

  /// Makes the program current; `set` works on the current program. A uniform that the shaders do
  /// not use is ignored, so that all programs can be given the same view.
  void use() const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, double value) const;
  void set(const char* uniform, const Eigen::Vector3d& value) const;
  void set(const char* uniform, const Eigen::Matrix3d& value) const;
  void set(const char* uniform, const Eigen::Matrix4d& value) const;

 private:
  const GlFunctions* gl_;
  GLuint program_ = 0;
};

/// Line offset of a shader's own file. Lines of `common.glsl` start at 1, so that the line of a
/// compiler's error identifies the file. (Not all compilers keep the number of the source string
/// that `#line` can set.)
inline constexpr int kOwnLines = 100'000;

/// Returns the first error in a compiler's log as `FILE:LINE: …`. Compilers write its line as
/// `0:LINE(COLUMN):`, `0(LINE) :` or `0:LINE:`.
std::string place_of_shader_error(const std::string& log, const std::filesystem::path& common,
                                  const std::filesystem::path& own);

}  // namespace render
