#pragma once

#include <limits>
#include <optional>

#include "engine/motion/acceleration_history.h"
#include "engine/motion/carried_water.h"
#include "engine/motion/suction.h"
#include "engine/motion/wave_memory.h"
#include "engine/motion/work_record.h"

/// @file
/// The changing side of a body: everything that one step leaves to the next. A motion is a value; a
/// copy of it restores the body.

namespace engine {

struct Motion {
  hydro::BodyState state;
  /// Velocity of the water about the body, constant for a substep, to which u is relative [m/s].
  /// The substep sets it.
  Eigen::Vector3d flow = Eigen::Vector3d::Zero();
  /// Angular momentum of propellers' spinning masses relative to the body, in B, constant for a
  /// substep [N m s]. The substep sets it.
  Eigen::Vector3d rotors_B = Eigen::Vector3d::Zero();
  /// How far the body has lately gone through the water, in W (hydro/loads/wake.h) [m, rad].
  Vector6d wake = Vector6d::Zero();
  // Motions are copied often, and most have no added mass.
  std::optional<Matrix6d> added_B;                    ///< A; none where it is zero.
  std::optional<WaveMemory> memory;                   ///< Only for a body that radiates waves.
  std::optional<WaterMemory> water;                   ///< Only for a hull in simulated water.
  std::shared_ptr<const CarriedWater> carried_water;  ///< Null: the body cannot have pockets.
  std::optional<Suction> suction;                     ///< Only on a bed that has any.
  AccelerationHistory accelerations;                  ///< Empty after contacts and other jumps.
  bool constrained = false;  ///< Joints or contacts acted in the last substep.
  /// Acceleration of the centre of mass by loads alone in the last constrained substep, in W
  /// [m/s^2]; none after a free substep.
  std::optional<Eigen::Vector3d> load_acceleration_W;
  /// Change of velocity a second by loads and reactions in the last substep, in W.
  Vector6d acceleration_W = Vector6d::Zero();
  /// Limit of the next substep by the last impact [s].
  double longest_after_impact = std::numeric_limits<double>::infinity();
  std::optional<WorkRecord> work;  ///< For a log of forces.

  /// A in B.
  const Matrix6d& added() const {
    static const Matrix6d none = Matrix6d::Zero();
    return added_B ? *added_B : none;
  }
};

}  // namespace engine
