#include "hydro/statics/hydrostatics.h"

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "hydro/loads/clip.h"
#include "hydro/statics/wet_sums.h"

namespace hydro {
namespace {

/// Adds a triangle without a dry part.
void add_wet_triangle(const Panel& r, const Eigen::Vector3d& d, WetSums& sums) {
  const Eigen::Vector3d a = area_vector(r);
  sums.volume -= a.z() * d.sum() / 3;
  Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
  for (int i = 0; i < 3; ++i) weighted += (d.sum() + d[i]) * r[i].head<2>();
  sums.horizontal -= a.z() / 12 * weighted;
  // Σ_i d_i² + Σ_{i<j} d_i d_j is half of Σ_i d_i² + S².
  sums.depth -= a.z() / 24 * (d.squaredNorm() + d.sum() * d.sum());
  sums.surface += a.norm();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (d[i] == 0 && d[j] == 0) sums.waterline.push_back({r[j].head<2>(), r[i].head<2>()});
  }
}

/// @param depths   Depths of the vertices [m].
WetSums sum_wet_triangles(const TriMesh& mesh_G, const Eigen::RowVectorXd& depths) {
  WetSums sums;
  for (Eigen::Index f = 0; f < mesh_G.face_count(); ++f) {
    const auto face = mesh_G.faces.col(f);
    add_panel(panel_of(mesh_G, f), {depths[face[0]], depths[face[1]], depths[face[2]]}, sums);
  }
  return sums;
}

/// Evaluates (4) and (5) about the mean point of the waterline, so that a waterplane far from the
/// centre of mass loses no digits.
Waterplane waterplane_within(const std::vector<WaterlineEdge>& waterline) {
  Waterplane plane;
  if (waterline.empty()) return plane;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const WaterlineEdge& edge : waterline)
    middle += edge.from / static_cast<double>(waterline.size());
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  for (const WaterlineEdge& edge : waterline) {
    const Eigen::Vector2d p = edge.from - middle;
    const Eigen::Vector2d q = edge.to - middle;
    const double c = p.x() * q.y() - p.y() * q.x();
    plane.area += c / 2;
    first += c / 6 * (p + q);
    plane.second_moment +=
        c / 24 * (p * p.transpose() + q * q.transpose() + (p + q) * (p + q).transpose());
  }
  plane.centroid = middle;
  if (plane.area <= 0) return {.centroid = middle};  // the body touches a point or a line
  const Eigen::Vector2d arm = first / plane.area;
  plane.centroid += arm;
  plane.second_moment -= plane.area * arm * arm.transpose();
  return plane;
}

}  // namespace

void add_panel(const Panel& panel_G, const Eigen::Vector3d& depth, WetSums& sums) {
  if (!(depth.maxCoeff() > 0)) return;
  if (depth.minCoeff() >= 0) return add_wet_triangle(panel_G, depth, sums);
  for (const PanelPart& wet : positive_part(panel_G, depth))
    add_wet_triangle(wet.panel, wet.value, sums);
}

Hydrostatics hydrostatics_of(const WetSums& sums, double height) {
  Hydrostatics h{.volume = sums.volume,
                 .wetted_surface = sums.surface,
                 .waterplane = waterplane_within(sums.waterline)};
  if (sums.volume <= 0) return h;
  h.centre_of_buoyancy.head<2>() = sums.horizontal / sums.volume;
  h.centre_of_buoyancy.z() = -height - sums.depth / sums.volume;
  return h;
}

Hydrostatics hydrostatics(const TriMesh& mesh_G, double height) {
  return hydrostatics_of(
      sum_wet_triangles(mesh_G, -(mesh_G.vertices.row(2).array() + height).matrix()), height);
}

WetVolume wet_volume(const TriMesh& mesh_G, const Eigen::RowVectorXd& depths) {
  const WetSums sums = sum_wet_triangles(mesh_G, depths);
  if (sums.volume <= 0) return {};
  return {sums.volume, sums.horizontal / sums.volume, sums.depth / sums.volume};
}

Eigen::Matrix3d restoring_stiffness(const Hydrostatics& h) {
  const Waterplane& w = h.waterplane;
  const Eigen::Vector3d lift(1, w.centroid.y(),
                             -w.centroid.x());  // heave of the centroid per motion
  Eigen::Matrix3d stiffness = w.area * lift * lift.transpose();
  stiffness.bottomRightCorner<2, 2>() += h.volume * metacentric_heights(h);
  return stiffness;
}

Eigen::Matrix2d metacentric_heights(const Hydrostatics& h) {
  if (h.volume <= 0) return Eigen::Matrix2d::Zero();
  const Eigen::Matrix2d& i = h.waterplane.second_moment;
  Eigen::Matrix2d turned;
  turned << i(1, 1), -i(0, 1),  //
      -i(0, 1), i(0, 0);
  return turned / h.volume + h.centre_of_buoyancy.z() * Eigen::Matrix2d::Identity();
}

}  // namespace hydro
