#include "hydro/loads/edge_drag.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hydro/decompositions.h"
#include "hydro/loads/point_rules.h"
#include "hydro/mesh/edge_table.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// An edge of the mesh with the faces on its two sides.
struct Fold {
  Vector3d from, to;
  int first = 0, second = 0;  ///< Faces.
  double turn = 0;            ///< Turn of the surface [rad]; negative in a hollow.
};

/// The edges at which two faces meet.
std::vector<Fold> folds(const TriMesh& mesh, const Eigen::Matrix3Xd& normals) {
  std::vector<Fold> result;
  const std::vector<HalfEdge> sides = sorted_half_edges(mesh);
  for (std::size_t i = 0; i < sides.size();) {
    const std::size_t end = edge_end(sides, i);
    if (end - i == 2 && sides[i].rising != sides[i + 1].rising) {
      const HalfEdge& forth = sides[i].rising ? sides[i] : sides[i + 1];
      const HalfEdge& back = sides[i].rising ? sides[i + 1] : sides[i];
      Fold fold{.from = mesh.vertices.col(forth.low),
                .to = mesh.vertices.col(forth.high),
                .first = forth.face,
                .second = back.face};
      const Vector3d n_1 = normals.col(fold.first), n_2 = normals.col(fold.second);
      const Vector3d along = (fold.to - fold.from).normalized();
      fold.turn = std::atan2(n_1.cross(n_2).dot(along), n_1.dot(n_2));
      if (n_1.squaredNorm() > 0 && n_2.squaredNorm() > 0) result.push_back(fold);
    }
    i = end;
  }
  return result;
}

/// A part of the surface between sharp edges.
struct Side {
  double area = 0;
  Vector3d first = Vector3d::Zero();                 ///< ∫ r dS
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< ∫ r rᵀ dS

  Vector3d middle() const { return first / area; }
  /// w^⅓/E of (2), w and l being those of a rectangle with the same second moments of area.
  double strength() const {
    const Eigen::Matrix3d spread = second / area - middle() * middle().transpose();
    Vector3d moments = eigen_decomposition(spread).values;
    std::sort(moments.begin(), moments.end());
    const double width = std::sqrt(12 * std::max(0.0, moments[1]));
    const double slenderness = std::sqrt(std::max(0.0, moments[1]) / moments[2]);
    return std::cbrt(width) / std::sqrt(1 + 1.464 * std::pow(slenderness, 1.65));
  }
};

/// The sides, and of each face the side that it is a part of.
struct Sides {
  Sides(const TriMesh& mesh, const std::vector<Fold>& folds)
      : parent_(static_cast<std::size_t>(mesh.face_count())), sides_(parent_.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const Fold& fold : folds)
      if (std::abs(fold.turn) < kLeastTurn)
        parent_[static_cast<std::size_t>(root(fold.first))] = root(fold.second);
    for (Eigen::Index face = 0; face < mesh.face_count(); ++face) {
      Side& side = sides_[static_cast<std::size_t>(root(static_cast<int>(face)))];
      const double area = area_vector(mesh, face).norm();
      side.area += area;
      const Panel panel = panel_of(mesh, face);
      for (const TrianglePoint& point : kThreePoints) {
        const Vector3d r = point_of(panel, point);
        side.first += area / 3 * r;
        side.second += area / 3 * r * r.transpose();
      }
    }
  }
  const Side& of(int face) { return sides_[static_cast<std::size_t>(root(face))]; }

 private:
  int root(int face) {
    while (parent_[static_cast<std::size_t>(face)] != face) {
      int& up = parent_[static_cast<std::size_t>(face)];
      face = up = parent_[static_cast<std::size_t>(up)];
    }
    return face;
  }

  std::vector<int> parent_;
  std::vector<Side> sides_;
};

/// w^⅓/E n·v(p) of (2) as a function of u.
Vector6d flow_off(const Side& side, const Vector3d& n, const Vector3d& edge,
                  const Vector3d& along) {
  const Vector3d to_middle = side.middle() - edge;
  const Vector3d p = edge + (to_middle - to_middle.dot(along) * along) / 2;
  Vector6d row;
  row << n, p.cross(n);
  return side.strength() * row;
}

/// Length of the part of an edge below the surface.
/// @param from, to   Depths of its ends [m].
double wet_length(double length, double from, double to) {
  const double high = std::max(from, to), low = std::min(from, to);
  if (high <= 0) return 0;
  return low >= 0 ? length : length * high / (high - low);
}

/// Calls visit(a, A, l) for each wet edge: a and A of (1) in body axes, and its wet length.
template <class Edges, class Visit>
void for_each_wet(const Edges& edges, const BodyState& state, const HullWater& water,
                  const Visit& visit) {
  const Eigen::Matrix3d R_BW = state.orientation.toRotationMatrix().transpose();
  Vector6d u;
  u << R_BW * (state.linear_velocity - water.velocity), R_BW * state.angular_velocity;
  const double level = water.surface - state.position.z();
  const Vector3d up_B = R_BW.col(2);
  for (const auto& edge : edges) {
    const double length = wet_length((edge.to - edge.from).norm(), level - up_B.dot(edge.from),
                                     level - up_B.dot(edge.to));
    if (length > 0) visit(edge.a, edge.a.dot(u), length);
  }
}

}  // namespace

EdgeDrag::EdgeDrag(const TriMesh& mesh_B) {
  Eigen::Matrix3Xd normals(3, mesh_B.face_count());
  for (Eigen::Index face = 0; face < mesh_B.face_count(); ++face)
    normals.col(face) = area_vector(mesh_B, face).stableNormalized();
  const std::vector<Fold> all = folds(mesh_B, normals);
  Sides sides(mesh_B, all);
  for (const Fold& fold : all) {
    if (!(fold.turn > kLeastTurn)) continue;
    const Vector3d edge = (fold.from + fold.to) / 2, along = (fold.to - fold.from).normalized();
    const Vector3d n_1 = normals.col(fold.first), n_2 = normals.col(fold.second);
    const double part = std::min(1.0, (fold.turn - kLeastTurn) / (kFullTurn - kLeastTurn));
    const double scale = std::cbrt(kEdgeDrag * part) * std::sqrt(2.0) / (n_1 - n_2).norm();
    edges_.push_back({.from = fold.from,
                      .to = fold.to,
                      .a = scale * (flow_off(sides.of(fold.first), n_1, edge, along) -
                                    flow_off(sides.of(fold.second), n_2, edge, along))});
  }
}

Wrench EdgeDrag::load(const BodyState& state, const HullWater& water) const {
  Vector6d sum = Vector6d::Zero();
  for_each_wet(edges_, state, water, [&](const Vector6d& a, double A, double length) {
    sum -= length * std::abs(A) * A * a;
  });
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  return water.density * Wrench{R_WB * sum.head<3>(), R_WB * sum.tail<3>()};
}

Matrix6d EdgeDrag::jacobian(const BodyState& state, const HullWater& water) const {
  Matrix6d sum = Matrix6d::Zero();
  for_each_wet(edges_, state, water, [&](const Vector6d& a, double A, double length) {
    sum.noalias() -= 2 * length * std::abs(A) * a * a.transpose();
  });
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = R_WB;
  return water.density * turn * sum * turn.transpose();
}

}  // namespace hydro
