"""What no Python code may do is end the process by a signal: threads that Python's end overtakes, and objects
whose __init__ was not called."""

import subprocess
import sys

import pytest

import plimsoll as pl

from conftest import BUOY


def ended(code):
    """Runs code in a process of its own."""
    return subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True)


STEPPING = f"""
import threading
import plimsoll as pl

sim = pl.Simulation({BUOY!r})
begun = threading.Event()

def step():
    while True:
        begun.set()
        sim.step(COUNT)

for _ in range(3):
    threading.Thread(target=step, daemon=True).start()
begun.wait()
"""


@pytest.mark.parametrize("count", ["1", "100", "10**9"])
def test_a_daemon_thread_that_steps_does_not_hinder_the_end(count):
    for _ in range(3):
        done = ended(STEPPING.replace("COUNT", count))
        assert (done.returncode, done.stderr) == (0, "")


def test_a_daemon_thread_of_a_batch_does_not_hinder_the_end():
    code = STEPPING.replace("pl.Simulation(", "pl.Batch(n=2, threads=2, scene=").replace("COUNT", "10**9")
    done = ended(code)
    assert (done.returncode, done.stderr) == (0, "")


def test_work_at_the_end_itself_is_done():
    done = ended(f"""
import atexit
import plimsoll as pl
sim = pl.Simulation({BUOY!r})

class AtEnd:
    def __del__(self):
        sim.step(2)
        print(sim.steps)

atexit.register(lambda: (sim.step(3), print(sim.steps)))
kept = AtEnd()
""")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.split() == ["3", "5"]


def test_a_forked_process_does_not_wait_for_the_work_of_its_parent():
    done = ended(STEPPING.replace("COUNT", "10**9") + """
import os, sys
child = os.fork()
if child == 0:
    sys.exit(7)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
""")
    assert (done.returncode, done.stdout) == (0, "7\n")


def test_a_method_of_an_object_without_init_raises():
    for cls in (pl.Batch, pl.Simulation):
        with pytest.raises(TypeError):
            cls.__new__(cls).step()
        with pytest.raises(TypeError):
            cls.__new__(cls).time
    with pytest.raises(TypeError):
        pl.Simulation(pl.Scene.__new__(pl.Scene))
    with pytest.raises(TypeError):
        pl.Mesh.__new__(pl.Mesh).volume


def test_no_use_of_an_object_without_init_ends_the_process():
    done = ended("""
import pickle
import plimsoll as pl

own = ("__len__", "__iter__", "__repr__", "__str__", "__getstate__", "__enter__", "__exit__", "__contains__",
       "__getitem__", "__setitem__", "__delitem__")
arguments = ((), (0,), ("a",), (None, None, None), (0, 0), ("a", 1.0), (0, b""))
classes = (pl.Batch, pl.Control, pl.Fault, pl.Mesh, pl.Scene, pl.Simulation)
raised = 0
for cls in classes:
    for name in dir(cls):
        if name.startswith("__") and name not in own:
            continue
        for given in arguments:
            try:
                member = getattr(cls.__new__(cls), name)
                if callable(member):
                    member(*given)
            except Exception:
                raised += 1
    for call in (pl.Simulation, pl.Batch, pl.Scene.load, pl.loads, pl.added_mass, pl.radiation, pl.hydrostatics,
                 pickle.dumps, lambda blank: pl.Batch(blank, 2), lambda blank: pl.hydrostatics(blank, 1.0)):
        try:
            call(cls.__new__(cls))
        except Exception:
            raised += 1
print(raised)
""")
    assert (done.returncode, done.stderr) == (0, "")
    assert int(done.stdout) > 100
