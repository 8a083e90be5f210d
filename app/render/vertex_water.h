#pragma once

#include <Eigen/Core>

#include "hydro/airy_waves.h"
#include "hydro/spatial.h"

namespace render {

/// The water at the vertices of a body, one column each.
struct VertexWater {
  Eigen::RowVectorXd depths;  ///< Depth below the surface [m].
  Eigen::RowVectorXd heads;   ///< p/(ρg) [m]; equal to the depth but under linear waves.
  Eigen::Matrix3Xd flow;      ///< Velocity relative to `Sea::current`, in W [m/s].
};

/// Above the surface the flow is that of the surface, so that both are linear over a triangle which
/// crosses it.
/// @param waves   Waves of the sea at this time.
VertexWater vertex_water(const hydro::Sea& sea, const hydro::AiryWaves& waves,
                         const Eigen::Matrix3Xd& points_W, double time);

/// Returns how much a body at the surface churns the water, from a little at rest to 1: by the mean
/// speed of its vertices through the water, over that of a deep-water wave twice as long as
/// `radius` [m], that of the body.
double churn(const VertexWater& water, const hydro::Sea& sea, const hydro::BodyState& state,
             const Eigen::Matrix3Xd& points_W, double radius);

}  // namespace render
