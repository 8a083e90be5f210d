#include "engine/pull.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace engine {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// M_p of the point r from the centre of mass.
Matrix3d mass_at(const Vector3d& r, const Matrix6d& inertia) {
  Eigen::Matrix<double, 3, 6> J;
  J << Matrix3d::Identity(), -cross_matrix(r);
  return (J * inertia.llt().solve(J.transpose())).inverse();
}

}  // namespace

hydro::Wrench wrench(const Pull& pull, const Matrix6d& inertia_W, const hydro::BodyState& state) {
  const Vector3d r = state.orientation * pull.at_B;
  const Vector3d off = pull.to_W - state.position - r;
  const Vector3d speed = state.linear_velocity + state.angular_velocity.cross(r);
  const Vector3d force =
      mass_at(r, inertia_W) * (pull.rate * pull.rate * off - 2 * pull.rate * speed);
  return {.force = force, .moment = r.cross(force)};
}

}  // namespace engine
