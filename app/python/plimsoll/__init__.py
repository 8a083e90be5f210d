"""Plimsoll from Python: load a scene, step it, drive it, run a thousand of it.

    import plimsoll as pl
    sim = pl.Simulation("scenes/teapot_drop.yaml")
    sim.step(60)
    print(sim.time, sim.position[sim.index("teapot")])

Quantities are in SI units. The world W has z up; a quaternion is w, x, y, z. `Scene.load` reads a
scene, `Simulation` steps it, `Batch` steps many at once, `Env` and `VectorEnv` make environments of
Gymnasium of them; `loads`, `added_mass`, `radiation` and `hydrostatics` compute without one;
`read_log` and `read_sweep` read what the program wrote.
"""

from plimsoll._core import (
    Batch,
    Control,
    Fault,
    Mesh,
    RenderError,
    Scene,
    SceneError,
    Simulation,
    SimulationError,
    __version__,
    added_mass,
    hydrostatics,
    loads,
    radiation,
)
from plimsoll.gym import Env, VectorEnv
from plimsoll.logs import BodyLog, Log, read_log
from plimsoll.sweeps import Sweep, read_sweep

__all__ = [
    "Batch",
    "BodyLog",
    "Control",
    "Env",
    "Fault",
    "Log",
    "Mesh",
    "RenderError",
    "Scene",
    "SceneError",
    "Simulation",
    "SimulationError",
    "Sweep",
    "VectorEnv",
    "__version__",
    "added_mass",
    "hydrostatics",
    "loads",
    "radiation",
    "read_log",
    "read_sweep",
]
