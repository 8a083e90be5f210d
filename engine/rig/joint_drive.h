#pragma once

#include <optional>
#include <vector>

#include "engine/constraints/force_row.h"
#include "engine/machines/set_points.h"

/// @file
/// The coordinate of a hinge or slider, and what acts along it.
///
/// With the turns Q of both bodies since the start and e the axis in the first body, q of a hinge
/// is the twist of Q₁⁻¹ Q₂ about e, in (−π, π], and q of a slider the displacement of the second
/// body along Q₁ e; q' is e·(ω₂ − ω₁), or e·(v₂ − v₁ − ω₁ × (x₂ − x₁)). Torques act on both
/// bodies, forces on both at the place of the second.
///
/// A stop holds q' where it must not go on, and takes what q is beyond it back in the next substep.
/// A motor of mode `speed` holds q' at its set point; one of mode `position` is a spring and damper
/// k = ω² m, c = 2 ω m with ω its rate and m the mass or moment of inertia that it moves, so it
/// reaches its set point without overshoot; friction holds q' at 0. The forces of these are found
/// with those of the joints (force_row.h), and none exceeds its largest value.

namespace engine {

/// The two bodies of a joint: their states, or none for the world.
struct JointBodies {
  const hydro::BodyState* first = nullptr;
  const hydro::BodyState* second = nullptr;
};

/// The coordinate of a joint, of a hinge or slider, and its place, of any.
class JointCoordinate {
 public:
  JointCoordinate(const JointSpec& joint, const JointBodies& initial);

  double value(const JointBodies& now) const;
  double rate(const JointBodies& now) const;
  /// e, in W.
  Eigen::Vector3d axis_W(const JointBodies& now) const;
  /// The anchor or, of a slider or fixed joint, the place of the second body, or of the first one
  /// if the second is the world [m].
  Eigen::Vector3d place_W(const JointBodies& now) const;
  bool turns() const { return turns_; }

 private:
  Eigen::Quaterniond turn(const hydro::BodyState* now, const hydro::BodyState& start) const;
  bool turns_, anchored_;
  hydro::BodyState first_, second_;  ///< At the start; the world: at rest in the origin.
  Eigen::Vector3d axis_, anchor_;    ///< At the start.
};

/// True if what acts along q needs the constraint solver.
/// @param stiff   Spring and damper are too stiff to be loads (`Rig`).
bool needs_rows(const JointDrive& drive, bool stiff);

/// The effort along q that is a load: that of an effort motor, and of spring and damper unless they
/// are stiff.
double drive_load(const JointDrive& drive, const SetPoints& set_points, double time, double q,
                  double rate, bool stiff);

/// The mean over the last step of the effort of an effort motor; 0 without one.
double motor_load(const JointDrive& drive, const SetPoints& set_points);

/// The quantities that the rows of a drive depend on.
struct DriveState {
  double q = 0, rate = 0;  ///< Halfway through the substep, before the update.
  double inertia = 1;      ///< Inertia that the drive moves [kg m^2, kg].
  double step = 0;         ///< The scene's [s].
  bool stiff = false;
};

/// The rows of a drive for a substep, without bodies and place.
std::vector<ForceRow> drive_rows(const JointDrive& drive, const SetPoints& set_points, double time,
                                 double h, const DriveState& state, bool turns);

}  // namespace engine
