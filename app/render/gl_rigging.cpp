#include "app/render/gl_rigging.h"

#include <algorithm>

#include "app/render/part_meshes.h"
#include "app/render/shaded_mesh.h"

namespace render {
namespace {

using Eigen::Vector3d;

GlMesh on_device(const GlFunctions& gl, const hydro::TriMesh& surface) {
  const ShadedMesh skin = make_shaded_mesh(surface);
  GlMesh mesh(gl, skin.triangles);
  mesh.set(0, skin.vertices.cast<float>());
  mesh.set(1, skin.normals.cast<float>());
  mesh.set(3, Eigen::RowVectorXf::Ones(skin.vertices.cols()));
  return mesh;
}

}  // namespace

hydro::TriMesh drawn_tube(const Tube& tube, const View& view, double thinnest) {
  // The needed radius is a convex function of the place, so that between two points a tube is never
  // thinner than it must be.
  const Eigen::Matrix3Xd points_E = tube.points_W.colwise() - view.eye_W;
  const Eigen::VectorXd depths = points_E.transpose() * view.forward_W;
  return tube_mesh(points_E, (thinnest * depths.array()).max(tube.radius).matrix());
}

void GlRigging::draw_part(const GlProgram& body, const View& view, const Part& part) {
  auto mesh = meshes_.find(part.mesh_P);
  if (mesh == meshes_.end())
    mesh = meshes_.emplace(part.mesh_P, on_device(gl_, *part.mesh_P)).first;
  body.set("u_rotation", Eigen::Matrix3d(part.X_WP.linear()));
  body.set("u_position", Vector3d(part.X_WP.translation() - view.eye_W));
  body.set("u_color", part.color);
  mesh->second.draw();
}

void GlRigging::draw(const GlProgram& body, const View& view, double thinnest,
                     const Rigging& rigging) {
  for (const Part& part : rigging.parts) draw_part(body, view, part);
  body.set("u_rotation", Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  body.set("u_position", Vector3d(Vector3d::Zero()));
  for (const Tube& tube : rigging.tubes) {
    const hydro::TriMesh surface = drawn_tube(tube, view, thinnest);
    if (surface.face_count() == 0) continue;
    body.set("u_color", tube.color);
    on_device(gl_, surface).draw();
  }
}

}  // namespace render
