#include "hydro/added_mass/patch_integrals.h"

#include <cmath>

namespace hydro {
namespace {

using bem::Element;
using bem::Potentials;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Distance in radii beyond which a patch acts by its moments. With 4 instead of 8 the
/// half-submerged sphere's matrix changes by less than 1e-3.
constexpr double kFar = 4;

void add_far(const Patch& patch, const PatchMoments& m, const Vector3d& x, double factor,
             Seen& seen) {
  const Vector3d r = patch.centre - x;
  const double squared = r.squaredNorm();
  const double inverse = 1 / std::sqrt(squared);
  const double cubed = inverse / squared * factor;
  for (Index k = 0; k < 3; ++k) {
    const Matrix3d& lever = m.lever[static_cast<std::size_t>(k)];
    seen.twofold[k] +=
        cubed * (m.area.col(k).dot(r) + lever.trace() - 3 / squared * r.dot(lever * r));
  }
  seen.single += factor * inverse * m.source - cubed * r.transpose() * m.source_lever;
  seen.normal += factor * inverse * m.area;
  for (Index k = 0; k < 3; ++k)
    seen.normal.col(k) -= cubed * m.lever[static_cast<std::size_t>(k)] * r;
}

void add_near(const Patch& patch, const Vector3d& x, double factor, Seen& seen) {
  const Vector3d f = patch.functions(x);
  for (const Element& panel : patch.panels) {
    const Potentials p = bem::potentials(panel, x);
    const double height = panel.normal.dot(panel.centroid - x);
    // Along the panel's plane f changes by its slope; across the plane by height·slope·n.
    seen.twofold[0] += factor * p.solid_angle;
    for (Index k = 0; k < 2; ++k) {
      const Vector3d& slope = patch.slopes[static_cast<std::size_t>(k)];
      const double across = height * slope.dot(panel.normal);
      double along = 0;
      if (std::abs(height) > 1e-12 * panel.radius) along = height * slope.dot(p.attraction);
      seen.twofold[k + 1] += factor * ((f[k + 1] + across) * p.solid_angle + along);
    }
    const Vector3d weights(p.single, f[1] * p.single + patch.slopes[0].dot(p.first),
                           f[2] * p.single + patch.slopes[1].dot(p.first));
    seen.normal += factor * panel.normal * weights.transpose();
    seen.single.head<3>() += factor * p.single * panel.normal.transpose();
    seen.single.tail<3>() += factor * (p.single * x + p.first).cross(panel.normal).transpose();
  }
}

}  // namespace

MotionRow motions(const Vector3d& at, const Vector3d& normal) {
  MotionRow row;
  row << normal.transpose(), at.cross(normal).transpose();
  return row;
}

PatchMoments moments_of(const Patch& patch) {
  PatchMoments m{};
  m.area.setZero();
  for (Matrix3d& lever : m.lever) lever.setZero();
  m.source.setZero();
  m.source_lever.setZero();
  m.load.setZero();
  for (const Element& panel : patch.panels) {
    for (std::size_t e = 0; e < 3; ++e) {  // the edge-midpoint rule is exact for degree 2
      const Vector3d y = 0.5 * (panel.corners[e] + panel.corners[(e + 1) % 3]);
      const Vector3d f = patch.functions(y);
      const MotionRow N = panel.area / 3 * motions(y, panel.normal);
      const Vector3d n = panel.area / 3 * panel.normal;
      m.area += n * f.transpose();
      for (Index k = 0; k < 3; ++k)
        m.lever[static_cast<std::size_t>(k)] += f[k] * n * (y - patch.centre).transpose();
      m.source += N;
      m.source_lever += (y - patch.centre) * N;
      m.load += f * N;
    }
  }
  return m;
}

void add_seen(const Patch& patch, const PatchMoments& m, const Vector3d& x, double factor,
              Seen& seen) {
  if ((patch.centre - x).squaredNorm() > kFar * kFar * patch.radius * patch.radius)
    add_far(patch, m, x, factor, seen);
  else
    add_near(patch, x, factor, seen);
}

}  // namespace hydro
