"""A PID autopilot in Python steers a ship along three courses.

    tools/python app/python/examples/autopilot.py [OUT]
"""

import math
import sys
from pathlib import Path

import matplotlib
import numpy as np

import plimsoll as pl

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SCENES = Path(__file__).resolve().parents[3] / "scenes"
COURSES = [(0, 0.0), (10, 30.0), (80, -20.0)]  # from this time [s] on this heading [deg]


class Pid:
    """kp·e + ki·∫e dt − kd·rate, between ± limit; the integral waits while the output is at it."""

    def __init__(self, kp: float, ki: float, kd: float, limit: float) -> None:
        self.kp, self.ki, self.kd, self.limit = kp, ki, kd, limit
        self.sum = 0.0

    def __call__(self, error: float, rate: float, h: float) -> float:
        output = self.kp * error + self.ki * self.sum - self.kd * rate
        if abs(output) < self.limit:
            self.sum += error * h
        return max(-self.limit, min(self.limit, output))


def heading(q: np.ndarray) -> float:
    """Direction of the body's x axis over the ground [deg], counter-clockwise from W's x."""
    w, x, y, z = q
    return math.degrees(math.atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z)))


def main(out: Path) -> None:
    # The scene's own rudder is left to us.
    sim = pl.Simulation(pl.Scene.load(SCENES / "turning_circle.yaml"))
    ship = sim.index("ship")
    sim.control["propellers[main].speed_rps"] = 2.0
    pid = Pid(kp=2, ki=0.005, kd=12, limit=35)
    rows = []
    while sim.time < 150:
        target = [course for start, course in COURSES if sim.time >= start][-1]
        now = heading(sim.orientation[ship])
        error = (target - now + 180) % 360 - 180
        rate = math.degrees(sim.angular_velocity[ship, 2])
        sim.control["rudders[rudder].angle_deg"] = rudder = pid(error, rate, 10 * sim.scene.step)
        rows.append((sim.time, *sim.position[ship, :2], target, now, rudder))
        sim.step(10)
    time, x, y, target, course, rudder = np.transpose(rows)

    figure, (track, turns) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    track.plot(x, y)
    track.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    turns.plot(time, target, "k--", lw=0.8, label="target")
    turns.plot(time, course, label="heading")
    turns.plot(time, rudder, lw=0.8, label="rudder")
    turns.set(xlabel="time [s]", ylabel="[deg]")
    turns.legend()
    figure.savefig(out / "autopilot.png", dpi=110)
    print(f"heading at the end {course[-1]:.1f} deg, target {target[-1]:.0f} deg")
    print(f"overshoot of the first turn {np.max(course) - 30:.1f} deg")


if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "out/examples")
    folder.mkdir(parents=True, exist_ok=True)
    main(folder)
