#include "hydro/added_mass/bem/element.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hydro::bem {

using Eigen::Vector3d;

Element make_element(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  Element element;
  element.corners = {a, b, c};
  const Vector3d twice_area = (b - a).cross(c - a);
  element.area = 0.5 * twice_area.norm();
  element.normal = twice_area.normalized();
  element.centroid = (a + b + c) / 3;
  for (std::size_t e = 0; e < 3; ++e) {
    const Vector3d edge = element.corners[(e + 1) % 3] - element.corners[e];
    element.lengths[e] = edge.norm();
    element.tangents[e] = edge / element.lengths[e];
    element.conormals[e] = element.tangents[e].cross(element.normal);
    element.curls[(e + 2) % 3] = edge / (-2 * element.area);
    element.slopes[(e + 2) % 3] = element.curls[(e + 2) % 3].cross(element.normal);
    element.radius = std::max(element.radius, (element.corners[e] - element.centroid).norm());
  }
  return element;
}

std::vector<Element> make_elements(const TriMesh& mesh) {
  std::vector<Element> elements;
  elements.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    const Eigen::Vector3i face = mesh.faces.col(f);
    elements.push_back(make_element(mesh.vertices.col(face[0]), mesh.vertices.col(face[1]),
                                    mesh.vertices.col(face[2])));
  }
  return elements;
}

Vector3d hats_at(const Element& element, const Vector3d& x) {
  const Vector3d offset = x - element.centroid;
  return {1.0 / 3 + element.slopes[0].dot(offset), 1.0 / 3 + element.slopes[1].dot(offset),
          1.0 / 3 + element.slopes[2].dot(offset)};
}

double solid_angle(const Element& element, const Vector3d& x) {
  const Vector3d a = element.corners[0] - x;
  const Vector3d b = element.corners[1] - x;
  const Vector3d c = element.corners[2] - x;
  const double ra = a.norm(), rb = b.norm(), rc = c.norm();
  // The distance from the plane gives the triple product without cancellation.
  const double triple = 2 * element.area * element.normal.dot(element.centroid - x);
  if (std::abs(triple) <= 1e-14 * element.area * element.radius) return 0;
  return 2 * std::atan2(triple, ra * rb * rc + a.dot(b) * rc + b.dot(c) * ra + c.dot(a) * rb);
}

namespace {

/// Integrals of 1/r, r, s·r and s/r along one edge, with s measured from the foot of x on the
/// edge's line.
struct EdgeIntegrals {
  double offset;   ///< Offset of the edge's line from x, along the conormal [m].
  double inverse;  ///< ∫ 1/r ds, infinite on the edge itself, where its factors are 0.
  double linear;   ///< ∫ r ds.
  double rise;     ///< ∫ s r ds.
  double growth;   ///< ∫ s/r ds.
};

EdgeIntegrals along_edge(const Element& element, std::size_t e, const Vector3d& x, double near,
                         double far, double height) {
  const double length = element.lengths[e];
  const Vector3d to_edge = element.corners[e] - x;
  const double offset = to_edge.dot(element.conormals[e]);
  const double start = to_edge.dot(element.tangents[e]);
  const double sum = near + far;
  const double gap = std::max(sum - length, std::numeric_limits<double>::min() + 1e-16 * length);
  const double inverse = std::log((sum + length) / gap);
  const double squared = offset * offset + height * height;
  return {offset, inverse, 0.5 * ((start + length) * far - start * near + squared * inverse),
          (far * far * far - near * near * near) / 3, length * (2 * start + length) / sum};
}

/// Returns the potentials, and calls f for each edge.
template <class Function>
Potentials integrated(const Element& element, const Vector3d& x, Function&& f) {
  const double height = element.normal.dot(element.centroid - x);
  Potentials result{0, Vector3d::Zero(), solid_angle(element, x), Vector3d::Zero()};
  std::array<double, 3> range;  // distances of the corners from x
  for (std::size_t i = 0; i < 3; ++i) range[i] = (element.corners[i] - x).norm();
  for (std::size_t e = 0; e < 3; ++e) {
    const EdgeIntegrals edge = along_edge(element, e, x, range[e], range[(e + 1) % 3], height);
    result.single += edge.offset * edge.inverse;
    result.attraction -= edge.inverse * element.conormals[e];
    result.first += edge.linear * element.conormals[e];
    f(e, edge);
  }
  result.single -= height * result.solid_angle;
  result.first += height * result.single * element.normal;
  return result;
}

}  // namespace

Potentials potentials(const Element& element, const Vector3d& x) {
  return integrated(element, x, [](std::size_t, const EdgeIntegrals&) {});
}

PotentialMoments potential_moments(const Element& element, const Vector3d& x) {
  PotentialMoments result;
  result.second.setZero();
  result.stress.setZero();
  double distances = 0;  // 3 ∫ r dS − height² ∫ 1/r dS
  // The terms follow from ∇r = ρ/r and ∇(1/r) = −ρ/r³, with ρ = offset·conormal + s·tangent on the
  // edge.
  static_cast<Potentials&>(result) =
      integrated(element, x, [&](std::size_t e, const EdgeIntegrals& edge) {
        const Vector3d& conormal = element.conormals[e];
        const Vector3d& tangent = element.tangents[e];
        result.second +=
            (edge.offset * edge.linear * conormal + edge.rise * tangent) * conormal.transpose();
        result.stress -=
            (edge.offset * edge.inverse * conormal + edge.growth * tangent) * conormal.transpose();
        distances += edge.offset * edge.linear;
      });
  const double height = element.normal.dot(element.centroid - x);
  const Eigen::Matrix3d flat =
      Eigen::Matrix3d::Identity() - element.normal * element.normal.transpose();
  result.second -= (distances + height * height * result.single) / 3 * flat;
  result.stress += result.single * flat;
  return result;
}

double distance(const Element& element, const Vector3d& x) {
  double nearest = std::numeric_limits<double>::infinity();
  bool above = true;
  for (std::size_t e = 0; e < 3; ++e) {
    const Vector3d r = x - element.corners[e];
    above = above && r.dot(element.conormals[e]) <= 0;
    const double along = std::clamp(r.dot(element.tangents[e]), 0.0, element.lengths[e]);
    nearest = std::min(nearest, (r - along * element.tangents[e]).norm());
  }
  return above ? std::abs(element.normal.dot(x - element.centroid)) : nearest;
}

}  // namespace hydro::bem
