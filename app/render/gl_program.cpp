#include "app/render/gl_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "app/render/image.h"

namespace render {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file))
    throw Error(fmt::format("{}: cannot read the shader", file.string()));
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string log_of_shader(const GlFunctions& gl, GLuint shader) {
  std::array<char, 4096> text{};
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(text.size()), nullptr, text.data());
  return text.data();
}

GLuint compile(const GlFunctions& gl, GLenum stage, const fs::path& file) {
  const fs::path common = file.parent_path() / "common.glsl";
  const std::string text = fmt::format("#version 330 core\n#line 1\n{}\n#line {}\n{}",
                                       read_text(common), kOwnLines + 1, read_text(file));
  const GLchar* source = text.c_str();
  const GLuint shader = gl.CreateShader(stage);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint compiled = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (!compiled) throw Error(place_of_shader_error(log_of_shader(gl, shader), common, file));
  return shader;
}

}  // namespace

std::string place_of_shader_error(const std::string& log, const fs::path& common,
                                  const fs::path& own) {
  int line = 0, length = 0;
  std::size_t at = 0;
  const auto is_place = [&](std::size_t i) {
    return std::sscanf(log.c_str() + i, "%*1d%*1[:(]%d%n", &line, &length) == 1;
  };
  while (at < log.size() && !is_place(at)) ++at;
  if (at == log.size()) return fmt::format("{}: {}", own.string(), log);
  const std::size_t message = std::min(log.find(": ", at + length), log.size() - 2) + 2;
  const std::string said = log.substr(message, log.find('\n', message) - message);
  return line > kOwnLines ? fmt::format("{}:{}: {}", own.string(), line - kOwnLines, said)
                          : fmt::format("{}:{}: {}", common.string(), line, said);
}

GlProgram::GlProgram(const GlFunctions& gl, const fs::path& folder, const std::string& vertex,
                     const std::string& fragment)
    : gl_(&gl) {
  const GLuint shaders[] = {compile(gl, GL_VERTEX_SHADER, folder / (vertex + ".vert")),
                            compile(gl, GL_FRAGMENT_SHADER, folder / (fragment + ".frag"))};
  program_ = gl.CreateProgram();
  for (const GLuint shader : shaders) gl.AttachShader(program_, shader);
  gl.LinkProgram(program_);
  for (const GLuint shader : shaders) gl.DeleteShader(shader);
  GLint linked = 0;
  gl.GetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked) return;
  std::array<char, 4096> text{};
  gl.GetProgramInfoLog(program_, static_cast<GLsizei>(text.size()), nullptr, text.data());
  throw Error(
      fmt::format("{}: the shaders do not link: {}", (folder / fragment).string(), text.data()));
}

void GlProgram::use() const { gl_->UseProgram(program_); }

void GlProgram::set(const char* uniform, int value) const {
  gl_->Uniform1i(gl_->GetUniformLocation(program_, uniform), value);
}

void GlProgram::set(const char* uniform, double value) const {
  gl_->Uniform1f(gl_->GetUniformLocation(program_, uniform), static_cast<float>(value));
}

void GlProgram::set(const char* uniform, const Eigen::Vector3d& value) const {
  const Eigen::Vector3f v = value.cast<float>();
  gl_->Uniform3fv(gl_->GetUniformLocation(program_, uniform), 1, v.data());
}

void GlProgram::set(const char* uniform, const Eigen::Matrix3d& value) const {
  const Eigen::Matrix3f m = value.cast<float>();
  gl_->UniformMatrix3fv(gl_->GetUniformLocation(program_, uniform), 1, GL_FALSE, m.data());
}

void GlProgram::set(const char* uniform, const Eigen::Matrix4d& value) const {
  const Eigen::Matrix4f m = value.cast<float>();
  gl_->UniformMatrix4fv(gl_->GetUniformLocation(program_, uniform), 1, GL_FALSE, m.data());
}

}  // namespace render
