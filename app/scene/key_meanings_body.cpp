#include <array>

#include "app/scene/key_meanings.h"

/// @file
/// The meaning of the keys of bodies and of the loads of the water on them; see key_meanings.cpp.

namespace scene {
namespace {

constexpr auto kBodyMeanings = std::to_array<Meaning>({
    {"bodies[].repeat",
     "Makes [copies](#repeated-entries) of the body, named `NAME_0`, `NAME_1`, …. Any map in a "
     "list "
     "of a scene may have this block."},
    {"bodies[].repeat.count", "Number of copies in one place; `jitter` moves them apart."},
    {"bodies[].repeat.grid", "Numbers of copies along x, y and z."},
    {"bodies[].repeat.spacing", "Distances between the copies of a grid along x, y and z."},
    {"bodies[].repeat.jitter",
     "Largest random shift of each copy along x, y and z, either way; all shifts are as likely."},
    {"bodies[].repeat.seed", "Seed of the shifts: equal seeds give equal shifts."},
    {"hydro.preset",
     "Set of coefficients, which the other keys override. `fitted` is fitted to the tabulated "
     "drag of blunt and slender bodies (`hydro/README.md`). `thesis` is the set of the 2014 "
     "thesis: C_p = 0.6316 on both sides, `blunt: 0`, `lift: 0.01` and `viscous_drag: thesis`."},
    {"hydro.buoyancy", "Hydrostatic pressure. `false` switches the load off."},
    {"hydro.pressure_drag",
     "Pressure drag coefficient C_p of steady motion. One number holds for all panels; `false` "
     "switches the load off. While the wake of a body that may move is not formed, as when it "
     "starts or bobs within its own size, its edges shed vortices in place of it "
     "(`hydro/README.md`)."},
    {"hydro.pressure_drag.front", "C_p where the surface moves into the water."},
    {"hydro.pressure_drag.back", "C_p where the surface moves away from the water."},
    {"hydro.pressure_drag.blunt",
     "Bluntness of the mesh along an axis from which on pressure drag counts in full along it: 1 "
     "is a flat face, 0.5 a sphere, 0.13 an ellipsoid of 4:1. Where the mesh, or the "
     "finer of its two ends, is more slender, the drag falls with the third power of the "
     "bluntness (`hydro/README.md`). With 0 it counts in full everywhere, and whether the wake is "
     "formed or not; along every axis it does so with `calibrate`, too."},
    {"hydro.lift",
     "Lift coefficient C_l of the 2014 thesis. Its load raises every hull that moves, where hulls "
     "sink in their own waves, so it is off unless it is asked for."},
    {"hydro.viscous_drag",
     "Friction coefficient C_v. `false` switches the load off. `thesis` depends on the local "
     "tangential speed v: 0.1 below 1 m/s, 0.2 − 0.1·v from 1 to 2 m/s, 0 above. `ittc57` is the "
     "friction line 0.075 / (log10 Re − 2)² with Re = v·length/viscosity; below Re = 1e4 its "
     "value at 1e4 holds."},
    {"hydro.wave_tolerance",
     "Accuracy of the loads in waves: the largest error of the force, relative to the "
     "buoyancy of the submerged body. As far as it allows, parts of the mesh are summed at "
     "once, triangles are split less, and waves that are too short or too low to move the "
     "body are left out. The error also stays below some half percent of the waves' own load. "
     "A smaller value takes more time. With 0 every triangle is summed by itself, with an "
     "error of 1e-6."},
    {"hydro.length",
     "Length in the friction line `ittc57`. The default is the longest side of the mesh's "
     "bounding box."},
    {"hydro.added_mass",
     "Added mass of the body. `deep` is that of the body in unbounded fluid, of which the "
     "wetted panels contribute their share, less where the body begins to enter the water, so "
     "that impacts have their force (`hydro/README.md`); it is solved once per mesh and kept "
     "for later runs. A body without loads of the water has added mass only if this key asks "
     "for it, and a body locked in all six degrees of freedom only where `log.forces` asks for "
     "its loads. Without this key, a body with `radiation` has the added mass of its mean "
     "pose."},
    {"hydro.added_mass.model",
     "Model of the added mass. `none` and `deep` are the same as the words alone. `surface` sets "
     "the potential to 0 on the water surface, the limit of high frequency (`hydro/README.md`); "
     "it is solved for the poses that the run meets, some tenths of a second each."},
    {"hydro.added_mass.tolerance",
     "Largest relative error of `deep` due to the size of the panels. The solver splits the "
     "faces of the mesh until the error is below it or a limit on their number is reached. "
     "`summary.json` has the error that remains."},
    {"hydro.added_mass.matrix",
     "The added mass matrix in body axes about the centre of mass, in the order surge, sway, "
     "heave, roll, pitch, yaw. It holds while any part of the body is wet, whatever the water's "
     "density. It must be symmetric and have no negative eigenvalues, both to 1e-9 of its "
     "largest entry."},
    {"hydro.radiation",
     "The waves that the body makes as it moves, and those that it scatters. With `auto` both are "
     "solved on its mesh in its mean pose, that in which it floats at rest, and kept for later "
     "runs; a block takes them from a database that another program has written. The body's added "
     "mass is then that of this pose in waves of high frequency, so the key excludes "
     "`added_mass`. Without both keys it is `auto` for a body that floats at rest near its start, "
     "in water of one depth, and otherwise `none`; the table before a run tells which, and why "
     "([below](#radiation))."},
    {"hydro.radiation.pose",
     "The mean pose. `equilibrium` is that in which the body comes to rest in still water with its "
     "joints, lines, locks and constant loads in place; where it does not come to rest within ten "
     "of its radii, as at a slack line, it is the start. `start` is the pose of the start. "
     "Without the key it is `equilibrium`, and for a body that something else than the water "
     "holds it must then be within 15° and a quarter of the displacement of the start."},
    {"hydro.radiation.file",
     "A database of added mass, damping and loads of waves, relative to the scene file: "
     "Capytaine's "
     "`.nc`, the `.h5` of BEMIO (WEC-Sim, HydroChrono), WAMIT's `.1` with the `.3` and `.hst` "
     "beside "
     "it, or Nemoh's `RadiationCoefficients.tec` with the forces beside it "
     "([below](#databases))."},
    {"hydro.radiation.body",
     "The body in the file, by its name or its number. It is needed if the file has several."},
    {"hydro.radiation.reference_point",
     "The point of the file's motions and moments, in the file's frame, whose z points up from the "
     "still water. The default is what the file tells, or else the frame's origin."},
    {"hydro.radiation.center_of_mass",
     "The body's centre of mass in the file's frame. The default is what the file tells, or else "
     "the place over the frame's origin; the height is that of the body's mean pose."},
    {"hydro.radiation.heading_deg",
     "Direction of the file's x axis as the body sees it, counter-clockwise from its own x axis."},
    {"hydro.radiation.length",
     "The length by which WAMIT's files are without dimension (ULEN); other files have units."},
    {"hydro.radiation.frequencies",
     "The least and the greatest frequency that are taken from the file. The default is all of "
     "them; a bad end of a file is left out by itself ([below](#databases))."},
    {"hydro.resistance",
     "Resistance of a hull along its motion, beside the drag of its panels: by the waves that it "
     "makes as it goes, and by its form. It acts against the horizontal velocity through the water "
     "at the centre of the volume displaced at rest, in whatever direction the hull goes, is "
     "whole down to half of that volume, and vanishes with it "
     "([below](#resistance))."},
    {"hydro.resistance.file",
     "A table with the columns `speed` [m/s] and `force` [N], relative to the scene file: what "
     "the hull's resistance is beyond the drag of its panels. It is interpolated by cubics from "
     "0 at speed 0 on, and beyond the last speed it grows as the square of the speed."},
    {"hydro.resistance.wave",
     "The theory of the waves. `michell` is thin-ship theory on the wetted mesh in the pose at "
     "rest, for hulls at least four times as long as wide in deep water; hulls side by side "
     "interfere. It is tabulated for Froude numbers up to 1, once for a mesh, and kept for later "
     "runs. Its flow draws the hull down, too, with the square of the speed."},
    {"bodies[].name",
     "Name of the body in logs and joints. It must not be `world` and must not contain a comma, "
     "a double quote or a control character."},
    {"bodies[].mesh", "A closed triangle mesh from a file. Its normals point out of the solid."},
    {"bodies[].mesh.file",
     "A mesh file, relative to the scene file: .obj, .stl, .ply, .off, .gltf or .glb, a file of "
     "panels .gdf, .dat, .pnl or .msh, and with the option `--any-format` any other that assimp "
     "reads."},
    {"bodies[].mesh.up",
     "The axis of the file that points up. The mesh is turned so that this is z of its mesh "
     "frame: about x for y, −y and −z, so that x stays, and about y for x and −x. The default is "
     "what the file says: y in glTF, `up_axis` in COLLADA, `UpAxis` in FBX; otherwise z."},
    {"bodies[].mesh.unit",
     "The unit of the file's coordinates. The default is what the file says: m in glTF, `unit` in "
     "COLLADA, `UnitScaleFactor` in FBX; otherwise m."},
    {"bodies[].mesh.scale",
     "Factor by which the coordinates are multiplied besides the unit, about the origin of the "
     "file."},
    {"bodies[].mesh.weld",
     "Widest crack between open edges that is closed. This key and the four below make a solid of "
     "a mesh that is none, as `plimsoll mesh FILE --repair` does: with any of them faces are "
     "turned outward, repeated ones and those without area dropped, and T-junctions stitched. The "
     "default is then 1e-5 of the diagonal of the mesh's box."},
    {"bodies[].mesh.cap", "Whether flat open loops are filled."},
    {"bodies[].mesh.mirror",
     "Axis normal to the plane through the origin in which a half hull is mirrored: `y` for one "
     "side of a ship."},
    {"bodies[].mesh.unite",
     "Whether closed parts of the file that overlap are united. A part inside another is dropped "
     "if its faces look out as those of the other do, and remains as a cavity if they look in."},
    {"bodies[].mesh.thickness",
     "Thickness of the plates that open parts become. Their faces remain as the outer side."},
    {"bodies[].box", "A box about the origin, of 12·divisions² triangles."},
    {"bodies[].box.size", "Lengths of the edges along x, y, z."},
    {"bodies[].box.divisions", "Number of parts of each edge."},
    {"bodies[].sphere",
     "A UV sphere with its poles on z and its vertices on the sphere, of 2·slices·(stacks − 1) "
     "triangles."},
    {"bodies[].sphere.radius", "Radius."},
    {"bodies[].sphere.slices", "Number of parts around z."},
    {"bodies[].sphere.stacks", "Number of parts from pole to pole."},
    {"bodies[].icosphere", "A sphere of nearly equal triangles, 20·4ⁿ with n subdivisions."},
    {"bodies[].icosphere.radius", "Radius."},
    {"bodies[].icosphere.subdivisions", "Number of times that each triangle is split into four."},
    {"bodies[].ellipsoid", "A UV sphere that is scaled along the axes."},
    {"bodies[].ellipsoid.semi_axes", "Half the lengths along x, y, z."},
    {"bodies[].ellipsoid.slices", "Number of parts around z."},
    {"bodies[].ellipsoid.stacks", "Number of parts from pole to pole."},
    {"bodies[].cylinder", "A closed cylinder about z, centred at the origin."},
    {"bodies[].cylinder.radius", "Radius."},
    {"bodies[].cylinder.height", "Length along z."},
    {"bodies[].cylinder.slices", "Number of parts around z."},
    {"bodies[].cylinder.stacks", "Number of parts along z."},
    {"bodies[].shapes",
     "Several shapes whose union is the body, each closed. They may lie apart or touch, but not "
     "overlap. An entry has one of `mesh`, `box`, `sphere`, `icosphere`, `ellipsoid` and "
     "`cylinder`, as a body has ([below](#several-shapes))."},
    {"bodies[].shapes[].position",
     "Position of the shape's own origin in the mesh frame of the body."},
    {"bodies[].shapes[].orientation",
     "Rotation of the shape about its own origin; the keys are those of `bodies[].orientation`."},
    {"bodies[].density",
     "Density, uniform over the volume of the shape. Exactly one of `density` and `mass` is "
     "required."},
    {"bodies[].mass", "Total mass."},
    {"bodies[].center_of_mass",
     "Centre of mass in the mesh frame, allowed with `mass` only. The default is the centroid of "
     "the volume."},
    {"bodies[].inertia",
     "Entries `[xx, yy, zz, xy, xz, yz]` of the inertia matrix about the centre of mass in body "
     "axes, allowed with `mass` only. The default is that of the mass spread evenly over the "
     "volume. The matrix must be positive definite, and no principal moment may exceed the sum "
     "of the other two."},
    {"bodies[].gyration",
     "Gyradii `[kx, ky, kz]` about the body's axes through its centre of mass, in place of "
     "`inertia`: the moments are mass·k², the products 0. No square may exceed the sum of the "
     "other two."},
    {"bodies[].position", "Position of the origin of the mesh frame in the world."},
    {"bodies[].orientation",
     "Rotation from body to world, given by exactly one of `euler_deg`, `quaternion` and `axis` "
     "with `angle_deg`. The default is no rotation."},
    {"bodies[].orientation.euler_deg", "Roll, pitch and yaw: R = Rz(yaw)·Ry(pitch)·Rx(roll)."},
    {"bodies[].orientation.quaternion", "Quaternion w, x, y, z. It is normalised."},
    {"bodies[].orientation.axis",
     "Axis of the rotation, of any length, together with `angle_deg`."},
    {"bodies[].orientation.angle_deg", "Angle of the rotation about `axis`."},
    {"bodies[].start",
     "Pose at time 0. `given` takes `position` and `orientation`. `equilibrium` puts the body "
     "where "
     "it comes to rest from its `orientation` in still water at `water.level`, under its weight, "
     "buoyancy, joints, springs, ropes, moorings, locks and constant `forces`. A body that the "
     "water alone carries keeps x, y and the heading of its x axis; z, roll and pitch follow. "
     "Bodies that `fixed` joints hold to it count as one with it and are taken along; only one "
     "body of them has this key. A body that does not float, or does not come to rest within ten "
     "of its radii, is a fault."},
    {"bodies[].heel",
     "Turn from the equilibrium, about the centre of mass and in the axes of the heading, with "
     "which the body starts: a decay in roll is `start: equilibrium, heel: {roll_deg: 10}`. No "
     "joint may hold the body."},
    {"bodies[].heel.roll_deg", "Roll of R = Ry(pitch)·Rx(roll)."},
    {"bodies[].heel.pitch_deg", "Pitch of R."},
    {"bodies[].linear_velocity", "Velocity of the centre of mass in world axes."},
    {"bodies[].angular_velocity", "Angular velocity in world axes."},
    {"bodies[].interior",
     "Water in the hollows of the body. With `flooding` they are dry until water comes over "
     "their rims or through `openings`; it then has a level of its own in each of them. With "
     "`dry` those that the body has at time 0 are closed by lids, and voids are dry. With `wet` "
     "all that is below the surface is in the sea."},
    {"bodies[].air",
     "True: the air in hollows without a mouth stays in them, but for what leaves through "
     "`openings`, and its pressure holds back the water. The body needs such a hollow with an "
     "opening or a pump into it. False: the air gives way to the water."},
    {"bodies[].interior_water", "Water in the hollows at time 0."},
    {"bodies[].interior_water[].at",
     "A point in the hollow, in the mesh frame: the hollow's surface is straight below it."},
    {"bodies[].interior_water[].volume", "Volume of the water."},
    {"bodies[].interior_water[].level",
     "Height of the water's surface above the origin of the mesh frame, along the world's "
     "vertical at time 0."},
    {"bodies[].openings",
     "Holes through which water runs between the sea and a hollow, or between two hollows, "
     "driven by the difference of their pressures."},
    {"bodies[].openings[].at", "Centre of the hole, in or near the wall, in the mesh frame."},
    {"bodies[].openings[].area", "Area of the hole."},
    {"bodies[].openings[].discharge", "Coefficient of discharge."},
    {"bodies[].pumps",
     "Pumps that empty or fill hollows. A pump brings water as long as its suction is under it."},
    {"bodies[].pumps[].name",
     "Name of the pump in logs and controls, unique among the pumps of all bodies. It must not "
     "contain a comma, a double quote or a control character."},
    {"bodies[].pumps[].from",
     "The suction, in the mesh frame: a point in a hollow, straight above its bottom, or a point "
     "in no hollow, where it is in the sea."},
    {"bodies[].pumps[].to",
     "The outlet: `sea`, or a point in a hollow, in the mesh frame, straight above its bottom."},
    {"bodies[].pumps[].rate",
     "Flow Q₀ without a lift. It is the first value of the set point `pumps[NAME].rate`, which is "
     "not below 0."},
    {"bodies[].pumps[].head",
     "Lift H₀ at which nothing comes any more: at a lift H from the level at the suction to that "
     "at the outlet, or to an outlet above it, the flow is Q₀ √(1 − H/H₀). Without this key it is "
     "Q₀ at any lift."},
    {"bodies[].hydro", "Coefficients of this body. They override the scene's `hydro` key by key."},
    {"bodies[].calibrate",
     "Scaling of the body's pressure drag to tabulated values, independent of its mesh."},
    {"bodies[].calibrate.drag",
     "Drag coefficients C_d of the submerged body along its x, y and z axes, each the mean of "
     "both directions. The reference area is the area of the projection along the axis. In other "
     "motions the three factors are averaged, weighted by the share of the surface's motion "
     "along each axis. Viscous drag is added."},
    {"bodies[].collision",
     "Shape of the body in contacts with other bodies and the ground. The default is `box` for a "
     "box, `sphere` for a sphere or icosphere, and `mesh` otherwise. A body with `none` passes "
     "through everything."},
    {"bodies[].friction",
     "Coulomb's coefficient of friction of the surface. A pair of bodies has the geometric mean of "
     "both, unless `contacts` gives it."},
    {"bodies[].restitution",
     "Coefficient of restitution of the surface: bodies that meet faster than 0.1 m/s part with "
     "this share of that speed. A pair of bodies has the larger of both, unless `contacts` "
     "gives it."},
    {"bodies[].lock", "Degrees of freedom that are locked at their initial values, in world axes."},
    {"bodies[].color", "Red, green and blue of the dry surface."},
});

}  // namespace

std::span<const Meaning> body_meanings() { return kBodyMeanings; }

}  // namespace scene
