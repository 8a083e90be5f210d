#include "hydro/bem/element.h"

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

double solid_angle(const Element& element, const Vector3d& x) {
  const Vector3d a = element.corners[0] - x;
  const Vector3d b = element.corners[1] - x;
  const Vector3d c = element.corners[2] - x;
  const double ra = a.norm(), rb = b.norm(), rc = c.norm();
  // From the plane: the triple product without its cancellation.
  const double triple = 2 * element.area * element.normal.dot(element.centroid - x);
  if (std::abs(triple) <= 1e-14 * element.area * element.radius) return 0;
  return 2 * std::atan2(triple, ra * rb * rc + a.dot(b) * rc + b.dot(c) * ra + c.dot(a) * rb);
}

Potentials potentials(const Element& element, const Vector3d& x) {
  const double height = element.normal.dot(element.centroid - x);
  Potentials result{0, Vector3d::Zero(), solid_angle(element, x), Vector3d::Zero()};
  std::array<double, 3> range;  // of the corners from x
  for (std::size_t i = 0; i < 3; ++i) range[i] = (element.corners[i] - x).norm();
  for (std::size_t e = 0; e < 3; ++e) {
    const double near = range[e], far = range[(e + 1) % 3], length = element.lengths[e];
    const Vector3d to_edge = element.corners[e] - x;
    const double offset = to_edge.dot(element.conormals[e]);
    const double start = to_edge.dot(element.tangents[e]);
    // ∫ 1/r along the edge. On the edge it is infinite, but its factors there are 0.
    const double sum = near + far;
    const double gap = std::max(sum - length, std::numeric_limits<double>::min() + 1e-16 * length);
    const double line = std::log((sum + length) / gap);
    const double squared = offset * offset + height * height;
    result.single += offset * line;
    result.attraction -= line * element.conormals[e];
    result.first +=
        0.5 * ((start + length) * far - start * near + squared * line) * element.conormals[e];
  }
  result.single -= height * result.solid_angle;
  result.first += height * result.single * element.normal;
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
