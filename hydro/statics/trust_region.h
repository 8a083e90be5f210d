#pragma once

#include <Eigen/Core>

namespace hydro {

/// Returns the step s, |s| <= `radius`, that minimises the quadratic model g·s + ½ s·H s [CGT00,
/// ch. 7], exactly, from the eigenvectors of H.
///
/// At a saddle or maximum, where g has no component along the lowest eigenvector, both directions
/// along it are equally good; the one with its larger component positive is taken. A component of g
/// below `negligible` counts as zero, so that round-off does not choose the side.
///
/// [CGT00] Conn, Gould, Toint. Trust-Region Methods. SIAM (2000).
Eigen::Vector2d trust_region_step(const Eigen::Vector2d& gradient, const Eigen::Matrix2d& hessian,
                                  double radius, double negligible);

}  // namespace hydro
