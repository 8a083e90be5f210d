#pragma once

#include <Eigen/Core>

namespace hydro {

/// The step s of at most length `radius` that makes the quadratic model g·s + ½ s·H s least
/// [CGT00, ch. 7], exactly, from the eigenvectors of H.
///
/// At a saddle or maximum, where g has no part along the lowest eigenvector, both directions along
/// it are equally good: the one with its larger component positive is taken. A part of g below
/// `negligible` counts as none, so that round-off does not choose the side.
///
/// [CGT00] Conn, Gould, Toint. Trust-Region Methods. SIAM (2000).
Eigen::Vector2d trust_region_step(const Eigen::Vector2d& gradient, const Eigen::Matrix2d& hessian,
                                  double radius, double negligible);

}  // namespace hydro
