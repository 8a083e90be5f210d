#include <array>

#include "app/scene/key_meanings.h"

/// @file
/// The meaning of the keys of joints, lines, machines, controls and applied loads; see
/// key_meanings.cpp.

namespace scene {
namespace {

constexpr auto kRigMeanings = std::to_array<Meaning>({
    {"bodies[].forces", "Loads in addition to those of water and gravity."},
    {"bodies[].forces[].force", "Force."},
    {"bodies[].forces[].torque", "Torque."},
    {"bodies[].forces[].frame",
     "Axes of `force` and `torque`. With `body` they turn with the body."},
    {"bodies[].forces[].at",
     "Point at which the force acts, in the mesh frame. The default is the centre of mass."},
    {"bodies[].forces[].start", "Time at which the load begins."},
    {"bodies[].forces[].end",
     "Time at which the load ends, not before `start`. Without this key it does not end."},
    {"bodies[].forces[].sine",
     "Modulation: the load is multiplied by sin(2π·frequency·t + phase)."},
    {"bodies[].forces[].sine.frequency_hz", "Frequency."},
    {"bodies[].forces[].sine.phase_deg", "Phase at time 0."},
    {"bodies[].forces[].factor",
     "Factor of the load. With this key, or with a control of it, the set point "
     "`bodies[NAME].forces[0].factor` multiplies the load, NAME and 0 standing for the body's name "
     "and the load's index. At most one of `factor`, `formula` and `file` is allowed."},
    {"bodies[].forces[].formula",
     "Formula in the time t that multiplies the load ([below](#formulas)). At most one of `sine`, "
     "`formula` and `file` is allowed."},
    {"bodies[].forces[].file",
     "Table over time that multiplies the load, as that of a control ([below](#controls))."},
    {"bodies[].forces[].column", "Column of `file`. The default is the first beside `time`."},
    {"bodies[].forces[].interpolation",
     "Value between the rows of `file`: on a line between them, or with `step` that of the row "
     "before."},
    {"joints[].name",
     "Name of the joint in logs and controls. The default is `joint` and its index, counted from "
     "0. "
     "It must not contain a comma, a double quote or a control character."},
    {"joints[].type",
     "Type of the joint. A ball joint leaves all rotations free, a hinge the rotation about one "
     "axis, a slider the translation along one axis, a fixed joint nothing, and a universal "
     "joint the rotations about two axes."},
    {"joints[].bodies", "The two bodies that the joint connects."},
    {"joints[].anchor",
     "A point of the joint in the world at time 0. Required for ball, hinge and universal "
     "joints; it has no effect on a slider or fixed joint."},
    {"joints[].axis",
     "Direction in the world at time 0. Required for hinge, slider and universal joints, not "
     "allowed for the others."},
    {"joints[].axis2",
     "Second axis of a universal joint, perpendicular to `axis`. The default is some "
     "perpendicular direction."},
    {"joints[].limits_deg",
     "Least and largest angle of a hinge, relative to that at time 0. Stops hold the joint within "
     "them. The angle grows as the second body turns about `axis` relative to the first, or to the "
     "world."},
    {"joints[].limits",
     "Least and largest position of a slider, relative to that at time 0. It grows as the second "
     "body moves along `axis` relative to the first, or to the world."},
    {"joints[].motor",
     "Motor of a hinge or slider, driven by exactly one of `speed`, `angle_deg` or `position`, and "
     "`torque` or `force`. Its value is the first one of the set point `joints[NAME].motor.KEY`."},
    {"joints[].motor.speed", "Speed that the motor keeps, [rad/s] of a hinge, [m/s] of a slider."},
    {"joints[].motor.angle_deg", "Angle of a hinge that the motor moves to and holds."},
    {"joints[].motor.position", "Position of a slider that the motor moves to and holds."},
    {"joints[].motor.torque", "Torque of the motor of a hinge on the second body."},
    {"joints[].motor.force", "Force of the motor of a slider on the second body."},
    {"joints[].motor.max_torque",
     "Largest torque of the motor of a hinge. Without this key it is not limited."},
    {"joints[].motor.max_force",
     "Largest force of the motor of a slider. Without this key it is not limited."},
    {"joints[].motor.rate",
     "Rate at which an error of `angle_deg` or `position` decays, with critical damping. A steady "
     "load L leaves an error of L/(m·rate²), m being the mass or moment of inertia that the motor "
     "moves, with its added mass; a `pid` with `ki` leaves none."},
    {"joints[].stiffness",
     "Stiffness of a spring along the coordinate, [N m/rad] of a hinge, [N/m] of a slider."},
    {"joints[].rest_deg", "Angle of a hinge at which its spring is at rest."},
    {"joints[].rest", "Position of a slider at which its spring is at rest."},
    {"joints[].damping",
     "Damping along the coordinate, [N m s/rad] of a hinge, [N s/m] of a slider."},
    {"joints[].friction",
     "Coulomb's friction against the motion, the same at any speed, [N m] of a hinge, [N] of a "
     "slider."},
    {"springs[].name",
     "Name of the spring in logs and controls, unique among the springs. It must not contain a"
     " comma, a double quote, a bracket or a control character."},
    {"springs[].bodies", "The two bodies at its ends."},
    {"springs[].points",
     "Its ends, each in the mesh frame of its body, or in the world for `world`."},
    {"springs[].length",
     "Length without tension. The default is the distance of the ends at time 0. The set point"
     " `springs[NAME].length` changes it."},
    {"springs[].stiffness", "Tension per stretch."},
    {"springs[].damping", "Tension per speed of stretching."},
    {"springs[].breaks_at",
     "Tension at which it breaks for good. Without this key it does not break."},
    {"ropes[].name",
     "Name of the rope in logs and controls, unique among the ropes. It must not contain a "
     "comma, a double quote, a bracket or a control character."},
    {"ropes[].bodies", "The two bodies at its ends."},
    {"ropes[].points",
     "Its ends, each in the mesh frame of its body, or in the world for `world`."},
    {"ropes[].length",
     "Length without tension. The default is the distance of the ends at time 0. The set point"
     " `ropes[NAME].length` changes it. A control drives either this or the rate of the winch."},
    {"ropes[].stiffness",
     "Tension per stretch: EA over the length for a rope of the stiffness EA."},
    {"ropes[].damping", "Tension per speed of stretching. A rope never pushes."},
    {"ropes[].breaks_at",
     "Tension at which it breaks for good. Without this key it does not break."},
    {"ropes[].rate",
     "Speed at which a winch pays out rope; a negative one hauls in. It is the first value of "
     "the set point `ropes[NAME].rate`."},
    {"ropes[].shortest", "Least length to which the winch hauls in."},
    {"ropes[].weight",
     "Weight per length in water; a negative one floats. The rope then [has "
     "inertia](#lines-with-inertia), hangs and lies on a flat bottom. Without this key it is "
     "straight, without weight."},
    {"ropes[].mass",
     "Mass per length in air. The default follows from the weight and what the `diameter` of its "
     "drag displaces."},
    {"ropes[].segments", "Straight parts into which it is divided."},
    {"ropes[].drag", "What the water does to its motion. Without this block it does nothing."},
    {"ropes[].drag.diameter", "Diameter of the rope."},
    {"ropes[].drag.coefficient", "Drag coefficient across the rope."},
    {"ropes[].drag.along",
     "Drag coefficient along the rope, of its surface; 0.05 without this key."},
    {"ropes[].drag.added_mass",
     "Added mass across the rope over the mass of the water that it displaces; 1 without this "
     "key."},
    {"moorings[].name",
     "Name of the mooring in logs and controls, unique among the moorings. It must not contain"
     " a comma, a double quote, a bracket or a control character."},
    {"moorings[].body", "Body that is moored."},
    {"moorings[].fairlead", "Upper end of the line, in the mesh frame of the body."},
    {"moorings[].anchor",
     "Anchor in the world. With `bottom: true` it lies on the ground `z`, or else at "
     "`water.depth`, where the scene has one of these."},
    {"moorings[].length", "Length without tension."},
    {"moorings[].weight", "Weight per length in water."},
    {"moorings[].stiffness", "Axial stiffness EA of the line."},
    {"moorings[].friction", "Coefficient of friction of the line on the bottom."},
    {"moorings[].bottom",
     "Whether a flat bottom at the height of the anchor carries the line. With `false` it "
     "hangs free between its ends."},
    {"moorings[].drag",
     "Drag of the water on the line, of which half acts at the fairlead of a `static` one. Without "
     "this block there is none."},
    {"moorings[].drag.diameter", "Diameter of the line for its drag."},
    {"moorings[].drag.coefficient", "Drag coefficient across the line."},
    {"moorings[].drag.along",
     "Drag coefficient along a `dynamic` line, of its surface; 0.05 without this key."},
    {"moorings[].drag.added_mass",
     "Added mass across a `dynamic` line over the mass of the water that it displaces; 1 without "
     "this key."},
    {"moorings[].model",
     "`static`: the line is an elastic catenary at rest at every instant. `dynamic`: it [has "
     "inertia](#lines-with-inertia)."},
    {"moorings[].segments", "Straight parts into which a `dynamic` line is divided."},
    {"moorings[].mass",
     "Mass per length of a `dynamic` line in air. The default follows from the weight and what the "
     "`diameter` of its drag displaces."},
    {"moorings[].breaks_at",
     "Tension at the fairlead at which the line breaks for good. Without this key it does not "
     "break."},
    {"moorings.moordyn",
     "Input file for MoorDyn, whose lines become [lines with inertia](#files-for-moordyn)."},
    {"moorings.bodies",
     "The bodies that carry the coupled points of the file, one for each of them in its order, or "
     "one for all."},
    {"propellers[].name",
     "Name of the propeller in logs and controls, unique among the propellers. It must not "
     "contain a comma, a double quote, a bracket or a control character."},
    {"propellers[].body", "Body that it drives."},
    {"propellers[].at", "Centre of its disc, in the mesh frame of the body."},
    {"propellers[].axis",
     "Direction ahead in the mesh frame: thrust pushes the body along it. A tunnel thruster "
     "has `[0, 1, 0]`."},
    {"propellers[].diameter", "Diameter."},
    {"propellers[].model",
     "Characteristics, given by exactly one of `wageningen`, `open_water` and `four_quadrant`."
     " Required."},
    {"propellers[].model.wageningen", "A screw of the Wageningen B-series."},
    {"propellers[].model.wageningen.blades", "Number of blades Z."},
    {"propellers[].model.wageningen.area_ratio",
     "Expanded blade area over the area of the disc, A_E/A_0."},
    {"propellers[].model.wageningen.pitch_ratio", "Pitch over diameter, P/D."},
    {"propellers[].model.open_water",
     "Measured open-water curves, linear between the rows. In the last interval the thrust "
     "must fall; beyond it the curves go on along its line until the thrust is 0."},
    {"propellers[].model.open_water.advance",
     "Advance ratios J = V_a/(nD), rising from 0 or less."},
    {"propellers[].model.open_water.kt", "Thrust coefficients K_T = T/(ρn²D⁴)."},
    {"propellers[].model.open_water.kq", "Torque coefficients K_Q = Q/(ρn²D⁵)."},
    {"propellers[].model.open_water.area_ratio",
     "Blade area over the area of the disc, for the resistance of a stopped screw."},
    {"propellers[].model.four_quadrant",
     "Measured curves of all four quadrants, linear between the rows and periodic."},
    {"propellers[].model.four_quadrant.beta_deg",
     "Angles β = atan2(V_a, 0.7π n D), rising from −180 to 180."},
    {"propellers[].model.four_quadrant.ct",
     "Thrust coefficients C_T* = T/(½ρ(V_a² + (0.7πnD)²)(πD²/4))."},
    {"propellers[].model.four_quadrant.cq",
     "Torque coefficients C_Q* = Q/(½ρ(V_a² + (0.7πnD)²)(πD³/4))."},
    {"propellers[].speed_rps",
     "Rate of revolution, positive ahead. It is the first value of the set point "
     "`propellers[NAME].speed_rps`."},
    {"propellers[].wake", "Wake fraction w: water arrives with the speed V_a = (1 − w)V."},
    {"propellers[].deduction", "Thrust deduction t: the body gets (1 − t)T."},
    {"propellers[].rotative_efficiency",
     "Relative rotative efficiency η_R: the torque is that in open water over η_R."},
    {"propellers[].reverse",
     "Thrust at rest astern over that ahead, for `wageningen` and `open_water`."},
    {"propellers[].hand",
     "A `right`-handed propeller turns clockwise, as seen from behind, when it drives ahead."},
    {"propellers[].azimuth_deg",
     "Angle by which the propeller is turned about `pivot`. It is the first value of the set "
     "point `propellers[NAME].azimuth_deg`."},
    {"propellers[].pivot", "Axis of the azimuth in the mesh frame."},
    {"propellers[].inertia",
     "Moment of inertia of screw and shaft about the axis, for their gyroscopic torque."},
    {"rudders[].name",
     "Name in logs and controls, unique among the rudders and sails. It must not contain a "
     "comma, a double quote, a bracket or a control character."},
    {"rudders[].body", "Body that carries it."},
    {"rudders[].at", "Point where its force acts, in the mesh frame of the body."},
    {"rudders[].span", "Length along `axis`."},
    {"rudders[].chord", "Length along `chord_axis`."},
    {"rudders[].axis",
     "Direction of the span in the mesh frame; `angle_deg` turns the foil about it. A keel or "
     "rudder has `[0, 0, 1]`, a fin out to port `[0, 1, 0]`."},
    {"rudders[].chord_axis",
     "Direction from the trailing to the leading edge at the angle 0, in the mesh frame, "
     "perpendicular to `axis`."},
    {"rudders[].angle_deg",
     "Angle about `axis`. It is the first value of the set point `rudders[NAME].angle_deg`, or"
     " `sails[NAME].angle_deg`."},
    {"rudders[].law",
     "Law of the lift: slopes by Whicker and Fehlner, Söding, or Fujii, or with `table` "
     "measured coefficients."},
    {"rudders[].aspect_ratio",
     "Effective aspect ratio Λ. The default is span over chord; next to a hull it is up to "
     "twice that."},
    {"rudders[].drag", "Drag coefficient C_D0 without lift."},
    {"rudders[].stall_deg", "Angle of attack at which the flow separates."},
    {"rudders[].table",
     "Coefficients over the angle of attack for `law: table`, linear between the rows. A table"
     " that starts at 0 is that of a symmetric foil."},
    {"rudders[].table.angle_deg", "Angles of attack, rising."},
    {"rudders[].table.lift", "Lift coefficients C_L."},
    {"rudders[].table.drag", "Drag coefficients C_D."},
    {"rudders[].behind", "Name of a propeller of the same body, in whose race the rudder is."},
    {"controls[].set",
     "Set point that it drives, `propellers[main].speed_rps` for example ([below](#controls))."
     " A set point has at most one control."},
    {"controls[].file",
     "Table over time, relative to the scene file. Its first line names the columns, of which "
     "one is `time` [s] and rises. Before the first row and after the last their values hold. "
     "Exactly one of `file`, `formula`, `pid` and `relay` is required."},
    {"controls[].column", "Column of `file`. The default is the first beside `time`."},
    {"controls[].interpolation",
     "Value between the rows of `file`: on a line between them, or with `step` that of the row"
     " before."},
    {"controls[].formula", "Formula in the time t ([below](#formulas))."},
    {"controls[].pid",
     "Controller: the set point is kp·e + ki·∫e dt + kd·de/dt with e = target − measured, in "
     "the units of the names."},
    {"controls[].pid.of",
     "Quantity that is measured, `tug.heading_deg` for example ([below](#controls))."},
    {"controls[].pid.target", "Value that it is to have, a number or a formula in the time t."},
    {"controls[].pid.kp", "Gain of the error."},
    {"controls[].pid.ki",
     "Gain of the integral of the error. It does not grow while the output is at a limit."},
    {"controls[].pid.kd", "Gain of the rate of the error."},
    {"controls[].pid.limits", "Least and largest output. Without this key there are none."},
    {"controls[].relay",
     "Switch with hysteresis: the first of `values` until the quantity exceeds `high`, then "
     "the second until it falls below `low`."},
    {"controls[].relay.of", "Quantity that is measured."},
    {"controls[].relay.low", "Value below which it switches back."},
    {"controls[].relay.high", "Value above which it switches."},
    {"controls[].relay.values", "Values of the set point before and after it has switched."},
    {"controls[].start",
     "Time from which on the control acts. Before it the set point keeps its first value."},
    {"controls[].rate",
     "Largest change of the set point per second. Without this key it follows at once."},
});

}  // namespace

std::span<const Meaning> rig_meanings() { return kRigMeanings; }

}  // namespace scene
