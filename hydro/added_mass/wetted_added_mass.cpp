#include "hydro/added_mass/wetted_added_mass.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Barycentric coordinates in `panel` of the corners of a piece of it, a column a corner. Their
/// determinant is the piece's part of the area.
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

/// ∫ λ_a λ_b dS over the side of a triangle where a linear function with these values at its
/// corners is positive, in terms of its area. The corner i that is alone on its side is cut off as
/// a triangle with corners e_i, e_i + p (e_j − e_i) and e_i + q (e_k − e_i): pq of the area.
Matrix3d products_where_positive(const Vector3d& value) {
  const int positive = (value[0] > 0) + (value[1] > 0) + (value[2] > 0);
  if (positive == 0) return Matrix3d::Zero();
  if (positive == 3) return (Matrix3d::Ones() + Matrix3d::Identity()) / 12;
  int i = 0;
  while ((value[i] > 0) != (positive == 1)) ++i;
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  const double p = value[i] / (value[i] - value[j]), q = value[i] / (value[i] - value[k]);
  const double s = 3 - p - q;
  // The cut corner, or the whole without it.
  const double corner = (positive == 1 ? p : -p) * q / 12;
  const double whole = positive == 1 ? 0 : 1.0 / 12;
  Matrix3d products;
  products(i, i) = 2 * whole + corner * (s * s + 1 + (1 - p) * (1 - p) + (1 - q) * (1 - q));
  products(j, j) = 2 * whole + corner * 2 * p * p;
  products(k, k) = 2 * whole + corner * 2 * q * q;
  products(i, j) = products(j, i) = whole + corner * p * (s + 1 - p);
  products(i, k) = products(k, i) = whole + corner * q * (s + 1 - q);
  products(j, k) = products(k, j) = whole + corner * p * q;
  return products;
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
  Vector3d up_B;              ///< The vertical, its third row.
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

  /// Of the corners of a panel in W below a surface of the given elevations [m].
  Vector3d depth(const Panel& panel, const Vector3d& at_corners) const {
    Vector3d depth;
    for (int i = 0; i < 3; ++i) depth[i] = level + (at_corners[i] - panel[i].z());
    return depth;
  }

  /// Of the corners of a panel in B below the still water [m].
  Vector3d still_depth(const Panel& panel_B) const {
    return {level - up_B.dot(panel_B[0]), level - up_B.dot(panel_B[1]),
            level - up_B.dot(panel_B[2])};
  }

  /// What the surface does not leave over a box: it is no further from its height over the middle
  /// than its steepest slope carries it [m].
  std::pair<double, double> surface_over(const Node& box) const {
    if (surface.flat() || !std::isfinite(steepest)) return {lowest, highest};
    const double middle = level + surface.elevation(rotation * box.centre_B);
    const double away = steepest * box.half_B.norm();
    return {std::max(lowest, middle - away), std::min(highest, middle + away)};
  }

  /// Least and greatest height of a box [m].
  std::pair<double, double> heights(const Node& box) const {
    const double middle = up_B.dot(box.centre_B);
    const double half = up_B.cwiseAbs().dot(box.half_B);
    return {middle - half, middle + half};
  }
};

/// ∫ ψ_m N_n dS over a part of the face, from ∫ λ_i λ_j dS over it in terms of the face's area.
Matrix6d WettedAddedMass::Face::share_of(const Matrix3d& products) const {
  const Vector3d area = area_vector(corners_B);
  Eigen::Matrix<double, 6, 3> motions;  // N at the corners, times the area.
  for (std::size_t i = 0; i < 3; ++i)
    motions.col(static_cast<Index>(i)) << area, corners_B[i].cross(area);
  const CornerPotentials weighted = psi.lazyProduct(products);
  return weighted.lazyProduct(motions.transpose());
}

/// Sorts faces into a tree by halving them along the widest side of the box around their centroids.
class WettedAddedMass::Builder {
 public:
  Builder(const TriMesh& mesh_B, const std::vector<CornerPotentials>& potentials,
          WettedAddedMass& model)
      : mesh_B_(mesh_B), potentials_(potentials), model_(model), places_(potentials.size()) {
    for (std::size_t f = 0; f < places_.size(); ++f) {
      const auto face = static_cast<int>(f);
      const auto [a, b, c] = corners_of(face);
      places_[f] = {(a + b + c) / 3, face};
    }
    model_.faces_.reserve(places_.size());
    model_.nodes_.reserve(4 * places_.size() / kFacesALeaf + 1);
    build(0, static_cast<int>(places_.size()));
  }

 private:
  struct Place {
    Vector3d centroid;
    int face = 0;
  };

  Panel corners_of(int face) const {
    const auto v = mesh_B_.faces.col(face);
    return {mesh_B_.vertices.col(v[0]), mesh_B_.vertices.col(v[1]), mesh_B_.vertices.col(v[2])};
  }

  Eigen::AlignedBox3d build(int first, int last) {
    const std::size_t index = model_.nodes_.size();
    model_.nodes_.push_back({.first = first, .last = last});
    const Eigen::AlignedBox3d box =
        last - first <= kFacesALeaf ? fill_leaf(index) : fill_branch(index);
    Node& node = model_.nodes_[index];
    node.centre_B = box.center();
    node.half_B = box.sizes() / 2;
    node.next = static_cast<int>(model_.nodes_.size());
    return box;
  }

  Eigen::AlignedBox3d fill_leaf(std::size_t index) {
    Node& leaf = model_.nodes_[index];
    Eigen::AlignedBox3d box;
    for (int i = leaf.first; i < leaf.last; ++i) {
      const int face = places_[static_cast<std::size_t>(i)].face;
      const Panel corners = corners_of(face);
      const CornerPotentials& psi = potentials_[static_cast<std::size_t>(face)];
      model_.faces_.push_back(
          {mesh_B_.faces.col(face), corners, psi, triangle_share(corners, psi)});
      leaf.share += model_.faces_.back().share;
      for (const Vector3d& corner : corners) box.extend(corner);
    }
    return box;
  }

  Eigen::AlignedBox3d fill_branch(std::size_t index) {
    const auto [first, last] = std::pair(model_.nodes_[index].first, model_.nodes_[index].last);
    const int half = (first + last) / 2;
    halve(places_.begin() + first, places_.begin() + half, places_.begin() + last);
    const std::size_t left = index + 1;
    Eigen::AlignedBox3d box = build(first, half);
    const std::size_t right = model_.nodes_.size();
    box.extend(build(half, last));
    model_.nodes_[index].share = model_.nodes_[left].share + model_.nodes_[right].share;
    return box;
  }

  using Iterator = std::vector<Place>::iterator;
  static void halve(Iterator first, Iterator middle, Iterator last) {
    Eigen::AlignedBox3d box;
    for (auto place = first; place != last; ++place) box.extend(place->centroid);
    Index axis;
    box.sizes().maxCoeff(&axis);
    std::nth_element(first, middle, last, [axis](const Place& a, const Place& b) {
      const double at_a = a.centroid[axis], at_b = b.centroid[axis];
      return at_a < at_b || (at_a == at_b && a.face < b.face);
    });
  }

  const TriMesh& mesh_B_;
  const std::vector<CornerPotentials>& potentials_;
  WettedAddedMass& model_;
  std::vector<Place> places_;
};

WettedAddedMass::WettedAddedMass(const TriMesh& mesh_B, const AddedMassSolution& solution)
    : vertices_(mesh_B.vertex_count()),
      radius_(mesh_B.vertices.colwise().norm().maxCoeff()),
      whole_(semi_definite_part(solution.matrix)) {
  Builder(mesh_B, solution.potentials, *this);
}

Matrix6d WettedAddedMass::at(const BodyState& state, const Sea& sea, double time) const {
  const SurfaceBounds bounds = surface_bounds(sea);
  if (state.position.z() - radius_ >= bounds.highest) return Matrix6d::Zero();
  if (state.position.z() + radius_ < bounds.lowest) return sea.density * whole_;
  const Matrix3d rotation = state.orientation.toRotationMatrix();
  Immersion in{.surface = SurfaceSampler(sea, state.position, time, kSmallestPanel * radius_),
               .rotation = rotation,
               .up_B = rotation.row(2),
               .level = sea.level - state.position.z(),
               .lowest = bounds.lowest - state.position.z(),
               .highest = bounds.highest - state.position.z(),
               .steepest = steepest_slope(sea),
               .elevation = {}};
  const auto [bottom, top] = in.heights(nodes_.front());
  if (bottom >= in.highest) return Matrix6d::Zero();
  if (top < in.lowest) return sea.density * whole_;
  if (!in.surface.flat())
    in.elevation.setConstant(vertices_, std::numeric_limits<double>::quiet_NaN());
  return sea.density * semi_definite_part(sum_of_wet(in));
}

/// Whole branches that are wet, or dry, are not looked into. Bounds of the whole surface come
/// first: they cost nothing.
Matrix6d WettedAddedMass::sum_of_wet(Immersion& in) const {
  Matrix6d sum = Matrix6d::Zero();
  for (std::size_t i = 0; i < nodes_.size();) {
    const Node& node = nodes_[i];
    const auto next = static_cast<std::size_t>(node.next);
    const auto [bottom, top] = in.heights(node);
    auto [lowest, highest] = std::pair(in.lowest, in.highest);
    if (bottom < highest && top >= lowest) std::tie(lowest, highest) = in.surface_over(node);
    const bool dry = bottom >= highest;
    const bool wet = !dry && top < lowest;
    const bool leaf = next == i + 1;
    if (wet) sum += node.share;
    if (leaf && !dry && !wet) add_leaf(in, node, sum);
    i = dry || wet ? next : i + 1;
  }
  return sum;
}

void WettedAddedMass::add_leaf(Immersion& in, const Node& leaf, Matrix6d& sum) const {
  for (int i = leaf.first; i < leaf.last; ++i) {
    const Face& face = faces_[static_cast<std::size_t>(i)];
    if (!in.surface.flat()) {
      add_in_waves(in, face, sum);
      continue;
    }
    const Vector3d depth = in.still_depth(face.corners_B);
    if (depth.minCoeff() > 0)
      sum += face.share;
    else if (depth.maxCoeff() > 0)
      sum += face.share_of(products_where_positive(depth));
  }
}

void WettedAddedMass::add_in_waves(Immersion& in, const Face& face, Matrix6d& sum) const {
  Panel panel;
  for (std::size_t i = 0; i < 3; ++i) panel[i] = in.rotation * face.corners_B[i];
  if (area_vector(panel).isZero(0)) return;
  Vector3d elevation;
  for (int i = 0; i < 3; ++i)
    elevation[i] = in.elevation_over(face.vertices[i], panel[static_cast<std::size_t>(i)]);
  Matrix3d products = Matrix3d::Zero();
  for_each_linear_piece(
      panel, elevation, in.surface, [&](const Panel& piece, const Vector3d& heights) {
        const Matrix3d W = weights_in(panel, piece);
        const Matrix3d of_piece = products_where_positive(in.depth(piece, heights));
        products += W.determinant() * W * of_piece * W.transpose();
      });
  sum += face.share_of(products);
}

}  // namespace hydro
