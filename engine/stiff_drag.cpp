#include "engine/stiff_drag.h"

#include <Eigen/Cholesky>

namespace engine {
namespace {

using hydro::Matrix6d;
using hydro::Vector6d;

Vector6d stacked(const hydro::Wrench& wrench) {
  Vector6d six;
  six << wrench.force, wrench.moment;
  return six;
}

Matrix6d mass_matrix(const BodySpec& body, const hydro::BodyState& state) {
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  Matrix6d mass = Matrix6d::Zero();
  mass.diagonal().head<3>().setConstant(body.mass);
  mass.bottomRightCorner<3, 3>() = R_WB * body.inertia_B * R_WB.transpose();
  return mass;
}

/// Solves matrix·x = rhs for the free degrees of freedom; x is zero in the locked ones.
Vector6d solve_free(Matrix6d matrix, Vector6d rhs, const DofMask& locked) {
  for (int i = 0; i < 6; ++i) {
    if (!locked[static_cast<std::size_t>(i)]) continue;
    const double pivot = matrix(i, i);
    matrix.row(i).setZero();
    matrix.col(i).setZero();
    matrix(i, i) = pivot;
    rhs[i] = 0;
  }
  return matrix.ldlt().solve(rhs);
}

hydro::Wrench drag_of(const hydro::Loads& loads) {
  return loads.pressure_drag + loads.viscous_drag;
}

/// J = −∂D/∂ν by forward differences, a millionth of the body's own speed apart.
Matrix6d resistance(const BodySpec& body, const hydro::Hull& hull, const hydro::BodyState& state,
                    const hydro::Sea& sea, double time) {
  hydro::Coefficients drag_only = body.coefficients;
  drag_only.buoyancy = false;
  drag_only.lift = 0;
  const auto drag = [&](const hydro::BodyState& moved) {
    return stacked(drag_of(hydro::compute_loads(hull, moved, sea, time, drag_only)));
  };
  const double speed =
      (state.linear_velocity - sea.current).norm() + state.angular_velocity.norm() * hull.radius;
  const Vector6d before = drag(state);
  Matrix6d J;
  for (int i = 0; i < 6; ++i) {
    hydro::BodyState moved = state;
    const double change = 1e-6 * (i < 3 ? speed : speed / hull.radius);
    (i < 3 ? moved.linear_velocity : moved.angular_velocity)[i % 3] += change;
    J.col(i) = (before - drag(moved)) / change;
  }
  return (J + J.transpose()) / 2;
}

}  // namespace

double drag_stiffness(const BodySpec& body, const hydro::BodyState& state,
                      const Eigen::Vector3d& current, const hydro::Wrench& drag, double step) {
  const Vector6d D = stacked(drag);
  const Vector6d motion = stacked({state.linear_velocity - current, state.angular_velocity});
  const double power = -D.dot(motion);
  if (power <= 0) return 0;
  return step * D.dot(solve_free(mass_matrix(body, state), D, body.locked)) / power;
}

hydro::Wrench implicit_part(const BodySpec& body, const hydro::Hull& hull,
                            const hydro::BodyState& state, const hydro::Sea& sea, double time,
                            const hydro::Wrench& load, double step) {
  const Matrix6d J = resistance(body, hull, state, sea, time);
  const Matrix6d matrix = mass_matrix(body, state) + step * J;
  const Vector6d change = solve_free(matrix, step * stacked(load), body.locked);
  const Vector6d part = -J * change;
  return {part.head<3>(), part.tail<3>()};
}

}  // namespace engine
