#include "hydro/water/near_field.h"

#include "hydro/added_mass/bem/element.h"

namespace hydro {

NearFlow& NearFlow::operator+=(const NearFlow& other) {
  velocity += other.velocity;
  change += other.change;
  acceleration += other.acceleration;
  return *this;
}

NearFlow near_flow(const NearSources& sources, const Eigen::Vector3d& place) {
  NearFlow flow;
  for (Eigen::Index j = 0; j < sources.places.cols(); ++j) {
    const Eigen::Vector3d from = sources.places.col(j);
    const Eigen::Vector3d r = place - from;
    const Eigen::Vector3d image = place - Eigen::Vector3d(from.x(), from.y(), -from.z());
    const double inverse = 1 / r.norm(), mirrored = 1 / image.norm();
    const Eigen::Vector3d slope = bem::kPerSphere * (inverse * inverse * inverse * r -
                                                     mirrored * mirrored * mirrored * image);
    flow.velocity += sources.rates[j] * slope;
    flow.change -= sources.changes[j] * bem::kPerSphere * (inverse - mirrored);
    flow.acceleration += sources.changes[j] * slope;
  }
  return flow;
}

}  // namespace hydro
