#include "app/render/drawn_meshes.h"

#include <cmath>
#include <utility>

#include "app/render/occlusion.h"
#include "app/render/paint.h"
#include "app/render/vertex_water.h"
#include "app/render/water_grid.h"

namespace render {
namespace {

using Eigen::Vector3d;

/// Largest number of triangles that a body is split into for waves, which bounds the work of a
/// picture.
constexpr double kMostFaces = 100'000;

}  // namespace

DrawnBody make_body(const GlFunctions& gl, const BodyAppearance& look, double longest_edge,
                    bool wireframe) {
  hydro::TriMesh mesh_B =
      std::isfinite(longest_edge) ? subdivided(look.mesh_B, longest_edge, kMostFaces) : look.mesh_B;
  ShadedMesh skin = make_shaded_mesh(mesh_B);
  Eigen::Matrix3Xf colors;
  if (look.paint) {
    PaintedSkin painted = painted_skin(skin, *look.paint, look.color.cast<float>());
    skin = std::move(painted.skin);
    colors = std::move(painted.colors);
  }
  GlMesh mesh(gl, skin.triangles);
  mesh.set(0, skin.vertices.cast<float>());
  mesh.set(1, skin.normals.cast<float>());
  mesh.set(3, openness(look.mesh_B, skin));
  if (look.paint) mesh.set(5, colors);
  GlMesh edges(gl, wireframe ? edges_of(look.mesh_B) : creases_of(look.mesh_B));
  edges.set(0, look.mesh_B.vertices.cast<float>());
  const double radius = mesh_B.vertices.colwise().norm().maxCoeff();
  return {std::move(mesh_B), radius,           std::move(skin),
          std::move(mesh),   std::move(edges), look.paint != nullptr};
}

void wet(DrawnBody& body, const hydro::BodyState& state, const hydro::Sea& sea,
         const hydro::AiryWaves& waves, double time, const std::optional<InteriorLook>& interior) {
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Eigen::Matrix3Xd points_W = (R_WB * body.skin_B.vertices).eval().colwise() + state.position;
  VertexWater water = vertex_water(sea, waves, points_W, time);
  if (interior) interior->set_water(body.skin_B, sea, water);
  body.wet = water.depths.maxCoeff() >= 0;
  const bool afloat = body.wet && water.depths.minCoeff() < 0;
  body.churn = afloat ? churn(water, sea, state, points_W, body.radius) : 0;
  if (!body.wet) return;
  Eigen::MatrixXf heights(2, points_W.cols());
  heights << water.depths.cast<float>(), water.heads.cast<float>();
  body.mesh.set(2, heights);
  body.mesh.set(4, water.flow.cast<float>());
}

GlMesh make_ground(const GlFunctions& gl, const hydro::TriMesh& ground_W, const View& view) {
  const ShadedMesh skin = make_shaded_mesh(ground_W);
  GlMesh mesh(gl, skin.triangles);
  mesh.set(0, (skin.vertices.colwise() - view.eye_W).cast<float>());
  mesh.set(1, skin.normals.cast<float>());
  return mesh;
}

GlMesh make_plane(const GlFunctions& gl, double z, const View& view) {
  const PolarGrid grid = make_polar_grid(view, {.level = z, .lowest = z, .highest = z}, kFlatSteps);
  GlMesh mesh(gl, grid.triangles());
  Eigen::Matrix3Xd points_E(3, grid.points_W.cols());
  points_E.topRows<2>() = grid.points_W.colwise() - view.eye_W.head<2>();
  points_E.row(2).setConstant(z - view.eye_W.z());
  mesh.set(0, points_E.cast<float>());
  mesh.set(1, Vector3d::UnitZ().replicate(1, points_E.cols()).cast<float>());
  return mesh;
}

GlMesh make_level(const GlFunctions& gl, const Triangles& triangles_W, const View& view,
                  double nearer) {
  Eigen::Matrix3Xi corners(3, triangles_W.cols() / 3);
  for (Eigen::Index i = 0; i < triangles_W.cols(); ++i) corners(i % 3, i / 3) = static_cast<int>(i);
  GlMesh mesh(gl, corners);
  mesh.set(0, ((1 - nearer) * (triangles_W.colwise() - view.eye_W)).cast<float>());
  mesh.set(1, Eigen::Matrix2Xf::Zero(2, triangles_W.cols()));
  return mesh;
}

GLuint make_scale_texture(const GlFunctions& gl, ColorMap colors) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, kScaleColors, 1, 0, GL_RGB, GL_UNSIGNED_BYTE,
                scale_colors(colors).data());
  for (const GLenum key : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, key, GL_CLAMP_TO_EDGE);
  for (const GLenum key : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, key, GL_LINEAR);
  return name;
}

}  // namespace render
