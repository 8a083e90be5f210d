"""Memory after very many simulations."""

import gc
import os

import plimsoll as pl
from conftest import TUG

BOX = {
    "plimsoll": 1,
    "duration": 1,
    "water": {"density": 1000, "surface": {"waves": [{"amplitude": 0.1, "wavelength": 5}]}},
    "bodies": [{"name": "box", "box": {"size": [1, 1, 1]}, "density": 500, "hydro": {"added_mass": "none", "radiation": "none"}}],
    "springs": [{"name": "s", "bodies": ["box", "world"], "points": [[0, 0, 0], [0, 0, 3]], "stiffness": 100}],
    "controls": [{"set": "springs[s].length", "formula": "3 + 0.1*sin(t)"}],
}


def resident():
    """Memory of this process [bytes]."""
    gc.collect()
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def cycle():
    sim = pl.Simulation(pl.Scene.load(BOX))
    position = sim.position
    sim.apply("box", force=[1, 0, 0])
    sim.step(2)
    sim.forces("box")
    sim.load(sim.save())
    sim.control["s"] = 2.5
    assert position[0, 2] != 0


def growth(cycle, warm, counted):
    """Memory that cycles keep once caches and allocators have what they want [bytes]."""
    for _ in range(warm):
        cycle()
    before = resident()
    for _ in range(counted):
        cycle()
    return resident() - before


def test_ten_thousand_simulations_leave_no_memory_behind():
    # A leak of a hundred bytes a simulation would show; allocators keep some pages.
    assert growth(cycle, 1000, 9000) < 9e5


def test_batches_and_their_errors_leave_no_memory_behind():
    def cycle():
        batch = pl.Batch(BOX, 4, threads=2, vary={"bodies[0].density": [300, 400, 500, 600]})
        batch.force[0] = 1e300
        batch.step(20)
        batch.reset(0)
        try:
            pl.Scene.load(BOX, set={"bodies[0].densty": 1})
        except pl.SceneError:
            pass

    assert growth(cycle, 300, 300) < 3e6


def test_logs_leave_no_memory_and_no_file_open(tmp_path):
    def cycle():
        with pl.Simulation(pl.Scene.load(TUG, set={"bodies[0].hydro.added_mass": "none", "bodies[1].hydro.added_mass": "none"})) as sim:
            sim.log_to(tmp_path / "run")
            sim.step(2)

    cycle()
    files = len(os.listdir("/proc/self/fd"))
    assert growth(cycle, 20, 200) < 3e6
    assert len(os.listdir("/proc/self/fd")) == files
