#include "hydro/wetted_added_mass.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "hydro/decompositions.h"

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Faces in a leaf of the tree. With fewer the boxes cost more than the faces that they spare.
constexpr int kFacesALeaf = 8;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

std::array<Vector3d, 3> corners_of(const TriMesh& mesh, int face) {
  const auto vertex = mesh.faces.col(face);
  return {mesh.vertices.col(vertex[0]), mesh.vertices.col(vertex[1]), mesh.vertices.col(vertex[2])};
}

/// Barycentric coordinates in `panel` of the corners of a piece of it, a Vector3d a corner.
Panel weights_in(const Panel& panel, const Panel& piece) {
  const Vector3d a = panel[1] - panel[0];
  const Vector3d b = panel[2] - panel[0];
  const Vector3d normal = a.cross(b);
  const Vector3d along = normal / normal.squaredNorm();
  Panel weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d p = piece[i] - panel[0];
    const double second = p.cross(b).dot(along);
    const double third = a.cross(p).dot(along);
    weights[i] = {1 - second - third, second, third};
  }
  return weights;
}

/// A bound of |∇ξ| [-]; infinite for a grid of heights, which is cheap to ask point by point.
double steepest_slope(const Sea& sea) {
  if (std::holds_alternative<HeightField>(sea.surface))
    return std::numeric_limits<double>::infinity();
  double slope = 0;
  if (const auto* waves = std::get_if<WaveSurface>(&sea.surface))
    for (const WaveComponent& w : waves->components)
      slope += std::abs(w.amplitude) * std::hypot(w.kx, w.ky);
  return slope;
}

}  // namespace

AddedMassSolution moved_origin(AddedMassSolution solution, const Vector3d& p) {
  Matrix6d shift = Matrix6d::Identity();
  shift.bottomLeftCorner<3, 3>() = -cross_matrix(p);
  const Matrix6d moved = shift * solution.matrix * shift.transpose();
  solution.matrix = 0.5 * (moved + moved.transpose());
  for (CornerPotentials& psi : solution.potentials) psi = (shift * psi).eval();
  return solution;
}

Matrix6d semi_definite_part(const Matrix6d& matrix) {
  const Matrix6d symmetric = 0.5 * (matrix + matrix.transpose());
  if (Cholesky6(symmetric).positive_definite()) return symmetric;
  const EigenDecomposition6 eigen = eigen_decomposition(symmetric);
  if (eigen.values[0] >= 0) return symmetric;
  const Vector6d kept = eigen.values.cwiseMax(0);
  const Matrix6d part = eigen.vectors * kept.asDiagonal() * eigen.vectors.transpose();
  return 0.5 * (part + part.transpose());
}

/// The body in the water, heights above its centre of mass.
struct WettedAddedMass::Immersion {
  SurfaceSampler surface;
  Matrix3d rotation;          ///< R_WB.
  double level;               ///< Of the still water [m].
  double lowest;              ///< What the surface never leaves [m].
  double highest;             ///< [m]
  double steepest;            ///< No slope of the surface exceeds it [-]; infinite where not known.
  Eigen::VectorXd elevation;  ///< In waves: over each vertex, once asked for; before that NaN [m].

  /// Elevation over a vertex that lies at `r`.
  double elevation_over(Index vertex, const Vector3d& r) {
    if (std::isnan(elevation[vertex])) elevation[vertex] = surface.elevation(r);
    return elevation[vertex];
  }

  /// Of the corners of a panel below a surface of the given elevations [m].
  Vector3d depth(const Panel& panel, const Vector3d& at_corners) const {
    Vector3d depth;
    for (int i = 0; i < 3; ++i) depth[i] = level + (at_corners[i] - panel[i].z());
    return depth;
  }

  /// What the surface does not leave over a box: it is no further from its height over the middle
  /// than its steepest slope carries it [m].
  std::pair<double, double> surface_over(const Eigen::AlignedBox3d& box_B) const {
    if (surface.flat() || !std::isfinite(steepest)) return {lowest, highest};
    const double middle = level + surface.elevation(rotation * box_B.center());
    const double away = steepest * box_B.sizes().norm() / 2;
    return {std::max(lowest, middle - away), std::min(highest, middle + away)};
  }

  /// Least and greatest height of a box [m].
  std::pair<double, double> heights(const Eigen::AlignedBox3d& box_B) const {
    const Vector3d up_B = rotation.row(2);
    const double middle = up_B.dot(box_B.center());
    const double half = up_B.cwiseAbs().dot(box_B.sizes()) / 2;
    return {middle - half, middle + half};
  }
};

WettedAddedMass::WettedAddedMass(TriMesh mesh_B, const AddedMassSolution& solution)
    : mesh_B_(std::move(mesh_B)),
      whole_(semi_definite_part(solution.matrix)),
      potentials_(solution.potentials),
      faces_(potentials_.size()) {
  radius_ = mesh_B_.vertices.colwise().norm().maxCoeff();
  std::iota(faces_.begin(), faces_.end(), 0);
  for (const int face : faces_)
    shares_.push_back(
        triangle_share(corners_of(mesh_B_, face), potentials_[static_cast<std::size_t>(face)]));
  build(0, static_cast<int>(faces_.size()));
}

int WettedAddedMass::build(int first, int last) {
  const auto index = static_cast<std::size_t>(nodes_.size());
  Node node{.first = first, .last = last};
  const auto begin = faces_.begin() + first;
  const auto end = faces_.begin() + last;
  for (auto face = begin; face != end; ++face)
    for (const Vector3d& corner : corners_of(mesh_B_, *face)) node.box_B.extend(corner);
  nodes_.push_back(node);
  if (last - first <= kFacesALeaf) {
    for (auto face = begin; face != end; ++face)
      nodes_[index].share += shares_[static_cast<std::size_t>(*face)];
    return static_cast<int>(index);
  }
  Index axis;
  node.box_B.sizes().maxCoeff(&axis);
  const auto place = [&](int face) {
    const auto corners = corners_of(mesh_B_, face);
    return corners[0][axis] + corners[1][axis] + corners[2][axis];
  };
  const int half = (first + last) / 2;
  std::nth_element(begin, faces_.begin() + half, end, [&](int a, int b) {
    const double at_a = place(a), at_b = place(b);
    return at_a < at_b || (at_a == at_b && a < b);
  });
  const int left = build(first, half);
  const int right = build(half, last);
  nodes_[index].right = right;
  nodes_[index].share =
      nodes_[static_cast<std::size_t>(left)].share + nodes_[static_cast<std::size_t>(right)].share;
  return static_cast<int>(index);
}

Matrix6d WettedAddedMass::at(const BodyState& state, const Sea& sea, double time) const {
  const SurfaceBounds bounds = surface_bounds(sea);
  if (state.position.z() - radius_ >= bounds.highest) return Matrix6d::Zero();
  if (state.position.z() + radius_ < bounds.lowest) return sea.density * whole_;
  Immersion in{.surface = SurfaceSampler(sea, state.position, time, kSmallestPanel * radius_),
               .rotation = state.orientation.toRotationMatrix(),
               .level = sea.level - state.position.z(),
               .lowest = bounds.lowest - state.position.z(),
               .highest = bounds.highest - state.position.z(),
               .steepest = steepest_slope(sea),
               .elevation = {}};
  const auto [bottom, top] = in.heights(nodes_.front().box_B);
  if (bottom >= in.highest) return Matrix6d::Zero();
  if (top < in.lowest) return sea.density * whole_;
  if (!in.surface.flat())
    in.elevation.setConstant(mesh_B_.vertex_count(), std::numeric_limits<double>::quiet_NaN());
  Matrix6d sum = Matrix6d::Zero();
  add_node(in, 0, sum);
  return sea.density * semi_definite_part(sum);
}

/// Whole branches that are wet, or dry, are not looked into. Bounds of the whole surface come
/// first: they cost nothing.
void WettedAddedMass::add_node(Immersion& in, int index, Matrix6d& sum) const {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  const auto [bottom, top] = in.heights(node.box_B);
  if (bottom >= in.highest) return;
  auto [lowest, highest] = std::pair(in.lowest, in.highest);
  if (top >= lowest) std::tie(lowest, highest) = in.surface_over(node.box_B);
  if (bottom >= highest) return;
  if (top < lowest) {
    sum += node.share;
  } else if (node.right == 0) {
    for (int i = node.first; i < node.last; ++i)
      add_face(in, faces_[static_cast<std::size_t>(i)], sum);
  } else {
    add_node(in, index + 1, sum);
    add_node(in, node.right, sum);
  }
}

void WettedAddedMass::add_face(Immersion& in, int face, Matrix6d& sum) const {
  Panel panel = corners_of(mesh_B_, face);
  for (Vector3d& corner : panel) corner = in.rotation * corner;
  if (in.surface.flat()) {
    const Vector3d depth = in.depth(panel, Vector3d::Zero());
    if (depth.minCoeff() > 0)
      sum += shares_[static_cast<std::size_t>(face)];
    else
      add_piece(face, {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()}, depth, sum);
    return;
  }
  if (area_vector(panel).isZero(0)) return;
  Vector3d elevation;
  for (int i = 0; i < 3; ++i)
    elevation[i] = in.elevation_over(mesh_B_.faces(i, face), panel[static_cast<std::size_t>(i)]);
  for_each_linear_piece(panel, elevation, in.surface,
                        [&](const Panel& piece, const Vector3d& heights) {
                          add_piece(face, weights_in(panel, piece), in.depth(piece, heights), sum);
                        });
}

/// The wet part of a piece of a face. The cut is made on the barycentric coordinates of the piece's
/// corners, which give points and potentials alike.
void WettedAddedMass::add_piece(int face, const Panel& weights, const Vector3d& depth,
                                Matrix6d& sum) const {
  const auto corners = corners_of(mesh_B_, face);
  const CornerPotentials& psi = potentials_[static_cast<std::size_t>(face)];
  for (const PanelPart& wet : positive_part(weights, depth)) {
    std::array<Vector3d, 3> points;
    CornerPotentials values;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d& w = wet.panel[i];
      points[i] = w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
      values.col(static_cast<Index>(i)) = psi * w;
    }
    sum += triangle_share(points, values);
  }
}

}  // namespace hydro
