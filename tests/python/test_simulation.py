"""A simulation that Python steps."""

import gc
import math
import signal
import threading
import time

import numpy as np
import pytest

import plimsoll as pl
from conftest import BUOY, G, TUG, motions, sphere_volume, turned

DRY = {
    "plimsoll": 1,
    "duration": 1,
    "step": 0.01,
    "bodies": [{"name": "box", "box": {"size": [1, 2, 3]}, "mass": 12, "position": [0, 0, 10]}],
}


def test_steps_are_those_of_the_program_to_the_last_bit(tmp_path, tug, program):
    program("run", "scene.yaml", "--out", "out", "--no-render", "--quiet", scene=TUG, cwd=tmp_path)
    log = pl.read_log(tmp_path / "out")
    sim = pl.Simulation(tug)
    rows = list(np.round(log.time / 0.02).astype(int))
    for row, steps in enumerate(rows[:40]):
        sim.step(steps - sim.steps)
        assert sim.time == pytest.approx(log.time[row], abs=1e-12)
        assert np.array_equal(sim.position, log.position[row])
        assert np.array_equal(sim.orientation, log.orientation[row])
        assert np.array_equal(sim.velocity, log.velocity[row])
        assert np.array_equal(sim.angular_velocity, log.angular_velocity[row])


def test_steps_one_by_one_are_those_of_one_call(tug):
    one, many = pl.Simulation(tug), pl.Simulation(tug, threads=2)
    for _ in range(50):
        one.step()
    many.step(50)
    assert motions(one) == motions(many)
    assert one.time == many.time == 1.0 and one.steps == 50


def test_forces_are_kept_without_a_change_of_the_motion(buoy):
    with_forces, without = pl.Simulation(buoy), pl.Simulation(buoy, forces=False)
    with_forces.step(100)
    without.step(100)
    assert motions(with_forces) == motions(without)
    with pytest.raises(ValueError, match="forces=False"):
        without.forces("buoy")


def test_arrays_are_live_and_read_only(buoy):
    sim = pl.Simulation(buoy)
    position = sim.position
    kept = position.copy()
    sim.step(10)
    assert sim.position is position and not np.array_equal(position, kept)
    with pytest.raises(ValueError):
        position[0, 0] = 1


def test_arrays_outlive_their_simulation(buoy):
    position = pl.Simulation(buoy).position
    gc.collect()
    assert position[0, 2] == pytest.approx(0.2)


def test_forces_are_those_of_archimedes(buoy):
    sim = pl.Simulation(buoy)
    sim.step(10)
    forces = sim.forces("buoy")
    assert forces["buoyancy"].shape == (6,)
    assert forces["buoyancy"][2] == pytest.approx(1000 * G * forces["displaced_volume"], rel=1e-12)
    assert forces["weight"][2] == pytest.approx(-500 * G * sphere_volume(0.5), rel=1e-12)


def test_a_held_force_acts_until_it_ends():
    # A step applies the impulse of the force and of the weight: v = (F/m − g) t to round-off.
    sim = pl.Simulation(DRY)
    sim.apply("box", force=[24, 0, 12 * G])
    sim.step(50)
    assert sim.velocity[0] == pytest.approx([2 * 0.5, 0, 0], abs=1e-12)
    sim.apply("box")
    sim.step(50)
    assert sim.velocity[0] == pytest.approx([1, 0, -G * 0.5], abs=1e-12)


def test_a_torque_turns_a_body():
    sim = pl.Simulation({**DRY, "gravity": 0})
    sim.apply("box", torque=[0, 0, 7])
    sim.step(10)
    inertia = 12 / 12 * (1 + 4)
    assert sim.angular_velocity[0] == pytest.approx([0, 0, 7 / inertia * 0.1], abs=1e-12)


def test_a_force_at_a_point_and_in_the_axes_of_the_body_is_the_force_and_its_moment():
    body = {**DRY["bodies"][0], "center_of_mass": [0, 0.5, 0], "inertia": [13, 10, 5, 0, 0, 0],
            "orientation": {"axis": [0, 0, 1], "angle_deg": 90}}
    scene = {**DRY, "gravity": 0, "bodies": [body]}
    at, whole = pl.Simulation(scene), pl.Simulation(scene)
    # Along the body's x, two metres along its y from the centre of mass: a moment about −z.
    at.apply("box", force=[3, 0, 0], at=[0, 2.5, 0], frame="body")
    whole.apply("box", force=[0, 3, 0], torque=[0, 0, -6])
    at.step()
    whole.step()
    assert at.velocity == pytest.approx(whole.velocity, abs=1e-14)
    assert at.angular_velocity == pytest.approx(whole.angular_velocity, abs=1e-14)
    assert whole.angular_velocity[0, 2] < 0


def test_wrong_loads_are_refused(buoy):
    sim = pl.Simulation(buoy)
    with pytest.raises(ValueError, match="force: expected three finite numbers"):
        sim.apply("buoy", force=[1, 2])
    with pytest.raises(ValueError, match="force: expected three finite numbers"):
        sim.apply("buoy", force=[1, 2, math.nan])
    with pytest.raises(ValueError, match="frame: found 'ship'"):
        sim.apply("buoy", force=[1, 2, 3], frame="ship")
    with pytest.raises(KeyError, match="did you mean buoy"):
        sim.apply("bouy", force=[1, 2, 3])
    with pytest.raises(IndexError):
        sim.apply(1, force=[1, 2, 3])
    with pytest.raises(TypeError):
        sim.apply(object(), force=[1, 2, 3])


def test_set_points_are_set_and_given_back(tug):
    sim = pl.Simulation(tug)
    control = sim.control
    assert list(control) == tug.set_points and len(control) == len(tug.set_points)
    assert control["propellers[main].speed_rps"] == 2 and "propellers[main].speed_rps" in control
    control["rudder"] = 7
    sim.step(200)
    assert control["rudders[rudder].angle_deg"] == 7
    assert sim.readings()["machines"]["rudders[rudder]"]["angle_deg"] == pytest.approx(7)
    del control["rudder"]
    sim.step(100)
    assert control["rudder"] != 7
    with pytest.raises(KeyError, match="did you mean"):
        control["rudders[ruder].angle_deg"]
    with pytest.raises(KeyError, match="several set points"):
        control["main"]
    with pytest.raises(ValueError, match="not finite"):
        control["rudder"] = math.inf


def test_a_screw_that_is_set_ahead_drives_the_tug(tug):
    fast, slow = pl.Simulation(tug), pl.Simulation(tug)
    fast.control["propellers[main].speed_rps"] = 4
    slow.control["propellers[main].speed_rps"] = 0
    fast.step(500)
    slow.step(500)
    i = fast.index("tug")
    assert fast.position[i, 0] > slow.position[i, 0] + 2


def test_forces_and_readings_are_those_of_the_logs(tmp_path, tug):
    sim = pl.Simulation(tug)
    with sim:
        sim.log_to(tmp_path / "run")
        sim.step(50)
    log = pl.read_log(tmp_path / "run")
    for body in ("tug", "barge"):
        now, logged = sim.forces(body), log.body(body).forces
        assert set(now) == set(logged)
        for load, value in now.items():
            assert np.array_equal(value, logged[load][-1]), load
    readings = sim.readings()
    for table, names in readings.items():
        if table == "joints":
            continue
        for name, columns in names.items():
            for column, value in columns.items():
                assert np.array_equal(value, log.tables[table][name][column][-1], equal_nan=True)
    assert readings["lines"]["ropes[tow]"]["tension"] >= 0


def test_a_saved_state_goes_on_to_the_same_bits(tug):
    sim = pl.Simulation(tug)
    sim.step(30)
    sim.apply("barge", force=[0, 2000, 0], at=[3, 0, 0], frame="body")
    sim.control["rudder"] = -5
    state = sim.save()
    sim.step(60)
    end = motions(sim)
    sim.load(state)
    assert sim.steps == 30
    sim.step(60)
    assert motions(sim) == end
    other = pl.Simulation(tug, threads=2)
    other.load(state)
    other.step(60)
    assert motions(other) == end


def test_a_state_that_is_none_is_refused(tug, buoy):
    sim = pl.Simulation(buoy)
    for state in (b"", b"nonsense", sim.save()[:-5], pl.Simulation(tug).save()):
        with pytest.raises(ValueError):
            sim.load(state)
    sim.step()


def test_reset_goes_back_to_the_start(tug):
    sim = pl.Simulation(tug)
    start = motions(sim)
    sim.apply("tug", force=[1e5, 0, 0])
    sim.step(20)
    once = motions(sim)
    sim.reset()
    assert motions(sim) == start and sim.time == 0
    sim.step(20)
    assert motions(sim) != once  # the load has ended


def test_a_body_is_put_elsewhere(buoy):
    sim = pl.Simulation(buoy)
    sim.set_motion("buoy", position=[1, 2, 3], orientation=turned([0, 1, 1], 0.7), velocity=[4, 5, 6],
                   angular_velocity=[7, 8, 9])
    assert sim.position[0] == pytest.approx([1, 2, 3])
    assert sim.orientation[0] == pytest.approx(turned([0, 1, 1], 0.7))
    assert sim.velocity[0] == pytest.approx([4, 5, 6])
    assert sim.angular_velocity[0] == pytest.approx([7, 8, 9])
    sim.set_motion(0, velocity=[0, 0, 0])
    assert sim.angular_velocity[0] == pytest.approx([7, 8, 9])
    with pytest.raises(ValueError):
        sim.set_motion(0, orientation=[0, 0, 0, 0])


def test_a_simulation_that_breaks_down_says_when_and_why():
    sim = pl.Simulation(DRY)
    sim.step(3)
    sim.apply("box", force=[1e300, 0, 0])
    with pytest.raises(pl.SimulationError) as caught:
        sim.step(1000)
    assert caught.value.body == "box" and caught.value.time >= 0.02
    assert np.isfinite(sim.position).all()
    with pytest.raises(pl.SimulationError):
        sim.step()
    sim.reset()
    sim.step()


def test_a_negative_number_of_steps_is_refused(buoy):
    with pytest.raises(ValueError):
        pl.Simulation(buoy).step(-1)


def test_ctrl_c_ends_a_long_call(buoy):
    sim = pl.Simulation(buoy)
    threading.Timer(0.2, lambda: signal.raise_signal(signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        sim.step(10**9)
    steps = sim.steps
    assert 0 < steps < 10**9
    sim.step()
    assert sim.steps == steps + 1


def test_python_runs_on_while_a_simulation_steps(buoy):
    sim = pl.Simulation(buoy)
    thread = threading.Thread(target=sim.step, args=(20000,))
    thread.start()
    turns = 0
    while thread.is_alive():
        turns += 1
        time.sleep(1e-4)
    thread.join()
    assert turns > 2 and sim.steps == 20000


def test_calls_from_several_threads_take_turns(buoy):
    sim = pl.Simulation(buoy)
    alone = pl.Simulation(buoy)
    alone.step(4 * 500)
    threads = [threading.Thread(target=sim.step, args=(500,)) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert motions(sim) == motions(alone)


@pytest.mark.parametrize("format", ["csv", "hdf5"])
def test_a_log_is_that_of_a_run(tmp_path, tug, program, format):
    if format == "hdf5":
        pytest.importorskip("h5py")
    program("run", "scene.yaml", "--out", "run", "--no-render", "--quiet", "--format", format,
            "--set", "duration=2", scene=TUG, cwd=tmp_path)
    sim = pl.Simulation(tug)
    try:
        sim.log_to(tmp_path / "own", format=format)
    except ValueError as error:
        pytest.skip(str(error))
    sim.step(100)
    sim.close_log()
    names = ["run.h5"] if format == "hdf5" else ["trajectory.csv", "forces.csv", "lines.csv", "machines.csv", "controls.csv"]
    run, own = pl.read_log(tmp_path / "run"), pl.read_log(tmp_path / "own")
    assert np.array_equal(run.position, own.position) and list(run.tables) == list(own.tables)
    if format == "csv":
        for name in names:
            assert (tmp_path / "own" / name).read_bytes() == (tmp_path / "run" / name).read_bytes()
    assert (tmp_path / "own/summary.json").exists()
    program("report", "own", cwd=tmp_path, allowed=(0, 2))


def test_a_folder_in_use_is_refused(tmp_path, buoy):
    one, other = pl.Simulation(buoy), pl.Simulation(buoy)
    one.log_to(tmp_path / "run")
    with pytest.raises(pl.SceneError, match="another run is writing"):
        other.log_to(tmp_path / "run")
    one.close_log()
    other.log_to(tmp_path / "run")


def test_a_picture_is_an_array(buoy):
    sim = pl.Simulation(buoy)
    try:
        picture = sim.render(size=(160, 120))
    except pl.RenderError as error:
        pytest.skip(str(error))
    assert picture.shape == (120, 160, 3) and picture.dtype == np.uint8
    assert picture.std() > 5  # it is no plain colour
    near = sim.render(camera={"from": [1, -2, 1], "to": [0, 0, 0]}, size=(160, 120))
    assert not np.array_equal(near, picture)
    with pytest.raises(KeyError):
        sim.render(camera="none of this name")
    with pytest.raises(pl.SceneError, match="fov"):
        sim.render(camera={"from": [1, -2, 1], "to": [0, 0, 0], "fov": 3})
