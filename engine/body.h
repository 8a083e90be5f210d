#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "engine/added_inertia.h"
#include "engine/faults.h"
#include "engine/guide.h"
#include "engine/kick_history.h"
#include "engine/ledger.h"
#include "engine/pull.h"
#include "engine/six.h"

/// @file
/// A body as the stepping sees it: what is constant, how it moves, what it remembers and what it
/// has cost.

namespace engine {

/// What surrounds the bodies. Constant.
struct Surroundings {
  double gravity = 0;               ///< [m/s^2]
  const hydro::Sea* sea = nullptr;  ///< Null: a dry scene.
  double highest = 0;               ///< Of the water surface, ever [m].
  double lowest = 0;                ///< Of the water surface, ever [m].

  Eigen::Vector3d current() const { return sea ? sea->current : Eigen::Vector3d::Zero(); }
};

/// Half the part of the greatest energy so far by which a body may come to have more than the
/// lowest so far.
inline constexpr double kEnergyGain = 2.5e-4;

/// Energies that a body has had [J].
struct EnergyRange {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  double lowest_potential = std::numeric_limits<double>::infinity();

  void extend(double energy, double potential) {
    lowest = std::min(lowest, energy);
    highest = std::max(highest, energy);
    lowest_potential = std::min(lowest_potential, potential);
  }
  /// @param floor   Least energy that the gain is measured by.
  double allowed_gain(double floor) const {
    return kEnergyGain * std::max(highest - lowest_potential, floor);
  }
};

/// How a body moves at an instant.
struct Motion {
  hydro::BodyState state;
  // Motions are copied often: what most of them do without is then no work.
  std::optional<Matrix6d> added_B;       ///< A, body axes; none where it is zero.
  std::optional<Matrix6d> added_rate_B;  ///< Its change a second in the last step; none: zero.
  KickHistory kicks;                     ///< Empty if they say nothing about the next one.
  EnergyRange energy;                    ///< Where still water must not give any.
  bool constrained = false;              ///< The last kick was under joints or contacts.
  std::optional<Ledger> ledger;          ///< Where the scene asks for a log of forces.

  /// A, body axes.
  Matrix6d added() const { return added_B.value_or(Matrix6d::Zero()); }
};

/// What a body has cost.
struct Cost {
  long free_steps = 0;         ///< Steps moved by itself.
  long constrained_steps = 0;  ///< Steps moved under joints or contacts.
  long substeps = 0;           ///< Pieces that those steps were cut in, in all.
  long implicit = 0;           ///< Pieces whose loads were taken implicitly.
  long iterations = 0;         ///< Solutions of its constraints for its added mass.
  long unconverged = 0;        ///< Pieces in which those did not reach their tolerance.
  long braked = 0;             ///< Pieces slowed so that the water gives no energy.
  long dry = 0;                ///< Evaluations above the highest water.
  long resting = 0;            ///< Evaluations that took over the last loads.
  long evaluations = 0;        ///< Of its loads, the former two included.
  double load_seconds = 0;     ///< Wall time of them [s].
};

struct Body {
  const BodySpec* spec = nullptr;
  std::shared_ptr<const hydro::Hull> hull;  ///< None if not wet; one for all of the same mesh.
  Eigen::AlignedBox3d box_B;
  double radius = 0;                        ///< Of its farthest vertex from the centre of mass [m].
  double displacement = 0;                  ///< Mass of the water that it can displace [kg].
  Matrix6d rigid_B = Matrix6d::Identity();  ///< M about the centre of mass, body axes.
  Eigen::Matrix3d inverse_inertia_B = Eigen::Matrix3d::Identity();
  bool wet = false;      ///< The water has loads on it.
  bool adds = false;     ///< It has added mass.
  bool movable = true;   ///< Not all of it is locked.
  bool locked = false;   ///< Some of it is.
  bool jointed = false;  ///< A joint holds it.
  std::optional<Guide> guide;
  std::optional<Pull> pull;  ///< None as a rule.

  Motion motion;
  BodyLoads loads;  ///< Of the last evaluation.
  /// In which the water's loads were found; none for a look above the surface.
  std::optional<hydro::BodyState> loaded_state;
  Vector6d reaction_B = Vector6d::Zero();  ///< Of the last constraints, body axes.
  /// Of the centre of mass without constraints, in W, when it was last under them [m/s^2].
  std::optional<Eigen::Vector3d> acceleration_W;
  /// Longest piece that its last impact leaves [s].
  double after_impact = std::numeric_limits<double>::infinity();
  Cost cost;
};

Surroundings surroundings(const SimulationSpec& spec);

/// A body at its initial state.
Body make_body(const SimulationSpec& spec, std::size_t index);
/// All of them: those of the same mesh share its hull.
std::vector<Body> make_bodies(const SimulationSpec& spec);

/// True for a body that can move; not for kWorld.
inline bool moves(const std::vector<Body>& bodies, BodyId id) {
  return id != kWorld && bodies[static_cast<std::size_t>(id)].movable;
}

/// How it may go by itself, in W.
Freedom freedom(const Body& body, const hydro::BodyState& state);

/// What contacts push against: a mass no less than M + A in any direction [kg].
double contact_mass(const Body& body, const Motion& motion);

/// What its weight and the water's lift can speed that mass up with, as a part of gravity; at most
/// 1.
double contact_fall(const Body& body, const Motion& motion);

/// M + A in W.
/// @param R_WB   Of the motion's state.
Matrix6d inertia_W(const Body& body, const Motion& motion, const Eigen::Matrix3d& R_WB);
Matrix6d inertia_W(const Body& body, const Motion& motion);

/// Where added mass and loads leave the body after `time` [s] without loads.
hydro::BodyState state_after_drift(const Body& body, const Surroundings& around,
                                   const Motion& motion, double time);

/// Moves on to there.
void drift(const Body& body, const Surroundings& around, Motion& motion, double time);

/// The state moved on by (Δx, Δθ) in W, its velocity as it was.
hydro::BodyState displaced(const Body& body, hydro::BodyState state, const Vector6d& change);

/// A of the body in a state, body axes.
Matrix6d added_mass(const Body& body, const Surroundings& around, const hydro::BodyState& state,
                    double time);

/// Gives the motion the added mass `added_B` after a step.
void set_added_mass(Motion& motion, const Matrix6d& added_B, double step);

/// A as it will be after the step: as it changed in the last one.
Matrix6d expected_added_mass(const Body& body, const Motion& motion, double step);

/// Passes of a step until the added mass at its end is the one it was taken with, at most.
inline constexpr int kMostPasses = 3;
/// True if two added masses differ by no more than matters to the step.
bool same_added_mass(const Body& body, const Matrix6d& a, const Matrix6d& b);

/// True if one more pass with the added mass `found_B` of the pose that `taken_B` has led to, from
/// `start_B`, leaves no difference that matters to the energy.
bool nearly_met(const Body& body, const Matrix6d& start_B, const Matrix6d& taken_B,
                const Matrix6d& found_B);
/// The motion with the added mass of its pose where passes have not met that, as when a body comes
/// to the water: what it gains shares the momentum (added_inertia.h).
Motion settled(const Body& body, const Surroundings& around, const Motion& before,
               const Matrix6d& added_B);

/// Of the hand that draws it, in a state; only where one does.
hydro::Wrench pull_on(const Body& body, const hydro::BodyState& state);

/// All loads on the body in a state, its weight included.
/// Kept in body.loads.
/// @throws MotionFault if they are not finite.
hydro::Wrench find_loads(Body& body, const Surroundings& around, const hydro::BodyState& state,
                         double time);

/// A load or state of a body that is not finite or beyond all bounds, in words.
class MotionFault : public std::runtime_error {
 public:
  MotionFault(const Body& body, const std::string& what)
      : std::runtime_error(what), body_(body.spec->name) {}
  const std::string& body() const { return body_; }

 private:
  std::string body_;
};

/// @throws MotionFault if the state is out of bounds, naming the largest load.
void check_state(const Body& body, const hydro::BodyState& state);

}  // namespace engine
