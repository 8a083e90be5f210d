#pragma once

#include <functional>

#include "hydro/added_mass/added_mass_model.h"
#include "hydro/mesh/mesh.h"
#include "hydro/radiation/radiation_memory.h"
#include "hydro/radiation/wave_frame.h"

/// @file
/// A floating body as linear theory sees it.

namespace hydro {

/// A floating body as linear theory sees it: the added mass A∞ of its mean pose, the memory of the
/// waves that it makes, and the load of those that it scatters.
///
/// All three hold near the mean pose. In other poses they are the same in the frame H, which
/// follows the wetted shape (wave_frame.h), but vanish as the body leaves the water: A∞ is
/// multiplied by the body's presence w, and so is the diffraction; the memory's port by √w, so that
/// it stays passive however w changes.
class FloatingBody final : public AddedMassModel {
 public:
  /// The load of scattered waves or their momentum, before its presence: W axes, moment about the
  /// centre of mass. The state's velocity is that of H, which does not turn unless each turn moves
  /// water.
  using Diffraction =
      std::function<Wrench(const BodyState&, const WaveFrame&, const Sea&, double time)>;

  /// Makes a body from its data, and fits a memory to them.
  /// @param mesh_B        Its origin the centre of mass.
  /// @param diffraction   The load; empty: none.
  /// @param momentum      Momentum of the waves that exert it; empty: none.
  /// @throws std::invalid_argument as fit_memory does.
  FloatingBody(TriMesh mesh_B, RadiationData data, Diffraction diffraction = {},
               Diffraction momentum = {});
  /// Makes a body with a given memory.
  /// @param memory   Fitted to the data before.
  FloatingBody(TriMesh mesh_B, RadiationData data, RadiationMemory memory, Diffraction diffraction,
               Diffraction momentum);

  /// w [-]: 0 while every vertex is above the surface, 1 once one is deeper below it than a
  /// fiftieth of the draught of the mean pose or of the body's height, whichever is less, and
  /// smooth between. Evaluates the surface once as a rule, as the vertex that is the lowest one in
  /// the mean pose is looked at first.
  double presence(const BodyState& state, const Sea& sea, double time) const;

  /// w A∞.
  Matrix6d at(const BodyState& state, const Sea& sea, double time) const override;
  /// w times the diffraction.
  Wrench wave_load(const BodyState& state, const Sea& sea, double time) const override;

  /// w times the momentum of the scattered waves [N s, N m s].
  Wrench wave_momentum(const BodyState& state, const Sea& sea, double time) const;

  /// The frame H.
  WaveFrame frame(const Eigen::Quaterniond& R_WB) const { return frame_.at(R_WB); }
  /// How H follows the body.
  WaveFrameRule::Slides slides() const { return frame_.slides(); }
  /// True if each turn of the body moves water.
  bool turns_water() const { return frame_.turns_water(); }

  /// The data, in H for ρ = 1.
  const RadiationData& data() const { return data_; }
  /// The memory of the waves that the body makes.
  const RadiationMemory& memory() const { return memory_; }

 private:
  /// w times a part of the diffraction.
  Wrench present(const Diffraction& part, const BodyState& state, const Sea& sea,
                 double time) const;

  RadiationData data_;
  RadiationMemory memory_;
  Diffraction diffraction_;
  Diffraction momentum_;
  Eigen::Matrix3Xd vertices_B_;  ///< The lowest one of the mean pose first.
  double depth_ = 0;             ///< Depth of full presence [m].
  Matrix6d added_H_;             ///< A∞ for ρ = 1, positive semidefinite.
  WaveFrameRule frame_;
  Matrix6d added_B_;  ///< A∞ in the mean pose, and in all poses if H turns with the body.
};

}  // namespace hydro
