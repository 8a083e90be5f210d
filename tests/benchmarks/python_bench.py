"""What Python costs: a loop of single steps, and a batch, against the same in C++ (BM_Fleet); and
how many steps a second a thousand environments take, with observations and without.

    tools/python tests/benchmarks/python_bench.py

Each number is the least of several runs that take turns, so that a busy machine troubles all alike.
"""

import json
import subprocess
import sys
import time
from pathlib import Path

import plimsoll as pl

ROOT = Path(__file__).resolve().parents[2]
SCENE = ROOT / "tests/benchmarks/buoy.yaml"
ROUNDS, STEPS, BUOYS, HULLS = 7, 2000, 256, 1000

# A hull of 320 triangles with a screw in a wave, with an instrument on board.
HULL = {
    "plimsoll": 1,
    "duration": 1000,
    "step": 0.02,
    "water": {"surface": {"waves": [{"amplitude": 0.1, "period": 3}]}},
    "hydro": {"radiation": "none"},
    "bodies": [{"name": "hull", "icosphere": {"radius": 1, "subdivisions": 2}, "density": 500}],
    "propellers": [{"name": "main", "body": "hull", "at": [-1, 0, -0.5], "diameter": 0.3,
                    "model": {"wageningen": {"blades": 4, "area_ratio": 0.7, "pitch_ratio": 1}}}],
    "log": {"probes": [{"name": "imu", "body": "hull", "at": [0, 0, 0.5]}]},
}
OBSERVATIONS = ["hull.heading_deg", "hull.speed", "hull.z", "probes[imu].specific_x", "probes[imu].specific_z",
                "probes[imu].wz"]


def seconds(work) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def one_by_one(sim) -> None:
    for _ in range(STEPS):
        sim.step()


def cpp() -> dict:
    """Steps a second by the name of the benchmark; none where it is not built."""
    program = ROOT / "build/plimsoll_bench"
    if not program.exists():
        return {}
    done = subprocess.run([program, "--benchmark_filter=BM_Fleet", "--benchmark_format=json",
                           "--benchmark_min_time=0.5"], capture_output=True, text=True, check=True)
    return {row["name"].removesuffix("/real_time"): row["items_per_second"]
            for row in json.loads(done.stdout)["benchmarks"]}


def environments() -> None:
    """Prints the steps a second of a thousand environments, and the time of a reset with another hull."""
    actions = {"propellers[main].speed_rps": (0.0, 5.0)}
    kinds = {"6 observations": dict(observations=OBSERVATIONS),
             "positions alone": dict(observe=lambda batch: batch.position[:, 0])}
    print(f"\n| {HULLS} environments of a hull of 320 triangles | steps a second |\n| --- | ---: |")
    for name, how in kinds.items():
        env = pl.VectorEnv(HULL, n=HULLS, actions=actions, vary={"bodies[hull].density": (450.0, 550.0)}, **how)
        set_up = seconds(env.reset)
        taken = env.action_space.sample()
        rate = max(HULLS / seconds(lambda: env.step(taken)) for _ in range(ROUNDS))
        print(f"| {name} | {rate:,.0f} |")
    print(f"\na reset that draws another density: {1e3 * set_up / HULLS:.1f} ms an environment")


def main() -> None:
    scene = pl.Scene.load(SCENE)
    sims = {"forces kept": pl.Simulation(scene), "forces=False": pl.Simulation(scene, forces=False)}
    batches = {threads: pl.Batch(scene, BUOYS, threads=threads) for threads in (1, 2)}
    loop, call, rate, fleet = {}, {}, {}, {}
    for _ in range(ROUNDS):
        for name, sim in sims.items():
            for results, work in ((call, lambda: sim.step(STEPS)), (loop, lambda: one_by_one(sim))):
                sim.reset()
                results[name] = min(results.get(name, 1e9), seconds(work) / STEPS * 1e6)
        for threads, batch in batches.items():
            took = seconds(lambda: batch.step(20))
            rate[threads] = max(rate.get(threads, 0), 20 * BUOYS / took)
        for name, value in cpp().items():
            fleet[name] = max(fleet.get(name, 0), value)

    print("| one buoy, µs a step | one call | Python's loop | more |\n| --- | ---: | ---: | ---: |")
    for name in sims:
        print(f"| {name} | {call[name]:.2f} | {loop[name]:.2f} | {loop[name] - call[name]:.2f} |")
    if fleet:
        print(f"| C++ | {1e6 / fleet['BM_Fleet/1/1']:.2f} | – | – |")
    print(f"\n| {BUOYS} buoys, steps a second | Batch | C++ | Batch over C++ |\n| --- | ---: | ---: | ---: |")
    for threads in batches:
        other = fleet.get(f"BM_Fleet/{BUOYS}/{threads}")
        compared = f"{other:,.0f} | {100 * rate[threads] / other:.0f} %" if other else "– | –"
        print(f"| {threads} thread{'s' * (threads > 1)} | {rate[threads]:,.0f} | {compared} |")
    print(f"\ntwo threads over one: Batch {rate[2] / rate[1]:.2f}")
    environments()


if __name__ == "__main__":
    sys.exit(main())
