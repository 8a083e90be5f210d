#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "app/render/gl_functions.h"

namespace render {

/// A vertex and a fragment shader, linked. Lives as long as the context it is made in.
class GlProgram {
 public:
  /// Compiles `name.vert` and `name.frag` of a folder, each after the folder's `common.glsl`.
  /// @throws Error for a file that cannot be read, or `shaders/name.frag:LINE: …` with what the
  ///         compiler says.
  GlProgram(const GlFunctions& gl, const std::filesystem::path& folder, const std::string& name);

  /// Makes the program current; `set` works on the current program. A uniform that the shaders do
  /// not use is passed over, so that all programs can be given the same view.
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

/// Lines of a shader's own file are numbered from here for the compiler, those of the shared file
/// from 1, so that a complaint's line tells the file. (Not all compilers keep the number of the
/// source string that `#line` can set.)
inline constexpr int kOwnLines = 100'000;

/// The first complaint in a compiler's log as `FILE:LINE: …`. Compilers write its place as
/// `0:LINE(COLUMN):`, `0(LINE) :` or `0:LINE:`.
std::string place_of_shader_error(const std::string& log, const std::filesystem::path& common,
                                  const std::filesystem::path& own);

}  // namespace render
