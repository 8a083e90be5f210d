#include "hydro/bem/collocation.h"

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace hydro::bem {
namespace {

using Eigen::Index;

int part_of(const TriMesh& mesh, const Parts& parts, Index face) {
  return parts.of_vertex[static_cast<std::size_t>(mesh.faces(0, face))];
}

/// 1 for the faces of a cavity's wall and of all that is in the cavity, else 0.
Eigen::VectorXd in_cavity(const TriMesh& mesh, const std::vector<Element>& elements,
                          const Parts& parts, int wall) {
  std::vector<double> angle(parts.volume.size(), 0);
  std::vector<bool> seen(parts.volume.size(), false);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto part = static_cast<std::size_t>(part_of(mesh, parts, f));
    if (seen[part]) continue;
    seen[part] = true;
    for (Index g = 0; g < mesh.face_count(); ++g)
      if (part_of(mesh, parts, g) == wall)
        angle[part] += solid_angle(elements[static_cast<std::size_t>(g)],
                                   elements[static_cast<std::size_t>(f)].centroid);
  }
  Eigen::VectorXd inside(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const int part = part_of(mesh, parts, f);
    // −4π inside, as the wall's normals point in; −2π on the wall itself.
    inside[f] = part == wall || angle[static_cast<std::size_t>(part)] < -2 * std::numbers::pi;
  }
  return inside;
}

/// Each cavity's constant gets an equation: that the mean on its wall is 0.
void pin_cavities(const TriMesh& mesh, const std::vector<Element>& elements, const Parts& parts,
                  Eigen::MatrixXd& matrix) {
  for (std::size_t k = 0; k < parts.volume.size(); ++k) {
    if (parts.volume[k] >= 0) continue;
    Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(mesh.face_count());
    for (Index f = 0; f < mesh.face_count(); ++f)
      if (part_of(mesh, parts, f) == static_cast<int>(k))
        mean[f] = elements[static_cast<std::size_t>(f)].area;
    matrix += in_cavity(mesh, elements, parts, static_cast<int>(k)) * (mean / mean.sum());
  }
}

}  // namespace

Potential collocate(const TriMesh& mesh, const std::vector<Element>& elements, const Parts& parts) {
  const Index count = mesh.face_count();
  constexpr double kPerSphere = 1 / (4 * std::numbers::pi);
  Potential motion(count, 6);
  for (Index f = 0; f < count; ++f) {
    const Element& element = elements[static_cast<std::size_t>(f)];
    motion.row(f) << element.normal.transpose(), element.centroid.cross(element.normal).transpose();
  }
  Eigen::MatrixXd matrix(count, count);
  Potential side(count, 6);
  tbb::parallel_for(tbb::blocked_range<Index>(0, count, 16), [&](const auto& range) {
    for (Index i = range.begin(); i < range.end(); ++i) {
      side.row(i).setZero();
      for (Index j = 0; j < count; ++j) {
        const Potentials seen = potentials(elements[static_cast<std::size_t>(j)],
                                           elements[static_cast<std::size_t>(i)].centroid);
        matrix(i, j) = kPerSphere * seen.solid_angle + (i == j ? 0.5 : 0);
        side.row(i) += kPerSphere * seen.single * motion.row(j);
      }
    }
  });
  pin_cavities(mesh, elements, parts, matrix);
  return Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>>(matrix).solve(side);
}

}  // namespace hydro::bem
