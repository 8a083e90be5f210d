#pragma once

#include <functional>

#include "hydro/added_mass/added_mass_model.h"
#include "hydro/mesh/mesh.h"
#include "hydro/radiation/radiation_memory.h"

namespace hydro {

/// The horizontal angle of the frame H of radiation_data.h, counter-clockwise from W's x axis, for
/// a body of this mean pose and orientation: that of the rotation about the vertical in the body's
/// rotation from its mean pose [rad].
double heading(const MeanPose& pose, const Eigen::Quaterniond& orientation);

/// A floating body as linear theory sees it: the added mass A∞ of its mean pose, the memory of the
/// waves that it makes, and the load of those that it scatters.
///
/// All three hold near the mean pose. They are the same in other poses, but vanish as the body
/// leaves the water: A∞ is multiplied by the body's presence w, and so is the diffraction; the
/// memory's port by √w, so that it stays passive however w changes.
class FloatingBody final : public AddedMassModel {
 public:
  /// The load of scattered waves, before its presence: W axes, moment about the centre of mass.
  using Diffraction = std::function<Wrench(const BodyState&, const Sea&, double time)>;

  /// @param mesh_B        Its origin the centre of mass.
  /// @param diffraction   Empty: none.
  /// @throws std::invalid_argument as fit_memory does.
  FloatingBody(TriMesh mesh_B, RadiationData data, Diffraction diffraction = {});
  /// @param memory   Fitted to the data before.
  FloatingBody(TriMesh mesh_B, RadiationData data, RadiationMemory memory, Diffraction diffraction);

  /// w [-]: 0 while every vertex is above the surface, 1 once one is deeper below it than a
  /// fiftieth of the draught of the mean pose or of the body's height, whichever is less, and
  /// smooth between. Evaluates the surface once as a rule, as the vertex that is the lowest one in
  /// the mean pose is looked at first.
  double presence(const BodyState& state, const Sea& sea, double time) const;

  /// w A∞.
  Matrix6d at(const BodyState& state, const Sea& sea, double time) const override;
  /// w times the diffraction.
  Wrench wave_load(const BodyState& state, const Sea& sea, double time) const override;

  const RadiationData& data() const { return data_; }
  const RadiationMemory& memory() const { return memory_; }

 private:
  RadiationData data_;
  RadiationMemory memory_;
  Diffraction diffraction_;
  Eigen::Matrix3Xd vertices_B_;  ///< The lowest one of the mean pose first.
  double depth_ = 0;             ///< Of full presence [m].
  Matrix6d added_B_;             ///< A∞ for ρ = 1.
};

}  // namespace hydro
