#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/body.h"
#include "engine/simulation.h"
#include "engine/world.h"
#include "tests/stress/scenario.h"

/// @file
/// What may not happen in a run.
///
/// With E(t) = K + U the energy of all bodies, their added mass included, and U their potential
/// energy (gravity, buoyancy, a constant push), in still water without lift
///
///     rise(t)  = E(t) − min E(s) − max C(s)  over s <= t,
///     scale(t) = max E(s) − min U(s)  over s <= t                                           (1)
///
/// and the run fails if rise > kLargestRise · scale at any step. The scale does not depend on where
/// U is zero; it is no more than the greatest energy so far above the lowest place that can be
/// reached. C is the weight of all bodies and their displaced water times the deepest overlap of
/// any two for each body: contacts are soft (engine/contacts.h), and push what has sunk into them
/// out again. Energy that was lost and comes back is a rise, also if it stays below what it was at
/// the start.
///
/// No body may get farther than its energy can carry it. The water can give it
/// W = ρ g V (depth of its start below the highest water + size) by lifting it, gravity m g times
/// how far it sank, a push F·x; and a wave that runs with speed c at most that in the frame in
/// which it stands still. So with q the speed of its initial energy 2E_0/m,
///
///     v = c + √((q + c)² + 2 (W + m g sunk + F·x)/m)                                        (2)
///
/// bounds its speed, v t + size its way along the water and v²/2g + size its height above it.

namespace stress {

inline constexpr double kLargestRise = 1e-3;  ///< Of the greatest energy so far.
/// Least scale of (1), of the weight and the largest buoyancy times size: E has round-off in it.
inline constexpr double kSmallestScale = 1e-9;
/// Most substeps of a body in a step. Its own movement asks for 64 at most
/// (engine::kMostSubsteps); the rest is left for energy that halving must keep from rising.
inline constexpr long kMostSubsteps = 1024;
/// Most solutions of its constraints in a step: 60 for each of those 64 substeps.
inline constexpr long kMostSolutions = 3840;

/// Follows a simulation from its initial state.
class Watch {
 public:
  explicit Watch(const Scenario& scenario);

  /// To be called after every step. @returns what is wrong, if anything is.
  std::optional<std::string> look(const engine::Simulation& simulation);

  double energy() const { return energy_; }          ///< E [J]; 0 where it is not judged.
  double worst_rise() const { return worst_rise_; }  ///< Largest rise/scale so far.
  long most_substeps() const { return most_substeps_; }
  long most_solutions() const { return most_solutions_; }

 private:
  struct Energy {
    double kinetic = 0;
    double potential = 0;
    double overlap = 0;  ///< C
    double total() const { return kinetic + potential; }
  };
  Energy find_energy(const std::vector<hydro::BodyState>& states);
  double overlap_energy(const std::vector<engine::Motion>& motions);
  void follow_energy(const Energy& energy);
  double greatest_speed(std::size_t body, const hydro::BodyState& state) const;
  std::optional<std::string> left(const engine::Simulation& simulation) const;
  std::optional<std::string> stalled(const engine::Simulation& simulation);

  Scenario scenario_;  ///< What the bodies below refer to.
  engine::Environment environment_;
  std::vector<engine::Body> bodies_;
  engine::World world_;                   ///< Finds the contacts of what was simulated.
  std::vector<double> initial_energies_;  ///< Kinetic, of each body [J].
  double lowest_ = 0, highest_ = 0, lowest_potential_ = 0;
  double smallest_scale_ = 0;
  double weight_ = 0;   ///< Of all bodies and the water that they can displace [N].
  double overlap_ = 0;  ///< Greatest C so far [J].
  double energy_ = 0;
  double worst_rise_ = 0;
  long most_substeps_ = 0, most_solutions_ = 0;
  std::vector<engine::Counts> counts_;  ///< After the step before.
};

}  // namespace stress
