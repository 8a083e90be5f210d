#include "app/render/vertex_water.h"

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

}  // namespace render
