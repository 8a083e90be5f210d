#include "hydro/statics/hydrostatics.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "hydro/loads/clip.h"
#include "hydro/mesh/mass_properties.h"

namespace hydro {
namespace {

/// An edge of the waterline; seen from above, the waterplane is on its left.
struct WaterlineEdge {
  Eigen::Vector2d from, to;
};

/// Sums over the wet triangles.
struct WetSums {
  double volume = 0;
  Eigen::Vector2d horizontal = Eigen::Vector2d::Zero();  ///< ∫ (x, y) dV
  double depth = 0;                                      ///< ∫ d dV
  double surface = 0;
  std::vector<WaterlineEdge> waterline;
};

/// Adds the terms of (1) to (3) and the triangle's edges at the surface.
void add_wet_triangle(const PanelPart& wet, WetSums& sums) {
  const Panel& r = wet.panel;
  const Eigen::Vector3d& d = wet.value;
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
  for (const auto& face : mesh_G.faces.colwise()) {
    const Panel panel = {mesh_G.vertices.col(face[0]), mesh_G.vertices.col(face[1]),
                         mesh_G.vertices.col(face[2])};
    const Eigen::Vector3d depth(depths[face[0]], depths[face[1]], depths[face[2]]);
    for (const PanelPart& wet : positive_part(panel, depth)) add_wet_triangle(wet, sums);
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

Hydrostatics hydrostatics(const TriMesh& mesh_G, double height) {
  const WetSums sums =
      sum_wet_triangles(mesh_G, -(mesh_G.vertices.row(2).array() + height).matrix());
  Hydrostatics h{.volume = sums.volume,
                 .wetted_surface = sums.surface,
                 .waterplane = waterplane_within(sums.waterline)};
  if (sums.volume <= 0) return h;
  h.centre_of_buoyancy.head<2>() = sums.horizontal / sums.volume;
  h.centre_of_buoyancy.z() = -height - sums.depth / sums.volume;
  return h;
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

double floating_height(const TriMesh& mesh_G, double volume) {
  const double whole = solid_properties(mesh_G).volume;
  if (!(volume > 0 && volume < whole))
    throw std::invalid_argument("found a displacement of " + std::to_string(volume) +
                                " m^3, expected more than 0 and less than the body's volume, " +
                                std::to_string(whole) + " m^3");
  double wet =
      -mesh_G.vertices.row(2).maxCoeff();  // heights at which the body is all wet and all dry
  double dry = -mesh_G.vertices.row(2).minCoeff();
  double height = wet + (dry - wet) * (1 - volume / whole);
  for (int i = 0; i < 200; ++i) {
    const Hydrostatics h = hydrostatics(mesh_G, height);
    const double excess = h.volume - volume;
    if (std::abs(excess) <= 1e-15 * volume) break;
    (excess > 0 ? wet : dry) = height;
    double next = height + excess / h.waterplane.area;
    if (!(next > wet && next < dry)) next = (wet + dry) / 2;  // also for an area of 0
    if (next == height || next == wet || next == dry) break;  // neighbouring numbers
    height = next;
  }
  return height;
}

}  // namespace hydro
