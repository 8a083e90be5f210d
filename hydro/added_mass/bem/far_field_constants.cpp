#include <cmath>

#include "hydro/added_mass/bem/galerkin.h"
#include "hydro/parallel.h"

namespace hydro::bem {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Number of points of a part at which its equation is evaluated. Any point alone gives the
/// constant of the part; the mean reduces the effect of the error of ψ at a point.
constexpr int kSamples = 32;

/// Faces of a part, evenly spread over its area.
std::vector<std::size_t> samples_of(const Surface& surface, int part) {
  double whole = 0;
  for (std::size_t f = 0; f < surface.face_count(); ++f)
    if (surface.part_of_face(f) == part) whole += surface.elements[f].area;
  std::vector<std::size_t> samples;
  double passed = 0;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    if (surface.part_of_face(f) != part) continue;
    passed += surface.elements[f].area;
    if (passed >= whole * (static_cast<double>(samples.size()) + 0.5) / kSamples)
      samples.push_back(f);
  }
  return samples;
}

/// ∫ φ dΩ for the six functions on an element, seen from x.
std::array<double, 6> double_layers(const Element& element, const PotentialMoments& seen,
                                    const Vector3d& x) {
  const double height = element.normal.dot(element.centroid - x);
  const Vector3d hats = hats_at(element, x);
  const auto& slopes = element.slopes;
  const auto hat = [&](std::size_t i) { return hats[static_cast<Index>(i)]; };
  std::array<double, 6> layers;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    layers[i] = hat(i) * seen.solid_angle + height * slopes[i].dot(seen.attraction);
    layers[3 + i] = 4 * (hat(i) * hat(j) * seen.solid_angle +
                         height * (hat(i) * slopes[j] + hat(j) * slopes[i]).dot(seen.attraction) +
                         height * slopes[i].dot(seen.stress * slopes[j]));
  }
  return layers;
}

/// Σ N ∫ 1/r − ∫ ψ dΩ seen from x, without ∫ ψ dΩ of the face `own` whose centroid is x.
Vector6d excess(const Surface& surface, const Potential& psi, const Vector3d& x, std::size_t own) {
  Vector6d sum = Vector6d::Zero();
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const Element& element = surface.elements[f];
    const PotentialMoments seen = potential_moments(element, x);
    const Vector3d arm = seen.first + seen.single * x;  // ∫ y/r
    Vector6d given;
    given << seen.single * element.normal, arm.cross(element.normal);
    if (f != own) {  // An element's own double layer is 0 on it.
      const std::array<double, 6> layers = double_layers(element, seen, x);
      const std::array<int, 6> rows = functions_of(surface, f);
      for (std::size_t k = 0; k < 6; ++k) given -= layers[k] * psi.row(rows[k]).transpose();
    }
    sum += given;
  }
  return sum;
}

/// (1/4π) Σ N ∫ 1/r − ½ψ − (1/4π) ∫ ψ dΩ at the centroid of a face.
Vector6d residual(const Surface& surface, const Potential& psi, std::size_t at) {
  Vector6d sum = excess(surface, psi, surface.elements[at].centroid, at) * kPerSphere;
  const std::array<int, 6> rows = functions_of(surface, at);
  for (std::size_t i = 0; i < 3; ++i)
    sum -= psi.row(rows[i]).transpose() / 6 + 2 * psi.row(rows[3 + i]).transpose() / 9;
  return sum;
}

/// Mean residual over sample faces of a part: the missing constant of its potential.
Vector6d mean_residual(const Surface& surface, const Potential& psi, int part) {
  const std::vector<std::size_t> samples = samples_of(surface, part);
  std::vector<Vector6d> residuals(samples.size());
  parallel_for(samples.size(),
               [&](std::size_t i) { residuals[i] = residual(surface, psi, samples[i]); });
  Vector6d mean = Vector6d::Zero();
  for (const Vector6d& r : residuals) mean += r / static_cast<double>(samples.size());
  return mean;
}

/// Centroid of the volume that a part encloses.
Vector3d centroid_of(const Surface& surface, int part) {
  double volume = 0;
  Vector3d moment = Vector3d::Zero();
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    if (surface.part_of_face(f) != part) continue;
    const Element& element = surface.elements[f];
    const double cone = element.area * element.normal.dot(element.centroid) / 3;
    volume += cone;
    moment += 0.75 * cone * element.centroid;
  }
  return moment / volume;
}

/// True if x is inside a part, outside all others, and clear of the surface.
bool is_inside(const Surface& surface, const Vector3d& x, int part) {
  std::vector<double> turns(surface.parts.volume.size());
  for (std::size_t f = 0; f < surface.face_count(); ++f)
    turns[static_cast<std::size_t>(surface.part_of_face(f))] +=
        solid_angle(surface.elements[f], x) * kPerSphere;
  for (std::size_t k = 0; k < turns.size(); ++k)
    if (std::abs(turns[k] - (static_cast<int>(k) == part ? 1 : 0)) > 1e-6) return false;
  return true;
}

/// The missing constant of a part's potential. Inside the part (1/4π) Σ N ∫ 1/r equals (1/4π) ∫ ψ
/// dΩ at any point. The centroid is used because it is away from the surface and shares the body's
/// symmetries; where it is not inside, as in a ring, points on the surface are used.
Vector6d constant_of(const Surface& surface, const Potential& psi, int part) {
  const Vector3d x = centroid_of(surface, part);
  if (!is_inside(surface, x, part)) return mean_residual(surface, psi, part);
  return excess(surface, psi, x, surface.face_count()) * kPerSphere;
}

}  // namespace

Potential with_far_field_constants(const Surface& surface, Potential psi) {
  const Potential given = psi;
  for (std::size_t k = 0; k < surface.parts.volume.size(); ++k) {
    if (surface.parts.volume[k] < 0) continue;
    const Vector6d constant = constant_of(surface, given, static_cast<int>(k));
    for (Index i = 0; i < surface.vertex_count(); ++i)
      if (surface.parts.of_vertex[static_cast<std::size_t>(i)] == static_cast<int>(k))
        psi.row(i) += constant.transpose();
  }
  return psi;
}

}  // namespace hydro::bem
