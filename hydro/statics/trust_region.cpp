#include "hydro/statics/trust_region.h"

#include <algorithm>
#include <cmath>

#include "hydro/decompositions.h"

namespace hydro {
namespace {

/// −(Λ + shift)⁻¹ g; a component without gradient is 0.
Eigen::Vector2d shifted_step(const Eigen::Vector2d& g, const Eigen::Vector2d& eigenvalues,
                             double shift) {
  Eigen::Vector2d s;
  for (int i = 0; i < 2; ++i) s[i] = g[i] == 0 ? 0 : -g[i] / (eigenvalues[i] + shift);
  return s;
}

/// Finds by bisection the shift above `least` whose step has the length `radius`; returns the step.
Eigen::Vector2d boundary_step(const Eigen::Vector2d& g, const Eigen::Vector2d& eigenvalues,
                              double radius, double least) {
  double lo = least;
  double hi = least + g.norm() / radius;
  for (int i = 0; i < 100; ++i) {
    const double shift = (lo + hi) / 2;
    (shifted_step(g, eigenvalues, shift).norm() > radius ? lo : hi) = shift;
  }
  return shifted_step(g, eigenvalues, hi);
}

/// +1 or −1: the sign of the larger component of `v`.
double sign_of_larger(const Eigen::Vector2d& v) {
  Eigen::Index larger;
  v.cwiseAbs().maxCoeff(&larger);
  return v[larger] < 0 ? -1 : 1;
}

}  // namespace

Eigen::Vector2d trust_region_step(const Eigen::Vector2d& gradient, const Eigen::Matrix2d& hessian,
                                  double radius, double negligible) {
  const EigenDecomposition<2> eigen = eigen_decomposition(hessian);
  const Eigen::Vector2d& lambda = eigen.values;
  Eigen::Vector2d g = eigen.vectors.transpose() * gradient;
  if (lambda[0] > 0) {
    const Eigen::Vector2d newton = shifted_step(g, lambda, 0);
    if (newton.norm() <= radius) return eigen.vectors * newton;
  } else if (std::abs(g[0]) <= negligible) {
    g[0] = 0;
    // The difference of two equal eigenvalues is 0, so noise would make a step without bounds.
    if (std::abs(g[1]) <= negligible) g[1] = 0;
    Eigen::Vector2d s(0, g[1] == 0 ? 0 : -g[1] / (lambda[1] - lambda[0]));
    if (std::abs(s[1]) < radius) {
      s[0] = std::sqrt(radius * radius - s[1] * s[1]) * sign_of_larger(eigen.vectors.col(0));
      return eigen.vectors * s;
    }
  }
  return eigen.vectors * boundary_step(g, lambda, radius, std::max(0.0, -lambda[0]));
}

}  // namespace hydro
