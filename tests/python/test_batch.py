"""Many simulations at once."""

import gc

import numpy as np
import pytest

import plimsoll as pl
from conftest import BUOY, TUG, motions


def of(batch, i):
    """The arrays of one simulation as bytes."""
    arrays = (batch.position, batch.orientation, batch.velocity, batch.angular_velocity)
    return b"".join(a[i].tobytes() for a in arrays)


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_each_simulation_gives_the_bits_that_it_gives_alone(threads):
    n = 6
    vary = {
        "bodies[buoy].density": np.linspace(300, 900, n),
        "bodies[buoy].position": [[0, 0, 0.1 * i] for i in range(n)],
    }
    batch = pl.Batch(BUOY, n, threads=threads, vary=vary)
    batch.step(30)
    batch.step(30)
    for i in range(n):
        sim = pl.Simulation(pl.Scene.load(BUOY, set={key: values[i] for key, values in vary.items()}))
        sim.step(60)
        assert of(batch, i) == motions(sim)
        assert batch.time[i] == sim.time


def test_ropes_screws_and_controls_give_the_same_bits_too(tug):
    batch, sim = pl.Batch(tug, 3, threads=2), pl.Simulation(tug)
    rudder = batch.set_point("rudder")
    batch.control[1, rudder] = 9
    batch.force[1, batch.index("barge")] = [0, 3000, 0]
    batch.step(100)
    sim.control["rudder"] = 9
    sim.apply("barge", force=[0, 3000, 0])
    sim.step(100)
    assert of(batch, 1) == motions(sim)
    assert of(batch, 0) == of(batch, 2) != of(batch, 1)


def test_arrays_have_the_shapes_of_the_scene_and_are_live(tug):
    batch = pl.Batch(tug, 4)
    assert len(batch) == 4 and batch.bodies == ["tug", "barge"]
    assert batch.position.shape == batch.velocity.shape == batch.angular_velocity.shape == (4, 2, 3)
    assert batch.orientation.shape == (4, 2, 4) and batch.time.shape == (4,)
    assert batch.control.shape == (4, len(batch.set_points)) and np.isnan(batch.control).all()
    position, before = batch.position, batch.position.copy()
    batch.step(10)
    assert batch.position is position and not np.array_equal(position, before)
    with pytest.raises(ValueError):
        position[0] = 0
    del batch
    gc.collect()
    assert np.isfinite(position).all()


def test_a_set_point_that_is_nan_is_the_scenes_again(tug):
    batch, sim = pl.Batch(tug, 1), pl.Simulation(tug)
    rudder = batch.set_point("rudder")
    batch.control[0, rudder] = 9
    batch.step(50)
    batch.control[0, rudder] = np.nan
    batch.step(50)
    sim.control["rudder"] = 9
    sim.step(50)
    del sim.control["rudder"]
    sim.step(50)
    assert of(batch, 0) == motions(sim)


def test_some_are_stepped_and_reset(buoy):
    batch = pl.Batch(buoy, 4)
    start = of(batch, 0)
    batch.step(5)
    batch.step(5, which=[1, 3])
    batch.step(5, which=np.array([False, True, False, False]))
    batch.step(5, which=[])
    assert batch.time == pytest.approx([0.05, 0.15, 0.05, 0.1])
    batch.reset(1)
    batch.reset([True, False, False, False])
    assert batch.time == pytest.approx([0, 0, 0.05, 0.1])
    assert of(batch, 0) == of(batch, 1) == start
    batch.reset()
    assert not batch.time.any() and of(batch, 3) == start


def test_a_reset_ends_loads_and_set_values(tug):
    batch = pl.Batch(tug, 2)
    batch.force[:] = 10
    batch.torque[:] = 10
    batch.control[:, batch.set_point("rudder")] = 3
    batch.reset(1)
    assert (batch.force[0] == 10).all() and not batch.force[1].any() and not batch.torque[1].any()
    assert np.isnan(batch.control[1]).all() and not np.isnan(batch.control[0]).all()


def test_a_saved_simulation_goes_on_in_another_and_alone(tug):
    batch = pl.Batch(tug, 3, threads=2)
    batch.step(20)
    batch.force[0, 1] = [500, 0, 0]
    batch.control[0, batch.set_point("rudder")] = 4
    state = batch.save(0)
    batch.step(40)
    batch.load(2, state)
    assert batch.time[2] == pytest.approx(0.4)
    assert batch.force[2, 1, 0] == 500 and batch.control[2, batch.set_point("rudder")] == 4
    batch.step(40, which=2)
    assert of(batch, 2) == of(batch, 0)
    sim = pl.Simulation(tug)
    sim.load(state)
    sim.step(40)
    assert motions(sim) == of(batch, 0)


def test_one_that_breaks_down_stands_still_and_the_others_go_on(buoy):
    batch = pl.Batch(buoy, 3)
    batch.force[1, 0] = [1e300, 0, 0]
    batch.step(500)
    assert list(batch.errors) == [1] and "buoy" in batch.errors[1]
    assert batch.time[0] == batch.time[2] == pytest.approx(5) and batch.time[1] < 5
    batch.reset(1)
    assert batch.errors == {}
    batch.step()
    assert batch.time[1] == pytest.approx(0.01)


def test_wrong_use_is_refused(buoy, tug):
    with pytest.raises(ValueError, match="at least one"):
        pl.Batch(buoy, 0)
    with pytest.raises(ValueError, match="has 2 values, expected one for each of 3"):
        pl.Batch(buoy, 3, vary={"bodies[0].density": [300, 400]})
    with pytest.raises(pl.SceneError, match="densty"):
        pl.Batch(buoy, 2, vary={"bodies[0].densty": [300, 400]})
    with pytest.raises(ValueError, match="other bodies"):
        pl.Batch(buoy, 2, vary={"bodies[0].name": ["a", "b"]})
    batch = pl.Batch(buoy, 2)
    batch.force[1, 0, 2] = np.nan
    with pytest.raises(ValueError, match="'buoy' of simulation 1 is not finite"):
        batch.step()
    for call in (lambda: batch.reset(2), lambda: batch.save(-3), lambda: batch.step(which=[0, 7])):
        with pytest.raises(IndexError):
            call()


def test_a_body_of_one_is_put_elsewhere(buoy):
    batch = pl.Batch(buoy, 2)
    batch.set_motion(1, "buoy", position=[1, 2, 3], velocity=[0, 0, 1])
    assert batch.position[1, 0] == pytest.approx([1, 2, 3]) and batch.velocity[1, 0, 2] == 1
    assert batch.position[0, 0] == pytest.approx([0, 0, 0.2])
