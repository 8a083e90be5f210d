#include "hydro/radiation/wave_frame.h"

#include <cmath>

#include "hydro/decompositions.h"

namespace hydro {
namespace {

/// Added moment of inertia of a turn that moves no water, over the added mass and the square of the
/// largest distance from the axis [-]. A sphere of 500 triangles has 1e-3, a square prism 0.08.
constexpr double kSlides = 5e-3;

/// Least angle between an axis and the vertical at which the axis tells a heading [rad].
constexpr double kLeastLean = 1e-6;

/// The axes that an axis e has with the vertical: e, the horizontal one, the upper one.
Eigen::Matrix3d axes_of(const Eigen::Vector3d& e) {
  const Eigen::Vector3d side = Eigen::Vector3d::UnitZ().cross(e).normalized();
  Eigen::Matrix3d axes;
  axes << e, side, e.cross(side);
  return axes;
}

}  // namespace

Vector6d WaveFrame::velocity_in(const Vector6d& u_W) const {
  const Eigen::Matrix3d R_HW = R_WH.conjugate().toRotationMatrix();
  const Eigen::Vector3d spin = u_W.tail<3>();
  Vector6d u_H;
  u_H << R_HW * (u_W.head<3>() + spin.cross(origin)), R_HW * spin;
  return u_H;
}

Vector6d WaveFrame::load_out(const Vector6d& load_H) const {
  const Eigen::Matrix3d R = R_WH.toRotationMatrix();
  const Eigen::Vector3d force = R * load_H.head<3>();
  Vector6d load_W;
  load_W << force, R * load_H.tail<3>() + origin.cross(force);
  return load_W;
}

Matrix6d WaveFrame::tensor_out(const Matrix6d& tensor_H) const {
  const Eigen::Matrix3d R = R_WH.toRotationMatrix();
  Matrix6d to_W = Matrix6d::Zero();  // of loads
  to_W.topLeftCorner<3, 3>() = to_W.bottomRightCorner<3, 3>() = R;
  to_W.bottomLeftCorner<3, 3>() = cross_matrix(origin) * R;
  return to_W * tensor_H * to_W.transpose();
}

double WaveFrame::heading() const { return 2 * std::atan2(R_WH.z(), R_WH.w()); }

WaveFrameRule::WaveFrameRule(const MeanPose& pose, const Eigen::Matrix3Xd& vertices_B,
                             const Matrix6d& added_H)
    : R_HB_(pose.orientation) {
  const Eigen::Matrix3d mass = added_H.topLeftCorner<3, 3>();
  const Eigen::Vector3d masses = eigenvalues(mass);
  if (!(masses[0] > 0)) return;
  // The velocity of the centre of mass with which a turn, a column each, moves the least water.
  const Eigen::Matrix3d v = -mass.inverse() * added_H.topRightCorner<3, 3>();
  const Eigen::Matrix3d least =
      added_H.bottomRightCorner<3, 3>() + added_H.bottomLeftCorner<3, 3>() * v;
  const Eigen::Matrix3Xd vertices_H = R_HB_.toRotationMatrix() * vertices_B;
  const auto moves_no_water = [&](const Eigen::Vector3d& e, const Eigen::Vector3d& c) {
    const Eigen::Matrix3Xd from_axis = cross_matrix(e) * (vertices_H.colwise() - c);
    return e.dot(least * e) <=
           kSlides * masses.mean() * from_axis.colwise().squaredNorm().maxCoeff();
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY();
  // v = c × e for e along x and y tells c.
  const Eigen::Vector3d centre(v(2, 1), -v(2, 0), (v(1, 0) - v(0, 1)) / 2);
  if (moves_no_water(x, centre) && moves_no_water(y, centre)) {
    slides_ = Slides::all;
    centre_H_ = centre;
    return;
  }
  // The horizontal axis about which the least water moves.
  const double angle = std::atan2(2 * least(0, 1), least(0, 0) - least(1, 1)) / 2 + M_PI / 2;
  const Eigen::Vector3d e(std::cos(angle), std::sin(angle), 0);
  const Eigen::Vector3d c = e.cross(v * e);
  if (!moves_no_water(e, c)) {
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    turns_water_ = !moves_no_water(z, z.cross(v * z));
    return;
  }
  slides_ = Slides::about_axis;
  axis_H_ = e;
  centre_H_ = c;
}

WaveFrame WaveFrameRule::at(const Eigen::Quaterniond& R_WB) const {
  const Eigen::Quaterniond turn = R_WB * R_HB_.conjugate();
  if (slides_ == Slides::none) return {.R_WH = turn};
  WaveFrame frame;
  if (slides_ == Slides::about_axis) {
    const Eigen::Vector3d e_W = turn * axis_H_;
    if (e_W.head<2>().norm() < kLeastLean) return {.R_WH = turn};
    frame.R_WH = Eigen::Quaterniond(Eigen::Matrix3d(axes_of(e_W) * axes_of(axis_H_).transpose()));
  }
  frame.origin = turn * centre_H_ - frame.R_WH * centre_H_;
  return frame;
}

}  // namespace hydro
