#include "hydro/added_mass/plain_wetted_added_mass.h"

#include <optional>
#include <span>

#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/airy_waves.h"
#include "hydro/loads/loads.h"
#include "hydro/loads/point_rules.h"
#include "hydro/loads/refine.h"

namespace hydro {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The barycentric coordinates in `panel` of the corners of a piece of it, a column a corner.
Matrix3d weights_in(const Panel& panel, const Panel& piece) {
  const Vector3d a = panel[1] - panel[0];
  const Vector3d b = panel[2] - panel[0];
  const Vector3d normal = a.cross(b);
  const Vector3d along = normal / normal.squaredNorm();
  Matrix3d weights;
  for (int i = 0; i < 3; ++i) {
    const Vector3d p = piece[static_cast<std::size_t>(i)] - panel[0];
    const double second = p.cross(b).dot(along);
    const double third = a.cross(p).dot(along);
    weights.col(i) << 1 - second - third, second, third;
  }
  return weights;
}

/// The wet part of a face.
struct WetPart {
  Panel panel_B;                        ///< Body axes.
  CornerPotentials psi;                 ///< At its corners.
  Vector3d depth;                       ///< Below the surface [m].
  std::span<const TrianglePoint> rule;  ///< Empty where u̇ is linear over it.
};

HeadError head_error(const TriMesh& mesh_B) {
  double area = 0, volume = 0;
  for (Eigen::Index f = 0; f < mesh_B.face_count(); ++f) {
    const Vector3d a = area_vector(mesh_B, f);
    area += a.norm();
    volume += a.dot(mesh_B.vertices.col(mesh_B.faces(0, f))) / 3;
  }
  return {LoadAccuracy{}.wave_tolerance, volume / area};
}

/// Calls visit(part) for each wet part of the faces.
template <class Visit>
void for_each_wet_part(const TriMesh& mesh_B, const AddedMassSolution& solution,
                       const BodyState& state, const Sea& sea, double time, SplitFor what,
                       Visit&& visit) {
  const double radius = mesh_B.vertices.colwise().norm().maxCoeff();
  const SurfaceSampler surface(sea, state.position, time, kSmallestPanel * radius, what,
                               head_error(mesh_B));
  const Matrix3d R_WB = state.orientation.toRotationMatrix();
  const double level = sea.level - state.position.z();
  for (Eigen::Index f = 0; f < mesh_B.face_count(); ++f) {
    Panel face_B, panel;
    Vector3d elevation;
    for (std::size_t i = 0; i < 3; ++i) {
      face_B[i] = mesh_B.vertices.col(mesh_B.faces(static_cast<Eigen::Index>(i), f));
      panel[i] = R_WB * face_B[i];
      elevation[static_cast<Eigen::Index>(i)] = surface.elevation(panel[i]);
    }
    if (area_vector(panel).isZero(0)) continue;
    const CornerPotentials& psi = solution.potentials[static_cast<std::size_t>(f)];
    const bool curved = surface.curves(panel);
    const auto visit_piece = [&](const Panel& piece, const Vector3d& at) {
      const Vector3d depth(level + at[0] - piece[0].z(), level + at[1] - piece[1].z(),
                           level + at[2] - piece[2].z());
      for (const PanelPart& wet : positive_part(piece, depth)) {
        const Matrix3d weights = weights_in(panel, wet.panel);
        WetPart part{.panel_B = {}, .psi = psi * weights, .depth = wet.value, .rule = {}};
        if (curved) surface.with_rule(piece, [&](const auto& rule) { part.rule = rule; });
        for (int i = 0; i < 3; ++i)
          part.panel_B[static_cast<std::size_t>(i)] =
              weights(0, i) * face_B[0] + weights(1, i) * face_B[1] + weights(2, i) * face_B[2];
        visit(part);
      }
    };
    if (curved)
      for_each_curved_piece(panel, elevation, level, false, surface, visit_piece);
    else
      for_each_linear_piece(panel, elevation, surface, visit_piece);
  }
}

/// ∫ ψ u̇·n dA of a wet part, with u̇·n(r, depth) as `normal_acceleration` says.
template <class Acceleration>
Vector6d wave_load_on(const WetPart& part, Acceleration&& normal_acceleration) {
  const double area = area_vector(part.panel_B).norm();
  Vector6d load = Vector6d::Zero();
  if (!part.rule.empty()) {
    for (const TrianglePoint& point : part.rule) {
      const Vector3d at(point.at[0], point.at[1], point.at[2]);
      const Vector3d r = point_of(part.panel_B, point);
      load += point.weight * area * normal_acceleration(r, std::nullopt) * (part.psi * at);
    }
    return load;
  }
  Vector3d f;
  for (int i = 0; i < 3; ++i)
    f[i] = normal_acceleration(part.panel_B[static_cast<std::size_t>(i)],
                               std::optional(part.depth[i]));
  // ∫ ψ f dA = (A/12) (Σ ψ_i Σ f_i + Σ ψ_i f_i).
  return area / 12 * (part.psi.rowwise().sum() * f.sum() + part.psi * f);
}

}  // namespace

Matrix6d plain_wetted_added_mass(const TriMesh& mesh_B, const AddedMassSolution& solution,
                                 const BodyState& state, const Sea& sea, double time) {
  Matrix6d sum = Matrix6d::Zero();
  const std::optional<Sea> felt = without_weak_waves(sea, head_error(mesh_B));
  for_each_wet_part(mesh_B, solution, state, felt ? *felt : sea, time, SplitFor::surface,
                    [&](const WetPart& part) { sum += triangle_share(part.panel_B, part.psi); });
  return sea.density * semi_definite_part(sum);
}

Wrench plain_wave_load(const TriMesh& mesh_B, const AddedMassSolution& solution,
                       const BodyState& state, const Sea& all_of_the_sea, double time) {
  const std::optional<Sea> felt = without_weak_waves(all_of_the_sea, head_error(mesh_B));
  const Sea& sea = felt ? *felt : all_of_the_sea;
  const AiryWaves waves(sea, time);
  const Eigen::Quaterniond to_B = state.orientation.conjugate();
  const Vector3d u_B = to_B * water_at(all_of_the_sea, state.position, time).acceleration;
  Matrix6d share = Matrix6d::Zero();
  Vector6d load = Vector6d::Zero();
  for_each_wet_part(mesh_B, solution, state, sea, time, SplitFor::head, [&](const WetPart& part) {
    share += triangle_share(part.panel_B, part.psi);
    const Vector3d n = area_vector(part.panel_B).normalized();
    load += wave_load_on(part, [&](const Vector3d& r, std::optional<double> depth) {
      const Vector3d p_W = state.position + state.orientation * r;
      const double s = depth ? *depth : surface_height(sea, p_W.x(), p_W.y(), time) - p_W.z();
      return (to_B * waves.at(p_W, s).acceleration).dot(n);
    });
  });
  const Vector6d load_B =
      sea.density * (load + (semi_definite_part(share) - share).leftCols<3>() * u_B);
  return {state.orientation * load_B.head<3>(), state.orientation * load_B.tail<3>()};
}

}  // namespace hydro
