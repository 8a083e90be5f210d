"""Regular waves on the water of a scene."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import yaml


@dataclass(frozen=True)
class Wave:
    """A linear wave with a crest over the origin at time 0."""

    period: float  # At a fixed place [s].
    number: float  # k [1/m].
    heading: float  # [rad]
    amplitude: float  # [m]

    @property
    def omega(self) -> float:
        return 2 * np.pi / self.period

    def advance(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """By which the phase lags at a place [rad]."""
        return self.number * (np.cos(self.heading) * x + np.sin(self.heading) * y)


@dataclass(frozen=True)
class StillSea:
    """What the length of a wave depends on."""

    gravity: float = 9.80665
    depth: float = np.inf  # [m]
    current: tuple[float, ...] = (0.0, 0.0, 0.0)  # [m/s]

    def wave(self, period: float, heading_deg: float, amplitude: float,
             slope: float | None = None) -> Wave:
        """slope: k a, in place of the amplitude."""
        heading = np.radians(heading_deg)
        along = self.current[0] * np.cos(heading) + self.current[1] * np.sin(heading)
        number = self._number(2 * np.pi / period, along)
        return Wave(period, number, heading, slope / number if slope else amplitude)

    def _number(self, omega: float, along: float) -> float:
        """The least root of ω = k U + sqrt(g k tanh kh), by bisection."""
        excess = lambda k: (k * along - omega
                            + np.sqrt(self.gravity * k * np.tanh(min(k * self.depth, 50))))
        low, high = 0.0, 1e-4 * omega**2 / self.gravity
        while excess(high) < 0:
            low, high = high, 1.01 * high
            if high > 1e6 * omega**2 / self.gravity:
                raise RuntimeError(f"no wave of {2 * np.pi / omega:g} s runs against the current")
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if excess(middle) < 0 else (low, middle)
        return high


def sea_of(program: str, scene: Path, settings: list[str]) -> StillSea:
    """Of a scene as the program reads it: with its includes, variables and overrides
    KEY.PATH=VALUE. Raises the program's faults; those of values are left for a run to tell."""
    command = [program, "check", str(scene), "--expand"]
    command += [part for setting in settings for part in ("--set", setting)]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        raise RuntimeError(result.stderr.strip() or f"{' '.join(command)} failed")
    read = yaml.safe_load(result.stdout)
    water = read.get("water") or {}
    given = {"gravity": read.get("gravity"), "depth": water.get("depth")}
    numbers = {key: float(value) for key, value in given.items() if value is not None}
    current = water.get("current") or (0, 0, 0)
    if isinstance(current, dict):  # By depth: waves travel on the current of the surface.
        current = current["velocities"][0]
    return StillSea(current=tuple(map(float, current)), **numbers)
