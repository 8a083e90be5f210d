#pragma once

#include <map>

#include "engine/base/spec.h"
#include "engine/contacts/broad_phase.h"

/// @file
/// Friction and restitution of each pair of bodies that touch.
///
/// A surface has a coefficient of friction µ and one of restitution e. A pair has
///
///     µ = √(µ₁ µ₂),    e = max(e₁, e₂),                                                  (E31)
///
/// so that equal surfaces have their own value, a smooth one makes every contact smooth, and a
/// ball bounces on a floor that says nothing about it. There is no law behind either: where a pair
/// was measured, SimulationSpec::contacts gives its values.

namespace engine {

/// Friction and restitution of a body's surface, or of a pair.
struct Surface {
  double friction = kFriction;  ///< Coulomb's µ [-], >= 0.
  double restitution = 0;       ///< [-], 0 … 1.
};

class ContactSurfaces {
 public:
  /// Every pair has the default surface.
  ContactSurfaces() = default;
  /// @throws std::invalid_argument for values out of bounds, an unknown body, a body with itself,
  /// or a pair that is given twice.
  explicit ContactSurfaces(const SimulationSpec& spec);

  /// (E31), or what the specification gives for the pair.
  Surface between(const Pair& pair) const;

 private:
  Surface of(BodyId body) const;

  Surface ground_;
  std::vector<Surface> bodies_;
  std::map<Pair, Surface> pairs_;  ///< Surfaces given for single pairs.
};

}  // namespace engine
