#pragma once

#include <vector>

#include "engine/base/rig_readings.h"
#include "engine/machines/set_points.h"
#include "hydro/machines/propeller.h"

/// @file
/// The loads of propellers and foils on their bodies.
///
/// The water at a machine is that of waves and current at its point, undisturbed by bodies. With n
/// the unit axis, V = n·(v − u_water) and T, Q of hydro/machines/propeller.h at the disc's wetted
/// share, a propeller pushes its body with T n at its centre and turns it with ∓Q n, against the
/// turn of a right-handed screw, and with −I 2πs' n for its spinning mass, s being the speed [1/s].
/// The momentum I 2πs n of that is part of the drift (E1), which so has its gyroscopic moment. A
/// foil (hydro/machines/foil.h) feels the flow u − v at its point, in the fraction of its span that
/// is in its fluid; behind a propeller, the part of its span that the race covers feels the speed
/// of the race along the propeller's axis.

namespace engine {

class Machines {
 public:
  /// Both must outlive it. @throws std::invalid_argument for a machine out of its range.
  Machines(const SimulationSpec& spec, const SetPoints& set_points);

  bool drives(BodyId body) const { return !of_body_[body].empty(); }

  /// H of (E1): the angular momentum of a body's spinning masses relative to it, in B [N m s].
  Eigen::Vector3d rotors_B(BodyId body, double time) const;

  /// Load of all machines of a body: moment about the centre of mass, in W.
  hydro::Wrench load(BodyId body, const hydro::BodyState& state, double time) const;

  PropellerReading propeller(std::size_t index, const hydro::BodyState& state, double time) const;
  FoilReading foil(std::size_t index, const hydro::BodyState& state, double time) const;

 private:
  /// The water at one time.
  class Water;
  struct Screw;  ///< A propeller at an instant.
  struct OfBody {
    std::vector<std::size_t> propellers, foils;
    bool empty() const { return propellers.empty() && foils.empty(); }
  };

  Screw screw(std::size_t index, const hydro::BodyState& state, double time,
              const Water& water) const;
  FoilReading foil(std::size_t index, const hydro::BodyState& state, double time,
                   const Water& water) const;
  hydro::Wrench load(const Screw& screw, std::size_t index, double time) const;

  const SimulationSpec& spec_;
  const SetPoints& set_points_;
  std::vector<hydro::PropellerCurves> curves_;  ///< Per propeller.
  std::vector<OfBody> of_body_;
};

}  // namespace engine
