#include "app/render/plan_view.h"

#include <Eigen/Geometry>

namespace render {
namespace {

using Vector1d = Eigen::Matrix<double, 1, 1>;

/// Half the side of the largest square, in pictures at the point looked at. Larger: shadows of many
/// bodies are coarser; smaller: bodies near the border cast none.
constexpr double kPictures = 1.5;

}  // namespace

PlanView::PlanView(const GlFunctions& gl, const std::filesystem::path& shaders)
    : gl_(&gl),
      shadows_(gl, shaders, "shadow"),
      foam_(gl, shaders, "foam"),
      blur_(gl, shaders, "cover", "blur"),
      sharp_(make_target()),
      half_(make_target()) {}

PlanView::~PlanView() {
  for (const Target& target : {sharp_, half_}) {
    gl_->DeleteFramebuffers(1, &target.framebuffer);
    gl_->DeleteTextures(1, &target.texture);
  }
}

PlanView::Target PlanView::make_target() const {
  Target target;
  gl_->GenTextures(1, &target.texture);
  gl_->BindTexture(GL_TEXTURE_2D, target.texture);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, kSize, kSize, 0, GL_RGBA, GL_FLOAT, nullptr);
  // The blur leaves the border empty, and so is all beyond it.
  for (const GLenum key : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_->TexParameteri(GL_TEXTURE_2D, key, GL_CLAMP_TO_EDGE);
  for (const GLenum key : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_->TexParameteri(GL_TEXTURE_2D, key, GL_LINEAR);
  gl_->GenFramebuffers(1, &target.framebuffer);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture, 0);
  return target;
}

void PlanView::begin_shadows() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, sharp_.framebuffer);
  gl_->Viewport(0, 0, kSize, kSize);
  gl_->Clear(GL_COLOR_BUFFER_BIT);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE);
  gl_->BlendEquation(GL_MAX);
  gl_->ColorMask(GL_TRUE, GL_TRUE, GL_FALSE, GL_FALSE);
}

void PlanView::begin_foam() const {
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->ColorMask(GL_FALSE, GL_FALSE, GL_TRUE, GL_TRUE);
}

void PlanView::blur(const Target& from, const Target& to, const Eigen::Vector3d& axis,
                    const GlMesh& cover) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, to.framebuffer);
  gl_->BindTexture(GL_TEXTURE_2D, from.texture);
  blur_.set("u_axis", axis);
  cover.draw();
}

void PlanView::finish(const GlMesh& cover) const {
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_->Disable(GL_BLEND);
  gl_->ActiveTexture(GL_TEXTURE0 + kUnit);
  blur_.use();
  blur_.set("u_sharp", kUnit);
  blur(sharp_, half_, Eigen::Vector3d::UnitX(), cover);
  blur(half_, sharp_, Eigen::Vector3d::UnitY(), cover);
  gl_->BindTexture(GL_TEXTURE_2D, sharp_.texture);
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->Enable(GL_DEPTH_TEST);
}

PlanPart plan_part(const View& view, const std::vector<Ball>& bodies) {
  const Eigen::Vector3d light = key_light(view);
  const auto square = [&](const Eigen::Vector3d& middle_E, double half) {
    const Eigen::Array2d cast = middle_E.head<2>() - middle_E.z() / light.z() * light.head<2>();
    return Eigen::AlignedBox2d(cast - half, cast + half);
  };
  const Eigen::AlignedBox2d near =
      square(view.distance * view.forward_W, kPictures * picture_size(view));
  Eigen::AlignedBox2d all;
  Eigen::AlignedBox1d heights;
  for (const auto& [middle_E, radius] : bodies) {
    const Eigen::AlignedBox2d body = square(middle_E, radius / light.z()).intersection(near);
    if (body.isEmpty()) continue;
    all.extend(body);
    heights.extend(Vector1d(middle_E.z() - radius));
    heights.extend(Vector1d(middle_E.z() + radius));
  }
  const double side = all.isEmpty() ? 0 : all.sizes().maxCoeff();
  if (side == 0) return {};
  const double used = 1 - 2.0 * PlanView::kMargin / PlanView::kSize;
  return {.square = {all.center().x(), all.center().y(), used / side},
          .low = heights.min().x(),
          .range = heights.sizes().x()};
}

}  // namespace render
