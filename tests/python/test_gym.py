"""The vector environment, with the rules of Gymnasium."""

import numpy as np
import pytest

import plimsoll as pl
from plimsoll import gym

FLOAT = {
    "plimsoll": 1,
    "duration": 5,
    "step": 0.02,
    "water": {"density": 1000},
    "bodies": [{"name": "raft", "box": {"size": [2, 2, 0.5]}, "density": 500,
                "hydro": {"added_mass": "none", "radiation": "none"}}],
}


def make(autoreset="NextStep", n=3, **more):
    batch = pl.Batch(FLOAT, n, threads=2)

    def act(batch, actions):
        batch.force[:, 0, 0] = actions[:, 0]

    return gym.VectorEnv(
        batch, observe=lambda b: b.position[:, 0, :2], reward=lambda b, a: -b.position[:, 0, 0] ** 2,
        act=act, low=[-1000], high=[1000], steps=5, duration=0.5, autoreset=autoreset, **more)


def test_spaces_have_the_shapes_of_observations_and_actions():
    env = make()
    assert env.num_envs == 3
    assert env.single_action_space.shape == (1,) and env.single_observation_space.shape == (2,)
    assert env.action_space.shape == (3, 1) and env.observation_space.shape == (3, 2)
    assert env.metadata["autoreset_mode"] is gym.AutoresetMode.NEXT_STEP
    seen, info = env.reset(seed=1)
    assert seen.shape == (3, 2) and info == {}
    env.close()


def test_an_action_drives_each_environment():
    env = make()
    env.reset()
    seen, reward, terminated, truncated, _ = env.step(np.array([[1000.0], [0.0], [-1000.0]]))
    assert seen[0, 0] > 1e-3 and abs(seen[1, 0]) < 1e-12 and seen[2, 0] < -1e-3
    assert reward == pytest.approx(-seen[:, 0] ** 2)
    assert not terminated.any() and not truncated.any()


def test_an_observation_is_no_view_of_the_state():
    env = make()
    before, _ = env.reset()
    kept = before.copy()
    env.step(np.full((3, 1), 500.0))
    assert np.array_equal(before, kept)


def run_to_the_end(env):
    env.reset()
    for _ in range(4):
        assert not env.step(np.full((3, 1), 800.0))[3].any()
    return env.step(np.full((3, 1), 800.0))


def test_next_step_begins_the_next_episode_in_the_step_after_the_end():
    env = make("NextStep")
    seen, _, _, truncated, _ = run_to_the_end(env)
    assert truncated.all() and (seen[:, 0] > 0).all()
    seen, reward, _, truncated, _ = env.step(np.full((3, 1), 800.0))
    assert not truncated.any() and not seen[:, 0].any() and not reward.any() and not env.batch.time.any()
    seen = env.step(np.full((3, 1), 800.0))[0]
    assert (seen[:, 0] > 0).all()


def test_same_step_gives_the_last_observation_beside_the_first():
    env = make("SameStep")
    seen, _, _, truncated, info = run_to_the_end(env)
    assert truncated.all() and not seen[:, 0].any()
    assert (info["final_obs"][:, 0] > 0).all() and info["_final_obs"].all()


def test_disabled_waits_for_a_reset_by_mask():
    env = make("Disabled", done=lambda b: np.array([True, False, False]))
    env.reset()
    _, _, terminated, _, _ = env.step(np.full((3, 1), 800.0))
    assert list(terminated) == [True, False, False]
    env.reset(options={"reset_mask": terminated})
    assert list(env.batch.time) == pytest.approx([0, 0.1, 0.1])


def test_episodes_begin_where_they_are_told_to_by_the_seed():
    def begin(batch, which, rng):
        for i in which:
            batch.set_motion(int(i), 0, position=[*rng.uniform(-1, 1, 2), 0])

    env = make(begin=begin)
    first, _ = env.reset(seed=3)
    again, _ = env.reset(seed=3)
    other, _ = env.reset()
    assert np.array_equal(first, again) and not np.array_equal(first, other)
    assert len(np.unique(first[:, 0])) == 3


def test_an_episode_whose_simulation_fails_is_terminated():
    env = make("SameStep")
    env.reset()
    _, _, terminated, _, info = env.step(np.array([[0.0], [1e300], [0.0]]))
    assert list(terminated) == [False, True, False]
    assert info["error"][1] and not info["error"][0]
    _, _, terminated, _, info = env.step(np.zeros((3, 1)))
    assert not terminated.any() and "error" not in info


def test_gymnasium_takes_it_where_it_is_installed():
    gymnasium = pytest.importorskip("gymnasium")
    env = make()
    assert isinstance(env, gymnasium.vector.VectorEnv)
    recorded = gymnasium.wrappers.vector.RecordEpisodeStatistics(env)
    recorded.reset(seed=0)
    for _ in range(5):
        _, _, _, truncated, info = recorded.step(env.action_space.sample())
    assert truncated.all() and info["episode"]["l"].tolist() == [5, 5, 5]
