#include <cstdint>

#include "app/pages/packing.h"
#include "app/report/page_data.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

Json packed_mesh(const hydro::TriMesh& mesh, const Eigen::Vector3d& origin) {
  const Eigen::Matrix3Xf vertices = (mesh.vertices.colwise() - origin).cast<float>();
  const auto corners = static_cast<std::size_t>(mesh.faces.size());
  return {{"vertices", packed<float>({vertices.data(), static_cast<std::size_t>(vertices.size())})},
          {"triangles", packed<std::int32_t>({mesh.faces.data(), corners})}};
}

Json surface(const hydro::FlatSurface&, const PageLimits&) { return {{"kind", "flat"}}; }

Json surface(const hydro::HeightField& whole, const PageLimits& limits) {
  const hydro::HeightField field = coarsened(whole, limits.heights);
  const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> heights =
      field.heights.cast<float>();
  return {{"kind", "heightfield"},
          {"rows", heights.rows()},
          {"columns", heights.cols()},
          {"of_rows", whole.heights.rows()},
          {"of_columns", whole.heights.cols()},
          {"cell", field.cell},
          {"origin", {field.origin.x(), field.origin.y()}},
          {"heights", packed<float>({heights.data(), static_cast<std::size_t>(heights.size())})}};
}

Json surface(const hydro::WaveSurface& waves, const PageLimits&) {
  std::vector<double> numbers;
  for (const hydro::WaveComponent& w : waves.components)
    numbers.insert(numbers.end(), {w.amplitude, w.kx, w.ky, w.omega, w.phase});
  return {{"kind", "waves"}, {"components", packed<double>(numbers)}, {"ramp", waves.ramp}};
}

Json ground_of(const std::monostate&, const PageLimits&) { return nullptr; }

Json ground_of(const engine::PlaneGround& plane, const PageLimits&) { return {{"z", plane.z}}; }

Json ground_of(const engine::MeshGround& ground, const PageLimits& limits) {
  const hydro::TriMesh mesh = coarsened(ground.mesh_W, limits.faces);
  const Eigen::Vector3d origin = hydro::bounding_box(mesh).center();
  return {{"origin", {origin.x(), origin.y(), origin.z()}}, {"mesh", packed_mesh(mesh, origin)}};
}

}  // namespace

Json page_bodies(const LoggedRun& run, const Shapes& shapes) {
  Json bodies = Json::array();
  for (std::size_t i = 0; i < run.scene.bodies.size(); ++i) {
    const engine::BodySpec& body = run.built.spec.bodies[i];
    const Eigen::Vector3d& color = run.scene.bodies[i].color;
    const Eigen::Matrix3d& I = body.inertia_B;
    bodies.push_back({{"name", body.name},
                      {"shape", shapes.of_body[i]},
                      {"color", {color.x(), color.y(), color.z()}},
                      {"mass", body.mass},
                      {"inertia", {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}}});
  }
  return bodies;
}

Json page_shapes(const Shapes& shapes) {
  Json all = Json::array();
  for (const Shapes::Shape& shape : shapes.shapes) {
    Json json = packed_mesh(shape.mesh_B, Eigen::Vector3d::Zero());
    json["faces"] = shape.mesh_B.face_count();
    json["of_faces"] = shape.of_faces;
    all.push_back(std::move(json));
  }
  return all;
}

Json page_water(const engine::SimulationSpec& spec, const PageLimits& limits) {
  if (!spec.sea) return nullptr;
  Json water = std::visit([&](const auto& s) { return surface(s, limits); }, spec.sea->surface);
  water["level"] = spec.sea->level;
  water["density"] = spec.sea->density;
  return water;
}

Json page_ground(const engine::Ground& ground, const PageLimits& limits) {
  return std::visit([&](const auto& g) { return ground_of(g, limits); }, ground);
}

}  // namespace app
