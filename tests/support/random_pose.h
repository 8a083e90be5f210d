#pragma once

#include <Eigen/Geometry>
#include <random>

#include "hydro/spatial.h"

namespace support {

/// Random numbers of a test with a fixed seed and no global state.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double uniform(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(engine_);
  }
  Eigen::Vector3d vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  /// Returns a unit quaternion, uniformly distributed over the rotations.
  Eigen::Quaterniond rotation() {
    std::normal_distribution<double> normal;
    Eigen::Vector4d q(normal(engine_), normal(engine_), normal(engine_), normal(engine_));
    q.normalize();
    return Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  }
  /// Returns a symmetric matrix with random axes and eigenvalues from 0.1 to 1: a K of bluntness.h.
  Eigen::Matrix3d drag_shape() {
    const Eigen::Matrix3d axes = rotation().toRotationMatrix();
    const Eigen::Vector3d share(uniform(0.1, 1), uniform(0.1, 1), uniform(0.1, 1));
    return axes * share.asDiagonal() * axes.transpose();
  }
  /// Returns a state with coordinates up to `distance` and velocities up to `speed`.
  hydro::BodyState state(double distance, double speed) {
    return {.position = vector(distance),
            .orientation = rotation(),
            .linear_velocity = vector(speed),
            .angular_velocity = vector(speed)};
  }

 private:
  std::mt19937 engine_;
};

}  // namespace support
