#include "app/render/renderer.h"

#include <Eigen/Geometry>
#include <cassert>
#include <cmath>

#include "app/render/drawn_meshes.h"
#include "app/render/egl_context.h"
#include "app/render/framebuffer.h"
#include "app/render/gl_mesh.h"
#include "app/render/gl_program.h"
#include "app/render/gl_rigging.h"
#include "app/render/plan_view.h"
#include "app/render/view.h"
#include "app/render/water_grid.h"
#include "hydro/loads/loads.h"

namespace render {
namespace {

using Eigen::Vector3d;

/// Deviation of waves from a straight edge that needs no finer triangles, at the point looked at
/// [px].
constexpr double kSagPixels = 0.3;

/// Least radius of a drawn line [px].
constexpr double kThinnest = 1.3;

/// Opacity of the edges of a wireframe, and of the creases of a body.
constexpr double kEdges = 0.4, kCreases = 0.25;

/// Edges of bodies that are split again for a nearer view, as a fraction of the length that this
/// view needs. A camera that keeps approaching then has them split only a few times.
constexpr double kFiner = 0.5;

}  // namespace

struct Renderer::Impl {
  Impl(SceneDescription p, const std::filesystem::path& shaders);
  ~Impl() { context_.make_current(); }  // Meshes are freed in their own context.
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Image draw(const std::vector<hydro::BodyState>& states, double time, const Interiors& interiors,
             const Rigging& rigging, const hydro::SurfacePatch* ripples);
  void look(const Camera& camera);
  void resize(int width, int height);

 private:
  void make_surroundings();
  void set_view(const GlProgram& program, double time) const;
  /// Says where a body is.
  void place(const GlProgram& program, const hydro::BodyState& state) const;
  /// Returns the unit of line widths [px]: 1 for up to 720 lines, in proportion above.
  double line_unit() const { return std::max(1.0, picture_.height / 720.0); }
  void draw_plan(const std::vector<hydro::BodyState>& states, double time, const Rigging& rigging);
  void draw_sky(double time) const;
  void draw_ground(double time) const;
  void find_interiors(const std::vector<hydro::BodyState>& states, const Interiors& interiors);
  /// Draws the bodies with the current program.
  void draw_bodies(const GlProgram& program, const std::vector<hydro::BodyState>& states);
  void draw_pressures(const std::vector<hydro::BodyState>& states, double time);
  void draw_pressure(std::size_t index, const hydro::BodyState& state);
  void draw_hollows(double time) const;
  void draw_edges(const std::vector<hydro::BodyState>& states, double time) const;
  void draw_rigging(const GlProgram& program, const Rigging& rigging);
  void draw_water(double time, const hydro::SurfacePatch* ripples);

  SceneDescription picture_;
  View view_;
  EglContext context_;
  const GlFunctions& gl_ = context_.gl();
  std::optional<Framebuffer> canvas_;
  GlProgram sky_, body_, pressure_, edge_, ground_, water_;
  GlMesh nothing_;  ///< Vertices that a shader places by their indices.
  PlanView plan_;
  PlanPart plan_part_;
  GLuint scale_texture_;
  GlTextures textures_{gl_};
  std::vector<DrawnBody> bodies_;
  std::vector<std::optional<InteriorLook>> interiors_;  ///< Per body; none without pockets.
  double bodies_edge_ = 0;                              ///< Longest edge of the bodies' meshes [m].
  GlRigging rigging_{gl_};
  std::vector<GlMesh> grounds_;
  std::optional<WaterSurface> surface_;
  std::optional<GlMesh> surface_mesh_;

  friend class Renderer;
};

Renderer::Impl::Impl(SceneDescription p, const std::filesystem::path& shaders)
    : picture_(std::move(p)),
      canvas_(std::in_place, gl_, picture_.width, picture_.height),
      sky_(gl_, shaders, "sky"),
      body_(gl_, shaders, "body"),
      pressure_(gl_, shaders, "body", "pressure"),
      edge_(gl_, shaders, "edge"),
      ground_(gl_, shaders, "ground"),
      water_(gl_, shaders, "water"),
      nothing_(gl_, Eigen::Matrix3Xi(Eigen::Vector3i(0, 1, 2))),
      plan_(gl_, shaders),
      scale_texture_(make_scale_texture(gl_, picture_.pressure.colors)) {
  make_surroundings();
}

void Renderer::Impl::look(const Camera& camera) {
  if (camera == picture_.camera) return;
  context_.make_current();
  picture_.camera = camera;
  make_surroundings();
}

void Renderer::Impl::resize(int width, int height) {
  if (width == picture_.width && height == picture_.height) return;
  context_.make_current();
  canvas_.reset();
  canvas_.emplace(gl_, width, height);
  picture_.width = width;
  picture_.height = height;
  make_surroundings();
}

void Renderer::Impl::place(const GlProgram& program, const hydro::BodyState& state) const {
  program.set("u_rotation", state.orientation.toRotationMatrix());
  program.set("u_position", Vector3d(state.position - view_.eye_W));
}

/// Makes the view and the meshes that depend on it, with coordinates relative to the eye.
void Renderer::Impl::make_surroundings() {
  view_ = make_view(picture_.camera, picture_.width, picture_.height);
  const double sag = kSagPixels * picture_size(view_) / picture_.height;
  const double longest_edge = picture_.sea ? longest_straight_edge(*picture_.sea, sag)
                                           : std::numeric_limits<double>::infinity();
  // Bodies are made again only if they are too coarse for the view.
  const double body_edge =
      picture_.sea ? std::min(longest_edge, longest_sheared_edge(*picture_.sea)) : longest_edge;
  if (bodies_.empty() || body_edge < bodies_edge_) {
    bodies_edge_ = (bodies_.empty() ? 1 : kFiner) * body_edge;
    bodies_.clear();
    for (const BodyAppearance& look : picture_.bodies)
      bodies_.push_back(make_body(gl_, textures_, look, bodies_edge_, picture_.wireframe));
  }
  grounds_.clear();
  if (picture_.ground_W) grounds_.push_back(make_ground(gl_, *picture_.ground_W, view_));
  if (picture_.ground_z) grounds_.push_back(make_plane(gl_, *picture_.ground_z, view_));
  if (!picture_.sea || !picture_.water_visible) return;
  surface_.emplace(*picture_.sea, view_, longest_edge, picture_.ripple);
  surface_mesh_.emplace(gl_, surface_->grid().triangles());
}

void Renderer::Impl::set_view(const GlProgram& program, double time) const {
  const Vector3d level = Vector3d::UnitZ().cross(view_.level_W);
  const Vector3d& eye = view_.eye_W;
  const bool under = picture_.sea && picture_.water_visible &&
                     eye.z() < hydro::surface_height(*picture_.sea, eye.x(), eye.y(), time);
  program.use();
  program.set("u_clip_from_E", view_.clip_from_E);
  program.set("u_key_light", key_light(view_));
  program.set("u_back_light",
              Vector3d((-0.25 * view_.level_W + level + 0.45 * Vector3d::UnitZ()).normalized()));
  program.set("u_visibility", 40 * view_.distance);
  program.set("u_murk", 0.45 / picture_size(view_));
  program.set("u_level", picture_.sea ? picture_.sea->level - eye.z() : 0.0);
  const double grid = grid_length(view_);
  program.set("u_grid", grid);
  program.set("u_grid_lines", picture_.grid_visible ? 1 : 0);
  program.set("u_grid_shift",
              Vector3d(eye.unaryExpr([&](double x) { return std::remainder(x, grid); })));
  program.set("u_sea", picture_.sea && picture_.water_visible ? 1 : 0);
  program.set("u_under", under ? 1 : 0);
  program.set("u_plan", PlanView::kUnit);
  program.set("u_plan_part", plan_part_.square);
  program.set("u_cast_low", plan_part_.low);
  program.set("u_cast_range", plan_part_.range);
}

/// Draws what bodies do to water and ground about them.
void Renderer::Impl::draw_plan(const std::vector<hydro::BodyState>& states, double time,
                               const Rigging& rigging) {
  std::vector<Ball> casters;
  for (std::size_t i = 0; i < states.size(); ++i)
    casters.push_back({states[i].position - view_.eye_W, bodies_[i].radius});
  plan_part_ = plan_part(view_, casters);
  plan_.begin_shadows();
  set_view(plan_.shadows(), time);
  draw_bodies(plan_.shadows(), states);
  draw_rigging(plan_.shadows(), rigging);
  plan_.begin_foam();
  set_view(plan_.foam(), time);
  for (std::size_t i = 0; surface_ && i < states.size(); ++i) {
    if (bodies_[i].churn == 0) continue;
    place(plan_.foam(), states[i]);
    plan_.foam().set("u_churn", bodies_[i].churn);
    bodies_[i].mesh.draw();
  }
  plan_.finish(nothing_);
}

void Renderer::Impl::draw_sky(double time) const {
  set_view(sky_, time);
  sky_.set("u_forward", view_.forward_W);
  sky_.set("u_right", Vector3d(view_.half_width * view_.right_W));
  sky_.set("u_up", Vector3d(view_.half_height * view_.up_W));
  gl_.DepthMask(GL_FALSE);
  gl_.Disable(GL_DEPTH_TEST);
  nothing_.draw();
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
}

void Renderer::Impl::draw_ground(double time) const {
  set_view(ground_, time);
  for (const GlMesh& mesh : grounds_) mesh.draw();
}

/// Draws the pressure on the wet part of a body over the body itself.
void Renderer::Impl::draw_pressure(std::size_t index, const hydro::BodyState& state) {
  const BodyAppearance& look = picture_.bodies[index];
  const hydro::Sea& sea = *picture_.sea;
  if (!bodies_[index].wet) return;
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  place(pressure_, state);
  pressure_.set("u_spin", state.angular_velocity);
  pressure_.set("u_drag_shape",
                Eigen::Matrix3d(R_WB * look.coefficients.drag_shape * R_WB.transpose()));
  pressure_.set("u_velocity", Vector3d(state.linear_velocity - sea.current));
  const Pressure shows = picture_.pressure.shows;
  pressure_.set("u_weight", shows == Pressure::dynamic ? 0.0 : sea.density * sea.gravity);
  const double half_density =
      shows == Pressure::hydrostatic
          ? 0
          : 0.5 * sea.density *
                hydro::drag_scale(look.coefficients, state,
                                  hydro::current_at(sea, state.position.z()));
  pressure_.set("u_drag_front", half_density * look.coefficients.pressure_drag.front);
  pressure_.set("u_drag_back", half_density * look.coefficients.pressure_drag.back);
  bodies_[index].mesh.draw();
}

void Renderer::Impl::draw_edges(const std::vector<hydro::BodyState>& states, double time) const {
  set_view(edge_, time);
  edge_.set("u_opacity", picture_.wireframe ? kEdges : kCreases);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DepthMask(GL_FALSE);
  for (std::size_t i = 0; i < states.size(); ++i) {
    place(edge_, states[i]);
    bodies_[i].edges.draw();
  }
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_BLEND);
}

/// The pockets of each body that may have some.
void Renderer::Impl::find_interiors(const std::vector<hydro::BodyState>& states,
                                    const Interiors& interiors) {
  interiors_ = std::vector<std::optional<InteriorLook>>(states.size());
  for (std::size_t i = 0; picture_.sea && i < states.size(); ++i) {
    const BodyAppearance& look = picture_.bodies[i];
    if (look.hollows == Hollows::none) continue;
    const Vector3d up_B = look.hollows == Hollows::dry
                              ? look.up_B
                              : Vector3d(states[i].orientation.toRotationMatrix().row(2));
    static const std::vector<PocketLook> kDry;
    interiors_[i].emplace(bodies_[i].mesh_B, up_B, states[i],
                          i < interiors.size() ? interiors[i] : kDry);
    if (!interiors_[i]->has_pockets()) interiors_[i].reset();
  }
}

/// Draws the water in hollows, and puts lids of depth alone over those that the sea does not fill,
/// so that its surface does not appear there.
void Renderer::Impl::draw_hollows(double time) const {
  constexpr double kNearer = 2e-3;
  for (const auto& interior : interiors_)
    if (interior) make_level(gl_, interior->surfaces(), view_, 0).draw();
  gl_.BlendFunc(GL_ZERO, GL_ONE);
  for (const auto& interior : interiors_)
    if (interior) make_level(gl_, interior->openings(*picture_.sea, time), view_, kNearer).draw();
  gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void Renderer::Impl::draw_water(double time, const hydro::SurfacePatch* ripples) {
  const Eigen::MatrixXf vertices = surface_->vertices(time, ripples);
  surface_mesh_->set(0, vertices.topRows<3>().eval());
  surface_mesh_->set(1, vertices.bottomRows<2>().eval());
  canvas_->copy_depth();
  set_view(water_, time);
  water_.set("u_near", view_.near);
  water_.set("u_far", view_.far);
  water_.set("u_depth", 0);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, canvas_->depth_copy());
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  draw_hollows(time);
  // Depth is written and cells are drawn from near to far, so that near waves hide those behind
  // them.
  surface_mesh_->draw();
  gl_.Disable(GL_BLEND);
}

void Renderer::Impl::draw_bodies(const GlProgram& program,
                                 const std::vector<hydro::BodyState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    place(program, states[i]);
    draw_look(gl_, program, bodies_[i], picture_.bodies[i].color);
  }
}

/// Draws the pressures and waterlines where bodies are in sight, whatever water is before them.
void Renderer::Impl::draw_pressures(const std::vector<hydro::BodyState>& states, double time) {
  set_view(pressure_, time);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, scale_texture_);
  pressure_.set("u_scale", 0);
  pressure_.set("u_pressure_min", picture_.pressure.min);
  pressure_.set("u_pressure_range", picture_.pressure.max - picture_.pressure.min);
  pressure_.set("u_stripe", kStripe * line_unit());
  pressure_.set("u_flat_depth", 1e-7 * picture_size(view_));
  pressure_.set("u_line_width", (picture_.bold_waterline ? 4.0 : 2.0) * line_unit());
  pressure_.set("u_colored", picture_.pressure_visible ? 1 : 0);
  pressure_.set("u_bold", picture_.bold_waterline ? 1 : 0);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DepthFunc(GL_LEQUAL);
  for (std::size_t i = 0; i < states.size(); ++i) draw_pressure(i, states[i]);
  gl_.DepthFunc(GL_LESS);
  gl_.Disable(GL_BLEND);
}

void Renderer::Impl::draw_rigging(const GlProgram& program, const Rigging& rigging) {
  if (rigging.empty()) return;
  const double pixel = 2 * view_.half_height / picture_.height;
  program.set("u_painted", 0);
  rigging_.draw(program, view_, kThinnest * line_unit() * pixel, rigging);
}

Image Renderer::Impl::draw(const std::vector<hydro::BodyState>& states, double time,
                           const Interiors& interiors, const Rigging& rigging,
                           const hydro::SurfacePatch* ripples) {
  assert(states.size() == bodies_.size());
  context_.make_current();
  find_interiors(states, interiors);
  if (picture_.sea) {
    const hydro::AiryWaves waves(*picture_.sea, time);
    for (std::size_t i = 0; i < states.size(); ++i)
      wet(bodies_[i], states[i], *picture_.sea, waves, time, interiors_[i]);
  }
  if (surface_ || !grounds_.empty()) draw_plan(states, time, rigging);
  canvas_->begin();
  draw_sky(time);
  draw_ground(time);
  set_view(body_, time);
  draw_bodies(body_, states);
  draw_rigging(body_, rigging);
  if (surface_) {
    draw_water(time, ripples);
    canvas_->restore_depth();
  }
  if (picture_.sea && (picture_.pressure_visible || picture_.bold_waterline))
    draw_pressures(states, time);
  draw_edges(states, time);
  return canvas_->read();
}

Renderer::Renderer(SceneDescription picture, const std::filesystem::path& shader_folder)
    : impl_(std::make_unique<Impl>(std::move(picture), shader_folder)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const std::string& Renderer::device() const { return impl_->context_.device(); }

double Renderer::grid() const {
  const SceneDescription& p = impl_->picture_;
  const bool lined = (p.sea && p.water_visible) || p.ground_W || p.ground_z;
  return lined && p.grid_visible ? grid_length(impl_->view_) : 0;
}

const View& Renderer::view() const { return impl_->view_; }

void Renderer::look(const Camera& camera) { impl_->look(camera); }

void Renderer::resize(int width, int height) { impl_->resize(width, height); }

void Renderer::show_pressures(const PressureScale& scale) { impl_->picture_.pressure = scale; }

Image Renderer::draw(const std::vector<hydro::BodyState>& states, double time,
                     const Interiors& interiors, const Rigging& rigging,
                     const hydro::SurfacePatch* ripples) {
  return impl_->draw(states, time, interiors, rigging, ripples);
}

}  // namespace render
