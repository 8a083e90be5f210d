#include "app/scene/key_meanings.h"

#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/scene/key_catalogue.h"

/// @file
/// The meaning of every key of a scene. The tables in scenes/README.md, the JSON Schema and the
/// descriptions that editors show are generated from these texts.

namespace scene {
namespace {

constexpr auto kMeanings = std::to_array<Meaning>({
    {"plimsoll", "Version of the scene format."},
    {"title", "Title for reports and tools. It has no effect on the run."},
    {"include",
     "Scene files whose keys this scene has, too. [Keys of later "
     "files](#files-that-a-scene-includes) "
     "go over those of earlier ones, and those of the scene over all."},
    {"variables", "Numbers and texts for `${…}` [in values](#variables)."},
    {"variables.NAME", "Value of `${NAME}`; it may use variables before it."},
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
    {"duration", "Simulated time. With 0 the run consists of the initial state."},
    {"step",
     "Time step; the default is 1/60 s. The engine divides a step into substeps where the motion "
     "requires it, and takes drag or buoyancy implicitly where they are stiff. `summary.json` "
     "counts both per body (`pieces`, `implicit_pieces`); where they are many, a shorter step is "
     "more accurate. Where bodies collide with each other or with the ground, the step is "
     "divided at the time of first contact and continues in short substeps for these bodies "
     "alone. Heaps with more than four pairs in contact take whole steps."},
    {"gravity", "Gravitational acceleration along −z."},
    {"integrator", "Options of the time stepping."},
    {"integrator.method",
     "`split` is the default method. It includes the full 6×6 added mass and is of second order, "
     "and of fourth order where the loads depend on the pose alone. It divides a step in which a "
     "body crosses the surface, turns or oscillates too far. `ode` is the plain method, for "
     "comparison: it finds the loads once per step and hands them to the first-order step of the "
     "Open Dynamics Engine, without added mass."},
    {"integrator.tolerance",
     "Largest estimated error of a body's pose per second of motion, relative to its radius for "
     "the position and in rad for the attitude. Steps are divided until the error is below it, "
     "for free bodies and bodies under joints; steps of bodies in contact are divided at the "
     "time of first contact only. Without this key, steps are divided for stability and impacts "
     "only. Not allowed with `ode`."},
    {"integrator.sleep",
     "This key has no effect. It is accepted so that old scenes still run. Not allowed with "
     "`ode`."},
    {"water", "The water. Without this block the scene is dry."},
    {"air",
     "The air above the water, which acts on the dry part of bodies. It needs `water`. Without "
     "this "
     "block nothing acts there."},
    {"ground",
     "The sea floor or shore, given by exactly one of `z`, `heightfield` and `mesh`. Without "
     "this block there is none."},
    {"hydro", "Coefficients of the loads for all bodies."},
    {"bodies", "The rigid bodies."},
    {"joints", "Joints between two bodies, or between a body and the world."},
    {"contacts", "Friction and restitution of single pairs of bodies."},
    {"springs", "Springs with dampers between two points."},
    {"ropes", "Ropes and winches between two points. They only pull."},
    {"moorings",
     "Mooring lines: a list of elastic catenaries at rest between a body and an anchor, or a map "
     "that names a file of MoorDyn."},
    {"propellers", "Propellers and thrusters. They need `water`."},
    {"rudders", "Rudders, fins and keels: foils in the water. They need `water`."},
    {"sails", "Sails: foils in the wind. They need `air`."},
    {"controls", "What drives set points in the course of time."},
    {"log", "Options of the log."},
    {"render",
     "Options of the pictures. Without this block none is drawn, and no graphics library is "
     "loaded."},
    {"water.density", "Density of the water."},
    {"water.viscosity",
     "Kinematic viscosity for `viscous_drag: ittc57`. The default is that of fresh water at 20 "
     "°C."},
    {"water.level", "Height z of the still water."},
    {"water.depth",
     "Depth of the still water, uniform everywhere, for the waves; without this key they are those "
     "of deep water. It is no obstacle: bodies stand on `ground`."},
    {"water.current",
     "Velocity of the water, uniform everywhere, or a table of it over the depth, for flat water "
     "and "
     "waves of `kinematics: airy`. Waves travel on it, on a table's first row, and their motion "
     "adds to it."},
    {"water.current.depths",
     "Depths of the rows below the still water level. Between two rows the velocity is linear in "
     "the depth; above the first and below the last it is that of the row."},
    {"water.current.velocities", "Velocities of the water at these depths, horizontal."},
    {"water.surface",
     "Shape of the surface, given by exactly one of `flat`, `heightfield`, `waves`, "
     "`spectrum` and `elevation`. Without this block the surface is flat."},
    {"water.surface.kinematics",
     "Model of the water below waves. `airy` is linear wave theory: pressure and "
     "motion of the water decay with depth. `hydrostatic` is the model of the 2014 thesis: the "
     "pressure is that of the height of water above, and the water moves with the current alone."},
    {"water.surface.ramp",
     "Time over which the waves grow from still water at time 0: all amplitudes have the factor ½ "
     "(1 − cos πt/ramp) until then. With 0 they are whole from the start. Not used with `flat` and "
     "`heightfield`."},
    {"water.surface.flat", "Still water: `flat: {}`."},
    {"water.surface.heightfield", "A fixed surface, given by heights on a grid."},
    {"water.surface.heightfield.file",
     "A `.csv` file with rows of heights above `water.level` [m], or a 16-bit grey `.png`. The "
     "row index counts along y and the column index along x. Outside the grid the nearest height "
     "of its edge holds."},
    {"water.surface.heightfield.cell", "Distance between neighbouring grid points."},
    {"water.surface.heightfield.origin", "Position x, y of the first height of the first row."},
    {"water.surface.heightfield.range",
     "Heights of black and white. Required for a `.png`, not allowed for a `.csv`."},
    {"water.surface.waves", "Linear waves, at least one. Their heights are added."},
    {"water.surface.waves[].amplitude", "Half the height from trough to crest."},
    {"water.surface.waves[].wavelength",
     "Distance from crest to crest. Exactly one of `wavelength` and `period` is required."},
    {"water.surface.waves[].period",
     "Time from crest to crest at a fixed point. It includes the effect of the current."},
    {"water.surface.waves[].heading_deg",
     "Direction in which the wave travels, counter-clockwise from +x."},
    {"water.surface.waves[].phase_deg", "Phase at the origin at time 0; 0 is a crest."},
    {"water.surface.spectrum", "Irregular waves, given by a wave spectrum."},
    {"water.surface.spectrum.type",
     "Type of the spectrum. `jonswap` is that of growing wind waves. `pierson_moskowitz` and "
     "`bretschneider` are two names of the same formula, that of `jonswap` with `gamma: 1`. "
     "`tma` is `jonswap` for water of the depth `water.depth`. `file` is a spectrum in a table."},
    {"water.surface.spectrum.file",
     "Table of a spectrum. Its first line names the columns: `frequency_hz` and `density` [m²/Hz], "
     "or `frequency_rad_s` and `density` [m² s/rad]; and, where the direction of travel changes "
     "with the frequency, `heading_deg`, to which the key `heading_deg` is added. The density is "
     "linear between the rows and zero outside. Required with `type: file`, not used otherwise."},
    {"water.surface.spectrum.significant_height",
     "Significant wave height H_s. Required but for `type: file`."},
    {"water.surface.spectrum.peak_period", "Peak period T_p. Required but for `type: file`."},
    {"water.surface.spectrum.gamma",
     "Peak enhancement factor γ of `jonswap` and `tma`. With `auto` it follows DNV-RP-C205: with "
     "r = T_p/√H_s in s/√m it is 5 for r up to 3.6, 1 from 5 on, and exp(5.75 − 1.15·r) between."},
    {"water.surface.spectrum.heading_deg", "Mean direction in which the waves travel."},
    {"water.surface.spectrum.spreading",
     "Exponent s of the directional spreading cos²ˢ(θ/2); 0 gives long-crested waves."},
    {"water.surface.spectrum.seed", "Seed of the random phases. The same seed gives the same sea."},
    {"water.surface.spectrum.components",
     "Number of wave components that represent the spectrum. The cost of a step grows with it."},
    {"water.surface.elevation",
     "Long-crested waves with a measured elevation at one point: the Fourier series of a record in "
     "a band of frequencies. After the record's length they repeat."},
    {"water.surface.elevation.file",
     "Table of the record. Its first line names the columns, `time` [s] in equal intervals and "
     "`elevation` above the still water [m]. The mean elevation is left out."},
    {"water.surface.elevation.at", "Position x, y of the gauge."},
    {"water.surface.elevation.heading_deg", "Direction in which the waves travel."},
    {"water.surface.elevation.start",
     "Time in the file that is time 0 of the run. Without this key it is the first one."},
    {"water.surface.elevation.lowest_frequency_hz",
     "Lower end of the band. Without this key it is 0.3 times the frequency of the record's peak."},
    {"water.surface.elevation.highest_frequency_hz",
     "Upper end of the band. Without this key it is 3 times the frequency of the record's peak. "
     "The "
     "cost of a step grows much with it: faces are split for short waves."},
    {"water.surface.elevation.components",
     "Largest number of waves, of which those of the largest energy are kept."},
    {"air.density", "Density of the air; the default is that at 15 °C at sea level."},
    {"air.wind",
     "Velocity of the air, uniform everywhere, or a map for a wind that grows with the height. The "
     "speed is at most 150 m/s."},
    {"air.wind.speed", "Speed of the wind at `height`."},
    {"air.wind.heading_deg",
     "Direction in which the air moves, counter-clockwise from +x, as waves' `heading_deg`; not "
     "that from which it comes."},
    {"air.wind.height", "Height above the water where the wind has its `speed`."},
    {"air.wind.profile",
     "Change with the height z above the water's surface. `power` is the power law speed · "
     "(z/height)^exponent, zero at the surface. `uniform` is the same speed everywhere."},
    {"air.wind.exponent",
     "Exponent of `power`: about 0.11 over open sea, 0.14 over smooth land, 0.2 and more over "
     "rough land."},
    {"ground.z", "Height of a flat sea floor."},
    {"ground.heightfield",
     "A sea floor given by heights. They are values of z in the world frame; the keys are those "
     "of `water.surface.heightfield`."},
    {"ground.mesh",
     "A sea floor or shore as a mesh in the world frame, with its faces upward. The keys are "
     "those of `bodies[].mesh`."},
    {"ground.friction", "Coefficient of friction, as `bodies[].friction`."},
    {"ground.restitution", "Coefficient of restitution, as `bodies[].restitution`."},
    {"hydro.preset",
     "Set of coefficients, which the other keys override. `fitted` is fitted to the tabulated "
     "drag of blunt and slender bodies (`hydro/README.md`). `thesis` is the set of the 2014 "
     "thesis: C_p = 0.6316 on both sides, `blunt: 0` and `viscous_drag: thesis`."},
    {"hydro.buoyancy", "Hydrostatic pressure. `false` switches the load off."},
    {"hydro.pressure_drag",
     "Pressure drag coefficient C_p. One number holds for all panels; `false` switches the load "
     "off."},
    {"hydro.pressure_drag.front", "C_p where the surface moves into the water."},
    {"hydro.pressure_drag.back", "C_p where the surface moves away from the water."},
    {"hydro.pressure_drag.blunt",
     "Bluntness of the mesh along an axis from which on pressure drag counts in full along it: 1 "
     "is a flat face, 0.5 a sphere, 0.13 an ellipsoid of 4:1. Where the mesh is more slender, the "
     "drag falls with the third power of the bluntness (`hydro/README.md`). With 0 it counts in "
     "full everywhere; so it does with `calibrate`."},
    {"hydro.lift", "Lift coefficient C_l. `false` switches the load off."},
    {"hydro.viscous_drag",
     "Friction coefficient C_v. `false` switches the load off. `thesis` depends on the local "
     "tangential speed v: 0.1 below 1 m/s, 0.2 − 0.1·v from 1 to 2 m/s, 0 above. `ittc57` is the "
     "friction line 0.075 / (log10 Re − 2)² with Re = v·length/viscosity; below Re = 1e4 its "
     "value at 1e4 holds."},
    {"hydro.wave_tolerance",
     "Accuracy of the loads of large meshes in waves. Parts of the mesh are summed at once where "
     "the surface above them is nearly quadratic. The key bounds the resulting error of the "
     "force, relative to the buoyancy of the submerged body; that of the waves' pressure stays "
     "below this part of the waves' height, too. With 0 every triangle is summed by "
     "itself."},
    {"hydro.length",
     "Length in the friction line `ittc57`. The default is the longest side of the mesh's "
     "bounding box."},
    {"hydro.added_mass",
     "Added mass of the body. `deep` is that of the body in unbounded fluid, of which the wetted "
     "panels contribute their share; it is solved once per mesh and kept for later runs. A body "
     "without loads of the water has added mass only if this key asks for it, and a body locked "
     "in all six degrees of freedom has none. Without this key, a body with `radiation` has the "
     "added mass of its mean pose."},
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
     "`added_mass`. Without both keys it is `auto` for a body that starts afloat near its mean "
     "pose, free and alone on open water, and otherwise `none`; `plimsoll check` tells which, and "
     "why ([below](#radiation))."},
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
    {"bodies[].name",
     "Name of the body in logs and joints. It must not be `world` and must not contain a comma, "
     "a double quote or a line break."},
    {"bodies[].mesh", "A closed triangle mesh from a file. Its normals point out of the solid."},
    {"bodies[].mesh.file",
     "A mesh file, relative to the scene file: .obj, .stl, .ply, .off, .gltf or .glb, and with the "
     "option `--any-format` any other that assimp reads."},
    {"bodies[].mesh.scale", "Factor by which the coordinates of the file are multiplied."},
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
     "afloat, where it comes to rest from its `orientation` in still water at `water.level` "
     "under weight and buoyancy alone. Then x, y and the heading of its x axis are those given, "
     "and z, roll and pitch follow. The body must be lighter than water, and z, roll and pitch "
     "must not be locked."},
    {"bodies[].linear_velocity", "Velocity of the centre of mass in world axes."},
    {"bodies[].angular_velocity", "Angular velocity in world axes."},
    {"bodies[].interior",
     "Water in the hollows of the body. With `flooding` they are dry until water comes over "
     "their rims or through `openings`; it then has a level of its own in each of them. With "
     "`dry` those that the body has at time 0 are closed by lids, and voids are dry. With `wet` "
     "all that is below the surface is in the sea."},
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
     "Coulomb's coefficient of friction of the surface. That of a pair is the geometric mean of "
     "both, unless `contacts` gives it."},
    {"bodies[].restitution",
     "Coefficient of restitution of the surface: bodies that meet faster than 0.1 m/s part with "
     "this share of that speed. That of a pair is the larger of both, unless `contacts` gives "
     "it."},
    {"bodies[].lock", "Degrees of freedom that are locked at their initial values, in world axes."},
    {"bodies[].color", "Red, green and blue of the dry surface."},
    {"contacts[].bodies",
     "The two bodies, which no joint connects; `world` stands for the ground. Each pair may be "
     "given once."},
    {"contacts[].friction",
     "Coefficient of friction of the pair. Without this key it follows from those of the bodies. "
     "At least one of `friction` and `restitution` is required."},
    {"contacts[].restitution",
     "Coefficient of restitution of the pair. Without this key it follows from those of the "
     "bodies."},
    {"log.every", "Time between logged states. With 0 or without this key every step is logged."},
    {"log.probes", "Probes, which are read for `probes.csv` with every row of the trajectory."},
    {"log.probes[].name",
     "Name of the probe in the log. It must not contain a comma, double quote or line break."},
    {"log.probes[].wave",
     "Place x, y in the world frame of a gauge of the water's elevation. Exactly one of `wave` and "
     "`body` is required."},
    {"log.probes[].depth",
     "Depth below `water.level` of a fixed point at the gauge, where velocity and acceleration of "
     "the water are logged too. Only used with `wave`."},
    {"log.probes[].body", "Name of a body that carries the probe."},
    {"log.probes[].at",
     "Point of the body in its mesh frame. Its position, velocity and acceleration are logged, and "
     "the water's elevation over it. Only used with `body`."},
    {"log.forces",
     "Option to write `forces.csv`: for every row of the trajectory, the loads on the body, "
     "their work and the energies. With `--format hdf5` they are in `run.h5`."},
    {"render.size", "Width and height of the pictures."},
    {"render.every",
     "Time between pictures. `frames/` has all pictures. `sheet.png` has at most 24: all, or "
     "every second, fourth and so on."},
    {"render.camera",
     "The camera. Up in the picture is +z, so the camera cannot look straight up or down."},
    {"render.camera.from", "Position of the camera."},
    {"render.camera.to", "Point at which the camera looks."},
    {"render.camera.fov_deg", "Vertical field of view."},
    {"render.camera.follow",
     "Body that the camera follows. `from` and `to` are those of time 0 and move with its centre "
     "of mass. Without this key they are fixed."},
    {"render.camera.orbit",
     "Rate at which the camera orbits the vertical through `to`, counter-clockwise as seen from "
     "above."},
    {"render.cameras",
     "Several cameras by name, in place of `camera`. They write `frames/NAME/` and "
     "`sheet_NAME.png` and share one colour scale. A name consists of letters, digits, - and _."},
    {"render.cameras.NAME", "A camera. The keys are those of `render.camera`."},
    {"render.sheet", "Options of the figure `sheet.png`, which shows the pictures side by side."},
    {"render.sheet.columns",
     "Number of pictures in a row. By default the figure is about 1.5 times as wide as high."},
    {"render.show",
     "What is drawn in addition to the bodies. `forces` are arrows of weight, buoyancy, drag and "
     "lift with one scale for the whole sequence; `centres` are the centres of mass G and "
     "buoyancy B; `waterline` is a bold line; `wireframe` shows the edges of the meshes; `joints` "
     "are pins of hinges, balls, and bars along which sliders move."},
    {"render.pressure", "Colour scale of the pressure on the wet surface."},
    {"render.pressure.shows",
     "Pressure that is shown. `hydrostatic` is ρ g h; under linear waves it is the pressure that "
     "the water would have without the body. `dynamic` is ½ ρ C_p v_n |v_n| with the speed v_n "
     "relative to the water along the normal. `total` is their sum."},
    {"render.pressure.colors",
     "Colour map. `turbo` and `thesis` go from blue over green to red; `viridis` and `cividis` "
     "have uniform steps of lightness; `coolwarm` is pale in the middle, for values of either "
     "sign; `gray` goes from dark to light."},
    {"render.pressure.min", "Lower end of the scale. With `auto` it is found from the scene."},
    {"render.pressure.max", "Upper end of the scale. With `auto` it is found from the scene."},
});

/// Blocks that occur in several places, and the place at which each is described.
constexpr auto kCopies = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"bodies[].hydro.", "hydro."},
     {"ground.heightfield.", "water.surface.heightfield."},
     {"ground.mesh.", "bodies[].mesh."},
     {"sails[].", "rudders[]."},
     {"render.cameras.NAME.", "render.camera."}});

}  // namespace

std::string described_path(const std::string& path) {
  for (const auto& [copy, original] : kCopies)
    if (path.starts_with(copy)) return std::string(original) + path.substr(copy.size());
  return path;
}

std::vector<std::string> described_paths() {
  std::vector<std::string> paths;
  for (const Meaning& meaning : kMeanings) paths.emplace_back(meaning.path);
  for (const Meaning& meaning : rig_meanings()) paths.emplace_back(meaning.path);
  return paths;
}

std::string key_meaning(const std::string& path) {
  const std::string original = described_path(path);
  for (const std::span<const Meaning> some : {std::span<const Meaning>(kMeanings), rig_meanings()})
    for (const Meaning& meaning : some)
      if (meaning.path == original) return std::string(meaning.text);
  throw std::out_of_range(path + " has no meaning");
}

}  // namespace scene
