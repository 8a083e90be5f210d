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

std::vector<DrawnPart> drawn_parts(GlTextures& textures, const std::vector<SkinPart>& parts) {
  std::vector<DrawnPart> drawn;
  for (const SkinPart& part : parts)
    drawn.push_back({.texture = part.texture ? textures.of(*part.texture) : 0,
                     .first = part.first,
                     .count = part.count});
  return drawn;
}

}  // namespace

DrawnBody make_body(const GlFunctions& gl, GlTextures& textures, const BodyAppearance& look,
                    double longest_edge, bool wireframe) {
  hydro::TriMesh mesh_B =
      std::isfinite(longest_edge) ? subdivided(look.mesh_B, longest_edge, kMostFaces) : look.mesh_B;
  ShadedMesh skin = make_shaded_mesh(mesh_B);
  PaintedSkin painted;
  if (look.paint) {
    painted = painted_skin(skin, *look.paint, look.color.cast<float>());
    skin = std::move(painted.skin);
  }
  GlMesh mesh(gl, skin.triangles);
  mesh.set(0, skin.vertices.cast<float>());
  mesh.set(1, skin.normals.cast<float>());
  mesh.set(3, openness(look.mesh_B, skin));
  if (look.paint) mesh.set(5, painted.colors);
  if (!painted.parts.empty()) mesh.set(6, painted.coordinates);
  GlMesh edges(gl, wireframe ? edges_of(look.mesh_B) : creases_of(look.mesh_B));
  edges.set(0, look.mesh_B.vertices.cast<float>());
  const double radius = mesh_B.vertices.colwise().norm().maxCoeff();
  return {.mesh_B = std::move(mesh_B),
          .radius = radius,
          .skin_B = std::move(skin),
          .mesh = std::move(mesh),
          .edges = std::move(edges),
          .painted = look.paint != nullptr,
          .parts = drawn_parts(textures, painted.parts),
          .of_light = !painted.parts.empty() && look.paint->textures->of_light};
}

void draw_look(const GlFunctions& gl, const GlProgram& program, const DrawnBody& body,
               const Vector3d& color) {
  program.set("u_color", color);
  program.set("u_painted", body.painted ? 1 : 0);
  if (body.parts.empty()) {
    body.mesh.draw();
    return;
  }
  program.set("u_of_light", body.of_light ? 1 : 0);
  program.set("u_texture", 0);
  gl.ActiveTexture(GL_TEXTURE0);
  for (const DrawnPart& part : body.parts) {
    program.set("u_textured", part.texture != 0 ? 1 : 0);
    gl.BindTexture(GL_TEXTURE_2D, part.texture);
    body.mesh.draw(part.first, part.count);
  }
  program.set("u_textured", 0);
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
