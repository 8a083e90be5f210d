#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/contacts/world.h"
#include "engine/motion/body.h"
#include "engine/simulation.h"
#include "tests/stress/scenario.h"

/// @file
/// Criteria by which a run fails. Of a run outside the operating envelope only that its states are
/// finite and its work is bounded is asked.
///
/// Let E = K + U be the energy of all bodies, K their kinetic energy with added mass and that in
/// the memory of their waves, and U their potential energy (gravity, buoyancy, a constant push).
/// In still water without lift
///
///     rise(t)  = E(t) − min E(s) − max C(s)  over s <= t,
///     scale(t) = max E(s) − min U(s)  over s <= t                                           (1)
///
/// and the run fails if rise > kLargestRise · scale at any step. The scale does not depend on the
/// zero of U; it is at most the largest energy so far relative to the lowest reachable position. C
/// is, summed over the bodies, the weight of all bodies and their displaced water times the deepest
/// overlap of any two: contacts push overlapping bodies apart (engine/contacts/contacts.h). Energy
/// that was lost and returns counts as a rise, even if it stays below its initial value. Lines may
/// give back what they have taken, and no more than ½ k e² of their stretch e. The state that is
/// reported lies (h²/24) a off the one that is moved on (engine/motion/processing_correction.h),
/// and may be dry where that touches the water: K is found with the added mass of the pose and with
/// that of the last substep, and is the less of the two. With L the sum of the lines' energies and
/// of the differences of the two, E(t) is counted as min(E + L, min E(s) over s < t) where E is
/// less than that.
///
/// No body may move farther than its energy allows. By lifting a body the water can add at most W =
/// ρ g V (depth of its start below the highest water + size), gravity adds m g times the depth
/// sunk, a push F·x, and a wave of speed c no more than these in the frame in which it is steady.
/// With the initial kinetic energy E_0 and q = √(2E_0/m), the speed
///
///     v = c + √((q + c)² + 2 (W + m g sunk + F·x)/m)                                        (2)
///
/// bounds the body's speed, v t + size its horizontal displacement and v²/2g + size its height
/// above the water.

namespace stress {

inline constexpr double kLargestRise = 1e-3;  ///< Limit of rise/scale in (1).
/// Smallest scale in (1), relative to (weight + largest buoyancy) · size, because of round-off in
/// E.
inline constexpr double kSmallestScale = 1e-9;
/// Largest number of substeps of a body in a step. Its motion needs at most 64
/// (engine::kMostSubsteps); the energy limiter may halve them further, and a fast spinning body
/// beside a wall is cut at what it passes: a teapot of 1 mm at 300 m/s takes 1,650.
inline constexpr long kMostSubsteps = 2048;
/// Largest number of sweeps over its constraints in a step: those of two updates of six
/// linearisations, of 120 sweeps each, for each of those 64 substeps.
inline constexpr long kMostSweeps = 92160;

/// Follows a simulation from its initial state.
class Watch {
 public:
  explicit Watch(const Scenario& scenario);

  /// Checks the state after a step; must be called after every step. @returns the fault, if there
  /// is one.
  std::optional<std::string> look(const engine::Simulation& simulation);

  double energy() const { return energy_; }          ///< E with lines [J]; 0 if not judged.
  double worst_rise() const { return worst_rise_; }  ///< Largest rise/scale so far.
  long most_substeps() const { return most_substeps_; }
  long most_sweeps() const { return most_sweeps_; }

 private:
  struct Energy {
    double kinetic = 0;
    double potential = 0;
    double unseen = 0;   ///< L
    double overlap = 0;  ///< C
    double total() const { return kinetic + potential; }
  };
  bool judges_energy() const { return scenario_.inside && scenario_.passive; }
  Energy find_energy(const std::vector<engine::Motion>& motions);
  double overlap_energy(const std::vector<engine::Motion>& motions);
  void follow_energy(const Energy& energy);
  double greatest_speed(std::size_t body, const hydro::BodyState& state) const;
  std::optional<std::string> left(const engine::Simulation& simulation) const;
  std::optional<std::string> stalled(const engine::Simulation& simulation);

  Scenario scenario_;  ///< The bodies below refer to it.
  engine::Environment environment_;
  std::vector<engine::Body> bodies_;
  engine::World world_;                   ///< Finds the contacts of the simulated bodies.
  std::vector<double> initial_energies_;  ///< Initial kinetic energy of each body [J].
  double lowest_ = 0, highest_ = 0, lowest_potential_ = 0;
  double smallest_scale_ = 0;
  double weight_ = 0;   ///< Weight of all bodies and the water that they can displace [N].
  double overlap_ = 0;  ///< Largest C so far [J].
  double energy_ = 0;
  double worst_rise_ = 0;
  long most_substeps_ = 0, most_sweeps_ = 0;
  std::vector<engine::Counts> counts_;  ///< Counts after the previous step.
};

}  // namespace stress
