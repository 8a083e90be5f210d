#include "engine/motion/pull.h"

#include <Eigen/LU>

#include "hydro/decompositions.h"

namespace engine {

hydro::Wrench wrench(const Pull& pull, const Matrix6d& inertia_W, const hydro::BodyState& state) {
  using Eigen::Vector3d;
  const Vector3d r = state.orientation * pull.at_B;
  const Vector3d offset = pull.to_W - state.position - r;
  const Vector3d speed = state.linear_velocity + state.angular_velocity.cross(r);
  Eigen::Matrix<double, 3, 6> J;
  J << Eigen::Matrix3d::Identity(), -cross_matrix(r);
  const Eigen::Matrix3d mass =
      (J * hydro::Cholesky6(inertia_W).inverse() * J.transpose()).inverse();
  const Vector3d force = mass * (pull.rate * pull.rate * offset - 2 * pull.rate * speed);
  return {.force = force, .moment = r.cross(force)};
}

}  // namespace engine
