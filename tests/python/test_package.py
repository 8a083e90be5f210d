"""The module as it is installed: by CMake, and as a wheel."""

import os
import subprocess
import sys
import venv
from pathlib import Path

import pytest

from conftest import ROOT

SCRIPT = """
import numpy as np, plimsoll as pl
scene = pl.Scene.load({"plimsoll": 1, "duration": 1, "water": {"density": 1000},
                       "bodies": [{"name": "a", "box": {"size": [1, 1, 1]}, "density": 500,
                                   "hydro": {"added_mass": "none"}}]})
sim = pl.Simulation(scene)
sim.step(10)
try:
    assert sim.render(size=(80, 60)).std() > 1
except pl.RenderError as error:
    assert "shader" not in str(error), error
print(pl.__file__, sim.time)
"""


def python_of(folder):
    """A clean virtual environment; NumPy comes from the system."""
    venv.create(folder, system_site_packages=True, symlinks=True)
    return folder / "bin/python"


def works(python, site, tmp_path):
    environment = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH",)}
    environment["PYTHONPATH"] = str(site) if site else ""
    done = subprocess.run([python, "-B", "-c", SCRIPT], capture_output=True, text=True, cwd=tmp_path, env=environment)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_an_installation_that_was_moved_works(tmp_path):
    subprocess.run(["cmake", "--install", os.environ["PLIMSOLL_BUILD"], "--component", "python",
                    "--prefix", tmp_path / "first"], check=True, capture_output=True)
    (tmp_path / "first").rename(tmp_path / "moved")
    (site,) = (tmp_path / "moved").glob("lib/python*/site-packages")
    assert (site / "plimsoll/share/shaders").is_dir() and (site / "plimsoll/_core.pyi").exists()
    assert str(tmp_path / "moved") in works(python_of(tmp_path / "env"), site, tmp_path)


def test_a_wheel_works_in_a_clean_environment(tmp_path):
    pytest.importorskip("scikit_build_core")
    pytest.importorskip("pip")
    subprocess.run([sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps", "--wheel-dir",
                    tmp_path, ROOT], check=True)
    (wheel,) = tmp_path.glob("plimsoll-*.whl")
    python = python_of(tmp_path / "env")
    subprocess.run([python, "-m", "pip", "install", "--no-deps", "--no-index", wheel], check=True)
    assert str(tmp_path / "env") in works(python, None, tmp_path)


def test_help_tells_shapes_and_units():
    import plimsoll as pl

    assert "(N, 3): the centres of mass, in W [m]" in pl.Simulation.position.__doc__
    assert "force (3,) [N]" in pl.Simulation.apply.__doc__
