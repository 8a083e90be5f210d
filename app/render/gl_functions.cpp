#include "app/render/gl_functions.h"

#include <fmt/format.h>

#include "app/render/image.h"

namespace render {
namespace {

template <typename Function>
void load(FunctionFinder find, Function& function, const char* name) {
  function = reinterpret_cast<Function>(find(name));
  if (!function) throw Error(fmt::format("the graphics library has no {}", name));
}

}  // namespace

GlFunctions load_gl_functions(FunctionFinder find) {
  GlFunctions gl;
  load(find, gl.ActiveTexture, "glActiveTexture");
  load(find, gl.AttachShader, "glAttachShader");
  load(find, gl.BindBuffer, "glBindBuffer");
  load(find, gl.BindFramebuffer, "glBindFramebuffer");
  load(find, gl.BindRenderbuffer, "glBindRenderbuffer");
  load(find, gl.BindTexture, "glBindTexture");
  load(find, gl.BindVertexArray, "glBindVertexArray");
  load(find, gl.BlendEquation, "glBlendEquation");
  load(find, gl.BlendFunc, "glBlendFunc");
  load(find, gl.BlitFramebuffer, "glBlitFramebuffer");
  load(find, gl.BufferData, "glBufferData");
  load(find, gl.CheckFramebufferStatus, "glCheckFramebufferStatus");
  load(find, gl.Clear, "glClear");
  load(find, gl.ColorMask, "glColorMask");
  load(find, gl.CompileShader, "glCompileShader");
  load(find, gl.CreateProgram, "glCreateProgram");
  load(find, gl.CreateShader, "glCreateShader");
  load(find, gl.DeleteBuffers, "glDeleteBuffers");
  load(find, gl.DeleteFramebuffers, "glDeleteFramebuffers");
  load(find, gl.DeleteRenderbuffers, "glDeleteRenderbuffers");
  load(find, gl.DeleteShader, "glDeleteShader");
  load(find, gl.DeleteTextures, "glDeleteTextures");
  load(find, gl.DeleteVertexArrays, "glDeleteVertexArrays");
  load(find, gl.DepthFunc, "glDepthFunc");
  load(find, gl.DepthMask, "glDepthMask");
  load(find, gl.Disable, "glDisable");
  load(find, gl.DrawBuffer, "glDrawBuffer");
  load(find, gl.DrawElements, "glDrawElements");
  load(find, gl.Enable, "glEnable");
  load(find, gl.EnableVertexAttribArray, "glEnableVertexAttribArray");
  load(find, gl.FramebufferRenderbuffer, "glFramebufferRenderbuffer");
  load(find, gl.FramebufferTexture2D, "glFramebufferTexture2D");
  load(find, gl.GenBuffers, "glGenBuffers");
  load(find, gl.GenFramebuffers, "glGenFramebuffers");
  load(find, gl.GenRenderbuffers, "glGenRenderbuffers");
  load(find, gl.GenTextures, "glGenTextures");
  load(find, gl.GenVertexArrays, "glGenVertexArrays");
  load(find, gl.GenerateMipmap, "glGenerateMipmap");
  load(find, gl.GetError, "glGetError");
  load(find, gl.GetProgramInfoLog, "glGetProgramInfoLog");
  load(find, gl.GetProgramiv, "glGetProgramiv");
  load(find, gl.GetShaderInfoLog, "glGetShaderInfoLog");
  load(find, gl.GetShaderiv, "glGetShaderiv");
  load(find, gl.GetString, "glGetString");
  load(find, gl.GetUniformLocation, "glGetUniformLocation");
  load(find, gl.LinkProgram, "glLinkProgram");
  load(find, gl.PixelStorei, "glPixelStorei");
  load(find, gl.ReadBuffer, "glReadBuffer");
  load(find, gl.ReadPixels, "glReadPixels");
  load(find, gl.RenderbufferStorageMultisample, "glRenderbufferStorageMultisample");
  load(find, gl.ShaderSource, "glShaderSource");
  load(find, gl.TexImage2D, "glTexImage2D");
  load(find, gl.TexImage2DMultisample, "glTexImage2DMultisample");
  load(find, gl.TexParameteri, "glTexParameteri");
  load(find, gl.Uniform1f, "glUniform1f");
  load(find, gl.Uniform1i, "glUniform1i");
  load(find, gl.Uniform3fv, "glUniform3fv");
  load(find, gl.UniformMatrix3fv, "glUniformMatrix3fv");
  load(find, gl.UniformMatrix4fv, "glUniformMatrix4fv");
  load(find, gl.UseProgram, "glUseProgram");
  load(find, gl.VertexAttribPointer, "glVertexAttribPointer");
  load(find, gl.Viewport, "glViewport");
  return gl;
}

}  // namespace render
