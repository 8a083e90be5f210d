"""How the picture of each task of scenes/GUIDE.md is drawn."""
from __future__ import annotations

import guide_plots as plots
from guide_frames import choices_of_radiation, film, frame, frame_of_scene, frame_of_text, page, verdicts
from guide_work import kRoot

kCrate = str(kRoot / "tests/install/crate/crate.yaml")  # The scene of the program in C++.

# The half of a hull and the solid that the task makes of it.
kMended = """
plimsoll: 1
duration: 1
gravity: 0
bodies:
  - {name: half, mesh: {file: scenes/meshes/landing_craft_half.obj, weld: 0.01, thickness: 0.06}, mass: 1000,
     position: [0, 3.6, 0], color: [0.78, 0.33, 0.24]}
  - {name: solid, mesh: {file: solid.obj}, mass: 1000, color: [0.2, 0.48, 0.62]}
"""

kPictures = {
    "launch": frame_of_scene("launch.yaml", 2, "{from: [5.5, -6.5, 2.9], to: [0, 0, 0.15], fov_deg: 27}"),
    "mend": frame_of_text(kMended, 1, "{from: [9, -9, 9], to: [0, 1.6, 0.3], fov_deg: 33}"),
    "gz": plots.righting_arms,
    "densities": plots.densities,
    "shapes": frame_of_scene("scenes/catamaran.yaml", 5,
                             "{from: [-5, -6.5, 3.6], to: [0.1, 0, 0.2], fov_deg: 31, follow: catamaran}"),
    "pile": plots.pile,
    "flooding": frame("out/damaged_barge", 30, "{from: [10, -13, 6], to: [0, 0, -0.3], fov_deg: 33}",
                      "render.pressure={min: 0, max: 30000}"),
    "calibrate": plots.calibrated,
    "spectrum": plots.spectrum,
    "gauge": plots.gauge,
    "current": frame("out/adrift_in_gale", 20, "{from: [-2, -40, 14], to: [13, 2, -3], fov_deg: 31}",
                     "render.show=[trail]"),
    "beach": frame("out/beach", 2, "{from: [15, -9, 5], to: [18.6, 0, 0.8], fov_deg: 38}"),
    "rings": frame("out/teapot_drop", 2.4, "{from: [4.6, -8, 3], to: [0, 0.3, 0.1], fov_deg: 30}",
                   "render.pressure={min: 0, max: 14000}"),
    "abreast": frame("out/two_barges_abreast", 20, "{from: [-17, -13, 8.5], to: [0, 0, 0], fov_deg: 31}"),
    "radiation": choices_of_radiation,
    "tow": plots.towed,
    "resistance": plots.resistance,
    "autopilot": plots.autopilot,
    "winch": frame("out/crane_winch", 10, "{from: [22, -19, 8], to: [3.5, 3, 3.4], fov_deg: 29}"),
    "moorings": plots.tensions,
    "motor": frame("out/motorised_gate", 12, "{from: [-12.5, -4.5, 7], to: [0.3, 0, -1], fov_deg: 38}"),
    "pto": plots.power,
    "decay": plots.decay,
    "rao": plots.operators,
    "sweep": plots.swept,
    "golden": verdicts,
    "step": plots.steps,
    "faster": plots.costs,
    "restart": plots.resumed,
    "hdf5": plots.sizes,
    "video": film("out/barge_in_swell", (2, 8, 14, 20),
                  "{from: [20, -27, 9], to: [0, 0, 1], fov_deg: 26, follow: barge, orbit: 10}",
                  "render.show=[forces, waterline]"),
    "report": page("out/hinged_gate/report.html"),
    "imu": plots.sensors,
    "batch": plots.batch,
    "library": frame_of_scene(kCrate, 2, "{from: [2.2, -2.8, 1.3], to: [0, 0, 0.05], fov_deg: 24}",
                              "bodies[crate].density=300"),
}
