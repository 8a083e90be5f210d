#include "hydro/bem/estimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hydro::bem {
namespace {

using Eigen::Vector3d;

/// Edges that turn by less are smooth, those that turn by more than the second are sharp [rad].
constexpr double kSmoothTurn = 10 * std::numbers::pi / 180;
constexpr double kSharpTurn = 35 * std::numbers::pi / 180;

/// What is left of a sharp edge's influence one ring of panels farther, and how many there are.
constexpr double kFading = 0.7;
constexpr int kRings = 8;

/// ∂ψ/∂m along the conormal of edge e, for each motion, and the same of the body's velocity.
Vector6d slip_across(const TriMesh& mesh, const std::vector<Element>& elements,
                     const Potential& psi, int face, std::size_t e) {
  const Element& element = elements[static_cast<std::size_t>(face)];
  const Vector3d& conormal = element.conormals[e];
  const Vector3d middle = 0.5 * (element.corners[e] + element.corners[(e + 1) % 3]);
  Vector6d slip;
  slip << conormal, middle.cross(conormal);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d slope = element.curls[i].cross(element.normal);  // ∇λ
    slip +=
        slope.dot(conormal) * psi.row(mesh.faces(static_cast<Eigen::Index>(i), face)).transpose();
  }
  return slip;
}

/// How sharp the body is at each vertex, 0 … 1: by the sharpest edge there.
std::vector<double> sharpness(const TriMesh& mesh, const std::vector<Element>& elements,
                              const Edges& edges) {
  std::vector<double> sharp(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (std::size_t f = 0; f < elements.size(); ++f) {
    for (std::size_t e = 0; e < 3; ++e) {
      const auto& [a, b] = edges.faces[static_cast<std::size_t>(edges.of_face[f][e])];
      const double cosine = elements[static_cast<std::size_t>(a)].normal.dot(
          elements[static_cast<std::size_t>(b)].normal);
      const double turn = std::acos(std::clamp(cosine, -1.0, 1.0));
      const double here = std::clamp((turn - kSmoothTurn) / (kSharpTurn - kSmoothTurn), 0.0, 1.0);
      for (const std::size_t corner : {e, (e + 1) % 3}) {
        double& most = sharp[static_cast<std::size_t>(
            mesh.faces(static_cast<Eigen::Index>(corner), static_cast<Eigen::Index>(f)))];
        most = std::max(most, here);
      }
    }
  }
  return sharp;
}

/// The largest value at a face's corners.
double most_of(const TriMesh& mesh, Eigen::Index face, const std::vector<double>& of_vertex) {
  double most = 0;
  for (Eigen::Index i = 0; i < 3; ++i)
    most = std::max(most, of_vertex[static_cast<std::size_t>(mesh.faces(i, face))]);
  return most;
}

/// κ of each face. What a sharp edge does to the flow fades from ring to ring of panels around it.
std::vector<double> factors_of_faces(const TriMesh& mesh, const std::vector<Element>& elements,
                                     const Edges& edges) {
  std::vector<double> sharp = sharpness(mesh, elements, edges);
  for (int ring = 0; ring < kRings; ++ring) {
    const std::vector<double> before = sharp;
    for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
      const double faded = kFading * most_of(mesh, f, before);
      for (Eigen::Index i = 0; i < 3; ++i) {
        double& here = sharp[static_cast<std::size_t>(mesh.faces(i, f))];
        here = std::max(here, faded);
      }
    }
  }
  std::vector<double> factors(elements.size());
  for (std::size_t f = 0; f < elements.size(); ++f)
    factors[f] = kSmooth + most_of(mesh, static_cast<Eigen::Index>(f), sharp) * (kSharp - kSmooth);
  return factors;
}

/// Jumps across the edges, with what they are weighed by.
struct Jumps {
  std::vector<Vector6d> slip;
  std::vector<double> area;    ///< Of both panels [m^2].
  std::vector<double> factor;  ///< κ.
};

Jumps find_jumps(const TriMesh& mesh, const std::vector<Element>& elements, const Edges& edges,
                 const Potential& psi) {
  const std::size_t count = edges.faces.size();
  Jumps jumps{std::vector<Vector6d>(count, Vector6d::Zero()), std::vector<double>(count, 0),
              std::vector<double>(count, 0)};
  const std::vector<double> factors = factors_of_faces(mesh, elements, edges);
  for (std::size_t f = 0; f < elements.size(); ++f) {
    for (std::size_t e = 0; e < 3; ++e) {
      const auto edge = static_cast<std::size_t>(edges.of_face[f][e]);
      jumps.slip[edge] += slip_across(mesh, elements, psi, static_cast<int>(f), e);
      jumps.area[edge] += elements[f].area;
      jumps.factor[edge] = std::max(jumps.factor[edge], factors[f]);
    }
  }
  return jumps;
}

/// How much the slip changes along edge e of a face: from its jumps across the other two, each
/// spread over the distance from centroid to centroid.
Vector6d bend_along(const Element& element, const std::array<int, 3>& edges, const Jumps& jumps,
                    std::size_t e) {
  Vector6d bend = Vector6d::Zero();
  for (const std::size_t i : {(e + 1) % 3, (e + 2) % 3}) {
    const auto other = static_cast<std::size_t>(edges[i]);
    const double across = element.conormals[i].dot(element.tangents[e]);
    const double spread = jumps.area[other] / element.lengths[i];
    bend += jumps.slip[other] * std::sqrt(jumps.factor[other]) *
            (across * across * element.lengths[e] / spread);
  }
  return bend;
}

}  // namespace

Kinks find_kinks(const TriMesh& mesh, const std::vector<Element>& elements, const Edges& edges,
                 const Potential& psi, const Matrix6d& weight) {
  const Jumps jumps = find_jumps(mesh, elements, edges, psi);
  Kinks kinks;
  kinks.of_edge.assign(edges.faces.size(), 0);
  for (std::size_t f = 0; f < elements.size(); ++f) {
    for (std::size_t e = 0; e < 3; ++e) {
      const auto edge = static_cast<std::size_t>(edges.of_face[f][e]);
      const Vector6d bend = bend_along(elements[f], edges.of_face[f], jumps, e);
      kinks.of_edge[edge] += elements[f].area * elements[f].lengths[e] * bend.dot(weight * bend);
      // Half of it from each side.
      const double factor =
          jumps.factor[edge] * jumps.area[edge] * jumps.area[edge] / (2 * elements[f].lengths[e]);
      kinks.missing += factor * jumps.slip[edge] * jumps.slip[edge].transpose();
    }
  }
  return kinks;
}

}  // namespace hydro::bem
