#include "hydro/added_mass/bem/collocation.h"

#include <cmath>
#include <numbers>

#include "hydro/decompositions.h"
#include "hydro/parallel.h"

namespace hydro::bem {
namespace {

using Eigen::Index;

/// 1 for the faces of a cavity's wall and of all parts in the cavity, else 0.
Eigen::VectorXd in_cavity(const Surface& surface, int wall) {
  std::vector<double> angle(surface.parts.volume.size(), 0);
  std::vector<bool> seen(surface.parts.volume.size(), false);
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto part = static_cast<std::size_t>(surface.part_of_face(f));
    if (seen[part]) continue;
    seen[part] = true;
    for (std::size_t g = 0; g < surface.face_count(); ++g)
      if (surface.part_of_face(g) == wall)
        angle[part] += solid_angle(surface.elements[g], surface.elements[f].centroid);
  }
  Eigen::VectorXd inside(surface.mesh.face_count());
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const int part = surface.part_of_face(f);
    // The angle is −4π inside, because the wall's normals point in, and −2π on the wall itself.
    inside[static_cast<Index>(f)] =
        part == wall || angle[static_cast<std::size_t>(part)] < -2 * std::numbers::pi;
  }
  return inside;
}

/// Adds an equation for each cavity's constant: the mean of ψ on its wall is 0.
void pin_cavities(const Surface& surface, Eigen::MatrixXd& matrix) {
  for (std::size_t k = 0; k < surface.parts.volume.size(); ++k) {
    if (surface.parts.volume[k] >= 0) continue;
    Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(matrix.cols());
    for (std::size_t f = 0; f < surface.face_count(); ++f)
      if (surface.part_of_face(f) == static_cast<int>(k))
        mean[static_cast<Index>(f)] = surface.elements[f].area;
    matrix += in_cavity(surface, static_cast<int>(k)) * (mean / mean.sum());
  }
}

}  // namespace

Potential collocate(const Surface& surface) {
  const std::vector<Element>& elements = surface.elements;
  const Index count = surface.mesh.face_count();
  Potential motion(count, 6);
  for (Index f = 0; f < count; ++f) {
    const Element& element = elements[static_cast<std::size_t>(f)];
    motion.row(f) << element.normal.transpose(), element.centroid.cross(element.normal).transpose();
  }
  Eigen::MatrixXd matrix(count, count);
  Potential side(count, 6);
  parallel_for(elements.size(), [&](std::size_t row) {
    const auto i = static_cast<Index>(row);
    side.row(i).setZero();
    for (Index j = 0; j < count; ++j) {
      const Potentials seen =
          potentials(elements[static_cast<std::size_t>(j)], elements[row].centroid);
      matrix(i, j) = kPerSphere * seen.solid_angle + (i == j ? 0.5 : 0);
      side.row(i) += kPerSphere * seen.single * motion.row(j);
    }
  });
  pin_cavities(surface, matrix);
  return hydro::solve_dense(matrix, side);
}

}  // namespace hydro::bem
