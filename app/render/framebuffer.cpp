#include "app/render/framebuffer.h"

#include <fmt/format.h>

#include <algorithm>

namespace render {
namespace {

GLuint make_framebuffer(const GlFunctions& gl) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_FRAMEBUFFER, name);
  return name;
}

/// Storage attached to the bound framebuffer.
struct Storage {
  GLenum attachment, format;
  int samples;
};

GLuint attach_storage(const GlFunctions& gl, Storage storage, int width, int height) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, storage.samples, storage.format, width,
                                    height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, storage.attachment, GL_RENDERBUFFER, name);
  return name;
}

GLuint attach_depth_texture(const GlFunctions& gl, int samples, int width, int height) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, name);
  gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, GL_DEPTH_COMPONENT32F, width, height,
                           GL_TRUE);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D_MULTISAMPLE, name, 0);
  return name;
}

void check_complete(const GlFunctions& gl, int width, int height) {
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE || gl.GetError() != GL_NO_ERROR)
    throw Error(fmt::format("the graphics device cannot draw {} x {} pixels with {} samples each",
                            width, height, Framebuffer::kSamples));
}

}  // namespace

Framebuffer::Framebuffer(const GlFunctions& gl, int width, int height)
    : gl_(&gl), width_(width), height_(height) {
  canvas_ = make_framebuffer(gl);
  color_ = attach_storage(gl, {GL_COLOR_ATTACHMENT0, GL_RGBA8, kSamples}, width, height);
  depth_ = attach_depth_texture(gl, kSamples, width, height);
  check_complete(gl, width, height);

  copy_ = make_framebuffer(gl);
  depth_copy_ = attach_depth_texture(gl, kSamples, width, height);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  check_complete(gl, width, height);

  resolved_ = make_framebuffer(gl);
  resolved_color_ = attach_storage(gl, {GL_COLOR_ATTACHMENT0, GL_RGBA8, 0}, width, height);
  check_complete(gl, width, height);
}

Framebuffer::~Framebuffer() {
  const GLuint framebuffers[] = {canvas_, copy_, resolved_};
  const GLuint renderbuffers[] = {color_, resolved_color_};
  const GLuint textures[] = {depth_, depth_copy_};
  gl_->DeleteFramebuffers(3, framebuffers);
  gl_->DeleteRenderbuffers(2, renderbuffers);
  gl_->DeleteTextures(2, textures);
}

void Framebuffer::begin() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, canvas_);
  gl_->Viewport(0, 0, width_, height_);
  gl_->DepthMask(GL_TRUE);
  gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Framebuffer::copy_depth() const { copy_depth(canvas_, copy_); }

void Framebuffer::restore_depth() const { copy_depth(copy_, canvas_); }

void Framebuffer::copy_depth(GLuint from, GLuint to) const {
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, from);
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  gl_->BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_DEPTH_BUFFER_BIT,
                       GL_NEAREST);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, canvas_);
}

Image Framebuffer::read() const {
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, canvas_);
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  gl_->BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                       GL_NEAREST);
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  Image upside_down = filled_image(width_, height_, {});
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_->ReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, upside_down.rgb.data());
  Image image = filled_image(width_, height_, {});
  for (int y = 0; y < height_; ++y)
    std::copy_n(upside_down.pixel(0, height_ - 1 - y), 3 * width_, image.pixel(0, y));
  return image;
}

}  // namespace render
