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


# A raft with a screw, in a sea that each episode draws anew.
BOAT = {
    "plimsoll": 1,
    "duration": 0.5,
    "step": 0.02,
    "water": {"density": 1000, "surface": {"spectrum": {"type": "jonswap", "significant_height": 0.2,
                                                        "peak_period": 2, "components": 5}}},
    "bodies": [{"name": "raft", "box": {"size": [3, 2, 0.5]}, "density": 500,
                "hydro": {"added_mass": "none", "radiation": "none"}}],
    "propellers": [{"name": "main", "body": "raft", "at": [-1.5, 0, -0.2], "diameter": 0.3,
                    "model": {"wageningen": {"blades": 4, "area_ratio": 0.7, "pitch_ratio": 1}}}],
    "log": {"probes": [{"name": "imu", "body": "raft", "at": [0, 0, 0.1]}]},
    "render": {"size": [64, 48], "camera": {"from": [3, -5, 3], "to": [0, 0, 0]}},
}
ACTIONS = {"propellers[main].speed_rps": (-10, 10)}
OBSERVATIONS = ["raft.speed", "raft.z", "probes[imu].specific_x"]
SEA = {"water.surface.spectrum.seed": (0, 10**6), "water.surface.spectrum.significant_height": (0.1, 0.3)}


def test_a_scene_is_an_environment_by_names_alone():
    env = pl.Env(BOAT, ACTIONS, OBSERVATIONS, steps=5, reward=lambda sim, action: sim.velocity[0, 0],
                 done=lambda sim: sim.position[0, 2] < -1)
    assert env.action_space.shape == (1,) and env.action_space.high[0] == 10
    assert env.observation_space.shape == (3,) and env.metadata["render_fps"] == pytest.approx(10)
    first, info = env.reset()
    assert info == {} and env.observation_space.contains(first)
    steps = [env.step([8.0]) for _ in range(5)]
    seen, reward, terminated, truncated, info = steps[-1]
    assert seen[0] > 1e-3 and reward == env.simulation.velocity[0, 0] and info == {}
    assert not terminated and [step[3] for step in steps] == [False] * 4 + [True]
    assert seen[2] == env.simulation.readings()["probes"]["imu"]["specific_x"]
    again, _ = env.reset()
    assert np.array_equal(first, again)
    env.close()


def test_each_episode_draws_its_own_sea_by_the_seed():
    env = pl.Env(BOAT, ACTIONS, OBSERVATIONS, steps=5, vary=SEA)

    def episode(**how):
        env.reset(**how)
        return np.array([env.step([0.0])[0] for _ in range(3)])

    first, second, again = episode(seed=5), episode(), episode(seed=5)
    assert np.array_equal(first, again) and not np.array_equal(first, second)
    other = pl.Env(BOAT, ACTIONS, OBSERVATIONS, steps=5, vary=SEA, seed=5)
    other.reset()
    assert np.array_equal(other.step([0.0])[0], first[0])


def test_an_environment_of_a_batch_is_each_of_its_environments_alone():
    names = pl.VectorEnv(BOAT, n=3, actions=ACTIONS, observations=OBSERVATIONS, steps=5, threads=2,
                         autoreset="SameStep", reward=lambda batch, actions: batch.observation[:, 0])
    alone = pl.Env(BOAT, ACTIONS, OBSERVATIONS, steps=5)
    seen, _ = names.reset()
    assert np.array_equal(seen, [alone.reset()[0]] * 3)
    for take in range(5):
        seen, reward, _, truncated, info = names.step([[8.0], [0.0], [-8.0]])
        assert np.array_equal(reward, (info["final_obs"] if take == 4 else seen)[:, 0]), take
        expected = alone.step([8.0])[0]
        assert np.array_equal((info["final_obs"] if take == 4 else seen)[0], expected), take
    assert truncated.all() and not names.batch.time.any()


def test_a_batch_draws_a_sea_for_each_episode():
    def episode(seed):
        env = pl.VectorEnv(BOAT, n=3, actions=ACTIONS, observations=["raft.z"], steps=5, seed=seed, vary=SEA,
                           threads=2)
        env.reset()
        return np.concatenate([env.step(np.zeros((3, 1)))[0] for _ in range(8)], axis=1)

    first, again, other = episode(1), episode(1), episode(2)
    assert np.array_equal(first, again) and not np.array_equal(first, other)
    assert len(np.unique(first[:, 0])) == 3
    # The steps after the reset of the sixth step are those of other seas.
    assert not np.array_equal(first[:, 0], first[:, 6])


def test_a_value_may_be_drawn_by_a_function():
    drawn = []

    def density(rng):
        drawn.append(float(rng.choice([300.0, 600.0])))
        return drawn[-1]

    env = pl.Env(BOAT, ACTIONS, ["raft.z"], vary={"bodies[raft].density": density}, seed=1)
    for _ in range(4):
        env.reset()
        assert env.simulation.mass[0] == pytest.approx(3 * drawn[-1])
    assert len(drawn) == 4


def test_what_cannot_be_is_told_before_the_first_episode():
    with pytest.raises(KeyError, match="main"):
        pl.Env(BOAT, {"propellers[main].speed_rpm": (0, 1)}, OBSERVATIONS)
    with pytest.raises(KeyError, match="did you mean raft.speed"):
        pl.Env(BOAT, ACTIONS, ["raft.sped"])
    with pytest.raises(ValueError, match="bounds"):
        pl.Env(BOAT, list(ACTIONS), OBSERVATIONS)
    with pytest.raises(ValueError, match="rgb_array"):
        pl.Env(BOAT, ACTIONS, OBSERVATIONS, render_mode="human")
    with pytest.raises(ValueError, match="observe"):
        pl.VectorEnv(BOAT, n=2, actions=ACTIONS)
    with pytest.raises(ValueError, match="does not observe raft.y"):
        pl.VectorEnv(pl.Batch(BOAT, 2, observe=["raft.x"]), actions=ACTIONS, observations=["raft.y"])


def test_actions_have_the_shape_of_their_space():
    two = {**BOAT, "propellers": [BOAT["propellers"][0], {**BOAT["propellers"][0], "name": "bow"}]}
    names = ["propellers[main].speed_rps", "propellers[bow].speed_rps"]
    env = pl.Env(two, names, OBSERVATIONS, low=-1, high=[1, 2])
    assert env.action_space.shape == (2,) and list(env.action_space.high) == [1, 2]
    env.reset()
    for wrong in ([0.5], [1, 2, 3], 0.5, [np.nan, 0]):
        with pytest.raises(ValueError, match="2 numbers"):
            env.step(wrong)
    many = pl.VectorEnv(two, n=3, actions=names, observations=OBSERVATIONS, low=-1, high=1)
    assert many.action_space.shape == (3, 2)
    many.reset()
    with pytest.raises(ValueError, match=r"\(3, 2\)"):
        many.step([0.1, 0.2, 0.3])
    with pytest.raises(ValueError, match="not a number"):
        many.step(np.full((3, 2), np.nan))
    with pytest.raises(ValueError, match="a batch has its own"):
        pl.VectorEnv(pl.Batch(two, 2, observe=["raft.x"]), n=3, actions=names, low=-1, high=1)
    assert pl.Env(two, names, OBSERVATIONS, low=0, high=1).np_random is not env.np_random


def test_a_failed_simulation_ends_the_episode_of_an_environment():
    env = pl.Env(BOAT, ACTIONS, OBSERVATIONS)
    env.reset()
    env.simulation.apply("raft", force=[1e300, 0, 0])
    seen, _, terminated, truncated, info = env.step([0.0])
    assert terminated and not truncated and "raft" in info["error"] and np.isfinite(seen).all()
    env.reset()
    assert not env.step([0.0])[2]


def test_an_environment_shows_pictures_without_text():
    env = pl.Env(BOAT, ACTIONS, OBSERVATIONS, render_mode="rgb_array", size=(96, 64))
    env.reset()
    try:
        picture = env.render()
    except pl.RenderError:
        pytest.skip("no graphics")
    assert picture.shape == (64, 96, 3) and picture.dtype == np.uint8 and picture.std() > 5
    assert pl.Env(BOAT, ACTIONS, OBSERVATIONS).render() is None


def test_gymnasiums_checker_finds_no_fault_where_it_is_installed():
    checker = pytest.importorskip("gymnasium.utils.env_checker")
    env = pl.Env(BOAT, ACTIONS, OBSERVATIONS, steps=5, vary=SEA)
    checker.check_env(env, skip_render_check=True)


def test_gymnasium_takes_it_where_it_is_installed():
    gymnasium = pytest.importorskip("gymnasium")
    env = make()
    assert isinstance(env, gymnasium.vector.VectorEnv)
    recorded = gymnasium.wrappers.vector.RecordEpisodeStatistics(env)
    recorded.reset(seed=0)
    for _ in range(5):
        _, _, _, truncated, info = recorded.step(env.action_space.sample())
    assert truncated.all() and info["episode"]["l"].tolist() == [5, 5, 5]
