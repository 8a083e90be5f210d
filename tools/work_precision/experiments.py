"""The scenes that the benchmark runs, what varies in them, and what is known of them exactly."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

import exact_motion
from trajectory_error import Path

kGravity = 9.80665  # m/s²
kLogEvery = 1 / 15  # s: a multiple of every step.


@dataclass(frozen=True)
class Mesh:
    triangles: int
    keys: dict  # Of the scene, that make this mesh.


@dataclass(frozen=True)
class Measured:
    """What the program says of a scene's only body before it moves; SI."""

    mass: float
    volume: float
    drag_at_unit_speed: float


@dataclass(frozen=True)
class Experiment:
    name: str
    title: str
    scene: str  # Below scenes/.
    smooth: bool  # Without impacts.
    length: float  # Of the trajectory's error [m].
    meshes: tuple[Mesh, ...]
    nominal: int  # Index of the mesh on which steps are compared.
    keys: dict = field(default_factory=dict)  # Of the scene, for every run.
    mesh_kind: str | None = None  # What finer meshes change: the shape, or only where it is cut.
    all_pairs: bool = False  # Every step on every mesh.
    exact: Callable[[np.ndarray, Measured | None], Path] | None = None  # On the mesh that is run.
    needs_probe: bool = False  # `exact` takes what the program says of the mesh.
    exact_shape: Callable[[np.ndarray], Path] | None = None  # Of the shape that meshes tend to.
    baseline: bool = True  # False: the plain method tends to another motion.


def icospheres(counts: range) -> tuple[Mesh, ...]:
    return tuple(Mesh(20 * 4**n, {"bodies[0].icosphere.subdivisions": n}) for n in counts)


def boxes(divisions: tuple[int, ...]) -> tuple[Mesh, ...]:
    return tuple(Mesh(12 * d * d, {"bodies[0].box.divisions": d}) for d in divisions)


def teapots() -> tuple[Mesh, ...]:
    files = {1240: "teapot_1k", 4898: "teapot", 19914: "teapot_20k"}
    return tuple(Mesh(count, {"bodies[0].mesh.file": f"meshes/{name}.obj"})
                 for count, name in files.items())


def heave(times: np.ndarray) -> Path:
    return exact_motion.heave_of_sphere(times, 0.5, 0.5, 0.2, kGravity)


def terminal_velocity_of_mesh(times: np.ndarray, body: Measured) -> Path:
    return exact_motion.sinking(times, -2, (body.mass - 1000 * body.volume) * kGravity,
                                body.drag_at_unit_speed, body.mass)


def terminal_velocity(times: np.ndarray) -> Path:
    """A sphere: half of its front, and half of its back, on C_p of 0.93 and 0.12."""
    volume = 4 / 3 * np.pi * 0.25**3
    drag = 0.5 * 1000 * (0.93 + 0.12) / 2 * np.pi * 0.25**2
    return exact_motion.sinking(times, -2, 1000 * volume * kGravity, drag, 2000 * volume)


def torque_free(times: np.ndarray, added_mass: tuple[float, ...]) -> Path:
    inertia = np.diag([1570.796327] * 3 + [255.2544031, 392.6990817, 490.8738521])
    return exact_motion.torque_free(times, inertia + np.diag(added_mass), np.array([0, 0, -40.0]),
                                    np.array([0.5, 0.2, 0.1]), np.array([0.3, 1.5, 0.2]))


kEllipsoidAdded = (420.7439653, 689.3626237, 1471.779569, 32.77642783, 117.6002340, 19.36849415)


def hinged_plate(times: np.ndarray, across: float, turning: float) -> Path:
    """With added mass across the plate and about the hinge's axis."""
    mass, volume, arm = 750.0, 0.3, 0.75
    inertia = mass / 12 * (0.2**2 + 1.5**2) + turning + (mass + across) * arm**2
    return exact_motion.pendulum(times, np.pi / 3, arm,
                                 (mass - 1000 * volume) * kGravity * arm / inertia,
                                 np.array([0, 0, -10.0]))


kExperiments = (
    Experiment("torque_free", "Torque-free body", "benchmark/torque_free.yaml",
               True, 1.0, (Mesh(320, {}),), 0, keys={"hydro.added_mass": "none"},
               exact=lambda times, body: torque_free(times, (0.0,) * 6)),
    Experiment("torque_free_in_fluid", "Torque-free body in fluid",
               "benchmark/torque_free.yaml", True, 1.0, (Mesh(320, {}),), 0,
               exact=lambda times, body: torque_free(times, kEllipsoidAdded), baseline=False),
    Experiment("heave", "Heave of a sphere", "benchmark/heave.yaml", True, 0.5,
               icospheres(range(1, 6)), 1, mesh_kind="shape", all_pairs=True, exact_shape=heave),
    Experiment("terminal_velocity", "Terminal velocity",
               "benchmark/terminal_velocity.yaml", True, 0.5, icospheres(range(1, 6)), 1,
               mesh_kind="shape", all_pairs=True, exact=terminal_velocity_of_mesh,
               needs_probe=True, exact_shape=terminal_velocity),
    Experiment("settling_cube", "Cube settling corner-up", "benchmark/settling_cube.yaml",
               True, 2.0, boxes((1, 3, 5, 10, 20, 41)), 1, mesh_kind="cut"),
    Experiment("barge_in_waves", "Barge in waves", "benchmark/barge_in_waves.yaml", True, 5.0,
               boxes((1, 3, 6, 12, 24, 41)), 4, mesh_kind="cut"),
    Experiment("hinged_plate", "Hinged plate",
               "benchmark/hinged_plate.yaml", True, 1.5, (Mesh(12, {}),), 0,
               keys={"hydro.added_mass": "none"},
               exact=lambda times, body: hinged_plate(times, 0, 0)),
    Experiment("hinged_plate_in_fluid", "Hinged plate, added mass",
               "benchmark/hinged_plate.yaml", True, 1.5, (Mesh(12, {}),), 0,
               exact=lambda times, body: hinged_plate(times, 600, 60), baseline=False),
    Experiment("teapot_drop", "Teapot drop", "teapot_drop.yaml", False, 1.0, teapots(), 0,
               keys={"hydro.added_mass": "none", "hydro.lift": False,
                     "hydro.pressure_drag": {"blunt": 0}}, mesh_kind="shape"),
    Experiment("colliding_crates", "Colliding crates", "benchmark/colliding_crates.yaml",
               False, 1.0, (Mesh(144, {}),), 0),
    Experiment("falling_heap", "Falling heap of buoys", "benchmark/falling_heap.yaml",
               False, 1.0, (Mesh(34560, {}),), 0, baseline=False),
)
