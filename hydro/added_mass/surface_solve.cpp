#include "hydro/added_mass/surface_solve.h"

#include <Eigen/LU>
#include <cmath>

#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/parallel.h"

namespace hydro {
namespace {

using bem::Element;
using bem::kPerSphere;
using bem::Potentials;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Distance in radii beyond which a patch acts by its moments. With 4 instead of 8 the
/// half-submerged sphere's matrix changes by less than 1e-3.
constexpr double kFar = 4;

/// Term that keeps the constant of a closed cavity's potential finite, which (1) leaves free and
/// which causes no load. It is small enough to change nothing else.
constexpr double kCavity = 1e-8;

MotionRow motions(const Vector3d& at, const Vector3d& normal) {
  MotionRow row;
  row << normal.transpose(), at.cross(normal).transpose();
  return row;
}

/// Moments of a patch for its effect on distant points.
struct PatchMoments {
  Eigen::Matrix3d area;                      ///< ∫ f_k n dS, one column per function k [m^2].
  std::array<Matrix3d, 3> lever;             ///< ∫ f_k n (y − centre)ᵀ dS [m^3].
  MotionRow source;                          ///< ∫ N dS.
  Eigen::Matrix<double, 3, 6> source_lever;  ///< ∫ (y − centre) N dS.
  Eigen::Matrix<double, 3, 6> load;          ///< ∫ f_k N dS, one row per function.
};

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

/// ∫ f_k n·(y − x)/r³ dS and ∫ N/r dS over a patch, seen from x.
struct Seen {
  Vector3d twofold = Vector3d::Zero();
  MotionRow single = MotionRow::Zero();
};

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
    seen.single.head<3>() += factor * p.single * panel.normal.transpose();
    seen.single.tail<3>() += factor * (p.single * x + p.first).cross(panel.normal).transpose();
  }
}

void add_seen(const Patch& patch, const PatchMoments& m, const Vector3d& x, double factor,
              Seen& seen) {
  if ((patch.centre - x).squaredNorm() > kFar * kFar * patch.radius * patch.radius)
    add_far(patch, m, x, factor, seen);
  else
    add_near(patch, x, factor, seen);
}

struct System {
  Eigen::MatrixXd matrix;
  Eigen::Matrix<double, Eigen::Dynamic, 6> side;
};

/// Fills the three rows of equation (1) for patch `i`.
void fill_rows(const std::vector<Patch>& patches, const std::vector<PatchMoments>& moments,
               const WaterPlane& plane, std::size_t i, System& system) {
  const Index row = 3 * static_cast<Index>(i);
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
  for (const PatchPoint& point : patches[i].points) {
    const Vector3d f = patches[i].functions(point.at);
    const Vector3d test = point.weight / patches[i].area * f;
    own += test * f.transpose();
    for (std::size_t j = 0; j < patches.size(); ++j) {
      Seen seen;
      add_seen(patches[j], moments[j], point.at, kPerSphere, seen);
      if (plane.bounded())
        add_seen(patches[j], moments[j], plane.mirrored(point.at), -kPerSphere, seen);
      system.matrix.block<3, 3>(row, 3 * static_cast<Index>(j)) += test * seen.twofold.transpose();
      system.side.middleRows<3>(row) += test * seen.single;
    }
  }
  system.matrix.block<3, 3>(row, row) += (0.5 + kCavity) * own;
  for (Index k = 0; k < 2; ++k)  // a function that the patch lacks has a coefficient of 0
    if (patches[i].slopes[static_cast<std::size_t>(k)].isZero(0))
      system.matrix(row + k + 1, row + k + 1) = 1;
}

/// The symmetry_error of a matrix: rotations are divided by the root of the wetted area.
double asymmetry(const Matrix6d& matrix, const std::vector<Patch>& patches) {
  double area = 0;
  for (const Patch& patch : patches) area += patch.area;
  Vector6d lever = Vector6d::Ones();
  lever.tail<3>() *= std::sqrt(area);
  const Matrix6d even = lever.cwiseInverse().asDiagonal() * (matrix - matrix.transpose()) *
                        lever.cwiseInverse().asDiagonal();
  return even.cwiseAbs().maxCoeff() / matrix.diagonal().head<3>().maxCoeff();
}

}  // namespace

SurfaceSolution solve_under(const TriMesh& mesh_B, const WaterPlane& plane, int count) {
  const std::vector<Patch> patches = wetted_patches(mesh_B, plane, count);
  if (patches.empty()) return {};
  std::vector<PatchMoments> moments;
  for (const Patch& patch : patches) moments.push_back(moments_of(patch));
  const Index unknowns = 3 * static_cast<Index>(patches.size());
  System system{Eigen::MatrixXd::Zero(unknowns, unknowns),
                Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(unknowns, 6)};
  parallel_for(patches.size(),
               [&](std::size_t i) { fill_rows(patches, moments, plane, i, system); });
  const Eigen::Matrix<double, Eigen::Dynamic, 6> psi =
      Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>>(system.matrix).solve(system.side);
  Matrix6d matrix = Matrix6d::Zero();
  for (std::size_t i = 0; i < patches.size(); ++i)
    matrix += psi.middleRows<3>(3 * static_cast<Index>(i)).transpose() * moments[i].load;
  SurfaceSolution solution{.unknowns = static_cast<int>(unknowns)};
  solution.symmetry_error = asymmetry(matrix, patches);
  solution.matrix = semi_definite_part(matrix);
  return solution;
}

}  // namespace hydro
