#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/scene/key_catalogue.h"

/// @file
/// What every key of a scene is for: the one source of the tables in scenes/README.md, of the JSON
/// Schema, and of what editors show.

namespace scene {
namespace {

struct Meaning {
  std::string_view path;
  std::string_view text;  ///< Markdown.
};

constexpr auto kMeanings = std::to_array<Meaning>({
    {"plimsoll", "The version of the format."},
    {"title", "Shown by people's tools; has no effect on the run."},
    {"duration", "How much time is simulated. 0: only the initial state."},
    {"step",
     "Time step; the default is 1/60. Where a step is too long for a body's drag or buoyancy "
     "these are taken implicitly, or the step is cut in pieces; `summary.json` counts both "
     "(`implicit_pieces`, `pieces`): where there are many, a shorter step is more accurate. "
     "Where bodies run into each other or into the ground the step ends as they begin to "
     "touch and goes on in short pieces, for them alone; heaps of more than four pairs that "
     "touch take whole steps."},
    {"gravity", "Acceleration along −z."},
    {"integrator", "Options of the time stepping."},
    {"integrator.method",
     "`split` is of second order, and of the fourth where loads hang on the pose alone, with "
     "the 6×6 added mass; it cuts steps in which a body crosses the surface, turns or swings "
     "too far. `ode` is the plain method to compare with: loads once a step, handed to the "
     "Open Dynamics Engine's own step of first order, without added mass."},
    {"integrator.tolerance",
     "Steps are cut until the estimated error of a body's pose in a second is below this part "
     "of its radius, and this angle in rad, for bodies by themselves and under joints; in "
     "contact steps are cut where bodies begin to touch, with or without it. Left out: steps "
     "are cut for stability and impacts only. Not with `ode`."},
    {"integrator.sleep",
     "Has no effect any more, and is accepted for old scenes: bodies at rest move on like others. "
     "Not "
     "with `ode`."},
    {"water", "The water; left out: a dry scene."},
    {"ground",
     "A sea floor or shore; left out: none. Exactly one of `z`, `heightfield` and `mesh`."},
    {"hydro", "Coefficients of the loads for every body."},
    {"bodies", "The rigid bodies."},
    {"joints", "What ties bodies together."},
    {"log", "How the motion is logged."},
    {"render", "The pictures; left out: none is made and no graphics library is touched."},
    {"water.density", "Density of the water."},
    {"water.viscosity",
     "Kinematic viscosity, for `viscous_drag: ittc57`; the default is fresh water of 20 °C."},
    {"water.level", "z of the still water."},
    {"water.current", "Velocity of the water everywhere."},
    {"water.surface",
     "The shape of the surface, exactly one of `flat`, `heightfield`, `waves` and `spectrum`; left "
     "out: flat."},
    {"water.surface.flat", "Still water: `flat: {}`."},
    {"water.surface.heightfield", "A fixed surface, given by heights on a grid."},
    {"water.surface.heightfield.file",
     "A `.csv` file with rows of heights above `water.level` [m], or a 16-bit grey `.png`. "
     "Row = y, column = x. Outside the grid the nearest edge height holds."},
    {"water.surface.heightfield.cell", "Distance of neighbouring grid points."},
    {"water.surface.heightfield.origin", "Where the first height of the first row stands."},
    {"water.surface.heightfield.range",
     "The heights of black and white. Required for a `.png`, refused for a `.csv`."},
    {"water.surface.waves", "Deep-water linear waves, summed; at least one."},
    {"water.surface.waves[].amplitude", "Half of the height from trough to crest."},
    {"water.surface.waves[].wavelength", "Crest to crest."},
    {"water.surface.waves[].heading_deg",
     "Direction the wave travels to, counter-clockwise from +x."},
    {"water.surface.waves[].phase_deg", "Phase at the origin at time 0; 0: a crest."},
    {"water.surface.spectrum", "Irregular waves."},
    {"water.surface.spectrum.type", "The kind of spectrum."},
    {"water.surface.spectrum.significant_height", "Significant wave height H_s."},
    {"water.surface.spectrum.peak_period", "Period of the spectrum's peak T_p."},
    {"water.surface.spectrum.gamma", "Peak enhancement; 1 gives Pierson–Moskowitz."},
    {"water.surface.spectrum.heading_deg", "Mean direction the waves travel to."},
    {"water.surface.spectrum.spreading",
     "Exponent s of the directional spreading cos²ˢ(θ/2); 0: long-crested."},
    {"water.surface.spectrum.seed", "Chooses the phases. The same seed gives the same sea."},
    {"water.surface.spectrum.components",
     "Number of waves that stand for the spectrum; the cost of a step grows with it."},
    {"ground.z", "Height of a flat sea floor."},
    {"ground.heightfield",
     "A sea floor by heights: z in the world, otherwise as `water.surface.heightfield`."},
    {"ground.mesh",
     "A sea floor or shore as a mesh in the world frame, its faces looking up; keys as in "
     "`bodies[].mesh`."},
    {"hydro.preset",
     "A set of coefficients to start from; the other keys go over it. `thesis`: the set of "
     "the 2014 thesis, C_p = 0.6316 on both sides, the rest as by default."},
    {"hydro.buoyancy", "Hydrostatic pressure."},
    {"hydro.pressure_drag", "C_p; one number holds for all panels; `false` switches the load off."},
    {"hydro.pressure_drag.front", "C_p of panels that move into the water."},
    {"hydro.pressure_drag.back", "C_p of panels that move out of it."},
    {"hydro.lift", "C_l; `false` switches the load off."},
    {"hydro.viscous_drag",
     "C_v; `false` switches the load off. `thesis`: 0.1 below 1 m/s, 0.2 − 0.1·v from 1 to 2 "
     "m/s, 0 above, v the local tangential speed. `ittc57`: 0.075 / (log10 Re − 2)², Re = "
     "v·length/viscosity, held below Re = 1e4."},
    {"hydro.wave_tolerance",
     "In waves, parts of a large mesh are taken at once where the surface over them is nearly "
     "a curved one of second order; this bounds the error in the force, as a part of the "
     "wholly submerged body's buoyancy. In any water, parts of a mesh of more than 8,000 "
     "triangles have their viscous drag from a few points where that is bounded to be as good: "
     "this bounds its error, as a part of the drag of all the skin under the largest ½ρ C_v v² up "
     "to the body's greatest speed. 0: every triangle by itself."},
    {"hydro.length",
     "Length of the friction line `ittc57`; without it the longest side of the mesh's "
     "bounding box."},
    {"hydro.added_mass",
     "The water that a body moves with it. `deep`: of the body in unbounded fluid, the share "
     "of the panels that are wet; found once for a mesh and kept for later runs. A body whose "
     "loads are all off has none unless this key asks for it, nor has a body that is locked "
     "in all six."},
    {"hydro.added_mass.model",
     "As the word alone; `surface` has the potential 0 on the water's surface, the limit of "
     "high frequency (`hydro/README.md`), solved for poses as they are met: some tenths of a "
     "second each."},
    {"hydro.added_mass.tolerance",
     "Of the relative error of `deep` that finer panels would lessen. The mesh's faces are "
     "split for it, up to a limit beyond which the error stays what `summary.json` says."},
    {"hydro.added_mass.matrix",
     "The matrix itself, in body axes about the centre of mass, in the order surge, sway, "
     "heave, roll, pitch, yaw; it holds while any of the body is wet, whatever the water's "
     "density. Symmetric and without negative eigenvalues, to 1e-9 of its largest entry."},
    {"bodies[].name",
     "Used in the log and by joints. Not `world`; no comma, double quote or line break."},
    {"bodies[].mesh", "A closed triangle mesh from a file, normals out of the solid."},
    {"bodies[].mesh.file", "In any format that assimp reads, relative to the scene file."},
    {"bodies[].mesh.scale", "Factor on the file's coordinates."},
    {"bodies[].box", "A box, centred: 12·divisions² triangles."},
    {"bodies[].box.size", "Edges along x, y, z."},
    {"bodies[].box.divisions", "Parts of each edge."},
    {"bodies[].sphere",
     "A UV sphere, poles on z, vertices on the sphere: 2·slices·(stacks − 1) triangles."},
    {"bodies[].sphere.radius", "Radius."},
    {"bodies[].sphere.slices", "Parts around z."},
    {"bodies[].sphere.stacks", "Parts from pole to pole."},
    {"bodies[].icosphere", "A sphere of nearly equal triangles: 20·4ⁿ with n subdivisions."},
    {"bodies[].icosphere.radius", "Radius."},
    {"bodies[].icosphere.subdivisions", "How often each triangle is split in four."},
    {"bodies[].ellipsoid", "The UV sphere, scaled along the axes."},
    {"bodies[].ellipsoid.semi_axes", "Half the extent along x, y, z."},
    {"bodies[].ellipsoid.slices", "Parts around z."},
    {"bodies[].ellipsoid.stacks", "Parts from pole to pole."},
    {"bodies[].cylinder", "A capped cylinder about z, centred."},
    {"bodies[].cylinder.radius", "Radius."},
    {"bodies[].cylinder.height", "Extent along z."},
    {"bodies[].cylinder.slices", "Parts around."},
    {"bodies[].cylinder.stacks", "Parts along."},
    {"bodies[].density",
     "Uniform over the volume of the shape. Exactly one of `density` and `mass`."},
    {"bodies[].mass", "Total mass."},
    {"bodies[].center_of_mass",
     "In the mesh frame, with `mass` only; left out: the centroid of the volume."},
    {"bodies[].inertia",
     "`[xx, yy, zz, xy, xz, yz]`, the entries of the inertia matrix about the centre of mass "
     "in body axes, with `mass` only; left out: the mass spread evenly over the volume. Must "
     "be positive definite, and no principal moment larger than the sum of the others."},
    {"bodies[].position", "Of the mesh frame's origin, in the world."},
    {"bodies[].orientation",
     "Body to world, exactly one of `euler_deg`, `quaternion` and `axis` with `angle_deg`; left "
     "out: unturned."},
    {"bodies[].orientation.euler_deg", "Roll, pitch, yaw: R = Rz(yaw)·Ry(pitch)·Rx(roll)."},
    {"bodies[].orientation.quaternion", "w, x, y, z; brought to unit length."},
    {"bodies[].orientation.axis", "Axis of one turn, any length; with `angle_deg`."},
    {"bodies[].orientation.angle_deg", "Angle of the turn about `axis`."},
    {"bodies[].start",
     "`equilibrium`: the body starts afloat, where it comes to rest from its `orientation` in "
     "still water at `water.level`, alone and with nothing but weight and buoyancy on it. "
     "`position`'s x and y and the heading of its x axis are kept, z is found. It must be "
     "lighter than water, and z, roll and pitch not locked."},
    {"bodies[].linear_velocity", "Of the centre of mass, world axes."},
    {"bodies[].angular_velocity", "World axes."},
    {"bodies[].hydro", "As the scene's `hydro`, which it overrides key by key."},
    {"bodies[].calibrate",
     "Scales the body's pressure drag to tabulated values, whatever its mesh."},
    {"bodies[].calibrate.drag",
     "Drag coefficients C_d along the body's x, y and z axes, wholly submerged, on the area "
     "of its shadow along each axis; the mean of both directions. In other motions the three "
     "factors are mixed by how much of the surface's motion is along each axis. Viscous drag "
     "comes on top."},
    {"bodies[].collision",
     "What stands for the body when it touches others and the ground; left out: `box` for a "
     "box, `sphere` for a sphere or icosphere, else `mesh`. `none`: it passes through "
     "everything."},
    {"bodies[].lock", "Degrees of freedom held where they are, world axes."},
    {"bodies[].forces", "Loads besides those of water and gravity."},
    {"bodies[].forces[].force", "Force."},
    {"bodies[].forces[].torque", "Torque."},
    {"bodies[].forces[].frame", "Axes of `force` and `torque`; `body`: they turn with the body."},
    {"bodies[].forces[].at",
     "Where the force acts, in the mesh frame; left out: the centre of mass."},
    {"bodies[].forces[].start", "When it begins."},
    {"bodies[].forces[].end", "When it ends, not before `start`; left out: never."},
    {"bodies[].forces[].sine", "The load is multiplied by sin(2π·frequency·t + phase)."},
    {"bodies[].forces[].sine.frequency_hz", "Frequency."},
    {"bodies[].forces[].sine.phase_deg", "Phase at time 0."},
    {"bodies[].color", "Red, green, blue of the dry surface."},
    {"joints[].name", "Left out: `joint` and its index, counted from 0."},
    {"joints[].type",
     "What the joint leaves free: all turning; turning about one axis; sliding along one "
     "axis; nothing; turning about two axes."},
    {"joints[].bodies", "The two bodies that it ties."},
    {"joints[].anchor",
     "A point of the joint in the world at time 0. Required for ball, hinge and universal; a "
     "slider or fixed joint is the same wherever it is."},
    {"joints[].axis",
     "Direction in the world at time 0. Required for hinge, slider and universal, refused for "
     "the others."},
    {"joints[].axis2",
     "Second axis of a universal joint, perpendicular to `axis`; left out: some perpendicular."},
    {"log.every", "Time between logged states; 0 or left out: every step."},
    {"log.forces",
     "Writes `forces.csv` beside `trajectory.csv`: a row with the forces on a body and their "
     "work for each that the trajectory has; with `--format hdf5` they are in `run.h5`."},
    {"render.size", "Width and height."},
    {"render.every",
     "Time between pictures. `frames/` has them all, `sheet.png` every one of up to 24, of "
     "more every second, fourth, …."},
    {"render.camera", "The view. Up in the picture is +z, so it cannot look straight up or down."},
    {"render.camera.from", "Where the camera stands."},
    {"render.camera.to", "What it looks at."},
    {"render.camera.fov_deg", "Vertical field of view."},
    {"render.camera.follow",
     "A body. `from` and `to` are those of time 0, and move as its centre of mass does; left out: "
     "they stay."},
    {"render.camera.orbit",
     "How fast the camera turns about the vertical through `to`, counter-clockwise from above."},
    {"render.cameras",
     "Several cameras by their names, instead of `camera`: `frames/NAME/` and `sheet_NAME.png`. "
     "They share one colour scale. A name is of letters, digits, - and _."},
    {"render.cameras.NAME", "A camera; keys as in `render.camera`."},
    {"render.sheet", "The figure of the pictures side by side, `sheet.png`."},
    {"render.sheet.columns",
     "How many pictures stand in a row; left out: as many as make it about half again as wide as "
     "it is high."},
    {"render.show",
     "Besides the bodies: `forces`, arrows of weight, buoyancy, drag and lift with one scale for "
     "the whole sequence; `centres` of mass G and buoyancy B; `waterline`, drawn bold; "
     "`wireframe`, the edges of the meshes."},
    {"render.pressure", "The colour scale of the pressure on the wet surface."},
    {"render.pressure.shows",
     "`hydrostatic`: ρ g h. `dynamic`: ½ ρ C_p v_n |v_n|, by the speed v_n against the water along "
     "the normal. `total`: both."},
    {"render.pressure.colors",
     "Colours by name: `turbo` and `thesis` from blue over green to red, `viridis` and `cividis` "
     "even in lightness, `coolwarm` pale in the middle, for what may be negative."},
    {"render.pressure.min", "Lower end; `auto`: found from the scene."},
    {"render.pressure.max", "Upper end; `auto`: found from the scene."},
});

/// Blocks that stand in several places are described once.
constexpr auto kCopies = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"bodies[].hydro.", "hydro."},
     {"ground.heightfield.", "water.surface.heightfield."},
     {"ground.mesh.", "bodies[].mesh."},
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
  return paths;
}

std::string key_meaning(const std::string& path) {
  const std::string original = described_path(path);
  const auto found = std::find_if(kMeanings.begin(), kMeanings.end(),
                                  [&](const Meaning& meaning) { return meaning.path == original; });
  if (found == kMeanings.end()) throw std::out_of_range(path + " has no meaning");
  return std::string(found->text);
}

}  // namespace scene
