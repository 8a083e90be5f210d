#include "hydro/radiation/floating_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hydro/added_mass/wetted_added_mass.h"

namespace hydro {
namespace {

// Depth of full presence over the draught or the height [-]. A body that falls in from the surface
// gives its momentum to the whole A∞ there: at a fiftieth of the draught it has little.
constexpr double kFullPresence = 0.02;

/// A tensor in axes of B from one in other axes.
Matrix6d turned(const Eigen::Quaterniond& turn, const Matrix6d& matrix) {
  return WaveFrame{.R_WH = turn}.tensor_out(matrix);
}

}  // namespace

FloatingBody::FloatingBody(TriMesh mesh_B, RadiationData data, Diffraction diffraction,
                           Diffraction momentum)
    : FloatingBody(std::move(mesh_B), data, fit_memory(data), std::move(diffraction),
                   std::move(momentum)) {}

FloatingBody::FloatingBody(TriMesh mesh_B, RadiationData data, RadiationMemory memory,
                           Diffraction diffraction, Diffraction momentum)
    : data_(std::move(data)),
      memory_(std::move(memory)),
      diffraction_(std::move(diffraction)),
      momentum_(std::move(momentum)),
      vertices_B_(std::move(mesh_B.vertices)),
      added_H_(semi_definite_part(data_.infinite_added_mass)),
      frame_(data_.pose, vertices_B_, added_H_),
      added_B_(turned(data_.pose.orientation.conjugate(), added_H_)) {
  const Eigen::RowVectorXd z =
      (data_.pose.orientation.toRotationMatrix() * vertices_B_).row(2).array() + data_.pose.height;
  Eigen::Index lowest = 0;
  const double draught = -z.minCoeff(&lowest);
  vertices_B_.col(0).swap(vertices_B_.col(lowest));
  const double height = z.maxCoeff() - z.minCoeff();
  depth_ = kFullPresence * (draught > 0 ? std::min(draught, height) : height);
}

double FloatingBody::presence(const BodyState& state, const Sea& sea, double time) const {
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const SurfaceBounds bounds = surface_bounds(sea);
  double deepest = 0;
  for (const auto r_B : vertices_B_.colwise()) {
    const Eigen::Vector3d p = state.position + R_WB * r_B;
    if (p.z() >= bounds.highest - deepest) continue;
    deepest = std::max(deepest, surface_height(sea, p.x(), p.y(), time) - p.z());
    if (deepest >= depth_) return 1;
  }
  const double part = deepest / depth_;
  return part * part * (3 - 2 * part);
}

Matrix6d FloatingBody::at(const BodyState& state, const Sea& sea, double time) const {
  const double mass = presence(state, sea, time) * sea.density;
  if (slides() == WaveFrameRule::Slides::none || mass == 0) return mass * added_B_;
  return mass *
         turned(state.orientation.conjugate(), frame_.at(state.orientation).tensor_out(added_H_));
}

Wrench FloatingBody::present(const Diffraction& part, const BodyState& state, const Sea& sea,
                             double time) const {
  if (!part) return {};
  const double w = presence(state, sea, time);
  return w > 0 ? w * part(state, frame(state.orientation), sea, time) : Wrench{};
}

Wrench FloatingBody::wave_load(const BodyState& state, const Sea& sea, double time) const {
  BodyState of_frame = state;
  if (!turns_water()) of_frame.angular_velocity.setZero();
  return present(diffraction_, of_frame, sea, time);
}

Wrench FloatingBody::wave_momentum(const BodyState& state, const Sea& sea, double time) const {
  return present(momentum_, state, sea, time);
}

}  // namespace hydro
