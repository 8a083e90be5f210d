import math
from pathlib import Path

import pytest

import plimsoll as pl

ROOT = Path(__file__).resolve().parents[2]

BUOY = {
    "plimsoll": 1,
    "duration": 5,
    "step": 0.01,
    "water": {"density": 1000},
    "bodies": [
        {
            "name": "buoy",
            "sphere": {"radius": 0.5, "slices": 16, "stacks": 8},
            "density": 500,
            "position": [0, 0, 0.2],
            "hydro": {"radiation": "none"},
        }
    ],
}

# A tug with a screw and a rudder that steers by its heading, and a barge on a line, in waves.
TUG = {
    "plimsoll": 1,
    "duration": 20,
    "step": 0.02,
    "water": {"density": 1025, "surface": {"waves": [{"amplitude": 0.2, "wavelength": 20}]}},
    "bodies": [
        {"name": "tug", "box": {"size": [8, 3, 2]}, "mass": 24000},
        {"name": "barge", "box": {"size": [12, 5, 2]}, "mass": 60000, "position": [-24, 0, 0]},
    ],
    "ropes": [
        {"name": "tow", "bodies": ["tug", "barge"], "points": [[-4, 0, 1], [6, 0, 1]],
         "length": 14.5, "stiffness": 1e5, "damping": 1e4}
    ],
    "propellers": [
        {"name": "main", "body": "tug", "at": [-4, 0, -1], "diameter": 1.4, "speed_rps": 2,
         "model": {"wageningen": {"blades": 4, "area_ratio": 0.7, "pitch_ratio": 1}}}
    ],
    "rudders": [
        {"name": "rudder", "body": "tug", "at": [-4.8, 0, -1], "span": 1.4, "chord": 1, "behind": "main"}
    ],
    "controls": [
        {"set": "rudders[rudder].angle_deg", "rate": 10,
         "pid": {"of": "tug.heading_deg", "target": "20", "kp": 2, "kd": 5, "limits": [-35, 35]}}
    ],
    "log": {"every": 0.1, "forces": True},
}

G = 9.80665


@pytest.fixture
def buoy():
    return pl.Scene.load(BUOY)


@pytest.fixture(scope="session")
def tug():
    return pl.Scene.load(TUG)


def motions(sim):
    """All arrays of a simulation as bytes, for comparisons to the last bit."""
    arrays = (sim.position, sim.orientation, sim.velocity, sim.angular_velocity)
    return b"".join(a.tobytes() for a in arrays)


def sphere_volume(radius, slices=16, stacks=8):
    return pl.Mesh.sphere(radius, slices, stacks).volume


def turned(axis, angle):
    """The quaternion w, x, y, z of a rotation."""
    s = math.sin(angle / 2) / math.hypot(*axis)
    return [math.cos(angle / 2), *(s * a for a in axis)]


@pytest.fixture(scope="session")
def program():
    """Run the built program: program("run", …, scene=dict, cwd=folder)."""
    import json
    import os
    import subprocess

    def run(*arguments, scene=None, cwd, allowed=(0,)):
        if scene is not None:
            (Path(cwd) / "scene.yaml").write_text(json.dumps(scene))
        done = subprocess.run([os.environ["PLIMSOLL_PROGRAM"], *arguments], cwd=cwd, capture_output=True, text=True)
        assert done.returncode in allowed, done.stderr
        return done

    return run
