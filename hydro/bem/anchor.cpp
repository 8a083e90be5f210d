#include <tbb/parallel_for.h>

#include <numbers>

#include "hydro/bem/galerkin.h"

namespace hydro::bem {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Points of a part at which its equation is asked for. Their mean is used, so that the error of
/// ψ at a point matters less; a constant on the part follows from any of them alone.
constexpr int kSamples = 32;

/// Faces of a part, evenly spread over its area.
std::vector<Index> samples_of(const TriMesh& mesh, const std::vector<Element>& elements,
                              const Parts& parts, int part) {
  const auto in_part = [&](Index f) {
    return parts.of_vertex[static_cast<std::size_t>(mesh.faces(0, f))] == part;
  };
  double whole = 0;
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (in_part(f)) whole += elements[static_cast<std::size_t>(f)].area;
  std::vector<Index> samples;
  double passed = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!in_part(f)) continue;
    passed += elements[static_cast<std::size_t>(f)].area;
    if (passed >= whole * (static_cast<double>(samples.size()) + 0.5) / kSamples)
      samples.push_back(f);
  }
  return samples;
}

/// What (1/4π) Σ N ∫ 1/r lacks or exceeds of ½ψ + (1/4π) ∫ ψ dΩ at the centroid of a face.
Vector6d residual(const TriMesh& mesh, const std::vector<Element>& elements, const Potential& psi,
                  Index at) {
  const Vector3d x = elements[static_cast<std::size_t>(at)].centroid;
  Vector6d sum = Vector6d::Zero();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Element& element = elements[static_cast<std::size_t>(f)];
    const Potentials seen = potentials(element, x);
    const Vector3d arm = seen.first + seen.single * x;  // ∫ y/r
    Vector6d given;
    given << seen.single * element.normal, arm.cross(element.normal);
    const double height = element.normal.dot(element.centroid - x);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = psi.row(mesh.faces(static_cast<Index>(i), f)).transpose();
      const Vector3d slope = element.curls[i].cross(element.normal);  // ∇λ
      const double hat = 1.0 / 3 + slope.dot(x - element.centroid);   // λ below x
      const double layer =
          f == at ? 0 : hat * seen.solid_angle + height * slope.dot(seen.attraction);
      given -= layer * row;
    }
    sum += given / (4 * std::numbers::pi);
  }
  for (int i = 0; i < 3; ++i) sum -= psi.row(mesh.faces(i, at)).transpose() / 6;
  return sum;
}

}  // namespace

Potential anchored(const TriMesh& mesh, const std::vector<Element>& elements, const Parts& parts,
                   Potential psi) {
  const Potential given = psi;
  for (std::size_t k = 0; k < parts.volume.size(); ++k) {
    if (parts.volume[k] < 0) continue;
    const std::vector<Index> samples = samples_of(mesh, elements, parts, static_cast<int>(k));
    std::vector<Vector6d> residuals(samples.size());
    tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) {
      residuals[i] = residual(mesh, elements, given, samples[i]);
    });
    Vector6d mean = Vector6d::Zero();
    for (const Vector6d& r : residuals) mean += r / static_cast<double>(samples.size());
    for (Index i = 0; i < psi.rows(); ++i)
      if (parts.of_vertex[static_cast<std::size_t>(i)] == static_cast<int>(k))
        psi.row(i) += mean.transpose();
  }
  return psi;
}

}  // namespace hydro::bem
