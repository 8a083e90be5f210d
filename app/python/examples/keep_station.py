"""Learns to keep a raft on station with three propellers, in currents from any direction.

The controller has twelve gains. The cross-entropy method draws candidates, lets a batch try all of
them in three currents at once, and draws the next ones about the best; no derivative is needed.

    tools/python app/python/examples/keep_station.py [OUT] [--generations N]
"""

import argparse
import time
from pathlib import Path
from typing import Tuple

import matplotlib
import numpy as np

import plimsoll as pl
from plimsoll.gym import VectorEnv

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

CANDIDATES, CURRENTS, BEST = 20, 3, 5
EPISODE, HOLD = 40.0, 3  # [s], steps of 0.1 s for which an action is held
FASTEST = 8.0  # [1/s]


def propeller(name: str, at: list, axis: list) -> dict:
    return {"name": name, "body": "raft", "at": at, "axis": axis, "diameter": 0.5, "speed_rps": 0,
            "model": {"wageningen": {"blades": 4, "area_ratio": 0.6, "pitch_ratio": 0.9}}}


SCENE = {
    "plimsoll": 1,
    "duration": EPISODE,
    "step": 0.1,
    "water": {"density": 1025, "current": [0, 0, 0]},
    "bodies": [{"name": "raft", "box": {"size": [6, 4, 1.2]}, "mass": 12000,
                "hydro": {"radiation": "none"}}],
    "propellers": [propeller("port", [-3, 1.2, -0.4], [1, 0, 0]),
                   propeller("starboard", [-3, -1.2, -0.4], [1, 0, 0]),
                   propeller("bow", [2.4, 0, -0.4], [0, 1, 0])],
}


def observe(batch: pl.Batch) -> np.ndarray:
    """Place and velocity in the raft's own axes, heading and its rate: (n, 6)."""
    w, x, y, z = np.moveaxis(batch.orientation[:, 0], 1, 0)
    heading = np.arctan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z))
    c, s = np.cos(heading), np.sin(heading)
    px, py = batch.position[:, 0, 0], batch.position[:, 0, 1]
    vx, vy = batch.velocity[:, 0, 0], batch.velocity[:, 0, 1]
    return np.stack([c * px + s * py, c * py - s * px, heading, c * vx + s * vy, c * vy - s * vx,
                     batch.angular_velocity[:, 0, 2]], axis=1)


def reward(batch: pl.Batch, actions: np.ndarray) -> np.ndarray:
    place = batch.position[:, 0, :2]
    heading = observe(batch)[:, 2]
    return -((place**2).sum(1) + 4 * heading**2) - 2e-3 * (actions**2).sum(1)


def turn_screws(batch: pl.Batch, actions: np.ndarray) -> None:
    for column, name in enumerate(("port", "starboard", "bow")):
        batch.control[:, batch.set_point(f"propellers[{name}].speed_rps")] = actions[:, column]


class Controller:
    """Gains of place, speed and sum for surge, sway and yaw, and three that mix them: (n, 12)."""

    def __init__(self, gains: np.ndarray) -> None:
        self.gains = gains
        self.sums = np.zeros((len(gains), 3))

    def __call__(self, seen: np.ndarray) -> np.ndarray:
        place, speed = seen[:, :3], seen[:, 3:]
        self.sums = np.clip(self.sums + HOLD * SCENE["step"] * place, -20, 20)
        g = self.gains
        surge, sway, yaw = -(g[:, 0:3] * place + g[:, 3:6] * speed + g[:, 6:9] * self.sums).T
        turn = g[:, 9] * yaw + g[:, 10] * sway
        actions = np.stack([surge - turn, surge + turn, sway + g[:, 11] * yaw], axis=1)
        return np.clip(actions, -FASTEST, FASTEST)


def environment(candidates: int) -> VectorEnv:
    angles = np.linspace(0, 2 * np.pi, CURRENTS, endpoint=False) + 0.4
    currents = [[0.35 * np.cos(a), 0.35 * np.sin(a), 0] for a in angles]
    batch = pl.Batch(SCENE, candidates * CURRENTS, vary={"water.current": currents * candidates})
    return VectorEnv(batch, observe, reward, act=turn_screws, low=[-FASTEST] * 3,
                     high=[FASTEST] * 3, steps=HOLD, duration=EPISODE, autoreset="Disabled")


def try_out(env: VectorEnv, gains: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Mean reward of each candidate, and the places of all on the way: (times, n, 2)."""
    controller = Controller(np.repeat(gains, CURRENTS, axis=0))
    seen, _ = env.reset()
    total, places, over = 0.0, [], False
    while not over:
        seen, gained, terminated, truncated, _ = env.step(controller(seen))
        total += gained
        places.append(env.batch.position[:, 0, :2].copy())
        over = (terminated | truncated).all()
    score = np.where(terminated, -1e6, total / len(places))
    return score.reshape(-1, CURRENTS).mean(1), np.array(places)


def learn(generations: int, seed: int) -> Tuple[np.ndarray, list]:
    rng = np.random.default_rng(seed)
    mean, spread = np.zeros(12), np.full(12, 2.0)
    env = environment(CANDIDATES)
    history = []
    for generation in range(generations):
        gains = mean + spread * rng.standard_normal((CANDIDATES, 12))
        gains[0] = mean
        scores, _ = try_out(env, gains)
        best = gains[np.argsort(scores)[-BEST:]]
        mean, spread = best.mean(0), best.std(0) + 0.3 / (generation + 1)
        history.append((scores[0], scores.max()))
        print(f"generation {generation + 1:2}: {scores.max():9.3f}", flush=True)
    return mean, history


def main(out: Path, generations: int) -> None:
    start = time.perf_counter()
    gains, history = learn(generations, seed=1)
    wall = time.perf_counter() - start
    env = environment(1)
    idle_score, idle = try_out(env, np.zeros((1, 12)))
    score, kept = try_out(env, gains[None])

    figure, (progress, track) = plt.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
    progress.plot(np.arange(1, len(history) + 1), -np.array(history))
    progress.set(xlabel="generation", ylabel="cost", yscale="log")
    progress.legend(["mean of the best", "best candidate"])
    for i in range(CURRENTS):
        track.plot(*idle[:, i].T, "0.7", label="without propellers" if i == 0 else None)
        track.plot(*kept[:, i].T, label=f"learned, current {i + 1}")
    track.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title=f"{EPISODE:g} s")
    track.legend(fontsize=8)
    figure.savefig(out / "keep_station.png", dpi=110)

    last = np.linalg.norm(kept[-50:], axis=2)
    print(f"cost {-idle_score[0]:.1f} idle, {-score[0]:.2f} learned, in {wall:.0f} s")
    print(f"farthest from the station in the last 10 s: {last.max():.2f} m")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=Path, nargs="?", default=Path("out/examples"))
    parser.add_argument("--generations", type=int, default=25)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    main(arguments.out, arguments.generations)
