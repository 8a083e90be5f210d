#include "app/render/vertex_water.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {

VertexWater vertex_water(const hydro::Sea& sea, const hydro::AiryWaves& waves,
                         const Eigen::Matrix3Xd& points_W, double time) {
  const Eigen::Index count = points_W.cols();
  VertexWater water{Eigen::RowVectorXd(count), Eigen::RowVectorXd(count),
                    Eigen::Matrix3Xd(3, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d p_W = points_W.col(i);
    const double depth = hydro::surface_height(sea, p_W.x(), p_W.y(), time) - p_W.z();
    const hydro::WaterMotion motion = waves.at(p_W, depth);
    water.depths[i] = depth;
    water.heads[i] = motion.head;
    water.flow.col(i) = motion.velocity - sea.current;
  }
  return water;
}

double churn(const VertexWater& water, const hydro::Sea& sea, const hydro::BodyState& state,
             const Eigen::Matrix3Xd& points_W, double radius) {
  constexpr double kAtRest = 0.15;
  const Eigen::Vector3d& spin = state.angular_velocity;
  const Eigen::Vector3d drift = state.linear_velocity - sea.current - spin.cross(state.position);
  double sum = 0;
  for (Eigen::Index i = 0; i < points_W.cols(); ++i)
    sum += (drift + spin.cross(points_W.col(i)) - water.flow.col(i)).norm();
  const double mean = sum / static_cast<double>(std::max<Eigen::Index>(points_W.cols(), 1));
  const double wave_speed = std::sqrt(sea.gravity * radius / std::numbers::pi);
  return std::min(1.0, kAtRest + mean / wave_speed);
}

}  // namespace render
