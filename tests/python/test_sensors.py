"""Probes as instruments, and observations by name, of a simulation and of a batch."""

import math

import numpy as np
import pytest

import plimsoll as pl
from conftest import BUOY, G, TUG

# A crate in the air that is thrown with a spin, and one that waves carry, with an instrument each.
IMU = {
    "plimsoll": 1,
    "duration": 5,
    "step": 0.01,
    "water": {"density": 1000, "surface": {"waves": [{"amplitude": 0.1, "period": 2}]}},
    "bodies": [
        {"name": "thrown", "box": {"size": [1, 0.6, 0.4]}, "density": 800, "position": [20, 0, 60],
         "linear_velocity": [3, 0, 2], "angular_velocity": [0, 0, 0.5], "orientation": {"euler_deg": [10, 20, 30]},
         "hydro": {"added_mass": "none", "radiation": "none"}},
        {"name": "raft", "box": {"size": [1, 1, 0.4]}, "density": 500, "position": [0, 0, 0],
         "hydro": {"added_mass": "none", "radiation": "none"}},
    ],
    "log": {"probes": [{"name": "imu", "body": "thrown", "at": [0.4, 0.1, 0]},
                       {"name": "deck", "body": "raft", "at": [0, 0, 0.2]},
                       {"name": "gauge", "wave": [2, 1]},
                       {"name": "current", "wave": [2, 1], "depth": 0.5}]},
}
BOARD = ("elevation x y z vx vy vz ax ay az wx wy wz specific_x specific_y specific_z").split()


def vector(reading, *names):
    return np.array([reading[name] for name in names])


def rotation(q):
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def test_a_body_in_free_fall_feels_no_force_at_its_centre_of_mass():
    scene = {**IMU, "log": {"probes": [{"name": "imu", "body": "thrown", "at": [0, 0, 0]}]}}
    sim = pl.Simulation(scene)
    sim.step(20)
    reading = sim.readings()["probes"]["imu"]
    assert list(reading) == BOARD
    # The air does nothing here: g is left to 1e-10 of it, as the solution of the step is.
    assert vector(reading, "specific_x", "specific_y", "specific_z") == pytest.approx(np.zeros(3), abs=1e-9)
    spin = rotation(sim.orientation[0]).T @ sim.angular_velocity[0]
    assert vector(reading, "wx", "wy", "wz") == pytest.approx(spin, abs=1e-14)


def test_readings_are_in_the_axes_of_the_body():
    sim = pl.Simulation(IMU)
    sim.step(30)
    before = sim.save()
    point = np.array([0.4, 0.1, 0])  # The centre of mass of a box is the origin of its mesh.

    def motion():
        """Velocity and centripetal acceleration of the point, spin, and arm of the point."""
        r, w = rotation(sim.orientation[0]) @ point, sim.angular_velocity[0].copy()
        return sim.velocity[0] + np.cross(w, r), np.cross(w, np.cross(w, r)), w, r

    v0, inward0, w0, r0 = motion()
    sim.step()
    R, (v1, inward1, w1, r1) = rotation(sim.orientation[0]), motion()
    reading = sim.readings()["probes"]["imu"]
    assert vector(reading, "x", "y", "z") == pytest.approx(sim.position[0] + R @ point, abs=1e-12)
    assert vector(reading, "vx", "vy", "vz") == pytest.approx(R.T @ v1, abs=1e-12)
    # Differences of 3 m/s over 0.01 s.
    acceleration = R.T @ (v1 - v0) / 0.01
    assert vector(reading, "ax", "ay", "az") == pytest.approx(acceleration, abs=1e-11)
    specific = acceleration + R.T @ np.array([0, 0, G])
    assert vector(reading, "specific_x", "specific_y", "specific_z") == pytest.approx(specific, abs=1e-11)
    # Only the turn about the centre of mass is felt, to the square of the angle in a step, 2.5e-5.
    turn = np.cross((w1 - w0) / 0.01, (r0 + r1) / 2) + (inward0 + inward1) / 2
    assert specific == pytest.approx(R.T @ turn, abs=1e-5) and np.linalg.norm(turn) > 0.05
    kept = sim.readings()
    sim.load(before)
    sim.step()
    assert sim.readings() == kept


def test_a_state_holds_the_last_step_for_accelerations():
    sim = pl.Simulation(IMU)
    sim.step(7)
    kept, state = sim.readings()["probes"]["deck"], sim.save()
    sim.step(9)
    sim.load(state)
    assert sim.readings()["probes"]["deck"] == kept
    other = pl.Simulation(IMU)
    other.load(state)
    assert other.readings()["probes"]["deck"] == kept
    with pytest.raises(ValueError, match="another scene"):
        pl.Simulation({**IMU, "log": {}}).load(state)


def test_a_body_is_not_accelerated_before_the_first_step_and_after_a_jump():
    sim = pl.Simulation(IMU)
    at_rest = vector(sim.readings()["probes"]["deck"], "specific_x", "specific_y", "specific_z")
    assert at_rest == pytest.approx([0, 0, G], abs=1e-12)
    sim.step(5)
    sim.set_motion("raft", velocity=[50, 0, 0])
    assert sim.readings()["probes"]["deck"]["ax"] == 0
    sim.step(5)
    sim.reset()
    assert sim.readings()["probes"]["deck"]["az"] == 0


def test_gauges_read_waves_as_the_log_does(tmp_path):
    scene = {**IMU, "log": {**IMU["log"], "every": 0.1}}
    sim = pl.Simulation(scene)
    with sim:
        sim.log_to(tmp_path / "run")
        sim.step(20)
    logged = pl.read_log(tmp_path / "run").tables["probes"]
    probes = sim.readings()["probes"]
    assert list(probes["gauge"]) == BOARD[:4] and list(probes["current"]) == BOARD[:10]
    for name in ("gauge", "current"):
        for column, value in probes[name].items():
            assert value == logged[name][column][-1], (name, column)
    assert probes["deck"]["elevation"] == logged["deck"]["elevation"][-1]
    assert math.isclose(probes["gauge"]["z"], probes["gauge"]["elevation"], abs_tol=1e-15)


def test_observations_have_the_units_of_their_names():
    sim = pl.Simulation(TUG)
    sim.step(40)
    readings = sim.readings()
    names = ["tug.x", "tug.heading_deg", "tug.speed", "tug.turn_rate_deg", "barge.z", "ropes[tow].tension",
             "propellers[main].thrust", "rudders[rudder].angle_deg", "rudders[rudder].attack_deg"]
    seen = dict(zip(names, sim.observe(names)))
    R = rotation(sim.orientation[0])
    assert seen["tug.x"] == sim.position[0, 0] and seen["barge.z"] == sim.position[1, 2]
    assert seen["tug.heading_deg"] == pytest.approx(math.degrees(math.atan2(R[1, 0], R[0, 0])), abs=1e-12)
    assert seen["tug.speed"] == pytest.approx(R[:, 0] @ sim.velocity[0], abs=1e-12)
    assert seen["tug.turn_rate_deg"] == pytest.approx(math.degrees(sim.angular_velocity[0, 2]), rel=1e-12)
    assert seen["ropes[tow].tension"] == readings["lines"]["ropes[tow]"]["tension"]
    assert seen["propellers[main].thrust"] == readings["machines"]["propellers[main]"]["thrust"]
    assert seen["rudders[rudder].attack_deg"] == readings["machines"]["rudders[rudder]"]["attack_deg"]
    assert set(names) <= set(sim.observables)
    # Numbers that a rudder does not have are no observables, and each observable is a number, once.
    assert "rudders[rudder].thrust" not in sim.observables
    assert np.isfinite(sim.observe(sim.observables)).all()
    assert len(set(sim.observables)) == len(sim.observables)


def test_joints_have_their_angles_in_degrees():
    scene = {**BUOY, "water": {}, "joints": [{"name": "arm", "type": "hinge", "bodies": ["world", "buoy"],
                                              "anchor": [1, 0, 0.2], "axis": [0, 1, 0]}]}
    sim = pl.Simulation(scene)
    sim.step(30)
    angle, coordinate, effort = sim.observe(["joints[arm].angle_deg", "joints[arm].coordinate", "joints[arm].effort"])
    assert angle == pytest.approx(math.degrees(coordinate), rel=1e-14) and abs(angle) > 0.1
    assert effort == sim.readings()["joints"]["arm"]["effort"]


def test_bodies_have_the_columns_of_their_trajectory():
    sim = pl.Simulation(TUG)
    sim.step(5)
    for body in ("tug", "barge"):
        i = sim.index(body)
        row = np.concatenate([sim.position[i], sim.orientation[i], sim.velocity[i], sim.angular_velocity[i]])
        names = "x y z qw qx qy qz vx vy vz wx wy wz".split()
        assert np.array_equal(sim.observe([f"{body}.{name}" for name in names]), row)


def test_an_unknown_name_is_told_with_the_nearest():
    sim = pl.Simulation(TUG)
    with pytest.raises(KeyError, match="did you mean tug.heading_deg"):
        sim.observe(["tug.heading_dge"])
    with pytest.raises(KeyError, match="did you mean"):
        pl.Batch(TUG, 2, observe=["barge.zz"])


def test_a_batch_observes_what_its_simulations_would():
    names = ["thrown.z", "probes[deck].specific_z", "probes[gauge].elevation", "probes[current].vx"]
    batch = pl.Batch(IMU, 3, threads=2, observe=names, vary={"bodies[raft].density": [300, 500, 700]})
    assert batch.observed == names and batch.observation.shape == (3, 4)
    for take in range(3):
        batch.step(take)
        for i, density in enumerate([300, 500, 700]):
            alone = pl.Simulation(pl.Scene(IMU, set={"bodies[raft].density": density}))
            alone.step(round(batch.time[0] / 0.01))
            assert np.array_equal(batch.observation[i], alone.observe(names)), (take, i)
    batch.set_motion(1, "thrown", position=[0, 0, 80])
    assert batch.observation[1, 0] == 80
    batch.reset(1)
    assert batch.observation[1, 0] == 60 and batch.observation[0, 0] < 60.1
    with pytest.raises(ValueError):
        batch.observation[0, 0] = 1


def test_a_reset_with_other_values_is_another_scene():
    sea = {"water": {"surface": {"spectrum": {"type": "jonswap", "significant_height": 0.2, "peak_period": 2,
                                              "components": 5, "seed": 1}}}}
    scene = {**IMU, **sea}
    names = ["probes[gauge].elevation", "raft.z"]
    batch = pl.Batch(scene, 3, threads=2, observe=names)
    batch.step(10)
    batch.control[:] = np.nan
    batch.force[1, 0, 0] = 5
    kept = batch.observation[0].copy()
    batch.reset([1, 2], vary={"water.surface.spectrum.seed": [7, 8],
                              "water.surface.spectrum.significant_height": [0.1, 0.2]})
    assert list(batch.time) == pytest.approx([0.1, 0, 0]) and not batch.force.any()
    assert np.array_equal(batch.observation[0], kept)
    batch.step(10, which=[1, 2])
    for i, seed, height in ((1, 7, 0.1), (2, 8, 0.2)):
        alone = pl.Simulation(pl.Scene(scene, set={"water.surface.spectrum.seed": seed,
                                                   "water.surface.spectrum.significant_height": height}))
        alone.step(10)
        assert np.array_equal(batch.observation[i], alone.observe(names))
        assert np.array_equal(batch.position[i], alone.position)
    seen = batch.observation[1].copy()
    batch.reset(1)  # A reset without values begins the same sea again.
    batch.step(10, which=1)
    assert np.array_equal(batch.observation[1], seen)


def test_values_of_a_reset_go_to_the_simulations_in_their_order():
    batch = pl.Batch(IMU, 4, observe=["raft.z"])
    batch.reset([3, 1], vary={"bodies[raft].position": [[0, 0, 3], [0, 0, 1]]})
    assert list(batch.observation[:, 0]) == [0, 1, 0, 3]


def test_a_failed_step_leaves_the_readings_as_they_were():
    sim = pl.Simulation(IMU)
    sim.step(5)
    kept, state = sim.readings(), sim.save()
    sim.apply("thrown", force=[1e300, 0, 0])
    with pytest.raises(pl.SimulationError):
        sim.step()
    assert sim.readings() == kept and sim.readings()["probes"]["imu"]["az"] != 0
    sim.load(state)
    assert sim.readings() == kept


def test_a_batch_that_refuses_a_state_keeps_its_own():
    batch, sim = pl.Batch(IMU, 1, observe=["raft.z"]), pl.Simulation(IMU)
    sim.step(20)
    sim.apply("raft", force=[0, 0, 9], at=[0.3, 0, 0])
    kept = batch.position.copy(), batch.observation.copy()
    with pytest.raises(ValueError, match="centre of mass"):
        batch.load(0, sim.save())
    assert np.array_equal(batch.position, kept[0]) and np.array_equal(batch.observation, kept[1])


def test_the_first_simulation_of_a_scene_lets_other_threads_run(tmp_path, monkeypatch):
    import threading
    import time

    scene = {**BUOY, "bodies": [{"name": "buoy", "icosphere": {"radius": 1, "subdivisions": 4}, "density": 500,
                                 "hydro": {"radiation": "none", "added_mass": {"tolerance": 0.02}}}]}
    monkeypatch.setenv("PLIMSOLL_CACHE", str(tmp_path))
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.005)

    other = threading.Thread(target=tick)
    other.start()
    start = time.monotonic()
    pl.Simulation(scene)
    took = time.monotonic() - start
    done.set()
    other.join()
    if took < 0.5:
        pytest.skip("too quick to tell")
    # With the lock held all the while there would be two.
    assert len(ticks) > 5


def test_a_reset_that_a_batch_cannot_take_changes_nothing():
    batch = pl.Batch({**IMU, "log": {}}, 2, observe=["raft.z"])
    batch.step(5)
    kept = batch.position.copy(), batch.observation.copy()
    with pytest.raises(ValueError, match="other bodies"):
        batch.reset([0, 1], vary={"bodies[raft].name": ["raft", "log"]})
    with pytest.raises(pl.SceneError):
        batch.reset(1, vary={"bodies[raft].density": [-1]})
    with pytest.raises(ValueError, match="one for each of 1"):
        batch.reset(1, vary={"bodies[raft].density": [300, 400]})
    assert np.array_equal(batch.position, kept[0]) and np.array_equal(batch.observation, kept[1])
    batch.step(5)
    assert batch.time[1] == pytest.approx(0.1)


def test_pictures_have_no_text_where_none_is_wanted():
    sim = pl.Simulation(IMU)
    look = {"camera": {"from": [6, -8, 3], "to": [0, 0, 0]}, "size": (320, 240)}
    try:
        told, bare = sim.render(**look), sim.render(**look, overlay=False)
    except pl.RenderError:
        pytest.skip("no graphics")
    assert told.shape == bare.shape == (240, 320, 3)
    different = (told != bare).any(axis=2)
    assert 0.002 < different.mean() < 0.3  # The scale at the edge and the time, no more.
    assert not different[60:180, 90:200].any()
