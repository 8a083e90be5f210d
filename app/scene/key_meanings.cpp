#include "app/scene/key_meanings.h"

#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/scene/key_catalogue.h"

/// @file
/// The meaning of every key of a scene. The tables in scenes/KEYS.md, the JSON Schema and the
/// descriptions that editors show are generated from these texts.

namespace scene {
namespace {

constexpr auto kMeanings = std::to_array<Meaning>({
    {"plimsoll", "Version of the scene format."},
    {"title", "Title for reports and tools. It has no effect on the run."},
    {"include",
     "Scene files whose keys this scene has, too. [Later files override earlier "
     "ones](#files-that-a-scene-includes), and the scene overrides them all."},
    {"variables", "Numbers and texts for `${…}` [in values](#variables)."},
    {"variables.NAME", "Value of `${NAME}`; it may use variables before it."},
    {"duration", "Simulated time. With 0 the run consists of the initial state."},
    {"step",
     "Time step; the default is 1/60 s. The engine divides a step into substeps where the motion "
     "requires it, and takes drag or buoyancy implicitly where they are stiff. `summary.json` "
     "counts both per body (`substeps`, `implicit_substeps`); where they are many, a shorter step "
     "is more accurate. Where bodies collide with each other or with the ground, the step is "
     "divided at the time of first contact and continues in short substeps for these bodies "
     "alone. Heaps in which more than 256 pairs touch take whole steps, as do bodies under joints "
     "that are in contact in more than four pairs."},
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
     "Mooring lines between a body and an anchor: a list, or a map that names a file for MoorDyn."},
    {"propellers", "Propellers and thrusters. They need `water`."},
    {"rudders", "Rudders, fins and keels: foils in the water. They need `water`."},
    {"sails", "Sails: foils in the wind. They need `air`."},
    {"controls", "Controls, which drive set points in the course of time."},
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
    {"water.simulated",
     "`picture`: bodies make waves, rings and wakes, that the pictures and the window show and no "
     "body feels; nor do the logs and Python's pictures have them. `{}`: bodies feel the waves of "
     "all bodies as well. Hulls that float near their mean pose radiate into this water and "
     "scatter "
     "what comes, in the place of `radiation: auto`; other bodies make waves and feel none. "
     "`none`: "
     "the water is as it is given."},
    {"water.simulated.size",
     "Cells of the grid along x and y, two equal powers of two. Without it as many as the bodies "
     "need, 512 at most."},
    {"water.simulated.spacing",
     "Side of a cell. Without it a quarter of the breadth of the narrowest hull, or more where the "
     "bodies are far apart or the step is long."},
    {"water.simulated.edge",
     "Width of the edge of the grid that absorbs waves: the length of the longest ones that "
     "matter. "
     "Without it a fifth of the grid."},
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
     "Number of wave components that represent the spectrum. With more of them the shortest "
     "waves are shorter, and the cost of a step grows with that."},
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
    {"ground.suction",
     "A soft bed: it holds a body that lies on it and is pulled. Without this block a body lifts "
     "off at once. The load is in `applied` of the log of forces."},
    {"ground.suction.pressure",
     "Largest fall of the pressure below a body; over the area of its footprint it is the force "
     "that frees it at once. From about 5e3 in loose sand to 5e4 in stiff clay."},
    {"ground.suction.time",
     "Time T in which the bond is lost. A pull of f over the weight in water frees a footprint of "
     "area A after T (p A/f - 1)."},
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
     "Name of the probe in the log. It must not contain a comma, double quote or control "
     "character."},
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
     "Time between pictures; the final state has one, too. `frames/` has all pictures. `sheet.png` "
     "has at most 24: all, or "
     "every second, fourth and so on."},
    {"render.camera",
     "The camera. Up in the picture is +z, so the camera cannot look straight up or down."},
    {"render.camera.from",
     "Position of the camera. By default it is on the side of [6, -8, 3] from `to`, as far away as "
     "it takes to see all bodies at the start."},
    {"render.camera.to",
     "Point at which the camera looks, by default the middle of all bodies at the start."},
    {"render.camera.fov_deg", "Vertical field of view."},
    {"render.camera.follow",
     "Body that the camera follows. `from` and `to` are those of time 0 and move with its centre "
     "of mass. Without this key they are fixed."},
    {"render.camera.orbit",
     "Rate at which the camera orbits the vertical through `to`, counter-clockwise as seen from "
     "above."},
    {"render.camera.on",
     "Body that the camera stands on and turns with: `from` and `to` are points of its mesh frame, "
     "whose z is up in the picture."},
    {"render.cameras",
     "Several cameras in place of `camera`: a list, or a map by their names. They write "
     "`frames/NAME/` and `sheet_NAME.png` and share one colour scale."},
    {"render.cameras[].name",
     "Name of a camera in the list: letters, digits, - and _. The other keys are those of "
     "`render.camera`."},
    {"render.cameras.NAME", "A camera in the map. The keys are those of `render.camera`."},
    {"render.sheet", "Options of the figure `sheet.png`, which shows the pictures side by side."},
    {"render.sheet.columns",
     "Number of pictures in a row. By default the figure is about 1.5 times as wide as high."},
    {"render.show",
     "Things that are drawn besides the bodies. `forces` are arrows of weight, buoyancy, drag and "
     "lift with one scale for the whole sequence; `centres` are the centres of mass G and "
     "buoyancy B; `waterline` is a bold line; `wireframe` shows the edges of the meshes; `joints` "
     "are pins of hinges, balls, and bars along which sliders move; `trail` is the path so far of "
     "the centre of mass of the body that the camera follows, or of every body that can move."},
    {"render.overlay",
     "Overlay of the pictures: the time, the spacing of the grid, the scales, the legend and "
     "letters. Without it they have none of these; what stands below the pictures on the sheet "
     "stays."},
    {"render.grid", "Lines for scale on water and ground."},
    {"render.pressure",
     "Colour scale of the pressure on the wet surface. With `none` bodies have their own colours "
     "under water, too, and no waterline but that of `show`."},
    {"render.pressure.shows",
     "Pressure that is shown. `hydrostatic` is ρ g h; under linear waves it is the pressure that "
     "the water would have without the body. `dynamic` is ½ ρ C_p v_n |v_n| with the speed v_n "
     "relative to the water along the normal. `total` is their sum."},
    {"render.pressure.colors",
     "Colour map. `turbo` and `thesis` go from blue over green to red; `viridis` and `cividis` "
     "have uniform steps of lightness; `coolwarm` is pale at zero in the middle, for values of "
     "either sign, and is the default if `shows` is `dynamic`; `gray` goes from dark to light."},
    {"render.pressure.min",
     "Lower end of the scale. A number fixes it across runs. `auto` finds it from the scene, "
     "whatever pictures are drawn; `drawn` finds it from the pressures in the pictures. With "
     "`coolwarm` an end that is not a number is the opposite of the other, so that zero is in the "
     "middle. Pressures beyond an end are striped with black below and with white above, as that "
     "end of the bar is."},
    {"render.pressure.max", "Upper end of the scale, as `min`."},
});

/// Blocks that occur in several places, and the place at which each is described.
constexpr auto kCopies = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"bodies[].hydro.", "hydro."},
     {"ground.heightfield.", "water.surface.heightfield."},
     {"ground.mesh.", "bodies[].mesh."},
     {"bodies[].shapes[].mesh", "bodies[].mesh"},
     {"bodies[].shapes[].box", "bodies[].box"},
     {"bodies[].shapes[].sphere", "bodies[].sphere"},
     {"bodies[].shapes[].icosphere", "bodies[].icosphere"},
     {"bodies[].shapes[].ellipsoid", "bodies[].ellipsoid"},
     {"bodies[].shapes[].cylinder", "bodies[].cylinder"},
     {"bodies[].shapes[].orientation.", "bodies[].orientation."},
     {"sails[].", "rudders[]."},
     {"render.cameras.NAME.", "render.camera."},
     {"render.cameras[].name", "render.cameras[].name"},
     {"render.cameras[].", "render.camera."}});

}  // namespace

std::string described_path(const std::string& path) {
  for (const auto& [copy, original] : kCopies)
    if (path.starts_with(copy)) return std::string(original) + path.substr(copy.size());
  return path;
}

std::vector<std::string> described_paths() {
  std::vector<std::string> paths;
  for (const Meaning& meaning : kMeanings) paths.emplace_back(meaning.path);
  for (const Meaning& meaning : body_meanings()) paths.emplace_back(meaning.path);
  for (const Meaning& meaning : rig_meanings()) paths.emplace_back(meaning.path);
  return paths;
}

std::string key_meaning(const std::string& path) {
  const std::string original = described_path(path);
  for (const std::span<const Meaning> some :
       {std::span<const Meaning>(kMeanings), body_meanings(), rig_meanings()})
    for (const Meaning& meaning : some)
      if (meaning.path == original) return std::string(meaning.text);
  throw std::out_of_range(path + " has no meaning");
}

}  // namespace scene
