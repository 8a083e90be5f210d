#pragma once

#include <Eigen/Core>

#include "hydro/spatial.h"

namespace engine {

/// The hold of a soft bed on a body that rests on it: (E41), contacts/bed_suction.h.
struct Suction {
  double bond = 0;                                         ///< b, 0 … 1 [-].
  double force = 0;                                        ///< F, constant for a step [N].
  Eigen::Vector3d place_B = Eigen::Vector3d::Zero();       ///< Centre of the footprint [m].
  Eigen::Vector3d into_bed_B = -Eigen::Vector3d::UnitZ();  ///< Unit.
};

/// The load of the suction on the body: moment about the centre of mass, in W.
hydro::Wrench wrench(const Suction& suction, const hydro::BodyState& state);

}  // namespace engine
